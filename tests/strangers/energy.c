/* SPDX-License-Identifier: MIT */
/* The energy of a closed scene: it cannot rise. Everything here follows from the scene's documented meaning.
 *
 * The scale that a rise is measured by is the energy that the scene has to spend, for liquid of mass M:
 *
 *     kinetic energy at the start
 *   + M g D     D: how far the centre of mass is, along gravity, above the lowest corner of the domain; beyond an
 *               open side that gravity points to, liquid is followed for one more domain, and D reaches as far
 *   + M B^2 <(x - centre)^2>/2     of the central force
 *   + sigma 2 sqrt(pi A)           of the surface of a round drop of the liquid's area A
 *   + elastic energy at the start
 *   + the first two of bodies, with the energy of their springs
 *
 * but at least M (0.01 c0)^2/2, so that liquid at rest without any force has a scale, too. */
#include <math.h>

#include "judge.h"

static const double pi = 3.14159265358979323846;

static bool moves(const sph2d_motion *motion)
{
    return motion->path.count > 0 || motion->rate != 0 || motion->swing_count > 0 ||
           (motion->frequency > 0 && (hypot(motion->amplitude.x, motion->amplitude.y) > 0 || motion->angle != 0));
}

bool walls_are_at_rest(const sph2d_scene *s)
{
    bool rest = true;
    for (size_t i = 0; i < s->obstacle_count; ++i)
        rest = rest && !moves(&s->obstacles[i].motion);
    return rest;
}

bool scene_is_closed(const sph2d_scene *s)
{
    const bool period_x = s->boundary.left == SPH2D_SIDE_PERIODIC, period_y = s->boundary.bottom == SPH2D_SIDE_PERIODIC;
    bool drive = s->source_count > 0 || s->drain_count > 0 || s->opening_count > 0 || s->interaction_count > 0 ||
                 moves(&s->motion);
    for (size_t i = 0; i < s->body_count; ++i)
        drive = drive || (s->bodies[i].motor.torque > 0 && s->bodies[i].motor.rate != 0);
    drive = drive || !walls_are_at_rest(s);
    drive = drive || s->wall_speeds.left != 0 || s->wall_speeds.right != 0 || s->wall_speeds.bottom != 0 ||
            s->wall_speeds.top != 0;
    // Forces along a period have no potential.
    drive = drive || (period_x && s->gravity.x != 0) || (period_y && s->gravity.y != 0) ||
            (s->central_force.rate > 0 && (period_x || period_y));
    return !drive;
}

/** Integral of p/rho^2 over density from rest density to r rho0 [J/kg]. */
static double elastic(double c0, double r)
{
    return c0 * c0 * (log(r) + 1 / r - 1);
}

double held_energy(const sph2d_scene *s, const sph2d_plan *plan, const sph2d_view *fluid, bool start)
{
    const double c2 = plan->sound_speed * plan->sound_speed;
    const double asked = s->method.max_compression > 0 ? s->method.max_compression : 0.01;
    const double unknown = s->method.name == SPH2D_METHOD_PCISPH ? asked : 0;
    double sum = 0;
    for (size_t i = 0; i < fluid->count && isfinite(c2); ++i) {
        const double compression = fluid->density[i] / s->fluid.density - 1;
        const double pressed = fluid->pressure[i] / (s->fluid.density * c2);
        const double held = (start ? compression : fmin(compression, pressed)) - unknown;
        sum += held > 0 ? c2 * held * held / 2 : 0;
    }
    return plan->particle_mass * sum;
}

double elastic_energy(const sph2d_scene *s, const sph2d_plan *plan, const sph2d_view *fluid)
{
    if (s->method.name == SPH2D_METHOD_PCISPH)
        return 0; // held_energy() tells it, and a start's does not make the scale larger
    const bool squares = s->method.name == SPH2D_METHOD_CONSTRAINT ||
                         (s->method.name == SPH2D_METHOD_WCSPH && s->method.operators == SPH2D_OPERATORS_VARIATIONAL);
    double sum = 0;
    for (size_t i = 0; i < fluid->count; ++i) {
        const double r = fluid->density[i] / s->fluid.density;
        if (squares) // p = rho c0^2 ln r
            sum += pow(plan->sound_speed * log(r), 2) / 2;
        else if (fluid->pressure[i] * (r - 1) > 0) // where a method has no tension, nothing is stretched
            sum += elastic(plan->sound_speed, r);
    }
    return plan->particle_mass * sum;
}

/** How far a point is above the lowest place along gravity, times g [m^2/s^2]. */
static double fall(const sph2d_scene *s, double x, double y)
{
    const sph2d_box *box = &s->domain;
    const double width = box->max.x - box->min.x, height = box->max.y - box->min.y;
    const bool open_x = (s->gravity.x < 0 ? s->boundary.left : s->boundary.right) == SPH2D_SIDE_OPEN;
    const bool open_y = (s->gravity.y < 0 ? s->boundary.bottom : s->boundary.top) == SPH2D_SIDE_OPEN;
    const double down_x = s->gravity.x < 0 ? x - box->min.x : box->max.x - x;
    const double down_y = s->gravity.y < 0 ? y - box->min.y : box->max.y - y;
    return fabs(s->gravity.x) * (down_x + (open_x ? width : 0)) + fabs(s->gravity.y) * (down_y + (open_y ? height : 0));
}

double energy_scale(const sph2d_scene *s, const sph2d_sim *sim)
{
    const sph2d_view fluid = sph2d_sim_fluid(sim);
    const sph2d_plan *plan = sph2d_sim_plan(sim);
    const double m = plan->particle_mass, total = m * (double)fluid.count;
    double sum = 0;
    for (size_t i = 0; i < fluid.count; ++i) {
        const double x = fluid.x[i] - s->central_force.center.x, y = fluid.y[i] - s->central_force.center.y;
        sum += 0.5 * (fluid.vx[i] * fluid.vx[i] + fluid.vy[i] * fluid.vy[i]) + fall(s, fluid.x[i], fluid.y[i]) +
               0.5 * s->central_force.rate * s->central_force.rate * (x * x + y * y);
    }
    const double surface = s->fluid.surface_tension * 2 * sqrt(pi * total / s->fluid.density);
    const double least = 0.5 * total * 1e-4 * plan->sound_speed * plan->sound_speed;
    return fmax(m * sum + surface + elastic_energy(s, plan, &fluid) + bodies_scale(s, fall), least);
}
