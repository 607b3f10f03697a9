/* SPDX-License-Identifier: MIT */
/** @file study.c
 *  `sph2d study STUDY`: runs a scene several times, compares what comes out with what is expected, prints one table. */
#include "study.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../command.h"
#include "../exit.h"
#include "../message.h"
#include "../signals.h"
#include "study_csv.h"
#include "study_front.h"
#include "study_measure.h"
#include "study_open.h"
#include "study_page.h"
#include "study_plot.h"
#include "study_pool.h"
#include "study_refine.h"
#include "study_scene.h"
#include "study_table.h"

/* ---- before anything runs ---------------------------------------------------------------------------------------- */

static int read_references(cli_study *s)
{
    s->references = calloc(s->study->measure_count + 1, sizeof *s->references);
    if (s->references == NULL)
        return study_report(s, SPH2D_NOMEM, NULL, NULL);
    int code = CLI_EXIT_SUCCESS;
    for (size_t i = 0; i < s->study->measure_count; ++i) {
        const sph2d_study_measure *m = &s->study->measures[i];
        if (m->expectation != SPH2D_EXPECT_REFERENCE)
            continue;
        bool along = m->source == SPH2D_MEASURE_PROFILE;
        int reported =
            study_report(s, study_points_read(&s->references[i], &m->reference, along, &s->report), NULL, NULL);
        code = code == CLI_EXIT_SUCCESS ? reported : code;
    }
    return code;
}

static bool is_wanted(const cli_study *s, const sph2d_study_run *run)
{
    return !run->skip || s->options->all;
}

/* A row for each run, with room for its values, so that a long study does not fail for it in the end. */
static int make_rows(cli_study *s)
{
    s->rows = calloc(s->study->run_count, sizeof *s->rows);
    if (s->rows == NULL)
        return study_report(s, SPH2D_NOMEM, NULL, NULL);
    for (; s->row_count < s->study->run_count; ++s->row_count) {
        study_row *row = &s->rows[s->row_count];
        *row = (study_row){.number = s->row_count + 1, .run = s->study->runs[s->row_count]};
        row->wanted = is_wanted(s, &row->run);
        row->values = malloc((s->study->measure_count + 1) * sizeof *row->values);
        if (row->values == NULL)
            return study_report(s, SPH2D_NOMEM, NULL, NULL);
    }
    return CLI_EXIT_SUCCESS;
}

/* What a refinement's row points at is its own. */
static void free_row(study_row *row)
{
    if (row->owned) {
        free((void *)(uintptr_t)row->run.name);
        free((void *)(uintptr_t)row->run.overrides);
        free((void *)(uintptr_t)row->run.places);
    }
    study_record_free(&row->record);
    free(row->values);
}

/* What a refinement makes of the first run. */
static int check_refinement(cli_study *s, const sph2d_study_run *step)
{
    study_row row;
    int code = study_refine_row(&row, &s->study->runs[0], step, 0) ? study_scene_check(s, &row.run, false)
                                                                   : study_report(s, SPH2D_NOMEM, NULL, NULL);
    free_row(&row);
    return code;
}

/* The scene of each row. */
static int check_scenes(cli_study *s)
{
    int code = CLI_EXIT_SUCCESS;
    for (size_t i = 0; i < s->study->run_count && code == CLI_EXIT_SUCCESS; ++i)
        code = study_scene_check(s, &s->study->runs[i], is_wanted(s, &s->study->runs[i]));
    for (size_t i = 0; i < s->study->refinement_count && code == CLI_EXIT_SUCCESS; ++i)
        code = check_refinement(s, &s->study->refinements[i]);
    return code;
}

/* A key that rows vary cannot have one value in all of them. */
static int refuse_varied(const cli_study *s)
{
    for (size_t i = 0; s->made == NULL && i < s->options->override_count; ++i) {
        for (size_t k = 0; k < s->study->vary_count; ++k) {
            if (strcmp(s->options->overrides[i].path, s->study->vary[k].path) != 0)
                continue;
            message_usage("study", "--set %s: the study varies that key", s->study->vary[k].path);
            return CLI_EXIT_USAGE;
        }
    }
    return CLI_EXIT_SUCCESS;
}

/* Takes the folder: a new one, or one that an earlier session of the study left. */
static int open_folder(cli_study *s)
{
    static const char mark[] =
        "Rows that sph2d study has run. Without this file it takes the folder for somebody else's.\n";
    const char *path = s->options->output;
    int code = folder_refuse(path, s->options->force || folder_holds(path, "rows/README"));
    if (code == CLI_EXIT_SUCCESS)
        code = folder_open_new(&s->folder, path, FOLDER_CLEAR_STUDY);
    if (code == CLI_EXIT_SUCCESS)
        code = folder_make_inside(&s->folder, "rows");
    const char *name = code == CLI_EXIT_SUCCESS ? folder_file(&s->folder, "rows/README") : NULL;
    if (name != NULL) /* and whether rows can be kept is known before any runs */
        code = study_report(s, sph2d_text_write(name, mark, strlen(mark), &s->report), NULL, NULL);
    return code;
}

