/* SPDX-License-Identifier: MIT */
/** @file snapshot_read.c
 *  Reads a snapshot into memory: first format and version, then everything in it, reporting all errors. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/null.h"
#include "files/snapshot.h"

/* ---- arrays ------------------------------------------------------------------------------------------------------ */

enum { BLOCK_ROWS = 16384 };
/** Maximum number of arrays of a state, which has about 50; the search for duplicates is quadratic. */
enum { MAX_ARRAYS = 4096 };

/** Sets type and shape of an array from an item; false, with a report, if they are invalid. */
static bool set_shape(sph2d__h5_reader *r, const sph2d__h5_item *item, const char *name, sph2d_array *array)
{
    H5T_class_t class = H5Tget_class(item->type);
    bool real = class == H5T_FLOAT && item->bytes == sizeof(double);
    bool integer = class == H5T_INTEGER && item->bytes == sizeof(uint64_t) && H5Tget_sign(item->type) == H5T_SGN_NONE;
    if (!real && !integer) {
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.100s' has the wrong type", name);
        return false;
    }
    size_t two = array->group == SPH2D_GROUP_RUN ? 2 : SPH2D__FILE_COMPONENTS; /* columns of two components */
    if (item->rank == 2 ? item->sizes[1] != two : array->group != SPH2D_GROUP_RUN && item->rank != 1) {
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.100s' has the wrong shape", name);
        return false;
    }
    array->type = real ? SPH2D_F64 : SPH2D_U64;
    array->components = item->rank == 2 ? 2 : 1;
    array->count = item->sizes[0];
    array->stride = 1;
    return true;
}

/** Reads the rows of an item into one array per component. */
static void read_values(sph2d__h5_reader *r, const sph2d__h5_item *item, const char *name, sph2d_array *array)
{
    size_t columns = item->sizes[1];
    hid_t type = array->type == SPH2D_F64 ? H5T_NATIVE_DOUBLE : H5T_NATIVE_UINT64;
    uint64_t *values[2] = {NULL, NULL};
    for (unsigned c = 0; c < array->components; ++c)
        array->data[c] = values[c] = sph2d__pool_alloc(r->pool, array->count + 1, sizeof *values[c]);
    uint64_t *block = malloc(BLOCK_ROWS * columns * sizeof *block);
    if (!values[0] || (array->components > 1 && !values[1]) || !block) {
        r->status = SPH2D_NOMEM;
    } else if (item->rank == 0) {
        sph2d__h5_item_read(r, item, type, values[0], name);
    } else {
        bool ok = true;
        for (size_t first = 0; ok && first < array->count; first += BLOCK_ROWS) {
            size_t rows = array->count - first < BLOCK_ROWS ? array->count - first : BLOCK_ROWS;
            ok = sph2d__h5_item_read_rows(r, item, type, first, rows, block, name);
            for (size_t i = 0; ok && i < rows; ++i)
                for (unsigned c = 0; c < array->components; ++c)
                    values[c][first + i] = block[i * columns + c];
        }
    }
    free(block);
}

/** Reads one array and appends it to the snapshot. */
static void read_array(sph2d__h5_reader *r, sph2d_snapshot *s, const char *in, sph2d_array array)
{
    sph2d__h5_item item;
    if (!sph2d__h5_item_open(r, in, array.name, &item))
        return;
    if (item.is_attribute && item.rank != 0)
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.100s' has the wrong shape", array.name);
    else if (set_shape(r, &item, array.name, &array))
        read_values(r, &item, array.name, &array);
    sph2d__h5_item_close(&item);
    s->arrays[s->array_count++] = array;
}

/** Splits "/PartType0/Coordinates". False if it is not the path of an array. */
static bool split(const char *path, const char **in, sph2d_group *group, const char **name)
{
    static const struct {
        const char *in;
        sph2d_group group;
    } groups[] = {{SPH2D__GROUP_FLUID, SPH2D_GROUP_FLUID},
                  {SPH2D__GROUP_WALLS, SPH2D_GROUP_WALL},
                  {SPH2D__GROUP_STATE, SPH2D_GROUP_RUN}};
    for (size_t i = 0; i < sizeof groups / sizeof groups[0]; ++i) {
        size_t length = strlen(groups[i].in);
        if (strncmp(path, groups[i].in, length) != 0 || path[length] != '/' || path[length + 1] == '\0')
            continue;
        *in = groups[i].in;
        *group = groups[i].group;
        *name = path + length + 1;
        return !strchr(*name, '/');
    }
    return false;
}

