/* SPDX-License-Identifier: MIT */
/** @file grid_cut.c
 *  Cuts the squares of the grid of method `hybrid` by solids: open parts of faces, what squares hide, thin walls. */
#include <math.h>
#include <string.h>

#include "methods/hybrid/grid.h"
#include "scene/liquid.h"
#include "scene/pose.h"
#include "scene/shape.h"
#include "sim/bodies.h"

/* ---- solids: how far a point is from one ------------------------------------------------------------------------- */

/* Part of a spacing within which an outline lies along a side. */
static const double ALONG = 1e-6;

/** Solids in a pose, as the grid sees them. */
typedef struct solid_shape {
    const sph2d_scene *scene;
    const sph2d__wall *wall;
    const sph2d__pose *pose;
    sph2d_box extent; /**< a rectangle around it */
    sph2d_box inside; /**< within the sides of the domain that are walls */
    bool reaches;     /**< such a side: of its outline only what is inside counts, as no solid ends along a side */
} solid_shape;

/** A wall as a solid in a pose; both stay the caller's. */
static solid_shape solid_of(const sph2d__world *world, const sph2d__wall *is, const sph2d__pose *pose)
{
    const sph2d_scene *scene = &world->scene;
    const bool layered = sph2d__shape_is_open(&is->shape) || sph2d__wall_is_hollow(is);
    const sph2d_box b = sph2d__shape_bounds(&is->shape), *d = &world->box;
    const sph2d_vec2 ends[4] = {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}};
    const double more = layered ? sph2d__layer_thickness(scene) : 0, in = ALONG * scene->spacing;
    sph2d_vec2 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (int k = 0; k < 4; ++k) {
        const sph2d_vec2 p = sph2d__pose_apply(pose, ends[k]);
        low = (sph2d_vec2){fmin(low.x, p.x - more), fmin(low.y, p.y - more)};
        high = (sph2d_vec2){fmax(high.x, p.x + more), fmax(high.y, p.y + more)};
    }
    const bool over_x = low.x < d->min.x + in && high.x > d->max.x - in,
               over_y = low.y < d->min.y + in && high.y > d->max.y - in;
    bool wall[4]; /* or the seam of a period, on both sides of which the solid goes on */
    for (int side = 0; side < 4; ++side) {
        const sph2d_side kind = sph2d__side_of(scene, side);
        wall[side] = kind == SPH2D_SIDE_WALL || (kind == SPH2D_SIDE_PERIODIC && (side < 2 ? over_x : over_y));
    }
    const sph2d_box inside = {{wall[0] ? d->min.x + in : -INFINITY, wall[2] ? d->min.y + in : -INFINITY},
                              {wall[1] ? d->max.x - in : INFINITY, wall[3] ? d->max.y - in : INFINITY}};
    const bool reaches =
        !layered && (low.x < inside.min.x || high.x > inside.max.x || low.y < inside.min.y || high.y > inside.max.y);
    return (solid_shape){scene, is, pose, {low, high}, inside, reaches};
}

static double coordinate(sph2d_vec2 p, int axis)
{
    return axis == 0 ? p.x : p.y;
}

/** Leaves of a segment what is within a box; false: nothing. */
static bool clip(sph2d__segment *s, const sph2d_box *box)
{
    double from = 0, to = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double a = coordinate(s->a, axis), way = coordinate(s->b, axis) - a;
        const double low = coordinate(box->min, axis) - a, high = coordinate(box->max, axis) - a;
        if (way == 0) {
            if (low > 0 || high < 0)
                return false;
            continue;
        }
        from = fmax(from, fmin(low / way, high / way));
        to = fmin(to, fmax(low / way, high / way));
    }
    if (!(from <= to))
        return false;
    const sph2d__segment whole = *s;
    const double x = whole.b.x - whole.a.x, y = whole.b.y - whole.a.y;
    *s = (sph2d__segment){{whole.a.x + from * x, whole.a.y + from * y}, {whole.a.x + to * x, whole.a.y + to * y}};
    return true;
}

