/* SPDX-License-Identifier: MIT */
/** @file derive.c
 *  What follows from a scene: head, sound speed, lengths; and the defaults that follow from these. */
#include "scene/derive.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "scene/bodies.h"
#include "scene/frame.h"
#include "scene/liquid.h"
#include "scene/method_table.h"
#include "scene/motion.h"
#include "scene/openings.h"
#include "scene/resolve.h"
#include "scene/shape.h"

/** Largest distance of a shape's corners from a point. */
static double farthest(const sph2d_shape *shape, sph2d_vec2 c)
{
    sph2d_box b = sph2d__shape_bounds(shape);
    double x = fmax(fabs(b.min.x - c.x), fabs(b.max.x - c.x)), y = fmax(fabs(b.min.y - c.y), fabs(b.max.y - c.y));
    return shape->kind == SPH2D_SHAPE_CIRCLE ? fmax(x, y) : hypot(x, y);
}

/** Largest distance of a block's corners from the centre of the central force. */
static double farthest_liquid(const sph2d_scene *scene)
{
    double distance = 0;
    for (size_t i = 0; i < scene->block_count; ++i)
        distance = fmax(distance, farthest(&scene->blocks[i].shape, scene->central_force.center));
    return distance;
}

/** Largest speed of a block at the start. Flows whose speed grows with the distance from their centre have the one that
 *  they name at their length, and the block may go on beyond it. */
static double block_speed(const sph2d_block *block)
{
    const sph2d_flow *f = &block->start.flow;
    bool grows = f->kind == SPH2D_FLOW_ROTATION || f->kind == SPH2D_FLOW_PATCH || f->kind == SPH2D_FLOW_STRAIN ||
                 f->kind == SPH2D_FLOW_DROP;
    double beyond = grows ? farthest(&block->shape, (sph2d_vec2){f->center[0], f->center[1]}) / f->length : 1;
    double most = beyond > 1 + 1e-9 ? beyond : 1; /* a disc as large as its flow has the speed to the bit */
    return hypot(block->velocity.x, block->velocity.y) + most * sph2d__start_speed(&block->start);
}

/** Pressure over density by which surface tension presses on the thinnest block, sigma/(rho R) with R half of its smaller
 *  side. A block from side to side has a flat surface. */
static double capillary_head(const sph2d_scene *scene)
{
    double width = scene->domain.max.x - scene->domain.min.x, height = scene->domain.max.y - scene->domain.min.y;
    double radius = INFINITY;
    for (size_t i = 0; i < scene->block_count; ++i) {
        sph2d_box b = sph2d__shape_bounds(&scene->blocks[i].shape);
        double x = b.max.x - b.min.x, y = b.max.y - b.min.y;
        if (x < width - scene->spacing && y < height - scene->spacing)
            radius = fmin(radius, fmin(x, y) / 2);
    }
    return scene->fluid.surface_tension / (scene->fluid.density * radius);
}

/** Largest speed of a wall by its motion. Without memory for the cubics of its path they count as straight lines. */
static double motion_speed(const sph2d__wall *wall)
{
    const sph2d_motion *m = &wall->motion;
    if (!sph2d__motion_moves(m))
        return 0;
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    size_t count = sph2d__motion_bends(m);
    void *bends = count ? sph2d__alloc(&memory, count, sizeof(sph2d_pose_point)) : NULL;
    sph2d__course course = sph2d__course_of(m, &wall->shape, bends);
    double speed = sph2d__course_speed(&course, sph2d__shape_distance(&wall->shape, course.center));
    sph2d__release(&memory, &bends, count, sizeof(sph2d_pose_point));
    return speed;
}

/** Largest speed of a wall. */
static double wall_speed(const sph2d__world *world)
{
    const sph2d_scene *scene = &world->scene;
    const sph2d_side_speeds *s = &scene->wall_speeds;
    double speed = fmax(fmax(fabs(s->left), fabs(s->right)), fmax(fabs(s->bottom), fabs(s->top)));
    for (size_t k = SPH2D__WALL_OBSTACLE; k < world->wall_count; ++k)
        speed = fmax(speed, motion_speed(&world->walls[k]));
    for (size_t k = 0; k < scene->body_count; ++k)
        speed = fmax(speed, sph2d__body_speed(&scene->bodies[k]));
    return speed;
}

