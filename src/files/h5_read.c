/* SPDX-License-Identifier: MIT */
/** @file h5_read.c
 *  Attributes and datasets of a file that may be damaged, by makers who are unknown: a checksum can be renewed by anyone. So
 *  there are limits of what a file may consist of, which are checked before its data are read: everything is in the file
 *  itself, takes no more memory than the file can hold, and is stored in a way that needs no code beyond HDF5's own. */
#include "files/h5_read.h"

#include <errno.h>
#include <string.h>

/** Maximum compression ratio of deflate: 258 bytes by two bits. */
enum { MAX_RATIO = 1032 };
/** Maximum bytes in a chunk; this program writes 512 KiB. HDF5 allocates a chunk before it reads it, and for deflate as
 *  much as comes out, up to MAX_RATIO chunks. */
enum { MAX_CHUNK_BYTES = 1 << 20 };
/** A stored chunk is no larger than its values, but some compressors add a little to what cannot be compressed. */
enum { CHUNK_MARGIN = 1024 };

/* ---- limits: links ----------------------------------------------------------------------------------------------- */

/** Checks that a link is a hard one, or is not there; to be called before it is followed. False with a report. The links
 *  of a file are not listed: HDF5 1.10 frees what it never allocated if a group says that it has more than it has. */
static bool check_link(sph2d__h5_reader *r, hid_t at, const char *name)
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

/* ---- limits: storage --------------------------------------------------------------------------------------------- */

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

/** Checks where and how a dataset is stored; to be called before its type and space are asked for, since a virtual
 *  dataset opens other files then. False with a report. */
static bool check_storage(sph2d__h5_reader *r, hid_t dataset, const char *name)
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

/** Checks that the values of an item fit in the file, with all other items that were read. Type, rank, sizes and bytes
 *  are set. False with a report. */
static bool check_size(sph2d__h5_reader *r, const sph2d__h5_item *item, const char *name)
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

/* ---- limits: types ----------------------------------------------------------------------------------------------- */

/** Whether a type is one of the usual numbers, or a text of fixed length. HDF5 converts others by rules in the file. */
static bool usual_type(hid_t type)
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

/* ---- items ------------------------------------------------------------------------------------------------------- */

static sph2d_diagnostic *refuse_item(sph2d__h5_reader *r, const char *name, const char *what)
{
    return sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.100s' %s", name, what);
}

static bool read_failed(sph2d__h5_reader *r, const char *name)
{
    char cause[120];
    sph2d__h5_cause(cause, sizeof cause);
    sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.100s' cannot be read: %s", name, cause);
    return false;
}

static bool has_attribute(const sph2d__h5_reader *r, const char *group, const char *name)
{
    return H5Aexists_by_name(r->file, group, name, H5P_DEFAULT) > 0;
}

/** Whether a group has a dataset of a name. */
static bool has_dataset(const sph2d__h5_reader *r, const char *group, const char *name)
{
    bool top = strcmp(group, "/") == 0;
    hid_t at = top || H5Lexists(r->file, group, H5P_DEFAULT) > 0 ? H5Gopen2(r->file, group, H5P_DEFAULT) : -1;
    if (at < 0)
        return false;
    bool found = H5Lexists(at, name, H5P_DEFAULT) > 0;
    H5Gclose(at);
    return found;
}

bool sph2d__h5_has(sph2d__h5_reader *r, const char *group, const char *name)
{
    errno = 0;
    bool found = has_attribute(r, group, name) || has_dataset(r, group, name);
    if (!found && errno == ENOMEM)
        refuse_item(r, name, "cannot be looked for");
    return found;
}

bool sph2d__h5_check_group(sph2d__h5_reader *r, const char *group)
{
    return check_link(r, r->file, group);
}

/** Opens a dataset. False, with a report, if it is none. */
static bool open_dataset(sph2d__h5_reader *r, const char *group, const char *name, hid_t *id)
{
    hid_t at = H5Gopen2(r->file, group, H5P_DEFAULT);
    bool here = at < 0 || check_link(r, at, name);
    *id = at >= 0 && here ? H5Dopen2(at, name, H5P_DEFAULT) : H5I_INVALID_HID;
    if (at >= 0)
        H5Gclose(at);
    if (here && *id < 0)
        read_failed(r, name);
    return *id >= 0 && check_storage(r, *id, name);
}

static bool open_attribute(sph2d__h5_reader *r, const char *group, const char *name, hid_t *id)
{
    *id = H5Aopen_by_name(r->file, group, name, H5P_DEFAULT, H5P_DEFAULT);
    return *id >= 0 || read_failed(r, name);
}

/** Gets type and shape of an item; false, with a report, if they are damaged. */
static bool get_shape(sph2d__h5_reader *r, sph2d__h5_item *item, const char *name)
{
    item->type = item->is_attribute ? H5Aget_type(item->id) : H5Dget_type(item->id);
    item->space = item->is_attribute ? H5Aget_space(item->id) : H5Dget_space(item->id);
    if (item->type < 0 || item->space < 0)
        return read_failed(r, name);
    item->rank = H5Sget_simple_extent_ndims(item->space);
    hsize_t sizes[2] = {1, 1};
    if (item->rank < 0 || item->rank > 2 || H5Sget_simple_extent_type(item->space) == H5S_NULL ||
        H5Sget_simple_extent_dims(item->space, sizes, NULL) < 0) {
        refuse_item(r, name, "has the wrong shape");
        return false;
    }
    if (!usual_type(item->type)) {
        refuse_item(r, name, "has the wrong type");
        return false;
    }
    item->bytes = H5Tget_size(item->type);
    item->sizes[0] = sizes[0];
    item->sizes[1] = sizes[1];
    return check_size(r, item, name);
}

