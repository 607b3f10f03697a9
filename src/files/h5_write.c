/* SPDX-License-Identifier: MIT */
/** @file h5_write.c
 *  Wrappers of the HDF5 calls that snapshots need, with sticky errors. */
#include "files/h5_write.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/atomic_file.h"

/** Maximum size of an attribute: object header messages are limited to 64 KiB. */
enum { MAX_ATTRIBUTE_BYTES = 32 * 1024 };
/** Values in a chunk of a compressed dataset. */
enum { CHUNK_VALUES = 64 * 1024 };
/** Minimum number of rows of a compressed dataset. */
enum { MIN_COMPRESSED_ROWS = 64 };
/** Maximum number of attributes in an object's header. By default HDF5 moves more than eight to B-trees and heaps,
 *  which takes a tenth of a snapshot's time. */
enum { MAX_IN_HEADER = 4096 };

void sph2d__h5_check(sph2d__h5_writer *w, bool ok, const char *what)
{
    if (!w->ok || (ok && w->sink.error == 0))
        return;
    w->ok = false;
    if (w->sink.error != 0) {
        sph2d__report_errno(w->report, SPH2D_CODE_FILE_WRITE, "write", w->path, w->sink.error);
        return;
    }
    w->short_of_memory = errno == ENOMEM;
    char cause[200];
    sph2d__h5_cause(cause, sizeof cause);
    sph2d_report_add(w->report, SPH2D_ERROR, SPH2D_CODE_FILE_WRITE, NULL, "cannot write '%s': %s: %s", w->path, what,
                     cause);
}

void sph2d__h5_check_memory(sph2d__h5_writer *w, bool ok)
{
    w->short_of_memory = w->short_of_memory || !ok;
    w->ok = w->ok && ok;
}

/** Properties common to files, groups and datasets. */
static bool set_object(hid_t properties)
{
    return properties >= 0 && H5Pset_obj_track_times(properties, false) >= 0 &&
           H5Pset_attr_phase_change(properties, MAX_IN_HEADER, MAX_IN_HEADER / 2) >= 0;
}

void sph2d__h5_writer_open(sph2d__h5_writer *w, int fd, unsigned compress, const char *path, sph2d_report *report)
{
    *w = (sph2d__h5_writer){.path = path,
                            .report = report,
                            .sink = {.fd = fd},
                            .driver = H5I_INVALID_HID,
                            .file = H5I_INVALID_HID,
                            .group_properties = H5Pcreate(H5P_GROUP_CREATE),
                            .compress = compress,
                            .ok = true};
    errno = 0; /* HDF5 has no status for a lack of memory, but leaves malloc's errno */
    hid_t creation = H5Pcreate(H5P_FILE_CREATE);
    hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    bool ok = access >= 0 && set_object(creation) && set_object(w->group_properties);
    /* The newer one is that of virtual datasets alone. */
    ok = ok && H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V110) >= 0;
    ok = ok && H5Pset_fclose_degree(access, H5F_CLOSE_STRONG) >= 0;
    ok = ok && (w->driver = sph2d__h5_sink_driver(access, &w->sink)) >= 0;
    ok = ok && (w->file = H5Fcreate(path, H5F_ACC_TRUNC, creation, access)) >= 0;
    sph2d__h5_check(w, ok, "creating it");
    if (creation >= 0)
        H5Pclose(creation);
    if (access >= 0)
        H5Pclose(access);
}

sph2d_status sph2d__h5_writer_close(sph2d__h5_writer *w)
{
    if (w->file >= 0)
        sph2d__h5_check(w, H5Fclose(w->file) >= 0, "closing it");
    if (w->group_properties >= 0)
        H5Pclose(w->group_properties);
    if (w->driver >= 0)
        H5FDunregister(w->driver);
    return w->ok ? SPH2D_OK : w->short_of_memory ? SPH2D_NOMEM : SPH2D_IO;
}

hid_t sph2d__h5_group(sph2d__h5_writer *w, const char *path)
{
    if (!w->ok)
        return H5I_INVALID_HID;
    hid_t group = H5Gcreate2(w->file, path, H5P_DEFAULT, w->group_properties, H5P_DEFAULT);
    sph2d__h5_check(w, group >= 0, path);
    return group;
}

void sph2d__h5_close(hid_t object)
{
    if (object >= 0)
        H5Oclose(object);
}

static hid_t make_space(size_t rows, size_t columns)
{
    hsize_t sizes[2] = {rows, columns};
    return rows > 0 || columns > 0 ? H5Screate_simple(columns > 0 ? 2 : 1, sizes, NULL) : H5Screate(H5S_SCALAR);
}

