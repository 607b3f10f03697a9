/* SPDX-License-Identifier: MIT */
/** @file drawn.c
 *  Walls that are drawn by hand. */
#include "drawn.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lists.h"

/* Lines that turn by more than 101 degrees, the cosine of which this is, are divided: solids are mitred up to 120. */
static const double SHARP = -0.2;

static sph2d_vec2 direction(const sph2d_vec2 *corners, size_t k)
{
    const double x = corners[k + 1].x - corners[k].x, y = corners[k + 1].y - corners[k].y, length = hypot(x, y);
    return (sph2d_vec2){x / length, y / length};
}

double drawn_distance(const sph2d_vec2 *line, sph2d_vec2 p)
{
    const sph2d_vec2 a = line[0], b = line[1];
    const double x = b.x - a.x, y = b.y - a.y, t = ((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y);
    const double part = fmin(fmax(t, 0), 1); /* 0 for NaN: a point */
    return hypot(a.x + part * x - p.x, a.y + part * y - p.y);
}

static double side(const sph2d_vec2 *line, sph2d_vec2 p)
{
    return (line[1].x - line[0].x) * (p.y - line[0].y) - (line[1].y - line[0].y) * (p.x - line[0].x);
}

bool drawn_near(const sph2d_vec2 *s, const sph2d_vec2 *t, double reach)
{
    const bool cross = side(s, t[0]) * side(s, t[1]) < 0 && side(t, s[0]) * side(t, s[1]) < 0;
    return cross || drawn_distance(s, t[0]) < reach || drawn_distance(s, t[1]) < reach ||
           drawn_distance(t, s[0]) < reach || drawn_distance(t, s[1]) < reach;
}

drawn_line drawn_divide(const sph2d_vec2 *corners, size_t count, double thickness)
{
    drawn_line line = {.corners = corners};
    for (size_t k = 1; k + 1 < count; ++k) {
        const sph2d_vec2 from = direction(corners, k - 1), to = direction(corners, k);
        bool ends = from.x * to.x + from.y * to.y < SHARP;
        for (size_t j = line.start[line.pieces]; j + 1 < k && !ends; ++j)
            ends = drawn_near(corners + j, corners + k, 1.5 * thickness);
        if (ends)
            line.start[++line.pieces] = k;
    }
    line.start[++line.pieces] = count - 1;
    return line;
}

size_t drawn_solid(const drawn_line *line, size_t k, double thickness, double more,
                   sph2d_vec2 out[2 * DRAWN_MOST_CORNERS])
{
    const size_t first = line->start[k], last = line->start[k + 1], n = last - first + 1;
    for (size_t i = first; i <= last; ++i) {
        const sph2d_vec2 from = direction(line->corners, i > first ? i - 1 : i),
                         to = direction(line->corners, i < last ? i : i - 1), at = line->corners[i];
        const double half = thickness / 2 / (1 + from.x * to.x + from.y * to.y), x = half * (from.x + to.x),
                     y = half * (from.y + to.y),
                     ahead = i == first  ? -more
                             : i == last ? more
                                         : 0;
        out[i - first] = (sph2d_vec2){at.x - y + ahead * to.x, at.y + x + ahead * to.y};
        out[2 * n - 1 - (i - first)] = (sph2d_vec2){at.x + y + ahead * to.x, at.y - x + ahead * to.y};
    }
    return 2 * n;
}

void *drawn_list(sph2d_scene *scene, size_t from, size_t to, const drawn_line *line)
{
    const size_t pieces = line ? line->pieces : 0, kept = scene->obstacle_count - (to - from);
    sph2d_obstacle *list = malloc((kept + pieces) * sizeof *list + 1);
    if (!list)
        return NULL;
    if (from > 0)
        memcpy(list, scene->obstacles, from * sizeof *list);
    if (kept > from)
        memcpy(list + from, scene->obstacles + to, (kept - from) * sizeof *list);
    for (size_t k = 0; k < pieces; ++k) {
        const size_t start = line->start[k];
        list[kept + k] = sph2d_obstacle_default();
        list[kept + k].shape.kind = SPH2D_SHAPE_POLYLINE;
        list[kept + k].shape.points = (sph2d_points){line->corners + start, line->start[k + 1] - start + 1};
        list[kept + k].liquid = SPH2D_LIQUID_BOTH;
    }
    scene->obstacles = list;
    scene->obstacle_count = kept + pieces;
    void *copy = lists_copy(scene, NULL);
    free(list);
    return copy;
}

/* Whether a drawn wall begins where the one before ends. */
static bool goes_on(const sph2d_scene *scene, size_t k)
{
    const sph2d_points *before = &scene->obstacles[k - 1].shape.points, *here = &scene->obstacles[k].shape.points;
    const sph2d_vec2 a = before->items[before->count - 1], b = here->items[0];
    return a.x == b.x && a.y == b.y;
}

void drawn_find(const sph2d_scene *scene, size_t given, sph2d_vec2 at, double reach, size_t *from, size_t *to)
{
    *from = *to = 0;
    for (size_t k = given; k < scene->obstacle_count; ++k) {
        const sph2d_points *line = &scene->obstacles[k].shape.points;
        for (size_t i = 0; i + 1 < line->count; ++i)
            if (drawn_distance(line->items + i, at) < reach) {
                reach = drawn_distance(line->items + i, at);
                *from = k;
                *to = k + 1;
            }
    }
    while (*from > given && goes_on(scene, *from))
        --*from;
    while (*to > *from && *to < scene->obstacle_count && goes_on(scene, *to))
        ++*to;
}
