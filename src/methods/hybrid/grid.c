/* SPDX-License-Identifier: MIT */
/** @file grid.c
 *  Makes the grid of method `hybrid`, and cuts its squares by solids. */
#include "methods/hybrid/grid.h"

#include <math.h>
#include <string.h>

#include "scene/bodies.h"
#include "scene/liquid_side.h"
#include "scene/method_table.h"
#include "scene/outline.h"
#include "scene/resolve.h"
#include "scene/wall_names.h"
#include "sim/bodies.h"

/* Squares of a periodic direction are a multiple of this, so that levels divide them. */
enum { PERIODIC_SQUARES = 8, SMALLEST = 4 };

static int squares_of(double length, double spacing, bool wraps)
{
    const double wanted = length / (SPH2D__SQUARE * spacing);
    const int multiple = wraps ? PERIODIC_SQUARES : 1, n = multiple * (int)lround(wanted / multiple);
    return n < multiple ? multiple : n;
}

/* ---- memory ------------------------------------------------------------------------------------------------------ */

/** Hands out parts of the block; without one it counts. */
typedef struct room {
    char *block;
    size_t used;
} room;

static void *take(room *r, size_t count, size_t size)
{
    void *at = r->block ? r->block + r->used : NULL;
    r->used += (count * size + 63) / 64 * 64;
    return at;
}

static void lay_out_level(sph2d__level *l, int nx, int ny, room *r)
{
    l->nx = nx;
    l->ny = ny;
    l->stride = ((size_t)nx + 4 + 15) / 16 * 16;
    l->size = l->stride * ((size_t)ny + 4);
    float **const all[] = {&l->left, &l->below, &l->air, &l->inverse, &l->value, &l->rest, &l->product};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        *all[k] = take(r, l->size, sizeof(float));
    l->from = take(r, (size_t)ny + 4, sizeof(int));
    l->to = take(r, (size_t)ny + 4, sizeof(int));
}

static void lay_out_sums(sph2d__sums *s, size_t size, room *r)
{
    s->x = take(r, size, sizeof *s->x);
    s->y = take(r, size, sizeof *s->y);
    s->middle = take(r, size, sizeof *s->middle);
}

static void lay_out(sph2d__grid *g, room *r)
{
    int nx = g->nx, ny = g->ny;
    for (g->levels = 0; g->levels < SPH2D__LEVELS;) {
        lay_out_level(&g->level[g->levels++], nx, ny, r);
        if ((nx <= SMALLEST && ny <= SMALLEST) || (g->wraps_x && nx % 2 != 0) || (g->wraps_y && ny % 2 != 0))
            break;
        nx = (nx + 1) / 2;
        ny = (ny + 1) / 2;
    }
    g->stride = g->level[0].stride;
    g->size = g->level[0].size;
    float **const all[] = {&g->still,    &g->distance, &g->open_x,      &g->open_y, &g->wall_x, &g->wall_y, &g->room,
                           &g->corner_u, &g->corner_v, &g->still_stick, &g->stick,  &g->mass,   &g->excess, &g->u,
                           &g->v,        &g->air_x,    &g->air_y,       &g->q,      &g->s,      &g->rest,   &g->z,
                           &g->way,      &g->image,    &g->wet_x,       &g->wet_y};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        *all[k] = take(r, g->size, sizeof(float));
    g->cut = take(r, g->size, sizeof *g->cut);
    g->filled = take(r, g->size, sizeof *g->filled);
    g->member = take(r, g->size, sizeof *g->member);
    g->pocket_end = take(r, g->size, sizeof *g->pocket_end);
    g->seen = take(r, g->size, sizeof *g->seen);
    g->begin = take(r, (size_t)g->ny + 4, sizeof *g->begin);
    g->end = take(r, (size_t)g->ny + 4, sizeof *g->end);
    g->face_x = take(r, g->size, sizeof(sph2d__quad));
    g->face_y = take(r, g->size, sizeof(sph2d__quad));
    lay_out_sums(&g->sums, g->size, r);
    if (g->body_count == 0)
        return;
    g->owner = take(r, g->size, sizeof *g->owner);
    g->thin_x = take(r, g->size, sizeof *g->thin_x);
    g->thin_y = take(r, g->size, sizeof *g->thin_y);
    g->bodies = take(r, g->body_count, sizeof *g->bodies);
    g->push = take(r, 3 * g->body_count, sizeof *g->push);
    g->impulses = take(r, g->body_count, sizeof *g->impulses);
    g->elements = take(r, 8 * g->size, sizeof *g->elements); /* of a square two faces, of each two ends and two sides */
}