/** Writes a complete dataset. */
static void put_dataset(sph2d__h5_writer *w, hid_t at, const char *name, hid_t type, hid_t space, const void *values)
{
    hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    bool ok = set_object(properties) && H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER) >= 0;
    hid_t dataset = ok ? H5Dcreate2(at, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT) : H5I_INVALID_HID;
    sph2d__h5_check(w, dataset >= 0 && H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0, name);
    sph2d__h5_close(dataset);
    if (properties >= 0)
        H5Pclose(properties);
}

void sph2d__h5_put(sph2d__h5_writer *w, hid_t at, const char *name, hid_t type, size_t rows, size_t columns,
                   const void *values)
{
    if (!w->ok)
        return;
    size_t bytes = H5Tget_size(type) * (rows > 0 ? rows : 1) * (columns > 0 ? columns : 1);
    hid_t space = make_space(rows, columns);
    sph2d__h5_check(w, space >= 0, name);
    if (w->ok && bytes > MAX_ATTRIBUTE_BYTES) {
        put_dataset(w, at, name, type, space, values);
    } else if (w->ok) {
        hid_t attribute = H5Acreate2(at, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
        sph2d__h5_check(w, attribute >= 0 && H5Awrite(attribute, type, values) >= 0, name);
        if (attribute >= 0)
            H5Aclose(attribute);
    }
    if (space >= 0)
        H5Sclose(space);
}

void sph2d__h5_put_reals(sph2d__h5_writer *w, hid_t at, const char *name, const double *values, size_t count)
{
    sph2d__h5_put(w, at, name, H5T_NATIVE_DOUBLE, count, 0, values);
}

void sph2d__h5_put_real(sph2d__h5_writer *w, hid_t at, const char *name, double value)
{
    sph2d__h5_put_reals(w, at, name, &value, 1);
}

void sph2d__h5_put_counts(sph2d__h5_writer *w, hid_t at, const char *name, const uint64_t *values, size_t count)
{
    sph2d__h5_put(w, at, name, H5T_NATIVE_UINT64, count, 0, values);
}

void sph2d__h5_put_ints(sph2d__h5_writer *w, hid_t at, const char *name, const int64_t *values, size_t count)
{
    sph2d__h5_put(w, at, name, H5T_NATIVE_INT64, count, 0, values);
}

/** The type of texts of `size` bytes, to be closed. ASCII texts are marked as such, which VTK requires. */
static hid_t text_type(size_t size, bool ascii)
{
    hid_t type = H5Tcopy(H5T_C_S1);
    if (type >= 0 && (H5Tset_size(type, size > 0 ? size : 1) < 0 || H5Tset_strpad(type, H5T_STR_NULLPAD) < 0 ||
                      H5Tset_cset(type, ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8) < 0)) {
        H5Tclose(type);
        type = H5I_INVALID_HID;
    }
    return type;
}

static bool is_ascii(const char *text)
{
    while (*text && (unsigned char)*text < 0x80)
        ++text;
    return !*text;
}

void sph2d__h5_put_text(sph2d__h5_writer *w, hid_t at, const char *name, const char *text)
{
    if (!w->ok)
        return;
    hid_t type = text_type(strlen(text), is_ascii(text));
    sph2d__h5_check(w, type >= 0, name);
    sph2d__h5_put(w, at, name, type, 0, 0, text);
    if (type >= 0)
        H5Tclose(type);
}

void sph2d__h5_put_document(sph2d__h5_writer *w, hid_t at, const char *name, const char *text)
{
    if (!w->ok)
        return;
    hid_t type = text_type(strlen(text), is_ascii(text));
    hid_t space = make_space(0, 0);
    sph2d__h5_check(w, type >= 0 && space >= 0, name);
    if (w->ok)
        put_dataset(w, at, name, type, space, text);
    if (type >= 0)
        H5Tclose(type);
    if (space >= 0)
        H5Sclose(space);
}

void sph2d__h5_put_texts(sph2d__h5_writer *w, hid_t at, const char *name, const char *const *texts, size_t count)
{
    size_t longest = 1;
    for (size_t i = 0; i < count; ++i)
        if (strlen(texts[i]) > longest)
            longest = strlen(texts[i]);
    char *block = calloc(count > 0 ? count : 1, longest);
    hid_t type = w->ok ? text_type(longest, false) : H5I_INVALID_HID;
    hid_t space = w->ok ? make_space(count, 0) : H5I_INVALID_HID;
    sph2d__h5_check(w, type >= 0 && space >= 0, name);
    sph2d__h5_check_memory(w, block);
    if (w->ok) {
        for (size_t i = 0; i < count; ++i)
            memcpy(block + i * longest, texts[i], strlen(texts[i]));
        put_dataset(w, at, name, type, space, block);
    }
    if (type >= 0)
        H5Tclose(type);
    if (space >= 0)
        H5Sclose(space);
    free(block);
}

hid_t sph2d__h5_dataset(sph2d__h5_writer *w, hid_t at, const char *name, hid_t type, size_t rows, size_t columns)
{
    if (!w->ok)
        return H5I_INVALID_HID;
    hsize_t sizes[2] = {rows, columns};
    int rank = columns > 0 ? 2 : 1;
    hid_t space = H5Screate_simple(rank, sizes, NULL);
    hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    bool ok = space >= 0 && set_object(properties) && H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER) >= 0;
    if (ok && w->compress > 0 && rows >= MIN_COMPRESSED_ROWS) {
        size_t max_rows = CHUNK_VALUES / (columns > 0 ? columns : 1);
        hsize_t chunk[2] = {rows < max_rows ? rows : max_rows, columns};
        ok = H5Pset_chunk(properties, rank, chunk) >= 0 && H5Pset_shuffle(properties) >= 0 &&
             H5Pset_deflate(properties, w->compress) >= 0;
    }
    hid_t dataset = ok ? H5Dcreate2(at, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT) : H5I_INVALID_HID;
    sph2d__h5_check(w, dataset >= 0, name);
    if (space >= 0)
        H5Sclose(space);
    if (properties >= 0)
        H5Pclose(properties);
    return dataset;
}

