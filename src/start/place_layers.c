/* SPDX-License-Identifier: MIT */
/** @file place_layers.c
 *  Generalised walls: layers of boundary particles 1/2, 3/2, ... spacings behind the surface, over a support radius.
 *  Each particle represents the area of its part of the layer.
 *
 *  Closed outlines are solids, with layers inside. Lines and polylines are walls with liquid on one side, layers on the
 *  other, and an impermeable back. Sides of the domain have layers outside, on the continued lattice. */
#include <math.h>

#include "kernels/kernel.h"
#include "scene/liquid_side.h"
#include "start/near.h"
#include "start/start.h"

/* Boundary particles nearer than this many spacings to an earlier one are left out: their area would count twice. */
static const double MIN_DISTANCE = 0.6;
/* Mitre limit: a layer extends around a corner by at most this many spacings. */
static const double MITRE = 4;

static int layer_count(const sph2d_sim *sim)
{
    return (int)ceil(sim->system.support / sim->scene.spacing - 1e-9);
}

/** The boundary particles placed so far, for their distance from new ones. */
static bool find_earlier(sph2d_sim *sim, sph2d__near *earlier)
{
    const sph2d__store *w = &sim->system.walls;
    return sph2d__near_build(earlier, w->x, w->y, w->count, MIN_DISTANCE * sim->scene.spacing, &sim->memory);
}

/** A boundary particle: position, area, and unit normal to and depth below the surface. */
typedef struct boundary_particle {
    sph2d_vec2 at;
    double area;
    sph2d_vec2 normal;
    double depth;
    double skin; /**< length of surface that it represents, in the first layer */
} boundary_particle;

static sph2d_status add_particle(sph2d_sim *sim, const boundary_particle *p, sph2d_report *report)
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
    bool closed, hollow; /**< hollow: closed, with the layers around it */
    double side;         /**< +1: layers on the left, -1: on the right */
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
    bool hollow = sph2d__obstacle_is_hollow(obstacle);
    return (contour){outline, dx, sph2d__outline_pieces(outline, dx), closed, hollow, left != hollow ? 1 : -1};
}

static sph2d_vec2 direction_of(sph2d__segment s)
{
    double length = hypot(s.b.x - s.a.x, s.b.y - s.a.y);
    return (sph2d_vec2){(s.b.x - s.a.x) / length, (s.b.y - s.a.y) / length};
}

/** The length by which a layer at distance d is cut at the corner between two directions; negative: extended. */
static double corner_cut(const contour *c, sph2d_vec2 from, sph2d_vec2 to, double d)
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
        start = corner_cut(c, direction_of(sph2d__outline_piece(c->outline, c->spacing, before)), u, d);
    }
    if (index + 1 < c->pieces || c->closed) {
        size_t after = (index + 1) % c->pieces;
        end = corner_cut(c, u, direction_of(sph2d__outline_piece(c->outline, c->spacing, after)), d);
    }
    double nx = -u.y * c->side * d, ny = u.x * c->side * d;
    sph2d__segment layer = {{piece.a.x + start * u.x + nx, piece.a.y + start * u.y + ny},
                            {piece.b.x - end * u.x + nx, piece.b.y - end * u.y + ny}};
    double along = (layer.b.x - layer.a.x) * u.x + (layer.b.y - layer.a.y) * u.y;
    if (along < 0)
        layer.b = layer.a;
    return layer;
}

sph2d__segment sph2d__inset_piece(const sph2d_sim *sim, const sph2d_obstacle *obstacle, size_t index, double distance)
{
    const contour c = contour_of(sim, obstacle);
    return layer_piece(&c, index, distance);
}

/** Whether another piece of a solid is on the opposite side of it, as in a plate. */
static bool is_opposite(const contour *c, size_t index, size_t other)
{
    size_t apart = index > other ? index - other : other - index;
    if (!c->closed || c->outline->kind == SPH2D_OUTLINE_CIRCLE || apart < 2 || apart + 1 == c->pieces)
        return false;
    sph2d_vec2 u = direction_of(sph2d__outline_piece(c->outline, c->spacing, index));
    sph2d_vec2 v = direction_of(sph2d__outline_piece(c->outline, c->spacing, other));
    return u.x * v.x + u.y * v.y < 0;
}

