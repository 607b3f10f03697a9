/* SPDX-License-Identifier: MIT */
/** @file check_start.c
 *  Checks what liquid starts with: one of a known flow, a table, a snapshot, and that their values are numbers; and single
 *  particles. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "scene/checker.h"
#include "scene/colors.h"
#include "scene/liquid.h"

typedef sph2d__checker checker;

/** A start and its key. */
typedef struct subject {
    checker *c;
    const sph2d_start *start;
    const char *key;
} subject;

/** Reports a fault at a key of the start. */
static sph2d_diagnostic *fault(const subject *s, sph2d_code code, const char *key, const char *message)
{
    char path[SPH2D__PATH_SIZE];
    snprintf(path, sizeof path, "%s%s", s->key, key);
    return sph2d__check_fault(s->c, code, path, message);
}

static bool are_finite(const double *values, size_t count)
{
    for (size_t k = 0; values && k < count; ++k)
        if (!isfinite(values[k]))
            return false;
    return true;
}

/** Whether grid lines are finite and increase. */
static bool are_lines(const double *lines, size_t count)
{
    for (size_t k = 0; k < count; ++k)
        if (!isfinite(lines[k]) || (k > 0 && !(lines[k] > lines[k - 1])))
            return false;
    return true;
}

static void check_table(const subject *s)
{
    const sph2d_grid *g = &s->start->table;
    if (g->nx == 0 && g->ny == 0)
        return;
    if (g->nx < 2 || g->ny < 2)
        fault(s, SPH2D_CODE_OUT_OF_RANGE, ".table", "needs two x and two y at least");
    else if (g->nx > SIZE_MAX / g->ny)
        fault(s, SPH2D_CODE_OUT_OF_RANGE, ".table", "has more places than memory could hold");
    else if (!g->x || !g->y || (!g->vx && !g->vy && !g->pressure))
        fault(s, SPH2D_CODE_CONFLICT, ".table", "has a NULL list, or no values");
    else if (!are_lines(g->x, g->nx) || !are_lines(g->y, g->ny))
        fault(s, SPH2D_CODE_OUT_OF_RANGE, ".table", "has grid lines that do not increase");
    else if (!are_finite(g->vx, g->nx * g->ny) || !are_finite(g->vy, g->nx * g->ny) ||
             !are_finite(g->pressure, g->nx * g->ny))
        fault(s, SPH2D_CODE_OUT_OF_RANGE, ".table", "has a value that is not finite");
}

static void check_snapshot(const subject *s)
{
    const sph2d_cloud *cloud = &s->start->snapshot;
    if (cloud->count == 0)
        return;
    if (!cloud->items)
        fault(s, SPH2D_CODE_CONFLICT, ".snapshot", "a count above 0 with a NULL list");
    else if (!(cloud->spacing > 0) || !isfinite(cloud->spacing))
        fault(s, SPH2D_CODE_OUT_OF_RANGE, ".snapshot", "has a spacing that is not above 0");
    for (size_t k = 0; cloud->items && k < cloud->count; ++k) {
        const sph2d_cloud_point *p = &cloud->items[k];
        if (isfinite(p->x) && isfinite(p->y) && isfinite(p->vx) && isfinite(p->vy) && isfinite(p->pressure))
            continue;
        fault(s, SPH2D_CODE_OUT_OF_RANGE, ".snapshot", "has a particle with a number that is not finite");
        return;
    }
}

/** Checks a start of a block or of the scene. */
static void check_start(checker *c, const sph2d_start *start, const char *key)
{
    subject s = {c, start, key};
    bool flow = start->flow.kind != SPH2D_FLOW_NONE, table = start->table.file || start->table.nx > 0;
    bool snapshot = start->snapshot.file || start->snapshot.count > 0;
    if (flow + table + snapshot > 1)
        sph2d_diagnostic_hint(fault(&s, SPH2D_CODE_CONFLICT, "", "starts with more than one thing"),
                              "give one of flow, table, snapshot");
    if (!flow && (start->flow.speed != 0 || start->flow.length != 0 || start->flow.depth != 0))
        sph2d_diagnostic_hint(fault(&s, SPH2D_CODE_MISSING_KEY, ".flow", "must be given"),
                              "speed, length and depth belong to a known flow");
    if (!table && !snapshot && start->top_speed > 0)
        fault(&s, SPH2D_CODE_CONFLICT, ".top_speed", "belongs to a table or a snapshot");
    check_table(&s);
    check_snapshot(&s);
}

/** Checks that the scene's own start is of something. */
static void check_own(checker *c)
{
    const sph2d_scene *scene = c->scene;
    const sph2d_method_options *m = &scene->method;
    bool particles = scene->particles.file || scene->particles.count > 0;
    if (!particles &&
        (scene->start.flow.kind != SPH2D_FLOW_NONE || scene->start.table.file || scene->start.table.nx > 0))
        sph2d_diagnostic_hint(
            sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "start", "is that of `particles`, of which there are none"),
            "move it to a block: `blocks: [{box: ..., start: ...}]`");
    if (!sph2d__starts_from_snapshot(scene) || m->sound_speed > 0 || m->stiffness > 0)
        return;
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, "start.snapshot",
                                             "does not determine the sound speed, as it is of another method");
    sph2d_diagnostic_hint(d, "give method.sound_speed, ten times the largest speed that you expect [m/s]");
}

void sph2d__check_starts(checker *c)
{
    char key[SPH2D__PATH_SIZE];
    for (size_t i = 0; i < c->scene->block_count; ++i)
        check_start(c, &c->scene->blocks[i].start, sph2d__check_path(key, "blocks", i, ".start"));
    check_start(c, &c->scene->start, "start");
    check_own(c);
}

/* ---- single particles --------------------------------------------------------------------------------------------- */

/** Checks a particle. */
static void check_particle(sph2d__checker *c, size_t i)
{
    const sph2d_particle *p = &c->scene->particles.items[i];
    char path[SPH2D__PATH_SIZE];
    sph2d__check_path(path, "particles", i, "");
    if (!isfinite(p->x) || !isfinite(p->y) || !isfinite(p->vx) || !isfinite(p->vy) || !isfinite(p->density))
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, "has a number that is missing or not finite");
    else if (!(p->density >= 0) && c->scene->fluid.density > 0)
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, "has a density below 0");
    else if (!sph2d__is_color(p->color))
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path,
                           "has a colour that is no whole number from 0 to 16777215, 65536 red + 256 green + blue");
    else if (!sph2d__check_in_domain(c->scene, (sph2d_vec2){p->x, p->y}))
        sph2d__check_outside(c, path, (sph2d_vec2){p->x, p->y});
}

/** Stops at the first error, as a wrong file may have one in every row. */
void sph2d__check_particles(sph2d__checker *c)
{
    const sph2d_particles *p = &c->scene->particles;
    if (!p->file && p->count == 0)
        return;
    const sph2d_method_options *m = &c->scene->method;
    if (!(m->sound_speed > 0) && !(m->stiffness > 0)) {
        sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, "particles",
                                                 "a list of particles does not determine the sound speed");
        sph2d_diagnostic_hint(d, "give method.sound_speed, ten times the largest speed that you expect [m/s]");
    }
    if (!p->items && p->count > 0)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "particles", "a count above 0 with a NULL list");
    for (size_t before = c->errors, i = 0; p->items && i < p->count && c->errors == before; ++i)
        check_particle(c, i);
}
