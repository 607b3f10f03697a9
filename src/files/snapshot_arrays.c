/* SPDX-License-Identifier: MIT */
/** @file snapshot_arrays.c
 *  Writes fields and state to a snapshot, as listed by the field table and the state. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files/snapshot.h"

/** Rows that are gathered in memory at a time. */
enum { BLOCK_ROWS = 16384 };

const char *sph2d__snapshot_group(sph2d_group group)
{
    return group == SPH2D_GROUP_FLUID     ? SPH2D__GROUP_FLUID
           : group == SPH2D_GROUP_WALL    ? SPH2D__GROUP_WALLS
           : group == SPH2D_GROUP_OUTLINE ? SPH2D__GROUP_OUTLINES
                                          : SPH2D__GROUP_STATE;
}

/* ---- one array --------------------------------------------------------------------------------------------------- */

static double power(double base, int exponent)
{
    double result = 1;
    for (int i = 0; i < abs(exponent); ++i)
        result *= base;
    return exponent < 0 ? 1 / result : result;
}

/** Appends " U_L^-3" or nothing. */
static void append_unit(char *out, size_t size, const char *unit, int exponent)
{
    size_t used = strlen(out);
    if (exponent == 1)
        snprintf(out + used, size - used, "%s%s", used > 0 ? " " : "", unit);
    else if (exponent != 0)
        snprintf(out + used, size - used, "%s%s^%d", used > 0 ? " " : "", unit, exponent);
}

/** Writes description and unit of a dataset as in SWIFT snapshots. */
static void describe(sph2d__h5_writer *w, hid_t dataset, const sph2d_array *array)
{
    int m = array->unit[0], kg = array->unit[1], s = array->unit[2];
    char units[64] = "", cgs[64] = "", expression[160];
    append_unit(units, sizeof units, "U_M", kg);
    append_unit(units, sizeof units, "U_L", m);
    append_unit(units, sizeof units, "U_t", s);
    append_unit(cgs, sizeof cgs, "g", kg);
    append_unit(cgs, sizeof cgs, "cm", m);
    append_unit(cgs, sizeof cgs, "s", s);
    snprintf(expression, sizeof expression, "%s%s[ %s ]", units, units[0] ? " " : "", cgs[0] ? cgs : "-");
    double to_cgs = power(1000, kg) * power(100, m);
    sph2d__h5_put_text(w, dataset, "Description", array->description ? array->description : "");
    sph2d__h5_put_text(w, dataset, "Expression for physical CGS units", expression);
    sph2d__h5_put_real(w, dataset, "Conversion factor to CGS (not including cosmological corrections)", to_cgs);
    sph2d__h5_put_real(w, dataset, "Conversion factor to physical CGS (including cosmological corrections)", to_cgs);
    sph2d__h5_put_real(w, dataset, "U_M exponent", kg);
    sph2d__h5_put_real(w, dataset, "U_L exponent", m);
    sph2d__h5_put_real(w, dataset, "U_t exponent", s);
    sph2d__h5_put_real(w, dataset, "U_I exponent", 0);
    sph2d__h5_put_real(w, dataset, "U_T exponent", 0);
    sph2d__h5_put_real(w, dataset, "a-scale exponent", 0);
    sph2d__h5_put_real(w, dataset, "h-scale exponent", 0);
}

static hid_t array_type(const sph2d_array *array)
{
    return array->type == SPH2D_F64 ? H5T_NATIVE_DOUBLE : H5T_NATIVE_UINT64;
}

/** Gathers `rows` rows from `first` on; columns beyond the components are 0. Both types have 8 bytes. */
static void gather(const sph2d_array *array, size_t first, size_t rows, size_t columns, uint64_t *block)
{
    size_t width = columns > 0 ? columns : 1;
    memset(block, 0, rows * width * sizeof *block);
    for (unsigned c = 0; c < array->components; ++c) {
        const char *data = array->data[c];
        for (size_t i = 0; i < rows; ++i)
            memcpy(&block[i * width + c], data + (first + i) * array->stride * sizeof *block, sizeof *block);
    }
}

