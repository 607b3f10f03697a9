/* SPDX-License-Identifier: MIT */
/** @file liquid.c
 *  The liquid of a scene: what it starts with, where it is, and which sides of lines it wets. */
#include "scene/liquid.h"

#include <math.h>
#include <string.h>

#include "scene/shape.h"

/* Maximum numbers of samples along a wall segment, and along an edge of a block's bounding box. */
static const double MAX_ALONG = 2000, MAX_ACROSS = 40;
/* Mitre limit, as a multiple of the offset: lines that turn by more than 120 degrees have no solid. */
static const double MITRE_LIMIT = 2;

/* ---- what it starts with ----------------------------------------------------------------------------------------- */

bool sph2d__starts_from_snapshot(const sph2d_scene *scene)
{
    const sph2d_cloud *snapshot = &scene->start.snapshot;
    return (snapshot->file || snapshot->count > 0) && !scene->particles.file && scene->particles.count == 0;
}

bool sph2d__liquid_is_from_file(const sph2d_scene *scene)
{
    return scene->particles.file || sph2d__starts_from_snapshot(scene);
}

double sph2d__start_speed(const sph2d_start *start)
{
    const sph2d_grid *grid = &start->table;
    const sph2d_cloud *cloud = &start->snapshot;
    double speed = fabs(start->flow.speed);
    if (start->top_speed > 0)
        return start->top_speed;
    for (size_t k = 0; k < grid->nx * grid->ny; ++k)
        speed = fmax(speed, hypot(grid->vx ? grid->vx[k] : 0, grid->vy ? grid->vy[k] : 0));
    for (size_t k = 0; cloud->items && k < cloud->count; ++k)
        speed = fmax(speed, hypot(cloud->items[k].vx, cloud->items[k].vy));
    return speed;
}

/* ---- solids and blocks ------------------------------------------------------------------------------------------- */

double sph2d__layer_thickness(const sph2d_scene *scene)
{
    return ceil(scene->method.support_ratio - 1e-9) * scene->spacing;
}

bool sph2d__wall_has_side(const sph2d__wall *wall)
{
    return sph2d__shape_is_open(&wall->shape) && wall->form == SPH2D_WALL_GENERALISED;
}

bool sph2d__wall_is_hollow(const sph2d__wall *wall)
{
    return wall->liquid == SPH2D_LIQUID_INSIDE && !sph2d__shape_is_open(&wall->shape);
}

bool sph2d__wall_fills(const sph2d_scene *scene, const sph2d__wall *wall, sph2d_vec2 p)
{
    bool inside = sph2d__shape_contains(&wall->shape, p);
    if (!sph2d__wall_is_hollow(wall))
        return inside;
    return !inside && wall->form == SPH2D_WALL_GENERALISED &&
           sph2d__shape_nearest(&wall->shape, scene->spacing, p) < sph2d__layer_thickness(scene);
}

bool sph2d__in_block(const sph2d_scene *scene, sph2d_vec2 p)
{
    for (size_t i = 0; i < scene->block_count; ++i)
        if (sph2d__shape_contains(&scene->blocks[i].shape, p))
            return true;
    return false;
}

/* Places that are looked at for a void, and the part of them that may be one: where edges of blocks and solids meet. */
static const double MOST_PLACES = 4e6, VOID_PART = 0.002;

static bool is_taken(const sph2d__world *world, sph2d_vec2 p)
{
    bool taken = sph2d__in_block(&world->scene, p);
    for (size_t k = SPH2D__WALL_OBSTACLE; !taken && k < world->first_body; ++k)
        taken = sph2d__wall_fills(&world->scene, &world->walls[k], p);
    return taken;
}

/** Whether one block covers the domain. */
static bool is_covered(const sph2d_scene *scene)
{
    const sph2d_box *d = &scene->domain;
    double near = scene->spacing / 2;
    for (size_t i = 0; i < scene->block_count; ++i) {
        const sph2d_shape *shape = &scene->blocks[i].shape;
        const sph2d_box *box = &shape->box;
        if (shape->kind == SPH2D_SHAPE_BOX && box->min.x <= d->min.x + near && box->min.y <= d->min.y + near &&
            box->max.x >= d->max.x - near && box->max.y >= d->max.y - near)
            return true;
    }
    return false;
}

