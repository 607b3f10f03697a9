/* SPDX-License-Identifier: MIT */
/** @file order.c
 *  Orders of convergence, between two rows and of all rows on a line. */
#include "study/parts.h"

#include <math.h>

#include "study/curve.h"

/** The row from which the order of `fine` is computed: the nearest before it that is coarser and has the same settings;
 *  among individually listed rows otherwise the nearest that is coarser and sets the same keys. */
static const sph2d_study_row *coarser(const sph2d_study_results *results, const sph2d_study_row *fine)
{
    const sph2d_study_row *same = NULL, *alike = NULL;
    for (const sph2d_study_row *row = results->rows; row < fine; ++row) {
        if (!sph2d__row_counts(row) || !(row->record.spacing > fine->record.spacing))
            continue;
        if (sph2d__same_settings(&row->run, &fine->run, "spacing", false))
            same = row;
        if (results->study->vary_count == 0 && sph2d__same_settings(&row->run, &fine->run, "", true))
            alike = row;
    }
    return same ? same : alike;
}

void sph2d__order_all(sph2d_study_results *results)
{
    const sph2d_study *study = results->study;
    for (size_t r = 0; r < results->row_count; ++r) {
        sph2d_study_row *fine = &results->rows[r];
        const sph2d_study_row *coarse = sph2d__row_counts(fine) ? coarser(results, fine) : NULL;
        for (size_t i = 0; i < study->measure_count && coarse; ++i)
            if (study->measures[i].order)
                fine->values[i].order = sph2d__order(coarse->values[i].error, fine->values[i].error,
                                                     coarse->record.spacing, fine->record.spacing);
    }
}

double sph2d_study_row_order(const sph2d_study_results *results, const sph2d_study_row *row)
{
    if (!results || !row)
        return NAN;
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (size_t r = 0; r < results->row_count; ++r) {
        double error = sph2d_study_row_error(results, &results->rows[r]);
        double along = sph2d_study_row_along(results, &results->rows[r]);
        if (!(error > 0) || !(along > 0) || !sph2d_study_rows_belong(results, &results->rows[r], row))
            continue;
        double a = log(along), b = log(error);
        n += 1;
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
    }
    double spread = n * xx - x * x;
    return n > 1 && spread > 1e-12 * n * xx ? (n * xy - x * y) / spread : NAN;
}
