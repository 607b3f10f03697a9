/* SPDX-License-Identifier: MIT */
/** @file info.c
 *  `sph2d info PATH...`: prints the contents of snapshots, and what became of runs. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <sys/stat.h>

#include "command.h"
#include "exit.h"
#include "json.h"
#include "message.h"
#include "run_info.h"
#include "snapshot.h"
#include "text.h"

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