/** Distance of a point from a solid's outline; `drawn`: the point, where the scene draws the solid [m]. */
static double outline_distance(const solid_shape *s, sph2d_vec2 at, sph2d_vec2 drawn)
{
    const sph2d_shape *outline = &s->wall->shape;
    const double spacing = s->scene->spacing;
    if (!s->reaches)
        return sph2d__shape_nearest(outline, spacing, drawn);
    double nearest = INFINITY;
    for (size_t k = 0, n = sph2d__shape_pieces(outline, spacing); k < n; ++k) {
        sph2d__segment piece = sph2d__shape_piece(outline, spacing, k);
        piece.a = sph2d__pose_apply(s->pose, piece.a);
        piece.b = sph2d__pose_apply(s->pose, piece.b);
        if (clip(&piece, &s->inside))
            nearest = fmin(nearest, sph2d__segment_distance(&piece, at));
    }
    return nearest;
}

/** Distance of a point from a solid, negative in it [m]. Of a line or a hollow outline the solid are the layers behind it. */
static double distance_from(const solid_shape *s, sph2d_vec2 point)
{
    const sph2d_scene *scene = s->scene;
    const sph2d__wall *o = s->wall;
    const sph2d_shape *outline = &o->shape;
    const sph2d_vec2 at = {fmin(fmax(point.x, s->inside.min.x), s->inside.max.x),
                           fmin(fmax(point.y, s->inside.min.y), s->inside.max.y)};
    const sph2d_vec2 p = sph2d__pose_invert(s->pose, at);
    const double d = outline_distance(s, at, p), thick = sph2d__layer_thickness(scene);
    if (!sph2d__shape_is_open(outline)) {
        if (sph2d__wall_fills(scene, o, p))
            return -d;
        const bool beyond = sph2d__wall_is_hollow(o) && !sph2d__shape_contains(outline, p);
        return beyond ? d - thick : d;
    }
    /* A line is wet on one side, with layers on the other: the side is that of its nearest piece. */
    double nearest = INFINITY, side = 0;
    for (size_t k = 0, n = sph2d__shape_pieces(outline, scene->spacing); k < n; ++k) {
        const sph2d__segment piece = sph2d__shape_piece(outline, scene->spacing, k);
        const double r = sph2d__segment_distance(&piece, p);
        if (r < nearest) {
            nearest = r;
            side = sph2d__segment_side(&piece, p);
        }
    }
    const bool wet = o->liquid == SPH2D_LIQUID_RIGHT ? side < 0 : side > 0;
    return wet ? d : d < thick ? -d : d - thick;
}

/* ---- the squares ------------------------------------------------------------------------------------------------- */

/** A range of corners. */
typedef struct corners {
    int left, right, bottom, top;
} corners;

/** The corners within a square and a half of a solid. */
static corners corners_near(const sph2d__grid *g, const solid_shape *s)
{
    const double x = 1.5 * (double)g->hx, y = 1.5 * (double)g->hy;
    return (corners){sph2d__grid_clamp((s->extent.min.x - x - g->low_x) * g->inverse_x + 1, g->nx + 1),
                     sph2d__grid_clamp((s->extent.max.x + x - g->low_x) * g->inverse_x + 2, g->nx + 1),
                     sph2d__grid_clamp((s->extent.min.y - y - g->low_y) * g->inverse_y + 1, g->ny + 1),
                     sph2d__grid_clamp((s->extent.max.y + y - g->low_y) * g->inverse_y + 2, g->ny + 1)};
}

/** Sets the distances of the corners near a solid from it, in `own`; lowers those from all, and gives the corners that it is
 *  nearest to its velocity and slip. */
static void add_solid(sph2d__grid *g, const solid_shape *solid, const corners *c, float *own)
{
    const float stick = solid->wall->slip == SPH2D_SLIP_NONE ? 1 : 0;
    for (int j = c->bottom; j <= c->top; ++j)
        for (int i = c->left; i <= c->right; ++i) {
            const sph2d_vec2 at = {g->low_x + (i - 1) * (double)g->hx, g->low_y + (j - 1) * (double)g->hy};
            const size_t k = sph2d__at(g, i, j);
            own[k] = (float)distance_from(solid, at);
            if (!(own[k] < g->distance[k]))
                continue;
            const sph2d_vec2 v = sph2d__pose_velocity(solid->pose, at);
            g->distance[k] = own[k];
            g->stick[k] = stick;
            g->corner_u[k] = (float)v.x;
            g->corner_v[k] = (float)v.y;
        }
}

