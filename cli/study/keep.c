/* SPDX-License-Identifier: MIT */
/** @file keep.c
 *  The folder of a study, and the rows in it. */
#include "parts.h"

#include <inttypes.h>

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
    int code = folder_claim(&s->folder, s->options->output, s->options->force, "rows/README");
    if (code == CLI_EXIT_SUCCESS)
        code = folder_clear(&s->folder, FOLDER_CLEAR_STUDY);
    if (code == CLI_EXIT_SUCCESS)
        code = folder_make_inside(&s->folder, "rows");
    if (code == CLI_EXIT_SUCCESS) /* and whether rows can be kept is known before any runs */
        code = study_write(s, "rows/README", put_mark, NULL);
    return code;
}

/* All that a row depends on but its scene. */
static void write_program(const cli_study *s, char *out, size_t size)
{
    char processor[256];
    sph2d_isa isa = s->options->isa;
    for (int i = SPH2D_ISA_BASELINE; s->options->isa == SPH2D_ISA_AUTO && i <= SPH2D_ISA_AVX512; ++i)
        if (sph2d_isa_available((sph2d_isa)i))
            isa = (sph2d_isa)i;
    snprintf(out, size, "sph2d %s, source %s, %s, %s\nthreads %d, isa %s, repeat %" PRIu64 ", %s", sph2d_version(),
             build_source, build_compiler, build_flags, s->threads.count, sph2d_isa_name(isa), s->repeat,
             build_processor(processor, sizeof processor));
}

int study_find(cli_study *s, sph2d_study_row *row)
{
    if (!s->options->output)
        return CLI_EXIT_SUCCESS;
    char program[8192];
    write_program(s, program, sizeof program);
    sph2d_status status = sph2d_study_row_key(s->results, row, program, &s->report);
    const char *rows = folder_file(&s->folder, "rows");
    status = status == SPH2D_OK && !rows ? SPH2D_NOMEM : status;
    if (status == SPH2D_OK && !s->options->force)
        sph2d_study_row_find(s->results, row, rows);
    return study_report(s, status);
}

int study_keep(cli_study *s, const sph2d_study_row *row)
{
    if (!s->options->output)
        return CLI_EXIT_SUCCESS;
    const char *rows = folder_file(&s->folder, "rows");
    return study_report(s, rows ? sph2d_study_row_keep(row, rows, &s->report) : SPH2D_NOMEM);
}