/** Whether a position at distance d from its own piece is nearer to another one. A circle's layers never are. */
static bool is_nearer_to_another(const contour *c, size_t index, sph2d_vec2 p, double d)
{
    if (c->outline->kind == SPH2D_OUTLINE_CIRCLE)
        return !c->hollow && d >= c->outline->circle.radius;
    if (c->outline->kind == SPH2D_OUTLINE_ARC) {
        double side, bulge = sph2d__arc_bulge(&c->outline->arc, c->spacing);
        return sph2d__arc_distance(&c->outline->arc, p, &side) < 0.999 * d - bulge;
    }
    for (size_t k = 0; k < c->pieces; ++k) {
        sph2d__segment piece = sph2d__outline_piece(c->outline, c->spacing, k);
        if (sph2d__segment_distance(&piece, p) < 0.999 * d && !is_opposite(c, index, k))
            return true;
    }
    return c->outline->kind == SPH2D_OUTLINE_POLYGON && sph2d__outline_encloses(c->outline, p) == c->hollow;
}

/** The part of a layer's thickness, d - 1/2 to d + 1/2 spacings deep, on this side of the midline of a solid: 1 except
 *  in thin solids, whose layers meet there. */
static double thickness_share(const contour *c, size_t index, sph2d_vec2 p, double d)
{
    double other = INFINITY;
    /* no piece is opposite, and there may be many */
    if (c->outline->kind == SPH2D_OUTLINE_CIRCLE || c->outline->kind == SPH2D_OUTLINE_ARC || c->hollow)
        return 1;
    for (size_t k = 0; k < c->pieces; ++k) {
        sph2d__segment piece = sph2d__outline_piece(c->outline, c->spacing, k);
        double distance = c->closed ? sph2d__segment_distance(&piece, p) : INFINITY;
        if (distance >= d + c->spacing) /* far: of another wall, as the other arm of a trough */
            continue;
        if (c->side * sph2d__segment_side(&piece, p) < 0) /* p is beyond that piece */
            distance = -distance;
        if (distance < other && is_opposite(c, index, k))
            other = distance;
    }
    return fmin(fmax(((other - d) / c->spacing + 1) / 2, 0), 1);
}

/** Sets the boundary particle of a layer at p; false if there is none. */
static bool set_particle(const contour *c, size_t index, sph2d_vec2 p, double d, boundary_particle *particle)
{
    if (is_nearer_to_another(c, index, p, d))
        return false;
    double share = thickness_share(c, index, p, d), out = (1 - share) / 2 * c->spacing; /* to the middle of its share */
    sph2d_vec2 u = direction_of(sph2d__outline_piece(c->outline, c->spacing, index));
    particle->normal = (sph2d_vec2){u.y * c->side, -u.x * c->side};
    particle->at = (sph2d_vec2){p.x + out * particle->normal.x, p.y + out * particle->normal.y};
    particle->area *= share;
    particle->depth = d - out;
    return share > 0.01;
}

/** Length of surface in front of particle k of `count` in the first layer of a piece. The first and last particle also
 *  get the ends, so that the sum is the length of the piece. */
