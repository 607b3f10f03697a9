/* SPDX-License-Identifier: MIT */
/** @file check_way.c
 *  Follows the motion of an obstacle: that it stays within the domain and clear of obstacles at rest, and leaves the
 *  liquid between room. */
#include <math.h>
#include <stdio.h>

#include "scene/checker.h"
#include "scene/overlap.h"
#include "scene/shape.h"

typedef sph2d__checker checker;

/* How often a motion is looked at, and how many pairs of segments are compared in all for one obstacle. Thinner overlaps
 * than DEPTH spacings pass: corners of a hinged flap dip into the floor, and ends of a paddle slide along walls. */
static const double MAX_TIMES = 2000, MAX_PAIRS = 2e6, DEPTH = 2;

/* What is kept of an obstacle at rest: whether it can be hit, and whether it is more than a spacing away at first. */
enum { CAN_HIT = 1, AWAY = 2 };

/** An obstacle that moves, and how finely its motion is looked at. */
typedef struct mover {
    const sph2d__world *world;
    const sph2d_scene *scene;
    const sph2d_shape *outline;
    const sph2d__course *course;
    size_t index, pieces;
    double spacing, depth;           /**< of the pieces of circles; that is too deep [m] */
    bool away[SPH2D__WALL_OBSTACLE]; /**< which sides are more than a spacing away at first */
    unsigned char *hits;             /**< CAN_HIT and AWAY of each obstacle */
} mover;

/** How near a motion takes its obstacle to something that was away at first. */
typedef struct approach {
    double gap, time; /**< [m], [s] */
    char what[64];
} approach;

/** Whether the mover in a pose overlaps an obstacle at rest. */
static bool overlaps(const mover *m, const sph2d__pose *pose, const sph2d__wall *other)
{
    return sph2d__walls_overlap(&m->world->walls[m->index], pose, other, m->spacing, m->depth);
}

static double gap_to(const mover *m, const sph2d__pose *pose, const sph2d__wall *other)
{
    return sph2d__walls_gap(&m->world->walls[m->index], pose, other, m->scene->spacing);
}

/** Whether another obstacle stands where the motion could hit it: it rests, and is clear of it at the start. */
static bool can_hit(const mover *m, size_t other)
{
    sph2d__pose start = {.center = m->course->center, .cosine = 1};
    const sph2d__wall *o = &m->world->walls[other];
    return other != m->index && !sph2d__wall_moves(o) && !overlaps(m, &start, o);
}

/** Chooses what the motion is compared with: pairs of segments at each time. Gaps take finer pieces than overlaps. */
static double choose(mover *m)
{
    sph2d__pose start = {.center = m->course->center, .cosine = 1};
    const double dx = m->scene->spacing, own = (double)sph2d__shape_pieces(m->outline, dx);
    double pairs = 0;
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        m->away[side] = sph2d__side_gap(m->scene, m->outline, &start, m->spacing, side) >= dx;
    for (size_t k = SPH2D__WALL_OBSTACLE; k < m->world->wall_count; ++k) {
        const sph2d__wall *other = &m->world->walls[k];
        double here = (double)m->pieces * (double)sph2d__shape_pieces(&other->shape, m->spacing);
        double fine = own * (double)sph2d__shape_pieces(&other->shape, dx);
        m->hits[k] = pairs + here < MAX_PAIRS / 10 && can_hit(m, k) ? CAN_HIT : 0;
        pairs += m->hits[k] ? here : 0;
        if (m->hits[k] && pairs + fine < MAX_PAIRS / 10 && gap_to(m, &start, other) >= dx) {
            m->hits[k] |= AWAY;
            pairs += fine;
        }
    }
    return pairs;
}

