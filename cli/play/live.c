/* SPDX-License-Identifier: MIT */
/** @file live.c
 *  A simulation that follows the clock. What changes it goes on from the state of the run, in a simulation of the
 *  changed scene: so does what undoes that. */
#include "live.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sph2d/contacts.h>

#include "../clock.h"
#include "lists.h"

/* What a slow machine may be behind before time is left out [s of the clock]. */
static const double MOST_BEHIND = 0.1;

/* Counts the particles that left where their number has changed: a summary looks at all pairs. */
static void count_left(live *l)
{
    const size_t now = sph2d_sim_count(l->sim);
    if (now == l->counted)
        return;
    const sph2d_summary s = sph2d_sim_summary(l->sim);
    l->counted = now;
    l->left = s.left_open[0] + s.left_open[1] + s.left_open[2] + s.left_open[3];
}

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
    l->counted = SIZE_MAX;
    count_left(l);
    return SPH2D_OK;
}

const char *live_reason(sph2d_status status, const sph2d_report *report)
{
    size_t k = 0; /* warnings may stand before the error */
    while (k + 1 < report->count && report->items[k].severity != SPH2D_ERROR)
        ++k;
    return status == SPH2D_OK ? "" : report->count > 0 ? report->items[k].message : sph2d_status_text(status);
}

/* Notes whether steps can follow, or why not. */
static void note_stop(live *l, sph2d_status status, const sph2d_report *report)
{
    l->stopped = status;
    snprintf(l->why, sizeof l->why, "%s", live_reason(status, report));
}

static sph2d_status create(live *l, sph2d_report *report)
{
    sph2d_sim *sim = NULL;
    const sph2d_status made = sph2d_sim_create(&l->scene, &l->options, &sim, report);
    const sph2d_status status = take(l, sim, made);
    if (status == SPH2D_OK) {
        l->due = sph2d_sim_time(sim);
        note_stop(l, SPH2D_OK, report);
        l->ratio = 1;
        l->pace = 0;
    }
    return status;
}

sph2d_status live_open(live *l, sph2d_scene_file *file, const sph2d_sim_options *options, sph2d_report *report)
{
    *l = (live){.file = file, .scene = *sph2d_scene_file_scene(file), .options = *options};
    return live_restart(l, 0, report);
}

void live_close(live *l)
{
    sph2d_sim_destroy(l->sim);
    free(l->lists);
    past_free(&l->past);
    sph2d_scene_file_destroy(l->file);
    *l = (live){0};
}

sph2d_status live_restart(live *l, double spacing, sph2d_report *report)
{
    const sph2d_scene *given = sph2d_scene_file_scene(l->file);
    const sph2d_scene before = l->scene;
    l->scene.obstacles = given->obstacles;
    l->scene.obstacle_count = given->obstacle_count;
    l->scene.bodies = given->bodies;
    l->scene.body_count = given->body_count;
    l->scene.gravity = given->gravity;
    if (spacing > 0)
        l->scene.spacing = spacing;
    void *lists = lists_copy(&l->scene, NULL);
    const sph2d_status status = lists ? create(l, report) : SPH2D_NOMEM;
    if (status != SPH2D_OK) {
        l->scene = before;
        free(lists);
        return status;
    }
    free(l->lists);
    l->lists = lists;
    return SPH2D_OK;
}

double live_fitting_spacing(const live *l, double part)
{
    /* In two dimensions the cost of simulated time goes with the third power of the number of particles along a side. */
    return l->pace > 0 ? l->scene.spacing * cbrt(1 / (part * l->pace)) : 0;
}

/* ---- the clock --------------------------------------------------------------------------------------------------- */

sph2d_status live_step(live *l, sph2d_report *report)
{
    if (l->stopped != SPH2D_OK)
        return SPH2D_OK;
    note_stop(l, sph2d_sim_step(l->sim, report), report);
    count_left(l);
    l->due = fmax(l->due, sph2d_sim_time(l->sim));
    return l->stopped;
}

/* Adds to the paths of tracers, as a run does. */
static void follow_tracers(const live *l, sph2d_sim *sim)
{
    for (size_t k = 0; k < l->scene.probe_count; ++k)
        if (l->scene.probes[k].kind == SPH2D_PROBE_TRACER && sph2d_sim_output_due(sim, SPH2D_OUTPUT_PROBE + k))
            sph2d_sim_output_done(sim, SPH2D_OUTPUT_PROBE + k);
}

