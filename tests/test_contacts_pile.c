/* SPDX-License-Identifier: MIT */
/** @file test_contacts_pile.c
 *  Piles of discs and boxes, that what is found depends on nothing else, and convex pieces. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"
#include "contact_world.h"
#include "contacts/convex.h"
#include "suites.h"

#define RADIUS 0.05

/** From -1 to 1. */
static double part(uint32_t i, uint32_t k)
{
    return fmod(sin(i * 12.9898 + k * 78.233) * 43758.5453, 1);
}

/** Discs and boxes in a loose lattice above the floor. */
static contact_world *heap(uint32_t count, double restitution)
{
    contact_world *w = world_new();
    uint32_t columns = (uint32_t)ceil(sqrt(count));
    w->scene.domain = (sph2d_box){{0, 0}, {columns * 2.3 * RADIUS, 100}};
    for (uint32_t i = 0; i < count; ++i) {
        double x = (i % columns + 0.5) * 2.3 * RADIUS + 0.1 * RADIUS * part(i, 1);
        double y = (i / columns + 0.6) * 2.9 * RADIUS;
        uint32_t a = part(i, 2) > 0 ? world_disc(w, x, y, RADIUS) : world_box(w, x, y, 1.8 * RADIUS, 1.4 * RADIUS);
        w->bodies[a].restitution = restitution;
    }
    return w;
}

/** Falls, comes to rest, and nothing ever overlaps. */
static void falls(uint32_t count, double restitution, int steps)
{
    contact_world *w = heap(count, restitution);
    double energy = world_energy(w);
    for (int i = 0; i < steps; ++i) {
        world_step(w, i % 20 == 0 || i + 1 == steps);
        ck_assert_double_le(world_energy(w), energy * (1 + 1e-6));
        energy = world_energy(w);
    }
    ck_assert_msg(w->overlap <= 0.05 * RADIUS, "overlap %g", w->overlap);
    ck_assert_double_le(w->gain, 1e-12);
    double mass = count * 7.0;
    ck_assert_msg(world_kinetic(w) <= mass * 0.01 * 0.01 / 2, "kinetic %g", world_kinetic(w));
    for (uint32_t i = 0; i < count; ++i)
        ck_assert_double_lt(w->states[i].center.y, (sqrt(count) + 2) * 2.9 * RADIUS);
}

START_TEST(pile)
{
    falls(100, 0, 3000);
    falls(30, 0.5, 5000);
    if (getenv("SPH2D_TEST_FULL"))
        falls(1000, 0, 6000);
}
END_TEST

/** A box carries one a thousand times as heavy. */
START_TEST(heavy)
{
    contact_world *w = world_new();
    world_box(w, 0.5, 0.0502, 0.1, 0.1);
    uint32_t a = world_box(w, 0.5, 0.1504, 0.1, 0.1);
    w->states[a].inverse_mass_x = w->states[a].inverse_mass_y /= 1000;
    w->states[a].inverse_inertia /= 1000;
    world_run(w, 4000);
    ck_assert_msg(w->overlap <= 0, "overlap %g", w->overlap);
    ck_assert_double_eq_tol(w->states[a].center.y, 0.1504, 0.0005);
    ck_assert_double_le(w->gain, 1e-12);
}
END_TEST

/** Takes and gives back memory, so that what follows gets other addresses. */
static void stir(void **kept, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        kept[i] = malloc(16 + i * 37 % 700);
    for (size_t i = 0; i < count; i += 1 + i % 3) {
        free(kept[i]);
        kept[i] = NULL;
    }
}

START_TEST(same_bits)
{
    enum { BODIES = 100, BLOCKS = 2000 };
    static void *kept[BLOCKS];
    static sph2d_contact_body first[BODIES];
    contact_world *w = heap(BODIES, 0.2);
    for (int i = 0; i < 1500; ++i) {
        if (i % 100 != 0) {
            world_step(w, false);
            continue;
        }
        memcpy(first, w->states, sizeof first);
        ck_assert(sph2d__contacts_solve(&w->scene, w->walls, w->dt, first, BODIES, w->work) == SPH2D_OK);
        stir(kept, BLOCKS);
        ck_assert(sph2d__contacts_solve(&w->scene, w->walls, w->dt, w->states, BODIES, w->work) == SPH2D_OK);
        ck_assert(memcmp(first, w->states, sizeof first) == 0);
        for (size_t k = 0; k < BLOCKS; ++k)
            free(kept[k]);
    }
}
END_TEST

