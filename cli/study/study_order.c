/* SPDX-License-Identifier: MIT */
/** @file study_order.c
 *  Orders of convergence, between two rows and of all that belong together. */
#include "study_order.h"

#include <math.h>
#include <string.h>

#include "../parse.h"
#include "study_front.h"
#include "study_reduce.h"
#include "study_settings.h"

/* ---- between two rows -------------------------------------------------------------------------------------------- */

/* Whether two rows set the same keys, to whatever values. */
static bool same_keys(const sph2d_study_run *a, const sph2d_study_run *b)
{
    bool same = true;
    for (size_t i = 0; i < a->override_count; ++i)
        same = same && study_setting(b, a->overrides[i].path) != NULL;
    for (size_t i = 0; i < b->override_count; ++i)
        same = same && study_setting(a, b->overrides[i].path) != NULL;
    return same;
}

/* The row that the order of `fine` is reported from: the nearest before it that is coarser and has the same settings;
 * among rows that are written one by one, else the nearest that is coarser and sets the same keys. */
static const study_row *coarser(const cli_study *s, const study_row *fine)
{
    const study_row *found = NULL;
    for (const study_row *row = s->rows; row < fine; ++row) {
        if (!study_row_counts(row) || !(row->record.spacing > fine->record.spacing))
            continue;
        bool same = study_same_but("spacing", &row->run, &fine->run);
        bool better = found != NULL && study_same_but("spacing", &found->run, &fine->run);
        if (same || (s->study->vary_count == 0 && !better && same_keys(&row->run, &fine->run)))
            found = row;
    }
    return found;
}

static void tell_orders(cli_study *s, study_row *fine)
{
    const study_row *coarse = coarser(s, fine);
    for (size_t i = 0; i < s->study->measure_count && coarse != NULL; ++i)
        if (s->study->measures[i].order)
            fine->values[i].order = study_order(coarse->values[i].error, fine->values[i].error, coarse->record.spacing,
                                                fine->record.spacing);
}

void study_order_all(cli_study *s)
{
    for (size_t r = 0; r < s->row_count; ++r)
        if (study_row_counts(&s->rows[r]))
            tell_orders(s, &s->rows[r]);
}

/* ---- of rows that belong together -------------------------------------------------------------------------------- */

double study_order_along(const cli_study *s, const study_row *row)
{
    if (strcmp(s->study->along, "spacing") == 0)
        return row->record.spacing;
    const char *value = study_setting(&row->run, s->study->along);
    double number;
    return value != NULL && parse_number(value, &number) ? number : NAN;
}

bool study_order_belong(const cli_study *s, const study_row *a, const study_row *b)
{
    return study_same_but(s->study->along, &a->run, &b->run);
}

double study_order_fit(const cli_study *s, const study_row *row, size_t *count)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    *count = 0;
    for (size_t r = 0; r < s->row_count; ++r) {
        double error = study_front_error(s, &s->rows[r]);
        double along = study_order_along(s, &s->rows[r]);
        if (!(error > 0) || !(along > 0) || !study_order_belong(s, &s->rows[r], row))
            continue;
        double a = log(along), b = log(error);
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
        ++*count;
    }
    double n = (double)*count, spread = n * xx - x * x;
    return *count > 1 && spread > 1e-12 * n * xx ? (n * xy - x * y) / spread : NAN;
}
