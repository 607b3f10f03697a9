/* SPDX-License-Identifier: MIT */
/** @file h5_limits.c
 *  The limits of what is read, for files whose makers are unknown: a checksum can be renewed by anyone. */
#include "files/h5_limits.h"

/** Maximum compression ratio of deflate: 258 bytes by two bits. */
enum { MAX_RATIO = 1032 };
/** Maximum bytes in a chunk; this program writes 512 KiB. HDF5 allocates a chunk before it reads it, and for deflate as
 *  much as comes out, up to MAX_RATIO chunks. */
enum { MAX_CHUNK_BYTES = 1 << 20 };
/** A stored chunk is no larger than its values, but some compressors add a little to what cannot be compressed. */
enum { CHUNK_MARGIN = 1024 };
/* ---- links ------------------------------------------------------------------------------------------------------- */

bool sph2d__h5_check_link(sph2d__h5_reader *r, hid_t at, const char *name)
{
    H5L_info_t link;
    if (H5Lexists(at, name, H5P_DEFAULT) <= 0 || H5Lget_info(at, name, &link, H5P_DEFAULT) < 0 ||
        link.type == H5L_TYPE_HARD)
        return true;
    const char *kind = link.type == H5L_TYPE_SOFT       ? "a soft link"
                       : link.type == H5L_TYPE_EXTERNAL ? "an external link"
                                                        : "a link of a kind of its own";
    sph2d_diagnostic_hint(
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.100s' is %s, which may lead out of the file", name, kind),
        "a snapshot has hard links only: put the group or dataset itself in its place");
    return false;
}

/* ---- storage ----------------------------------------------------------------------------------------------------- */

/** Nothing, deflate, shuffle, or shuffle and then deflate. Deflate twice would multiply its ratio. */
static bool usual_filters(hid_t properties)
{
    static const H5Z_filter_t order[] = {H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE};
    int count = H5Pget_nfilters(properties);
    size_t next = 0;
    for (int i = 0; i < count; ++i) {
        unsigned flags, config;
        size_t values = 0;
        H5Z_filter_t filter = H5Pget_filter2(properties, (unsigned)i, &flags, &values, NULL, 0, NULL, &config);
        while (next < sizeof order / sizeof *order && order[next] != filter)
            ++next;
        if (next++ == sizeof order / sizeof *order)
            return false;
    }
    return count >= 0;
}

/** What is wrong with the way that a dataset is stored; NULL if nothing. */
static const char *find_fault(hid_t properties, const char **hint)
{
    H5D_layout_t layout = H5Pget_layout(properties);
    *hint = "put the values themselves in this file";
    if (layout == H5D_VIRTUAL)
        return "is a virtual dataset, whose values are in other files";
    if (layout == H5D_CONTIGUOUS && H5Pget_external_count(properties) != 0)
        return "has its values in other files";
    *hint = "store it without a filter, or with deflate, or with shuffle and then deflate";
    if (layout == H5D_CHUNKED && !usual_filters(properties))
        return "has filters that are not accepted";
    *hint = NULL;
    return layout == H5D_CONTIGUOUS || layout == H5D_COMPACT || layout == H5D_CHUNKED ? NULL : "is damaged";
}

bool sph2d__h5_check_storage(sph2d__h5_reader *r, hid_t dataset, const char *name)
{
    hid_t properties = H5Dget_create_plist(dataset);
    const char *hint = NULL;
    const char *fault = properties >= 0 ? find_fault(properties, &hint) : "is damaged";
    if (properties >= 0)
        H5Pclose(properties);
    if (!fault)
        return true;
    sph2d_diagnostic *d = sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.100s' %s", name, fault);
    if (hint)
        sph2d_diagnostic_hint(d, "%s", hint);
    return false;
}

/* ---- sizes ------------------------------------------------------------------------------------------------------- */

static bool refuse_size(sph2d__h5_reader *r, const char *name)
{
    sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.100s' is damaged: it is larger than the file", name);
    return false;
}

/** Adds to the bytes of the file that were read. Each is read once; many names for one dataset do not add up. */
static bool take_bytes(sph2d__h5_reader *r, uint64_t bytes)
{
    if (bytes > r->file_bytes - r->taken_bytes)
        return false;
    r->taken_bytes += bytes;
    return true;
}

/** Whether a stored chunk can have its values: HDF5 does not compare what comes out of it with them. */
static bool chunk_fits(uint64_t bytes, uint64_t stored, bool deflated)
{
    return deflated ? stored > 0 && stored <= bytes + CHUNK_MARGIN && bytes / MAX_RATIO <= stored : stored == bytes;
}

