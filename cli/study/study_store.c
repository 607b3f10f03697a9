/* SPDX-License-Identifier: MIT */
/** @file study_store.c
 *  Rows that were run, by what they depend on. */
#include "study_store.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../build.h"
#include "../exit.h"
#include "study_measure.h"
#include "study_scene.h"
#include "study_text.h"

enum { MOST_BYTES = 256 << 20 };

/* FNV-1a (Fowler, Noll & Vo), 64 bits. */
static uint64_t add_to_hash(uint64_t hash, const void *bytes, size_t count)
{
    const unsigned char *c = bytes;
    for (size_t i = 0; i < count; ++i)
        hash = (hash ^ c[i]) * UINT64_C(0x100000001b3);
    return hash;
}

static const uint64_t HASH_START = UINT64_C(0xcbf29ce484222325);

/* ---- keys -------------------------------------------------------------------------------------------------------- */

static void put_key(const cli_study *s, const sph2d_scene *scene, const char *text, FILE *out)
{
    char processor[256];
    const sph2d_particles *particles = &scene->particles;
    sph2d_isa isa = s->options->isa;
    for (int i = SPH2D_ISA_BASELINE; s->options->isa == SPH2D_ISA_AUTO && i <= SPH2D_ISA_AVX512; ++i)
        if (sph2d_isa_available((sph2d_isa)i))
            isa = (sph2d_isa)i;
    uint64_t hash = add_to_hash(HASH_START, particles->items, particles->count * sizeof *particles->items);
    fprintf(out, "sph2d %s, source %s, %s, %s\n", sph2d_version(), build_source, build_compiler, build_flags);
    fprintf(out, "threads %d, isa %s, repeat %" PRIu64 ", %s\n", s->threads.count, sph2d_isa_name(isa), s->repeat,
            build_processor(processor, sizeof processor));
    fprintf(out, "particles from a file: %016" PRIx64 "\n%s", hash, text);
}

char *study_store_key(cli_study *s, const sph2d_study_run *run)
{
    sph2d_scene_file *file;
    if (study_scene_open(s, run, &file) != CLI_EXIT_SUCCESS)
        return NULL;
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    study_text page;
    size_t length = sph2d_scene_text(scene, NULL, 0);
    char *text = malloc(length + 1), *key = NULL;
    if (text != NULL && length > 0 && study_text_begin(&page)) {
        sph2d_scene_text(scene, text, length + 1);
        put_key(s, scene, text, page.out);
        key = study_text_take(&page);
    }
    free(text);
    sph2d_scene_file_destroy(file);
    return key;
}

static const char *path_of(cli_study *s, const char *key)
{
    return folder_file(&s->folder, "rows/%016" PRIx64 ".row", add_to_hash(HASH_START, key, strlen(key)));
}

/* ---- files ------------------------------------------------------------------------------------------------------- */

/* The whole of a file with a NUL behind it; NULL when there is none, or no memory. */
static char *read_file(const char *path)
{
    FILE *in = fopen(path, "rb");
    char *text = NULL;
    if (in == NULL)
        return NULL;
    if (fseek(in, 0, SEEK_END) == 0) {
        long size = ftell(in);
        text = size >= 0 && size <= MOST_BYTES ? calloc((size_t)size + 1, 1) : NULL;
        rewind(in);
        if (text != NULL && fread(text, 1, (size_t)size, in) != (size_t)size) {
            free(text);
            text = NULL;
        }
    }
    fclose(in);
    return text;
}

bool study_store_find(cli_study *s, const char *key, study_record *record)
{
    const char *path = s->options->output != NULL ? path_of(s, key) : NULL;
    char *text = path != NULL ? read_file(path) : NULL;
    size_t length = strlen(key);
    bool found = text != NULL && strncmp(text, key, length) == 0 && study_record_read(record, text + length) &&
                 record->end <= STUDY_GUARD && study_measure_possible(s, record);
    free(text);
    if (!found)
        study_record_free(record);
    return found;
}

int study_store_keep(cli_study *s, const char *key, const study_record *record)
{
    study_text page;
    if (s->options->output == NULL)
        return CLI_EXIT_SUCCESS;
    if (!study_text_begin(&page))
        return study_report(s, SPH2D_NOMEM, NULL, NULL);
    fputs(key, page.out);
    study_record_write(record, page.out);
    return study_report(s, study_text_write(&page, path_of(s, key), &s->report), NULL, NULL);
}
