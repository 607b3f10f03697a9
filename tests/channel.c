/* SPDX-License-Identifier: MIT */
/** @file channel.c
 *  The channel of channel.h. */
#include "channel.h"

#include <math.h>

test_channel channel;

void channel_add_openings(void)
{
    for (int k = 0; k < 2; ++k) {
        channel.openings[k] = sph2d_opening_default();
        channel.openings[k].side = k == 0 ? SPH2D_SIDE_NAME_LEFT : SPH2D_SIDE_NAME_RIGHT;
        channel.openings[k].name = k == 0 ? "in" : "out";
        channel.probes[k] = sph2d_probe_default();
        channel.probes[k].kind = SPH2D_PROBE_OPENING;
        channel.probes[k].name = channel.probes[k].on = channel.openings[k].name;
        channel.probes[k].rate.every = 1;
    }
    channel.scene.openings = channel.openings;
    channel.scene.probes = channel.probes;
    channel.scene.opening_count = channel.scene.probe_count = 2;
}

void channel_lay(double width, double height, bool walls)
{
    channel = (test_channel){.scene = sph2d_scene_default()};
    channel.scene.domain = (sph2d_box){{0, 0}, {width, height}};
    channel.scene.boundary.bottom = channel.scene.boundary.top = walls ? SPH2D_SIDE_WALL : SPH2D_SIDE_PERIODIC;
    channel.scene.gravity = (sph2d_vec2){0, 0};
    channel.scene.spacing = CHANNEL_DX;
    channel.blocks[0] = test_block(0, 0, width, height);
    channel.blocks[0].velocity.x = 1;
    channel.scene.blocks = channel.blocks;
    channel.scene.block_count = 1;
    channel_add_openings();
    channel.openings[0].velocity = 1;
    channel.openings[1].pressure = 0;
}

void channel_start(void)
{
    channel.sim = test_create(&channel.scene, NULL);
}

void channel_run_until(double time)
{
    while (sph2d_sim_time(channel.sim) < time)
        test_steps(channel.sim, 1);
}

void channel_finish(void)
{
    sph2d_sim_destroy(channel.sim);
    channel.sim = NULL;
}

channel_reading channel_read(size_t index)
{
    double v[SPH2D_PROBE_MAX_COLUMNS];
    ck_assert_uint_eq(sph2d_sim_probe(channel.sim, index, v), 5);
    return (channel_reading){v[0], v[1], v[2], v[3], v[4]};
}

void channel_check_count(uint64_t at_start)
{
    sph2d_summary s = sph2d_sim_summary(channel.sim);
    ck_assert_uint_eq(s.particles, at_start + s.let_in - s.let_out);
}

channel_error channel_parabola_error(void)
{
    const double height = channel.scene.domain.max.y, width = channel.scene.domain.max.x;
    sph2d_view f = sph2d_sim_fluid(channel.sim);
    double worst = 0, x[2] = {0, 0}, p[2] = {0, 0}, n[2] = {0, 0};
    for (size_t i = 0; i < f.count; ++i) {
        double z = f.y[i] / height, along = f.x[i] / width;
        if (along > 0 && along < 1)
            worst = fmax(worst, fabs(f.vx[i] - 6 * z * (1 - z)));
        int near = along > 0.2 && along < 0.3 ? 0 : along > 0.7 && along < 0.8 ? 1 : -1;
        if (near >= 0) {
            x[near] += f.x[i];
            p[near] += f.pressure[i];
            ++n[near];
        }
    }
    double slope = (p[1] / n[1] - p[0] / n[0]) / (x[1] / n[1] - x[0] / n[0]);
    double exact = -12 * channel.scene.fluid.dynamic_viscosity / (height * height);
    return (channel_error){worst, slope / exact - 1};
}

void channel_compare(sph2d_sim *a, sph2d_sim *b)
{
    sph2d_view p = sph2d_sim_fluid(a), q = sph2d_sim_fluid(b);
    ck_assert_uint_eq(p.count, q.count);
    for (size_t i = 0; i < p.count; ++i) {
        ck_assert_uint_eq(p.id[i], q.id[i]);
        ck_assert(p.x[i] == q.x[i] && p.y[i] == q.y[i] && p.vx[i] == q.vx[i] && p.density[i] == q.density[i]);
    }
    ck_assert(sph2d_sim_summary(a).energy_fed == sph2d_sim_summary(b).energy_fed);
}
