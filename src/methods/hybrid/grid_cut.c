/* SPDX-License-Identifier: MIT */
/** @file grid_cut.c
 *  Cuts the squares of the grid of method `hybrid` by solids: open parts of faces, what squares hide, thin walls. */
#include <math.h>
#include <string.h>

#include "methods/hybrid/grid.h"
#include "scene/bodies.h"
#include "scene/liquid_side.h"
#include "scene/method_table.h"
#include "scene/outline.h"
#include "scene/resolve.h"
#include "scene/wall_names.h"
#include "sim/bodies.h"

/** Signed distance of a point from the solid of an obstacle, where the scene draws it [m]. */
static double distance_from(const sph2d_scene *scene, const sph2d_obstacle *o, sph2d_vec2 p)
{
    const sph2d_outline *outline = &o->outline;
    const double d = sph2d__outline_nearest(outline, scene->spacing, p), thick = sph2d__layer_thickness(scene);
    if (!sph2d__outline_is_open(outline)) {
        if (sph2d__obstacle_fills(scene, o, p))
            return -d;
        const bool beyond = sph2d__obstacle_is_hollow(o) && !sph2d__outline_encloses(outline, p);
        return beyond ? d - thick : d;
    }
    /* A line is wet on one side, with layers on the other: the side is that of its nearest piece. */
    double nearest = INFINITY, side = 0;
    for (size_t k = 0, n = sph2d__outline_pieces(outline, scene->spacing); k < n; ++k) {
        const sph2d__segment s = sph2d__outline_piece(outline, scene->spacing, k);
        const double r = sph2d__segment_distance(&s, p);
        if (r < nearest) {
            nearest = r;
            side = sph2d__segment_side(&s, p);
        }
    }
    const bool wet = o->liquid == SPH2D_LIQUID_RIGHT ? side < 0 : side > 0;
    return wet ? d : d < thick ? -d : d - thick;
}

/** A range of corners. */
typedef struct corners {
    int left, right, bottom, top;
} corners;

/** The corners within a square and a half of a solid's outline, in a pose. */
static corners corners_near(const sph2d_sim *sim, const sph2d__grid *g, const sph2d_obstacle *o,
                            const sph2d__pose *pose)
{
    const sph2d_box b = sph2d__outline_bounds(&o->outline, sim->scene.spacing);
    const sph2d_vec2 ends[4] = {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}};
    const bool layered = sph2d__outline_is_open(&o->outline) || sph2d__obstacle_is_hollow(o);
    const double more = 1.5 * fmax((double)g->hx, (double)g->hy) + (layered ? sph2d__layer_thickness(&sim->scene) : 0);
    double left = INFINITY, right = -INFINITY, bottom = INFINITY, top = -INFINITY;
    for (int k = 0; k < 4; ++k) {
        const sph2d_vec2 p = sph2d__pose_apply(pose, ends[k]);
        left = fmin(left, p.x);
        right = fmax(right, p.x);
        bottom = fmin(bottom, p.y);
        top = fmax(top, p.y);
    }
    return (corners){sph2d__grid_clamp((left - more - g->low_x) * g->inverse_x + 1, g->nx + 1),
                     sph2d__grid_clamp((right + more - g->low_x) * g->inverse_x + 2, g->nx + 1),
                     sph2d__grid_clamp((bottom - more - g->low_y) * g->inverse_y + 1, g->ny + 1),
                     sph2d__grid_clamp((top + more - g->low_y) * g->inverse_y + 2, g->ny + 1)};
}

