/* SPDX-License-Identifier: MIT */
/** @file check_motion.c
 *  Checks the motions of obstacles and of the tank: their keys, where they start, and jumps of their velocity. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "base/memory.h"
#include "scene/checker.h"
#include "scene/frame.h"
#include "scene/liquid.h"
#include "scene/method_table.h"
#include "scene/motion.h"
#include "scene/shape.h"

enum { PATH_SIZE = SPH2D__PATH_SIZE };
typedef sph2d__checker checker;

/* Maximum number of points of a path, and of swings. */
enum { MAX_POINTS = 5000, MAX_SWINGS = 100 };

/* ---- keys -------------------------------------------------------------------------------------------------------- */

/* In place of the number of a wall. */
static const size_t TANK = SIZE_MAX;

static void fault(checker *c, size_t i, sph2d_code code, const char *key, const char *message, const char *hint)
{
    char path[PATH_SIZE], full[64];
    snprintf(full, sizeof full, ".motion%s%s", key[0] ? "." : "", key);
    sph2d_diagnostic *d =
        sph2d__check_fault(c, code, i == TANK ? full + 1 : sph2d__check_wall_path(c, path, i, full), message);
    if (hint)
        sph2d_diagnostic_hint(d, "%s", hint);
}

static void check_keys(checker *c, size_t i)
{
    const sph2d_motion *m = i == TANK ? &c->scene->motion : &c->world->walls[i].motion;
    char path[PATH_SIZE];
    sph2d__check_times(c, m->path.count > 0 ? &m->path.items[0].t : NULL, m->path.count, 4,
                       i == TANK ? "motion.path" : sph2d__check_wall_path(c, path, i, ".motion.path"));
    if (m->file && m->path.count > 0)
        fault(c, i, SPH2D_CODE_CONFLICT, "file", "gives the path, which is given, too", "leave out one of the two");
    else if (m->file)
        fault(c, i, SPH2D_CODE_MISSING_KEY, "file", "was not read: only a scene that is read from a file has files",
              "give its rows as `path`");
    if (m->path.count > MAX_POINTS)
        fault(c, i, SPH2D_CODE_OUT_OF_RANGE, "path", "has more than 5000 points",
              "leave out points; cubics go smoothly through few");
    if (m->swing_count > MAX_SWINGS)
        fault(c, i, SPH2D_CODE_OUT_OF_RANGE, "swings", "has more than 100 items", NULL);
    if (m->between != SPH2D_BETWEEN_DEFAULT && m->path.count == 0)
        fault(c, i, SPH2D_CODE_CONFLICT, "between", "is about the points of a path, of which there is none", NULL);
}

static bool is_still(sph2d_swing s)
{
    return !(s.frequency > 0) && (s.amplitude.x != 0 || s.amplitude.y != 0 || s.angle != 0);
}

/** Warns of an oscillation without a frequency. A study may set one to 0 to compare with, so it is no error. */
static void check_swings(checker *c, size_t i)
{
    const sph2d_motion *m = i == TANK ? &c->scene->motion : &c->world->walls[i].motion;
    char path[PATH_SIZE], key[64];
    bool still = is_still((sph2d_swing){m->amplitude, m->angle, m->frequency, m->phase});
    snprintf(key, sizeof key, ".motion");
    for (size_t k = 0; k < m->swing_count && !still; ++k) {
        still = is_still(m->swings[k]);
        snprintf(key, sizeof key, ".motion.swings[%zu]", k);
    }
    if (!still)
        return;
    sph2d_diagnostic *w = sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_MISSING_KEY,
                                           i == TANK ? key + 1 : sph2d__check_wall_path(c, path, i, key),
                                           "has an amplitude or angle but no frequency: it moves nothing");
    sph2d_diagnostic_hint(w, "give `frequency`, in 1/s; a `path` goes somewhere once");
}

/* ---- velocity ---------------------------------------------------------------------------------------------------- */

/** A jump of velocity [m/s], and its time [s]. */
typedef struct velocity_jump {
    double speed, time;
} velocity_jump;