/** The largest height of a body's centre of mass above the lowest corner of the domain, from which it falls. */
static double height_of_bodies(const sph2d__world *world)
{
    const sph2d_scene *scene = &world->scene;
    double height = 0;
    sph2d_vec2 up = world->gravity.up;
    sph2d_vec2 low = {up.x > 0 ? scene->domain.min.x : scene->domain.max.x,
                      up.y > 0 ? scene->domain.min.y : scene->domain.max.y};
    for (size_t k = 0; k < scene->body_count; ++k) {
        sph2d_vec2 c = sph2d__body_mass(&scene->bodies[k]).center;
        if (scene->bodies[k].hold.x == SPH2D_SWITCH_OFF || scene->bodies[k].hold.y == SPH2D_SWITCH_OFF)
            height = fmax(height, (c.x - low.x) * up.x + (c.y - low.y) * up.y);
    }
    return height;
}

/** Height from which the liquid can fall: in a tank that tilts, by the rise of its floor more than at rest, and at most
 *  the domain's diagonal. */
static double height_of(const sph2d__world *world, const sph2d__drive *drive, double extra_head)
{
    const sph2d_scene *scene = &world->scene;
    double width = scene->domain.max.x - scene->domain.min.x, height = scene->domain.max.y - scene->domain.min.y;
    double g0 = world->gravity.size;
    if (!(g0 > 0))
        return drive->gravity > 0 ? hypot(width, height) : 0;
    double across = (width * fabs(scene->gravity.y) + height * fabs(scene->gravity.x)) / g0;
    double still = fmax(sph2d__basin_height(world, extra_head), height_of_bodies(world));
    return drive->tilt > 0 ? fmin(still + across * drive->tilt, hypot(width, height)) : still;
}

/** What springs of bodies that are stretched at the start add: what is as fast by them makes pressure, but there may be
 *  little of it, so that their energy counts by itself. */
static void add_springs(const sph2d_scene *scene, sph2d__derived *d)
{
    double speed = d->speed;
    for (size_t k = 0; k < scene->body_count; ++k) {
        const sph2d_body *body = &scene->bodies[k];
        d->speed = fmax(d->speed, hypot(sph2d__body_speed(body), sph2d__spring_speed(body)));
        for (size_t i = 0; i < body->spring_count; ++i)
            d->spring_energy += sph2d__spring_energy(body, &body->springs[i]);
    }
    d->spring_head = (d->speed * d->speed - speed * speed) / 2;
}

/** What follows from the world; what liquid a file holds, a resumed run does not know, so that nothing follows from it. */
static sph2d__derived derived_of(const sph2d__world *world)
{
    const sph2d_scene *scene = &world->scene;
    const sph2d_method_options method = scene->method;
    const bool from_file = sph2d__liquid_is_from_file(scene);
    sph2d__derived d = {0};
    d.support_radius = method.support_ratio * scene->spacing;
    d.reach = sph2d__scene_reach(scene);
    d.mass = scene->fluid.density * scene->spacing * scene->spacing;
    const sph2d__drive drive = sph2d__scene_drive(scene);
    double g = d.gravity = drive.gravity;
    for (size_t i = 0; i < scene->block_count; ++i)
        d.speed = fmax(d.speed, block_speed(&scene->blocks[i]));
    for (size_t i = 0; i < scene->source_count; ++i)
        d.speed = fmax(d.speed, scene->sources[i].speed);
    for (size_t i = 0; i < scene->opening_count; ++i)
        d.speed = fmax(d.speed, sph2d__opening_speed(scene, &scene->openings[i]));
    d.speed = fmax(d.speed, sph2d__throat_speed(world));
    for (size_t i = 0; !scene->particles.file && i < scene->particles.count; ++i)
        d.speed = fmax(d.speed, hypot(scene->particles.items[i].vx, scene->particles.items[i].vy));
    d.speed = fmax(d.speed, sph2d__start_speed(&scene->start));
    d.speed = fmax(fmax(d.speed, wall_speed(world)), drive.speed);
    add_springs(scene, &d);
    for (size_t i = 0; i < scene->interaction_count; ++i)
        d.pull = fmax(d.pull, fabs(scene->interactions[i].acceleration) * scene->interactions[i].radius / 2);
    double central_speed = scene->central_force.rate * farthest_liquid(scene);
    d.pull += central_speed * central_speed / 2;
    double pressed = 0; /* by openings, as by a column of liquid */
    for (size_t i = 0; i < scene->opening_count; ++i)
        if (sph2d__opening_kind_of(&scene->openings[i]) == SPH2D__OPENING_PRESSURE)
            pressed = fmax(pressed, sph2d__opening_largest(&scene->openings[i]) / scene->fluid.density);
    d.pull += sph2d__slowing_head(scene);
    d.height = g > 0 ? height_of(world, &drive, (d.speed * d.speed / 2 + d.pull) / g) : 0;
    d.pull += fmax(pressed - g * d.height, 0);
    d.head = g * d.height + d.speed * d.speed / 2 + d.pull;
    d.capillary_head = capillary_head(scene);
    d.ripple_speed = sqrt(8 * scene->fluid.surface_tension / (scene->fluid.density * scene->spacing));
    const sph2d__method_row *row = sph2d__method_row_of(&method);
    d.soft_compression = row->sound_compression * method.max_compression;
    d.stiffness_part = row->stiffness_part ? row->stiffness_part(d.support_radius, scene->spacing) : 1;
    d.natural_speed = fmax(sqrt(SPH2D__OVERSHOOT * d.head / d.soft_compression), d.ripple_speed);
    d.sound_speed = method.sound_speed > 0 ? method.sound_speed : sqrt(d.stiffness_part * method.stiffness);
    if (!(d.sound_speed > 0))
        d.sound_speed = d.natural_speed;
    if (from_file)
        d.head = fmax(d.head, d.soft_compression * d.sound_speed * d.sound_speed / SPH2D__OVERSHOOT);
    return d;
}

