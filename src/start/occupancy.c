/* SPDX-License-Identifier: MIT */
/** @file occupancy.c
 *  Which positions are free of obstacles. */
#include <math.h>

#include "scene/liquid.h"
#include "start/start.h"

/* Clearance of the liquid from an obstacle's surface [spacings]. Layers of boundary particles begin half a spacing
 * behind the surface, so that the lattice continues in them; so does the row of a solid (place_walls.c). Rows of lines
 * are on the surface. */
static const double CLEARANCE = 0.7, CLEARANCE_OF_LAYERS = 0.49;

static bool is_in_disc(sph2d_vec2 center, double radius, sph2d_vec2 p)
{
    double x = fabs(p.x - center.x), y = fabs(p.y - center.y);
    return x < radius && y < radius && hypot(x, y) < radius;
}

/** Whether a position is farther than a distance from the box around a segment: most are. */
static bool is_far(const sph2d__segment *s, double distance, sph2d_vec2 p)
{
    return p.x < fmin(s->a.x, s->b.x) - distance || p.x > fmax(s->a.x, s->b.x) + distance ||
           p.y < fmin(s->a.y, s->b.y) - distance || p.y > fmax(s->a.y, s->b.y) + distance;
}

/** Whether a position is within a distance of an outline. */
static bool is_near(const sph2d_shape *outline, double spacing, double distance, sph2d_vec2 p)
{
    const sph2d_circle *c = &outline->circle;
    if (outline->kind == SPH2D_SHAPE_CIRCLE) /* by its radius: it has far more pieces than the others */
        return is_in_disc(c->center, c->radius + distance, p) && !is_in_disc(c->center, c->radius - distance, p);
    if (outline->kind == SPH2D_SHAPE_ARC) {
        double side, bulge = sph2d__arc_bulge(&outline->arc, spacing);
        return sph2d__arc_distance(&outline->arc, p, &side) < distance + bulge;
    }
    size_t pieces = sph2d__shape_pieces(outline, spacing);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__shape_piece(outline, spacing, k);
        if (!is_far(&s, distance, p) && sph2d__segment_distance(&s, p) < distance)
            return true;
    }
    return false;
}

static sph2d__occupancy occupancy_by(const sph2d_sim *sim, const sph2d__wall *wall, double factor, sph2d_vec2 p)
{
    bool layers = wall->form == SPH2D_WALL_GENERALISED;
    bool inset = layers || sph2d__has_inset_row(wall);
    double distance = factor * (inset ? CLEARANCE_OF_LAYERS : CLEARANCE) * sim->world.scene.spacing;
    if (sph2d__wall_fills(&sim->world.scene, wall, p))
        return layers ? SPH2D__ENCLOSED : SPH2D__NEAR_LINE;
    if (!is_near(&wall->shape, sim->world.scene.spacing, distance, p))
        return SPH2D__FREE;
    return layers ? SPH2D__NEAR_LAYERS : SPH2D__NEAR_LINE;
}

sph2d__occupancy sph2d__sim_occupancy(const sph2d_sim *sim, sph2d_vec2 p, double factor)
{
    const sph2d__period *period = &sim->system.fluid_cells.period;
    int across = period->length_x > 0, along = period->length_y > 0;
    sph2d__occupancy occupancy = SPH2D__FREE;
    for (int image_x = -across; image_x <= across; ++image_x)
        for (int image_y = -along; image_y <= along; ++image_y) {
            sph2d_vec2 image = {p.x + image_x * period->length_x, p.y + image_y * period->length_y};
            sph2d__solid_list near = sph2d__solids_near(&sim->solids, image);
            for (size_t k = 0; k < near.count; ++k) {
                sph2d__occupancy other = occupancy_by(sim, &sim->world.walls[near.wall[k]], factor, image);
                occupancy = other > occupancy ? other : occupancy;
            }
        }
    return occupancy;
}
