/* SPDX-License-Identifier: MIT */
/** @file place_walls.c
 *  Walls of a scene: boundary particles along obstacles and sides, their slip, barriers for continuous collision, springs. */
#include <math.h>

#include "kernels/muller.h"
#include "scene/liquid.h"
#include "start/start.h"

/* ---- slip, where walls differ in it ------------------------------------------------------------------------------ */

/** The slip at a position outside the sides. In the corner between two it is that of the rougher one: beside a wall
 *  with free slip, which is a mirror, the other one goes on. */
static sph2d_slip slip_outside(const sph2d__world *world, double x, double y)
{
    sph2d_box d = world->box;
    const double outside[SPH2D__WALL_OBSTACLE] = {d.min.x - x, x - d.max.x, d.min.y - y, y - d.max.y};
    sph2d_slip slip = SPH2D_SLIP_FREE;
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side) {
        if (!(outside[side] > 0) || sph2d__side_of(&world->scene, side) != SPH2D_SIDE_WALL)
            continue;
        sph2d_slip own = world->walls[side].slip;
        if (own == SPH2D_SLIP_NONE || slip == SPH2D_SLIP_FREE)
            slip = own;
    }
    return slip;
}

static sph2d_status set_slips(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    sph2d__store *w = &s->walls;
    unsigned slips = sph2d__wall_slips(&sim->world);
    if (!(slips & (slips - 1)))
        return SPH2D_OK;
    unsigned char *of = sph2d__arena_alloc(&sim->arena, &sim->memory, w->count + 1, sizeof *of);
    if (!of)
        return SPH2D_NOMEM;
    for (size_t b = 0; b < w->count; ++b)
        of[b] = (unsigned char)slip_outside(&sim->world, w->x[b], w->y[b]);
    for (size_t k = SPH2D__WALL_OBSTACLE; k < sim->world.wall_count; ++k)
        for (uint64_t b = sim->wall_ids[k].first; b < sim->wall_ids[k].end; ++b)
            of[b] = (unsigned char)sim->world.walls[k].slip;
    for (size_t b = 0; s->walls_smooth && b < w->count; ++b)
        if (of[b] != SPH2D_SLIP_SMOOTH)
            w->skin[b] = 0; /* no friction */
    s->wall_slips = of;
    return SPH2D_OK;
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/* Clearance of the barriers [spacings]: well within the distance that pressure and springs maintain. */
static const double CLEARANCE = 0.05;
/* Distance of a single row of boundary particles outside a side of the domain [spacings]: a lattice that starts half a
 * spacing inside is then one spacing away. */
static const double SIDE_OFFSET = 0.5;

/** A piece of wall with boundary particles along it. */
typedef struct wall_piece {
    sph2d__segment segment;
    sph2d_wall_form form;
    double restitution;
    bool with_end; /**< with a particle at b, where no next piece begins */
} wall_piece;

static double piece_intervals(const sph2d__segment *s, double spacing)
{
    double n = ceil(hypot(s->b.x - s->a.x, s->b.y - s->a.y) / spacing - 1e-9);
    return n < 1 ? 1 : n;
}

/** Boundary particles from a to b, no farther apart than the spacing. */
static sph2d_status place_piece(sph2d_sim *sim, const wall_piece *piece, sph2d_report *report)
{
    sph2d__system *s = &sim->system;
    const sph2d__segment *line = &piece->segment;
    double intervals = piece_intervals(line, s->spacing);
    if (sph2d__sim_too_many(sim, (double)s->walls.count + intervals, "obstacles", report))
        return SPH2D_SCENE;
    size_t n = (size_t)intervals, count = n + piece->with_end;
    if (!sph2d__store_reserve(&s->walls, s->memory, s->walls.count + count))
        return SPH2D_NOMEM;
    for (size_t k = 0; k < count; ++k) {
        double t = (double)k / (double)n;
        size_t i = sph2d__store_add(&s->walls, s->walls.count, line->a.x + t * (line->b.x - line->a.x),
                                    line->a.y + t * (line->b.y - line->a.y));
        s->walls.bounce[i] = piece->form == SPH2D_WALL_REFLECT ? piece->restitution : -1;
    }
    s->walls_press |= piece->form == SPH2D_WALL_HEAVY;
    s->walls_reflect |= piece->form == SPH2D_WALL_REFLECT;
    return SPH2D_OK;
}

/** Kernel sum over a straight row of particles, one spacing apart, at a distance [spacings]. */
static double row_sum(double support_ratio, double distance)
{
    int reach = (int)support_ratio + 1;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i)
        sum += sph2d__poly6_shape(support_ratio * support_ratio, i * i + distance * distance);
    return sum;
}