void sph2d__h5_write_rows(sph2d__h5_writer *w, hid_t dataset, hid_t type, size_t first, size_t count, size_t columns,
                          const void *values)
{
    if (!w->ok || count == 0)
        return;
    hsize_t start[2] = {first, 0}, sizes[2] = {count, columns};
    hid_t in_memory = H5Screate_simple(columns > 0 ? 2 : 1, sizes, NULL);
    hid_t in_file = H5Dget_space(dataset);
    bool ok = in_memory >= 0 && in_file >= 0 &&
              H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start, NULL, sizes, NULL) >= 0 &&
              H5Dwrite(dataset, type, in_memory, in_file, H5P_DEFAULT, values) >= 0;
    sph2d__h5_check(w, ok, "writing data");
    if (in_memory >= 0)
        H5Sclose(in_memory);
    if (in_file >= 0)
        H5Sclose(in_file);
}

/** Maps rows `first` on of a joined dataset to a part. */
static bool map_part(hid_t properties, hid_t space, size_t first, const sph2d__h5_part *part, size_t columns)
{
    hsize_t start[2] = {first, 0}, sizes[2] = {part->rows, columns};
    hid_t source = H5Screate_simple(columns > 0 ? 2 : 1, sizes, NULL);
    bool ok = source >= 0 && H5Sselect_hyperslab(space, H5S_SELECT_SET, start, NULL, sizes, NULL) >= 0 &&
              H5Pset_virtual(properties, space, ".", part->from, source) >= 0;
    if (source >= 0)
        H5Sclose(source);
    return ok;
}

void sph2d__h5_join(sph2d__h5_writer *w, hid_t at, const char *name, hid_t type, size_t columns,
                    const sph2d__h5_part *parts, size_t count, const void *fill)
{
    if (!w->ok)
        return;
    size_t rows = 0;
    for (size_t i = 0; i < count; ++i)
        rows += parts[i].rows;
    hsize_t sizes[2] = {rows, columns};
    hid_t space = H5Screate_simple(columns > 0 ? 2 : 1, sizes, NULL), properties = H5Pcreate(H5P_DATASET_CREATE);
    bool ok = space >= 0 && set_object(properties) && H5Pset_fill_value(properties, type, fill) >= 0;
    size_t first = 0;
    for (size_t i = 0; ok && i < count; first += parts[i++].rows)
        if (parts[i].from && parts[i].rows > 0)
            ok = map_part(properties, space, first, &parts[i], columns);
    ok = ok && H5Sselect_all(space) >= 0;
    hid_t dataset = ok ? H5Dcreate2(at, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT) : H5I_INVALID_HID;
    sph2d__h5_check(w, dataset >= 0, name);
    sph2d__h5_close(dataset);
    if (space >= 0)
        H5Sclose(space);
    if (properties >= 0)
        H5Pclose(properties);
}