/* Whether the next step is due, and there is time for it; pours before it. */
static bool is_due(void *live_, sph2d_sim *sim)
{
    live *l = live_;
    follow_tracers(l, sim);
    const bool due = sph2d_sim_time(sim) + 0.5 * sph2d_sim_time_step(sim) < l->due && clock_wall() < l->deadline;
    return due && nozzle_emit(&l->nozzle, &l->scene, sim) == SPH2D_OK; /* without memory the next step tells */
}

sph2d_status live_advance(live *l, double seconds, double budget, sph2d_report *report)
{
    if (l->stopped != SPH2D_OK || !(seconds > 0))
        return SPH2D_OK;
    const double begun = clock_wall(), from = sph2d_sim_time(l->sim);
    l->due += seconds;
    l->deadline = begun + budget;
    note_stop(l, sph2d_sim_run(l->sim, is_due, l, report), report);
    l->nozzle.open = false;
    count_left(l);
    const double now = sph2d_sim_time(l->sim), share = fmin(seconds, 1), spent = clock_wall() - begun;
    if (now > from && spent > 0)
        l->pace += (l->pace > 0 ? 0.1 : 1) * ((now - from) / spent - l->pace);
    l->due = fmin(l->due, now + fmax(MOST_BEHIND * seconds / fmax(budget, 1e-3), sph2d_sim_time_step(l->sim)));
    l->ratio += share * ((now - from) / seconds - l->ratio);
    return l->stopped;
}

/* ---- changes ----------------------------------------------------------------------------------------------------- */

static bool has_lost_gravity(const live *l, const sph2d_scene *scene)
{
    const sph2d_vec2 own = sph2d_scene_file_scene(l->file)->gravity;
    return scene->gravity.x == 0 && scene->gravity.y == 0 && (own.x != 0 || own.y != 0);
}

/* Makes a simulation of a scene that goes on from a state. The state has the gravity of now; where that is none, the
 * scene's own says what the sound speed is. */
static sph2d_status restore(const live *l, const sph2d_scene *scene, const sph2d_state *state, sph2d_sim **sim,
                            sph2d_report *report)
{
    sph2d_scene with = *scene;
    if (has_lost_gravity(l, scene))
        with.gravity = sph2d_scene_file_scene(l->file)->gravity;
    return sph2d_sim_restore(&with, &l->options, state, sim, report);
}