/** Distance of a single row of boundary particles behind the surface of a wall [spacings]. A row with rest density by
 *  itself (Akinci et al. 2012, eq. 4) represents all rows behind it. Its distance from a lattice, which ends half a spacing
 *  before the surface, must give the first row of liquid the rest density, too; by default it is 1.19 spacings. */
static double row_offset(const sph2d_sim *sim)
{
    const double ratio = sim->world.scene.method.support_ratio;
    double behind = 0, row = row_sum(ratio, 0), lattice = row;
    for (int k = 1; k <= (int)ratio + 1; ++k)
        behind += row_sum(ratio, k);
    lattice += 2 * behind;
    double low = 0.5, high = 2; /* the sum over the wall's row falls with the distance */
    for (int n = 0; n < 50; ++n) {
        double gap = (low + high) / 2;
        *(row_sum(ratio, gap) * lattice / row > behind ? &low : &high) = gap;
    }
    return low - SIDE_OFFSET;
}

bool sph2d__has_inset_row(const sph2d__wall *wall)
{
    return wall->form == SPH2D_WALL_HEAVY && !sph2d__shape_is_open(&wall->shape) && !sph2d__wall_is_hollow(wall);
}

/** How far the row of a heavy solid lies behind its surface [m]: at most in the middle of a thin one. On its surface the
 *  row made the solid 0.63 to 0.75 spacings larger all round, with 1.27 to 1.32 times its buoyancy at 10 across. */
static double inset_of(const sph2d_sim *sim, const sph2d__wall *wall)
{
    if (!sph2d__has_inset_row(wall))
        return 0;
    const sph2d_shape *outline = &wall->shape;
    double spacing = sim->world.scene.spacing, length = 0;
    size_t pieces = sph2d__shape_pieces(outline, spacing);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__shape_piece(outline, spacing, k);
        length += hypot(s.b.x - s.a.x, s.b.y - s.a.y);
    }
    return fmin(row_offset(sim) * spacing, sph2d__shape_area(outline) / length);
}

/** Places the boundary particles of a wall and adds its pieces to a barrier. */
static sph2d_status place_outline(sph2d_sim *sim, const sph2d__wall *wall, sph2d__barrier *barrier,
                                  sph2d_report *report)
{
    double spacing = sim->world.scene.spacing;
    size_t pieces = sph2d__shape_pieces(&wall->shape, spacing);
    if (sph2d__sim_too_many(sim, (double)sim->system.walls.count + (double)pieces, "obstacles", report))
        return SPH2D_SCENE;
    sph2d_wall_form form = wall->form;
    bool open = sph2d__shape_is_open(&wall->shape);
    double inset = inset_of(sim, wall);
    for (size_t k = 0; k < pieces; ++k) {
        wall_piece piece = {sph2d__shape_piece(&wall->shape, spacing, k), form, wall->restitution,
                            open && k + 1 == pieces};
        sph2d__segment face = piece.segment;
        if (inset > 0)
            piece.segment = sph2d__inset_piece(sim, wall, k, inset);
        if (wall->liquid == SPH2D_LIQUID_RIGHT) /* the barrier keeps particles that start on a segment on its left */
            face = (sph2d__segment){face.b, face.a};
        if (!sph2d__barrier_add(barrier, face, &sim->memory))
            return SPH2D_NOMEM;
        sph2d_status status = form == SPH2D_WALL_GENERALISED ? SPH2D_OK : place_piece(sim, &piece, report);
        if (status != SPH2D_OK)
            return status;
    }
    return form == SPH2D_WALL_GENERALISED ? sph2d__sim_place_layers(sim, wall, barrier, report) : SPH2D_OK;
}