/** Reads the exponents of the units of `count` arrays; NULL after an error. */
static const signed char *read_units(sph2d__h5_reader *r, size_t count)
{
    sph2d__h5_item item;
    if (!sph2d__h5_item_open(r, SPH2D__GROUP_STATE, SPH2D__STATE_UNITS, &item))
        return NULL;
    signed char *units = sph2d__pool_alloc(r->pool, count + 1, 3);
    if (H5Tget_class(item.type) != H5T_INTEGER || item.rank != 2 || item.sizes[0] != count || item.sizes[1] != 3) {
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%s' has the wrong shape or type", SPH2D__STATE_UNITS);
        units = NULL;
    } else if (!units) {
        r->status = SPH2D_NOMEM;
    } else if (!sph2d__h5_item_read(r, &item, H5T_NATIVE_INT8, units, SPH2D__STATE_UNITS)) {
        units = NULL;
    }
    sph2d__h5_item_close(&item);
    return units;
}

static bool has_array(const sph2d_snapshot *s, sph2d_group group, const char *name)
{
    return sph2d_snapshot_array(s, group, name);
}

/** Checks an array against the field table. */
static void check_field(sph2d__h5_reader *r, const sph2d_snapshot *s, const sph2d_array *field)
{
    const sph2d_array *array = sph2d_snapshot_array(s, field->group, field->name);
    const sph2d_array *first = sph2d_snapshot_array(s, field->group, "Coordinates");
    if (!array || !first)
        return; /* reported */
    if (array->type != field->type || array->components != field->components)
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%s' has the wrong type or shape", field->name);
    else if (array->count != first->count)
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%s' has %zu values, 'Coordinates' has %zu", field->name,
                         array->count, first->count);
}

static void read_fields(sph2d__h5_reader *r, sph2d_snapshot *s, sph2d_group group, const char *in)
{
    for (size_t i = 0; i < sph2d_field_count(group); ++i) {
        sph2d_array field = sph2d_field(NULL, group, i);
        if (!has_array(s, group, field.name))
            read_array(r, s, in, field);
    }
    for (size_t i = 0; i < sph2d_field_count(group); ++i) {
        sph2d_array field = sph2d_field(NULL, group, i);
        check_field(r, s, &field);
    }
}

/** Reads the arrays listed in the state. */
static void read_state(sph2d__h5_reader *r, sph2d_snapshot *s)
{
    size_t count = 0, texts = 0;
    const char **paths = sph2d__h5_get_texts(r, SPH2D__GROUP_STATE, SPH2D__STATE_ARRAYS, &count);
    const char **descriptions = sph2d__h5_get_texts(r, SPH2D__GROUP_STATE, SPH2D__STATE_TEXTS, &texts);
    const signed char *units = paths ? read_units(r, count) : NULL;
    if (!paths || !descriptions || !units)
        return;
    if (texts != count || count > MAX_ARRAYS) {
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%s' has the wrong shape", SPH2D__STATE_ARRAYS);
        return;
    }
    size_t max_count = count + sph2d_field_count(SPH2D_GROUP_FLUID) + sph2d_field_count(SPH2D_GROUP_WALL) +
                       sph2d_field_count(SPH2D_GROUP_OUTLINE);
    s->arrays = sph2d__pool_alloc(r->pool, max_count, sizeof *s->arrays);
    if (!s->arrays) {
        r->status = SPH2D_NOMEM;
        return;
    }
    for (size_t i = 0; i < count && r->status != SPH2D_NOMEM; ++i) {
        const char *in;
        sph2d_array array = {.description = descriptions[i]};
        memcpy(array.unit, units + 3 * i, sizeof array.unit);
        if (!split(paths[i], &in, &array.group, &array.name))
            sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%s' has an entry that is not an array: '%.60s'",
                             SPH2D__STATE_ARRAYS, paths[i]);
        else if (has_array(s, array.group, array.name))
            sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%s' names '%.60s' twice", SPH2D__STATE_ARRAYS, paths[i]);
        else
            read_array(r, s, in, array);
    }
}

/** Reads all arrays. */
static void get_arrays(sph2d__h5_reader *r, sph2d_snapshot *s)
{
    read_state(r, s);
    if (!s->arrays)
        return;
    read_fields(r, s, SPH2D_GROUP_FLUID, SPH2D__GROUP_FLUID);
    read_fields(r, s, SPH2D_GROUP_WALL, SPH2D__GROUP_WALLS);
    read_fields(r, s, SPH2D_GROUP_OUTLINE, SPH2D__GROUP_OUTLINES);
}

/* ---- the file ---------------------------------------------------------------------------------------------------- */