/* ... in place of the present one. */
static sph2d_status go_on(live *l, const sph2d_scene *scene, const sph2d_state *state, sph2d_report *report)
{
    sph2d_sim *sim = NULL;
    const sph2d_status made = restore(l, scene, state, &sim, report);
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

sph2d_status live_give_colors(live *l, sph2d_report *report)
{
    if (sph2d_sim_colors(l->sim))
        return SPH2D_OK;
    sph2d_scene scene = l->scene;
    const char *usual = sph2d_materials(NULL)[scene.fluid.material].color;
    scene.fluid.color = usual ? usual : "water";
    return live_change(l, &scene, report);
}

/* A state without walls takes those of the scene, and no liquid is placed: where the scene's blocks were says nothing of
 * where it is now. */
sph2d_status live_rebuild(live *l, const sph2d_scene *scene, void *lists, bool anew, live_clear *clear,
                          const void *what, size_t *removed, sph2d_report *report)
{
    const sph2d_state run = sph2d_sim_state(l->sim);
    sph2d_array *arrays = malloc((run.array_count + 1) * sizeof *arrays);
    sph2d_state state = {run.version, arrays, 0};
    sph2d_sim *sim = NULL;
    sph2d_status status = lists && arrays && run.arrays ? SPH2D_OK : SPH2D_NOMEM;
    for (size_t i = 0; status == SPH2D_OK && i < run.array_count; ++i)
        if (run.arrays[i].group != SPH2D_GROUP_WALL && !(anew && strcmp(run.arrays[i].name, "Bodies") == 0))
            arrays[state.array_count++] = run.arrays[i];
    if (status == SPH2D_OK)
        status = restore(l, scene, &state, &sim, report);
    if (status == SPH2D_OK && clear)
        status = clear(l, sim, what, removed);
    status = take(l, sim, status);
    free(arrays);
    if (status != SPH2D_OK) {
        free(lists);
        return status;
    }
    free(l->lists);
    l->lists = lists;
    l->scene = *scene;
    return SPH2D_OK;
}

/* ---- drawn walls ------------------------------------------------------------------------------------------------- */

double live_clearance(const live *l)
{
    return 0.6 * l->scene.spacing;
}

double live_grasp(const live *l)
{
    return 1.5 * l->scene.spacing;
}

static size_t given_obstacles(const live *l)
{
    return sph2d_scene_file_scene(l->file)->obstacle_count;
}

double live_wall_thickness(const live *l)
{
    const double dx = l->scene.spacing;
    if (l->scene.method.name == SPH2D_METHOD_MULLER)
        return 0;
    return ceil(sph2d_sim_plan(l->sim)->support_radius / dx - 1e-9) * dx;
}

drawn_line live_divide(const live *l, const sph2d_vec2 *corners, size_t count)
{
    return drawn_divide(corners, count, live_wall_thickness(l) + 2 * live_clearance(l));
}

/* Removes the liquid in the way of a line, and counts it. */
static sph2d_status clear_way(const live *l, sph2d_sim *sim, const void *line_, size_t *removed)
{
    const drawn_line *line = line_;
    const double more = live_clearance(l);
    sph2d_status status = SPH2D_OK;
    *removed = 0;
    for (size_t k = 0; k < line->pieces && status == SPH2D_OK; ++k) {
        sph2d_vec2 corners[2 * DRAWN_MOST_CORNERS];
        size_t count = drawn_solid(line, k, live_wall_thickness(l) + 2 * more, more, corners), here = 0;
        const sph2d_shape shape = {.kind = SPH2D_SHAPE_POLYGON, .points = {corners, count}};
        status = sph2d_sim_remove_particles(sim, &shape, &here);
        *removed += here;
    }
    return status;
}

sph2d_status live_add_wall(live *l, const sph2d_vec2 *corners, size_t count, size_t *removed, sph2d_report *report)
{
    const drawn_line line = live_divide(l, corners, count);
    sph2d_scene scene = l->scene;
    void *lists = drawn_list(&scene, 0, 0, &line);
    return live_rebuild(l, &scene, lists, false, clear_way, &line, removed, report);
}

sph2d_status live_remove_wall(live *l, sph2d_vec2 at, bool *found, sph2d_report *report)
{
    size_t from, to;
    const double reach = live_wall_thickness(l) / 2 + live_grasp(l);
    drawn_find(&l->scene, given_obstacles(l), at, reach, &from, &to);
    *found = from < to;
    if (!*found)
        return SPH2D_OK;
    live_remember(l, "wall taken away");
    sph2d_scene scene = l->scene;
    void *lists = drawn_list(&scene, from, to, NULL);
    const sph2d_status status = live_rebuild(l, &scene, lists, false, NULL, NULL, NULL, report);
    if (status != SPH2D_OK)
        past_drop(&l->past);
    return status;
}

/* ---- acts -------------------------------------------------------------------------------------------------------- */

void live_remember(live *l, const char *name)
{
    const sph2d_state state = sph2d_sim_state(l->sim);
    past_keep(&l->past, name, &l->scene, &state);
}

sph2d_status live_undo(live *l, const char **name, sph2d_report *report)
{
    *name = NULL;
    if (l->past.count == 0)
        return SPH2D_OK;
    past_act *act = &l->past.acts[l->past.count - 1];
    const sph2d_state state = {SPH2D_STATE_VERSION, act->arrays, act->array_count};
    const sph2d_status status = go_on(l, &act->scene, &state, report);
    if (status != SPH2D_OK)
        return status;
    free(l->lists);
    l->lists = act->lists;
    act->lists = NULL;
    *name = act->name;
    past_drop(&l->past);
    l->due = sph2d_sim_time(l->sim);
    note_stop(l, SPH2D_OK, report);
    return SPH2D_OK;
}

uint64_t live_left(const live *l)
{
    return l->left;
}

sph2d_scene live_scene(const live *l)
{
    sph2d_scene scene = l->scene;
    if (has_lost_gravity(l, &scene) && !(scene.method.stiffness > 0))
        scene.method.sound_speed = sph2d_sim_plan(l->sim)->sound_speed;
    return scene;
}