/** Momentum of bodies that meet no wall is kept to rounding. */
START_TEST(momentum)
{
    contact_world *w = heap(60, 0.3);
    w->gravity = (sph2d_vec2){0, 0};
    w->scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    sph2d_vec2 sums[2] = {{0, 0}, {0, 0}};
    double turning[2] = {0, 0};
    for (int k = 0; k < 2; ++k) {
        for (uint32_t i = 0; i < 60; ++i) {
            sph2d_contact_body *b = &w->states[i];
            if (k == 0)
                b->velocity = (sph2d_vec2){2 * (0.5 - b->center.x) + part(i, 3), 2 * (0.5 - b->center.y) + part(i, 4)};
            double m = 1 / b->inverse_mass_x;
            sums[k] = (sph2d_vec2){sums[k].x + m * b->velocity.x, sums[k].y + m * b->velocity.y};
            turning[k] +=
                m * (b->center.x * b->velocity.y - b->center.y * b->velocity.x) + b->rate / b->inverse_inertia;
        }
        for (int i = 0; i < 1000 && k == 0; ++i)
            world_step(w, false);
    }
    ck_assert_double_eq_tol(sums[0].x, sums[1].x, 1e-10);
    ck_assert_double_eq_tol(sums[0].y, sums[1].y, 1e-10);
    ck_assert_double_eq_tol(turning[0], turning[1], 1e-9);
    ck_assert_double_le(w->gain, 1e-12);
}
END_TEST

/** Pieces of stars and combs, turned, with corners on lines: their areas add up, and none turns right. */
START_TEST(pieces)
{
    enum { MOST = 128 };
    static sph2d_vec2 p[MOST];
    static int left[MOST], indices[MOST * MOST];
    static sph2d__piece all[MOST];
    for (uint32_t t = 0; t < 4000; ++t) {
        int n = 0, teeth = 2 + (int)(t % 12);
        for (int i = 0; i < 3 * teeth && t % 2; ++i, ++n)
            p[n] = (sph2d_vec2){(1.2 + part(t, (uint32_t)n)) * cos(i * 2.0944 / teeth),
                                (1.2 + part(t, (uint32_t)n)) * sin(i * 2.0944 / teeth)};
        for (int i = 0; i <= teeth && t % 2 == 0; ++i)
            p[n++] = (sph2d_vec2){i, -1};
        for (int i = teeth - 1; i >= 0 && t % 2 == 0; --i)
            for (int k = 0; k < 4; ++k)
                p[n++] = (sph2d_vec2){i + 1 - 0.5 * ((k + 1) / 2), k < 2};
        double c = cos(t), s = sin(t), area = 0, sum = 0;
        for (int i = 0; i < n; ++i)
            p[i] = (sph2d_vec2){c * p[i].x - s * p[i].y, s * p[i].x + c * p[i].y};
        for (int i = 1; i + 1 < n; ++i)
            area += sph2d__turn(p[0], p[i], p[i + 1]);
        for (int i = 0; i < n; ++i)
            all[i].corners = indices + MOST * i;
        int found = sph2d__convex_pieces(p, n, left, all);
        for (int i = 0; i < found; ++i)
            for (int k = 0; k < all[i].count; ++k) {
                const int *q = all[i].corners;
                sum += sph2d__turn(p[q[0]], p[q[k]], p[q[(k + 1) % all[i].count]]);
                ck_assert(sph2d__turn(p[q[k]], p[q[(k + 1) % all[i].count]], p[q[(k + 2) % all[i].count]]) >= 0);
            }
        ck_assert_double_eq_tol(sum, area, 1e-12 * area);
    }
}
END_TEST

Suite *suite_contacts_pile(void)
{
    Suite *suite = suite_create("contacts_pile");
    TCase *tests = tcase_create("contacts_pile");
    tcase_add_test(tests, heavy);
    tcase_add_test(tests, same_bits);
    tcase_add_test(tests, momentum);
    tcase_add_test(tests, pieces);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_test(slow, pile);
    return suite;
}
