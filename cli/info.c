/* SPDX-License-Identifier: MIT */
/** @file info.c
 *  `sph2d info PATH...`: prints the contents of snapshots, and what became of runs. */
#include <dirent.h>
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "command.h"
#include "exit.h"
#include "input.h"
#include "json.h"
#include "loop.h"
#include "message.h"
#include "text.h"

/* ---- runs: all follows from the files there, and from the lock of a command that is at work ---------------------- */

enum { SERIES_NAME = 80 }; /* of a probe's name, at most 64 characters, and ".csv" */

/** What became of a run. */
typedef enum run_state {
    RUN_RUNNING,    /**< a command has locked the folder */
    RUN_FINISHED,   /**< run.until is reached */
    RUN_GUARD,      /**< stopped by a guard */
    RUN_STOPPED,    /**< stopped by a signal or --max-wall: there is a checkpoint */
    RUN_BROKEN_OFF, /**< none of these: killed, failed, or stopped just after a snapshot */
    RUN_UNKNOWN     /**< its snapshots have no scene, and so no end */
} run_state;

typedef struct run_info {
    cli_folder folder;
    newest_snapshot newest;      /**< from which it goes on */
    bool guarded;                /**< a guard fired ... */
    sph2d_snapshot *guard;       /**< ... at that moment */
    const sph2d_snapshot *shown; /**< the later of both */
    char shown_name[40];
    sph2d_scene_file *file; /**< NULL: the snapshots have no scene, or not one of this version */
    double until;           /**< [s]; NaN without a scene */
    bool resumable;         /**< the newest snapshot makes a simulation */
    run_state state;
    sph2d_summary summary; /**< NaN where it is not known */
    size_t snapshots, frames, series;
    double bytes;
    time_t first, last; /**< when the files were written; 0: there is none */
    bool short_of_memory;
} run_info;

/* ---- files ------------------------------------------------------------------------------------------------------- */

/* The path of a file in the folder, valid until the next call; NULL when memory is short, which is noted. */
static const char *path_of(run_info *r, const char *inside, const char *name)
{
    const char *path = folder_file(&r->folder, "%s%s", inside, name);
    r->short_of_memory = r->short_of_memory || !path;
    return path;
}

/* 1 for a file that is there, else 0. */
static size_t count_file(run_info *r, const char *inside, const char *name)
{
    const char *path = path_of(r, inside, name);
    struct stat file;
    if (!path || stat(path, &file) != 0)
        return 0;
    r->bytes += (double)file.st_size;
    if (r->first == 0 || file.st_mtime < r->first)
        r->first = file.st_mtime;
    if (file.st_mtime > r->last)
        r->last = file.st_mtime;
    return 1;
}

/* Counts the files PREFIX, digits, SUFFIX in the folder, or one inside; `inside` is "" or ends in a slash. */
static size_t count_numbered(run_info *r, const char *inside, const char *prefix, const char *suffix)
{
    const char *path = path_of(r, inside, "");
    DIR *listing = path ? opendir(path) : NULL;
    if (!listing) {
        r->short_of_memory = r->short_of_memory || errno == ENOMEM;
        return 0;
    }
    size_t count = 0;
    uint64_t number;
    const struct dirent *entry;
    while ((entry = readdir(listing)))
        if (folder_numbered(entry->d_name, prefix, suffix, &number))
            count += count_file(r, inside, entry->d_name);
    closedir(listing);
    return count;
}

static size_t count_series(run_info *r, const sph2d_scene *scene)
{
    size_t count = 0;
    for (size_t i = 0; i < scene->probe_count; ++i) {
        char name[SERIES_NAME];
        snprintf(name, sizeof name, "%s.csv", scene->probes[i].name);
        count += count_file(r, "", name);
    }
    return count;
}

static void count_files(run_info *r)
{
    r->snapshots = count_numbered(r, "", "snapshot_", ".h5");
    r->frames = count_numbered(r, "frames/", "frame_", ".png");
    count_file(r, "", "checkpoint.h5");
    count_file(r, "", "guard.h5");
    if (r->file)
        r->series = count_series(r, sph2d_scene_file_scene(r->file));
}

/* ---- state ------------------------------------------------------------------------------------------------------- */

static sph2d_status read_guard(run_info *r, const cli_options *options, sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    const char *path = path_of(r, "", "guard.h5");
    r->guarded = path && access(path, F_OK) == 0;
    if (r->guarded)
        r->guard = newest_try(options, path, report, &status);
    return status;
}

