/* SPDX-License-Identifier: MIT */
/** @file test_forces.c
 *  The table of forces: what a force adds is what it drives, whose work is booked, less the slope of its potential. */
#include <math.h>

#include "common.h"
#include "forces/forces.h"

/* All of them, strong enough to be seen. */
static const sph2d__point_force point = {0.4, 0.3, 2, -5};
static const sph2d__forces all = {
    .gravity = {1.2, -9.81, {-1, -2}, true, false},
    .central = {0.2, 0.1, 7},
    .frame = {true, {0.5, 0.5}, {0.3, -0.7}, 1.3, -2.1},
    .springs = {0, 1, 0, INFINITY, 0.25, 900, 40},
    .points = {&point, 1},
};

/* Inside, within a spring's range, at rest, approaching and leaving so fast that its damper would pull. */
static const sph2d__place places[] = {{0.5, 0.5, 0, 0},   {0.1, 0.6, 0, 0},     {0.1, 0.05, -1, -2},
                                      {0.9, 0.2, 0.5, 1}, {0.2, 0.2, 5, 0.125}, {0.97, 0.9, -9, -3},
                                      {0.05, 0.5, 9, 2}};

static double slope(double low, double high, double step)
{
    return (high - low) / (2 * step);
}

#define CHECK_FORCE(name, kind)                                                                                        \
    ck_assert_msg(sph2d__##name##_acts(&all.name), #name " has no values in this test");                               \
    for (size_t k = 0; k < sizeof places / sizeof *places; ++k) {                                                      \
        const sph2d__place at = places[k];                                                                             \
        const double step = 1e-6;                                                                                      \
        double ax = 0, ay = 0, dx = 0, dy = 0;                                                                         \
        sph2d__##name##_add(&all.name, at, &ax, &ay);                                                                  \
        if (sph2d__##name##_drives(&all.name))                                                                         \
            sph2d__##name##_drive(&all.name, at, &dx, &dy);                                                            \
        dx -= slope(sph2d__##name##_potential(&all.name, at.x - step, at.y),                                           \
                    sph2d__##name##_potential(&all.name, at.x + step, at.y), step);                                    \
        dy -= slope(sph2d__##name##_potential(&all.name, at.x, at.y - step),                                           \
                    sph2d__##name##_potential(&all.name, at.x, at.y + step), step);                                    \
        ck_assert_msg(fabs(ax - dx) < 1e-6 && fabs(ay - dy) < 1e-6,                                                    \
                      #name " books another force than acts, in place %zu", k);                                        \
    }

START_TEST(forces_book_what_they_do){SPH2D__FORCES(CHECK_FORCE)} END_TEST

    /** What is lost is lost: dampers take energy, whatever the velocity. */
    START_TEST(dampers_take)
{
    for (size_t k = 0; k < sizeof places / sizeof *places; ++k) {
        double ax = 0, ay = 0;
        sph2d__forces_drive(&all, SPH2D__LOSS, places[k], &ax, &ay);
        ck_assert_double_le(ax * places[k].vx + ay * places[k].vy, 0);
    }
}
END_TEST

/** The sums are those of the rows. */
START_TEST(sums_have_all_forces)
{
    const sph2d__place at = places[2];
    double ax = 0, ay = 0, x = 0, y = 0, potential = 0, work_x = 0, work_y = 0, loss_x = 0, loss_y = 0;
    sph2d__forces_add(&all, at, &ax, &ay);
#define ADD_FORCE(name, kind)                                                                                          \
    sph2d__##name##_add(&all.name, at, &x, &y);                                                                        \
    potential += sph2d__##name##_potential(&all.name, at.x, at.y);
    SPH2D__FORCES(ADD_FORCE)
    ck_assert_double_eq(ax, x);
    ck_assert_double_eq(ay, y);
    ck_assert_double_eq(sph2d__forces_potential(&all, at.x, at.y), potential);
    sph2d__forces_drive(&all, SPH2D__WORK, at, &work_x, &work_y);
    sph2d__forces_drive(&all, SPH2D__LOSS, at, &loss_x, &loss_y);
    ck_assert_double_ne(work_x, 0);
    ck_assert_double_ne(loss_y, 0);
    ck_assert(sph2d__forces_vary(&all));
    const sph2d__forces gravity = {.gravity = {0, -9.81, {0, 0}, false, false}};
    ck_assert(!sph2d__forces_vary(&gravity) && !sph2d__forces_drive_at_all(&gravity, SPH2D__WORK));
}
END_TEST

Suite *suite_forces(void)
{
    Suite *suite = suite_create("forces");
    TCase *tests = tcase_create("forces");
    tcase_add_test(tests, forces_book_what_they_do);
    tcase_add_test(tests, dampers_take);
    tcase_add_test(tests, sums_have_all_forces);
    suite_add_tcase(suite, tests);
    return suite;
}