/** Writes an array as a dataset of `columns` columns (0: one dimension). */
static void put_array(sph2d__h5_writer *w, hid_t at, const sph2d_array *array, size_t columns)
{
    _Static_assert(sizeof(double) == sizeof(uint64_t), "arrays have values of 8 bytes");
    hid_t dataset = sph2d__h5_dataset(w, at, array->name, array_type(array), array->count, columns);
    size_t block_rows = array->count < BLOCK_ROWS ? array->count : BLOCK_ROWS;
    uint64_t *block = malloc((block_rows > 0 ? block_rows : 1) * (columns > 0 ? columns : 1) * sizeof *block);
    sph2d__h5_check_memory(w, block);
    for (size_t first = 0; block && w->ok && first < array->count; first += block_rows) {
        size_t rows = array->count - first < block_rows ? array->count - first : block_rows;
        gather(array, first, rows, columns, block);
        sph2d__h5_write_rows(w, dataset, array_type(array), first, rows, columns, block);
    }
    free(block);
    if (w->ok)
        describe(w, dataset, array);
    sph2d__h5_close(dataset);
}

/* ---- groups of arrays -------------------------------------------------------------------------------------------- */

static bool is_field(sph2d_group group, const char *name)
{
    for (size_t i = 0; i < sph2d_field_count(group); ++i)
        if (strcmp(sph2d_field(NULL, group, i).name, name) == 0)
            return true;
    return false;
}

/** Writes the fields of fluid, walls or outlines, and the other arrays of them in the state. */
static void put_particles(sph2d__h5_writer *w, const sph2d_sim *sim, const sph2d_state *state, sph2d_group group)
{
    hid_t at = sph2d__h5_group(w, sph2d__snapshot_group(group));
    for (size_t i = 0; w->ok && i < sph2d_field_count(group); ++i) {
        sph2d_array field = sph2d_field(sim, group, i);
        put_array(w, at, &field, field.components > 1 ? SPH2D__FILE_COMPONENTS : 0);
    }
    for (size_t i = 0; w->ok && i < state->array_count; ++i) {
        const sph2d_array *array = &state->arrays[i];
        if (array->group == group && !is_field(group, array->name))
            put_array(w, at, array, array->components > 1 ? SPH2D__FILE_COMPONENTS : 0);
    }
    sph2d__h5_close(at);
}

/** Writes path, unit and description of all arrays of the state, in order. */
static void put_list(sph2d__h5_writer *w, hid_t at, const sph2d_state *state)
{
    enum { PATH_SIZE = 96 };
    size_t count = state->array_count;
    char *block = calloc(count + 1, PATH_SIZE);
    signed char(*units)[3] = calloc(count + 1, sizeof *units);
    const char **texts = calloc(2 * count + 1, sizeof *texts);
    bool ok = block && units && texts;
    sph2d__h5_check_memory(w, ok);
    for (size_t i = 0; ok && i < count; ++i) {
        const sph2d_array *array = &state->arrays[i];
        texts[i] = block + i * PATH_SIZE;
        snprintf(block + i * PATH_SIZE, PATH_SIZE, "%s/%s", sph2d__snapshot_group(array->group), array->name);
        texts[count + i] = array->description ? array->description : "";
        memcpy(units[i], array->unit, sizeof units[i]);
    }
    if (ok && w->ok) {
        sph2d__h5_put_texts(w, at, SPH2D__STATE_ARRAYS, texts, count);
        sph2d__h5_put_texts(w, at, SPH2D__STATE_TEXTS, texts + count, count);
        hid_t dataset = sph2d__h5_dataset(w, at, SPH2D__STATE_UNITS, H5T_NATIVE_INT8, count, 3);
        sph2d__h5_write_rows(w, dataset, H5T_NATIVE_INT8, 0, count, 3, units);
        sph2d__h5_close(dataset);
    }
    free(block);
    free(units);
    free(texts);
}

static void put_state(sph2d__h5_writer *w, const sph2d_state *state)
{
    hid_t at = sph2d__h5_group(w, SPH2D__GROUP_STATE);
    sph2d__h5_put_counts(w, at, SPH2D__AT_STATE_VERSION, &state->version, 0);
    put_list(w, at, state);
    for (size_t i = 0; w->ok && i < state->array_count; ++i) {
        const sph2d_array *array = &state->arrays[i];
        if (array->group != SPH2D_GROUP_RUN)
            continue;
        if (array->count == 1 && array->components == 1)
            sph2d__h5_put(w, at, array->name, array_type(array), 0, 0, array->data[0]);
        else
            put_array(w, at, array, array->components > 1 ? array->components : 0);
    }
    sph2d__h5_close(at);
}

void sph2d__snapshot_put_arrays(sph2d__h5_writer *w, const sph2d_sim *sim, const sph2d_state *state)
{
    put_particles(w, sim, state, SPH2D_GROUP_FLUID);
    put_particles(w, sim, state, SPH2D_GROUP_WALL);
    put_particles(w, sim, state, SPH2D_GROUP_OUTLINE);
    put_state(w, state);
}
