/* SPDX-License-Identifier: MIT */
/** @file place_layers.c
 *  Generalised walls: layers of boundary particles 1/2, 3/2, ... spacings behind the surface, over a support radius.
 *  Each particle represents the area of its part of the layer.
 *
 *  Closed outlines are solids, with layers inside. Lines and polylines are walls with liquid on one side, layers on the
 *  other, and an impermeable back. */
#include <math.h>

#include "scene/liquid.h"
#include "scene/shape.h"
#include "start/layers.h"
#include "start/start.h"

/* Mitre limit: a layer extends around a corner by at most this many spacings. */
static const double MITRE = 4;
/* Corners are sharp below 87 degrees, the cosine of which this is: mitred layers fill right angles, turned ones too. */
static const double SHARP = 0.05;
/* Places along a boundary particle at which its share of a thin solid is taken. */
enum { SAMPLES = 4 };

/** An outline as its pieces. */
typedef struct contour {
    const sph2d_shape *outline;
    double spacing;
    size_t pieces;
    bool closed, hollow; /**< hollow: closed, with the layers around it */
    double side;         /**< +1: layers on the left, -1: on the right */
} contour;

static contour contour_of(const sph2d_sim *sim, const sph2d__wall *wall)
{
    const sph2d_shape *outline = &wall->shape;
    bool closed = !sph2d__shape_is_open(outline), left = closed;
    if (outline->kind == SPH2D_SHAPE_POLYGON)
        left = !sph2d__polygon_is_clockwise(outline->points);
    else if (!closed)
        left = wall->liquid == SPH2D_LIQUID_RIGHT;
    double dx = sim->world.scene.spacing;
    bool hollow = sph2d__wall_is_hollow(wall);
    return (contour){outline, dx, sph2d__shape_pieces(outline, dx), closed, hollow, left != hollow ? 1 : -1};
}

static sph2d_vec2 direction_of(sph2d__segment s)
{
    double length = hypot(s.b.x - s.a.x, s.b.y - s.a.y);
    return (sph2d_vec2){(s.b.x - s.a.x) / length, (s.b.y - s.a.y) / length};
}

/** Whether the layers lie in the acute angle between two consecutive directions. There the two sides share the
 *  thickness as those of a plate do, up to the tip. */
static bool is_sharp(const contour *c, sph2d_vec2 from, sph2d_vec2 to)
{
    return c->side * (from.x * to.y - from.y * to.x) > 0 && from.x * to.x + from.y * to.y < -SHARP;
}

/** The length by which a layer at distance d and this thick is cut at the corner between two directions; negative:
 *  extended. At a sharp corner the layer goes on as far as its outer side. */
static double corner_cut(const contour *c, sph2d_vec2 from, sph2d_vec2 to, double d, double thickness)
{
    double angle = atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
    double from_surface = is_sharp(c, from, to) ? d - thickness / 2 : d;
    return fmax(c->side * from_surface * tan(angle / 2), -MITRE * c->spacing);
}

/** Piece `index` of the layer at distance d and this thick, or an empty one. */
static sph2d__segment layer_piece(const contour *c, size_t index, double d, double thickness)
{
    sph2d__segment piece = sph2d__shape_piece(c->outline, c->spacing, index);
    sph2d_vec2 u = direction_of(piece);
    double start = 0, end = 0;
    if (index > 0 || c->closed) {
        size_t before = (index + c->pieces - 1) % c->pieces;
        start = corner_cut(c, direction_of(sph2d__shape_piece(c->outline, c->spacing, before)), u, d, thickness);
    }
    if (index + 1 < c->pieces || c->closed) {
        size_t after = (index + 1) % c->pieces;
        end = corner_cut(c, u, direction_of(sph2d__shape_piece(c->outline, c->spacing, after)), d, thickness);
    }
    double nx = -u.y * c->side * d, ny = u.x * c->side * d;
    sph2d__segment layer = {{piece.a.x + start * u.x + nx, piece.a.y + start * u.y + ny},
                            {piece.b.x - end * u.x + nx, piece.b.y - end * u.y + ny}};
    double along = (layer.b.x - layer.a.x) * u.x + (layer.b.y - layer.a.y) * u.y;
    if (along < 0)
        layer.b = layer.a;
    return layer;
}

sph2d__segment sph2d__inset_piece(const sph2d_sim *sim, const sph2d__wall *wall, size_t index, double distance)
{
    const contour c = contour_of(sim, wall);
    return layer_piece(&c, index, distance, 0);
}

