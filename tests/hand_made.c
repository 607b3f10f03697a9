/* SPDX-License-Identifier: MIT */
/** @file hand_made.c
 *  Simulations whose particles a test places itself. */
#include "hand_made.h"

#include <math.h>

sph2d_sim *hand_made(sph2d_scene scene, size_t room, int threads)
{
    double x = (scene.domain.min.x + scene.domain.max.x) / 2, y = (scene.domain.min.y + scene.domain.max.y) / 2;
    sph2d_block block = test_particle(scene.spacing, x, y, 0, 0);
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = threads;
    sph2d_sim *sim = test_create(&scene, &options);
    ck_assert(sph2d__store_reserve(&sim->system.fluid, sim->system.memory, room));
    remove_all(sim);
    return sim;
}

size_t add_particle(sph2d_sim *sim, double x, double y)
{
    sph2d__store *f = &sim->system.fluid;
    ck_assert_uint_lt(f->count, f->capacity);
    size_t i = sph2d__store_add(f, f->count, x, y);
    f->density[i] = sim->system.rest_density;
    return i;
}

void add_lattice(sph2d_sim *sim, sph2d_box box, double jitter, uint64_t seed)
{
    double dx = sim->system.spacing;
    int nx = (int)round((box.max.x - box.min.x) / dx), ny = (int)round((box.max.y - box.min.y) / dx);
    for (int row = 0; row < ny; ++row)
        for (int column = 0; column < nx; ++column) {
            double x = test_random(&seed, -jitter, jitter), y = test_random(&seed, -jitter, jitter);
            add_particle(sim, box.min.x + (column + 0.5 + x) * dx, box.min.y + (row + 0.5 + y) * dx);
        }
}

void remove_all(sph2d_sim *sim)
{
    sim->system.fluid.count = 0;
}

void sort_particles(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    ck_assert(sph2d__cells_build(&s->fluid_cells, &s->fluid, s->support, s->memory));
}