/** Sets the motion of a wall; its boundary particles are placed. */
static sph2d_status start_motion(sph2d_sim *sim, sph2d__moving *m, const sph2d__wall *wall)
{
    const sph2d__store *walls = &sim->system.walls;
    size_t bends = sph2d__motion_bends(&wall->motion);
    bool turns = walls->normal_x && sph2d__wall_turns(wall);
    sph2d_pose_point *points = bends ? sph2d__arena_alloc(&sim->arena, &sim->memory, bends, sizeof *points) : NULL;
    size_t count = (size_t)(m->end_id - m->first_id) + 1;
    sph2d_vec2 *normals = turns ? sph2d__arena_alloc(&sim->arena, &sim->memory, count, sizeof *normals) : NULL;
    m->poses = sph2d__arena_alloc(&sim->arena, &sim->memory, SPH2D__MOST_CHORDS + 1, sizeof *m->poses);
    if ((bends && !points) || (turns && !normals) || !m->poses)
        return SPH2D_NOMEM;
    m->wall = wall;
    m->course = sph2d__course_of(&wall->motion, &wall->shape, points);
    sph2d__moving_start(m, walls, normals);
    return SPH2D_OK;
}

static sph2d_status place_wall(sph2d_sim *sim, size_t index, sph2d_report *report)
{
    const sph2d__wall *wall = &sim->world.walls[index];
    sph2d__barrier *barrier = &sim->barrier;
    sph2d__moving *m = NULL;
    if (sph2d__wall_moves(wall)) {
        m = &sim->moving[sim->moving_count++];
        barrier = &m->barrier;
    }
    sph2d__ids *ids = &sim->wall_ids[index];
    barrier->wall = (int)index;
    ids->first = sim->system.walls.count;
    sph2d_status status = place_outline(sim, wall, barrier, report);
    ids->end = sim->system.walls.count;
    if (!m || status != SPH2D_OK)
        return status;
    m->number = (int)index;
    m->first_id = ids->first;
    m->end_id = ids->end;
    return start_motion(sim, m, wall);
}

/** Places one side of the domain that is a wall. `shift` points outwards. */
static sph2d_status place_side(sph2d_sim *sim, sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 shift, sph2d_report *report)
{
    if (!sph2d__barrier_add(&sim->barrier, (sph2d__segment){a, b}, &sim->memory))
        return SPH2D_NOMEM;
    if (sim->world.scene.walls == SPH2D_WALL_SPRING || sim->world.scene.walls == SPH2D_WALL_GENERALISED)
        return SPH2D_OK;
    double d = SIDE_OFFSET * sim->world.scene.spacing;
    wall_piece piece = {{{a.x + d * shift.x, a.y + d * shift.y}, {b.x + d * shift.x, b.y + d * shift.y}},
                        sim->world.scene.walls,
                        sph2d_obstacle_default().restitution,
                        true};
    return place_piece(sim, &piece, report);
}

/** The domain and, beyond its open sides, the area in which particles are kept: walls extend as far. */
static sph2d_box extended_domain(const sph2d__world *world)
{
    const sph2d_scene *scene = &world->scene;
    sph2d_box d = world->box;
    double width = d.max.x - d.min.x, height = d.max.y - d.min.y;
    d.min.x -= scene->boundary.left == SPH2D_SIDE_OPEN ? width : 0;
    d.max.x += scene->boundary.right == SPH2D_SIDE_OPEN ? width : 0;
    d.min.y -= scene->boundary.bottom == SPH2D_SIDE_OPEN ? height : 0;
    d.max.y += scene->boundary.top == SPH2D_SIDE_OPEN ? height : 0;
    return d;
}