static double surface_length(const contour *c, size_t index, sph2d__segment layer, double k, double count)
{
    sph2d__segment piece = sph2d__outline_piece(c->outline, c->spacing, index);
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
            boundary_particle particle = {.area = length / count * c->spacing};
            if (d < c->spacing)
                particle.skin = surface_length(c, index, layer, k, count);
            if (!set_particle(c, index, p, d, &particle) || sph2d__near_any(earlier, particle.at))
                continue;
            sph2d_status status = add_particle(sim, &particle, report);
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
    double thickness = layer_count(sim) * c->spacing;
    for (size_t k = 0; k < c->pieces; ++k) {
        sph2d__segment front = sph2d__outline_piece(c->outline, c->spacing, k), back = layer_piece(c, k, thickness);
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

sph2d_status sph2d__sim_place_layers(sph2d_sim *sim, const sph2d_obstacle *obstacle, sph2d__barrier *barrier,
                                     sph2d_report *report)
{
    contour c = contour_of(sim, obstacle);
    sph2d__near earlier;
    if (((!c.closed || c.hollow) && !add_back(sim, &c, barrier)) || !find_earlier(sim, &earlier))
        return SPH2D_NOMEM;
    sph2d_status status = SPH2D_OK;
    for (int k = 0; status == SPH2D_OK && k < layer_count(sim); ++k)
        status = place_layer(sim, &c, (k + 0.5) * c.spacing, &earlier, report);
    sph2d__near_free(&earlier, &sim->memory);
    return status;
}

/* ---- sides of the domain ----------------------------------------------------------------------------------------- */

/** One direction of the domain's lattice: cells 0 to count - 1 inside; low to high - 1 with walls and open space. */
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

/** The next column at or after `i` that may have a boundary particle; rows inside the domain have them only
 *  beyond the two ends. */
static long next_column(const extent *x, bool row_behind, long i)
{
    return !row_behind && i >= 0 && i < x->count ? x->count : i;
}

/** Sets normal and depth of a boundary particle of a side; in corners there is no single surface. */
static void set_surface(boundary_particle *p, const extent *x, long i, const extent *y, long j)
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

/** Kernel sum, of f(q) times the area of a cell over H^2, over the lattice of liquid that fills all space in front of
 *  the walls. */
static double filled_sum(const sph2d_sim *sim, const extent *x, const extent *y, sph2d_vec2 p)
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

/** Sets the velocity of the last boundary particle to that of its side; corners are at rest. */
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

/** Adds the boundary particle of cell (i, j) of the lattice that continues the domain's beyond its sides. */
static sph2d_status place_cell(sph2d_sim *sim, const extent *x, long i, const extent *y, long j, sph2d_report *report)
{
    sph2d_vec2 p = {x->origin + ((double)i + 0.5) * x->size, y->origin + ((double)j + 0.5) * y->size};
    boundary_particle particle = {p, x->size * y->size, {0, 0}, INFINITY, 0};
    set_surface(&particle, x, i, y, j);
    sph2d_status status = add_particle(sim, &particle, report);
    if (status != SPH2D_OK)
        return status;
    set_speed(sim, x, i, y, j);
    if (sim->system.walls.filled)
        sim->system.walls.filled[sim->system.walls.count - 1] = filled_sum(sim, x, y, p);
    return SPH2D_OK;
}

/** Fills the cells behind the sides, but for those too near to obstacles. */
static sph2d_status place_cells(sph2d_sim *sim, const extent *x, const extent *y, sph2d_report *report)
{
    sph2d__near earlier;
    sph2d_status status = find_earlier(sim, &earlier) ? SPH2D_OK : SPH2D_NOMEM;
    for (long j = y->low; status == SPH2D_OK && j < y->high; ++j) {
        bool behind = is_behind(y, j);
        for (long i = next_column(x, behind, x->low); status == SPH2D_OK && i < x->high;
             i = next_column(x, behind, i + 1)) {
            sph2d_vec2 p = {x->origin + ((double)i + 0.5) * x->size, y->origin + ((double)j + 0.5) * y->size};
            if ((behind || is_behind(x, i)) && !sph2d__near_any(&earlier, p))
                status = place_cell(sim, x, i, y, j, report);
        }
    }
    sph2d__near_free(&earlier, &sim->memory);
    return status;
}

sph2d_status sph2d__sim_place_side_layers(sph2d_sim *sim, sph2d_report *report)
{
    sph2d_box d = sim->scene.domain;
    sph2d_boundary b = sim->scene.boundary;
    double dx = sim->scene.spacing;
    if (b.left != SPH2D_SIDE_WALL && b.right != SPH2D_SIDE_WALL && b.bottom != SPH2D_SIDE_WALL &&
        b.top != SPH2D_SIDE_WALL)
        return SPH2D_OK;
    int layers = layer_count(sim);
    double longest = fmax(d.max.x - d.min.x, d.max.y - d.min.y) / dx;
    if (sph2d__sim_too_many(sim, longest * layers, "spacing", report))
        return SPH2D_SCENE;
    extent x = extent_of(d.min.x, d.max.x, dx, b.left, b.right, layers);
    extent y = extent_of(d.min.y, d.max.y, dx, b.bottom, b.top, layers);
    return place_cells(sim, &x, &y, report);
}
