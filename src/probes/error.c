/* SPDX-License-Identifier: MIT */
/** @file error.c
 *  The difference from an exact solution: the known flow that the scene's first such block starts with. */
#include <math.h>

#include "probes/probes.h"

static const sph2d_flow *flow_of(const sph2d_scene *scene)
{
    for (size_t i = 0; i < scene->block_count; ++i)
        if (scene->blocks[i].start.flow.kind != SPH2D_FLOW_NONE)
            return &scene->blocks[i].start.flow;
    return NULL;
}

/** Sums over the particles; `exact` ones are of the solution at their positions. */
typedef struct differences {
    double speed, exact_speed;   /* of magnitudes */
    double vector, vector_max;   /* of vectors */
    double energy, exact_energy; /* squares of speeds */
    double pressure, pressure2;  /* magnitudes and squares */
    double exact_pressure, exact_pressure_max;
} differences;

enum { BATCH = 256 };

/** False when the solution is not known at this time. */
static bool sum_differences(const sph2d_sim *sim, const sph2d_flow *flow, differences *d)
{
    const sph2d__store *f = &sim->system.fluid;
    sph2d_flow_context context = sph2d__sim_flow_context(sim);
    double vx[BATCH], vy[BATCH], p[BATCH];
    for (size_t first = 0; first < f->count; first += BATCH) {
        size_t count = f->count - first < BATCH ? f->count - first : BATCH;
        if (sph2d_flow_values(flow, &context, sim->record.time, count, f->x + first, f->y + first, vx, vy, p, NULL) !=
            SPH2D_OK)
            return false;
        for (size_t k = 0; k < count; ++k) {
            size_t i = first + k;
            double speed = hypot(f->vx[i], f->vy[i]), exact = hypot(vx[k], vy[k]);
            double vector = hypot(f->vx[i] - vx[k], f->vy[i] - vy[k]), pressure = f->pressure[i] - p[k];
            d->speed += fabs(speed - exact);
            d->exact_speed += exact;
            d->vector += vector;
            d->vector_max = fmax(d->vector_max, vector);
            d->energy += speed * speed;
            d->exact_energy += exact * exact;
            d->pressure += fabs(pressure);
            d->pressure2 += pressure * pressure;
            d->exact_pressure += fabs(p[k]);
            d->exact_pressure_max = fmax(d->exact_pressure_max, fabs(p[k]));
        }
    }
    return true;
}

size_t sph2d__probe_error(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    (void)probe;
    const sph2d_flow *flow = flow_of(&sim->world.scene);
    differences d = {0};
    bool known = flow && sum_differences(sim, flow, &d);
    double unit = flow ? fabs(flow->speed) : 0;
    if (!(unit > 0)) /* a flow at rest: the speed that its pressure could make */
        unit = sqrt(d.exact_pressure_max / sim->world.scene.fluid.density);
    double count = (double)sim->system.fluid.count;
    values[0] = d.speed / d.exact_speed;
    values[1] = d.vector / d.exact_speed;
    values[2] = d.vector_max / unit;
    values[3] = d.pressure / d.exact_pressure;
    values[4] = sqrt(d.pressure2 / count) / d.exact_pressure_max;
    values[5] = d.energy / d.exact_energy - 1;
    for (int k = 0; k < 6; ++k)
        if (!known || !isfinite(values[k]))
            values[k] = NAN;
    return 6;
}
