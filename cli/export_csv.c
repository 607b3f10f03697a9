/* SPDX-License-Identifier: MIT */
/** @file export_csv.c
 *  The liquid of a snapshot as CSV, one row per particle. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "export.h"
#include "text.h"

/* Headings, in the order of columns; those of `particles` and `start.table` of a scene are the same. Other fields follow
 * by their own names. */
static const struct {
    const char *field, *headings[2];
} known[] = {{"ParticleIDs", {"id"}},
             {"Coordinates", {"x", "y"}},
             {"Velocities", {"vx", "vy"}},
             {"Densities", {"density"}},
             {"Pressures", {"pressure"}},
             {"Masses", {"mass"}},
             {"Accelerations", {"ax", "ay"}},
             {"SmoothingLengths", {"support_radius"}},
             {"Colors", {"color"}}};
enum { KNOWN = sizeof known / sizeof *known };

typedef struct table {
    const sph2d_array **arrays; /* in the order of columns */
    size_t array_count, row_count;
    size_t *rows; /* by number of particle */
} table;

static size_t known_index(const char *field)
{
    size_t i = 0;
    while (i < KNOWN && strcmp(known[i].field, field) != 0)
        ++i;
    return i;
}

/* False when memory is short. */
static bool collect(table *t, const sph2d_snapshot *snapshot)
{
    sph2d_state state = sph2d_snapshot_state(snapshot);
    t->arrays = calloc(state.array_count + 1, sizeof *t->arrays);
    if (!t->arrays)
        return false;
    for (size_t k = 0; k <= KNOWN; ++k)
        for (size_t i = 0; i < state.array_count; ++i)
            if (state.arrays[i].group == SPH2D_GROUP_FLUID && known_index(state.arrays[i].name) == k)
                t->arrays[t->array_count++] = &state.arrays[i];
    t->rows = export_order(snapshot, SPH2D_GROUP_FLUID, &t->row_count);
    return t->rows;
}

static void put_headings(const table *t, FILE *out)
{
    static const char *const letters = "xy";
    for (size_t i = 0; i < t->array_count; ++i) {
        const sph2d_array *array = t->arrays[i];
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
    const table *t = what;
    put_headings(t, out);
    for (size_t row = 0; row < t->row_count; ++row) {
        for (size_t i = 0; i < t->array_count; ++i)
            for (unsigned c = 0; c < t->arrays[i]->components; ++c) {
                fputs(i + c > 0 ? "," : "", out);
                put_value(t->arrays[i], c, t->rows[row], out);
            }
        fputc('\n', out);
    }
}

static sph2d_status write_csv(const table *t, const char *path, sph2d_report *report)
{
    if (!path) {
        put_csv(t, stdout);
        return SPH2D_OK;
    }
    size_t length = 0;
    char *text = compose(put_csv, t, &length);
    sph2d_status status = text ? sph2d_text_write(path, text, length, report) : SPH2D_NOMEM;
    free(text);
    return status;
}

sph2d_status export_csv(const sph2d_snapshot *snapshot, const char *path, size_t *rows, sph2d_report *report)
{
    table t = {0};
    const sph2d_status status = collect(&t, snapshot) ? write_csv(&t, path, report) : SPH2D_NOMEM;
    *rows = t.row_count;
    free(t.arrays);
    free(t.rows);
    return status;
}