/** What jumps: an obstacle, or without one the tank. */
typedef struct jumper {
    const sph2d_scene *scene;
    const sph2d__wall *wall;
    const sph2d__course *course;
    double radius; /**< of the tank, about which it turns [m] */
} jumper;

/** Whether liquid may be on the left (1) or right (-1) of a face of an obstacle: where it starts, and anywhere outside the
 *  solid if it comes from elsewhere. */
static bool is_wet(const jumper *j, const sph2d__segment *face, int side)
{
    enum { SAMPLES = 16 };
    const sph2d_scene *s = j->scene;
    const double x = face->b.x - face->a.x, y = face->b.y - face->a.y, length = hypot(x, y);
    const bool bends = j->wall->shape.kind == SPH2D_SHAPE_CIRCLE || j->wall->shape.kind == SPH2D_SHAPE_ARC;
    const double away = (bends ? fmax(s->spacing, length / 8) : s->spacing) * side; /* also from the arc of a chord */
    const bool anywhere = s->particles.file || s->particles.count > 0 || s->source_count > 0 || s->opening_count > 0 ||
                          sph2d__starts_from_snapshot(s);
    bool wet = false;
    for (int k = 0; k < SAMPLES && !wet; ++k) {
        const double along = (k + 0.5) / SAMPLES;
        const sph2d_vec2 p = {face->a.x + along * x - away * y / length, face->a.y + along * y + away * x / length};
        wet = (anywhere || sph2d__in_block(s, p)) && !sph2d__wall_fills(s, j->wall, p);
    }
    return wet;
}

/** The largest speed of faces towards liquid that touches them, as the obstacle is drawn: a wall that slides along itself, or
 *  goes away, pushes nothing. */
static double speed_across(const jumper *j, sph2d_vec2 change, double turn)
{
    const sph2d_shape *outline = &j->wall->shape;
    const double size = fmax(j->scene->spacing, sph2d__shape_distance(outline, sph2d_shape_centroid(outline)) / 32);
    const size_t faces = sph2d__shape_pieces(outline, size);
    double largest = 0;
    for (size_t k = 0; k < faces; ++k) {
        const sph2d__segment face = sph2d__shape_piece(outline, size, k);
        const double x = face.b.x - face.a.x, y = face.b.y - face.a.y, length = hypot(x, y);
        if (!(length > 0))
            continue;
        double speed[2] = {0, 0}; /* to the right and left */
        for (int end = 0; end < 2; ++end) {
            const sph2d_vec2 p = end ? face.b : face.a;
            const double vx = change.x - turn * (p.y - j->course->center.y),
                         vy = change.y + turn * (p.x - j->course->center.x), left = (vy * x - vx * y) / length;
            speed[left > 0] = fmax(speed[left > 0], fabs(left));
        }
        for (int left = 0; left < 2; ++left)
            if (speed[left] > largest && is_wet(j, &face, left ? 1 : -1))
                largest = speed[left];
    }
    return largest;
}

static void note_jump(velocity_jump *largest, const jumper *j, const sph2d__pose *before, const sph2d__pose *after,
                      double time)
{
    const double x = after->velocity.x - before->velocity.x, y = after->velocity.y - before->velocity.y,
                 turn = after->omega - before->omega, c = cos(after->angle), s = sin(after->angle);
    const double speed = j->wall ? speed_across(j, (sph2d_vec2){c * x + s * y, c * y - s * x}, turn)
                                 : hypot(x, y) + fabs(turn) * j->radius;
    if (speed > largest->speed)
        *largest = (velocity_jump){speed, time};
}

/** The velocity that a motion has at once at its start. */
static velocity_jump jump_at_start(const jumper *j)
{
    sph2d__pose rest = {.angle = 0}, start = sph2d__course_at(j->course, 0);
    velocity_jump jump = {0, 0};
    note_jump(&jump, j, &rest, &start, 0);
    return jump;
}

