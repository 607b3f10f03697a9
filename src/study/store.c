/* SPDX-License-Identifier: MIT */
/** @file store.c
 *  Rows that were run, kept as files named after all that they depend on: the key in front, then the record. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/null.h"
#include "base/random.h"
#include "study/parts.h"

enum { MOST_BYTES = 256 << 20 };

sph2d_status sph2d_study_row_key(const sph2d_study_results *results, sph2d_study_row *row, const char *program,
                                 sph2d_report *report)
{
    if (!results)
        return sph2d__null(report, __func__, "results");
    if (!row)
        return sph2d__null(report, __func__, "row");
    if (!program)
        return sph2d__null(report, __func__, "program");
    static const char format[] = "%s\nparticles from a file: %016" PRIx64 "\n%s";
    sph2d_scene_file *file;
    sph2d_status status = sph2d_study_run_scene(results, &row->run, &file, report);
    if (status != SPH2D_OK)
        return status;
    const sph2d_particles *particles = &sph2d_scene_file_scene(file)->particles;
    uint64_t hash = sph2d__hash(SPH2D__HASH_START, particles->items, particles->count * sizeof *particles->items);
    char *text = sph2d__scene_text(sph2d_scene_file_scene(file));
    size_t size = text ? strlen(program) + strlen(text) + sizeof format + 16 : 0;
    free(row->key);
    row->key = text ? malloc(size) : NULL;
    if (row->key)
        snprintf(row->key, size, format, program, hash, text);
    free(text);
    sph2d_scene_file_destroy(file);
    return row->key ? SPH2D_OK : SPH2D_NOMEM;
}

/** "FOLDER/HASH.row"; NULL when memory is short. The caller frees it. */
static char *path_of(const char *key, const char *folder)
{
    size_t size = strlen(folder) + 32;
    char *path = malloc(size);
    if (path)
        snprintf(path, size, "%s/%016" PRIx64 ".row", folder, sph2d__hash(SPH2D__HASH_START, key, strlen(key)));
    return path;
}

/** The whole of a file; NULL when there is none, or no memory. */
static char *read_file(const char *path, size_t *size)
{
    FILE *in = path ? fopen(path, "rb") : NULL;
    char *bytes = NULL;
    if (!in)
        return NULL;
    long end = fseek(in, 0, SEEK_END) == 0 ? ftell(in) : -1;
    rewind(in);
    *size = end > 0 && end <= MOST_BYTES ? (size_t)end : 0;
    bytes = *size > 0 ? malloc(*size) : NULL;
    bool whole = bytes && fread(bytes, 1, *size, in) == *size;
    fclose(in);
    if (!whole) {
        free(bytes);
        return NULL;
    }
    return bytes;
}

bool sph2d_study_row_find(const sph2d_study_results *results, sph2d_study_row *row, const char *folder)
{
    if (!results || !row || !folder || !row->key)
        return false;
    size_t size = 0, length = strlen(row->key);
    char *path = path_of(row->key, folder), *bytes = read_file(path, &size);
    row->there = bytes && size > length && memcmp(bytes, row->key, length) == 0 &&
                 sph2d_study_record_unpack(&row->record, bytes + length, size - length) == SPH2D_OK;
    free(path);
    free(bytes);
    if (row->there && (row->record.end > SPH2D_STUDY_GUARD || !sph2d__record_serves(results, &row->record))) {
        sph2d_study_record_free(&row->record);
        row->there = false;
    }
    return row->there;
}

sph2d_status sph2d_study_row_keep(const sph2d_study_row *row, const char *folder, sph2d_report *report)
{
    if (!row)
        return sph2d__null(report, __func__, "row");
    if (!folder)
        return sph2d__null(report, __func__, "folder");
    if (!row->key)
        return sph2d__null(report, __func__, "row->key");
    size_t length = strlen(row->key), size = length + sph2d_study_record_pack(&row->record, NULL, 0);
    char *path = path_of(row->key, folder), *bytes = malloc(size);
    sph2d_status status = SPH2D_NOMEM;
    if (path && bytes) {
        memcpy(bytes, row->key, length);
        sph2d_study_record_pack(&row->record, bytes + length, size - length);
        status = sph2d_text_write(path, bytes, size, report);
    }
    free(path);
    free(bytes);
    return status;
}
