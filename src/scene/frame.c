/* SPDX-License-Identifier: MIT */
/** @file frame.c */
#include "scene/frame.h"

#include <math.h>

#include "base/memory.h"

bool sph2d__scene_is_driven(const sph2d_scene *scene)
{
    return scene->gravity_path.count > 0 || sph2d__motion_moves(&scene->motion);
}

size_t sph2d__tank_bends(const sph2d_scene *scene)
{
    sph2d_motion motion = scene->motion;
    if (motion.between == SPH2D_BETWEEN_DEFAULT)
        motion.between = SPH2D_BETWEEN_CUBIC;
    return sph2d__motion_bends(&motion);
}

sph2d__course sph2d__tank_course(const sph2d_scene *scene, sph2d_pose_point *bends)
{
    sph2d_shape tank = {.kind = SPH2D_SHAPE_BOX, .box = scene->domain};
    return sph2d__course_of(&scene->motion, &tank, bends);
}

/** Gravity at a time: straight lines between the points of its path, constant before and after. */
static sph2d_vec2 gravity_at(const sph2d_scene *scene, double time)
{
    const sph2d_path *path = &scene->gravity_path;
    if (path->count == 0)
        return scene->gravity;
    const sph2d_path_point *p = path->items, *last = &p[path->count - 1];
    if (time <= p->t)
        return (sph2d_vec2){p->x, p->y};
    while (p < last && time >= p[1].t)
        ++p;
    if (p == last)
        return (sph2d_vec2){p->x, p->y};
    double part = (time - p->t) / (p[1].t - p->t);
    return (sph2d_vec2){p->x + part * (p[1].x - p->x), p->y + part * (p[1].y - p->y)};
}

sph2d__frame sph2d__frame_at(const sph2d_scene *scene, const sph2d__course *tank, double time)
{
    if (!sph2d__scene_is_driven(scene))
        return (sph2d__frame){.moves = false};
    sph2d__pose pose = sph2d__course_at(tank, time);
    sph2d_vec2 g = gravity_at(scene, time);
    g = sph2d__pose_turn_back(&pose, (sph2d_vec2){g.x - pose.acceleration.x, g.y - pose.acceleration.y});
    return (sph2d__frame){.moves = true,
                          .center = pose.center,
                          .uniform = {g.x - scene->gravity.x, g.y - scene->gravity.y},
                          .omega = pose.omega,
                          .alpha = pose.alpha};
}

/* ---- extremes ---------------------------------------------------------------------------------------------------- */

/* Looks at oscillations: so many, and so many in each period of the fastest one; of several at so many periods of the
 * slowest one, after which the largest sum of all grows slowly. */
static const double FEWEST_LOOKS = 1000, MOST_LOOKS = 20000, LOOKS_PER_PERIOD = 40, PERIODS = 100;
/* Looks from one point of a path to the next: between them accelerations are straight lines, angles are not. */
enum { PARTS = 4 };

static void look(const sph2d_scene *scene, const sph2d__course *tank, double time, sph2d__drive *drive)
{
    sph2d__frame f = sph2d__frame_at(scene, tank, time);
    sph2d_vec2 g0 = scene->gravity, g = {f.uniform.x + g0.x, f.uniform.y + g0.y};
    double size = hypot(g.x, g.y), size0 = hypot(g0.x, g0.y), along = g.x * g0.x + g.y * g0.y;
    drive->gravity = fmax(drive->gravity, size);
    if (size > 0 && size0 > 0)
        drive->tilt = fmax(drive->tilt, along > 0 ? fabs(g.x * g0.y - g.y * g0.x) / (size * size0) : 1);
}

/** Looks along the paths of the tank and of gravity. Where nothing else moves, the largest gravity is at one of their
 *  points. */
static void look_at_paths(const sph2d_scene *scene, const sph2d__course *tank, sph2d__drive *drive)
{
    const sph2d_pose_path *path = &scene->motion.path;
    for (size_t k = 0; k < path->count; ++k) {
        const sph2d_pose_point *p = &path->items[k];
        double span = k + 1 < path->count ? p[1].t - p->t : 0;
        for (int part = 0; part < (span > 0 ? PARTS : 1); ++part)
            look(scene, tank, p->t + span * part / PARTS, drive);
    }
    for (size_t k = 0; k < scene->gravity_path.count; ++k)
        look(scene, tank, scene->gravity_path.items[k].t, drive);
}

/** Looks at oscillations from the start on, until ramp and paths have ended and some periods more. */
static void look_at_swings(const sph2d_scene *scene, const sph2d__course *tank, sph2d__drive *drive)
{
    const double GOLDEN = 0.6180339887498949; /* in step with no oscillation */
    const sph2d_motion *m = &scene->motion;
    sph2d__frequencies f = sph2d__motion_frequencies(m);
    double end = m->ramp;
    if (m->path.count > 0)
        end = fmax(end, m->path.items[m->path.count - 1].t);
    if (scene->gravity_path.count > 0)
        end = fmax(end, scene->gravity_path.items[scene->gravity_path.count - 1].t);
    end += (f.highest > f.lowest ? PERIODS : 1) / f.lowest;
    double looks = fmin(fmax(FEWEST_LOOKS, LOOKS_PER_PERIOD * f.highest * end), MOST_LOOKS);
    for (double k = 0; k < looks; ++k)
        look(scene, tank, end * (k * GOLDEN - floor(k * GOLDEN)), drive);
}

sph2d__drive sph2d__scene_drive(const sph2d_scene *scene)
{
    const sph2d_box d = scene->domain;
    sph2d__drive drive = {hypot(scene->gravity.x, scene->gravity.y), 0, 0};
    if (!sph2d__scene_is_driven(scene))
        return drive;
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    size_t count = sph2d__tank_bends(scene);
    void *bends = count ? sph2d__alloc(&memory, count, sizeof(sph2d_pose_point)) : NULL;
    sph2d__course tank = sph2d__tank_course(scene, bends);
    look_at_paths(scene, &tank, &drive);
    if (sph2d__motion_frequencies(&scene->motion).highest > 0)
        look_at_swings(scene, &tank, &drive);
    if (scene->motion.rate != 0)
        drive.tilt = 1; /* it turns over in time */
    sph2d_vec2 far = {fmax(tank.center.x - d.min.x, d.max.x - tank.center.x),
                      fmax(tank.center.y - d.min.y, d.max.y - tank.center.y)};
    drive.speed = sph2d__course_speed(&tank, hypot(far.x, far.y));
    sph2d__release(&memory, &bends, count, sizeof(sph2d_pose_point));
    return drive;
}
