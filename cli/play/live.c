/* SPDX-License-Identifier: MIT */
/** @file live.c
 *  A simulation that follows the clock. A changed fluid goes on from the state of the run. A new wall needs boundary
 *  particles, which are placed when a simulation is made: so one is made of the scene with the wall, and goes on with the
 *  walls of its own state and everything else of the old one. */
#include "live.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sph2d/contacts.h>

#include "../clock.h"

/* What a slow machine may be behind before time is left out [s of the clock]. */
static const double MOST_BEHIND = 0.1;

/* Puts a simulation that was made, with its contacts, in place of the present one; or frees it. */
static sph2d_status take(live *l, sph2d_sim *sim, sph2d_status made)
{
    const sph2d_status status = made == SPH2D_OK ? sph2d_contacts_attach(sim) : made;
    if (status != SPH2D_OK) {
        sph2d_sim_destroy(sim);
        return status;
    }
    sph2d_sim_destroy(l->sim);
    l->sim = sim;
    return SPH2D_OK;
}

static sph2d_status create(live *l, sph2d_report *report)
{
    sph2d_sim *sim = NULL;
    const sph2d_status made = sph2d_sim_create(&l->scene, &l->options, &sim, report);
    const sph2d_status status = take(l, sim, made);
    if (status == SPH2D_OK) {
        l->due = sph2d_sim_time(sim);
        l->stopped = SPH2D_OK;
        l->ratio = 1;
        l->pace = 0;
    }
    return status;
}

sph2d_status live_open(live *l, sph2d_scene_file *file, const sph2d_sim_options *options, sph2d_report *report)
{
    *l = (live){.file = file, .scene = *sph2d_scene_file_scene(file), .options = *options};
    l->scene.obstacles = NULL;
    return live_restart(l, 0, report);
}

void live_close(live *l)
{
    sph2d_sim_destroy(l->sim);
    free(l->obstacles);
    free(l->corners);
    sph2d_scene_file_destroy(l->file);
    *l = (live){0};
}

sph2d_status live_restart(live *l, double spacing, sph2d_report *report)
{
    const sph2d_scene *given = sph2d_scene_file_scene(l->file);
    sph2d_obstacle *obstacles = malloc((given->obstacle_count + 1) * sizeof *obstacles);
    if (!obstacles)
        return SPH2D_NOMEM;
    if (given->obstacle_count > 0)
        memcpy(obstacles, given->obstacles, given->obstacle_count * sizeof *obstacles);
    const sph2d_scene before = l->scene;
    l->scene.obstacles = obstacles;
    l->scene.obstacle_count = given->obstacle_count;
    if (spacing > 0)
        l->scene.spacing = spacing;
    const sph2d_status status = create(l, report);
    if (status != SPH2D_OK) {
        l->scene = before;
        free(obstacles);
        return status;
    }
    free(l->obstacles);
    l->obstacles = obstacles;
    l->corner_count = 0;
    return SPH2D_OK;
}

/* ---- the clock --------------------------------------------------------------------------------------------------- */

sph2d_status live_step(live *l, sph2d_report *report)
{
    if (l->stopped != SPH2D_OK)
        return SPH2D_OK;
    l->stopped = sph2d_sim_step(l->sim, report);
    l->due = fmax(l->due, sph2d_sim_time(l->sim));
    return l->stopped;
}

/* Whether the next step is due, and there is time for it. */
static bool is_due(void *live_, sph2d_sim *sim)
{
    const live *l = live_;
    return sph2d_sim_time(sim) + 0.5 * sph2d_sim_time_step(sim) < l->due && clock_wall() < l->deadline;
}

sph2d_status live_advance(live *l, double seconds, double budget, sph2d_report *report)
{
    if (l->stopped != SPH2D_OK || !(seconds > 0))
        return SPH2D_OK;
    const double begun = clock_wall(), from = sph2d_sim_time(l->sim);
    l->due += seconds;
    l->deadline = begun + budget;
    l->stopped = sph2d_sim_run(l->sim, is_due, l, report);
    const double now = sph2d_sim_time(l->sim), share = fmin(seconds, 1), spent = clock_wall() - begun;
    if (now > from && spent > 0)
        l->pace += (l->pace > 0 ? 0.1 : 1) * ((now - from) / spent - l->pace);
    l->due = fmin(l->due, now + fmax(MOST_BEHIND * seconds / fmax(budget, 1e-3), sph2d_sim_time_step(l->sim)));
    l->ratio += share * ((now - from) / seconds - l->ratio);
    return l->stopped;
}

/* ---- changes ----------------------------------------------------------------------------------------------------- */

/* Makes a simulation of a scene that goes on from a state, in place of the present one. */
static sph2d_status go_on(live *l, const sph2d_scene *scene, const sph2d_state *state, sph2d_report *report)
{
    sph2d_sim *sim = NULL;
    const sph2d_status made = sph2d_sim_restore(scene, &l->options, state, &sim, report);
    const sph2d_status status = take(l, sim, made);
    if (status == SPH2D_OK)
        l->scene = *scene;
    return status;
}

sph2d_status live_change(live *l, const sph2d_scene *scene, sph2d_report *report)
{
    const sph2d_state state = sph2d_sim_state(l->sim);
    return state.arrays ? go_on(l, scene, &state, report) : SPH2D_NOMEM;
}