/** Lowers the distances of the corners near a solid, and gives those that it is nearest to its velocity and slip. */
static void add_solid(const sph2d_sim *sim, sph2d__grid *g, const sph2d_obstacle *o, const sph2d__pose *pose,
                      uint32_t owner)
{
    const corners c = corners_near(sim, g, o, pose);
    const float stick = sph2d__obstacle_slip(&sim->scene, o) == SPH2D_SLIP_NONE ? 1 : 0;
    for (int j = c.bottom; j <= c.top; ++j)
        for (int i = c.left; i <= c.right; ++i) {
            const sph2d_vec2 at = {g->low_x + (i - 1) * (double)g->hx, g->low_y + (j - 1) * (double)g->hy};
            const float d = (float)distance_from(&sim->scene, o, sph2d__pose_invert(pose, at));
            const size_t k = sph2d__at(g, i, j);
            if (!(d < g->distance[k]))
                continue;
            const sph2d_vec2 v = sph2d__pose_velocity(pose, at);
            g->distance[k] = d;
            g->stick[k] = stick;
            if (g->owner)
                g->owner[k] = owner;
            g->corner_u[k] = (float)v.x;
            g->corner_v[k] = (float)v.y;
        }
}

/** Gives the corners of a side its slip, and those between its ends the speed along it. */
static void add_side(const sph2d_sim *sim, const sph2d__grid *g, int side)
{
    const sph2d_scene *scene = &sim->scene;
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
        g->stick[k] = sph2d__side_slip(scene, side) == SPH2D_SLIP_NONE ? 1 : 0;
        (vertical ? g->corner_v : g->corner_u)[k] = (float)speeds[side];
    }
}

/** The part outside solids of the square around a face whose ends are at these distances from them, in squares: of that,
 *  not of the face itself, which a side along it would open and close at once, and the lift of bodies would have steps. */
static float open_part(float a, float b)
{
    const float part = 0.5F + (a + b) / 2;
    return part > 1 ? 1 : part > 0 ? part : 0;
}

/** Part of the bilinear weights around a point that is not beyond a straight wall at a distance, in squares. */
static float hat_part(float t)
{
    return t >= 1 ? 1 : t >= 0 ? 1 - (1 - t) * (1 - t) / 2 : t > -1 ? (1 + t) * (1 + t) / 2 : 0;
}

/** Squares of a row that are cut: all, or those that a step sets. */
static corners row_to_cut(const sph2d__grid *g, int j, bool all)
{
    const int from = all || g->begin[j] < 1 ? 1 : g->begin[j],
              to = all || g->end[j] > g->nx + 1 ? g->nx + 1 : g->end[j] - 1;
    return (corners){from, to, j, j};
}

/** Open parts of faces, velocities of the closed ones, and room of squares. */
static void cut_squares(sph2d__grid *g, double spacing, bool all)
{
    const float full = g->hx * g->hy / (float)(spacing * spacing), unit = 2 / (g->hx + g->hy), side = 1 / 0.875F;
    const size_t up = g->stride;
    const bool *open = g->open;
    g->cut_count = 0;
    for (int j = 1; j <= g->ny + 1; ++j)
        for (int i = row_to_cut(g, j, all).left, to = row_to_cut(g, j, all).right; i <= to; ++i) {
            const size_t k = sph2d__at(g, i, j);
            const float *d = g->distance + k;
            const bool left = i == 1 && !g->wraps_x && !open[0], right = i == g->nx + 1 && !g->wraps_x && !open[1];
            const bool low = j == 1 && !g->wraps_y && !open[2], high = j == g->ny + 1 && !g->wraps_y && !open[3];
            g->open_x[k] = j > g->ny || left || right ? 0 : open_part(unit * d[0], unit * d[up]);
            g->open_y[k] = i > g->nx || low || high ? 0 : open_part(unit * d[0], unit * d[1]);
            const float *u = g->corner_u + k, *v = g->corner_v + k;
            g->wall_x[k] = j > g->ny || left || right ? 0 : (u[0] + u[up]) / 2;
            g->wall_y[k] = i > g->nx || low || high ? 0 : (v[0] + v[1]) / 2;
            if (i > g->nx || j > g->ny)
                continue;
            g->room[k] = (i == 1 && !g->wraps_x ? side : 1) * (i == g->nx && !g->wraps_x ? side : 1) *
                         (j == 1 && !g->wraps_y ? side : 1) * (j == g->ny && !g->wraps_y ? side : 1) / full;
            g->hidden[k] = 1 - hat_part((d[0] + d[1] + d[up] + d[up + 1]) / 4 * unit);
            if (g->hidden[k] > 0)
                g->cut[g->cut_count++] = (uint32_t)k;
        }
}

