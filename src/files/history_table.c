/* SPDX-License-Identifier: MIT */
/** @file history_table.c
 *  What an opening prescribes over time: a table of one number, or of velocities over time and place. */
#include <stddef.h>
#include <stdlib.h>

#include "files/table_kind.h"

enum { TIME, VELOCITY, FLOW_RATE, PRESSURE, LEVEL, X, Y, COLUMNS };

/* ---- velocity over place ----------------------------------------------------------------------------------------- */

/** Compares rows, which lie in the order of the file. */
static int by_time_and_place(const void *a, const void *b)
{
    const sph2d_path_point *p = *(const sph2d_path_point *const *)a, *q = *(const sph2d_path_point *const *)b;
    if (p->t != q->t)
        return p->t < q->t ? -1 : 1;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    return (p > q) - (p < q);
}

/** Checks that sorted rows have each place once, and the same places at each time; `rows` are those of the file. */
static sph2d_status check_places(const sph2d__table_input *in, const sph2d_path_point *rows,
                                 const sph2d_path_point *const *sorted, size_t count)
{
    size_t places = 1;
    while (places < count && sorted[places]->t == sorted[0]->t)
        ++places;
    for (size_t k = 1; k < count; ++k) {
        const sph2d_path_point *p = sorted[k], *before = sorted[k - 1];
        const size_t row = (size_t)(p - rows);
        bool here = p->x == sorted[k % places]->x && (p->t > before->t) == (k % places == 0);
        if (p->t == before->t && p->x == before->x)
            return sph2d__table_fault(in, row, "the place %g is given twice at t = %g", p->x, p->t);
        if (!here || (k + 1 == count && count % places != 0))
            return sph2d__table_fault(in, row, "the places at t = %g are not those at t = %g", p->t, sorted[0]->t);
    }
    return SPH2D_OK;
}

/** Takes rows of places in any order; without times all are of one. */
static sph2d_status take_profile(const sph2d__table_input *in, size_t along, sph2d_path *profile)
{
    const sph2d__row_form form = {.width = 3, .columns = {TIME, along, VELOCITY}};
    sph2d_path rows;
    sph2d_status status = sph2d__table_rows(in, &form, &rows);
    if (status != SPH2D_OK)
        return status;
    const sph2d_path_point **sorted = sph2d__pool_alloc(in->pool, rows.count, sizeof *sorted);
    sph2d_path_point *points = sph2d__pool_alloc(in->pool, rows.count, sizeof *points);
    if (!sorted || !points)
        return SPH2D_NOMEM;
    for (size_t row = 0; row < rows.count; ++row)
        sorted[row] = &rows.items[row];
    qsort(sorted, rows.count, sizeof *sorted, by_time_and_place);
    for (size_t k = 0; k < rows.count; ++k)
        points[k] = *sorted[k];
    *profile = (sph2d_path){points, rows.count};
    return check_places(in, rows.items, sorted, rows.count);
}

/* ---- any --------------------------------------------------------------------------------------------------------- */

static sph2d_status take_history(const sph2d__table_input *in, void *owner)
{
    sph2d_opening *opening = owner;
    bool vertical = opening->side == SPH2D_SIDE_NAME_LEFT || opening->side == SPH2D_SIDE_NAME_RIGHT;
    size_t given = 0, value = VELOCITY, along = vertical ? Y : X;
    for (size_t column = VELOCITY; column <= LEVEL; ++column)
        if (sph2d_table_has(in->table, column)) {
            value = column;
            ++given;
        }
    if (given != 1)
        return sph2d__table_fault(in, 0,
                                  "an opening needs just one of the columns velocity, flow_rate, pressure, level");
    if (value == VELOCITY && sph2d_table_has(in->table, along))
        return take_profile(in, along, &opening->history.profile);
    if (!sph2d_table_has(in->table, TIME))
        return sph2d__table_fault(in, 0, "there is no column 't', nor '%s' with a velocity over places",
                                  in->kind->columns[along].name);
    const sph2d__row_form form = {.width = 2, .columns = {TIME, value}, .refuse = sph2d__table_refuse_time};
    return sph2d__table_rows(in, &form, (char *)owner + in->kind->lists[value - VELOCITY].at);
}

#define SLOT(list) #list, offsetof(sph2d_opening, history.list)

const sph2d__table_kind sph2d__history_table = {
    .key = "file",
    .file = offsetof(sph2d_opening, history.file),
    .columns =
        {
            [TIME] = {"t", "s", true},
            [VELOCITY] = {"velocity", "m/s", true},
            [FLOW_RATE] = {"flow_rate", "m^2/s", true},
            [PRESSURE] = {"pressure", "Pa", true},
            [LEVEL] = {"level", "m", true},
            [X] = {"x", "m", true},
            [Y] = {"y", "m", true},
        },
    .column_count = COLUMNS,
    /* in the order of the columns */
    .lists = {{SLOT(velocity), 2}, {SLOT(flow_rate), 2}, {SLOT(pressure), 2}, {SLOT(level), 2}, {SLOT(profile), 3}},
    .take = take_history,
};