double sph2d_scene_particles(const sph2d_scene *scene)
{
    if (!scene)
        return 0;
    double width = scene->domain.max.x - scene->domain.min.x, height = scene->domain.max.y - scene->domain.min.y;
    double dx = scene->spacing, count = (double)scene->particles.count;
    for (size_t i = 0; i < scene->block_count; ++i) {
        double spacing = scene->blocks[i].spacing > 0 ? scene->blocks[i].spacing : dx;
        count += fmin(sph2d__shape_area(&scene->blocks[i].shape), width * height) / (spacing * spacing);
    }
    if (sph2d__starts_from_snapshot(scene))
        count += (double)scene->start.snapshot.count * pow(scene->start.snapshot.spacing / dx, 2);
    const sph2d_boundary *b = &scene->boundary; /* beyond open sides walls go on for the length of the domain */
    double wide = width * (1 + (b->left == SPH2D_SIDE_OPEN) + (b->right == SPH2D_SIDE_OPEN));
    double tall = height * (1 + (b->bottom == SPH2D_SIDE_OPEN) + (b->top == SPH2D_SIDE_OPEN));
    double length = ((b->left == SPH2D_SIDE_WALL) + (b->right == SPH2D_SIDE_WALL)) * tall +
                    ((b->bottom == SPH2D_SIDE_WALL) + (b->top == SPH2D_SIDE_WALL)) * wide;
    sph2d_wall_form form = sph2d__side_form(scene);
    double support = sph2d__method_resolve(scene->method).support_ratio;
    double layers = form == SPH2D_WALL_GENERALISED ? ceil(support - 1e-9) : form == SPH2D_WALL_SPRING ? 0 : 1;
    return count + length / dx * layers;
}

/* ---- defaults that follow ---------------------------------------------------------------------------------------- */

/* Shear that is a hundred times slower than that of the scene: a plug in a channel then creeps by 1 % of its velocity. */
static const double SLOWER = 100;

/** The regularisation of the liquid: the scene's, or by default 100 L/sqrt(2 E), L the smaller side of the domain and E
 *  the head, and 1 s where that is 0; 0 for liquids without one [s]. */
static double regularisation_of(const sph2d__world *world)
{
    const sph2d_scene *scene = &world->scene;
    const sph2d_fluid *f = &scene->fluid;
    if (f->regularisation > 0 || f->model == SPH2D_RHEOLOGY_NEWTONIAN || f->model == SPH2D_RHEOLOGY_CARREAU)
        return f->regularisation;
    double width = scene->domain.max.x - scene->domain.min.x, height = scene->domain.max.y - scene->domain.min.y;
    double head = world->derived.head;
    return head > 0 ? SLOWER * fmin(width, height) / sqrt(2 * head) : 1;
}

