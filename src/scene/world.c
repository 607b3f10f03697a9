/* SPDX-License-Identifier: MIT */
/** @file world.c
 *  A world as a scene draws it, and its walls: numbers, names, and what each is by default. */
#include "scene/world.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "scene/method_table.h"
#include "scene/motion.h"
#include "scene/resolve.h"
#include "scene/shape.h"

static const char *const words[SPH2D__WALL_OBSTACLE] = {"left", "right", "bottom", "top"};

const char *sph2d__side_word(int side)
{
    return words[side];
}

sph2d_side sph2d__side_of(const sph2d_scene *scene, int side)
{
    const sph2d_side sides[] = {scene->boundary.left, scene->boundary.right, scene->boundary.bottom,
                                scene->boundary.top};
    return sides[side];
}

sph2d_wall_slip sph2d__side_own_slip(const sph2d_scene *scene, int side)
{
    const sph2d_side_slips *s = &scene->side_slip;
    const sph2d_wall_slip slips[] = {s->left, s->right, s->bottom, s->top};
    return slips[side];
}

double sph2d__side_speed(const sph2d_scene *scene, int side)
{
    const sph2d_side_speeds *s = &scene->wall_speeds;
    const double speeds[] = {s->left, s->right, s->bottom, s->top};
    return speeds[side];
}

bool sph2d__has_side(const sph2d_scene *scene, sph2d_side kind)
{
    bool has = false;
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        has = has || sph2d__side_of(scene, side) == kind;
    return has;
}

double sph2d__side_distance(const sph2d_box *box, int side, sph2d_vec2 p)
{
    const double within[] = {p.x - box->min.x, box->max.x - p.x, p.y - box->min.y, box->max.y - p.y};
    return within[side];
}

double sph2d__walled_distance(const sph2d_scene *scene, const sph2d_box *box, sph2d_vec2 p)
{
    double nearest = INFINITY;
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        if (sph2d__side_of(scene, side) == SPH2D_SIDE_WALL)
            nearest = fmin(nearest, sph2d__side_distance(box, side, p));
    return nearest;
}

int sph2d__wall_named(const sph2d__world *world, const char *name)
{
    for (size_t k = 0; k < world->wall_count; ++k)
        if (world->walls[k].name && strcmp(world->walls[k].name, name) == 0)
            return (int)k;
    return SPH2D__WALL_ALL;
}

const char *sph2d__wall_path(char *path, size_t size, const sph2d__wall *wall, const char *rest)
{
    if (wall->kind == SPH2D__WALL_IS_SIDE || wall->kind == SPH2D__WALL_IS_BESIDE_OPENING)
        snprintf(path, size, "boundary.%s", wall->name);
    else
        snprintf(path, size, "%s[%zu]%s", wall->kind == SPH2D__WALL_IS_BODY ? "bodies" : "obstacles", wall->index,
                 rest);
    return path;
}

bool sph2d__wall_moves(const sph2d__wall *wall)
{
    return wall->body || sph2d__motion_moves(&wall->motion);
}

bool sph2d__wall_turns(const sph2d__wall *wall)
{
    return wall->body ? wall->body->hold.angle == SPH2D_SWITCH_OFF : sph2d__motion_turns(&wall->motion);
}

/** The bit of a slip; none for one that is no word, which the checker reports. */
static unsigned bit_of(sph2d_slip slip)
{
    return (unsigned)slip <= SPH2D_SLIP_SMOOTH ? 1u << slip : 0;
}

unsigned sph2d__wall_slips(const sph2d__world *world)
{
    unsigned slips = 0;
    for (size_t k = 0; k < world->wall_count; ++k) {
        const sph2d__wall *w = &world->walls[k];
        bool is_wall = w->kind != SPH2D__WALL_IS_SIDE || sph2d__side_of(&world->scene, (int)k) == SPH2D_SIDE_WALL;
        if (is_wall && w->form == SPH2D_WALL_GENERALISED)
            slips |= bit_of(w->slip);
    }
    return slips ? slips : bit_of(world->scene.wall_slip);
}

sph2d_wall_form sph2d__side_form(const sph2d_scene *scene)
{
    return scene->walls != SPH2D_WALL_DEFAULT ? scene->walls : sph2d__method_row_of(&scene->method)->side_form;
}

