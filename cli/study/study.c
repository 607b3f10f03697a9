/* SPDX-License-Identifier: MIT */
/** @file study.c
 *  `sph2d study STUDY`: runs a scene several times, compares what comes out with what is expected, prints one table. */
#include "study.h"

#include <signal.h>
#include <stdlib.h>

#include "../command.h"
#include "../exit.h"
#include "../message.h"
#include "../signals.h"
#include "study_csv.h"
#include "study_measure.h"
#include "study_scene.h"
#include "study_table.h"

/* ---- before anything runs ---------------------------------------------------------------------------------------- */

static int read_references(cli_study *s)
{
    s->references = calloc(s->study->measure_count + 1, sizeof *s->references);
    if (s->references == NULL)
        return study_told(s, SPH2D_NOMEM, NULL, NULL);
    int code = CLI_EXIT_SUCCESS;
    for (size_t i = 0; i < s->study->measure_count; ++i) {
        const sph2d_study_measure *m = &s->study->measures[i];
        if (m->expectation != SPH2D_EXPECT_REFERENCE)
            continue;
        bool along = m->source == SPH2D_MEASURE_PROFILE;
        int told = study_told(s, study_points_read(&s->references[i], &m->reference, along, &s->report), NULL, NULL);
        code = code == CLI_EXIT_SUCCESS ? told : code;
    }
    return code;
}

static bool is_wanted(const cli_study *s, const sph2d_study_run *run)
{
    return !run->skip || s->options->all;
}

/* Everything that may be refused comes before the first run and before the folder is touched. */
static int prepare(cli_study *s)
{
    int code = study_told(s, sph2d_study_file_read(s->path, &s->file, &s->report), NULL, NULL);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    s->study = sph2d_study_file_study(s->file);
    code = read_references(s);
    for (size_t i = 0; i < s->study->run_count && code == CLI_EXIT_SUCCESS; ++i)
        code = study_scene_check(s, &s->study->runs[i], is_wanted(s, &s->study->runs[i]));
    if (code == CLI_EXIT_SUCCESS && s->options->output != NULL)
        code = folder_refuse(s->options->output, s->options->force);
    if (code == CLI_EXIT_SUCCESS && s->options->output != NULL)
        code = folder_open_new(&s->folder, s->options->output, FOLDER_KEEP);
    return code;
}

/* Room for all rows, so that a long study does not fail for it in the end. */
static int make_rows(cli_study *s)
{
    s->rows = calloc(s->study->run_count, sizeof *s->rows);
    if (s->rows == NULL)
        return study_told(s, SPH2D_NOMEM, NULL, NULL);
    for (size_t i = 0; i < s->study->run_count; ++i) {
        s->rows[i].values = malloc((s->study->measure_count + 1) * sizeof *s->rows[i].values);
        if (s->rows[i].values == NULL)
            return study_told(s, SPH2D_NOMEM, NULL, NULL);
    }
    return CLI_EXIT_SUCCESS;
}

/* ---- the rows ---------------------------------------------------------------------------------------------------- */

/* Runs row after row; one that fails does not keep the others from running. Returns the first exit code that is none of
 * success. */
static int run_rows(cli_study *s)
{
    int code = CLI_EXIT_SUCCESS;
    size_t skipped = 0;
    for (size_t i = 0; i < s->study->run_count; ++i) {
        const sph2d_study_run *run = &s->study->runs[i];
        if (!is_wanted(s, run)) {
            ++skipped;
            continue;
        }
        study_row *row = &s->rows[s->row_count];
        row->run = run;
        row->number = i + 1;
        message_note("row %zu of %zu: %s", i + 1, s->study->run_count, run->name);
        study_run(s, row);
        if (row->end == STUDY_STOPPED) {
            s->stopped = true;
            message_note("stopped in row '%s' at t = %g s; the table has the rows before it", run->name, row->time);
            return code;
        }
        ++s->row_count;
        study_measure_orders(s);
        int written = study_csv_write_rows(s);
        code = code != CLI_EXIT_SUCCESS ? code : row->code != CLI_EXIT_SUCCESS ? row->code : written;
    }
    if (skipped > 0)
        message_note("%zu row%s left out; --all runs %s too", skipped, skipped == 1 ? "" : "s",
                     skipped == 1 ? "it" : "them");
    return code;
}

static int finish(const cli_study *s, int code)
{
    int signal = s->stopped ? signals_caught() : 0;
    const char *end = signal == SIGINT ? "SIGINT" : signal != 0 ? "SIGTERM" : "finished";
    if (!s->options->quiet && !s->options->json)
        study_table_print(s);
    if (study_measure_misses(s) > 0 && code == CLI_EXIT_SUCCESS)
        code = CLI_EXIT_GUARD;
    if (s->options->json)
        study_json_print(s, end, code == CLI_EXIT_SUCCESS);
    return signal != 0 ? 128 + signal : code;
}

static void end(cli_study *s)
{
    for (size_t i = 0; s->rows != NULL && i < s->study->run_count; ++i)
        free(s->rows[i].values);
    free(s->rows);
    for (size_t i = 0; s->references != NULL && i < s->study->measure_count; ++i)
        study_points_free(&s->references[i]);
    free(s->references);
    sph2d_study_file_destroy(s->file);
    folder_close(&s->folder);
}

int command_study(const cli_options *options)
{
    if (options->operand_count != 1) {
        message_usage("study", options->operand_count == 0 ? "a study file must be given" : "one study at a time");
        return CLI_EXIT_USAGE;
    }
    cli_study s = {.options = options, .path = options->operands[0], .folder = FOLDER_CLOSED};
    s.threads = threads_choose(options);
    signals_install();
    int code = prepare(&s);
    if (code == CLI_EXIT_SUCCESS)
        code = make_rows(&s);
    if (code == CLI_EXIT_SUCCESS)
        code = finish(&s, run_rows(&s));
    end(&s);
    return code;
}