static void set_shape(const sph2d_sim *sim, sph2d__grid *g)
{
    const sph2d_scene *scene = &sim->scene;
    const sph2d_boundary *b = &scene->boundary;
    const double width = scene->domain.max.x - scene->domain.min.x, height = scene->domain.max.y - scene->domain.min.y;
    g->wraps_x = sim->system.fluid_cells.period.length_x > 0;
    g->wraps_y = sim->system.fluid_cells.period.length_y > 0;
    g->open[0] = b->left == SPH2D_SIDE_OPEN;
    g->open[1] = b->right == SPH2D_SIDE_OPEN;
    g->open[2] = b->bottom == SPH2D_SIDE_OPEN;
    g->open[3] = b->top == SPH2D_SIDE_OPEN;
    const int nx = squares_of(width, scene->spacing, g->wraps_x), ny = squares_of(height, scene->spacing, g->wraps_y);
    g->nx = nx * (1 + g->open[0] + g->open[1]);
    g->ny = ny * (1 + g->open[2] + g->open[3]);
    g->low_x = scene->domain.min.x - g->open[0] * width;
    g->low_y = scene->domain.min.y - g->open[2] * height;
    g->inverse_x = nx / width;
    g->inverse_y = ny / height;
    g->hx = (float)(width / nx);
    g->hy = (float)(height / ny);
}

void sph2d__grid_free(sph2d__system *s)
{
    void *block = s->grid ? s->grid->block : NULL, *grid = s->grid;
    if (!grid)
        return;
    sph2d__release(s->memory, &block, s->grid->block_size, 1);
    sph2d__release(s->memory, &grid, 1, sizeof *s->grid);
    s->grid = NULL;
}

void sph2d__level_wrap(const sph2d__grid *g, const sph2d__level *l, float *a)
{
    for (int j = 1; j <= l->ny && g->wraps_x; ++j) {
        float *row = a + (size_t)j * l->stride;
        row[0] = row[l->nx];
        row[l->nx + 1] = row[1];
    }
    if (g->wraps_y) {
        memcpy(a, a + (size_t)l->ny * l->stride, l->stride * sizeof *a);
        memcpy(a + (size_t)(l->ny + 1) * l->stride, a + l->stride, l->stride * sizeof *a);
    }
}

/* ---- solids ------------------------------------------------------------------------------------------------------ */

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

static int clamp_to(double at, int last)
{
    return at > 0 ? (at < last ? (int)at : last) : 0;
}

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
    return (corners){clamp_to((left - more - g->low_x) * g->inverse_x + 1, g->nx + 1),
                     clamp_to((right + more - g->low_x) * g->inverse_x + 2, g->nx + 1),
                     clamp_to((bottom - more - g->low_y) * g->inverse_y + 1, g->ny + 1),
                     clamp_to((top + more - g->low_y) * g->inverse_y + 2, g->ny + 1)};
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
        g->stick[k] = sph2d__side_slip(scene, side) == SPH2D_SLIP_NONE ? 1 : 0;
        (vertical ? g->corner_v : g->corner_u)[k] = (float)speeds[side];
    }
}

/** The part of an edge outside solids, whose ends are at these distances from them. */
static float open_part(float a, float b)
{
    return a > 0 && b > 0 ? 1 : a <= 0 && b <= 0 ? 0 : (a > b ? a : b) / fabsf(a - b);
}

/** Part of the bilinear weights around a point that is not beyond a straight wall at a distance, in squares. */
static float hat_part(float t)
{
    return t >= 1 ? 1 : t >= 0 ? 1 - (1 - t) * (1 - t) / 2 : t > -1 ? (1 + t) * (1 + t) / 2 : 0;
}

/** Velocity of the closed part of a face, whose ends are at these distances from solids, by those of its ends. */
static float closed_velocity(float a, float b, float u, float v)
{
    return a <= 0 && b <= 0 ? (u + v) / 2 : a <= 0 ? u : b <= 0 ? v : 0;
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
    const float full = g->hx * g->hy / (float)(spacing * spacing), unit = 2 / (g->hx + g->hy);
    const size_t up = g->stride;
    const bool *open = g->open;
    g->cut_count = 0;
    for (int j = 1; j <= g->ny + 1; ++j)
        for (int i = row_to_cut(g, j, all).left, to = row_to_cut(g, j, all).right; i <= to; ++i) {
            const size_t k = sph2d__at(g, i, j);
            const float *d = g->distance + k;
            const bool left = i == 1 && !g->wraps_x && !open[0], right = i == g->nx + 1 && !g->wraps_x && !open[1];
            const bool low = j == 1 && !g->wraps_y && !open[2], high = j == g->ny + 1 && !g->wraps_y && !open[3];
            g->open_x[k] = j > g->ny || left || right ? 0 : open_part(d[0], d[up]);
            g->open_y[k] = i > g->nx || low || high ? 0 : open_part(d[0], d[1]);
            const float *u = g->corner_u + k, *v = g->corner_v + k;
            g->wall_x[k] = j > g->ny || left || right ? 0 : closed_velocity(d[0], d[up], u[0], u[up]);
            g->wall_y[k] = i > g->nx || low || high ? 0 : closed_velocity(d[0], d[1], v[0], v[1]);
            if (i > g->nx || j > g->ny)
                continue;
            float part = hat_part((d[0] + d[1] + d[up] + d[up + 1]) / 4 * unit);
            part *= (i == 1 && !g->wraps_x ? 0.875F : 1) * (i == g->nx && !g->wraps_x ? 0.875F : 1);
            part *= (j == 1 && !g->wraps_y ? 0.875F : 1) * (j == g->ny && !g->wraps_y ? 0.875F : 1);
            g->room[k] = part > 0.1F ? 1 / (part * full) : 0;
            if (d[0] <= 0 || d[1] <= 0 || d[up] <= 0 || d[up + 1] <= 0)
                g->cut[g->cut_count++] = (uint32_t)k;
        }
}