/** Gives the corners of a side its slip, and those between its ends the speed along it. */
static void add_side(const sph2d_sim *sim, const sph2d__grid *g, int side)
{
    const sph2d_scene *scene = &sim->world.scene;
    const sph2d_side_speeds *s = &scene->wall_speeds;
    const double speeds[4] = {s->left, s->right, s->bottom, s->top};
    const bool vertical = side < 2;
    const int n = vertical ? g->ny : g->nx, at = side % 2 == 0 ? 1 : vertical ? g->nx + 1 : g->ny + 1;
    if (sph2d__side_of(scene, side) != SPH2D_SIDE_WALL)
        return;
    for (int m = 1; m <= n + 1; ++m) {
        const size_t k = vertical ? sph2d__at(g, at, m) : sph2d__at(g, m, at);
        if (g->distance[k] <= 0) /* a solid reaches the side there */
            continue;
        g->stick[k] = sim->world.walls[side].slip == SPH2D_SLIP_NONE ? 1 : 0;
        (vertical ? g->corner_v : g->corner_u)[k] = (float)speeds[side];
    }
}

/** The part inside a solid of the square around a face whose ends are at these distances from it, in squares: of that, not
 *  of the face itself, which a side along it would open and close at once, and the lift of bodies would have steps. */
static float closed_part(float a, float b)
{
    const float part = 0.5F - (a + b) / 2;
    return part > 1 ? 1 : part > 0 ? part : 0;
}

/** Mean distance of a square's corners. */
static float middle(const sph2d__grid *g, const float *distance, size_t k)
{
    const float *d = distance + k;
    return (d[0] + d[1] + d[g->stride] + d[g->stride + 1]) / 4;
}

static bool is_inside_rest(const sph2d__world *world, sph2d_vec2 p)
{
    const sph2d__pose still = {.cosine = 1};
    for (size_t k = SPH2D__WALL_OBSTACLE; k < world->wall_count; ++k) {
        const solid_shape solid = solid_of(world, &world->walls[k], &still);
        if (!sph2d__wall_moves(solid.wall) && distance_from(&solid, p) <= 0)
            return true;
    }
    return false;
}

/** Whether the way between the middles of two squares, both outside a solid, passes it as it is thinner than they are.
 *  `distance` are those from it, or from all at rest (`solid` is NULL). */
static bool passes(const sph2d_sim *sim, const sph2d__grid *g, const solid_shape *solid, const sph2d__barrier *barrier,
                   const float *distance, size_t from, size_t to)
{
    const float near = g->hx + g->hy, one = middle(g, distance, from), other = middle(g, distance, to);
    if (!(one > 0 && other > 0 && one < near && other < near))
        return false;
    const size_t squares[2] = {from, to};
    sph2d_vec2 ends[2], drawn[2];
    for (int n = 0; n < 2; ++n) {
        ends[n] = (sph2d_vec2){g->low_x + ((double)(squares[n] % g->stride) - 0.5) * (double)g->hx,
                               g->low_y + ((double)(squares[n] / g->stride) - 0.5) * (double)g->hy};
        drawn[n] = solid ? sph2d__pose_invert(solid->pose, ends[n]) : ends[n];
    }
    if (!sph2d__barrier_crosses(barrier, drawn[0], drawn[1]))
        return false;
    for (int n = 0; n < 2; ++n)
        if (solid ? distance_from(solid, ends[n]) <= 0 : is_inside_rest(&sim->world, ends[n]))
            return false;
    return true;
}

/* ---- solids at rest ---------------------------------------------------------------------------------------------- */

