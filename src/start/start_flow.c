/* SPDX-License-Identifier: MIT */
/** @file start_flow.c
 *  Liquid that starts with a known flow. */
#include <math.h>

#include "methods/common/state_equation.h"
#include "scene/method_table.h"
#include "start/start.h"

/** Height of a position against gravity, from the origin [m]. */
static double height_of(const sph2d__world *world, double x, double y)
{
    const sph2d_scene *scene = &world->scene;
    double g = world->gravity.size;
    return g > 0 ? -(scene->gravity.x * x + scene->gravity.y * y) / g : 0;
}

/** Height of the bottom: half a spacing below the lowest particle from `first` on. */
static double bottom_of(const sph2d_sim *sim, size_t first)
{
    const sph2d__store *f = &sim->system.fluid;
    double lowest = INFINITY;
    for (size_t i = first; i < f->count; ++i)
        lowest = fmin(lowest, height_of(&sim->world, f->x[i], f->y[i]));
    return lowest - sim->world.scene.spacing / 2;
}

/** Where a particle of initially hydrostatic liquid is once the liquid below it is compressed: spacing and density then
 *  agree, and the column does not sink when it is released. A height s of the lattice becomes y with dy/ds = rho0/rho,
 *  where the pressure is rho0 g (S - s), S the height of the surface:
 *
 *      y = c0^2/g ln((1 + g S/c0^2)/(1 + g (S - s)/c0^2)) */
static sph2d_vec2 settled(const sph2d_sim *sim, size_t i, double pressure, double bottom)
{
    const sph2d_scene *scene = &sim->world.scene;
    const sph2d__store *f = &sim->system.fluid;
    double g = sim->world.gravity.size, c2 = sim->system.sound_speed * sim->system.sound_speed;
    double s = height_of(&sim->world, f->x[i], f->y[i]) - bottom, head = pressure / (scene->fluid.density * g);
    if (!(g > 0 && pressure > 0))
        return (sph2d_vec2){f->x[i], f->y[i]};
    double at_bottom = g * (head + s) / c2, at_particle = g * head / c2;
    double y = c2 / g * log((1 + at_bottom) / (1 + at_particle));
    return (sph2d_vec2){f->x[i] - scene->gravity.x / g * (y - s), f->y[i] - scene->gravity.y / g * (y - s)};
}

/** Settles the particles of a lattice, unless solids are in the way, on which they cannot sink: around these the lattice
 *  stays as it is, and the liquid is too light for its pressure by half of its compression, 0.5 % at most by default. */
static void settle(sph2d_sim *sim, const sph2d_flow *flow, size_t first)
{
    sph2d__store *f = &sim->system.fluid;
    const double bottom = bottom_of(sim, first);
    sph2d_flow_context context = sph2d__sim_flow_context(sim);
    for (int move = 0; move < 2; ++move)
        for (size_t i = first; i < f->count; ++i) {
            double vx, vy, pressure;
            if (sph2d_flow_values(flow, &context, 0, 1, &f->x[i], &f->y[i], &vx, &vy, &pressure, NULL) != SPH2D_OK)
                return;
            const sph2d_vec2 at = settled(sim, i, pressure, bottom);
            if (!move && sph2d__sim_is_in_layers(sim, at))
                return;
            if (move) {
                f->x[i] = at.x;
                f->y[i] = at.y;
            }
        }
}

sph2d_status sph2d__sim_start_flow(sph2d_sim *sim, const sph2d_flow *flow, size_t first, bool lattice,
                                   sph2d_report *report)
{
    sph2d__store *f = &sim->system.fluid;
    const bool summed = sph2d__method_row_of(&sim->world.scene.method)->summed_density;
    sph2d_flow_context context = sph2d__sim_flow_context(sim);
    for (size_t i = first; i < f->count; ++i) {
        double vx, vy, pressure;
        sph2d_status status = sph2d_flow_values(flow, &context, 0, 1, &f->x[i], &f->y[i], &vx, &vy, &pressure, report);
        if (status != SPH2D_OK)
            return SPH2D_SCENE;
        f->vx[i] += vx;
        f->vy[i] += vy;
        if (!summed)
            f->density[i] = sph2d__density_of(&sim->system, pressure);
    }
    if (!summed && lattice && (flow->kind == SPH2D_FLOW_STILL || flow->kind == SPH2D_FLOW_STANDING_WAVE))
        settle(sim, flow, first);
    return SPH2D_OK;
}