/* Which snapshot tells the state of the run. That of a guard goes away when the run is resumed. */
static void choose_shown(run_info *r)
{
    const newest_snapshot *newest = &r->newest;
    r->shown = r->guard ? r->guard : newest->snapshot;
    if (r->guard)
        snprintf(r->shown_name, sizeof r->shown_name, "guard.h5");
    else if (newest->saved == SAVED_IN_CHECKPOINT)
        snprintf(r->shown_name, sizeof r->shown_name, "checkpoint.h5");
    else
        snprintf(r->shown_name, sizeof r->shown_name, "snapshot_%06" PRIu64 ".h5", newest->number);
}

/* Whether a call succeeded that may do without; why not is told with --verbose. */
static bool succeeded(run_info *r, sph2d_status status, const char *what, sph2d_report *report)
{
    if (status == SPH2D_NOMEM)
        r->short_of_memory = true;
    else if (status != SPH2D_OK)
        message_detail("%s: %s", what, report->count > 0 ? report->items[0].message : sph2d_status_text(status));
    sph2d_report_clear(report);
    return status == SPH2D_OK;
}

/* A simulation of a snapshot; NULL if none can be made of it. */
static sph2d_sim *restore(run_info *r, const sph2d_snapshot *snapshot)
{
    sph2d_report report = {0};
    sph2d_sim *sim = NULL;
    const sph2d_state state = sph2d_snapshot_state(snapshot);
    const sph2d_status status = sph2d_sim_restore(sph2d_scene_file_scene(r->file), NULL, &state, &sim, &report);
    succeeded(r, status, "no simulation can be made of its state", &report);
    return sim;
}

/* What needs the scene: the end of the run, the summary that it would print now, and whether it can go on. */
static void read_scene(run_info *r)
{
    r->until = r->summary.energy_error = r->summary.energy_rise = r->summary.energy_scale = NAN;
    sph2d_report report = {0};
    const sph2d_status status = sph2d_snapshot_scene(r->shown, NULL, 0, &r->file, &report);
    if (!succeeded(r, status, "its scene cannot be read", &report))
        return;
    r->until = sph2d_scene_file_scene(r->file)->run.until;
    sph2d_sim *shown = restore(r, r->shown);
    if (shown)
        r->summary = sph2d_sim_summary(shown);
    sph2d_sim_destroy(shown);
    sph2d_sim *next = r->guard && r->newest.snapshot ? restore(r, r->newest.snapshot) : NULL;
    r->resumable = r->guard ? next != NULL : shown != NULL;
    sph2d_sim_destroy(next);
}

static run_state find_state(const run_info *r)
{
    if (folder_is_taken(&r->folder))
        return RUN_RUNNING;
    if (r->guarded)
        return RUN_GUARD;
    if (!r->file)
        return RUN_UNKNOWN;
    if (loop_reached(sph2d_snapshot_get_info(r->shown).time, r->until))
        return RUN_FINISHED;
    return r->newest.saved == SAVED_IN_CHECKPOINT ? RUN_STOPPED : RUN_BROKEN_OFF;
}

/* ---- the table --------------------------------------------------------------------------------------------------- */

static void print_state(const run_info *r, const sph2d_snapshot_info *info)
{
    static const char *const states[] = {
        [RUN_RUNNING] = "running: another sph2d is writing to the folder",
        [RUN_FINISHED] = "finished",
        [RUN_GUARD] = "stopped by a guard",
        [RUN_STOPPED] = "stopped by a signal or --max-wall",
        [RUN_BROKEN_OFF] = "not finished: killed, failed, or stopped just after this snapshot",
        [RUN_UNKNOWN] = "unknown: its snapshots have no scene that this version reads",
    };
    text_row("state", "%s", states[r->state]);
    if (isfinite(r->until))
        text_row("time", "%.6g s of %.6g s, after %" PRIu64 " steps, in %s", info->time, r->until, info->steps,
                 r->shown_name);
    else
        text_row("time", "%.6g s, after %" PRIu64 " steps, in %s", info->time, info->steps, r->shown_name);
    char folder[TEXT_WORD_SIZE];
    text_word(folder, r->folder.path);
    if (!r->resumable)
        text_row("resumable", "no");
    else if (r->state == RUN_FINISHED)
        text_row("resumable", "with a later end: sph2d resume %s --set run.until=T", folder);
    else if (r->state == RUN_RUNNING)
        text_row("resumable", "when that has ended");
    else
        text_row("resumable", "yes, from t = %.6g s: sph2d resume %s", sph2d_snapshot_get_info(r->newest.snapshot).time,
                 folder);
}