bool sph2d__liquid_fills(const sph2d__world *world)
{
    const sph2d_scene *scene = &world->scene;
    const sph2d_box *d = &scene->domain;
    double nx = floor((d->max.x - d->min.x) / scene->spacing), ny = floor((d->max.y - d->min.y) / scene->spacing);
    if (sph2d__has_side(scene, SPH2D_SIDE_OPEN))
        return false;
    if (is_covered(scene))
        return true;
    if (nx * ny > MOST_PLACES)
        return false;
    double voids = 0;
    for (double row = ny; row-- > 0;) /* from the top, where air is */
        for (double column = 0; column < nx; ++column) {
            sph2d_vec2 p = {d->min.x + (column + 0.5) * scene->spacing, d->min.y + (row + 0.5) * scene->spacing};
            voids += !is_taken(world, p);
            if (voids > VOID_PART * nx * ny)
                return false;
        }
    return true;
}

/* ---- wet sides --------------------------------------------------------------------------------------------------- */

/** Distance of a position from a line [m]; *side is positive on its left. Of two equally near segments, at a corner,
 *  both count. */
static double distance_to_line(const sph2d_shape *outline, sph2d_vec2 p, double *side)
{
    if (outline->kind == SPH2D_SHAPE_ARC)
        return sph2d__arc_distance(&outline->arc, p, side);
    double nearest = INFINITY;
    *side = 0;
    size_t pieces = sph2d__shape_pieces(outline, 0);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__shape_piece(outline, 0, k);
        double distance = sph2d__segment_distance(&s, p), tie = 1e-9 * distance;
        double here = sph2d__segment_side(&s, p) / hypot(s.b.x - s.a.x, s.b.y - s.a.y);
        *side = distance < nearest - tie ? here : distance <= nearest + tie ? *side + here : *side;
        nearest = fmin(nearest, distance);
    }
    return nearest;
}

/** Whether there is liquid on the left and right of a line, within a thickness of it. */
static void find_wet_sides(const sph2d_scene *scene, const sph2d_shape *outline, double thickness, bool *left,
                           bool *right)
{
    double dx = scene->spacing, side;
    double bulge = outline->kind == SPH2D_SHAPE_ARC ? sph2d__arc_bulge(&outline->arc, dx) : 0;
    size_t pieces = sph2d__shape_pieces(outline, dx);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__shape_piece(outline, dx, k);
        double length = hypot(s.b.x - s.a.x, s.b.y - s.a.y), count = fmin(fmax(floor(length / dx), 1), MAX_ALONG);
        for (double i = 0.5; i < count; ++i)
            for (double d = 0.5 * dx - thickness; d < thickness; d += dx) {
                double t = i / count, offset = d / length;
                sph2d_vec2 p = {s.a.x + t * (s.b.x - s.a.x) - offset * (s.b.y - s.a.y),
                                s.a.y + t * (s.b.y - s.a.y) + offset * (s.b.x - s.a.x)};
                bool *wet = d > 0 ? left : right;
                if (!*wet && sph2d__in_block(scene, p) &&
                    distance_to_line(outline, p, &side) >= 0.999 * fabs(d) - bulge)
                    *wet = true;
            }
    }
    for (size_t i = 0; i < scene->source_count; ++i)
        if (distance_to_line(outline, scene->sources[i].at, &side) < thickness)
            *(side > 0 ? left : right) = true;
}

/** The side of the liquid nearest to a line; left if there is none. */
static sph2d_liquid_side side_of_nearest(const sph2d_scene *scene, const sph2d_shape *outline)
{
    double nearest = INFINITY, side = 1, here = 0;
    for (size_t i = 0; i < scene->block_count; ++i) {
        const sph2d_shape *shape = &scene->blocks[i].shape;
        sph2d_box b = sph2d__shape_bounds(shape);
        double width = b.max.x - b.min.x, height = b.max.y - b.min.y;
        double nx = fmin(fmax(floor(width / scene->spacing), 1), MAX_ACROSS);
        double ny = fmin(fmax(floor(height / scene->spacing), 1), MAX_ACROSS);
        for (double y = 0.5; y < ny; ++y)
            for (double x = 0.5; x < nx; ++x) {
                sph2d_vec2 p = {b.min.x + x / nx * width, b.min.y + y / ny * height};
                double distance = sph2d__shape_contains(shape, p) ? distance_to_line(outline, p, &here) : INFINITY;
                if (distance < nearest) {
                    nearest = distance;
                    side = here;
                }
            }
    }
    for (size_t i = 0; i < scene->source_count; ++i) {
        double distance = distance_to_line(outline, scene->sources[i].at, &here);
        if (distance < nearest) {
            nearest = distance;
            side = here;
        }
    }
    return side < 0 ? SPH2D_LIQUID_RIGHT : SPH2D_LIQUID_LEFT;
}

