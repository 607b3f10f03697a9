/* SPDX-License-Identifier: MIT */
/** @file cloud.c
 *  The cloud of cloud.h. */
#include "cloud.h"

#include <math.h>

#include "sim/simulation.h"

test_cloud cloud;

void cloud_plain(double c0)
{
    cloud.scene.method = sph2d_scene_default().method;
    cloud.scene.method.name = SPH2D_METHOD_WCSPH;
    cloud.scene.method.sound_speed = c0;
}

void cloud_start(void)
{
    cloud.scene = test_open_scene(0.05, -2, -2, 3, 3);
    cloud_plain(10);
    cloud.blocks[0] = test_block(0, 0, 1, 1);
    cloud.blocks[0].perturb.amplitude = 0.2;
    cloud.scene.blocks = cloud.blocks;
    cloud.scene.block_count = 1;
}

void cloud_stir(sph2d_sim *sim, double speed)
{
    sph2d__store *f = &sim->system.fluid;
    sim->record.energy_low = sim->record.error_low = INFINITY; /* what comes in here comes from somewhere */
    for (size_t i = 0; i < f->count; ++i) {
        uint64_t seed = f->id[i] * 977 + 5;
        f->vx[i] += test_random(&seed, -speed, speed);
        f->vy[i] += test_random(&seed, -speed, speed);
    }
}