/** The largest velocity jump of a motion after its start and before an end: at a point of its path. */
static velocity_jump largest_jump(const jumper *j, double end)
{
    const double BEFORE = 1e-9; /* of the time between two points */
    const sph2d_pose_path *path = &j->course->motion->path;
    velocity_jump largest = {0, 0};
    for (size_t k = 0; k < path->count; ++k) {
        double t = path->items[k].t, span = k > 0 ? t - path->items[k - 1].t : 1;
        if (!(t > 0 && t < end))
            continue;
        sph2d__pose before = sph2d__course_at(j->course, t - BEFORE * span), after = sph2d__course_at(j->course, t);
        note_jump(&largest, j, &before, &after, t);
    }
    return largest;
}

/* Without sound a jump is worth a word from this part of the speed of liquid that falls as far as it can. */
static const double BLOW = 0.1;

/** Warns of a jump that `costs` something, and proposes to accelerate over a time [s]. */
static void warn_of_jump(checker *c, size_t i, const velocity_jump *hit, const char *costs, double time)
{
    char path[PATH_SIZE];
    sph2d_diagnostic *w =
        sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_CONFLICT, sph2d__check_wall_path(c, path, i, ".motion"),
                         "its velocity jumps by %.2g m/s at t = %g s, %s", hit->speed, hit->time, costs);
    const sph2d_motion *m = &c->world->walls[i].motion;
    bool end =
        m->path.count > 0 && (hit->time == m->path.items[0].t || hit->time == m->path.items[m->path.count - 1].t);
    if (end && m->between == SPH2D_BETWEEN_CUBIC)
        sph2d_diagnostic_hint(w,
                              "let it accelerate over %.2g s or longer: a cubic path begins and ends at rest only by "
                              "three equal points close together",
                              time);
    else
        sph2d_diagnostic_hint(w,
                              "let it accelerate over %.2g s or longer: by a `ramp` of oscillations and rates, by "
                              "`between: cubic` with three equal points close together where it rests, or start an "
                              "oscillation at rest by `phase: -1.5708`",
                              time);
}

/** Warns of velocity jumps of walls. Methods that have sound compress liquid by v/c0, a pressure of rho c0 v. With
 *  others it is an impact: the wall, at its new velocity, does the work J v, of which liquid keeps J v/2. By a jump of
 *  0.5 m/s of a piston in water 0.5 m deep `constraint` lost 17 to 21 J/m, and 0.543 rho h^2 v^2/2 (Westergaard 1933)
 *  are 17; over 10 spacings/sqrt(2 head) of a constant acceleration it lost 1.4. */
static void check_velocity_jump(checker *c, size_t i, const sph2d__course *course)
{
    const jumper wall = {c->scene, &c->world->walls[i], course, 0};
    velocity_jump hit = largest_jump(&wall, INFINITY), first = jump_at_start(&wall);
    if (first.speed >= hit.speed)
        hit = first;
    const sph2d_method_options m = c->scene->method;
    const sph2d__derived *d = &c->world->derived;
    double c0 = d->sound_speed, fall = sqrt(2 * d->head), dx = c->scene->spacing;
    char costs[160];
    if (sph2d__method_row_of(&m)->has_sound && hit.speed > m.max_compression * c0) {
        snprintf(costs, sizeof costs, "which compresses the liquid in front by %.2g %%, to %.2g Pa",
                 100 * hit.speed / c0, c->scene->fluid.density * c0 * hit.speed);
        warn_of_jump(c, i, &hit, costs, 10 * m.support_ratio * dx / c0);
    } else if (!sph2d__method_row_of(&m)->has_sound && hit.speed > BLOW * fall) {
        snprintf(costs, sizeof costs,
                 "an impact: it loses up to %.2g J for each kilogram of liquid that it stops or sets moving",
                 hit.speed * hit.speed / 2);
        warn_of_jump(c, i, &hit, costs, 10 * dx / fall);
    }
}

/* ---- cubics ------------------------------------------------------------------------------------------------------ */

/** How far a cubic path goes beyond the range of its points. */
typedef struct excess {
    double length, amount, time; /**< of its farthest point [m], [m] or [rad], [s] */
    const char *what;
} excess;