/** Open parts of faces and hidden parts of squares by all solids at rest, as one: the nearest counts. */
static void cut_by_rest(const sph2d_sim *sim, sph2d__grid *g)
{
    const float full = g->hx * g->hy / (float)(sim->world.scene.spacing * sim->world.scene.spacing),
                unit = 2 / (g->hx + g->hy), side = 1 / 0.875F, *distance = g->distance;
    const size_t up = g->stride;
    const sph2d__barrier *b = &sim->barrier;
    for (int j = 1; j <= g->ny + 1; ++j)
        for (int i = 1; i <= g->nx + 1; ++i) {
            const size_t k = sph2d__at(g, i, j);
            const float *d = distance + k;
            const bool left = i == 1 && !g->wraps_x && !g->open[0],
                       right = i == g->nx + 1 && !g->wraps_x && !g->open[1];
            const bool low = j == 1 && !g->wraps_y && !g->open[2], high = j == g->ny + 1 && !g->wraps_y && !g->open[3];
            const bool square = i <= g->nx && j <= g->ny;
            g->still_x[k] = j > g->ny || left || right ? 0 : 1 - closed_part(unit * d[0], unit * d[up]);
            g->still_y[k] = i > g->nx || low || high ? 0 : 1 - closed_part(unit * d[0], unit * d[1]);
            if (square && i > 1 && g->still_x[k] > 0 && passes(sim, g, NULL, b, distance, k - 1, k))
                g->still_x[k] = 0;
            if (square && j > 1 && g->still_y[k] > 0 && passes(sim, g, NULL, b, distance, k - up, k))
                g->still_y[k] = 0;
            if (!square)
                continue;
            g->room[k] = (i == 1 && !g->wraps_x ? side : 1) * (i == g->nx && !g->wraps_x ? side : 1) *
                         (j == 1 && !g->wraps_y ? side : 1) * (j == g->ny && !g->wraps_y ? side : 1) / full;
            g->still_hidden[k] = sph2d__hidden_part(unit * middle(g, distance, k));
        }
}

static bool leads_out(const sph2d__grid *g, float open, size_t to)
{
    return open > 0 && g->still_hidden[to] < 0.5F;
}

/** Closes squares inside solids at rest that are beside none outside: slits between them into which no particle gets. */
static void close_slits(const sph2d__grid *g)
{
    const size_t up = g->stride;
    for (int j = 1; j <= g->ny; ++j)
        for (size_t k = sph2d__at(g, 1, j), end = sph2d__at(g, g->nx, j); k <= end; ++k) {
            if (g->still_hidden[k] < 0.5F || leads_out(g, g->still_x[k], k - 1) ||
                leads_out(g, g->still_x[k + 1], k + 1) || leads_out(g, g->still_y[k], k - up) ||
                leads_out(g, g->still_y[k + up], k + up))
                continue;
            g->still_x[k] = g->still_x[k + 1] = g->still_y[k] = g->still_y[k + up] = 0;
        }
}

/* ---- solids that move -------------------------------------------------------------------------------------------- */

/** A face closed by a part, between two squares; NULL: memory is short. */
static sph2d__part *add_part(sph2d_sim *sim, sph2d__grid *g, size_t before, size_t after)
{
    if (g->part_count == g->part_capacity) {
        const size_t grown = g->part_capacity > 0 ? 2 * g->part_capacity : 256;
        void *block = g->parts;
        if (!sph2d__resize(sim->system.memory, &block, g->part_capacity, grown, sizeof *g->parts))
            return NULL;
        g->parts = block;
        g->part_capacity = grown;
    }
    g->parts[g->part_count] = (sph2d__part){.before = (uint32_t)before, .after = (uint32_t)after};
    return &g->parts[g->part_count++];
}

