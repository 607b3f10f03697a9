/* SPDX-License-Identifier: MIT */
/** @file closed_flow.c
 *  What openings make of liquid that has no free surface: how fast it gets in the narrowest part of a channel, and how
 *  hard it is pulled. */
#include "scene/derive.h"

#include <math.h>

#include "scene/openings.h"
#include "scene/shape.h"

/* Places across the channel at which a section is sampled, and corners of an outline at which there is one, at most. */
enum { PLACES = 400, CORNERS = 100 };

/* What the jet round the inner corner of a bend takes of its width (Lichtarowicz & Markland 1963, J. Fluid Mech. 17, 596). */
static const double BEND = 0.53;
/* Gaps that are narrower pass hardly any liquid [spacings]. */
static const double LEAST_GAP = 2;
/* The steepest slope of an opening's ramp, z^3 (10 - 15 z + 6 z^2), at z = 1/2. */
static const double RAMP_SLOPE = 1.875;

/** A channel along x, or along y. */
typedef struct channel {
    const sph2d__world *world;
    const sph2d_scene *scene;
    bool along_x;
    double low, width;  /**< across it [m] */
    double first, last; /**< along it all of the flow passes each section between these [m] */
} channel;

static sph2d_vec2 place(const channel *c, double along, double across)
{
    return c->along_x ? (sph2d_vec2){along, across} : (sph2d_vec2){across, along};
}

/** Whether an obstacle is in the way at a place: lines are as thick as a spacing. */
static bool blocks(const channel *c, const sph2d__wall *wall, sph2d_vec2 p)
{
    const sph2d_shape *outline = &wall->shape;
    double dx = c->scene->spacing;
    if (sph2d__shape_is_open(outline))
        return sph2d__shape_nearest(outline, dx, p) < dx / 2;
    return sph2d__shape_contains(outline, p) != (wall->liquid == SPH2D_LIQUID_INSIDE);
}

/** The free part of the width of the section at `along`; 0 where less is free than liquid passes, or where it need not
 *  pass. */
static double free_part(const channel *c, double along)
{
    if (along < c->first || along > c->last)
        return 0;
    int open = 0;
    for (int k = 0; k < PLACES; ++k) {
        sph2d_vec2 p = place(c, along, c->low + (k + 0.5) / PLACES * c->width);
        bool taken = false;
        for (size_t i = SPH2D__WALL_OBSTACLE; i < c->world->first_body && !taken; ++i)
            taken = blocks(c, &c->world->walls[i], p);
        open += !taken;
    }
    return open * c->width < LEAST_GAP * c->scene->spacing * PLACES ? 0 : (double)open / PLACES;
}

/** The least free part beside an obstacle: at its corners, on both sides of each, and in its middle. 0 is no section but
 *  a wall, which the flow does not pass. */
static double least_beside(const channel *c, const sph2d_shape *outline)
{
    double dx = c->scene->spacing, least = 1;
    sph2d_box b = sph2d__shape_bounds(outline);
    size_t pieces = sph2d__shape_pieces(outline, dx), step = 1 + pieces / CORNERS;
    double middle = free_part(c, c->along_x ? (b.min.x + b.max.x) / 2 : (b.min.y + b.max.y) / 2);
    if (middle > 0)
        least = middle;
    for (size_t k = 0; k < pieces; k += step) {
        sph2d_vec2 corner = sph2d__shape_piece(outline, dx, k).a;
        double at = c->along_x ? corner.x : corner.y;
        for (int side = -1; side <= 1; side += 2) {
            double part = free_part(c, at + side * 1e-6 * dx);
            if (part > 0 && part < least)
                least = part;
        }
    }
    return least;
}

/** The largest flow that openings prescribe on a side [m^2/s], and over which width [m]. */
typedef struct inflow {
    double flow, width;
    sph2d_side_name side;
} inflow;

static inflow largest_flow(const sph2d_scene *scene, sph2d_side_name side)
{
    inflow sum = {0, 0, side};
    for (size_t i = 0; i < scene->opening_count; ++i) {
        const sph2d_opening *o = &scene->openings[i];
        if (o->side != side || !sph2d__opening_has_velocity(o))
            continue;
        double width = sph2d__opening_mouth(scene, o).width;
        bool rate = sph2d__opening_kind_of(o) == SPH2D__OPENING_FLOW_RATE;
        sum.flow += sph2d__opening_largest(o) * (rate ? 1 : width);
        sum.width += width;
    }
    return sum;
}

static inflow larger(inflow a, inflow b)
{
    return a.flow > b.flow ? a : b;
}

/** Whether liquid that enters on a side leaves elsewhere than on the opposite one. */
static bool turns(const sph2d_scene *scene, sph2d_side_name from)
{
    static const sph2d_side_name opposite[] = {[SPH2D_SIDE_NAME_LEFT] = SPH2D_SIDE_NAME_RIGHT,
                                               [SPH2D_SIDE_NAME_RIGHT] = SPH2D_SIDE_NAME_LEFT,
                                               [SPH2D_SIDE_NAME_BOTTOM] = SPH2D_SIDE_NAME_TOP,
                                               [SPH2D_SIDE_NAME_TOP] = SPH2D_SIDE_NAME_BOTTOM};
    for (size_t i = 0; i < scene->opening_count; ++i)
        if (!sph2d__opening_has_velocity(&scene->openings[i]) && scene->openings[i].side != opposite[from])
            return true;
    return false;
}

