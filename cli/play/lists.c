/* SPDX-License-Identifier: MIT */
/** @file lists.c
 *  Copies of obstacles and bodies. */
#include "lists.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BOX_CORNERS = 4 };

sph2d_vec2 body_moved(const body_move *move, sph2d_vec2 p)
{
    const double c = cos(move->angle), s = sin(move->angle), x = p.x - move->from.x, y = p.y - move->from.y;
    return (sph2d_vec2){move->to.x + c * x - s * y, move->to.y + s * x + c * y};
}

sph2d_vec2 body_moved_back(const body_move *move, sph2d_vec2 p)
{
    return body_moved(&(body_move){move->to, move->from, -move->angle}, p);
}

/* Points mean nothing in shapes of other kinds. */
static size_t point_count(const sph2d_shape *shape)
{
    const bool has =
        shape->kind == SPH2D_SHAPE_POLYGON || shape->kind == SPH2D_SHAPE_LINE || shape->kind == SPH2D_SHAPE_POLYLINE;
    return has ? shape->points.count : 0;
}

/* Copies the corners of a shape to *next, which goes on. */
static void copy_points(sph2d_shape *shape, sph2d_vec2 **next)
{
    const size_t count = point_count(shape);
    if (count == 0)
        return;
    memcpy(*next, shape->points.items, count * sizeof **next);
    shape->points.items = *next;
    *next += count;
}

/* Moves a shape whose corners are `corners`; a box that has turned is a polygon of these. */
static void move_shape(sph2d_shape *shape, sph2d_vec2 *corners, const body_move *move)
{
    const sph2d_box box = shape->box;
    const double x = move->to.x - move->from.x, y = move->to.y - move->from.y;
    if (shape->kind == SPH2D_SHAPE_BOX && move->angle == 0) {
        shape->box = (sph2d_box){{box.min.x + x, box.min.y + y}, {box.max.x + x, box.max.y + y}};
        return;
    }
    if (shape->kind == SPH2D_SHAPE_BOX) {
        const sph2d_vec2 four[BOX_CORNERS] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
        memcpy(corners, four, sizeof four);
        *shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = {corners, BOX_CORNERS}};
    }
    shape->circle.center = body_moved(move, shape->circle.center);
    for (size_t i = 0; shape->kind == SPH2D_SHAPE_POLYGON && i < shape->points.count; ++i)
        corners[i] = body_moved(move, corners[i]);
}

/* Springs hold the same points of the body, with the same lengths. */
static void move_springs(sph2d_spring *springs, size_t count, const body_move *move)
{
    for (size_t i = 0; i < count; ++i) {
        sph2d_spring *s = &springs[i];
        const sph2d_vec2 at = isnan(s->at.x) || isnan(s->at.y) ? move->from : s->at;
        if (isnan(s->length))
            s->length = hypot(s->to.x - at.x, s->to.y - at.y);
        s->at = body_moved(move, at);
    }
}

void *lists_copy(sph2d_scene *scene, const body_move *moves)
{
    size_t corners = BOX_CORNERS * scene->body_count, springs = 0;
    for (size_t k = 0; k < scene->obstacle_count; ++k)
        corners += point_count(&scene->obstacles[k].shape);
    for (size_t k = 0; k < scene->body_count; ++k) {
        corners += point_count(&scene->bodies[k].shape);
        springs += scene->bodies[k].spring_count;
    }
    sph2d_obstacle *obstacles =
        malloc(scene->obstacle_count * sizeof *obstacles + scene->body_count * sizeof(sph2d_body) +
               springs * sizeof(sph2d_spring) + corners * sizeof(sph2d_vec2) + 1);
    if (!obstacles)
        return NULL;
    void *behind = obstacles + scene->obstacle_count;
    sph2d_body *bodies = behind;
    behind = bodies + scene->body_count;
    sph2d_spring *spring = behind;
    behind = spring + springs;
    sph2d_vec2 *next = behind;
    for (size_t k = 0; k < scene->obstacle_count; ++k) {
        obstacles[k] = scene->obstacles[k];
        copy_points(&obstacles[k].shape, &next);
    }
    for (size_t k = 0; k < scene->body_count; ++k) {
        sph2d_body *body = &bodies[k];
        *body = scene->bodies[k];
        sph2d_vec2 *own = next;
        copy_points(&body->shape, &next);
        if (body->spring_count > 0)
            memcpy(spring, body->springs, body->spring_count * sizeof *spring);
        if (moves) {
            move_shape(&body->shape, own, &moves[k]);
            move_springs(spring, body->spring_count, &moves[k]);
            next = own + point_count(&body->shape);
            if (!isnan(body->center.x) && !isnan(body->center.y))
                body->center = moves[k].to;
        }
        body->springs = spring;
        spring += body->spring_count;
    }
    scene->obstacles = obstacles;
    scene->bodies = bodies;
    return obstacles;
}
