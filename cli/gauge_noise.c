/* SPDX-License-Identifier: MIT */
/** @file gauge_noise.c
 *  How noisy the series of a pressure gauge is. The running mean is centred, so that it follows what changes steadily;
 *  it is over a quarter of the part that is judged, and differences from it count where all of that is inside. */
#include "gauge_noise.h"

#include <math.h>
#include <string.h>

enum { MIN_SAMPLES = 16, PARTS = 4 };

/* The first row of the last quarter of the time. */
static size_t begin_of_end(const sph2d_table *table, size_t rows)
{
    const double first = sph2d_table_value(table, 0, 0), last = sph2d_table_value(table, rows - 1, 0);
    size_t row = rows - 1;
    while (row > 0 && sph2d_table_value(table, row - 1, 0) >= last - (last - first) / PARTS)
        --row;
    return row;
}

static double mean_of(const sph2d_table *table, size_t from, size_t to)
{
    double sum = 0;
    for (size_t row = from; row < to; ++row)
        sum += sph2d_table_value(table, row, 1);
    return sum / (double)(to - from);
}

static bool judge(const sph2d_table *table, gauge_noise *out)
{
    const size_t rows = sph2d_table_rows(table), begin = rows > 0 ? begin_of_end(table, rows) : 0;
    const size_t count = rows - begin, half = count / PARTS / 2;
    if (count < MIN_SAMPLES)
        return false;
    double squares = 0, running = mean_of(table, begin, begin + 2 * half + 1);
    for (size_t row = begin + half; row < rows - half; ++row) {
        const double apart = sph2d_table_value(table, row, 1) - running;
        squares += apart * apart;
        if (row + half + 1 < rows)
            running += (sph2d_table_value(table, row + half + 1, 1) - sph2d_table_value(table, row - half, 1)) /
                       (double)(2 * half + 1);
    }
    *out = (gauge_noise){mean_of(table, begin, rows), sqrt(squares / (double)(count - 2 * half))};
    return isfinite(out->mean) && isfinite(out->deviation);
}

bool gauge_noise_read(const char *path, gauge_noise *out)
{
    const sph2d_table_column columns[] = {{"time", NULL, false}, {"pressure", NULL, false}};
    sph2d_table *table = NULL;
    sph2d_report report = {0};
    const bool ok = sph2d_table_read(path, columns, 2, &table, &report) == SPH2D_OK && judge(table, out);
    sph2d_table_destroy(table);
    sph2d_report_clear(&report);
    return ok;
}
