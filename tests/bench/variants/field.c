/* SPDX-License-Identifier: MIT */
/** @file field.c
 *  The particles that all ways go through, and the sums that they should find. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/pi.h"
#include "base/random.h"
#include "variants.h"

/* As in `make bench`: neighbours about 21; a tenth of the speed of sound at 1.4 c dt/dx. */
static const double SPACING = 0.01, REACH = 2.6, DRIFT = 0.14;
/* Steps of the random walk, and how long each is at most, in spacings. */
enum { WALK = 8 };
static const double PACE = 0.1;
/* Lower corner of the lattice [m]: padding is at the origin. */
static const double CORNER = 10;
/* Lattice spacings of a wave of the flow. */
static const double WAVE = 40;
/* Pairs that a brute-force loop may take. */
static const double PAIRS = 3e8;

static void check_memory(const void *got)
{
    if (got)
        return;
    fputs("variants: out of memory\n", stderr);
    exit(1);
}

uint32_t *numbers_reserve(numbers *n, size_t count)
{
    if (count > n->capacity) {
        free(n->at);
        n->at = calloc(count, sizeof *n->at);
        check_memory(n->at);
        n->capacity = count;
    }
    return n->at;
}

static scene make_scene(void)
{
    double support = REACH * SPACING, density = 1000, sound = 10;
    scene s = {.spacing = SPACING,
               .support = support,
               .mass = density * SPACING * SPACING,
               .rest_density = density,
               .sound_speed = sound,
               .drift = DRIFT * SPACING};
    s.diffusion = 0.1 * support * sound / s.mass;
    s.viscosity = density * 0.02 * sound * support / 16;
    s.scale = 7 / SPH2D__PI / (support * support * support * support);
    return s;
}

static double noise(uint64_t particle, uint64_t what)
{
    return sph2d__noise(1, 2, particle, what, 0);
}

/** The velocity of a flow of vortices, 1 at most. */
static void flow_at(double x, double y, double *u, double *v)
{
    double wave = 2 * SPH2D__PI / (WAVE * SPACING);
    *u = sin(wave * x) * cos(wave * y);
    *v = -cos(wave * x) * sin(wave * y);
}

void field_create(field *f, double particles)
{
    size_t side = (size_t)sqrt(particles), count = side * side;
    *f = (field){.scene = make_scene(), .memory = sph2d__memory_from((sph2d_allocator){NULL, NULL})};
    f->store.carried = SPH2D__STORE_BASIC | SPH2D__BIT(density);
    f->store.has = f->store.carried | SPH2D__BIT(pressure) | SPH2D__BIT(volume) | SPH2D__BIT(density_rate) |
                   SPH2D__BIT(ax) | SPH2D__BIT(ay);
    if (!sph2d__store_reserve(&f->store, &f->memory, count))
        check_memory(NULL);
    f->store.count = count;
    size_t room = count + SPH2D__PADDING;
    f->sorted = calloc(room, sizeof *f->sorted);
    f->blocks = aligned_alloc(sizeof(block), room * sizeof(block));
    f->other_blocks = aligned_alloc(sizeof(block), room * sizeof(block));
    check_memory(f->sorted);
    check_memory(f->blocks);
    check_memory(f->other_blocks);
    memset(f->blocks, 0, room * sizeof(block));
    memset(f->other_blocks, 0, room * sizeof(block));
}

void field_free(field *f)
{
    numbers *all[] = {&f->start,      &f->key,  &f->order,       &f->head,     &f->next,
                      &f->list_begin, &f->list, &f->group_first, &f->spread_x, &f->spread_y};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        free(all[k]->at);
    free(f->sorted);
    free(f->blocks);
    free(f->other_blocks);
    sph2d__cells_free(&f->cells, &f->memory);
    sph2d__store_free(&f->store, &f->memory);
}

/** Puts particle number `id` at place i. */
static void place_particle(field *f, size_t i, size_t id, size_t side)
{
    const scene *s = &f->scene;
    double x = CORNER + (double)(id % side) * s->spacing, y = CORNER + (double)(id / side) * s->spacing, u, v;
    for (uint64_t step = 0; step < WALK; ++step) {
        x += PACE * s->spacing * noise(id, 10 + 2 * step);
        y += PACE * s->spacing * noise(id, 11 + 2 * step);
    }
    flow_at(x, y, &u, &v);
    f->store.x[i] = x;
    f->store.y[i] = y;
    f->store.vx[i] = 0.1 * s->sound_speed * (u + 0.3 * noise(id, 1));
    f->store.vy[i] = 0.1 * s->sound_speed * (v + 0.3 * noise(id, 2));
    f->store.density[i] = s->rest_density * (1 + 0.01 * noise(id, 3));
    f->store.id[i] = id;
}

