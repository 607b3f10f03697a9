/* SPDX-License-Identifier: MIT */
/** @file layers.c
 *  Boundary particles of layers, one by one. */
#include "start/layers.h"

#include <math.h>

#include "start/start.h"

/* Boundary particles nearer than this many spacings to an earlier one are left out: their area would count twice. */
static const double MIN_DISTANCE = 0.6;

int sph2d__layer_count(const sph2d_sim *sim)
{
    return (int)ceil(sim->system.support / sim->world.scene.spacing - 1e-9);
}

bool sph2d__layers_find_earlier(sph2d_sim *sim, sph2d__near *earlier)
{
    const sph2d__store *w = &sim->system.walls;
    double dx = sim->world.scene.spacing, half = sim->system.rest_density * dx * dx / 2;
    double *x = sph2d__alloc(&sim->memory, w->count + 1, sizeof *x);
    double *y = sph2d__alloc(&sim->memory, w->count + 1, sizeof *y);
    size_t count = 0;
    *earlier = (sph2d__near){0}; /* freed after a failure, too */
    for (size_t i = 0; x && y && i < w->count; ++i) {
        bool sliver = w->mass[i] > 0 && w->mass[i] < half;
        x[count] = w->x[i];
        y[count] = w->y[i];
        count += !sliver;
    }
    bool built = x && y && sph2d__near_build(earlier, x, y, count, MIN_DISTANCE * dx, &sim->memory);
    void *points[] = {x, y};
    for (int k = 0; k < 2; ++k)
        sph2d__release(&sim->memory, &points[k], w->count + 1, sizeof *x);
    return built;
}

sph2d_status sph2d__layers_add(sph2d_sim *sim, const sph2d__boundary_particle *p, sph2d_report *report)
{
    sph2d__system *s = &sim->system;
    if (sph2d__sim_too_many(sim, (double)s->walls.count + 1, "obstacles", report))
        return SPH2D_SCENE;
    if (!sph2d__store_reserve(&s->walls, s->memory, s->walls.count + 1))
        return SPH2D_NOMEM;
    size_t i = sph2d__store_add(&s->walls, s->walls.count, p->at.x, p->at.y);
    s->walls.bounce[i] = -1;
    s->walls.mass[i] = s->rest_density * p->area;
    if (s->walls.normal_x) {
        s->walls.normal_x[i] = p->normal.x;
        s->walls.normal_y[i] = p->normal.y;
    }
    if (s->walls.depth)
        s->walls.depth[i] = p->depth;
    if (s->walls.skin)
        s->walls.skin[i] = p->skin;
    s->walls_press = true;
    return SPH2D_OK;
}