static bool leads_out(const sph2d__grid *g, float open, size_t to)
{
    return open > 0 && g->hidden[to] < 0.5F;
}

/** Closes squares inside solids that are beside none outside: where solids meet, or a side, at the edge between them, their
 *  faces may seem open, to what would be air. */
static void close_inner(const sph2d__grid *g)
{
    const size_t up = g->stride;
    for (size_t n = 0; n < g->cut_count; ++n) {
        const size_t k = g->cut[n];
        if (g->hidden[k] < 0.5F || leads_out(g, g->open_x[k], k - 1) || leads_out(g, g->open_x[k + 1], k + 1) ||
            leads_out(g, g->open_y[k], k - up) || leads_out(g, g->open_y[k + up], k + up))
            continue;
        g->open_x[k] = g->open_x[k + 1] = g->open_y[k] = g->open_y[k + up] = 0;
    }
}

/** Mean distance of a square's corners from solids. */
static float distance_of(const sph2d__grid *g, size_t k)
{
    const float *d = g->distance + k;
    return (d[0] + d[1] + d[g->stride] + d[g->stride + 1]) / 4;
}

/** Solids that may be thinner than a square: one that moves, or all at rest. `owner`: a body's number, from 1. */
typedef struct thin {
    const sph2d__barrier *barrier;
    const sph2d_obstacle *obstacle; /**< NULL: all at rest */
    const sph2d__pose *pose;
    uint32_t owner;
} thin;

static bool is_inside(const sph2d_scene *scene, const thin *t, sph2d_vec2 p)
{
    if (t->obstacle)
        return distance_from(scene, t->obstacle, p) <= 0;
    for (size_t k = 0; k < scene->obstacle_count; ++k)
        if (!sph2d__obstacle_moves(&scene->obstacles[k]) && distance_from(scene, &scene->obstacles[k], p) <= 0)
            return true;
    return false;
}

/** Whether the way between the middles of two squares, both outside solids, passes a thin one between their corners. */
static bool passes(const sph2d_scene *scene, const sph2d__grid *g, size_t from, size_t to, const thin *t)
{
    const float near = g->hx + g->hy, one = distance_of(g, from), other = distance_of(g, to);
    if (!(one > 0 && other > 0 && one < near && other < near))
        return false;
    sph2d_vec2 ends[2];
    const size_t squares[2] = {from, to};
    for (int n = 0; n < 2; ++n)
        ends[n] = sph2d__pose_invert(t->pose,
                                     (sph2d_vec2){g->low_x + ((double)(squares[n] % g->stride) - 0.5) * (double)g->hx,
                                                  g->low_y + ((double)(squares[n] / g->stride) - 0.5) * (double)g->hy});
    return sph2d__barrier_crosses(t->barrier, ends[0], ends[1]) && !is_inside(scene, t, ends[0]) &&
           !is_inside(scene, t, ends[1]);
}

/** Closes the faces that thin solids pass between squares. */
static void close_thin(const sph2d_scene *scene, sph2d__grid *g, const corners *c, const thin *t, bool all)
{
    const size_t up = g->stride;
    for (int j = c->bottom > 1 ? c->bottom : 1; j <= c->top && j <= g->ny; ++j) {
        const corners row = row_to_cut(g, j, all);
        for (int i = c->left > row.left ? c->left : row.left; i <= c->right && i <= row.right && i <= g->nx; ++i) {
            const size_t k = sph2d__at(g, i, j);
            const double x = g->low_x + (i - 1) * (double)g->hx, y = g->low_y + (j - 1) * (double)g->hy;
            if (i > 1 && g->open_x[k] > 0 && passes(scene, g, k - 1, k, t)) {
                g->open_x[k] = 0;
                g->wall_x[k] = (float)sph2d__pose_velocity(t->pose, (sph2d_vec2){x, y + (double)g->hy / 2}).x;
                if (t->owner > 0)
                    g->thin_x[k] = t->owner;
            }
            if (j > 1 && g->open_y[k] > 0 && passes(scene, g, k - up, k, t)) {
                g->open_y[k] = 0;
                g->wall_y[k] = (float)sph2d__pose_velocity(t->pose, (sph2d_vec2){x + (double)g->hx / 2, y}).y;
                if (t->owner > 0)
                    g->thin_y[k] = t->owner;
            }
        }
    }
}