/** Whether none of the groups is elsewhere. */
static bool groups_are_here(sph2d__h5_reader *r)
{
    static const char *const groups[] = {SPH2D__GROUP_HEADER, SPH2D__GROUP_CODE,    SPH2D__GROUP_PARAMETERS,
                                         SPH2D__GROUP_SCENE,  SPH2D__GROUP_FLUID,   SPH2D__GROUP_WALLS,
                                         SPH2D__GROUP_STATE,  SPH2D__GROUP_OUTLINES};
    bool here = true;
    for (size_t i = 0; i < sizeof groups / sizeof *groups; ++i)
        here = sph2d__h5_check_group(r, groups[i]) && here;
    return here;
}

/** Whether this is a complete snapshot of a supported version. */
static bool is_readable(sph2d__h5_reader *r, sph2d_snapshot *s)
{
    if (!sph2d__h5_has(r, "/", SPH2D__AT_FORMAT)) {
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_KIND, "this is an HDF5 file, but not a snapshot of sph2d");
        return false;
    }
    const char *format = sph2d__h5_get_text(r, "/", SPH2D__AT_FORMAT);
    if (format && strcmp(format, SPH2D__FORMAT) != 0)
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_KIND, "this is not a snapshot of sph2d, but '%.60s'", format);
    uint64_t version = 0, complete = 0;
    if (!sph2d__h5_has(r, "/", SPH2D__AT_COMPLETE) || !sph2d__h5_get_counts(r, "/", SPH2D__AT_COMPLETE, &complete, 1) ||
        complete != 1)
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_INCOMPLETE, "the file was not written completely");
    else if (sph2d__h5_get_counts(r, "/", SPH2D__AT_FORMAT_VERSION, &version, 1) &&
             sph2d__h5_get_counts(r, SPH2D__GROUP_STATE, SPH2D__AT_STATE_VERSION, &s->state_version, 1) &&
             (version != SPH2D__FORMAT_VERSION || s->state_version != SPH2D_STATE_VERSION)) {
        sph2d_diagnostic *d =
            sph2d__h5_refuse(r, SPH2D_CODE_FILE_VERSION, "the file has version %llu.%llu, this program reads %u.%u",
                             (unsigned long long)version, (unsigned long long)s->state_version, SPH2D__FORMAT_VERSION,
                             SPH2D_STATE_VERSION);
        const char *code = sph2d__h5_has(r, SPH2D__GROUP_CODE, SPH2D__AT_CODE_VERSION)
                               ? sph2d__h5_get_text(r, SPH2D__GROUP_CODE, SPH2D__AT_CODE_VERSION)
                               : NULL;
        if (code)
            sph2d_diagnostic_hint(d, "it was written by sph2d %.40s, this is %s", code, sph2d_version());
    }
    return r->status == SPH2D_OK;
}

static void read_metadata(sph2d__h5_reader *r, sph2d_snapshot *s)
{
    sph2d_snapshot_info *info = &s->info;
    const sph2d_scene *scene = &s->scene;
    sph2d__snapshot_get_parameters(r, &s->scene);
    info->scene_name = scene->name;
    info->domain = scene->domain;
    info->boundary = scene->boundary;
    info->spacing = scene->spacing;
    info->fluid = scene->fluid;
    info->frames = scene->run.frames;
    info->method = sph2d__h5_get_text(r, SPH2D__GROUP_PARAMETERS, "method.name");
    info->code_version = sph2d__h5_get_text(r, SPH2D__GROUP_CODE, SPH2D__AT_CODE_VERSION);
    info->isa = sph2d__h5_get_text(r, SPH2D__GROUP_CODE, SPH2D__AT_ISA);
    sph2d__h5_get_counts(r, SPH2D__GROUP_HEADER, SPH2D__AT_STEP, &info->steps, 1);
    sph2d__h5_get_reals(r, SPH2D__GROUP_HEADER, SPH2D__AT_TIME, &info->time, 1);
    sph2d__h5_get_reals(r, SPH2D__GROUP_HEADER, SPH2D__AT_TIME_STEP, &info->time_step, 1);
    sph2d__h5_get_reals(r, SPH2D__GROUP_HEADER, SPH2D__AT_SUPPORT, &info->support_radius, 1);
    sph2d__h5_get_reals(r, SPH2D__GROUP_HEADER, SPH2D__AT_SOUND_SPEED, &info->sound_speed, 1);
    if (!isfinite(info->time) || !isfinite(info->time_step) || !isfinite(info->support_radius) ||
        !isfinite(info->sound_speed))
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%s' has values that are not finite", SPH2D__GROUP_HEADER);
}