/** Width of all openings through which liquid flows as it will [m]; INFINITY without any. */
static double free_width(const sph2d_scene *scene)
{
    double sum = 0;
    for (size_t i = 0; i < scene->opening_count; ++i)
        if (!sph2d__opening_has_velocity(&scene->openings[i]))
            sum += sph2d__opening_mouth(scene, &scene->openings[i]).width;
    return sum > 0 ? sum : INFINITY;
}

static bool has_surface(const sph2d_scene *scene)
{
    for (size_t i = 0; i < scene->opening_count; ++i)
        if (sph2d__opening_has_surface(&scene->openings[i]))
            return true;
    return false;
}

/** The channel from the openings of a side into the domain, up to the first opening of the other kind on a side along it:
 *  there the flow may turn. */
static channel channel_from(const sph2d__world *world, sph2d_side_name side, bool with_velocity)
{
    const sph2d_scene *scene = &world->scene;
    const sph2d_box *d = &scene->domain;
    channel c = sph2d__side_is_vertical((int)side)
                    ? (channel){world, scene, true, d->min.y, d->max.y - d->min.y, d->min.x, d->max.x}
                    : (channel){world, scene, false, d->min.x, d->max.x - d->min.x, d->min.y, d->max.y};
    for (size_t i = 0; i < scene->opening_count; ++i) {
        const sph2d_opening *o = &scene->openings[i];
        if (sph2d__side_is_vertical((int)o->side) == c.along_x || sph2d__opening_has_velocity(o) == with_velocity)
            continue;
        sph2d__mouth m = sph2d__opening_mouth(scene, o);
        double from = c.along_x ? m.start.x : m.start.y;
        if (side == SPH2D_SIDE_NAME_LEFT || side == SPH2D_SIDE_NAME_BOTTOM)
            c.last = fmin(c.last, from);
        else
            c.first = fmax(c.first, from + m.width);
    }
    return c;
}

/** The width that is free in its narrowest section [m]. */
static double narrowest(const channel *c)
{
    double least = 1;
    for (size_t i = SPH2D__WALL_OBSTACLE; i < c->world->first_body; ++i)
        least = fmin(least, least_beside(c, &c->world->walls[i].shape));
    return least * c->width;
}

/** The side of all openings through which liquid flows as it will; `none` when there are several, or none. */
static sph2d_side_name side_of_outlets(const sph2d_scene *scene, sph2d_side_name none)
{
    sph2d_side_name side = none;
    for (size_t i = 0; i < scene->opening_count; ++i) {
        const sph2d_opening *o = &scene->openings[i];
        if (sph2d__opening_has_velocity(o) || o->side == side)
            continue;
        if (side != none)
            return none;
        side = o->side;
    }
    return side;
}

double sph2d__throat_speed(const sph2d__world *world)
{
    const sph2d_scene *scene = &world->scene;
    inflow x = larger(largest_flow(scene, SPH2D_SIDE_NAME_LEFT), largest_flow(scene, SPH2D_SIDE_NAME_RIGHT));
    inflow y = larger(largest_flow(scene, SPH2D_SIDE_NAME_BOTTOM), largest_flow(scene, SPH2D_SIDE_NAME_TOP));
    if (has_surface(scene) || (x.flow > 0) == (y.flow > 0))
        return 0;
    inflow in = x.flow > 0 ? x : y;
    channel c = channel_from(world, in.side, true);
    double width = fmin(narrowest(&c), free_width(scene));
    sph2d_side_name out = side_of_outlets(scene, in.side);
    if (sph2d__side_is_vertical((int)out) != c.along_x) {
        channel away = channel_from(world, out, false);
        width = fmin(width, narrowest(&away));
    }
    double m = fmin(width / in.width, 1), jet = 0.63 + 0.37 * m * m * m;
    return in.flow / (width * (turns(scene, in.side) ? fmin(jet, BEND) : jet));
}

/** The largest rate at which what an opening prescribes falls, in its own unit over seconds. */
static double fall_rate(const sph2d_opening *o)
{
    sph2d__opening_kind kind = sph2d__opening_kind_of(o);
    const sph2d_history *h = sph2d__opening_history(o, kind);
    double rate = 0, last = kind == SPH2D__OPENING_FLOW_RATE ? o->flow_rate : o->velocity;
    for (size_t i = 1; i < h->count; ++i)
        if (h->items[i].x > h->items[i - 1].x)
            rate = fmax(rate, (h->items[i - 1].y - h->items[i].y) / (h->items[i].x - h->items[i - 1].x));
    if (o->ramp > 0 && h->count == 0 && last < 0)
        rate = -last * RAMP_SLOPE / o->ramp;
    return rate;
}

double sph2d__slowing_head(const sph2d_scene *scene)
{
    const sph2d_box *d = &scene->domain;
    double most = 0;
    if (has_surface(scene))
        return 0;
    for (size_t i = 0; i < scene->opening_count; ++i) {
        const sph2d_opening *o = &scene->openings[i];
        if (!sph2d__opening_has_velocity(o))
            continue;
        sph2d__mouth m = sph2d__opening_mouth(scene, o);
        bool rate = sph2d__opening_kind_of(o) == SPH2D__OPENING_FLOW_RATE;
        double length = m.inward.x != 0 ? d->max.x - d->min.x : d->max.y - d->min.y;
        most = fmax(most, length * fall_rate(o) / (rate ? m.width : 1));
    }
    return most;
}