/** Each side has the liquid on the left of a to b, where the barrier keeps particles that start on it. */
static sph2d_status place_sides(sph2d_sim *sim, sph2d_report *report)
{
    sph2d_box d = extended_domain(&sim->world);
    sph2d_boundary sides = sim->world.scene.boundary;
    struct {
        sph2d_side side;
        sph2d_vec2 a, b, shift;
    } all[4] = {
        {sides.left, {d.min.x, d.max.y}, d.min, {-1, 0}},
        {sides.right, {d.max.x, d.min.y}, d.max, {1, 0}},
        {sides.bottom, d.min, {d.max.x, d.min.y}, {0, -1}},
        {sides.top, d.max, {d.min.x, d.max.y}, {0, 1}},
    };
    for (int k = 0; k < 4; ++k) {
        if (all[k].side != SPH2D_SIDE_WALL)
            continue;
        sim->barrier.wall = k;
        sph2d_status status = place_side(sim, all[k].a, all[k].b, all[k].shift, report);
        if (status != SPH2D_OK)
            return status;
    }
    return SPH2D_OK;
}

/** Makes the array of angular velocities, if any obstacle turns. False when memory is short. */
static bool make_spins(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    bool turns = false;
    for (size_t k = 0; k < sim->moving_count; ++k)
        turns = turns || sph2d__wall_turns(sim->moving[k].wall);
    if (!turns || !s->walls.depth)
        return true;
    s->wall_spin = sph2d__arena_alloc(&sim->arena, &sim->memory, s->walls.count + 1, sizeof *s->wall_spin);
    for (size_t k = 0; s->wall_spin && k < sim->moving_count; ++k)
        sim->moving[k].spins = &s->wall_spin[sim->moving[k].first_id];
    return s->wall_spin;
}

/** Sorts the boundary particles, once all are placed, and builds the barriers. */
static bool finish_walls(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    const sph2d__period *period = &s->wall_cells.period;
    double bucket = s->support, clearance = CLEARANCE * sim->world.scene.spacing;
    for (size_t i = 0; i < s->walls.count; ++i) {
        s->walls.start_x[i] = s->walls.x[i];
        s->walls.start_y[i] = s->walls.y[i];
        s->walls.x[i] = sph2d__period_wrap(s->walls.x[i], period->low_x, period->length_x);
        s->walls.y[i] = sph2d__period_wrap(s->walls.y[i], period->low_y, period->length_y);
        s->walls.density[i] = s->rest_density;
    }
    for (size_t k = 0; k < sim->moving_count; ++k)
        if (!sph2d__barrier_build(&sim->moving[k].barrier, bucket, clearance, &sim->memory))
            return false;
    return make_spins(sim) && sph2d__barrier_build(&sim->barrier, bucket, clearance, &sim->memory) &&
           (s->walls.count == 0 || sph2d__cells_build(&s->wall_cells, &s->walls, s->wall_reach, s->memory));
}

sph2d_status sph2d__sim_place_walls(sph2d_sim *sim, sph2d_report *report)
{
    sph2d_status status = place_sides(sim, report);
    for (size_t i = SPH2D__WALL_OBSTACLE; status == SPH2D_OK && i < sim->world.wall_count; ++i)
        status = place_wall(sim, i, report);
    if (status == SPH2D_OK && sim->world.scene.walls == SPH2D_WALL_GENERALISED)
        status = sph2d__sim_place_side_layers(sim, report);
    if (status == SPH2D_OK)
        status = set_slips(sim);
    if (status != SPH2D_OK)
        return status;
    return finish_walls(sim) ? SPH2D_OK : SPH2D_NOMEM;
}