/** Looks at one time; false once something is hit. */
static bool is_clear(checker *c, const mover *m, const sph2d__pose *pose, double time)
{
    const char *side = "";
    char message[160], path[SPH2D__PATH_SIZE];
    double beyond = sph2d__beyond_sides(m->scene, m->outline, pose, m->spacing, &side);
    message[0] = '\0';
    if (beyond > m->depth)
        snprintf(message, sizeof message, "takes it %.3g m beyond the %s side of the domain at t = %.4g s", beyond,
                 side, time);
    for (size_t k = SPH2D__WALL_OBSTACLE; k < m->world->wall_count && !message[0]; ++k)
        if (m->hits[k] && overlaps(m, pose, &m->world->walls[k]))
            snprintf(message, sizeof message, "takes it through %s at t = %.4g s",
                     sph2d__wall_path(path, sizeof path, &m->world->walls[k], ""), time);
    if (message[0])
        sph2d_diagnostic_hint(
            sph2d__check_fault(c, SPH2D_CODE_OUTSIDE, sph2d__check_wall_path(c, path, m->index, ".motion"), message),
            "let it turn back before, or move what is in its way");
    return !message[0];
}

/** Notes what is nearer than before. */
static void note_gaps(const mover *m, const sph2d__pose *pose, double time, approach *least)
{
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side) {
        double gap = m->away[side] ? sph2d__side_gap(m->scene, m->outline, pose, m->spacing, side) : INFINITY;
        if (gap < least->gap) {
            *least = (approach){.gap = gap, .time = time};
            snprintf(least->what, sizeof least->what, "the %s side of the domain", sph2d__side_word(side));
        }
    }
    for (size_t k = SPH2D__WALL_OBSTACLE; k < m->world->wall_count; ++k) {
        double gap = m->hits[k] & AWAY ? gap_to(m, pose, &m->world->walls[k]) : INFINITY;
        if (gap < least->gap) {
            *least = (approach){.gap = gap, .time = time};
            sph2d__wall_path(least->what, sizeof least->what, &m->world->walls[k], "");
        }
    }
}

/** A gate that closed onto the floor of a pool pushed a particle through the floor; one that left a tenth of a spacing
 *  did not, but what is in a gap below a spacing is no liquid: a particle takes half a spacing from each wall. */
static void warn_of_gap(checker *c, const mover *m, const approach *least)
{
    char path[SPH2D__PATH_SIZE];
    double gap = fmax(least->gap, 0) / m->scene->spacing;
    if (!(gap < 1 - 1e-6))
        return;
    sph2d_diagnostic *w = sph2d_report_add(
        c->report, SPH2D_WARNING, SPH2D_CODE_CONFLICT, sph2d__check_wall_path(c, path, m->index, ".motion"),
        "takes it to %.2g spacings from %s at t = %.4g s: liquid between them has nowhere to go", gap, least->what,
        least->time);
    sph2d_diagnostic_hint(w, "let it stop a spacing before, or keep liquid away from there");
}

void sph2d__check_way(checker *c, size_t index, const sph2d__course *course, unsigned char *hits)
{
    const sph2d_shape *outline = &c->world->walls[index].shape;
    double spacing = c->scene->spacing, end = c->scene->run.until;
    mover m = {.world = c->world,
               .scene = c->scene,
               .outline = outline,
               .course = course,
               .index = index,
               .spacing = outline->kind == SPH2D_SHAPE_CIRCLE ? outline->circle.radius / 2 : spacing,
               .depth = DEPTH * spacing,
               .hits = hits};
    const sph2d_motion *motion = course->motion;
    m.pieces = sph2d__shape_pieces(outline, m.spacing);
    if (motion->path.count > 0 && motion->rate == 0 && motion->swing_count == 0 && !(motion->frequency > 0))
        end = fmin(end, motion->path.items[motion->path.count - 1].t); /* nothing else moves it */
    double pairs = choose(&m);
    double speed = sph2d__course_speed(course, sph2d__shape_distance(outline, course->center));
    double times = fmin(ceil(end * speed / spacing), fmin(MAX_TIMES, MAX_PAIRS / fmax(pairs, 1)));
    approach least = {.gap = INFINITY};
    for (double k = 0; k <= times; ++k) {
        double time = times > 0 ? end * k / times : 0;
        sph2d__pose pose = sph2d__course_at(course, time);
        if (!is_clear(c, &m, &pose, time))
            return;
        note_gaps(&m, &pose, time, &least);
    }
    warn_of_gap(c, &m, &least);
}
