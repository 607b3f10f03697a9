/* SPDX-License-Identifier: MIT */
/** @file study.c
 *  `sph2d study STUDY`: runs a scene several times, compares what comes out with what is expected, prints one table. */
#include <stdlib.h>
#include <string.h>

#include "../command.h"
#include "../exit.h"
#include "../input.h"
#include "../message.h"
#include "parts.h"

/* ---- before anything runs ---------------------------------------------------------------------------------------- */

/* A key that rows vary cannot have one value in all of them. */
static int refuse_varied(const cli_study *s)
{
    for (size_t i = 0; !s->made && i < s->options->override_count; ++i) {
        for (size_t k = 0; k < s->study->vary_count; ++k) {
            if (strcmp(s->options->overrides[i].path, s->study->vary[k].path) != 0)
                continue;
            message_usage("study", "--set %s: the study varies that key", s->study->vary[k].path);
            return CLI_EXIT_USAGE;
        }
    }
    return CLI_EXIT_SUCCESS;
}

/* A relative error is a fraction, so that 5 would be 500 %: hardly what is meant. */
static int refuse_target(const cli_study *s, bool relative)
{
    const double target = s->options->target;
    if (!relative || s->options->percent || target < 1)
        return CLI_EXIT_SUCCESS;
    message_usage("study", "--target: %g of a relative error is %g %%: write %g%% or %g", target, 100 * target, target,
                  target / 100);
    return CLI_EXIT_USAGE;
}

/* Everything that may be refused comes before the first run and before the folder is touched. */
static int prepare(cli_study *s)
{
    const cli_options *options = s->options;
    int code = study_open(s);
    if (code == CLI_EXIT_SUCCESS)
        code = refuse_varied(s);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    /* What the command line changes is a part already of a study that was made. */
    sph2d_status status = sph2d_study_results_create(s->file, options->overrides, s->made ? 0 : options->override_count,
                                                     options->all, &s->results, &s->report);
    code = study_report(s, status);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    size_t judge = s->results->judge;
    bool relative = judge < s->study->measure_count && s->study->measures[judge].relative;
    s->target = options->target > 0 ? options->target : s->study->target;
    s->percent = (options->target > 0 ? options->percent : s->study->percent) || relative;
    s->repeat = options->repeat > 0 ? (uint64_t)options->repeat : s->study->repeat;
    code = refuse_target(s, relative);
    return code == CLI_EXIT_SUCCESS ? study_open_folder(s) : code;
}

/* ---- the rows ---------------------------------------------------------------------------------------------------- */

/* The steps that build on the front of what is there, up to the first that is to be left out. A shard goes on while it
 * has the rows of all. */
static int refine(cli_study *s)
{
    int code = CLI_EXIT_SUCCESS;
    for (size_t step = 0; step < s->study->refinement_count && !s->stopped && s->missing == 0; ++step) {
        if (s->study->refinements[step].skip && !s->options->all) {
            message_note("the study stops before '%s'; --all goes on", s->study->refinements[step].name);
            break;
        }
        size_t first = s->results->row_count;
        sph2d_status status = sph2d_study_results_measure(s->results);
        if (status == SPH2D_OK)
            status = sph2d_study_results_refine(s->results, step);
        if (status != SPH2D_OK)
            return study_report(s, status);
        code = study_first(code, study_pool_run(s, first));
        code = study_first(code, study_gather(s, first));
    }
    return code;
}

