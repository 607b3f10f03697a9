/* SPDX-License-Identifier: MIT */
/** @file check_outputs.c
 *  Checks of probes, and of what frames show. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/suggest.h"
#include "scene/checker.h"
#include "scene/openings.h"

enum { PATH_SIZE = SPH2D__PATH_SIZE };
typedef sph2d__checker checker;

/** Whether a probe's position, if its kind uses it, lies in the domain; of an elevation only x matters. */
static bool is_valid_position(const sph2d_scene *scene, const sph2d_probe *probe)
{
    switch (probe->kind) {
    case SPH2D_PROBE_SPEED:
    case SPH2D_PROBE_PRESSURE:
    case SPH2D_PROBE_TRACER:
        return sph2d__check_in_domain(scene, probe->at);
    case SPH2D_PROBE_ELEVATION:
        return sph2d__check_in_domain(scene, (sph2d_vec2){probe->at.x, scene->domain.min.y});
    default:
        return true;
    }
}

/** Checks that only pressure probes are gauges, and that a face has a direction and lies in the domain. */
static void check_gauge(checker *c, const sph2d_probe *probe, size_t i)
{
    char path[PATH_SIZE];
    if (probe->kind != SPH2D_PROBE_PRESSURE) {
        if (probe->size != 0 || (probe->rise_time != 0 && !isnan(probe->rise_time)))
            sph2d__check_fault(c, SPH2D_CODE_CONFLICT,
                               sph2d__check_path(path, "probes", i, probe->size != 0 ? ".size" : ".rise_time"),
                               "is for probes of kind pressure");
        return;
    }
    if (!(probe->size > 0))
        return;
    double length = hypot(probe->along.x, probe->along.y), half = probe->size / 2;
    if (!(length > 0) || !isfinite(length)) {
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, sph2d__check_path(path, "probes", i, ".along"),
                           "has no direction");
        return;
    }
    double x = half * probe->along.x / length, y = half * probe->along.y / length;
    const sph2d_path *way = &probe->path;
    const sph2d_path_point rest = {0, probe->at.x, probe->at.y}, *places = way->count > 0 ? way->items : &rest;
    for (size_t k = 0; k < (way->count > 0 ? way->count : 1); ++k)
        if (!sph2d__check_in_domain(c->scene, (sph2d_vec2){places[k].x - x, places[k].y - y}) ||
            !sph2d__check_in_domain(c->scene, (sph2d_vec2){places[k].x + x, places[k].y + y})) {
            sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, sph2d__check_path(path, "probes", i, ".size"),
                               "the gauge's face extends beyond the domain");
            return;
        }
}

/** Reports a name that no wall has. */
static void refuse_name(checker *c, const char *path, const char *name)
{
    enum { MOST = 20 };
    const char *names[SPH2D__WALL_OBSTACLE + MOST + 1] = {NULL};
    size_t count = 0;
    for (size_t k = SPH2D__WALL_OBSTACLE; k < c->world->wall_count && count < MOST; ++k)
        if (c->world->walls[k].name)
            names[count++] = c->world->walls[k].name;
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        names[count++] = sph2d__side_word(side);
    char message[160];
    snprintf(message, sizeof message, "no wall or body has the name '%.64s'", name);
    sph2d__suggest_word(sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, message), name, names,
                        "the name of an obstacle, body or side");
}

/** Checks that a probe of kind body names one. */
static void check_body(checker *c, const sph2d_probe *probe, size_t i)
{
    char path[PATH_SIZE];
    sph2d__check_path(path, "probes", i, ".on");
    if (!probe->on) {
        sph2d_diagnostic_hint(sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, path, "must be the name of a body"),
                              "give the body a `name`");
        return;
    }
    int wall = sph2d__wall_named(c->world, probe->on);
    if (wall == SPH2D__WALL_ALL) {
        refuse_name(c, path, probe->on);
    } else if (!c->world->walls[wall].body) {
        char message[160];
        snprintf(message, sizeof message, "'%.64s' is %s, not a body", probe->on,
                 wall < SPH2D__WALL_OBSTACLE ? "a side of the domain" : "an obstacle");
        sph2d_diagnostic_hint(sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, message),
                              "use `kind: force` or `work` for what liquid does to it");
    }
}

/** Checks that a probe of kind opening names one. */
static void check_opening(checker *c, const sph2d_probe *probe, size_t i)
{
    char path[PATH_SIZE], message[160];
    if (probe->on && sph2d__opening_named(c->scene, probe->on))
        return;
    snprintf(message, sizeof message, probe->on ? "no opening has the name '%.64s'" : "must be the name of an opening",
             probe->on);
    sph2d_diagnostic *d = sph2d__check_fault(c, probe->on ? SPH2D_CODE_CONFLICT : SPH2D_CODE_MISSING_KEY,
                                             sph2d__check_path(path, "probes", i, ".on"), message);
    sph2d_diagnostic_hint(d, "give the opening a `name`");
}

/** Refuses the force on a side that has openings: that is where the reservoir ends. */
static void check_side(checker *c, int side, const char *path)
{
    if (!sph2d__side_has_opening(c->scene, side))
        return;
    sph2d_diagnostic *d =
        sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, path, "is a side with an opening, whose force is not known");
    sph2d_diagnostic_hint(d, "draw a wall inside as an obstacle with a `name`");
}

static bool is_at_a_point(const sph2d_probe *probe)
{
    return probe->kind == SPH2D_PROBE_SPEED || probe->kind == SPH2D_PROBE_PRESSURE ||
           probe->kind == SPH2D_PROBE_ELEVATION;
}

