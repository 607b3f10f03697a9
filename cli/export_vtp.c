/* SPDX-License-Identifier: MIT */
/** @file export_vtp.c
 *  A snapshot as poly data for VTK: a header of XML, and behind it the values as they are in memory, which keeps every bit
 *  and takes less than half of the same in digits. The points are the liquid, the boundary particles and the corners of
 *  outlines, as in the group /VTKHDF of snapshots, which VTK reads from 9.3 on only. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "export.h"
#include "text.h"

/* The points, in order: the values of the field Kinds. */
static const sph2d_group kinds[] = {SPH2D_GROUP_FLUID, SPH2D_GROUP_WALL, SPH2D_GROUP_OUTLINE};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* Where a block of values belongs in the header. */
typedef enum section { FIELD_DATA, POINT_DATA, POINTS, VERTS, LINES, POLYS, SECTIONS } section;

/* Values behind the header: their size in bytes as a number of 8 bytes, and then they themselves. */
typedef struct block {
    section section;
    const char *name, *type;
    unsigned components;
    size_t offset;
} block;

typedef struct poly_data {
    const sph2d_snapshot *snapshot;
    size_t of[KINDS], all; /* numbers of points */
    size_t *order[KINDS];
    size_t cells[SECTIONS];
    block *blocks;
    size_t block_count;
    char *raw;
    size_t used;
} poly_data;

/* Adds a block of `bytes` bytes and returns where they go, until the next call; NULL when memory is short. */
static void *add_block(poly_data *p, section where, const char *name, const char *type, unsigned components,
                       size_t bytes)
{
    const uint64_t size = bytes;
    char *grown = realloc(p->raw, p->used + sizeof size + bytes);
    if (!grown)
        return NULL;
    p->raw = grown;
    p->blocks[p->block_count++] = (block){where, name, type, components, p->used};
    memcpy(grown + p->used, &size, sizeof size);
    p->used += sizeof size + bytes;
    return grown + p->used - bytes;
}

/* ---- points ------------------------------------------------------------------------------------------------------ */

/* False when memory is short. */
static bool count_points(poly_data *p)
{
    for (size_t k = 0; k < KINDS; ++k) {
        p->order[k] = export_order(p->snapshot, kinds[k], &p->of[k]);
        if (!p->order[k])
            return false;
        p->all += p->of[k];
    }
    return true;
}

/* Adds a field with the values of each kind of points that has it; elsewhere NaN or the largest number. Vectors have a
 * third component of 0. */
static bool add_field(poly_data *p, section where, const sph2d_array *field)
{
    const double no_real = NAN;
    const uint64_t no_count = UINT64_MAX;
    const bool real = field->type == SPH2D_F64;
    const unsigned width = field->components > 1 ? 3 : 1;
    char *to = add_block(p, where, field->name, real ? "Float64" : "UInt64", width, p->all * width * sizeof(double));
    if (!to)
        return false;
    for (size_t k = 0; k < KINDS; ++k) {
        const sph2d_array *from = sph2d_snapshot_array(p->snapshot, kinds[k], field->name);
        const bool has =
            from && from->type == field->type && from->components == field->components && from->count == p->of[k];
        for (size_t i = 0; i < p->of[k]; ++i, to += width * sizeof(double)) {
            memset(to, 0, width * sizeof(double));
            for (unsigned c = 0; c < (has ? field->components : width); ++c) {
                const void *value = real ? (const void *)&no_real : &no_count;
                if (has)
                    value = (const char *)from->data[c] + p->order[k][i] * from->stride * sizeof(double);
                memcpy(to + c * sizeof(double), value, sizeof(double));
            }
        }
    }
    return true;
}

static bool add_kinds(poly_data *p)
{
    unsigned char *to = add_block(p, POINT_DATA, "Kinds", "UInt8", 1, p->all);
    for (size_t k = 0; to && k < KINDS; to += p->of[k++])
        memset(to, (int)k, p->of[k]);
    return to;
}

/* Whether a field is that of a group before its own, too. */
static bool is_added(const poly_data *p, const sph2d_array *field)
{
    for (size_t k = 0; kinds[k] != field->group; ++k)
        if (sph2d_snapshot_array(p->snapshot, kinds[k], field->name))
            return true;
    return false;
}

static bool add_points(poly_data *p)
{
    const sph2d_state state = sph2d_snapshot_state(p->snapshot);
    bool ok = add_kinds(p);
    for (size_t k = 0; k < KINDS; ++k)
        for (size_t i = 0; ok && i < state.array_count; ++i) {
            const sph2d_array *field = &state.arrays[i];
            if (field->group == kinds[k] && !is_added(p, field))
                ok = add_field(p, strcmp(field->name, "Coordinates") == 0 ? POINTS : POINT_DATA, field);
        }
    return ok;
}

/* ---- cells ------------------------------------------------------------------------------------------------------- */

/* Adds cells: the numbers of their points one after the other, and where each of them ends. */
static bool add_cells(poly_data *p, section where, const int64_t *corners, size_t corner_count, const int64_t *ends,
                      size_t count)
{
    p->cells[where] = count;
    void *to = add_block(p, where, "connectivity", "Int64", 1, corner_count * sizeof *corners);
    if (to && corner_count > 0)
        memcpy(to, corners, corner_count * sizeof *corners);
    to = to ? add_block(p, where, "offsets", "Int64", 1, count * sizeof *ends) : NULL;
    if (to && count > 0)
        memcpy(to, ends, count * sizeof *ends);
    return to;
}

