/* SPDX-License-Identifier: MIT */
/** @file study_reduce.c
 *  A series of samples into one number. */
#include "study_reduce.h"

#include <math.h>

/* Steps to each side in which a reference is moved. */
enum { SHIFTS = 100 };

/* The clock of a simulation is a sum of steps: a time that it misses by rounding alone is reached. */
static const double ROUNDING = 1e-12;

static double slack(double x)
{
    return ROUNDING * fabs(x);
}

study_curve study_select(const double *x, const double *y, size_t stride, size_t count, double from, double to,
                         double *x_out, double *y_out)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; ++i) {
        double value = y[i * stride];
        if (x[i] < from - slack(from) || x[i] > to + slack(to) || !isfinite(value) || !isfinite(x[i]))
            continue;
        x_out[kept] = x[i];
        y_out[kept++] = value;
    }
    return (study_curve){x_out, y_out, kept};
}

/* ---- numbers of a curve ------------------------------------------------------------------------------------------ */

static double largest(study_curve c)
{
    double result = c.count > 0 ? c.y[0] : NAN;
    for (size_t i = 1; i < c.count; ++i)
        result = fmax(result, c.y[i]);
    return result;
}

static double smallest(study_curve c)
{
    double result = c.count > 0 ? c.y[0] : NAN;
    for (size_t i = 1; i < c.count; ++i)
        result = fmin(result, c.y[i]);
    return result;
}

static double last(study_curve c)
{
    return c.count > 0 ? c.y[c.count - 1] : NAN;
}

/* The mean of y or of y^2 over x, exact for straight lines; a curve that takes no time is its last sample. */
static double mean(study_curve c, bool squared)
{
    double sum = 0, length = 0;
    for (size_t i = 1; i < c.count; ++i) {
        double a = c.y[i - 1], b = c.y[i], dx = c.x[i] - c.x[i - 1];
        sum += dx * (squared ? (a * a + a * b + b * b) / 3 : (a + b) / 2);
        length += dx;
    }
    if (length > 0)
        return sum / length;
    return squared ? last(c) * last(c) : last(c);
}

/* Where the line from point i - 1 to point i comes to `level`. */
static double meeting(study_curve c, size_t i, double level)
{
    double part = (level - c.y[i - 1]) / (c.y[i] - c.y[i - 1]);
    return c.x[i - 1] + part * (c.x[i] - c.x[i - 1]);
}

static double crossing(study_curve c, double level)
{
    for (size_t i = 1; i < c.count; ++i) {
        bool upwards = c.y[i - 1] < level && c.y[i] >= level;
        bool downwards = c.y[i - 1] > level && c.y[i] <= level;
        if (upwards || downwards)
            return meeting(c, i, level);
    }
    return NAN;
}

static double period(study_curve c, double level)
{
    double first = NAN, newest = NAN;
    size_t crossings = 0;
    for (size_t i = 1; i < c.count; ++i) {
        if (!(c.y[i - 1] < level && c.y[i] >= level))
            continue;
        newest = meeting(c, i, level);
        if (crossings++ == 0)
            first = newest;
    }
    return crossings > 1 ? (newest - first) / (double)(crossings - 1) : NAN;
}

/* Less the slope of the line through the logarithms of the peaks; a swing that is not over does not count. */
static double decay(study_curve c, double level)
{
    double n = 0, st = 0, sl = 0, stt = 0, stl = 0, peak = 0, time = 0, first = NAN;
    bool open = true; /* of the swing under way the beginning is not known */
    for (size_t i = 0; i < c.count; ++i) {
        double y = c.y[i] - level;
        bool crossed = i > 0 && (c.y[i - 1] < level) != (c.y[i] < level);
        if (crossed && !open && peak > 0) {
            double t = time - first, l = log(peak);
            n += 1, st += t, sl += l, stt += t * t, stl += t * l;
        }
        if (crossed) {
            open = false;
            peak = 0;
        }
        if (!open && fabs(y) > peak) {
            peak = fabs(y);
            time = c.x[i];
            first = isnan(first) ? time : first;
        }
    }
    double spread = n * stt - st * st;
    return n > 1 && spread > 0 ? (st * sl - n * stl) / spread : NAN;
}