/* Everything that may be refused comes before the first run and before the folder is touched. */
static int prepare(cli_study *s)
{
    int code = study_open(s);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    s->judge = study_front_judge(s->study);
    bool relative = s->judge < s->study->measure_count && s->study->measures[s->judge].relative;
    s->target = s->options->target > 0 ? s->options->target : s->study->target;
    s->percent = s->options->target > 0 ? s->options->percent || relative : s->study->percent || relative;
    s->repeat = s->options->repeat > 0 ? (uint64_t)s->options->repeat : s->study->repeat;
    code = refuse_varied(s);
    if (code == CLI_EXIT_SUCCESS)
        code = read_references(s);
    if (code == CLI_EXIT_SUCCESS)
        code = check_scenes(s);
    if (code == CLI_EXIT_SUCCESS && s->options->output != NULL)
        code = open_folder(s);
    return code == CLI_EXIT_SUCCESS ? make_rows(s) : code;
}

/* ---- the rows ---------------------------------------------------------------------------------------------------- */

/* The steps that build on the front of what is there, up to the first that is to be left out. */
static int refine(cli_study *s)
{
    int code = CLI_EXIT_SUCCESS;
    for (size_t step = 0; step < s->study->refinement_count && !s->stopped; ++step) {
        if (!is_wanted(s, &s->study->refinements[step])) {
            message_note("the study stops before '%s'; --all goes on", s->study->refinements[step].name);
            break;
        }
        size_t first = s->row_count;
        int reported = study_report(s, study_measure_all(s, false), NULL, NULL);
        if (reported == CLI_EXIT_SUCCESS)
            reported = study_report(s, study_refine(s, step), NULL, NULL);
        if (reported != CLI_EXIT_SUCCESS)
            return reported;
        reported = study_pool_run(s, first);
        code = code == CLI_EXIT_SUCCESS ? reported : code;
    }
    return code;
}

static void tell_left_out(const cli_study *s)
{
    size_t skipped = 0, missing = 0;
    for (size_t r = 0; r < s->row_count; ++r) {
        skipped += !s->rows[r].wanted;
        missing += s->rows[r].wanted && !s->rows[r].there;
    }
    if (s->kept > 0)
        message_note("%zu row%s there already, unchanged, and not run again; --force runs all anew", s->kept,
                     s->kept == 1 ? " was" : "s were");
    if (s->stopped)
        message_note("%zu row%s missing%s%s", missing, missing == 1 ? " is" : "s are",
                     s->options->output != NULL ? "; the same command goes on" : "",
                     s->options->output != NULL && s->options->force ? " without --force" : "");
    else if (skipped > 0)
        message_note("%zu row%s left out; --all runs %s too", skipped, skipped == 1 ? "" : "s",
                     skipped == 1 ? "it" : "them");
}

/* Runs row after row; one that fails does not keep the others from running. Returns the first exit code that is none of
 * success. */
static int run_rows(cli_study *s)
{
    int code = study_pool_run(s, 0);
    int refined = refine(s);
    tell_left_out(s);
    int reported = study_report(s, study_measure_all(s, true), NULL, NULL);
    study_front_mark(s);
    code = code != CLI_EXIT_SUCCESS ? code : refined != CLI_EXIT_SUCCESS ? refined : reported;
    int written = s->options->output != NULL ? folder_clear_study(&s->folder) : CLI_EXIT_SUCCESS;
    if (written == CLI_EXIT_SUCCESS)
        written = study_csv_write(s);
    if (written == CLI_EXIT_SUCCESS)
        written = study_open_write(s);
    if (written == CLI_EXIT_SUCCESS)
        written = study_plot(s);
    if (written == CLI_EXIT_SUCCESS)
        written = study_page_write(s);
    return code != CLI_EXIT_SUCCESS ? code : written;
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
    for (size_t i = 0; i < s->row_count; ++i)
        free_row(&s->rows[i]);
    free(s->rows);
    for (size_t i = 0; s->references != NULL && i < s->study->measure_count; ++i)
        study_points_free(&s->references[i]);
    free(s->references);
    free(s->made);
    sph2d_study_file_destroy(s->file);
    folder_close(&s->folder);
}

/* Rows that run beside each other have one thread each, unless -j says otherwise. */
static thread_choice choose_threads(const cli_options *options)
{
    thread_choice choice = threads_choose(options);
    if (options->jobs > 1 && options->threads == 0)
        choice = (thread_choice){1, "one a row, with --jobs"};
    return choice;
}

int command_study(const cli_options *options)
{
    if (options->operand_count != 1) {
        message_usage("study", options->operand_count == 0 ? "a study file must be given" : "one study at a time");
        return CLI_EXIT_USAGE;
    }
    cli_study s = {.options = options, .path = options->operands[0], .folder = FOLDER_CLOSED, .process = getpid()};
    s.threads = choose_threads(options);
    s.jobs = options->jobs > 0 ? (size_t)options->jobs : 1;
    signals_install();
    int code = prepare(&s);
    if (code == CLI_EXIT_SUCCESS)
        code = finish(&s, run_rows(&s));
    end(&s);
    return code;
}