bool sph2d__h5_item_open(sph2d__h5_reader *r, const char *group, const char *name, sph2d__h5_item *item)
{
    *item = (sph2d__h5_item){.type = H5I_INVALID_HID, .space = H5I_INVALID_HID, .sizes = {1, 1}};
    item->is_attribute = has_attribute(r, group, name);
    if (!item->is_attribute && !has_dataset(r, group, name)) {
        item->id = H5I_INVALID_HID;
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.60s/%.60s' is missing", strcmp(group, "/") ? group : "", name);
        return false;
    }
    bool ok = item->is_attribute ? open_attribute(r, group, name, &item->id) : open_dataset(r, group, name, &item->id);
    ok = ok && get_shape(r, item, name);
    if (!ok)
        sph2d__h5_item_close(item);
    return ok;
}

void sph2d__h5_item_close(sph2d__h5_item *item)
{
    if (item->space >= 0)
        H5Sclose(item->space);
    if (item->type >= 0)
        H5Tclose(item->type);
    if (item->id >= 0 && item->is_attribute)
        H5Aclose(item->id);
    else if (item->id >= 0)
        H5Dclose(item->id);
    item->id = item->type = item->space = H5I_INVALID_HID;
}

bool sph2d__h5_item_read(sph2d__h5_reader *r, const sph2d__h5_item *item, hid_t type, void *out, const char *name)
{
    if (item->sizes[0] == 0 || item->sizes[1] == 0)
        return true;
    herr_t result =
        item->is_attribute ? H5Aread(item->id, type, out) : H5Dread(item->id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, out);
    return result >= 0 || read_failed(r, name);
}

bool sph2d__h5_item_read_rows(sph2d__h5_reader *r, const sph2d__h5_item *item, hid_t type, size_t first, size_t count,
                              void *out, const char *name)
{
    hsize_t start[2] = {first, 0}, sizes[2] = {count, item->sizes[1]};
    hid_t in_memory = H5Screate_simple(item->rank, sizes, NULL);
    bool ok = in_memory >= 0 && H5Sselect_hyperslab(item->space, H5S_SELECT_SET, start, NULL, sizes, NULL) >= 0 &&
              H5Dread(item->id, type, in_memory, item->space, H5P_DEFAULT, out) >= 0;
    if (in_memory >= 0)
        H5Sclose(in_memory);
    return ok || read_failed(r, name);
}

/* ---- items by name ----------------------------------------------------------------------------------------------- */

static bool get_numbers(sph2d__h5_reader *r, const char *group, const char *name, H5T_class_t class, hid_t type,
                        void *out, size_t count)
{
    sph2d__h5_item item;
    if (!sph2d__h5_item_open(r, group, name, &item))
        return false;
    bool ok = false;
    if (H5Tget_class(item.type) != class)
        refuse_item(r, name, "has the wrong type");
    else if (item.sizes[0] * item.sizes[1] != count)
        refuse_item(r, name, "has the wrong shape");
    else
        ok = sph2d__h5_item_read(r, &item, type, out, name);
    sph2d__h5_item_close(&item);
    return ok;
}

bool sph2d__h5_get_reals(sph2d__h5_reader *r, const char *group, const char *name, double *out, size_t count)
{
    return get_numbers(r, group, name, H5T_FLOAT, H5T_NATIVE_DOUBLE, out, count);
}

bool sph2d__h5_get_counts(sph2d__h5_reader *r, const char *group, const char *name, uint64_t *out, size_t count)
{
    return get_numbers(r, group, name, H5T_INTEGER, H5T_NATIVE_UINT64, out, count);
}

/** Reads an item of fixed-length texts as one block of NUL-terminated texts; NULL after an error. */
static char *get_text_block(sph2d__h5_reader *r, const char *group, const char *name, size_t *count, size_t *stride)
{
    sph2d__h5_item item;
    if (!sph2d__h5_item_open(r, group, name, &item))
        return NULL;
    char *block = NULL;
    *count = item.sizes[0] * item.sizes[1];
    *stride = item.bytes + 1;
    if (H5Tget_class(item.type) != H5T_STRING || H5Tis_variable_str(item.type) != 0) {
        refuse_item(r, name, "has the wrong type: expected a text of fixed length");
    } else if (!(block = sph2d__pool_alloc(r->pool, *count + 1, *stride))) {
        r->status = SPH2D_NOMEM;
    } else {
        hid_t type = H5Tcopy(item.type); /* one byte longer, for the NUL */
        bool ok = type >= 0 && H5Tset_size(type, *stride) >= 0 && H5Tset_strpad(type, H5T_STR_NULLTERM) >= 0;
        if (!ok || !sph2d__h5_item_read(r, &item, type, block, name))
            block = NULL;
        if (type >= 0)
            H5Tclose(type);
    }
    sph2d__h5_item_close(&item);
    return block;
}

const char *sph2d__h5_get_text(sph2d__h5_reader *r, const char *group, const char *name)
{
    size_t count, stride;
    char *text = get_text_block(r, group, name, &count, &stride);
    if (text && count != 1) {
        refuse_item(r, name, "has the wrong shape");
        return NULL;
    }
    return text;
}

const char **sph2d__h5_get_texts(sph2d__h5_reader *r, const char *group, const char *name, size_t *count)
{
    size_t stride;
    char *block = get_text_block(r, group, name, count, &stride);
    const char **texts = block ? sph2d__pool_alloc(r->pool, *count + 1, sizeof *texts) : NULL;
    if (block && !texts)
        r->status = SPH2D_NOMEM;
    for (size_t i = 0; texts && i < *count; ++i)
        texts[i] = block + i * stride;
    return texts;
}
