/* SPDX-License-Identifier: MIT */
/** @file fitted.c
 *  Method `wcsph` with fitted operators: constants and step limits. The pair loop is in fitted_pass.c. */
#include "methods/fitted/fitted.h"

#include <math.h>

#include "methods/common/state_equation.h"
#include "methods/terms/stable_step.h"

/* Step limits as fractions of H^2/nu and sqrt(H/a), and of H/(delta c0) for density diffusion. The Adams-Bashforth
 * scheme is stable on a lattice up to 0.0089 H^2/nu (H/dx 2 to 4; between no-slip walls 0.0065), 0.107 H/(delta c0),
 * and, for sound, 0.315 H/c0. */
static const double VISCOUS = 0.0075;
static const double VISCOUS_AT_WALLS = 0.005;
static const double FORCE = 0.25;
static const double DIFFUSIVE = 0.08;

static const sph2d__fitted_passes *passes(const sph2d__system *s)
{
    return sph2d__fitted_passes_find(s->isa);
}

/** For f = r^4 the fit gives c (x^2 + y^2), whose Laplacian 4c is wrong at the centre, and leaves the residual R:
 *  gamma makes 4c + gamma R = 0. */
double sph2d__fitted_residual_gain(double ratio)
{
    double m2 = 0, m4 = 0, m22 = 0, m6 = 0, m42 = 0;
    int reach = (int)ratio + 1;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j) {
            double x = i / ratio, y = j / ratio, q = sqrt(x * x + y * y);
            double w = q < 1 ? (1 - q) * (1 - q) * (1 - q) : 0;
            m2 += w * x * x;
            m4 += w * x * x * x * x;
            m22 += w * x * x * y * y;
            m6 += w * pow(x, 6);
            m42 += w * pow(x, 4) * y * y;
        }
    double c = (m6 + 3 * m42) / (m4 + m22);
    double residual = 2 / m2 * (2 * m4 + 2 * m22 - 2 * c * m2);
    return -4 * c / residual;
}

static void prepare(sph2d__system *s)
{
    s->residual_gain = sph2d__fitted_residual_gain(s->support / s->spacing);
}

static bool evaluate(sph2d__system *s)
{
    sph2d_phase before = sph2d__profile_enter(&s->profile, SPH2D_PHASE_FORCES);
    sph2d__over_particles(s, s->fluid.count, passes(s)->rates, NULL);
    sph2d__state_equation_apply(s);
    sph2d__profile_enter(&s->profile, before);
    return true;
}

static double stable_step(const sph2d__system *s, double speed, double acceleration, sph2d__limit *limit)
{
    double nu = s->viscosity / s->rest_density;
    double viscous = s->walls_press ? VISCOUS_AT_WALLS : VISCOUS;
    double step = sph2d__shortest_step(s, s->sound_speed, speed, acceleration, nu, viscous, FORCE, limit);
    double diffusive = DIFFUSIVE * s->support / (s->method.density_diffusion * s->sound_speed);
    if (step <= diffusive)
        return step;
    *limit = SPH2D__LIMIT_ACOUSTIC;
    return diffusive;
}

/* The rates that are kept for two steps. */
#define RATES (SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(density_rate))
#define OLD_RATES (SPH2D__BIT(old_ax) | SPH2D__BIT(old_ay) | SPH2D__BIT(old_density_rate))
#define OLDER_RATES (SPH2D__BIT(older_ax) | SPH2D__BIT(older_ay) | SPH2D__BIT(older_density_rate))
/* The shift velocity and the rates by advection with it. */
#define SHIFT                                                                                                          \
    (SPH2D__BIT(shift_x) | SPH2D__BIT(shift_y) | SPH2D__BIT(shift_ax) | SPH2D__BIT(shift_ay) |                         \
     SPH2D__BIT(shift_density_rate))

const sph2d__method sph2d__wcsph_fitted = {
    .name = "wcsph, fitted",
    .step = sph2d__adams_bashforth,
    .fluid = SPH2D__STORE_BASIC | SPH2D__BIT(density) | SPH2D__BIT(pressure) | RATES | OLD_RATES | OLDER_RATES | SHIFT,
    .carried = SPH2D__STORE_BASIC | SPH2D__BIT(density) | RATES | OLD_RATES,
    .walls = SPH2D__STORE_BASIC | SPH2D__BIT(normal_x) | SPH2D__BIT(normal_y) | SPH2D__BIT(depth) | SPH2D__BIT(ax) |
             SPH2D__BIT(ay) | SPH2D__BIT(start_x) | SPH2D__BIT(start_y) | SPH2D__BIT(mass) | SPH2D__BIT(bounce) |
             SPH2D__BIT(density) | SPH2D__BIT(pressure) | SPH2D__BIT(skin),
    .prepare = prepare,
    .evaluate = evaluate,
    .surface_force = sph2d__fitted_surface_force,
    .stable_step = stable_step,
};
