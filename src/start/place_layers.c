/* SPDX-License-Identifier: MIT */
/** @file place_layers.c
 *  Generalised walls: layers of boundary particles behind a surface, half a spacing, one and a half ... away from it,
 *  as many as a support radius reaches. Each stands for the area of its piece of its layer.
 *
 *  Closed outlines are solids, with layers inside. Lines and polylines are walls with the liquid on one side, layers on
 *  the other, and a back that nothing passes. Sides of the domain have layers outside, on the continued lattice of the
 *  spacing. */
#include <math.h>

#include "kernels/kernel.h"
#include "start/start.h"

/* Boundary particles nearer than this many spacings to an earlier one would count twice. */
static const double CROWDED = 0.6;
/* A layer goes on around a corner up to this many spacings. */
static const double MITRE = 4;

static int layer_count(const sph2d_sim *sim)
{
    return (int)ceil(sim->system.support / sim->scene.spacing - 1e-9);
}

/** Whether there is an earlier boundary particle so near that a new one has no place. */
static bool is_crowded(const sph2d_sim *sim, size_t first, sph2d_vec2 p)
{
    const sph2d__store *w = &sim->system.walls;
    double nearest = CROWDED * sim->scene.spacing;
    for (size_t i = 0; i < first; ++i)
        if (hypot(w->x[i] - p.x, w->y[i] - p.y) < nearest)
            return true;
    return false;
}

/** Where a boundary particle is, on whose behalf, and which way and how far the surface is. */
typedef struct place {
    sph2d_vec2 at;
    double area;
    sph2d_vec2 normal;
    double depth;
    double skin; /**< length of the surface that it stands for, in the layer next to it */
} place;

static sph2d_status add_particle(sph2d_sim *sim, const place *p, sph2d_report *report)
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

/* ---- outlines ---------------------------------------------------------------------------------------------------- */

/** An outline as its pieces. */
typedef struct contour {
    const sph2d_outline *outline;
    double spacing;
    size_t pieces;
    bool closed;
    double side; /**< +1: layers on the left, -1: on the right */
} contour;

static contour contour_of(const sph2d_sim *sim, const sph2d_obstacle *obstacle)
{
    const sph2d_outline *outline = &obstacle->outline;
    bool closed = !sph2d__outline_is_open(outline), left = closed;
    if (outline->kind == SPH2D_OUTLINE_POLYGON)
        left = !sph2d__polygon_is_clockwise(outline->polygon);
    else if (!closed)
        left = obstacle->liquid == SPH2D_LIQUID_RIGHT;
    double dx = sim->scene.spacing;
    return (contour){outline, dx, sph2d__outline_pieces(outline, dx), closed, left ? 1 : -1};
}

static sph2d_vec2 direction_of(sph2d__segment s)
{
    double length = hypot(s.b.x - s.a.x, s.b.y - s.a.y);
    return (sph2d_vec2){(s.b.x - s.a.x) / length, (s.b.y - s.a.y) / length};
}

/** By how much a layer at distance d is shorter at the corner between two directions. */
static double shortened(const contour *c, sph2d_vec2 from, sph2d_vec2 to, double d)
{
    double angle = atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
    return fmax(c->side * d * tan(angle / 2), -MITRE * c->spacing);
}

/** Piece `index` of the layer at distance d, or an empty one. */
static sph2d__segment layer_piece(const contour *c, size_t index, double d)
{
    sph2d__segment piece = sph2d__outline_piece(c->outline, c->spacing, index);
    sph2d_vec2 u = direction_of(piece);
    double start = 0, end = 0;
    if (index > 0 || c->closed) {
        size_t before = (index + c->pieces - 1) % c->pieces;
        start = shortened(c, direction_of(sph2d__outline_piece(c->outline, c->spacing, before)), u, d);
    }
    if (index + 1 < c->pieces || c->closed) {
        size_t after = (index + 1) % c->pieces;
        end = shortened(c, u, direction_of(sph2d__outline_piece(c->outline, c->spacing, after)), d);
    }
    double nx = -u.y * c->side * d, ny = u.x * c->side * d;
    sph2d__segment layer = {{piece.a.x + start * u.x + nx, piece.a.y + start * u.y + ny},
                            {piece.b.x - end * u.x + nx, piece.b.y - end * u.y + ny}};
    double along = (layer.b.x - layer.a.x) * u.x + (layer.b.y - layer.a.y) * u.y;
    if (along < 0)
        layer.b = layer.a;
    return layer;
}