double study_at(study_curve c, double x)
{
    if (c.count == 0 || !(x >= c.x[0] - slack(x)) || !(x <= c.x[c.count - 1] + slack(x)))
        return NAN;
    size_t low = 0, high = c.count - 1; /* the line that x lies on goes from one to the other in the end */
    while (high > low + 1) {
        size_t middle = low + (high - low) / 2;
        if (c.x[middle] <= x)
            low = middle;
        else
            high = middle;
    }
    double dx = c.x[high] - c.x[low];
    double part = dx > 0 ? fmin(fmax((x - c.x[low]) / dx, 0), 1) : 1;
    return c.y[low] + part * (c.y[high] - c.y[low]);
}

double study_reduce(sph2d_take take, study_curve curve, double level, double at)
{
    switch (take) {
    case SPH2D_TAKE_DEFAULT:
    case SPH2D_TAKE_LAST:
        return last(curve);
    case SPH2D_TAKE_MAX:
        return largest(curve);
    case SPH2D_TAKE_MIN:
        return smallest(curve);
    case SPH2D_TAKE_MEAN:
        return mean(curve, false);
    case SPH2D_TAKE_RMS:
        return sqrt(mean(curve, true));
    case SPH2D_TAKE_SPREAD:
        return largest(curve) - smallest(curve);
    case SPH2D_TAKE_PERIOD:
        return period(curve, isnan(level) ? mean(curve, false) : level);
    case SPH2D_TAKE_CROSSING:
        return crossing(curve, level);
    case SPH2D_TAKE_DECAY:
        return decay(curve, isnan(level) ? mean(curve, false) : level);
    case SPH2D_TAKE_VALUE:
        return study_at(curve, at);
    }
    return NAN;
}

/* ---- errors ------------------------------------------------------------------------------------------------------ */

/* Sums of differences, so that no list of them is needed. */
typedef struct differences {
    double largest, squares, sum;
    size_t count;
} differences;

static void add(differences *d, double difference)
{
    double size = fabs(difference);
    d->largest = fmax(d->largest, size);
    d->squares += size * size;
    d->sum += size;
    ++d->count;
}

static double norm_of(const differences *d, sph2d_norm norm)
{
    if (d->count == 0 || isnan(d->sum))
        return NAN;
    switch (norm) {
    case SPH2D_NORM_MAX:
        return d->largest;
    case SPH2D_NORM_RMS:
        return sqrt(d->squares / (double)d->count);
    case SPH2D_NORM_MEAN:
        return d->sum / (double)d->count;
    }
    return NAN;
}

double study_norm(sph2d_norm norm, const double *values, size_t count)
{
    differences d = {0, 0, 0, 0};
    for (size_t i = 0; i < count; ++i)
        add(&d, values[i]);
    return norm_of(&d, norm);
}

static double compare_moved(study_curve curve, double scale, study_curve reference, sph2d_norm norm, double by)
{
    differences d = {0, 0, 0, 0};
    for (size_t i = 0; i < reference.count; ++i) {
        double value = study_at(curve, reference.x[i] + by);
        if (!isnan(value))
            add(&d, value / scale - reference.y[i]);
    }
    return norm_of(&d, norm);
}

double study_compare(study_curve curve, double scale, study_curve reference, sph2d_norm norm, double shift)
{
    double least = compare_moved(curve, scale, reference, norm, 0);
    for (int k = -SHIFTS; k <= SHIFTS && shift > 0; ++k)
        least = fmin(least, compare_moved(curve, scale, reference, norm, shift * k / SHIFTS));
    return least;
}

double study_error(double value, double expect, bool relative)
{
    return relative ? fabs(value / expect - 1) : fabs(value - expect);
}

double study_order(double error_coarse, double error_fine, double spacing_coarse, double spacing_fine)
{
    bool positive = error_coarse > 0 && error_fine > 0 && spacing_coarse > 0 && spacing_fine > 0;
    if (!positive || spacing_coarse == spacing_fine)
        return NAN;
    return log(error_coarse / error_fine) / log(spacing_coarse / spacing_fine);
}
