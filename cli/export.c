/* SPDX-License-Identifier: MIT */
/** @file export.c
 *  `sph2d export SNAPSHOT`: the liquid of a snapshot as CSV, one row per particle. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "compose.h"
#include "exit.h"
#include "snapshot.h"
#include "text.h"

/* Headings, in the order of columns; those of `particles` and `start.table` of a scene are the same. Other fields follow
 * by their own names. */
static const struct {
    const char *field, *headings[2];
} known[] = {{"ParticleIDs", {"id"}},         {"Coordinates", {"x", "y"}},
             {"Velocities", {"vx", "vy"}},    {"Densities", {"density"}},
             {"Pressures", {"pressure"}},     {"Masses", {"mass"}},
             {"Accelerations", {"ax", "ay"}}, {"SmoothingLengths", {"support_radius"}}};
enum { KNOWN = sizeof known / sizeof *known };

typedef struct row_of {
    uint64_t id;
    size_t index;
} row_of;

typedef struct export
{
    const sph2d_array **arrays; /* in the order of columns */
    size_t array_count, row_count;
    row_of *rows; /* by id: the order in memory changes from snapshot to snapshot */
}
export;

static size_t known_index(const char *field)
{
    size_t i = 0;
    while (i < KNOWN && strcmp(known[i].field, field) != 0)
        ++i;
    return i;
}

static int by_id(const void *a, const void *b)
{
    const row_of *p = a, *q = b;
    return p->id < q->id ? -1 : p->id > q->id;
}

/* False when memory is short. */
static bool collect(export *e, const sph2d_snapshot *snapshot)
{
    sph2d_state state = sph2d_snapshot_state(snapshot);
    e->arrays = calloc(state.array_count + 1, sizeof *e->arrays);
    if (!e->arrays)
        return false;
    for (size_t k = 0; k <= KNOWN; ++k)
        for (size_t i = 0; i < state.array_count; ++i)
            if (state.arrays[i].group == SPH2D_GROUP_FLUID && known_index(state.arrays[i].name) == k)
                e->arrays[e->array_count++] = &state.arrays[i];
    const sph2d_array *ids = sph2d_snapshot_array(snapshot, SPH2D_GROUP_FLUID, "ParticleIDs");
    e->row_count = ids ? ids->count : 0;
    e->rows = calloc(e->row_count + 1, sizeof *e->rows);
    if (!e->rows)
        return false;
    for (size_t i = 0; i < e->row_count; ++i)
        e->rows[i] = (row_of){((const uint64_t *)ids->data[0])[i * ids->stride], i};
    qsort(e->rows, e->row_count, sizeof *e->rows, by_id);
    return true;
}

static void put_headings(const export *e, FILE *out)
{
    static const char *const letters = "xy";
    for (size_t i = 0; i < e->array_count; ++i) {
        const sph2d_array *array = e->arrays[i];
        char unit[TEXT_SIZE];
        text_unit(unit, array->unit);
        size_t k = known_index(array->name);
        for (unsigned c = 0; c < array->components; ++c) {
            fputs(i + c > 0 ? "," : "", out);
            if (k < KNOWN)
                fputs(known[k].headings[c], out);
            else if (array->components > 1)
                fprintf(out, "%s_%c", array->name, letters[c]);
            else
                fputs(array->name, out);
            if (unit[0] != '\0')
                fprintf(out, " [%s]", unit);
        }
    }
    fputc('\n', out);
}

static void put_value(const sph2d_array *array, unsigned component, size_t index, FILE *out)
{
    size_t at = index * array->stride;
    if (array->type == SPH2D_F64)
        fprintf(out, "%.17g", ((const double *)array->data[component])[at]);
    else
        fprintf(out, "%" PRIu64, ((const uint64_t *)array->data[component])[at]);
}

static void put_csv(const void *what, FILE *out)
{
    const export *e = what;
    put_headings(e, out);
    for (size_t row = 0; row < e->row_count; ++row) {
        for (size_t i = 0; i < e->array_count; ++i)
            for (unsigned c = 0; c < e->arrays[i]->components; ++c) {
                fputs(i + c > 0 ? "," : "", out);
                put_value(e->arrays[i], c, e->rows[row].index, out);
            }
        fputc('\n', out);
    }
}

static sph2d_status write_csv(const export *e, const char *path, sph2d_report *report)
{
    if (!path) {
        put_csv(e, stdout);
        return SPH2D_OK;
    }
    size_t length = 0;
    char *text = compose(put_csv, e, &length);
    sph2d_status status = text ? sph2d_text_write(path, text, length, report) : SPH2D_NOMEM;
    free(text);
    return status;
}

static int check_usage(const cli_options *options)
{
    const char *path = options->output;
    size_t length = path ? strlen(path) : 0;
    if (options->operand_count != 1)
        message_usage("export", "one snapshot must be given");
    else if (path && (length < 5 || strcmp(path + length - 4, ".csv") != 0))
        message_usage("export", "--output: '%s' must end in .csv", path);
    else
        return CLI_EXIT_SUCCESS;
    return CLI_EXIT_USAGE;
}

int command_export(const cli_options *options)
{
    int code = check_usage(options);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    snapshot_note(options);
    sph2d_report report = {0};
    sph2d_snapshot *snapshot = NULL;
    export e = {0};
    sph2d_status status = snapshot_read(options, options->operands[0], &snapshot, &report);
    if (status == SPH2D_OK)
        status = collect(&e, snapshot) ? write_csv(&e, options->output, &report) : SPH2D_NOMEM;
    message_report(status, &report, NULL);
    if (status == SPH2D_OK && options->output)
        message_note("wrote %zu particles to '%s'", e.row_count, options->output);
    free(e.arrays);
    free(e.rows);
    sph2d_snapshot_destroy(snapshot);
    return exit_of_status(status);
}