/** Compares one part of the path, of which `reach` makes a length [m]. */
static void note_excess(excess *most, const char *what, double low, double value, double high, double reach,
                        double time)
{
    double amount = fmax(low - value, value - high);
    if (amount * reach > most->length)
        *most = (excess){amount * reach, amount, time, what};
}

static excess largest_excess(const sph2d__course *course, double radius)
{
    enum { PARTS = 16 };
    const sph2d_pose_path *path = &course->motion->path;
    sph2d_pose_point low = path->items[0], high = low;
    for (size_t k = 1; k < path->count; ++k) {
        const sph2d_pose_point *p = &path->items[k];
        low = (sph2d_pose_point){0, fmin(low.x, p->x), fmin(low.y, p->y), fmin(low.angle, p->angle)};
        high = (sph2d_pose_point){0, fmax(high.x, p->x), fmax(high.y, p->y), fmax(high.angle, p->angle)};
    }
    excess most = {0, 0, 0, ""};
    for (size_t k = 1; k < path->count; ++k)
        for (int part = 1; part < PARTS; ++part) {
            double from = path->items[k - 1].t, time = from + (path->items[k].t - from) * part / PARTS;
            sph2d_pose_point p = sph2d__course_path_at(course, time);
            note_excess(&most, "m beyond its points in x", low.x, p.x, high.x, 1, time);
            note_excess(&most, "m beyond its points in y", low.y, p.y, high.y, 1, time);
            note_excess(&most, "rad beyond its points in angle", low.angle, p.angle, high.angle, radius, time);
        }
    return most;
}

/** Warns of cubics that overshoot: through a gate's rest, opening by 0.5 m in 0.4 s, and rest the cubic went 24 mm below
 *  the floor on which it stood; with three points 10 ms apart at each rest, a quarter of a millimetre. */
static void check_excess(checker *c, size_t i, const sph2d__course *course)
{
    if (!course->bends)
        return;
    char path[PATH_SIZE];
    excess most = largest_excess(course, sph2d__shape_distance(&c->world->walls[i].shape, course->center));
    if (!(most.length > c->scene->spacing / 10))
        return;
    sph2d_diagnostic *w =
        sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_CONFLICT, sph2d__check_wall_path(c, path, i, ".motion"),
                         "its cubic path goes %.2g %s at t = %.3g s", most.amount, most.what, most.time);
    sph2d_diagnostic_hint(w, "begin and end a rest by three equal points close together, or use `between: lines` and "
                             "more points");
}

/* ---- all of them ------------------------------------------------------------------------------------------------- */

/** A motion starts where the scene draws the obstacle: the liquid is placed around it there. */
static bool starts_in_place(checker *c, size_t i, const sph2d__course *course)
{
    sph2d__pose start = sph2d__course_at(course, 0);
    double radius = sph2d__shape_distance(&c->world->walls[i].shape, course->center);
    double shift = hypot(start.displacement.x, start.displacement.y) + fabs(start.angle) * radius;
    if (shift <= c->scene->spacing / 10)
        return true;
    char message[120];
    snprintf(message, sizeof message, "takes it away from its place in the scene by %.3g m already at t = 0", shift);
    fault(c, i, SPH2D_CODE_CONFLICT, "", message,
          "draw it where it starts, and begin the path with [0, 0, 0]: a path is a displacement");
    return false;
}

static void follow(checker *c, size_t i, sph2d__memory *memory, unsigned char *hits)
{
    const sph2d__wall *o = &c->world->walls[i];
    size_t count = sph2d__motion_bends(&o->motion);
    void *bends = count ? sph2d__alloc(memory, count, sizeof(sph2d_pose_point)) : NULL;
    sph2d__course course = sph2d__course_of(&o->motion, &o->shape, bends);
    if (starts_in_place(c, i, &course)) {
        check_velocity_jump(c, i, &course);
        check_excess(c, i, &course);
        sph2d__check_way(c, i, &course, hits);
    }
    sph2d__release(memory, &bends, count, sizeof(sph2d_pose_point));
}