static const sph2d_array *find(const sph2d_state *state, sph2d_group group, const char *name)
{
    for (size_t i = 0; i < state->array_count; ++i)
        if (state->arrays[i].group == group && strcmp(state->arrays[i].name, name) == 0)
            return &state->arrays[i];
    return NULL;
}

/* The arrays of a state whose walls are those of another: everything of `run` but its walls. The number of the next
 * particle is above those of both. */
static sph2d_array *join(const sph2d_state *run, const sph2d_state *walls, uint64_t *next)
{
    sph2d_array *arrays = malloc((run->array_count + 1) * sizeof *arrays);
    for (size_t i = 0; arrays && i < run->array_count; ++i) {
        const sph2d_array *from = &run->arrays[i], *other = find(walls, from->group, from->name);
        arrays[i] = *from;
        if (from->group == SPH2D_GROUP_WALL && other)
            arrays[i] = *other;
        if (from->group == SPH2D_GROUP_RUN && strcmp(from->name, "NextParticleID") == 0 && other) {
            const uint64_t *a = from->data[0], *b = other->data[0];
            *next = *a > *b ? *a : *b;
            arrays[i].data[0] = next;
        }
    }
    return arrays;
}

/* Removes the liquid in the way of a line that becomes a solid of a thickness. */
static sph2d_status clear_way(live *l, const sph2d_vec2 *corners, size_t count, double thickness)
{
    sph2d_status status = SPH2D_OK;
    for (size_t k = 0; k < count && status == SPH2D_OK; ++k) {
        const sph2d_shape end = {.kind = SPH2D_SHAPE_DISC, .disc = {corners[k], thickness}};
        status = sph2d_sim_remove_particles(l->sim, &end, NULL);
        if (k + 1 == count || status != SPH2D_OK)
            break;
        const sph2d_vec2 a = corners[k], b = corners[k + 1];
        const double length = hypot(b.x - a.x, b.y - a.y), x = -(b.y - a.y) / length * thickness,
                     y = (b.x - a.x) / length * thickness;
        const sph2d_vec2 quad[4] = {{a.x + x, a.y + y}, {a.x - x, a.y - y}, {b.x - x, b.y - y}, {b.x + x, b.y + y}};
        const sph2d_shape piece = {.kind = SPH2D_SHAPE_POLYGON, .polygon = {quad, 4}};
        status = sph2d_sim_remove_particles(l->sim, &piece, NULL);
    }
    return status;
}

/* The scene with one more obstacle, a line with liquid on both sides. Its list and corners are new. */
static bool with_wall(const live *l, const sph2d_vec2 *corners, size_t count, sph2d_scene *out,
                      sph2d_obstacle **obstacle_list, sph2d_vec2 **kept)
{
    const size_t obstacles = l->scene.obstacle_count;
    sph2d_obstacle *list = malloc((obstacles + 1) * sizeof *list);
    sph2d_vec2 *all = malloc((l->corner_count + count) * sizeof *all);
    if (!list || !all) {
        free(list);
        free(all);
        return false;
    }
    if (l->corner_count > 0)
        memcpy(all, l->corners, l->corner_count * sizeof *all);
    memcpy(all + l->corner_count, corners, count * sizeof *all);
    if (obstacles > 0)
        memcpy(list, l->obstacles, obstacles * sizeof *list);
    sph2d_vec2 *next = all; /* the corners of earlier lines have moved */
    for (size_t k = sph2d_scene_file_scene(l->file)->obstacle_count; k < obstacles; ++k) {
        list[k].outline.polyline.items = next;
        next += list[k].outline.polyline.count;
    }
    list[obstacles] = sph2d_obstacle_default();
    list[obstacles].outline.kind = SPH2D_OUTLINE_POLYLINE;
    list[obstacles].outline.polyline = (sph2d_points){next, count};
    list[obstacles].liquid = SPH2D_LIQUID_BOTH;
    *out = l->scene;
    out->obstacles = list;
    out->obstacle_count = obstacles + 1;
    *obstacle_list = list;
    *kept = all;
    return true;
}

sph2d_status live_add_wall(live *l, const sph2d_vec2 *corners, size_t count, sph2d_report *report)
{
    sph2d_scene scene;
    sph2d_obstacle *list;
    sph2d_vec2 *kept;
    sph2d_sim *fresh = NULL;
    if (!with_wall(l, corners, count, &scene, &list, &kept))
        return SPH2D_NOMEM;
    sph2d_status status = sph2d_sim_create(&scene, &l->options, &fresh, report);
    const double support = sph2d_sim_plan(l->sim)->support_radius;
    if (status == SPH2D_OK)
        status = clear_way(l, corners, count, support / 2 + 0.75 * scene.spacing);
    if (status == SPH2D_OK) {
        const sph2d_state run = sph2d_sim_state(l->sim), walls = sph2d_sim_state(fresh);
        uint64_t next = 0;
        sph2d_array *arrays = run.arrays && walls.arrays ? join(&run, &walls, &next) : NULL;
        const sph2d_state joined = {run.version, arrays, run.array_count};
        status = arrays ? go_on(l, &scene, &joined, report) : SPH2D_NOMEM;
        free(arrays);
    }
    sph2d_sim_destroy(fresh);
    if (status != SPH2D_OK) {
        free(list);
        free(kept);
        return status;
    }
    free(l->obstacles);
    free(l->corners);
    l->obstacles = list;
    l->corners = kept;
    l->corner_count += count;
    return SPH2D_OK;
}
