/* SPDX-License-Identifier: MIT */
/** @file tank.c
 *  The tank of tank.h. */
#include "tank.h"

#include <math.h>

test_tank tank;

void tank_empty(sph2d_method method, double dx, double width, double height, double viscosity)
{
    sph2d_scene *scene = &tank.scene;
    *scene = test_scene(dx, 0, 0, width, height);
    scene->method = sph2d_scene_default().method;
    scene->method.name = method;
    scene->boundary.top = SPH2D_SIDE_OPEN;
    scene->gravity.y = -G;
    scene->fluid.dynamic_viscosity = viscosity;
    scene->blocks = tank.blocks;
}

void tank_add(double x0, double y0, double x1, double y1)
{
    tank.blocks[tank.scene.block_count++] = test_block(x0, y0, x1, y1);
}

void tank_start(void)
{
    tank.sim = test_create(&tank.scene, NULL);
}

void tank_finish(void)
{
    sph2d_sim_destroy(tank.sim);
    tank.sim = NULL;
}

double tank_settling(double depth)
{
    return 1000 * sqrt(G * depth) * depth / 100;
}

double tank_middle(void)
{
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    double sum = 0;
    for (size_t i = 0; i < f.count; ++i)
        sum += f.y[i];
    return sum / (double)f.count;
}

double tank_fastest(void)
{
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    double most = 0;
    for (size_t i = 0; i < f.count; ++i)
        most = fmax(most, hypot(f.vx[i], f.vy[i]));
    return most;
}

bool tank_is_finite(void)
{
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    bool finite = true;
    for (size_t i = 0; i < f.count; ++i)
        finite = finite && isfinite(f.x[i] + f.y[i] + f.vx[i] + f.vy[i] + f.density[i] + f.pressure[i]);
    return finite;
}

tank_span tank_run_until(double time)
{
    tank_span s = {0};
    int steps = 0;
    for (; sph2d_sim_time(tank.sim) < time; ++steps) {
        test_steps(tank.sim, 1);
        s.fastest = fmax(s.fastest, tank_fastest());
        s.middle += tank_middle();
    }
    s.middle /= steps > 0 ? steps : 1;
    return s;
}