static char *text_time(char out[TEXT_SIZE], time_t when)
{
    struct tm local;
    if (!localtime_r(&when, &local) || strftime(out, TEXT_SIZE, "%Y-%m-%d %H:%M:%S", &local) == 0)
        snprintf(out, TEXT_SIZE, "unknown");
    return out;
}

static size_t particles_in(const sph2d_snapshot *snapshot, sph2d_group group)
{
    const sph2d_array *ids = sph2d_snapshot_array(snapshot, group, "ParticleIDs");
    return ids ? ids->count : 0;
}

static void print_run_table(const run_info *r)
{
    const sph2d_snapshot_info info = sph2d_snapshot_get_info(r->shown);
    const sph2d_summary *s = &r->summary;
    char bytes[TEXT_SIZE], first[TEXT_SIZE], last[TEXT_SIZE], span[TEXT_SIZE];
    text_row("folder", "%s", r->folder.path);
    text_row("scene", "%s", info.scene_name);
    text_row("written by", "sph2d %s, method %s, %s", info.code_version, info.method, info.isa);
    print_state(r, &info);
    text_row("particles", "%zu in the liquid, %zu in walls", particles_in(r->shown, SPH2D_GROUP_FLUID),
             particles_in(r->shown, SPH2D_GROUP_WALL));
    text_row("files", "snapshots %zu, frames %zu, series %zu; %s", r->snapshots, r->frames, r->series,
             text_bytes(bytes, r->bytes));
    text_row("written", "%s to %s: %s", text_time(first, r->first), text_time(last, r->last),
             text_seconds(span, difftime(r->last, r->first)));
    if (s->energy_scale > 0 && isfinite(s->energy_error))
        text_row("energy error", "%+.3g %% of the scene's %.4g J/m unaccounted for",
                 100 * s->energy_error / s->energy_scale, s->energy_scale);
    if (s->energy_scale > 0 && isfinite(s->energy_rise))
        text_row("", "at most %.3g %% came from nothing", 100 * s->energy_rise / s->energy_scale);
}

/* ---- JSON -------------------------------------------------------------------------------------------------------- */

static void print_run_object(const run_info *r)
{
    static const char *const states[] = {
        [RUN_RUNNING] = "running", [RUN_FINISHED] = "finished",     [RUN_GUARD] = "guard",
        [RUN_STOPPED] = "stopped", [RUN_BROKEN_OFF] = "broken_off", [RUN_UNKNOWN] = "unknown"};
    const sph2d_snapshot_info info = sph2d_snapshot_get_info(r->shown);
    cli_json line = json_begin(stdout);
    json_text(&line, "folder", r->folder.path);
    json_text(&line, "scene", info.scene_name);
    json_text(&line, "version", info.code_version);
    json_text(&line, "method", info.method);
    json_text(&line, "isa", info.isa);
    json_text(&line, "state", states[r->state]);
    json_number(&line, "time", info.time);
    json_number(&line, "until", r->until);
    json_count(&line, "steps", info.steps);
    json_text(&line, "newest", r->shown_name);
    json_flag(&line, "resumable", r->resumable);
    json_count(&line, "particles", particles_in(r->shown, SPH2D_GROUP_FLUID));
    json_count(&line, "wall_particles", particles_in(r->shown, SPH2D_GROUP_WALL));
    json_count(&line, "snapshots", r->snapshots);
    json_count(&line, "frames", r->frames);
    json_count(&line, "series", r->series);
    json_number(&line, "bytes", r->bytes);
    json_number(&line, "first_written", (double)r->first);
    json_number(&line, "last_written", (double)r->last);
    json_number(&line, "energy_error", r->summary.energy_error);
    json_number(&line, "energy_rise", r->summary.energy_rise);
    json_number(&line, "energy_scale", r->summary.energy_scale);
    json_end(&line);
}

/* ---- one folder -------------------------------------------------------------------------------------------------- */

static int refuse(const run_info *r)
{
    const char *path = r->folder.path;
    const char *hint = "a run writes snapshots if its scene has run.snapshots, and a checkpoint when it is stopped";
    if (folder_holds(path, "study.csv"))
        hint = "it is the folder of a study, whose numbers are in study.csv";
    else if (folder_is_taken(&r->folder))
        hint = "another sph2d is writing to it: there may be one later";
    message_error(SPH2D_CODE_FILE_OPEN, hint, "'%s' is not the folder of a run: it has no complete snapshot", path);
    return CLI_EXIT_NOINPUT;
}

