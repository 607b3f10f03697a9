/* SPDX-License-Identifier: MIT */
/** @file snapshot_vtk.c
 *  The fluid as VTKHDF poly data for ParaView. The particles' data is not copied: its datasets are linked. */
#include <stdio.h>
#include <stdlib.h>

#include "files/snapshot_parts.h"

/** Writes a dataset of the integers 0 to `count` - 1. */
static void put_numbers(sph2d__h5_writer *w, hid_t at, const char *name, size_t count)
{
    enum { BLOCK = 65536 };
    hid_t dataset = sph2d__h5_dataset(w, at, name, H5T_NATIVE_INT64, count, 0);
    int64_t *numbers = malloc(BLOCK * sizeof *numbers);
    sph2d__h5_check_memory(w, numbers != NULL);
    for (size_t first = 0; numbers && w->ok && first < count; first += BLOCK) {
        size_t rows = count - first < BLOCK ? count - first : BLOCK;
        for (size_t i = 0; i < rows; ++i)
            numbers[i] = (int64_t)(first + i);
        sph2d__h5_write_rows(w, dataset, H5T_NATIVE_INT64, first, rows, 0, numbers);
    }
    free(numbers);
    sph2d__h5_close(dataset);
}

/** Writes a dataset of one value. */
static void put_one(sph2d__h5_writer *w, hid_t at, const char *name, hid_t type, const void *value)
{
    hid_t dataset = sph2d__h5_dataset(w, at, name, type, 1, 0);
    sph2d__h5_write_rows(w, dataset, type, 0, 1, 0, value);
    sph2d__h5_close(dataset);
}

/** Writes cells of one point each. The reader requires all kinds of cells, so the others are empty: one group with
 *  three names. */
static void put_cells(sph2d__h5_writer *w, const char *kind, size_t count)
{
    char path[64];
    snprintf(path, sizeof path, "/VTKHDF/%s", kind);
    hid_t at = sph2d__h5_group(w, path);
    int64_t number = (int64_t)count;
    put_one(w, at, "NumberOfCells", H5T_NATIVE_INT64, &number);
    put_one(w, at, "NumberOfConnectivityIds", H5T_NATIVE_INT64, &number);
    put_numbers(w, at, "Offsets", count + 1);
    put_numbers(w, at, "Connectivity", count);
    sph2d__h5_close(at);
}

/** Links the fields of the fluid as point data, and the coordinates as points. */
static void link_fields(sph2d__h5_writer *w)
{
    sph2d__h5_close(sph2d__h5_group(w, "/VTKHDF/PointData"));
    for (size_t i = 0; i < sph2d_field_count(SPH2D_GROUP_FLUID); ++i) {
        const char *name = sph2d_field(NULL, SPH2D_GROUP_FLUID, i).name;
        char from[128], to[128];
        snprintf(from, sizeof from, SPH2D__GROUP_FLUID "/%.100s", name);
        snprintf(to, sizeof to, "/VTKHDF/PointData/%.100s", name);
        sph2d__h5_link(w, from, to);
    }
    sph2d__h5_link(w, SPH2D__GROUP_FLUID "/Coordinates", "/VTKHDF/Points");
}

void sph2d__snapshot_put_vtk(sph2d__h5_writer *w, const sph2d_sim *sim)
{
    static const int64_t version[2] = {2, 0};
    size_t count = sph2d_sim_fluid(sim).count;
    int64_t points = (int64_t)count;
    double time = sph2d_sim_time(sim);
    hid_t at = sph2d__h5_group(w, "/VTKHDF");
    sph2d__h5_put_ints(w, at, "Version", version, 2);
    sph2d__h5_put_text(w, at, "Type", "PolyData");
    put_one(w, at, "NumberOfPoints", H5T_NATIVE_INT64, &points);
    sph2d__h5_close(at);
    at = sph2d__h5_group(w, "/VTKHDF/FieldData");
    put_one(w, at, "TimeValue", H5T_NATIVE_DOUBLE, &time);
    sph2d__h5_close(at);
    link_fields(w);
    put_cells(w, "Vertices", count);
    put_cells(w, "Lines", 0);
    sph2d__h5_link(w, "/VTKHDF/Lines", "/VTKHDF/Polygons");
    sph2d__h5_link(w, "/VTKHDF/Lines", "/VTKHDF/Strips");
}
