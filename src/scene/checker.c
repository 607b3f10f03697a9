/* SPDX-License-Identifier: MIT */
/** @file checker.c
 *  Functions that the parts of the scene checker share. */
#include "scene/checker.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "scene/liquid.h"
#include "scene/shape.h"

sph2d_diagnostic *sph2d__check_fault(sph2d__checker *c, sph2d_code code, const char *path, const char *message)
{
    ++c->errors;
    return sph2d_report_add(c->report, SPH2D_ERROR, code, path, "%s", message);
}

const char *sph2d__check_path(char path[SPH2D__PATH_SIZE], const char *list, size_t index, const char *rest)
{
    snprintf(path, SPH2D__PATH_SIZE, "%s[%zu]%s", list, index, rest);
    return path;
}

const char *sph2d__check_wall_path(const sph2d__checker *c, char path[SPH2D__PATH_SIZE], size_t index, const char *rest)
{
    return sph2d__wall_path(path, SPH2D__PATH_SIZE, &c->world->walls[index], rest);
}

void sph2d__check_hint_wall(const sph2d__checker *c, sph2d_diagnostic *d, size_t index, const char *otherwise)
{
    const sph2d__wall *wall = &c->world->walls[index];
    if (wall->kind == SPH2D__WALL_IS_OBSTACLE && wall->liquid == SPH2D_LIQUID_BOTH)
        sph2d_diagnostic_hint(d, "%s; `liquid: both` makes a line a solid %.3g m thick", otherwise,
                              sph2d__layer_thickness(c->scene));
    else
        sph2d_diagnostic_hint(d, "%s", otherwise);
}

bool sph2d__check_box(sph2d__checker *c, sph2d_box box, const char *path)
{
    if (box.min.x < box.max.x && box.min.y < box.max.y)
        return true;
    sph2d_diagnostic *d =
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, "max must be above min in both directions");
    sph2d_diagnostic_hint(d, "min is (%g, %g), max is (%g, %g)", box.min.x, box.min.y, box.max.x, box.max.y);
    return false;
}

bool sph2d__check_in_domain(const sph2d_scene *scene, sph2d_vec2 p)
{
    double slack = 1e-9 * scene->spacing;
    sph2d_box d = scene->domain;
    return p.x >= d.min.x - slack && p.x <= d.max.x + slack && p.y >= d.min.y - slack && p.y <= d.max.y + slack;
}

void sph2d__check_outside(sph2d__checker *c, const char *path, sph2d_vec2 p)
{
    sph2d_box b = c->scene->domain;
    char message[160];
    snprintf(message, sizeof message, "(%g, %g) lies outside the domain", p.x, p.y);
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUTSIDE, path, message);
    sph2d_diagnostic_hint(d, "the domain reaches from (%g, %g) to (%g, %g)", b.min.x, b.min.y, b.max.x, b.max.y);
}

/* Maximum number of points of an outline, so that a scene is checked in seconds: every piece is compared with every
 * other. */
enum { MAX_POINTS = 2000 };

bool sph2d__check_count(sph2d__checker *c, sph2d_points points, const char *path)
{
    if (points.count <= MAX_POINTS)
        return true;
    char message[100];
    snprintf(message, sizeof message, "has %zu points, more than %d", points.count, MAX_POINTS);
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, message);
    sph2d_diagnostic_hint(d, "points nearer to each other than the spacing of %g m change nothing: leave some out",
                          c->scene->spacing);
    return false;
}

/** Whether corners lie on one line. Their area does not tell: that of a symmetric bow tie is 0. */
static bool lie_on_a_line(sph2d_points corners)
{
    const double ROUND_OFF = 1e-12; /* of the length squared */
    sph2d__segment longest = {corners.items[0], corners.items[0]};
    double length = 0, widest = 0;
    for (size_t k = 1; k < corners.count; ++k) {
        double here = hypot(corners.items[k].x - longest.a.x, corners.items[k].y - longest.a.y);
        if (here > length) {
            length = here;
            longest.b = corners.items[k];
        }
    }
    for (size_t k = 1; k < corners.count; ++k)
        widest = fmax(widest, fabs(sph2d__segment_side(&longest, corners.items[k])));
    return !(widest > ROUND_OFF * length * length);
}

bool sph2d__check_polygon(sph2d__checker *c, sph2d_points corners, const char *path)
{
    const sph2d_shape shape = {.kind = SPH2D_SHAPE_POLYGON, .points = corners};
    bool flat = corners.count < 3 || lie_on_a_line(corners);
    if (!flat && !sph2d__check_count(c, corners, path))
        return false;
    if (!flat && sph2d__polygon_crosses_itself(corners)) {
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, "a polygon must not cross or touch itself");
        return false;
    }
    if (!flat && sph2d__shape_area(&shape) > 0)
        return true;
    sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, "a polygon needs 3 corners or more that are not on one line");
    return false;
}

void sph2d__check_unread(sph2d__checker *c, const char *path)
{
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, path,
                                             "was not read: only a scene that is read from a file has files");
    sph2d_diagnostic_hint(d, "give its corners as `polygon`");
}

void sph2d__check_times(sph2d__checker *c, const double *times, size_t count, size_t stride, const char *path)
{
    for (size_t k = 1; k < count; ++k)
        if (!(times[k * stride] > times[(k - 1) * stride])) {
            sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "times must increase from point to point");
            break;
        }
}

void sph2d__check_rate(sph2d__checker *c, sph2d_rate rate, const char *prefix)
{
    if (rate.per_second > 0 && rate.every > 0) {
        char path[SPH2D__PATH_SIZE];
        snprintf(path, sizeof path, "%s.every", prefix);
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "give per_second or every, not both");
    }
}

bool sph2d__check_name(const char *name)
{
    size_t length = strlen(name);
    for (size_t i = 0; i < length; ++i)
        if (!isalnum((unsigned char)name[i]) && name[i] != '_' && name[i] != '-')
            return false;
    return length > 0 && length <= 64;
}
