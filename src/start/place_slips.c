/* SPDX-License-Identifier: MIT */
/** @file place_slips.c
 *  The slip of boundary particles, where walls differ in it. */
#include "start/start.h"

/** The slip at a position outside the sides. In the corner between two it is that of the rougher one: beside a wall
 *  with free slip, which is a mirror, the other one goes on. */
static sph2d_slip slip_outside(const sph2d__world *world, double x, double y)
{
    sph2d_box d = world->box;
    const double outside[SPH2D__WALL_OBSTACLE] = {d.min.x - x, x - d.max.x, d.min.y - y, y - d.max.y};
    sph2d_slip slip = SPH2D_SLIP_FREE;
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side) {
        if (!(outside[side] > 0) || sph2d__side_of(&world->scene, side) != SPH2D_SIDE_WALL)
            continue;
        sph2d_slip own = world->walls[side].slip;
        if (own == SPH2D_SLIP_NONE || slip == SPH2D_SLIP_FREE)
            slip = own;
    }
    return slip;
}

sph2d_status sph2d__sim_set_slips(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    sph2d__store *w = &s->walls;
    unsigned slips = sph2d__wall_slips(&sim->world);
    if (!(slips & (slips - 1)))
        return SPH2D_OK;
    unsigned char *of = sph2d__arena_alloc(&sim->arena, &sim->memory, w->count + 1, sizeof *of);
    if (!of)
        return SPH2D_NOMEM;
    for (size_t b = 0; b < w->count; ++b)
        of[b] = (unsigned char)slip_outside(&sim->world, w->x[b], w->y[b]);
    for (size_t k = SPH2D__WALL_OBSTACLE; k < sim->world.wall_count; ++k)
        for (uint64_t b = sim->wall_ids[k].first; b < sim->wall_ids[k].end; ++b)
            of[b] = (unsigned char)sim->world.walls[k].slip;
    for (size_t b = 0; s->walls_smooth && b < w->count; ++b)
        if (of[b] != SPH2D_SLIP_SMOOTH)
            w->skin[b] = 0; /* no friction */
    s->wall_slips = of;
    return SPH2D_OK;
}
