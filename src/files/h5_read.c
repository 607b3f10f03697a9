/* SPDX-License-Identifier: MIT */
/** @file h5_read.c
 *  Attributes and datasets of a file that may be damaged. */
#include "files/h5_read.h"

#include <errno.h>
#include <string.h>

#include "files/h5_limits.h"

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
    return sph2d__h5_check_link(r, r->file, group);
}

/** Opens a dataset. False, with a report, if it is none. */
static bool open_dataset(sph2d__h5_reader *r, const char *group, const char *name, hid_t *id)
{
    hid_t at = H5Gopen2(r->file, group, H5P_DEFAULT);
    bool here = at < 0 || sph2d__h5_check_link(r, at, name);
    *id = at >= 0 && here ? H5Dopen2(at, name, H5P_DEFAULT) : H5I_INVALID_HID;
    if (at >= 0)
        H5Gclose(at);
    if (here && *id < 0)
        read_failed(r, name);
    return *id >= 0 && sph2d__h5_check_storage(r, *id, name);
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
    if (!sph2d__h5_usual_type(item->type)) {
        refuse_item(r, name, "has the wrong type");
        return false;
    }
    item->bytes = H5Tget_size(item->type);
    item->sizes[0] = sizes[0];
    item->sizes[1] = sizes[1];
    return sph2d__h5_check_size(r, item, name);
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