sph2d_wall_form sph2d__obstacle_form(const sph2d_method_options *method, sph2d_wall_form form)
{
    return form != SPH2D_WALL_DEFAULT ? form : sph2d__method_row_of(method)->obstacle_form;
}

/* ---- the list ---------------------------------------------------------------------------------------------------- */

static sph2d_slip slip_or_scene(const sph2d_scene *scene, sph2d_wall_slip own)
{
    switch (own) {
    case SPH2D_WALL_SLIP_FREE:
        return SPH2D_SLIP_FREE;
    case SPH2D_WALL_SLIP_NONE:
        return SPH2D_SLIP_NONE;
    case SPH2D_WALL_SLIP_SMOOTH:
        return SPH2D_SLIP_SMOOTH;
    case SPH2D_WALL_SLIP_DEFAULT:
        break;
    }
    return scene->wall_slip;
}

static sph2d__wall side_wall(const sph2d_scene *scene, int side)
{
    return (sph2d__wall){.kind = SPH2D__WALL_IS_SIDE,
                         .index = (size_t)side,
                         .name = words[side],
                         .shape_key = "",
                         .form = scene->walls,
                         .slip = slip_or_scene(scene, sph2d__side_own_slip(scene, side)),
                         .motion = sph2d_motion_default()};
}

static sph2d__wall obstacle_wall(const sph2d_scene *scene, size_t index)
{
    const sph2d_obstacle *o = &scene->obstacles[index];
    return (sph2d__wall){.kind = SPH2D__WALL_IS_OBSTACLE,
                         .index = index,
                         .name = o->name,
                         .shape_key = sph2d__shape_key(o->shape.kind),
                         .shape = o->shape,
                         .liquid = o->liquid,
                         .form = sph2d__obstacle_form(&scene->method, o->form),
                         .slip = slip_or_scene(scene, o->slip),
                         .restitution = o->restitution,
                         .motion = o->motion};
}

static sph2d__wall body_wall(const sph2d_scene *scene, size_t index)
{
    const sph2d_body *body = &scene->bodies[index];
    const sph2d_obstacle plain = sph2d_obstacle_default();
    return (sph2d__wall){.kind = SPH2D__WALL_IS_BODY,
                         .index = index,
                         .name = body->name,
                         .shape_key = sph2d__shape_key(body->shape.kind),
                         .shape = body->shape,
                         .form = sph2d__obstacle_form(&scene->method, SPH2D_WALL_DEFAULT),
                         .slip = slip_or_scene(scene, body->slip),
                         .restitution = plain.restitution,
                         .motion = plain.motion,
                         .body = body};
}

static bool set_walls(sph2d__world *world, sph2d__arena *arena, sph2d__memory *memory)
{
    const sph2d_scene *scene = &world->scene;
    const size_t beside = scene->opening_count > 0 ? scene->opening_count + SPH2D__WALL_OBSTACLE : 0; /* at most */
    world->wall_room = SPH2D__WALL_OBSTACLE + scene->obstacle_count + beside + scene->body_count;
    world->walls = sph2d__arena_alloc(arena, memory, world->wall_room, sizeof *world->walls);
    if (!world->walls)
        return false;
    size_t count = 0;
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        world->walls[count++] = side_wall(scene, side);
    for (size_t k = 0; k < scene->obstacle_count; ++k)
        world->walls[count++] = obstacle_wall(scene, k);
    world->first_body = count;
    for (size_t k = 0; k < scene->body_count; ++k)
        world->walls[count++] = body_wall(scene, k);
    world->wall_count = count;
    return true;
}

static sph2d__gravity_direction direction_of(sph2d_vec2 g)
{
    double size = hypot(g.x, g.y);
    return (sph2d__gravity_direction){size, size > 0 ? (sph2d_vec2){-g.x / size, -g.y / size} : (sph2d_vec2){0, 0}};
}

sph2d_status sph2d__world_copy(sph2d__world *world, const sph2d_scene *scene, sph2d__arena *arena,
                               sph2d__memory *memory)
{
    *world = (sph2d__world){.box = scene->domain, .gravity = direction_of(scene->gravity)};
    if (!sph2d__scene_copy(scene, arena, memory, &world->scene))
        return SPH2D_NOMEM;
    world->scene.method = sph2d__method_resolve(scene->method);
    world->scene.walls = sph2d__side_form(scene);
    return set_walls(world, arena, memory) ? SPH2D_OK : SPH2D_NOMEM;
}