static int look(run_info *r, const cli_options *options, sph2d_report *report)
{
    sph2d_status status = newest_find(&r->newest, options, &r->folder, report);
    if (status == SPH2D_OK)
        status = read_guard(r, options, report);
    message_report(status, report, NULL);
    if (status != SPH2D_OK)
        return exit_of_status(status);
    choose_shown(r);
    if (!r->shown && !r->short_of_memory)
        return refuse(r);
    if (r->shown)
        read_scene(r);
    count_files(r);
    r->state = find_state(r);
    if (r->short_of_memory)
        message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
    return r->short_of_memory ? CLI_EXIT_SOFTWARE : CLI_EXIT_SUCCESS;
}

/* Prints scene, state and files of the run in a folder, as a table or as JSON, and changes nothing in it. Returns an exit
 * code; a folder without a complete snapshot is an error. */
static int run_info_print(const cli_options *options, const char *path)
{
    run_info r = {0};
    sph2d_report report = {0};
    int code = folder_look(&r.folder, path);
    if (code == CLI_EXIT_SUCCESS)
        code = look(&r, options, &report);
    if (code == CLI_EXIT_SUCCESS && options->json)
        print_run_object(&r);
    else if (code == CLI_EXIT_SUCCESS)
        print_run_table(&r);
    sph2d_scene_file_destroy(r.file);
    sph2d_snapshot_destroy(r.newest.snapshot);
    sph2d_snapshot_destroy(r.guard);
    folder_close(&r.folder);
    return code;
}

/* ---- snapshots --------------------------------------------------------------------------------------------------- */

static const char *const group_names[] = {[SPH2D_GROUP_FLUID] = "fluid",
                                          [SPH2D_GROUP_WALL] = "wall",
                                          [SPH2D_GROUP_RUN] = "run",
                                          [SPH2D_GROUP_OUTLINE] = "outline"};

/* The groups as the table has them. */
static const sph2d_group groups[] = {SPH2D_GROUP_FLUID, SPH2D_GROUP_WALL, SPH2D_GROUP_OUTLINE, SPH2D_GROUP_RUN};
enum { GROUPS = sizeof groups / sizeof *groups };

static double value_of(const sph2d_array *array, unsigned component, size_t index)
{
    const void *data = array->data[component];
    size_t offset = index * array->stride;
    return array->type == SPH2D_F64 ? ((const double *)data)[offset] : (double)((const uint64_t *)data)[offset];
}

/* Minimum and maximum of one component; NaN for an empty array. */
static void find_range(const sph2d_array *array, unsigned component, double *min, double *max)
{
    *min = *max = NAN;
    for (size_t i = 0; i < array->count; ++i) {
        double value = value_of(array, component, i);
        *min = fmin(*min, value); /* fmin and fmax ignore NaN */
        *max = fmax(*max, value);
    }
}

/* ---- the table --------------------------------------------------------------------------------------------------- */

static void print_header(const char *path, const sph2d_snapshot_info *info)
{
    text_row("file", "%s", path);
    text_row("scene", "%s%s", info->scene_name, info->scene_text ? "" : " (from structs, without a file)");
    text_row("written by", "sph2d %s, method %s, %s", info->code_version, info->method, info->isa);
    text_row("time", "%.9g s after %" PRIu64 " steps; next step %.6g s", info->time, info->steps, info->time_step);
    text_row("domain", "[%g, %g] to [%g, %g] m", info->domain.min.x, info->domain.min.y, info->domain.max.x,
             info->domain.max.y);
    text_row("spacing", "%g m; support radius %g m", info->spacing, info->support_radius);
}

static void print_field(const sph2d_array *array)
{
    char unit[TEXT_SIZE];
    text_unit(unit, array->unit);
    for (unsigned k = 0; k < array->components; ++k) {
        double min, max;
        find_range(array, k, &min, &max);
        char shape[TEXT_SIZE] = "";
        if (k == 0)
            snprintf(shape, sizeof shape, "%zu x %u", array->count, array->components);
        const char *type = array->type == SPH2D_F64 ? "f64" : "u64";
        printf("  %-20s %-4s %12s %-10s", k == 0 ? array->name : "", k == 0 ? type : "", shape, k == 0 ? unit : "");
        if (array->count > 0)
            printf(" %14.6g %14.6g", min, max);
        putchar('\n');
    }
}