void field_restart(field *f, bool mixed)
{
    size_t count = f->store.count, side = (size_t)(sqrt((double)count) + 0.5);
    uint32_t *order = numbers_reserve(&f->order, count);
    for (size_t i = 0; i < count; ++i)
        order[i] = (uint32_t)i;
    for (size_t i = 1; mixed && i < count; ++i) {
        size_t other = sph2d__mix(i) % (i + 1);
        uint32_t kept = order[i];
        order[i] = order[other];
        order[other] = kept;
    }
    for (size_t i = 0; i < count; ++i)
        place_particle(f, i, order[i], side);
}

void field_move(field *f, int steps)
{
    double way = f->scene.drift * steps;
    for (size_t i = 0; i < f->store.count; ++i) {
        double u, v;
        flow_at(f->store.x[i], f->store.y[i], &u, &v);
        f->store.x[i] += way * u;
        f->store.y[i] += way * v;
    }
}

void field_derive(field *f)
{
    const scene *s = &f->scene;
    for (size_t i = 0; i < f->store.count; ++i) {
        f->store.pressure[i] = s->sound_speed * s->sound_speed * (f->store.density[i] - s->rest_density);
        f->store.volume[i] = s->mass / f->store.density[i];
    }
}

void field_pack(field *f)
{
    const sph2d__store *s = &f->store;
    for (size_t i = 0; i < s->count; ++i)
        f->blocks[i] =
            (block){s->x[i], s->y[i], s->vx[i], s->vy[i], s->density[i], s->pressure[i], s->volume[i], s->id[i]};
}

void field_unpack(field *f)
{
    sph2d__store *s = &f->store;
    for (size_t i = 0; i < s->count; ++i) {
        const block *b = &f->blocks[i];
        s->x[i] = b->x;
        s->y[i] = b->y;
        s->vx[i] = b->vx;
        s->vy[i] = b->vy;
        s->density[i] = b->density;
        s->id[i] = b->id;
    }
}

/** The sums of particle i as the equations have them, with no thought of speed. */
static void sum_all(const field *f, size_t i, double sums[3])
{
    const sph2d__store *s = &f->store;
    const scene *c = &f->scene;
    double support = c->support, own = s->pressure[i] * s->volume[i] * s->volume[i];
    sums[0] = sums[1] = sums[2] = 0;
    for (size_t j = 0; j < s->count; ++j) {
        double dx = s->x[i] - s->x[j], dy = s->y[i] - s->y[j], r2 = dx * dx + dy * dy;
        if (j == i || r2 >= support * support)
            continue;
        double t = 1 - sqrt(r2) / support, slope = -20 * t * t * t * c->scale; /* grad W over r_ij */
        double approach = (s->vx[i] - s->vx[j]) * dx + (s->vy[i] - s->vy[j]) * dy;
        double spread = c->diffusion * s->volume[j] * (s->density[i] - s->density[j]);
        double drag = -8 * c->viscosity * s->volume[i] * s->volume[j] * approach / r2;
        double stress = own + s->pressure[j] * s->volume[j] * s->volume[j] + drag;
        sums[0] += c->mass * slope * (approach + spread);
        sums[1] -= slope * stress * dx / c->mass;
        sums[2] -= slope * stress * dy / c->mass;
    }
}

double field_error(const field *f)
{
    const sph2d__store *s = &f->store;
    double largest[3] = {0, 0, 0}, error[3] = {0, 0, 0}, worst = 0;
    size_t every = (size_t)ceil((double)s->count * (double)s->count / PAIRS);
    for (size_t i = 0; i < s->count; i += every) {
        double sums[3], found[3] = {s->density_rate[i], s->ax[i], s->ay[i]};
        sum_all(f, i, sums);
        for (int k = 0; k < 3; ++k) {
            double wrong = fabs(found[k] - sums[k]);
            largest[k] = fmax(largest[k], fabs(sums[k]));
            error[k] = wrong <= error[k] ? error[k] : wrong; /* keeps what is no number */
        }
    }
    for (int k = 0; k < 3; ++k)
        worst = error[k] / largest[k] <= worst ? worst : error[k] / largest[k];
    return worst;
}
