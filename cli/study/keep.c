/* SPDX-License-Identifier: MIT */
/** @file keep.c
 *  The folder of a study, and the rows in it. */
#include "parts.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "../build.h"
#include "../exit.h"

static void put_mark(const void *what, FILE *out)
{
    (void)what;
    fputs("Rows that sph2d study has run. Without this file it takes the folder for somebody else's.\n", out);
}

int study_open_folder(cli_study *s)
{
    if (!s->options->output)
        return CLI_EXIT_SUCCESS;
    int (*take)(cli_folder *, const char *, bool, const char *) = s->options->shards > 0 ? folder_share : folder_claim;
    int code = take(&s->folder, s->options->output, s->options->force, "rows/README");
    if (code == CLI_EXIT_SUCCESS)
        code = folder_clear(&s->folder, FOLDER_CLEAR_STUDY);
    if (code == CLI_EXIT_SUCCESS)
        code = folder_make_inside(&s->folder, "rows");
    if (code == CLI_EXIT_SUCCESS) /* and whether rows can be kept is known before any runs */
        code = study_write(s, "rows/README", put_mark, NULL);
    return code;
}

/* ---- what a row depends on --------------------------------------------------------------------------------------- */

/* Long enough for all that a row depends on but its scene. */
enum { PROGRAM_SIZE = 8192 };

/* All that a row depends on but its scene. For shards that is nothing that depends on where one runs, so that all find
 * the rows of all: the number of threads and the processor change the times of a row alone. */
static void write_program(const cli_study *s, bool anywhere, char out[PROGRAM_SIZE])
{
    char processor[256], threads[32];
    sph2d_isa isa = s->options->isa;
    for (int i = SPH2D_ISA_BASELINE; s->options->isa == SPH2D_ISA_AUTO && i <= SPH2D_ISA_AVX512; ++i)
        if (sph2d_isa_available((sph2d_isa)i))
            isa = (sph2d_isa)i;
    snprintf(threads, sizeof threads, "%d", s->threads.count);
    if (s->device.number > 0)
        isa = SPH2D_ISA_BASELINE;
    snprintf(out, PROGRAM_SIZE, "sph2d %s, source %s, %s, %s\nthreads %s, isa %s, repeat %" PRIu64 ", %s",
             sph2d_version(), build_source, build_compiler, build_flags, anywhere ? "any" : threads,
             sph2d_isa_name(isa), s->repeat, anywhere ? "of a shard" : build_processor(processor, sizeof processor));
    if (s->device.number > 0)
        text_append(out, PROGRAM_SIZE, ", %s, %s %s", s->device.about.name, s->device.about.platform,
                    s->device.about.driver);
}

/* The key of the same row with another program in front. NULL when memory is short. */
static char *key_with(const char *key, const char *program, const char *instead)
{
    const char *scene = key + strlen(program);
    size_t size = strlen(instead) + strlen(scene) + 1;
    char *out = malloc(size);
    if (out)
        snprintf(out, size, "%s%s", instead, scene);
    return out;
}

/* ---- finding and keeping ----------------------------------------------------------------------------------------- */

/* Looks for a row under the key that one of the other kind has: for a shard what a study in one process ran here, else
 * what a shard ran anywhere. The key of the row stays its own. */
static sph2d_status find_of_other_kind(cli_study *s, sph2d_study_row *row, const char *program, const char *rows)
{
    char others[PROGRAM_SIZE];
    write_program(s, s->options->shards == 0, others);
    char *own = row->key;
    row->key = key_with(own, program, others);
    bool memory = row->key;
    bool found = sph2d_study_row_find(s->results, row, rows);
    free(row->key);
    row->key = own;
    s->by_shards += found && s->options->shards == 0;
    if (found && s->options->shards > 0) /* now the other shards find it, too */
        return sph2d_study_row_keep(row, rows, &s->report);
    return memory ? SPH2D_OK : SPH2D_NOMEM;
}

bool study_owns(const cli_study *s, const sph2d_study_row *row)
{
    uint64_t shards = (uint64_t)s->options->shards;
    return shards == 0 || (row->number - 1) % shards + 1 == (uint64_t)s->options->shard;
}

int study_find(cli_study *s, sph2d_study_row *row)
{
    if (!s->options->output)
        return CLI_EXIT_SUCCESS;
    char program[PROGRAM_SIZE];
    write_program(s, s->options->shards > 0, program);
    sph2d_status status = sph2d_study_row_key(s->results, row, program, &s->report);
    const char *rows = folder_file(&s->folder, "rows");
    status = status == SPH2D_OK && !rows ? SPH2D_NOMEM : status;
    /* --force is for what runs here: the rows of other shards are as they are. */
    bool looked_for = !s->options->force || !study_owns(s, row);
    if (status == SPH2D_OK && looked_for && !sph2d_study_row_find(s->results, row, rows))
        status = find_of_other_kind(s, row, program, rows);
    return study_report(s, status);
}

/* Takes what another process has kept for this row while it ran here: both are the same but for their times. */
static bool take_kept(cli_study *s, sph2d_study_row *row, const char *rows)
{
    sph2d_study_row kept = {.key = row->key};
    if (s->options->shards == 0 || s->options->force || !sph2d_study_row_find(s->results, &kept, rows))
        return false;
    sph2d_study_record_free(&row->record);
    row->record = kept.record;
    return true;
}

int study_keep(cli_study *s, sph2d_study_row *row)
{
    if (!s->options->output)
        return CLI_EXIT_SUCCESS;
    const char *rows = folder_file(&s->folder, "rows");
    if (rows && take_kept(s, row, rows))
        return CLI_EXIT_SUCCESS;
    return study_report(s, rows ? sph2d_study_row_keep(row, rows, &s->report) : SPH2D_NOMEM);
}