/* Prints the values of run scalars, the size of lists. */
static void print_run_array(const sph2d_array *array)
{
    char unit[TEXT_SIZE];
    text_unit(unit, array->unit);
    printf("  %-30s", array->name);
    for (unsigned k = 0; k < array->components && array->count == 1; ++k) {
        if (array->type == SPH2D_U64)
            printf(" %" PRIu64, *(const uint64_t *)array->data[k]);
        else
            printf(" %.9g", *(const double *)array->data[k]);
    }
    if (array->count != 1)
        printf(" %zu values", array->count);
    printf("%s%s\n", unit[0] != '\0' ? " " : "", unit);
}

static void print_table(const char *path, const sph2d_snapshot *snapshot)
{
    sph2d_snapshot_info info = sph2d_snapshot_get_info(snapshot);
    sph2d_state state = sph2d_snapshot_state(snapshot);
    print_header(path, &info);
    for (size_t g = 0; g < GROUPS; ++g) {
        const sph2d_group group = groups[g];
        if (group != SPH2D_GROUP_RUN)
            printf("%s\n  %-20s %-4s %12s %-10s %14s %14s\n", group_names[group], "field", "type", "shape", "unit",
                   "smallest", "largest");
        else
            printf("%s\n", group_names[group]);
        for (size_t i = 0; i < state.array_count; ++i) {
            if (state.arrays[i].group != group)
                continue;
            if (group == SPH2D_GROUP_RUN)
                print_run_array(&state.arrays[i]);
            else
                print_field(&state.arrays[i]);
        }
    }
}

/* ---- JSON -------------------------------------------------------------------------------------------------------- */

static void add_array(cli_json *line, const sph2d_array *array)
{
    char unit[TEXT_SIZE];
    json_open_object(line, NULL);
    json_text(line, "group", group_names[array->group]);
    json_text(line, "name", array->name);
    json_text(line, "description", array->description);
    json_text(line, "type", array->type == SPH2D_F64 ? "f64" : "u64");
    json_text(line, "unit", text_unit(unit, array->unit));
    json_count(line, "count", array->count);
    json_count(line, "components", array->components);
    json_open_array(line, "range");
    for (unsigned k = 0; k < array->components; ++k) {
        double min, max;
        find_range(array, k, &min, &max);
        json_pair(line, NULL, min, max);
    }
    json_close_array(line);
    json_close_object(line);
}

static void print_object(const char *path, const sph2d_snapshot *snapshot)
{
    sph2d_snapshot_info info = sph2d_snapshot_get_info(snapshot);
    sph2d_state state = sph2d_snapshot_state(snapshot);
    cli_json line = json_begin(stdout);
    json_text(&line, "file", path);
    json_text(&line, "scene", info.scene_name);
    json_text(&line, "version", info.code_version);
    json_text(&line, "method", info.method);
    json_text(&line, "isa", info.isa);
    json_number(&line, "time", info.time);
    json_number(&line, "time_step", info.time_step);
    json_count(&line, "steps", info.steps);
    json_open_object(&line, "domain");
    json_pair(&line, "min", info.domain.min.x, info.domain.min.y);
    json_pair(&line, "max", info.domain.max.x, info.domain.max.y);
    json_close_object(&line);
    json_number(&line, "spacing", info.spacing);
    json_number(&line, "support_radius", info.support_radius);
    json_flag(&line, "resumable", info.scene_text);
    json_open_array(&line, "arrays");
    for (size_t i = 0; i < state.array_count; ++i)
        add_array(&line, &state.arrays[i]);
    json_close_array(&line);
    json_end(&line);
}

static int print_snapshot(const cli_options *options, const char *path)
{
    sph2d_report report = {0};
    sph2d_snapshot *snapshot = NULL;
    sph2d_status status = snapshot_read(options, path, &snapshot, &report);
    message_report(status, &report, NULL);
    if (status == SPH2D_OK && options->json)
        print_object(path, snapshot);
    else if (status == SPH2D_OK)
        print_table(path, snapshot);
    sph2d_snapshot_destroy(snapshot);
    return exit_of_status(status);
}

int command_info(const cli_options *options)
{
    if (options->operand_count == 0) {
        message_usage("info", "a snapshot or the folder of a run must be given");
        return CLI_EXIT_USAGE;
    }
    snapshot_note(options);
    int code = CLI_EXIT_SUCCESS;
    for (size_t i = 0; i < options->operand_count; ++i) {
        const char *path = options->operands[i];
        struct stat status;
        const bool folder = stat(path, &status) == 0 && S_ISDIR(status.st_mode);
        const int ended = folder ? run_info_print(options, path) : print_snapshot(options, path);
        /* Reads all of them; the exit code is that of the first error. */
        if (code == CLI_EXIT_SUCCESS)
            code = ended;
    }
    return code;
}