/* Every particle is a cell. */
static bool add_particles(poly_data *p)
{
    const size_t count = p->of[0] + p->of[1];
    int64_t *numbers = malloc((count + 1) * sizeof *numbers);
    for (size_t i = 0; numbers && i <= count; ++i)
        numbers[i] = (int64_t)i;
    const bool ok = numbers && add_cells(p, VERTS, numbers, count, numbers + 1, count);
    free(numbers);
    return ok;
}

/* A whole number of a corner of an outline. */
static uint64_t of_corner(const sph2d_array *array, size_t i)
{
    return array && i < array->count ? ((const uint64_t *)array->data[0])[i * array->stride] : 0;
}

/* The outlines that are solids, or the others. */
static bool add_outlines(poly_data *p, section where, bool solids)
{
    const size_t count = p->of[KINDS - 1], first = p->all - count;
    const sph2d_array *ids = sph2d_snapshot_array(p->snapshot, SPH2D_GROUP_OUTLINE, "OutlineIDs");
    const sph2d_array *sides = sph2d_snapshot_array(p->snapshot, SPH2D_GROUP_OUTLINE, "LiquidSides");
    int64_t *corners = malloc((2 * count + 1) * sizeof *corners);
    if (!corners)
        return false;
    int64_t *ends = corners + count;
    size_t corner_count = 0, cell_count = 0;
    for (size_t i = 0; i < count; ++i) {
        if ((of_corner(sides, i) == SPH2D_OUTLINE_LIQUID_OUTSIDE) != solids)
            continue;
        corners[corner_count++] = (int64_t)(first + i);
        if (i + 1 == count || of_corner(ids, i + 1) != of_corner(ids, i))
            ends[cell_count++] = (int64_t)corner_count;
    }
    const bool ok = add_cells(p, where, corners, corner_count, ends, cell_count);
    free(corners);
    return ok;
}

/* ---- the file ---------------------------------------------------------------------------------------------------- */

static bool is_little_endian(void)
{
    const uint16_t one = 1;
    unsigned char first;
    memcpy(&first, &one, 1);
    return first == 1;
}

static void put_section(const poly_data *p, section where, const char *tag, FILE *out)
{
    fprintf(out, "<%s>\n", tag);
    for (size_t i = 0; i < p->block_count; ++i) {
        const block *b = &p->blocks[i];
        if (b->section != where)
            continue;
        fprintf(out, "<DataArray type=\"%s\" Name=\"", b->type);
        export_xml_text(b->name, out);
        fprintf(out, "\" NumberOfComponents=\"%u\"%s format=\"appended\" offset=\"%zu\"/>\n", b->components,
                where == FIELD_DATA ? " NumberOfTuples=\"1\"" : "", b->offset);
    }
    fprintf(out, "</%s>\n", tag);
}

static void put_header(const void *what, FILE *out)
{
    const poly_data *p = what;
    fprintf(out,
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"%s\" header_type=\"UInt64\">\n<PolyData>\n",
            is_little_endian() ? "LittleEndian" : "BigEndian");
    put_section(p, FIELD_DATA, "FieldData", out);
    fprintf(out,
            "<Piece NumberOfPoints=\"%zu\" NumberOfVerts=\"%zu\" NumberOfLines=\"%zu\" NumberOfStrips=\"0\" "
            "NumberOfPolys=\"%zu\">\n",
            p->all, p->cells[VERTS], p->cells[LINES], p->cells[POLYS]);
    put_section(p, POINT_DATA, "PointData", out);
    put_section(p, POINTS, "Points", out);
    put_section(p, VERTS, "Verts", out);
    put_section(p, LINES, "Lines", out);
    put_section(p, POLYS, "Polys", out);
    fprintf(out, "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_");
}

/* False when memory is short. */
static bool collect(poly_data *p)
{
    const double time = sph2d_snapshot_get_info(p->snapshot).time;
    enum { OTHERS = 8 }; /* blocks that are no fields */
    p->blocks = calloc(sph2d_snapshot_state(p->snapshot).array_count + OTHERS, sizeof *p->blocks);
    void *to = p->blocks ? add_block(p, FIELD_DATA, "TimeValue", "Float64", 1, sizeof time) : NULL;
    if (to)
        memcpy(to, &time, sizeof time);
    return to && count_points(p) && add_points(p) && add_particles(p) && add_outlines(p, LINES, false) &&
           add_outlines(p, POLYS, true);
}

static sph2d_status write_file(const poly_data *p, const char *path, sph2d_report *report)
{
    static const char end[] = "\n</AppendedData>\n</VTKFile>\n";
    size_t length = 0;
    char *header = compose(put_header, p, &length);
    const size_t size = length + p->used + sizeof end - 1;
    char *file = header ? realloc(header, size) : NULL;
    if (!file) {
        free(header);
        return SPH2D_NOMEM;
    }
    memcpy(file + length, p->raw, p->used);
    memcpy(file + length + p->used, end, sizeof end - 1);
    const sph2d_status status = sph2d_text_write(path, file, size, report);
    free(file);
    return status;
}

sph2d_status export_vtp(const sph2d_snapshot *snapshot, const char *path, size_t *points, sph2d_report *report)
{
    poly_data p = {.snapshot = snapshot};
    const sph2d_status status = collect(&p) ? write_file(&p, path, report) : SPH2D_NOMEM;
    *points = p.all;
    for (size_t k = 0; k < KINDS; ++k)
        free(p.order[k]);
    free(p.blocks);
    free(p.raw);
    return status;
}