static void tell_left_out(const cli_study *s)
{
    size_t skipped = 0, missing = 0, own = 0;
    bool kept = s->options->output;
    for (size_t r = 0; r < s->results->row_count; ++r) {
        const sph2d_study_row *row = &s->results->rows[r];
        skipped += !row->wanted;
        missing += row->wanted && !row->there && study_owns(s, row);
        own += study_owns(s, row);
    }
    if (own == 0)
        message_note("shard %d of %d has no row of %zu", s->options->shard, s->options->shards, s->results->row_count);
    if (s->kept > 0)
        message_note("%zu row%s there already, unchanged, and not run again; --force runs all anew", s->kept,
                     s->kept == 1 ? " was" : "s were");
    if (s->stopped)
        message_note("%zu row%s missing%s%s", missing, missing == 1 ? " is" : "s are",
                     kept ? "; the same command goes on" : "", kept && s->options->force ? " without --force" : "");
    else if (skipped > 0)
        message_note("%zu row%s left out; --all runs %s too", skipped, skipped == 1 ? "" : "s",
                     skipped == 1 ? "it" : "them");
    if (s->missing > 0 && !s->stopped && !s->options->json)
        study_missing_tell(s);
}

/* Runs row after row; one that fails does not keep the others from running. Returns the first exit code that is none of
 * success. */
static int run_rows(cli_study *s)
{
    int code = study_pool_run(s, 0);
    code = study_first(code, study_gather(s, 0));
    code = study_first(code, refine(s));
    tell_left_out(s);
    code = study_first(code, study_report(s, sph2d_study_results_measure(s->results)));
    bool whole = s->options->output && s->missing == 0;
    return study_first(code, whole ? study_outputs_write(s) : CLI_EXIT_SUCCESS);
}

/* What is wrong with the numbers, and whether an error is above its bound. A shard answers for its own rows. */
static int judge(cli_study *s)
{
    bool missed = false;
    STUDY_FOR_ROWS (s, row) {
        if (!study_owns(s, row))
            continue;
        sph2d_study_row_judge(s->results, row, &s->report);
        missed = missed || s->report.errors > 0;
        study_report(s, SPH2D_OK);
    }
    return missed ? CLI_EXIT_GUARD : CLI_EXIT_SUCCESS;
}

static int finish(cli_study *s, int code)
{
    int signal = s->stopped ? signals_caught() : 0;
    const char *end = signal != 0 ? signals_name(signal) : "finished";
    if (!s->options->quiet && !s->options->json && s->missing == 0)
        study_table_print(s);
    code = study_first(code, judge(s));
    if (s->options->json)
        (s->missing == 0 ? study_json_print : study_missing_json)(s, end, code == CLI_EXIT_SUCCESS);
    return signal != 0 ? 128 + signal : code;
}

int command_study(const cli_options *options)
{
    if (options->operand_count != 1) {
        message_usage("study", options->operand_count == 0 ? "a study file must be given" : "one study at a time");
        return CLI_EXIT_USAGE;
    }
    if (scene_input_is_stream(options->operands[0])) {
        message_usage("study", "the standard input cannot be a study: each row reads the scene again, beside the file");
        return CLI_EXIT_USAGE;
    }
    if (options->shards > 0 && !options->output) {
        message_usage("study", "--shard needs -o DIR, the folder that all shards share");
        return CLI_EXIT_USAGE;
    }
    cli_study s = {.options = options, .path = options->operands[0], .folder = FOLDER_CLOSED};
    s.threads = threads_choose(options);
    s.jobs = options->jobs > 0 ? (size_t)options->jobs : 1;
    if ((options->jobs > 1 || options->shards > 0) && options->threads == 0) /* rows beside each other have one each */
        s.threads = (thread_choice){1, 1, options->jobs > 1 ? "one a row, with --jobs" : "one a row, with --shard"};
    signals_install();
    int code = device_choose_apart(&s.device, options);
    if (code == CLI_EXIT_SUCCESS)
        code = prepare(&s);
    signals_note();
    if (code == CLI_EXIT_SUCCESS)
        code = finish(&s, run_rows(&s));
    sph2d_study_results_destroy(s.results);
    sph2d_study_file_destroy(s.file);
    free(s.made);
    if (code == CLI_EXIT_SUCCESS)
        folder_close(&s.folder);
    else
        folder_abandon(&s.folder);
    return code;
}