static void read_scene(sph2d__h5_reader *r, sph2d_snapshot *s)
{
    if (!sph2d__h5_has(r, SPH2D__GROUP_SCENE, SPH2D__SCENE_TEXT))
        return;
    s->info.scene_text = sph2d__h5_get_text(r, SPH2D__GROUP_SCENE, SPH2D__SCENE_TEXT);
    if (!sph2d__h5_has(r, SPH2D__GROUP_SCENE, SPH2D__SCENE_PATHS))
        return;
    size_t paths = 0, values = 0;
    const char **path = sph2d__h5_get_texts(r, SPH2D__GROUP_SCENE, SPH2D__SCENE_PATHS, &paths);
    const char **value = sph2d__h5_get_texts(r, SPH2D__GROUP_SCENE, SPH2D__SCENE_VALUES, &values);
    if (!path || !value)
        return;
    if (paths != values) {
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%s' has the wrong shape", SPH2D__SCENE_VALUES);
        return;
    }
    s->overrides = sph2d__pool_alloc(&s->pool, paths + 1, sizeof *s->overrides);
    if (!s->overrides) {
        r->status = SPH2D_NOMEM;
        return;
    }
    for (size_t i = 0; i < paths; ++i)
        s->overrides[i] = (sph2d_override){path[i], value[i]};
    s->override_count = paths;
}

static sph2d_status read_snapshot(const char *path, bool checked, sph2d_snapshot **snapshot, sph2d_report *report)
{
    if (!snapshot)
        return sph2d__null(report, __func__, "snapshot");
    *snapshot = NULL;
    if (!path)
        return sph2d__null(report, __func__, "path");
    sph2d_snapshot *s = calloc(1, sizeof *s);
    if (!s)
        return SPH2D_NOMEM;
    sph2d__h5_scope scope;
    sph2d__h5_reader r;
    if (!sph2d__h5_scope_begin(&scope)) {
        free(s);
        return SPH2D_NOMEM;
    }
    sph2d__h5_reader_open(&r, path, checked, &s->pool, report);
    if (r.status == SPH2D_OK && groups_are_here(&r) && is_readable(&r, s)) {
        read_metadata(&r, s);
        read_scene(&r, s);
        sph2d__snapshot_get_given(&r, &s->scene);
        get_arrays(&r, s);
    }
    sph2d__h5_reader_close(&r);
    sph2d__h5_scope_end(&scope);
    size_t size = strlen(path) + sizeof SPH2D__GROUP_SCENE "/" SPH2D__SCENE_TEXT;
    char *source = sph2d__pool_alloc(&s->pool, size, 1);
    if (!source && r.status == SPH2D_OK)
        r.status = SPH2D_NOMEM;
    if (r.status != SPH2D_OK) {
        sph2d_snapshot_destroy(s);
        return r.status;
    }
    snprintf(source, size, "%s%s/%s", path, SPH2D__GROUP_SCENE, SPH2D__SCENE_TEXT);
    s->scene_source = source;
    *snapshot = s;
    return SPH2D_OK;
}

sph2d_status sph2d_snapshot_read(const char *path, sph2d_snapshot **snapshot, sph2d_report *report)
{
    return read_snapshot(path, true, snapshot, report);
}

sph2d_status sph2d_snapshot_read_unchecked(const char *path, sph2d_snapshot **snapshot, sph2d_report *report)
{
    return read_snapshot(path, false, snapshot, report);
}

/* ---- what was read ----------------------------------------------------------------------------------------------- */

void sph2d_snapshot_destroy(sph2d_snapshot *snapshot)
{
    if (!snapshot)
        return;
    sph2d__pool_free(&snapshot->pool);
    free(snapshot);
}

sph2d_snapshot_info sph2d_snapshot_get_info(const sph2d_snapshot *snapshot)
{
    if (!snapshot)
        return (sph2d_snapshot_info){0};
    return snapshot->info;
}

sph2d_state sph2d_snapshot_state(const sph2d_snapshot *snapshot)
{
    if (!snapshot)
        return (sph2d_state){0};
    return (sph2d_state){snapshot->state_version, snapshot->arrays, snapshot->array_count};
}

const sph2d_array *sph2d_snapshot_array(const sph2d_snapshot *snapshot, sph2d_group group, const char *name)
{
    if (!snapshot || !name)
        return NULL;
    for (size_t i = 0; i < snapshot->array_count; ++i)
        if (snapshot->arrays[i].group == group && strcmp(snapshot->arrays[i].name, name) == 0)
            return &snapshot->arrays[i];
    return NULL;
}