/** Whether a piece of a solid is on the other side of it, as of a plate. */
static bool is_opposite(const contour *c, size_t index, size_t other)
{
    size_t apart = index > other ? index - other : other - index;
    if (!c->closed || c->outline->kind == SPH2D_OUTLINE_CIRCLE || apart < 2 || apart + 1 == c->pieces)
        return false;
    sph2d_vec2 u = direction_of(sph2d__outline_piece(c->outline, c->spacing, index));
    sph2d_vec2 v = direction_of(sph2d__outline_piece(c->outline, c->spacing, other));
    return u.x * v.x + u.y * v.y < 0;
}

/** Whether a place at distance d from its own piece is nearer to another one. A circle's layers never are. */
static bool belongs_elsewhere(const contour *c, size_t index, sph2d_vec2 p, double d)
{
    if (c->outline->kind == SPH2D_OUTLINE_CIRCLE)
        return d >= c->outline->circle.radius;
    for (size_t k = 0; k < c->pieces; ++k) {
        sph2d__segment piece = sph2d__outline_piece(c->outline, c->spacing, k);
        if (sph2d__segment_distance(&piece, p) < 0.999 * d && !is_opposite(c, index, k))
            return true;
    }
    return c->outline->kind == SPH2D_OUTLINE_POLYGON && !sph2d__outline_encloses(c->outline, p);
}

/** How much of a layer's thickness, d - 1/2 to d + 1/2 spacings deep, is on this side of the middle of a solid: 1 but
 *  in thin ones, whose layers meet there. */
static double share_of(const contour *c, size_t index, sph2d_vec2 p, double d)
{
    double other = INFINITY;
    for (size_t k = 0; k < c->pieces; ++k) {
        sph2d__segment piece = sph2d__outline_piece(c->outline, c->spacing, k);
        double distance = c->closed ? sph2d__segment_distance(&piece, p) : INFINITY;
        if (c->side * sph2d__segment_side(&piece, p) < 0) /* beyond it */
            distance = -distance;
        if (distance < fmin(other, d + c->spacing) && is_opposite(c, index, k))
            other = distance;
    }
    return fmin(fmax(((other - d) / c->spacing + 1) / 2, 0), 1);
}

/** A boundary particle of a layer whose place is p; false where it has none. */
static bool fit_particle(const contour *c, size_t index, sph2d_vec2 p, double d, place *here)
{
    if (belongs_elsewhere(c, index, p, d))
        return false;
    double share = share_of(c, index, p, d), out = (1 - share) / 2 * c->spacing; /* to the middle of what is left */
    sph2d_vec2 u = direction_of(sph2d__outline_piece(c->outline, c->spacing, index));
    here->normal = (sph2d_vec2){u.y * c->side, -u.x * c->side};
    here->at = (sph2d_vec2){p.x + out * here->normal.x, p.y + out * here->normal.y};
    here->area *= share;
    here->depth = d - out;
    return share > 0.01;
}

/** Length of the surface in front of particle k of `count` of the layer next to a piece; the first and the last have
 *  what is beyond them, so that all together have the whole piece. */
static double skin_of(const contour *c, size_t index, sph2d__segment layer, double k, double count)
{
    sph2d__segment piece = sph2d__outline_piece(c->outline, c->spacing, index);
    sph2d_vec2 u = direction_of(piece);
    double whole = hypot(piece.b.x - piece.a.x, piece.b.y - piece.a.y);
    double start = (layer.a.x - piece.a.x) * u.x + (layer.a.y - piece.a.y) * u.y;
    double step = hypot(layer.b.x - layer.a.x, layer.b.y - layer.a.y) / count;
    double from = k == 0 ? 0 : fmin(fmax(start + k * step, 0), whole);
    double to = k == count - 1 ? whole : fmin(fmax(start + (k + 1) * step, 0), whole);
    return to - from;
}