/* ---- the tank ---------------------------------------------------------------------------------------------------- */

/** The tank's velocity must not jump while it runs: liquid in it would not feel the jump. */
static void refuse_jump(checker *c, const velocity_jump *jump)
{
    char message[160];
    snprintf(message, sizeof message,
             "the tank's velocity jumps by %.2g m/s at t = %.4g s, which liquid in it cannot "
             "feel: only accelerations act on it",
             jump->speed, jump->time);
    fault(c, TANK, SPH2D_CODE_CONFLICT, "path", message,
          c->scene->motion.between == SPH2D_BETWEEN_LINES
              ? "use `between: cubic`, and let the path begin and end at rest by three equal points"
              : "a cubic path begins and ends at rest only by three equal points close together");
}

/** What the tank has at t = 0 the liquid in it has, too: only changes of its velocity act on liquid. */
static void warn_of_start(checker *c, const velocity_jump *start)
{
    sph2d_diagnostic *w = sph2d_report_add(
        c->report, SPH2D_WARNING, SPH2D_CODE_CONFLICT, "motion",
        "the tank moves at up to %.2g m/s at t = 0 already, and its liquid with it: the liquid feels no start",
        start->speed);
    sph2d_diagnostic_hint(w, "to start from rest use a `ramp`, an oscillation with `phase: -1.5708`, or a cubic path "
                             "that begins by three equal points");
}

static void check_tank(checker *c, sph2d__memory *memory)
{
    const double SMALL = 1e-2; /* of the largest speed: the ends of splines through measured points */
    const sph2d_scene *scene = c->scene;
    size_t count = sph2d__tank_bends(scene);
    void *bends = count ? sph2d__alloc(memory, count, sizeof(sph2d_pose_point)) : NULL;
    sph2d__course tank = sph2d__tank_course(scene, bends);
    double radius = hypot(scene->domain.max.x - scene->domain.min.x, scene->domain.max.y - scene->domain.min.y) / 2;
    const jumper whole = {scene, NULL, &tank, radius};
    velocity_jump start = jump_at_start(&whole), later = largest_jump(&whole, scene->run.until);
    double small = SMALL * sph2d__course_speed(&tank, radius);
    if (later.speed > small)
        refuse_jump(c, &later);
    else if (start.speed > small)
        warn_of_start(c, &start);
    sph2d__release(memory, &bends, count, sizeof(sph2d_pose_point));
}

/** Gravity in time, by its path or its file. */
static void check_gravity(checker *c)
{
    const sph2d_path *path = &c->scene->gravity_path;
    sph2d__check_times(c, path->count > 0 ? &path->items[0].t : NULL, path->count, 3, "gravity_path");
    if (path->count > MAX_POINTS)
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "gravity_path", "has more than 5000 points: leave some out");
    if (c->scene->gravity_file)
        sph2d__check_fault(c, path->count > 0 ? SPH2D_CODE_CONFLICT : SPH2D_CODE_MISSING_KEY, "gravity_file",
                           path->count > 0
                               ? "gives the gravity_path, which is given, too: leave out one of the two"
                               : "was not read: only a scene that is read from a file has files; give its rows as "
                                 "`gravity_path`");
}

void sph2d__check_motion_keys(checker *c)
{
    check_keys(c, TANK);
    check_swings(c, TANK);
    check_gravity(c);
    for (size_t i = SPH2D__WALL_OBSTACLE; i < c->world->first_body; ++i) {
        check_keys(c, i);
        check_swings(c, i);
    }
}

void sph2d__check_motions(checker *c)
{
    size_t count = c->world->wall_count;
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    void *hits = sph2d__alloc(&memory, count, 1);
    if (sph2d__motion_moves(&c->scene->motion))
        check_tank(c, &memory);
    for (size_t i = SPH2D__WALL_OBSTACLE; hits && i < count; ++i)
        if (sph2d__motion_moves(&c->world->walls[i].motion))
            follow(c, i, &memory, hits);
    sph2d__release(&memory, &hits, count, 1);
}
