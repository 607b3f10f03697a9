/* SPDX-License-Identifier: MIT */
/** @file nozzle.c
 *  A jet that is poured by hand. */
#include "nozzle.h"

#include <math.h>

sph2d_vec2 nozzle_gravity(const sph2d_scene *scene)
{
    const sph2d_vec2 g = scene->gravity;
    const sph2d_box *d = &scene->domain;
    const double size = fmin(d->max.x - d->min.x, d->max.y - d->min.y);
    return g.x != 0 || g.y != 0 ? g : (sph2d_vec2){0, -size};
}

/* The speed with which rows leave. */
static double speed_of(const nozzle *n, const sph2d_scene *scene)
{
    const sph2d_vec2 g = nozzle_gravity(scene);
    return sqrt(hypot(g.x, g.y) * n->width);
}

void nozzle_open(nozzle *n, const sph2d_scene *scene, const sph2d_sim *sim, sph2d_vec2 at, double width)
{
    n->open = true;
    n->at = at;
    n->width = width;
    const double now = sph2d_sim_time(sim), row = scene->spacing / speed_of(n, scene);
    if (!(fabs(now - n->due) <= row + sph2d_sim_time_step(sim)))
        n->due = now;
}

/* One row, as far along as it has come since it was due. */
static sph2d_status emit_row(const nozzle *n, const sph2d_scene *scene, sph2d_sim *sim, double age)
{
    enum { MOST = 4096 };
    sph2d_particle row[MOST];
    const sph2d_vec2 g = nozzle_gravity(scene), acts = scene->gravity;
    const double size = hypot(g.x, g.y), x = g.x / size, y = g.y / size, speed = speed_of(n, scene);
    const double columns = fmin(fmax(floor(n->width / scene->spacing + 0.5), 1), MOST), across = n->width / columns;
    const size_t count = (size_t)columns;
    for (size_t k = 0; k < count; ++k) {
        const double aside = ((double)k - (columns - 1) / 2) * across;
        row[k] = (sph2d_particle){.x = n->at.x + (speed * x + age * acts.x / 2) * age - aside * y,
                                  .y = n->at.y + (speed * y + age * acts.y / 2) * age + aside * x,
                                  .vx = speed * x + age * acts.x,
                                  .vy = speed * y + age * acts.y,
                                  .color = n->color};
    }
    return sph2d_sim_add_particles(sim, row, count, NULL);
}

sph2d_status nozzle_emit(nozzle *n, const sph2d_scene *scene, sph2d_sim *sim)
{
    const double now = sph2d_sim_time(sim), every = n->open ? scene->spacing / speed_of(n, scene) : 0;
    sph2d_status status = SPH2D_OK;
    for (; n->open && n->due <= now && status == SPH2D_OK; n->due += every)
        status = emit_row(n, scene, sim, now - n->due);
    return status;
}