static sph2d_status place_layer(sph2d_sim *sim, const contour *c, double d, size_t first, sph2d_report *report)
{
    for (size_t index = 0; index < c->pieces; ++index) {
        sph2d__segment layer = layer_piece(c, index, d);
        double length = hypot(layer.b.x - layer.a.x, layer.b.y - layer.a.y);
        if (length < 0.01 * c->spacing)
            continue;
        double count = fmax(floor(length / c->spacing + 0.5), 1);
        if (sph2d__sim_too_many(sim, (double)sim->system.walls.count + count, "obstacles", report))
            return SPH2D_SCENE;
        for (double k = 0; k < count; ++k) {
            double t = (k + 0.5) / count;
            sph2d_vec2 p = {layer.a.x + t * (layer.b.x - layer.a.x), layer.a.y + t * (layer.b.y - layer.a.y)};
            place here = {.area = length / count * c->spacing};
            if (d < c->spacing)
                here.skin = skin_of(c, index, layer, k, count);
            if (!fit_particle(c, index, p, d, &here) || is_crowded(sim, first, here.at))
                continue;
            sph2d_status status = add_particle(sim, &here, report);
            if (status != SPH2D_OK)
                return status;
        }
    }
    return SPH2D_OK;
}

/** Adds the back of the layers behind an open line to its barrier, with the two ends: what comes round the line from
 *  behind must not get between the layers. Where the line turns so sharply that they lie in front of another piece
 *  there is no back. */
static bool add_back(sph2d_sim *sim, const contour *c, sph2d__barrier *barrier)
{
    double thickness = layer_count(sim) * c->spacing;
    for (size_t k = 0; k < c->pieces; ++k) {
        sph2d__segment front = sph2d__outline_piece(c->outline, c->spacing, k), back = layer_piece(c, k, thickness);
        sph2d_vec2 middle = {(back.a.x + back.b.x) / 2, (back.a.y + back.b.y) / 2};
        if (hypot(back.b.x - back.a.x, back.b.y - back.a.y) < 0.01 * c->spacing ||
            belongs_elsewhere(c, k, back.a, thickness) || belongs_elsewhere(c, k, back.b, thickness) ||
            belongs_elsewhere(c, k, middle, thickness))
            continue;
        if (!sph2d__barrier_add(barrier, back, &sim->memory) ||
            (k == 0 && !sph2d__barrier_add(barrier, (sph2d__segment){front.a, back.a}, &sim->memory)) ||
            (k + 1 == c->pieces && !sph2d__barrier_add(barrier, (sph2d__segment){front.b, back.b}, &sim->memory)))
            return false;
    }
    return true;
}

sph2d_status sph2d__sim_place_layers(sph2d_sim *sim, const sph2d_obstacle *obstacle, sph2d__barrier *barrier,
                                     sph2d_report *report)
{
    contour c = contour_of(sim, obstacle);
    size_t first = sim->system.walls.count;
    if (!c.closed && !add_back(sim, &c, barrier))
        return SPH2D_NOMEM;
    sph2d_status status = SPH2D_OK;
    for (int k = 0; status == SPH2D_OK && k < layer_count(sim); ++k)
        status = place_layer(sim, &c, (k + 0.5) * c.spacing, first, report);
    return status;
}

/* ---- sides of the domain ----------------------------------------------------------------------------------------- */

/** One direction of the domain's lattice: cells 0 to count - 1 inside, low to high with walls and open room. */
typedef struct extent {
    double origin, size;
    long count, low, high;
    bool wall_low, wall_high;
} extent;

static extent extent_of(double min, double max, double spacing, sph2d_side low, sph2d_side high, int layers)
{
    extent e = {.origin = min, .count = (long)fmax(floor((max - min) / spacing + 0.5), 1)};
    e.size = (max - min) / (double)e.count;
    e.wall_low = low == SPH2D_SIDE_WALL;
    e.wall_high = high == SPH2D_SIDE_WALL;
    e.low = e.wall_low ? -layers : low == SPH2D_SIDE_OPEN ? -e.count : 0;
    e.high = e.count + (e.wall_high ? layers : high == SPH2D_SIDE_OPEN ? e.count : 0);
    return e;
}

/** Whether a cell lies beyond a wall of this direction. */
static bool is_behind(const extent *e, long k)
{
    return (k < 0 && e->wall_low) || (k >= e->count && e->wall_high);
}

/** The next column at or after `i` of a row that may hold a boundary particle: rows that no wall covers have them only
 *  beyond the two ends. */
static long next_column(const extent *x, bool row_behind, long i)
{
    return !row_behind && i >= 0 && i < x->count ? x->count : i;
}

