/* SPDX-License-Identifier: MIT */
/** @file outlines.c
 *  The outlines of walls and bodies. Sides that meet are one outline, so that their corners can be mitred; those with
 *  openings are left to the solids beside these (scene/openings.h). */
#include "sim/outlines.h"

#include "scene/liquid.h"
#include "scene/openings.h"
#include "sim/simulation.h"

/** Writes outlines one after the other, or only counts their corners. */
typedef struct writer {
    sph2d__outlines *to; /**< NULL: counts */
    size_t count;
    uint64_t id, wall;
} writer;

static void add(writer *w, sph2d_vec2 corner, sph2d_outline_liquid liquid)
{
    if (w->to) {
        w->to->start[w->count] = corner;
        w->to->id[w->count] = w->id;
        w->to->liquid[w->count] = (uint64_t)liquid;
        w->to->wall[w->count] = w->wall;
    }
    ++w->count;
}

/* ---- sides ------------------------------------------------------------------------------------------------------- */

/** Adds the sides that are walls, anticlockwise: the liquid is on their left. */
static void add_sides(writer *w, const sph2d_scene *scene)
{
    const sph2d_box *d = &scene->domain;
    const sph2d_vec2 corners[4] = {d->min, {d->max.x, d->min.y}, d->max, {d->min.x, d->max.y}};
    static const int around[4] = {SPH2D__WALL_BOTTOM, SPH2D__WALL_RIGHT, SPH2D__WALL_TOP, SPH2D__WALL_LEFT};
    bool walls[4];
    for (int k = 0; k < 4; ++k)
        walls[k] = sph2d__side_of(scene, around[k]) == SPH2D_SIDE_WALL && !sph2d__side_has_opening(scene, around[k]);
    int first = 0; /* a side before which there is none */
    while (first < 4 && walls[(first + 3) % 4])
        ++first;
    w->wall = UINT64_MAX;
    if (first == 4) {
        for (int k = 0; k <= 4; ++k)
            add(w, corners[k % 4], SPH2D_OUTLINE_LIQUID_LEFT);
        ++w->id;
        return;
    }
    for (int k = first; k < first + 4; ++k) {
        if (!walls[k % 4])
            continue;
        if (k == first || !walls[(k + 3) % 4])
            add(w, corners[k % 4], SPH2D_OUTLINE_LIQUID_LEFT);
        add(w, corners[(k + 1) % 4], SPH2D_OUTLINE_LIQUID_LEFT);
        if (!walls[(k + 1) % 4])
            ++w->id;
    }
}

/* ---- obstacles and bodies ---------------------------------------------------------------------------------------- */

/** Adds the corners of an obstacle in the order of its outline, or backwards. */
static void add_corners(writer *w, const sph2d_shape *outline, double spacing, bool backwards,
                        sph2d_outline_liquid liquid)
{
    size_t pieces = sph2d__shape_pieces(outline, spacing);
    bool closed = !sph2d__shape_is_open(outline);
    for (size_t k = 0; k <= pieces; ++k) {
        if (k == pieces && closed && liquid == SPH2D_OUTLINE_LIQUID_OUTSIDE)
            break; /* a solid closes itself */
        size_t at = backwards ? pieces - k : k;
        sph2d_vec2 corner = at < pieces ? sph2d__shape_piece(outline, spacing, at).a
                            : closed    ? sph2d__shape_piece(outline, spacing, 0).a
                                        : sph2d__shape_piece(outline, spacing, pieces - 1).b;
        add(w, corner, liquid);
    }
    ++w->id;
}

/** Twice the area within the corners of an outline, positive if they are anticlockwise. */
static double turning(const sph2d_shape *outline, double spacing)
{
    double sum = 0;
    for (size_t k = 0; k < sph2d__shape_pieces(outline, spacing); ++k) {
        sph2d__segment s = sph2d__shape_piece(outline, spacing, k);
        sum += s.a.x * s.b.y - s.a.y * s.b.x;
    }
    return sum;
}

static void add_wall(writer *w, double dx, const sph2d__wall *o)
{
    bool layers = o->body || o->form == SPH2D_WALL_GENERALISED || o->kind == SPH2D__WALL_IS_BESIDE_OPENING;
    if (!layers)
        add_corners(w, &o->shape, dx, false, SPH2D_OUTLINE_LIQUID_BOTH);
    else if (sph2d__wall_is_hollow(o))
        add_corners(w, &o->shape, dx, turning(&o->shape, dx) < 0, SPH2D_OUTLINE_LIQUID_LEFT);
    else if (sph2d__shape_is_open(&o->shape))
        add_corners(w, &o->shape, dx, o->liquid == SPH2D_LIQUID_RIGHT, SPH2D_OUTLINE_LIQUID_LEFT);
    else
        add_corners(w, &o->shape, dx, false, SPH2D_OUTLINE_LIQUID_OUTSIDE);
}

/* ---- all of them ------------------------------------------------------------------------------------------------- */

static size_t write(const sph2d_sim *sim, sph2d__outlines *to)
{
    writer w = {.to = to};
    add_sides(&w, &sim->world.scene);
    for (size_t k = SPH2D__WALL_OBSTACLE; k < sim->world.wall_count; ++k) {
        const sph2d__wall *is = &sim->world.walls[k];
        w.wall = is->kind == SPH2D__WALL_IS_BESIDE_OPENING ? UINT64_MAX : is->index;
        if (is->body)
            w.wall += sim->world.scene.obstacle_count;
        add_wall(&w, sim->world.scene.spacing, is);
    }
    return w.count;
}

bool sph2d__outlines_create(sph2d_sim *sim)
{
    sph2d__outlines *all = &sim->outlines;
    size_t count = write(sim, NULL), room = count + 1;
    all->start = sph2d__arena_alloc(&sim->arena, &sim->memory, room, sizeof *all->start);
    all->x = sph2d__arena_alloc(&sim->arena, &sim->memory, room, sizeof *all->x);
    all->y = sph2d__arena_alloc(&sim->arena, &sim->memory, room, sizeof *all->y);
    all->id = sph2d__arena_alloc(&sim->arena, &sim->memory, room, sizeof *all->id);
    all->liquid = sph2d__arena_alloc(&sim->arena, &sim->memory, room, sizeof *all->liquid);
    all->wall = sph2d__arena_alloc(&sim->arena, &sim->memory, room, sizeof *all->wall);
    if (!all->start || !all->x || !all->y || !all->id || !all->liquid || !all->wall)
        return false;
    all->count = write(sim, all);
    for (size_t i = 0; i < count; ++i) {
        all->x[i] = all->start[i].x;
        all->y[i] = all->start[i].y;
    }
    sph2d__outlines_move(sim);
    return true;
}

void sph2d__outlines_move(sph2d_sim *sim)
{
    sph2d__outlines *all = &sim->outlines;
    uint64_t wall = UINT64_MAX;
    sph2d__pose pose = {.cosine = 1};
    for (size_t i = 0; sim->moving_count > 0 && i < all->count; ++i) {
        if (all->wall[i] == UINT64_MAX)
            continue;
        if (all->wall[i] != wall) {
            wall = all->wall[i];
            const size_t obstacles = sim->world.scene.obstacle_count;
            const size_t number =
                wall < obstacles ? SPH2D__WALL_OBSTACLE + wall : sim->world.first_body + (wall - obstacles);
            pose = sph2d__sim_pose_of(sim, &sim->world.walls[number]);
        }
        sph2d_vec2 at = sph2d__pose_apply(&pose, all->start[i]);
        all->x[i] = at.x;
        all->y[i] = at.y;
    }
}