/** Closes the face from square `before` to square `after`, with its middle at p, by a part. False: memory is short. */
static bool close_face(sph2d_sim *sim, sph2d__grid *g, const sph2d__moving *m, size_t before, size_t after, bool x,
                       sph2d_vec2 p, float closed)
{
    const sph2d_vec2 v = sph2d__pose_velocity(&m->to, p);
    (x ? g->open_x : g->open_y)[after] -= closed;
    (x ? g->wall_x : g->wall_y)[after] += closed * (float)(x ? v.x : v.y);
    sph2d__part *part = add_part(sim, g, before, after);
    if (!part)
        return false;
    const float area = closed * (x ? g->hy : g->hx);
    const double arm = x ? -(p.y - m->to.center.y - m->to.displacement.y) : p.x - m->to.center.x - m->to.displacement.x;
    part->body = m->rigid ? (uint32_t)(m->rigid - sim->bodies.items) + 1 : 0;
    part->speed = (float)(x ? v.x : v.y);
    part->by[0] = x ? area : 0;
    part->by[1] = x ? 0 : area;
    part->by[2] = (float)(arm * (double)area);
    return true;
}

/** Closes faces and hides squares near a solid that moves. False: memory is short. */
static bool cut_by(sph2d_sim *sim, sph2d__grid *g, const sph2d__moving *m, float *own)
{
    const solid_shape s = solid_of(&sim->world, m->wall, &m->to);
    const corners c = corners_near(g, &s);
    const float unit = 2 / (g->hx + g->hy);
    const size_t up = g->stride;
    add_solid(g, &s, &c, own);
    for (int j = c.bottom > 1 ? c.bottom : 1; j < c.top; ++j)
        for (int i = c.left > 1 ? c.left : 1; i < c.right; ++i) {
            const size_t k = sph2d__at(g, i, j);
            const sph2d_vec2 p = {g->low_x + (i - 1) * (double)g->hx, g->low_y + (j - 1) * (double)g->hy};
            if (k < sph2d__at(g, g->begin[j], j) || k >= sph2d__at(g, g->end[j], j))
                continue;
            g->hidden[k] += sph2d__hidden_part(unit * middle(g, own, k));
            for (int axis = 0; axis < 2; ++axis) {
                const bool x = axis == 0, first = x ? i == 1 : j == 1, wraps = x ? g->wraps_x : g->wraps_y;
                const size_t beside = x ? k - 1 : k - up,
                             other_end = x ? sph2d__at(g, g->nx, j) : sph2d__at(g, i, g->ny);
                float closed = closed_part(unit * own[k], unit * own[x ? k + up : k + 1]);
                if (!first && (x ? i > c.left : j > c.bottom) && closed < 1 &&
                    passes(sim, g, &s, &m->barrier, own, beside, k))
                    closed = 1;
                const sph2d_vec2 at = {p.x + (x ? 0 : (double)g->hx / 2), p.y + (x ? (double)g->hy / 2 : 0)};
                if ((!first || wraps) && closed > 0 &&
                    !close_face(sim, g, m, first ? other_end : beside, k, x, at, closed))
                    return false;
            }
        }
    return true;
}

/** Solids that meet close a face once: parts of a sum above 1 become smaller. */
static void level_parts(sph2d__grid *g)
{
    for (size_t n = 0; n < g->part_count; ++n) {
        sph2d__part *p = &g->parts[n];
        const float open = (p->by[0] > 0 ? g->open_x : g->open_y)[p->after];
        for (int c = 0; c < 3 && open < 0; ++c)
            p->by[c] /= 1 - open;
    }
}

/* A smaller open part of a face is one by rounding. */
static const float LEAST_OPEN = 1e-4F;

static void finish_face(float *open, float *wall)
{
    const float closed = 1 - *open;
    if (closed > 0)
        *wall /= closed;
    if (*open < LEAST_OPEN)
        *open = 0;
}

/** Sets what faces and squares say once all solids are there, and lists the squares that these cut. */
static void finish(sph2d__grid *g, bool all)
{
    g->cut_count = 0;
    for (int j = 1; j <= g->ny + 1; ++j) {
        const int from = all || g->begin[j] < 1 ? 1 : g->begin[j],
                  to = all || g->end[j] > g->nx + 1 ? g->nx + 1 : g->end[j] - 1;
        for (size_t k = sph2d__at(g, from, j), end = sph2d__at(g, to, j); k <= end; ++k) {
            finish_face(&g->open_x[k], &g->wall_x[k]);
            finish_face(&g->open_y[k], &g->wall_y[k]);
            if (g->hidden[k] > 1)
                g->hidden[k] = 1;
            if (g->hidden[k] > 0)
                g->cut[g->cut_count++] = (uint32_t)k;
        }
    }
}