/** Normal and depth of a boundary particle of a side; in a corner there is no one surface. */
static void look_at_surface(place *p, const extent *x, long i, const extent *y, long j)
{
    bool beside_x = is_behind(x, i), beside_y = is_behind(y, j);
    if (beside_x && !beside_y) {
        p->normal.x = i < 0 ? 1 : -1;
        p->depth = (i < 0 ? -(double)i - 0.5 : (double)(i - x->count) + 0.5) * x->size;
        p->skin = p->depth < x->size ? y->size : 0;
    }
    if (beside_y && !beside_x) {
        p->normal.y = j < 0 ? 1 : -1;
        p->depth = (j < 0 ? -(double)j - 0.5 : (double)(j - y->count) + 0.5) * y->size;
        p->skin = p->depth < y->size ? x->size : 0;
    }
}

/** f(q) of the kernel summed over the lattice that fills the room, corners included, around a place; each value counts
 *  as a cell's area over H^2. */
static double room_around(const sph2d_sim *sim, const extent *x, const extent *y, sph2d_vec2 p)
{
    double h = sim->system.support, sum = 0;
    long i1 = (long)floor((p.x + h - x->origin) / x->size), j1 = (long)floor((p.y + h - y->origin) / y->size);
    for (long j = (long)floor((p.y - h - y->origin) / y->size); j <= j1; ++j)
        for (long i = (long)floor((p.x - h - x->origin) / x->size); i <= i1; ++i) {
            double dx = x->origin + ((double)i + 0.5) * x->size - p.x;
            double dy = y->origin + ((double)j + 0.5) * y->size - p.y;
            if (!is_behind(x, i) && !is_behind(y, j))
                sum += sph2d__kernel_value_at(sim->system.method.kernel, hypot(dx, dy) / h);
        }
    return sum * x->size * y->size / (h * h);
}

/** Gives the last boundary particle the speed of its side; in corners the walls rest. */
static void set_speed(sph2d_sim *sim, const extent *x, long i, const extent *y, long j)
{
    const sph2d_side_speeds *speeds = &sim->scene.wall_speeds;
    sph2d__store *w = &sim->system.walls;
    bool beside_x = is_behind(x, i), beside_y = is_behind(y, j);
    if (beside_x && !beside_y)
        w->vy[w->count - 1] = i < 0 ? speeds->left : speeds->right;
    if (beside_y && !beside_x)
        w->vx[w->count - 1] = j < 0 ? speeds->bottom : speeds->top;
}

sph2d_status sph2d__sim_place_rings(sph2d_sim *sim, sph2d_report *report)
{
    sph2d_box d = sim->scene.domain;
    sph2d_boundary b = sim->scene.boundary;
    double dx = sim->scene.spacing;
    if (b.left != SPH2D_SIDE_WALL && b.right != SPH2D_SIDE_WALL && b.bottom != SPH2D_SIDE_WALL &&
        b.top != SPH2D_SIDE_WALL)
        return SPH2D_OK;
    int layers = layer_count(sim);
    size_t first = sim->system.walls.count;
    double longest = fmax(d.max.x - d.min.x, d.max.y - d.min.y) / dx;
    if (sph2d__sim_too_many(sim, longest * layers, "spacing", report))
        return SPH2D_SCENE;
    extent x = extent_of(d.min.x, d.max.x, dx, b.left, b.right, layers);
    extent y = extent_of(d.min.y, d.max.y, dx, b.bottom, b.top, layers);
    for (long j = y.low; j < y.high; ++j)
        for (long i = next_column(&x, is_behind(&y, j), x.low); i < x.high;
             i = next_column(&x, is_behind(&y, j), i + 1)) {
            if (!is_behind(&x, i) && !is_behind(&y, j))
                continue;
            sph2d_vec2 p = {x.origin + ((double)i + 0.5) * x.size, y.origin + ((double)j + 0.5) * y.size};
            if (is_crowded(sim, first, p))
                continue;
            place here = {p, x.size * y.size, {0, 0}, INFINITY, 0};
            look_at_surface(&here, &x, i, &y, j);
            sph2d_status status = add_particle(sim, &here, report);
            if (status != SPH2D_OK)
                return status;
            set_speed(sim, &x, i, &y, j);
            if (sim->system.walls.filled)
                sim->system.walls.filled[sim->system.walls.count - 1] = room_around(sim, &x, &y, p);
        }
    return SPH2D_OK;
}