/** Checks every chunk, as HDF5 would find it. `grid`: the numbers of chunks, of which there are not more than bytes. */
static bool chunks_fit(sph2d__h5_reader *r, const sph2d__h5_item *item, const hsize_t *chunk, const uint64_t *grid,
                       int deflate)
{
    for (uint64_t i = 0; i < grid[0]; ++i)
        for (uint64_t j = 0; j < grid[1]; ++j) {
            hsize_t offset[2] = {i * chunk[0], j * chunk[1]}, stored = 0;
            haddr_t address = HADDR_UNDEF;
            unsigned skipped = 0;
            if (H5Dget_chunk_info_by_coord(item->id, offset, &skipped, &address, &stored) < 0 || address == HADDR_UNDEF)
                return false;
            bool deflated = deflate >= 0 && (skipped >> deflate & 1) == 0;
            if (!chunk_fits(chunk[0] * chunk[1] * item->bytes, stored, deflated) || !take_bytes(r, stored))
                return false;
        }
    return true;
}

/** The place of deflate among the filters; -1 without. */
static int find_deflate(hid_t properties)
{
    for (int i = H5Pget_nfilters(properties) - 1; i >= 0; --i) {
        unsigned flags, config;
        size_t values = 0;
        if (H5Pget_filter2(properties, (unsigned)i, &flags, &values, NULL, 0, NULL, &config) == H5Z_FILTER_DEFLATE)
            return i;
    }
    return -1;
}

static bool check_chunks(sph2d__h5_reader *r, const sph2d__h5_item *item, hid_t properties, const char *name)
{
    hsize_t chunk[2] = {1, 1};
    if (H5Pget_chunk(properties, 2, chunk) != item->rank || chunk[0] == 0 || chunk[1] == 0)
        return refuse_size(r, name);
    if (chunk[0] > MAX_CHUNK_BYTES || chunk[1] > MAX_CHUNK_BYTES ||
        chunk[0] * chunk[1] > MAX_CHUNK_BYTES / item->bytes) {
        sph2d_diagnostic_hint(
            sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.100s' has chunks that are too large", name),
            "store it in chunks of at most %d KiB", MAX_CHUNK_BYTES / 1024);
        return false;
    }
    uint64_t grid[2] = {(item->sizes[0] + chunk[0] - 1) / chunk[0], (item->sizes[1] + chunk[1] - 1) / chunk[1]};
    if (grid[0] > r->file_bytes || grid[1] > r->file_bytes / grid[0] ||
        !chunks_fit(r, item, chunk, grid, find_deflate(properties)))
        return refuse_size(r, name);
    return true;
}

bool sph2d__h5_check_size(sph2d__h5_reader *r, const sph2d__h5_item *item, const char *name)
{
    uint64_t rows = item->sizes[0], columns = item->sizes[1];
    if (item->bytes == 0 || (columns > 0 && rows > UINT64_MAX / columns / item->bytes))
        return refuse_size(r, name);
    uint64_t bytes = rows * columns * item->bytes;
    if (bytes == 0)
        return true;
    if (item->is_attribute)
        return bytes <= r->file_bytes || refuse_size(r, name);
    hid_t properties = H5Dget_create_plist(item->id);
    if (properties < 0)
        return refuse_size(r, name);
    bool ok = H5Pget_layout(properties) == H5D_CHUNKED
                  ? check_chunks(r, item, properties, name)
                  : (bytes == H5Dget_storage_size(item->id) && take_bytes(r, bytes)) || refuse_size(r, name);
    H5Pclose(properties);
    return ok;
}

/* ---- types ------------------------------------------------------------------------------------------------------- */

bool sph2d__h5_usual_type(hid_t type)
{
    const hid_t numbers[] = {H5T_IEEE_F64LE, H5T_IEEE_F64BE, H5T_IEEE_F32LE, H5T_IEEE_F32BE, H5T_STD_U64LE,
                             H5T_STD_U64BE,  H5T_STD_I64LE,  H5T_STD_I64BE,  H5T_STD_U32LE,  H5T_STD_U32BE,
                             H5T_STD_I32LE,  H5T_STD_I32BE,  H5T_STD_U16LE,  H5T_STD_U16BE,  H5T_STD_I16LE,
                             H5T_STD_I16BE,  H5T_STD_U8LE,   H5T_STD_I8LE};
    if (H5Tget_class(type) == H5T_STRING)
        return H5Tis_variable_str(type) == 0;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; ++i)
        if (H5Tequal(type, numbers[i]) > 0)
            return true;
    return false;
}