/** The last faces of a periodic direction are the first. */
static void wrap_faces(sph2d__grid *g)
{
    for (int j = 1; j <= g->ny + 1 && g->wraps_x; ++j) {
        g->open_x[sph2d__at(g, g->nx + 1, j)] = g->open_x[sph2d__at(g, 1, j)];
        g->wall_x[sph2d__at(g, g->nx + 1, j)] = g->wall_x[sph2d__at(g, 1, j)];
    }
    for (int i = 1; i <= g->nx + 1 && g->wraps_y; ++i) {
        g->open_y[sph2d__at(g, i, g->ny + 1)] = g->open_y[sph2d__at(g, i, 1)];
        g->wall_y[sph2d__at(g, i, g->ny + 1)] = g->wall_y[sph2d__at(g, i, 1)];
    }
}

/** Begins with what is so at rest. */
static void take_rest(sph2d__grid *g)
{
    const size_t from = sph2d__at(g, 0, g->first),
                 count = sph2d__at(g, 0, g->last < g->ny + 2 ? g->last + 2 : g->ny + 4) - from;
    float *const to[] = {g->distance, g->stick, g->open_x, g->open_y, g->hidden};
    const float *const rest[] = {g->still, g->still_stick, g->still_x, g->still_y, g->still_hidden};
    float *const none[] = {g->corner_u, g->corner_v, g->wall_x, g->wall_y};
    for (size_t n = 0; n < sizeof to / sizeof *to; ++n)
        memcpy(to[n] + from, rest[n] + from, count * sizeof **to);
    for (size_t n = 0; n < sizeof none / sizeof *none; ++n)
        memset(none[n] + from, 0, count * sizeof **none);
    g->part_count = 0;
}

bool sph2d__grid_cut(sph2d_sim *sim, sph2d__grid *g)
{
    if (sim->moving_count == 0)
        return true;
    take_rest(g);
    for (size_t k = 0; k < sim->moving_count; ++k)
        if (!cut_by(sim, g, &sim->moving[k], g->pressure.product))
            return false;
    for (int side = 0; side < 4; ++side)
        add_side(sim, g, side);
    level_parts(g);
    finish(g, false);
    wrap_faces(g);
    for (size_t k = 0; k < sim->moving_count; ++k) {
        const sph2d__rigid *r = sim->moving[k].rigid;
        const double density = sim->system.rest_density;
        if (r)
            memcpy(g->inverse[r - sim->bodies.items],
                   (double[3]){density * r->free.x / r->mass, density * r->free.y / r->mass,
                               density * r->free.turn / r->inertia},
                   sizeof *g->inverse);
    }
    return true;
}

void sph2d__grid_place_solids(sph2d_sim *sim, sph2d__grid *g)
{
    const sph2d__pose still = {.cosine = 1};
    for (size_t k = 0; k < g->size; ++k)
        g->distance[k] = 4 * (g->hx + g->hy);
    for (size_t k = SPH2D__WALL_OBSTACLE; k < sim->world.wall_count; ++k) {
        const solid_shape s = solid_of(&sim->world, &sim->world.walls[k], &still);
        const corners c = corners_near(g, &s);
        if (!sph2d__wall_moves(s.wall))
            add_solid(g, &s, &c, g->pressure.product);
    }
    for (int side = 0; side < 4; ++side)
        add_side(sim, g, side);
    cut_by_rest(sim, g);
    close_slits(g);
    memcpy(g->still, g->distance, g->size * sizeof *g->distance);
    memcpy(g->still_stick, g->stick, g->size * sizeof *g->stick);
    memcpy(g->open_x, g->still_x, g->size * sizeof *g->open_x);
    memcpy(g->open_y, g->still_y, g->size * sizeof *g->open_y);
    memcpy(g->hidden, g->still_hidden, g->size * sizeof *g->hidden);
    finish(g, true);
    g->still_cut_count = g->cut_count;
}
