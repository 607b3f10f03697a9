/* SPDX-License-Identifier: MIT */
/** @file study_verdict.c
 *  The line that a study is run for. */
#include "study_verdict.h"

#include <stdio.h>

#include "../text.h"
#include "study_cells.h"
#include "study_front.h"

/* As people read it: per cent where it is a part of something, else in units of the measure. */
static void write_error(const cli_study *s, char out[TEXT_SIZE], double error)
{
    if (s->percent)
        snprintf(out, TEXT_SIZE, "%.3g %%", 100 * error);
    else
        snprintf(out, TEXT_SIZE, "%.3g", error);
}

char *study_verdict(const cli_study *s, char *out, size_t size)
{
    const study_row *cheapest = study_front_cheapest(s, s->target), *best = study_front_best(s);
    char wanted[TEXT_SIZE], got[TEXT_SIZE], time[STUDY_CELL_SIZE], judged[101], name[201];
    out[0] = '\0';
    if (best == NULL)
        return out;
    const sph2d_study_measure *judge = &s->study->measures[s->judge];
    const char *against = judge->expectation == SPH2D_EXPECT_FINEST ? ", against the finest row" : "";
    const study_row *row = cheapest != NULL ? cheapest : best;
    write_error(s, wanted, s->target);
    write_error(s, got, study_front_error(s, row));
    study_cells_seconds(time, row->record.cpu);
    snprintf(judged, sizeof judged, "%s", judge->name);
    snprintf(name, sizeof name, "%s", row->run.name);
    text_whole(judged);
    text_whole(name);
    if (cheapest != NULL)
        snprintf(out, size, "For an error of %s (%s%s) the cheapest is '%s': %s in %s CPU s.", wanted, judged, against,
                 name, got, time);
    else
        snprintf(out, size, "No row has an error of %s or less (%s%s): the smallest is %s, by '%s' in %s CPU s.",
                 wanted, judged, against, got, name, time);
    return out;
}
