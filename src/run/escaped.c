/* SPDX-License-Identifier: MIT */
/** @file escaped.c
 *  What to do about a particle that is beyond a wall of the domain. */
#include <math.h>

#include "run/run.h"
#include "scene/shape.h"
#include "scene/world.h"

/** The wall that moves and is nearest to a position, within the support radius; SIZE_MAX: none. */
static size_t moving_near(const sph2d_sim *sim, sph2d_vec2 p)
{
    double least = sim->system.support;
    size_t nearest = SIZE_MAX;
    for (size_t k = SPH2D__WALL_OBSTACLE; k < sim->world.wall_count; ++k) {
        const sph2d__wall *wall = &sim->world.walls[k];
        if (!sph2d__wall_moves(wall))
            continue;
        sph2d__pose pose = sph2d__sim_pose_of(sim, wall);
        double distance = sph2d__shape_nearest(&wall->shape, sim->world.scene.spacing, sph2d__pose_invert(&pose, p));
        if (distance < least) {
            least = distance;
            nearest = k;
        }
    }
    return nearest;
}

/** The word of the side beyond which a position is. */
static const char *side_beyond(const sph2d_box *box, sph2d_vec2 p)
{
    int side = SPH2D__WALL_LEFT;
    while (side < SPH2D__WALL_TOP && !(sph2d__side_distance(box, side, p) < 0))
        ++side;
    return sph2d__side_word(side);
}

void sph2d__sim_hint_escape(const sph2d_sim *sim, sph2d_vec2 p, sph2d_diagnostic *d)
{
    const char *side = side_beyond(&sim->world.box, p);
    bool fixed = sim->world.scene.method.time_step > 0;
    const char *step = fixed ? "; leave method.time_step out for an adaptive step, or lower it" : "";
    char name[64];
    size_t k = moving_near(sim, p);
    if (k == SIZE_MAX)
        sph2d_diagnostic_hint(d, "start liquid inside the domain%s", fixed ? step : "; lower method.cfl");
    else if (sim->world.walls[k].body)
        sph2d_diagnostic_hint(d, "%s presses it against the %s side: let what drives the body stop before%s",
                              sph2d__wall_path(name, sizeof name, &sim->world.walls[k], ""), side, step);
    else
        sph2d_diagnostic_hint(d, "%s squeezes it against the %s side: let the motion stop a spacing before%s",
                              sph2d__wall_path(name, sizeof name, &sim->world.walls[k], ""), side, step);
}