/** The number of a body, from 1; 0: it is none. */
static uint32_t owner_of(const sph2d_sim *sim, const sph2d__moving *moving)
{
    return moving->rigid ? (uint32_t)(moving->rigid - sim->bodies.items) + 1 : 0;
}

/** The solids that move or not, then the sides. */
static void add_all(sph2d_sim *sim, sph2d__grid *g, bool moving)
{
    const sph2d__pose still = {.cosine = 1};
    for (size_t k = 0; k < sim->scene.obstacle_count && !moving; ++k)
        if (!sph2d__obstacle_moves(&sim->scene.obstacles[k]))
            add_solid(sim, g, &sim->scene.obstacles[k], &still, 0);
    for (size_t k = 0; k < sim->moving_count && moving; ++k)
        add_solid(sim, g, sim->moving[k].obstacle, &sim->moving[k].to, owner_of(sim, &sim->moving[k]));
    for (int side = 0; side < 4; ++side)
        add_side(sim, g, side);
    cut_squares(g, sim->scene.spacing, !moving);
    close_inner(g);
    const thin rest = {&sim->barrier, NULL, &still, 0};
    close_thin(&sim->scene, g, &(corners){1, g->nx, 1, g->ny}, &rest, !moving);
    for (size_t k = 0; k < sim->moving_count && moving; ++k) {
        const sph2d__moving *m = &sim->moving[k];
        const thin one = {&m->barrier, m->obstacle, &m->to, owner_of(sim, m)};
        const corners c = corners_near(sim, g, m->obstacle, &m->to);
        close_thin(&sim->scene, g, &c, &one, false);
    }
}

void sph2d__grid_cut(sph2d_sim *sim, sph2d__grid *g)
{
    if (sim->moving_count == 0)
        return;
    const size_t from = sph2d__at(g, 0, g->first),
                 count = sph2d__at(g, 0, g->last < g->ny + 2 ? g->last + 2 : g->ny + 4) - from;
    memcpy(g->distance + from, g->still + from, count * sizeof *g->distance);
    memcpy(g->stick + from, g->still_stick + from, count * sizeof *g->stick);
    memset(g->corner_u + from, 0, count * sizeof *g->corner_u);
    memset(g->corner_v + from, 0, count * sizeof *g->corner_v);
    uint32_t *const owners[] = {g->owner, g->thin_x, g->thin_y};
    for (size_t n = 0; n < sizeof owners / sizeof *owners && g->body_count > 0; ++n)
        memset(owners[n] + from, 0, count * sizeof *owners[n]);
    add_all(sim, g, true);
    for (size_t k = 0; k < sim->moving_count; ++k) {
        const sph2d__rigid *r = sim->moving[k].rigid;
        if (!r)
            continue;
        const sph2d__pose *to = &sim->moving[k].to;
        const double density = sim->system.rest_density;
        g->bodies[r - sim->bodies.items] = (sph2d__grid_body){
            to->center.x + to->displacement.x,
            to->center.y + to->displacement.y,
            {density * r->free.x / r->mass, density * r->free.y / r->mass, density * r->free.turn / r->inertia}};
    }
}

void sph2d__grid_place_solids(sph2d_sim *sim, sph2d__grid *g)
{
    for (size_t k = 0; k < g->size; ++k)
        g->distance[k] = 4 * (g->hx + g->hy);
    add_all(sim, g, false);
    memcpy(g->still, g->distance, g->size * sizeof *g->distance);
    memcpy(g->still_stick, g->stick, g->size * sizeof *g->stick);
}
