/* SPDX-License-Identifier: MIT */
/** @file snapshot_vtk.c
 *  Fluid, boundary particles and outlines as one VTKHDF poly data for ParaView. Their data is not copied: the datasets of
 *  the group consist of those of the others. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files/snapshot.h"

/** The points, in order: the values of the field Kinds. */
static const sph2d_group kinds[] = {SPH2D_GROUP_FLUID, SPH2D_GROUP_WALL, SPH2D_GROUP_OUTLINE};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/** Numbers of points. */
typedef struct points {
    size_t of[KINDS], all;
} points;

static points count_points(const sph2d_sim *sim)
{
    points p = {.all = 0};
    for (size_t k = 0; k < KINDS; ++k)
        p.all += p.of[k] = sph2d_field(sim, kinds[k], 0).count;
    return p;
}

/* ---- datasets ---------------------------------------------------------------------------------------------------- */

/** Gives value `i` of a dataset of integers. */
typedef int64_t value_of(size_t i, const void *context);

/** Writes a dataset of `count` integers. */
static void put_integers(sph2d__h5_writer *w, hid_t at, const char *name, hid_t type, size_t count, value_of *value,
                         const void *context)
{
    enum { BLOCK = 65536 };
    hid_t dataset = sph2d__h5_dataset(w, at, name, type, count, 0);
    int64_t *numbers = malloc(BLOCK * sizeof *numbers);
    sph2d__h5_check_memory(w, numbers != NULL);
    for (size_t first = 0; numbers && w->ok && first < count; first += BLOCK) {
        size_t rows = count - first < BLOCK ? count - first : BLOCK;
        for (size_t i = 0; i < rows; ++i)
            numbers[i] = value(first + i, context);
        sph2d__h5_write_rows(w, dataset, H5T_NATIVE_INT64, first, rows, 0, numbers);
    }
    free(numbers);
    sph2d__h5_close(dataset);
}

static int64_t same_number(size_t i, const void *context)
{
    (void)context;
    return (int64_t)i;
}

static int64_t number_in_list(size_t i, const void *list)
{
    return ((const int64_t *)list)[i];
}

static int64_t kind_of_point(size_t i, const void *points_)
{
    const points *p = points_;
    return i < p->of[0] ? 0 : i < p->of[0] + p->of[1] ? 1 : 2;
}

/** Writes a dataset of one value. */
static void put_one(sph2d__h5_writer *w, hid_t at, const char *name, hid_t type, const void *value)
{
    hid_t dataset = sph2d__h5_dataset(w, at, name, type, 1, 0);
    sph2d__h5_write_rows(w, dataset, type, 0, 1, 0, value);
    sph2d__h5_close(dataset);
}

/* ---- cells ------------------------------------------------------------------------------------------------------- */

/** Cells of one kind, as the format has them. */
typedef struct cells {
    int64_t *offsets; /**< where in `corners` each begins, and where the last ends; NULL: of one point each */
    int64_t *corners; /**< numbers of points; NULL: 0, 1, 2, ... */
    size_t count, corner_count;
} cells;

static void put_cells(sph2d__h5_writer *w, const char *kind, const cells *c)
{
    char path[64];
    snprintf(path, sizeof path, "/VTKHDF/%s", kind);
    hid_t at = sph2d__h5_group(w, path);
    int64_t count = (int64_t)c->count, corner_count = (int64_t)c->corner_count;
    put_one(w, at, "NumberOfCells", H5T_NATIVE_INT64, &count);
    put_one(w, at, "NumberOfConnectivityIds", H5T_NATIVE_INT64, &corner_count);
    put_integers(w, at, "Offsets", H5T_NATIVE_INT64, c->count + 1, c->offsets ? number_in_list : same_number,
                 c->offsets);
    put_integers(w, at, "Connectivity", H5T_NATIVE_INT64, c->corner_count, c->corners ? number_in_list : same_number,
                 c->corners);
    sph2d__h5_close(at);
}

/** A field of the outlines, of which there is one value per corner. */
static const uint64_t *outline_field(const sph2d_sim *sim, const char *name)
{
    for (size_t i = 0; i < sph2d_field_count(SPH2D_GROUP_OUTLINE); ++i) {
        sph2d_array field = sph2d_field(sim, SPH2D_GROUP_OUTLINE, i);
        if (strcmp(field.name, name) == 0)
            return field.data[0];
    }
    return NULL;
}