/** Checks what a probe at a point is taken along by. */
static void check_carrier(checker *c, const sph2d_probe *probe, size_t i)
{
    char path[PATH_SIZE];
    sph2d__check_path(path, "probes", i, ".on");
    const int wall = sph2d__wall_named(c->world, probe->on);
    if (wall == SPH2D__WALL_ALL)
        refuse_name(c, path, probe->on);
    else if (wall < SPH2D__WALL_OBSTACLE)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "is a side of the domain, which takes no probe along");
    if (probe->path.count > 0)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "give `on` or `path`, not both");
}

/** Checks the way of a probe at a point. */
static void check_way(checker *c, const sph2d_probe *probe, size_t i)
{
    const sph2d_path *way = &probe->path;
    char path[PATH_SIZE];
    sph2d__check_path(path, "probes", i, ".path");
    if (way->count == 0)
        return;
    if (!isnan(c->given->probes[i].at.x))
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "give `at` or `path`, not both");
    if (!is_at_a_point(probe)) {
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "is for probes of kinds speed, pressure and elevation");
        return;
    }
    sph2d__check_times(c, &way->items[0].t, way->count, 3, path);
    for (size_t k = 0; k < way->count; ++k) {
        sph2d_probe there = *probe;
        there.at = (sph2d_vec2){way->items[k].x, way->items[k].y};
        if (!is_valid_position(c->scene, &there)) {
            sph2d__check_outside(c, path, there.at);
            return;
        }
    }
}

/** Checks what a probe is on. */
static void check_wall(checker *c, const sph2d_probe *probe, size_t i)
{
    if (is_at_a_point(probe)) {
        if (probe->on)
            check_carrier(c, probe, i);
        return;
    }
    char path[PATH_SIZE];
    if (probe->kind == SPH2D_PROBE_BODY) {
        check_body(c, probe, i);
        return;
    }
    if (probe->kind == SPH2D_PROBE_OPENING) {
        check_opening(c, probe, i);
        return;
    }
    bool on_wall = probe->kind == SPH2D_PROBE_FORCE || probe->kind == SPH2D_PROBE_WORK;
    sph2d__check_path(path, "probes", i, ".on");
    if (!on_wall) {
        if (probe->on)
            sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path,
                               "is for probes of kinds force, work, body, opening, speed, pressure and elevation");
        return;
    }
    if (!probe->on)
        return;
    int wall = sph2d__wall_named(c->world, probe->on);
    if (wall == SPH2D__WALL_ALL)
        refuse_name(c, path, probe->on);
    else if (wall < SPH2D__WALL_OBSTACLE && sph2d__side_of(c->scene, wall) != SPH2D_SIDE_WALL)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "this side of the domain is not a wall");
    else if (wall < SPH2D__WALL_OBSTACLE)
        check_side(c, wall, path);
}

void sph2d__check_probe(checker *c, size_t i)
{
    const sph2d_probe *probe = &c->scene->probes[i];
    char path[PATH_SIZE];
    sph2d__check_path(path, "probes", i, ".name");
    if (!probe->name || !sph2d__check_name(probe->name))
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, "must be 1 to 64 letters, digits, _ or -");
    for (size_t k = 0; k < i && probe->name; ++k)
        if (c->scene->probes[k].name && strcmp(c->scene->probes[k].name, probe->name) == 0) {
            sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "another probe has this name");
            break;
        }
    sph2d__check_path(path, "probes", i, "");
    sph2d__check_rate(c, probe->rate, path);
    if (sph2d_rate_interval(probe->rate) <= 0)
        sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, path, "needs per_second or every");
    check_wall(c, probe, i);
    check_way(c, probe, i);
    const bool placed = is_at_a_point(probe) || probe->kind == SPH2D_PROBE_TRACER;
    if (placed && isnan(c->given->probes[i].at.x) && probe->path.count == 0)
        sph2d_diagnostic_hint(
            sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, sph2d__check_path(path, "probes", i, ".at"), "must be given"),
            "the place [m], at: [x, y]%s", is_at_a_point(probe) ? "; or a `path`" : "");
    else if (probe->kind != SPH2D_PROBE_ELEVATION && isnan(c->given->probes[i].at.x) != isnan(c->given->probes[i].at.y))
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, sph2d__check_path(path, "probes", i, ".at"),
                           "has a number that is missing or not finite");
    else if (probe->path.count == 0 && !is_valid_position(c->scene, probe))
        sph2d__check_outside(c, sph2d__check_path(path, "probes", i, ".at"), probe->at);
    else
        check_gauge(c, probe, i);
}

/* ---- frames ------------------------------------------------------------------------------------------------------- */

/** Reports a name to follow that no obstacle or body has. */
static void check_follow(sph2d__checker *c, const char *name)
{
    enum { MOST = 20 };
    const char *names[MOST + 1] = {NULL};
    size_t count = 0;
    for (size_t k = SPH2D__WALL_OBSTACLE; k < c->world->wall_count; ++k) {
        const char *other = c->world->walls[k].name;
        if (other && strcmp(other, name) == 0)
            return;
        if (other && count < MOST)
            names[count++] = other;
    }
    char message[160];
    snprintf(message, sizeof message, "no obstacle or body has the name '%.64s'", name);
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "run.frames.follow", message);
    if (count == 0)
        sph2d_diagnostic_hint(d, "give an obstacle or body a `name`");
    else
        sph2d__suggest_word(d, name, names, "one of");
}

void sph2d__check_frames(sph2d__checker *c)
{
    const sph2d_frames *frames = &c->scene->run.frames;
    const sph2d_box *v = &frames->view;
    if (v->min.x != 0 || v->min.y != 0 || v->max.x != 0 || v->max.y != 0)
        sph2d__check_box(c, *v, "run.frames.view");
    if (frames->follow)
        check_follow(c, frames->follow);
}
