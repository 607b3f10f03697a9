/* SPDX-License-Identifier: MIT */
/** @file table_kind.c
 *  Lists from the rows of tables. */
#include "files/table_kind.h"

#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define IS_LIST(type)                                                                                                  \
    _Static_assert(offsetof(type, count) - offsetof(type, items) == offsetof(sph2d__list, count), #type)
IS_LIST(sph2d_path);
IS_LIST(sph2d_pose_path);
IS_LIST(sph2d_history);
IS_LIST(sph2d_particles);
IS_LIST(sph2d_points);

sph2d_status sph2d__table_fault(const sph2d__table_input *in, size_t row, const char *format, ...)
{
    char message[sizeof((sph2d_diagnostic *)0)->message];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    sph2d_table_locate(in->table, row,
                       sph2d_report_add(in->report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL, "%s", message));
    return SPH2D_FORMAT;
}

sph2d_status sph2d__table_lacks(const sph2d__table_input *in, size_t row, size_t column)
{
    return sph2d__table_fault(in, row, "this row lacks a number: its column '%s' is empty or nan",
                              in->kind->columns[column].name);
}

const char *sph2d__table_refuse_time(const sph2d_table *table, size_t row)
{
    bool increases = row == 0 || sph2d_table_value(table, row, 0) > sph2d_table_value(table, row - 1, 0);
    return increases ? NULL : "times must increase from row to row";
}

sph2d_status sph2d__table_rows(const sph2d__table_input *in, const sph2d__row_form *form, void *list)
{
    size_t count = sph2d_table_rows(in->table);
    if (count == 0)
        return sph2d__table_fault(in, 0, "this file has no rows");
    double *items = sph2d__pool_alloc(in->pool, count, form->width * sizeof *items);
    if (!items)
        return SPH2D_NOMEM;
    for (size_t row = 0; row < count; ++row) {
        for (size_t k = 0; k < form->width; ++k) {
            size_t column = form->columns[k];
            bool here = sph2d_table_has(in->table, column);
            double value = here ? sph2d_table_value(in->table, row, column) : form->otherwise[k];
            if (!isfinite(value))
                return sph2d__table_lacks(in, row, column);
            items[row * form->width + k] = value;
        }
        const char *why = form->refuse ? form->refuse(in->table, row) : NULL;
        if (why)
            return sph2d__table_fault(in, row, "%s", why);
    }
    memcpy(list, &(sph2d__list){items, count}, sizeof(sph2d__list));
    return SPH2D_OK;
}

sph2d_status sph2d__table_take(const sph2d__table_input *in, void *owner)
{
    const sph2d__table_kind *kind = in->kind;
    sph2d__row_form form = {.width = kind->column_count, .columns = {0, 1, 2, 3, 4, 5, 6}, .refuse = kind->refuse};
    if (kind->otherwise)
        memcpy(&form.otherwise[1], (char *)owner + kind->otherwise, (form.width - 1) * sizeof(double));
    return sph2d__table_rows(in, &form, (char *)owner + kind->lists[0].at);
}