/** Mean distance of a square's corners from solids. */
static float distance_of(const sph2d__grid *g, size_t k)
{
    const float *d = g->distance + k;
    return (d[0] + d[1] + d[g->stride] + d[g->stride + 1]) / 4;
}

/** Whether the way from one square to the next, both outside solids, passes a thin one between their corners. */
static bool passes(const sph2d__grid *g, size_t from, size_t to, const sph2d__barrier *barrier, const sph2d__pose *pose)
{
    const float near = g->hx + g->hy, one = distance_of(g, from), other = distance_of(g, to);
    if (!(one > 0 && other > 0 && one < near && other < near))
        return false;
    sph2d_vec2 ends[2];
    const size_t squares[2] = {from, to};
    for (int n = 0; n < 2; ++n)
        ends[n] =
            sph2d__pose_invert(pose, (sph2d_vec2){g->low_x + ((double)(squares[n] % g->stride) - 0.5) * (double)g->hx,
                                                  g->low_y + ((double)(squares[n] / g->stride) - 0.5) * (double)g->hy});
    return sph2d__barrier_crosses(barrier, ends[0], ends[1]);
}

/** Closes the faces that a barrier passes between squares. `owner`: of a body, from 1. */
static void close_thin(sph2d__grid *g, const corners *c, const sph2d__barrier *barrier, const sph2d__pose *pose,
                       uint32_t owner, bool all)
{
    const size_t up = g->stride;
    for (int j = c->bottom > 1 ? c->bottom : 1; j <= c->top && j <= g->ny; ++j) {
        const corners row = row_to_cut(g, j, all);
        for (int i = c->left > row.left ? c->left : row.left; i <= c->right && i <= row.right && i <= g->nx; ++i) {
            const size_t k = sph2d__at(g, i, j);
            const double x = g->low_x + (i - 1) * (double)g->hx, y = g->low_y + (j - 1) * (double)g->hy;
            if (i > 1 && g->open_x[k] > 0 && passes(g, k - 1, k, barrier, pose)) {
                g->open_x[k] = 0;
                g->wall_x[k] = (float)sph2d__pose_velocity(pose, (sph2d_vec2){x, y + (double)g->hy / 2}).x;
                if (owner > 0)
                    g->thin_x[k] = owner;
            }
            if (j > 1 && g->open_y[k] > 0 && passes(g, k - up, k, barrier, pose)) {
                g->open_y[k] = 0;
                g->wall_y[k] = (float)sph2d__pose_velocity(pose, (sph2d_vec2){x + (double)g->hx / 2, y}).y;
                if (owner > 0)
                    g->thin_y[k] = owner;
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
    close_thin(g, &(corners){1, g->nx, 1, g->ny}, &sim->barrier, &still, 0, !moving);
    for (size_t k = 0; k < sim->moving_count && moving; ++k) {
        const corners c = corners_near(sim, g, sim->moving[k].obstacle, &sim->moving[k].to);
        close_thin(g, &c, &sim->moving[k].barrier, &sim->moving[k].to, owner_of(sim, &sim->moving[k]), !moving);
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

/** The solids at rest. */
static void place_solids(sph2d_sim *sim, sph2d__grid *g)
{
    for (size_t k = 0; k < g->size; ++k)
        g->distance[k] = 4 * (g->hx + g->hy);
    add_all(sim, g, false);
    memcpy(g->still, g->distance, g->size * sizeof *g->distance);
    memcpy(g->still_stick, g->stick, g->size * sizeof *g->stick);
}

sph2d_status sph2d__grid_prepare(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    if (s->grid)
        return SPH2D_OK;
    sph2d__grid *g = s->grid = sph2d__alloc(s->memory, 1, sizeof *g);
    if (!g)
        return SPH2D_NOMEM;
    g->solver = sph2d__multigrid_find(s->isa);
    g->body_count = sim->bodies.count;
    set_shape(sim, g);
    room counted = {NULL, 0};
    lay_out(g, &counted);
    g->block = sph2d__alloc(s->memory, counted.used + 64, 1);
    if (!g->block) {
        sph2d__grid_free(s);
        return SPH2D_NOMEM;
    }
    g->block_size = counted.used + 64;
    room given = {(char *)g->block + (64 - (uintptr_t)g->block % 64) % 64, 0};
    lay_out(g, &given);
    place_solids(sim, g);
    return SPH2D_OK;
}