/** Whether another piece is on the opposite side of a solid, as in a plate or at a sharp corner. */
static bool is_opposite(const contour *c, size_t index, size_t other)
{
    if (index == other || c->outline->kind == SPH2D_SHAPE_CIRCLE)
        return false;
    sph2d_vec2 u = direction_of(sph2d__shape_piece(c->outline, c->spacing, index));
    sph2d_vec2 v = direction_of(sph2d__shape_piece(c->outline, c->spacing, other));
    if (other == index + 1 || (c->closed && index == c->pieces - 1 && other == 0))
        return is_sharp(c, u, v);
    if (index == other + 1 || (c->closed && other == c->pieces - 1 && index == 0))
        return is_sharp(c, v, u);
    return c->closed && u.x * v.x + u.y * v.y < 0;
}

/** Whether a position at distance d from its own piece is nearer to another one. A circle's layers never are. */
static bool is_nearer_to_another(const contour *c, size_t index, sph2d_vec2 p, double d)
{
    if (c->outline->kind == SPH2D_SHAPE_CIRCLE)
        return !c->hollow && d >= c->outline->circle.radius;
    if (c->outline->kind == SPH2D_SHAPE_ARC) {
        double side, bulge = sph2d__arc_bulge(&c->outline->arc, c->spacing);
        return sph2d__arc_distance(&c->outline->arc, p, &side) < 0.999 * d - bulge;
    }
    for (size_t k = 0; k < c->pieces; ++k) {
        sph2d__segment piece = sph2d__shape_piece(c->outline, c->spacing, k);
        if (sph2d__segment_distance(&piece, p) < 0.999 * d && !is_opposite(c, index, k))
            return true;
    }
    return false;
}

/** The part of a layer's thickness, d - 1/2 to d + 1/2 spacings deep, on this side of the midline of a solid: 1 except
 *  in thin solids and sharp corners, whose layers meet there. Inwards the distance from a side at an angle a to this
 *  one falls by cos a times as much as the depth grows. */
static double thickness_share(const contour *c, size_t index, sph2d_vec2 p, double d)
{
    double share = 1;
    sph2d_vec2 u = direction_of(sph2d__shape_piece(c->outline, c->spacing, index));
    /* no piece is opposite, and there may be many */
    if (c->outline->kind == SPH2D_SHAPE_CIRCLE || c->outline->kind == SPH2D_SHAPE_ARC || c->hollow)
        return 1;
    for (size_t k = 0; k < c->pieces; ++k) {
        sph2d__segment piece = sph2d__shape_piece(c->outline, c->spacing, k);
        double distance = sph2d__segment_distance(&piece, p);
        if (distance >= d + c->spacing || !is_opposite(c, index, k)) /* far: as the other arm of a trough */
            continue;
        if (c->side * sph2d__segment_side(&piece, p) < 0) /* p is beyond that piece */
            distance = -distance;
        sph2d_vec2 v = direction_of(piece);
        double cosine = -(u.x * v.x + u.y * v.y);
        share = fmin(share, (distance - d) / c->spacing / (1 + cosine) + 0.5);
    }
    return fmax(share, 0);
}

/** The mean of that over a length of the layer around p. */
static double mean_share(const contour *c, size_t index, sph2d_vec2 p, double d, double length)
{
    double share = thickness_share(c, index, p, d), sum = 0;
    sph2d_vec2 u = direction_of(sph2d__shape_piece(c->outline, c->spacing, index));
    if (share >= 1)
        return 1;
    for (int k = 0; k < SAMPLES; ++k) {
        double along = ((k + 0.5) / SAMPLES - 0.5) * length;
        sum += thickness_share(c, index, (sph2d_vec2){p.x + along * u.x, p.y + along * u.y}, d);
    }
    return sum / SAMPLES;
}

/** Sets the boundary particle of a layer at p that is this long; false if there is none. */
static bool set_particle(const contour *c, size_t index, sph2d_vec2 p, double d, double length,
                         sph2d__boundary_particle *particle)
{
    if (is_nearer_to_another(c, index, p, d))
        return false;
    double share = mean_share(c, index, p, d, length), out = (1 - share) / 2 * c->spacing; /* to the middle of that */
    sph2d_vec2 u = direction_of(sph2d__shape_piece(c->outline, c->spacing, index));
    particle->normal = (sph2d_vec2){u.y * c->side, -u.x * c->side};
    particle->at = (sph2d_vec2){p.x + out * particle->normal.x, p.y + out * particle->normal.y};
    particle->area *= share;
    particle->depth = d - out;
    if (c->outline->kind == SPH2D_SHAPE_POLYGON && sph2d__shape_contains(c->outline, particle->at) == c->hollow)
        return false;
    return share > 0.01;
}