/** Writes the outlines that are solids, or the others, as cells. */
static void put_outlines(sph2d__h5_writer *w, const sph2d_sim *sim, const points *p, const char *kind, bool solids)
{
    size_t count = p->of[KINDS - 1], first = p->all - count;
    const uint64_t *id = outline_field(sim, "OutlineIDs"), *liquid = outline_field(sim, "LiquidSides");
    cells c = {.offsets = calloc(count + 1, sizeof *c.offsets), .corners = calloc(count + 1, sizeof *c.corners)};
    bool ok = c.offsets && c.corners;
    sph2d__h5_check_memory(w, ok);
    for (size_t i = 0; ok && i < count; ++i) {
        if ((liquid[i] == SPH2D_OUTLINE_LIQUID_OUTSIDE) != solids)
            continue;
        c.corners[c.corner_count++] = (int64_t)(first + i);
        if (i + 1 == count || id[i + 1] != id[i])
            c.offsets[++c.count] = (int64_t)c.corner_count;
    }
    if (ok)
        put_cells(w, kind, &c);
    free(c.offsets);
    free(c.corners);
}

/* ---- fields ------------------------------------------------------------------------------------------------------ */

/** The dataset of a field in each group that has it, one after the other; elsewhere it has no value. */
static void join_field(sph2d__h5_writer *w, hid_t at, const char *as, const sph2d_array *field, const points *p)
{
    static const double nan_fill = NAN;
    static const uint64_t none = UINT64_MAX;
    char paths[KINDS][128];
    sph2d__h5_part parts[KINDS] = {{0}};
    for (size_t k = 0; k < KINDS; ++k) {
        parts[k].rows = p->of[k];
        snprintf(paths[k], sizeof paths[k], "%s/%.100s", sph2d__snapshot_group(kinds[k]), field->name);
        for (size_t i = 0; i < sph2d_field_count(kinds[k]) && !parts[k].from; ++i)
            if (strcmp(sph2d_field(NULL, kinds[k], i).name, field->name) == 0)
                parts[k].from = paths[k];
    }
    bool real = field->type == SPH2D_F64;
    sph2d__h5_join(w, at, as, real ? H5T_NATIVE_DOUBLE : H5T_NATIVE_UINT64,
                   field->components > 1 ? SPH2D__FILE_COMPONENTS : 0, parts, KINDS,
                   real ? (const void *)&nan_fill : (const void *)&none);
}

static void put_fields(sph2d__h5_writer *w, hid_t top, const points *p)
{
    hid_t at = sph2d__h5_group(w, "/VTKHDF/PointData");
    for (size_t i = 0; i < sph2d_field_count(SPH2D_GROUP_FLUID); ++i) {
        sph2d_array field = sph2d_field(NULL, SPH2D_GROUP_FLUID, i);
        join_field(w, at, field.name, &field, p);
        if (strcmp(field.name, "Coordinates") == 0)
            join_field(w, top, "Points", &field, p);
    }
    put_integers(w, at, "Kinds", H5T_NATIVE_UINT8, p->all, kind_of_point, p);
    sph2d__h5_close(at);
}

void sph2d__snapshot_put_vtk(sph2d__h5_writer *w, const sph2d_sim *sim)
{
    static const int64_t version[2] = {2, 0};
    const points p = count_points(sim);
    const cells vertices = {.count = p.of[0] + p.of[1], .corner_count = p.of[0] + p.of[1]}, none = {.count = 0};
    int64_t count = (int64_t)p.all;
    double time = sph2d_sim_time(sim);
    hid_t at = sph2d__h5_group(w, "/VTKHDF");
    sph2d__h5_put_ints(w, at, "Version", version, 2);
    sph2d__h5_put_text(w, at, "Type", "PolyData");
    put_one(w, at, "NumberOfPoints", H5T_NATIVE_INT64, &count);
    put_fields(w, at, &p);
    sph2d__h5_close(at);
    at = sph2d__h5_group(w, "/VTKHDF/FieldData");
    put_one(w, at, "TimeValue", H5T_NATIVE_DOUBLE, &time);
    sph2d__h5_close(at);
    put_cells(w, "Vertices", &vertices);
    put_outlines(w, sim, &p, "Lines", false);
    put_outlines(w, sim, &p, "Polygons", true);
    put_cells(w, "Strips", &none); /* the reader requires all kinds of cells */
}