/** The rise time of gauges that have none of their own [s].
 *
 *  Sound between a floor and a free surface at a distance h has the period 4 h/c0 at most (a quarter of a wave stands
 *  there), and liquid that is slightly compressible rings with it and its overtones after every impact, as water of its
 *  sound speed would. What is shorter says nothing of the liquid meant, whose sound is far faster. */
static double rise_time_of_gauges(const sph2d__world *world)
{
    const sph2d__derived *d = &world->derived;
    if (!(d->gravity > 0 && d->sound_speed > 0))
        return 0;
    /* What liquid a file has, a resumed run does not know: its height is the one that the sound speed is for. */
    const double head = d->soft_compression * d->sound_speed * d->sound_speed / SPH2D__OVERSHOOT;
    return 4 * (sph2d__liquid_is_from_file(&world->scene) ? head / d->gravity : d->height) / d->sound_speed;
}

/** The largest value of a quantity that the world's head suggests; 0 for others. */
static double largest_expected(const sph2d__world *world, const char *name)
{
    const sph2d_scene *scene = &world->scene;
    const double head = world->derived.head;
    if (strcmp(name, "speed") == 0)
        return sqrt(2 * head);
    if (strcmp(name, "vorticity") == 0) /* shear that is ten times that of the scene: layers and eddies */
        return 10 * sqrt(2 * head) /
               fmin(scene->domain.max.x - scene->domain.min.x, scene->domain.max.y - scene->domain.min.y);
    return strcmp(name, "Pressures") == 0 ? scene->fluid.density * head : 0;
}

/** The frames with the defaults that follow from the head: the ends of the colour bar 0 and sqrt(2 head) for
 *  speed, density * head for pressure, ten times that speed over the domain's smaller side, with either sign, for
 *  vorticity, (0, 0) for other fields; the speed of arrows, which streamlines know, too, sqrt(2 head); isolines a round
 *  number near a tenth of these. */
static sph2d_frames frames_of(const sph2d__world *world)
{
    static const double lines = 10; /* to that value */
    sph2d_frames frames = world->scene.run.frames;
    if (frames.color && frames.color_range.x == 0 && frames.color_range.y == 0) {
        frames.color_range.y = largest_expected(world, frames.color);
        if (strcmp(frames.color, "vorticity") == 0) /* of either sign */
            frames.color_range.x = 0 - frames.color_range.y;
    }
    const bool of_speed = frames.arrows == SPH2D_SWITCH_ON || frames.streamlines == SPH2D_SWITCH_ON;
    if (of_speed && frames.arrow_speed == 0)
        frames.arrow_speed = largest_expected(world, "speed");
    if (frames.isolines && frames.isoline_step == 0) {
        const double step = largest_expected(world, frames.isolines) / lines;
        const double power = step > 0 ? pow(10, floor(log10(step))) : 0, lead = step > 0 ? step / power : 0;
        frames.isoline_step = power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
    }
    return frames;
}

/** Gives probes what they have by default. False when memory is short. */
static bool resolve_probes(sph2d__world *world, sph2d__arena *arena, sph2d__memory *memory)
{
    sph2d_scene *scene = &world->scene;
    sph2d_probe *probes = sph2d__arena_alloc(arena, memory, scene->probe_count + 1, sizeof *probes);
    if (!probes)
        return false;
    for (size_t i = 0; i < scene->probe_count; ++i) {
        probes[i] = scene->probes[i];
        if (probes[i].kind == SPH2D_PROBE_PRESSURE && isnan(probes[i].rise_time))
            probes[i].rise_time = rise_time_of_gauges(world);
        probes[i].at.x = isnan(probes[i].at.x) ? 0 : probes[i].at.x;
        probes[i].at.y = isnan(probes[i].at.y) ? 0 : probes[i].at.y; /* of an elevation, too, which ignores it */
    }
    scene->probes = probes;
    return true;
}

sph2d_status sph2d__derive(sph2d__world *world, sph2d__arena *arena, sph2d__memory *memory)
{
    world->derived = derived_of(world);
    world->scene.fluid.regularisation = regularisation_of(world);
    world->scene.run.frames = frames_of(world);
    return resolve_probes(world, arena, memory) ? SPH2D_OK : SPH2D_NOMEM;
}
