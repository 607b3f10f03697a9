/* SPDX-License-Identifier: MIT */
/** @file outputs.c
 *  All files of a study beside its rows. */
#include "parts.h"

#include <stdlib.h>
#include <string.h>

#include "../exit.h"

/* "series_ROW_PROBE.csv" of a row that has this probe. */
static bool is_series(const cli_study *s, const char *name)
{
    char *end;
    const char prefix[] = "series_", suffix[] = ".csv";
    if (strncmp(name, prefix, strlen(prefix)) != 0)
        return false;
    unsigned long long number = strtoull(name + strlen(prefix), &end, 10);
    if (number < 1 || number > s->results->row_count || *end != '_' || !s->results->rows[number - 1].there)
        return false;
    const sph2d_study_record *record = &s->results->rows[number - 1].record;
    for (size_t i = 0; i < record->series_count; ++i) {
        size_t length = strlen(record->series[i].probe);
        if (length > 0 && strncmp(end + 1, record->series[i].probe, length) == 0 &&
            strcmp(end + 1 + length, suffix) == 0)
            return true;
    }
    return false;
}

/* Whether a file is one of these results. What is, stays until its new text replaces it: another process may have
 * written it just now, and may be reading it. */
static bool is_current(void *study, const char *name)
{
    const cli_study *s = study;
    if (strncmp(name, "plots.", 6) == 0)
        return s->plotted;
    if (strncmp(name, "error_time.", 11) == 0)
        return s->pictures > 0;
    if (strncmp(name, "error_along.", 12) == 0)
        return s->pictures > 1;
    if (strcmp(name, "cheapest.yaml") == 0)
        return sph2d_study_cheapest(s->results, s->target);
    return strcmp(name, "study.csv") == 0 || strcmp(name, "study.html") == 0 || is_series(s, name);
}

int study_outputs_write(cli_study *s)
{
    static int (*const parts[])(cli_study *) = {study_csv_write, study_open_write, study_plot};
    int code = CLI_EXIT_SUCCESS;
    for (size_t i = 0; i < sizeof parts / sizeof *parts && code == CLI_EXIT_SUCCESS; ++i)
        code = parts[i](s);
    if (code == CLI_EXIT_SUCCESS) /* before the page, which shows the pictures that are there */
        code = folder_clear_study(&s->folder, is_current, s);
    return code == CLI_EXIT_SUCCESS ? study_page_write(s) : code;
}