/** Length of surface in front of particle k of `count` in the first layer of a piece. The first and last particle also
 *  get the ends, so that the sum is the length of the piece. */
static double surface_length(const contour *c, size_t index, sph2d__segment layer, double k, double count)
{
    sph2d__segment piece = sph2d__shape_piece(c->outline, c->spacing, index);
    sph2d_vec2 u = direction_of(piece);
    double length = hypot(piece.b.x - piece.a.x, piece.b.y - piece.a.y);
    double start = (layer.a.x - piece.a.x) * u.x + (layer.a.y - piece.a.y) * u.y;
    double step = hypot(layer.b.x - layer.a.x, layer.b.y - layer.a.y) / count;
    double from = k == 0 ? 0 : fmin(fmax(start + k * step, 0), length);
    double to = k == count - 1 ? length : fmin(fmax(start + (k + 1) * step, 0), length);
    return to - from;
}

static sph2d_status place_layer(sph2d_sim *sim, const contour *c, double d, const sph2d__near *earlier,
                                sph2d_report *report)
{
    for (size_t index = 0; index < c->pieces; ++index) {
        sph2d__segment layer = layer_piece(c, index, d, c->spacing);
        double length = hypot(layer.b.x - layer.a.x, layer.b.y - layer.a.y);
        if (length < 0.01 * c->spacing)
            continue;
        double count = fmax(floor(length / c->spacing + 0.5), 1);
        if (sph2d__sim_too_many(sim, (double)sim->system.walls.count + count, "obstacles", report))
            return SPH2D_SCENE;
        for (double k = 0; k < count; ++k) {
            double t = (k + 0.5) / count;
            sph2d_vec2 p = {layer.a.x + t * (layer.b.x - layer.a.x), layer.a.y + t * (layer.b.y - layer.a.y)};
            sph2d__boundary_particle particle = {.area = length / count * c->spacing};
            if (d < c->spacing)
                particle.skin = surface_length(c, index, layer, k, count);
            if (!set_particle(c, index, p, d, length / count, &particle) || sph2d__near_any(earlier, particle.at))
                continue;
            sph2d_status status = sph2d__layers_add(sim, &particle, report);
            if (status != SPH2D_OK)
                return status;
        }
    }
    return SPH2D_OK;
}

/** Adds the back of the layers of a line or of a hollow outline, and the two ends of a line, to its barrier, so that liquid from behind cannot enter the
 *  layers. Where a sharp corner puts the back in front of another piece it is left out. */
static bool add_back(sph2d_sim *sim, const contour *c, sph2d__barrier *barrier)
{
    double thickness = sph2d__layer_count(sim) * c->spacing;
    for (size_t k = 0; k < c->pieces; ++k) {
        sph2d__segment front = sph2d__shape_piece(c->outline, c->spacing, k), back = layer_piece(c, k, thickness, 0);
        sph2d_vec2 middle = {(back.a.x + back.b.x) / 2, (back.a.y + back.b.y) / 2};
        if (hypot(back.b.x - back.a.x, back.b.y - back.a.y) < 0.01 * c->spacing ||
            is_nearer_to_another(c, k, back.a, thickness) || is_nearer_to_another(c, k, back.b, thickness) ||
            is_nearer_to_another(c, k, middle, thickness))
            continue;
        if (!sph2d__barrier_add(barrier, back, &sim->memory) ||
            (k == 0 && !c->closed && !sph2d__barrier_add(barrier, (sph2d__segment){front.a, back.a}, &sim->memory)) ||
            (k + 1 == c->pieces && !c->closed &&
             !sph2d__barrier_add(barrier, (sph2d__segment){front.b, back.b}, &sim->memory)))
            return false;
    }
    return true;
}

sph2d_status sph2d__sim_place_layers(sph2d_sim *sim, const sph2d__wall *wall, sph2d__barrier *barrier,
                                     sph2d_report *report)
{
    contour c = contour_of(sim, wall);
    sph2d__near earlier = {0}; /* none for a body: it starts clear of the others, or where a wall was built meanwhile */
    if (((!c.closed || c.hollow) && !add_back(sim, &c, barrier)) ||
        (!wall->body && !sph2d__layers_find_earlier(sim, &earlier)))
        return SPH2D_NOMEM;
    sph2d_status status = SPH2D_OK;
    for (int k = 0; status == SPH2D_OK && k < sph2d__layer_count(sim); ++k)
        status = place_layer(sim, &c, (k + 0.5) * c.spacing, &earlier, report);
    sph2d__near_free(&earlier, &sim->memory);
    return status;
}