sph2d_liquid_side sph2d__liquid_side(const sph2d_scene *scene, const sph2d__wall *wall)
{
    if (wall->liquid != SPH2D_LIQUID_AUTO)
        return wall->liquid;
    bool left = false, right = false;
    find_wet_sides(scene, &wall->shape, sph2d__layer_thickness(scene), &left, &right);
    if (left || right)
        return left && right ? SPH2D_LIQUID_BOTH : left ? SPH2D_LIQUID_LEFT : SPH2D_LIQUID_RIGHT;
    return side_of_nearest(scene, &wall->shape);
}

/** Unit normal of a segment of a line, to its left. */
static sph2d_vec2 normal_of(const sph2d_vec2 *points, size_t k)
{
    double x = points[k + 1].x - points[k].x, y = points[k + 1].y - points[k].y, length = hypot(x, y);
    return (sph2d_vec2){-y / length, x / length};
}

bool sph2d__solid_of_line(sph2d_points line, double thickness, sph2d_vec2 *corners)
{
    size_t n = line.count;
    for (size_t k = 0; k < n; ++k) {
        sph2d_vec2 from = normal_of(line.items, k > 0 ? k - 1 : k);
        sph2d_vec2 to = normal_of(line.items, k + 1 < n ? k : k - 1);
        double along = 1 + from.x * to.x + from.y * to.y; /* 2 where the line is straight, 0 where it turns back */
        if (along < 2 / (MITRE_LIMIT * MITRE_LIMIT))
            return false;
        double x = thickness / 2 * (from.x + to.x) / along, y = thickness / 2 * (from.y + to.y) / along;
        corners[k] = (sph2d_vec2){line.items[k].x + x, line.items[k].y + y};
        corners[2 * n - 1 - k] = (sph2d_vec2){line.items[k].x - x, line.items[k].y - y};
    }
    return !sph2d__polygon_crosses_itself((sph2d_points){corners, 2 * n});
}

/** Makes a solid of a line that is wet on both sides. False when memory is short. */
static bool make_solid(const sph2d_scene *scene, sph2d_shape *outline, sph2d__arena *arena, sph2d__memory *memory)
{
    size_t count = sph2d_shape_corners(outline, scene->spacing, NULL);
    sph2d_vec2 *corners = sph2d__arena_alloc(arena, memory, 3 * count, sizeof *corners);
    if (!corners)
        return false;
    sph2d_vec2 *line = corners + 2 * count;
    sph2d_shape_corners(outline, scene->spacing, line);
    sph2d__solid_of_line((sph2d_points){line, count}, sph2d__layer_thickness(scene), corners);
    outline->kind = SPH2D_SHAPE_POLYGON;
    outline->points = (sph2d_points){corners, 2 * count};
    return true;
}

sph2d_status sph2d__resolve_sides(sph2d__world *world, sph2d__arena *arena, sph2d__memory *memory)
{
    sph2d_scene *scene = &world->scene;
    sph2d_obstacle *obstacles = sph2d__arena_alloc(arena, memory, scene->obstacle_count + 1, sizeof *obstacles);
    if (!obstacles)
        return SPH2D_NOMEM;
    for (size_t i = 0; i < scene->obstacle_count; ++i) {
        sph2d__wall *wall = &world->walls[SPH2D__WALL_OBSTACLE + i];
        if (sph2d__wall_has_side(wall)) {
            wall->liquid = sph2d__liquid_side(scene, wall);
            if (wall->liquid == SPH2D_LIQUID_BOTH && !make_solid(scene, &wall->shape, arena, memory))
                return SPH2D_NOMEM;
        }
        obstacles[i] = scene->obstacles[i];
        obstacles[i].liquid = wall->liquid;
        obstacles[i].shape = wall->shape;
    }
    scene->obstacles = obstacles;
    return SPH2D_OK;
}
