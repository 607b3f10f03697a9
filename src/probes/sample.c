/* SPDX-License-Identifier: MIT */
/** @file sample.c
 *  Interpolation of the liquid's fields at a point.
 *
 *  A polynomial c . p with p = (1, xi, eta, xi^2, xi eta, eta^2), (xi, eta) = (x_j - x)/H, is fitted to the particles
 *  within the support radius: sum_j w_j (c . p_j - f_j)^2 is least, w Wendland's C2 (moving least squares, Lancaster &
 *  Salkauskas 1981). Its value at the point is
 *
 *      c_0 = sum_j w_j (lambda . p_j) f_j,   M lambda = (1, 0, ...),   M = sum_j w_j p_j p_j^T
 *
 *  whose factors depend on positions alone and serve all fields. The first three terms give the linear fit, the first
 *  alone the Shepard average. */
#include <math.h>

#include "kernels/kernel.h"
#include "methods/common/on_device.h"
#include "probes/probes.h"

/* Terms of the quadratic, linear and constant polynomial; velocity, pressure and density. */
enum { QUADRATIC = 6, LINEAR = 3, CONSTANT = 1, TERMS = QUADRATIC, FIELDS = 4 };

/* A term is not determined by the neighbours if its pivot is below this fraction of its diagonal element. Inside liquid
 * it is at least a tenth; from a hundredth on, noise is amplified tenfold at most. */
static const double MIN_PIVOT = 0.01;

/** The particles around a point. */
typedef struct surroundings {
    const sph2d__store *fluid;
    const double *fields[FIELDS];
    sph2d_vec2 at;
    double support;
    sph2d__ranges ranges;
    double neighbours;                /**< within the support */
    size_t nearest;                   /**< the nearest of them */
    double low[FIELDS], high[FIELDS]; /**< smallest and largest of their values */
    double matrix[TERMS][TERMS];      /**< M; factored, L below the diagonal and D on it */
} surroundings;

sph2d_vec2 sph2d__probe_place(const sph2d_sim *sim, const sph2d_probe *probe, sph2d_vec2 *along)
{
    const sph2d_path *path = &probe->path;
    sph2d_vec2 at = probe->at;
    *along = probe->along;
    if (path->count > 0) {
        const double first = path->items[0].t, last = path->items[path->count - 1].t;
        sph2d__path_at(path, fmin(fmax(sim->record.time, first), last), &at);
    } else if (probe->on) {
        const sph2d__wall *wall = &sim->world.walls[sph2d__wall_named(&sim->world, probe->on)];
        const sph2d__pose pose = sph2d__sim_pose_of(sim, wall);
        at = sph2d__pose_apply(&pose, at);
        *along = sph2d__pose_turn(&pose, *along);
    }
    return at;
}

bool sph2d__sim_around(const sph2d_sim *sim, sph2d_vec2 *at, sph2d__ranges *ranges)
{
    const sph2d__cells *cells = &sim->system.fluid_cells;
    const sph2d__period *period = &cells->period;
    if (sim->system.fluid.count == 0 || sph2d__sim_is_broken(sim))
        return false;
    at->x = sph2d__period_wrap(at->x, period->low_x, period->length_x);
    at->y = sph2d__period_wrap(at->y, period->low_y, period->length_y);
    uint32_t cell = sph2d__cells_find(cells, at->x, at->y);
    if (cell == UINT32_MAX)
        return false;
    sph2d__cells_ranges(cells, cell, ranges);
    return true;
}

/** Weight of particle j in range r, 0 beyond the support, and its terms. */
static double weigh(const surroundings *s, int r, size_t j, double terms[TERMS])
{
    double xi = (s->fluid->x[j] - s->at.x - s->ranges.x[r]) / s->support;
    double eta = (s->fluid->y[j] - s->at.y - s->ranges.y[r]) / s->support;
    double q2 = xi * xi + eta * eta;
    terms[0] = 1;
    terms[1] = xi;
    terms[2] = eta;
    terms[3] = xi * xi;
    terms[4] = xi * eta;
    terms[5] = eta * eta;
    return q2 < 1 ? sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, sqrt(q2)) : 0;
}

/** Sums the matrix, and finds the nearest neighbour and the range of each field. */
static void sum_matrix(surroundings *s)
{
    double terms[TERMS], largest = 0;
    SPH2D__FOR_NEIGHBOURS (&s->ranges, r, j) {
        double w = weigh(s, r, j, terms);
        if (!(w > 0))
            continue;
        for (int a = 0; a < TERMS; ++a)
            for (int b = 0; b <= a; ++b)
                s->matrix[a][b] += w * terms[a] * terms[b];
        for (int k = 0; k < FIELDS; ++k) {
            double value = s->fields[k][j];
            s->low[k] = s->neighbours > 0 ? fmin(s->low[k], value) : value;
            s->high[k] = s->neighbours > 0 ? fmax(s->high[k], value) : value;
        }
        if (w > largest) {
            largest = w;
            s->nearest = j;
        }
        ++s->neighbours;
    }
}

/** Factors M = L D L^T in at. Returns the number of leading terms that the neighbours determine. */
static int factor(double m[TERMS][TERMS])
{
    for (int k = 0; k < TERMS; ++k) {
        double diagonal = m[k][k];
        for (int a = 0; a < k; ++a) {
            for (int b = 0; b < a; ++b)
                m[k][a] -= m[k][b] * m[b][b] * m[a][b];
            m[k][a] /= m[a][a];
            m[k][k] -= m[k][a] * m[k][a] * m[a][a];
        }
        if (!(m[k][k] > MIN_PIVOT * diagonal))
            return k;
    }
    return TERMS;
}

/** Solves M lambda = (1, 0, ...) with the leading `count` terms. */
static void solve(double m[TERMS][TERMS], int count, double lambda[TERMS])
{
    for (int k = 0; k < count; ++k) {
        lambda[k] = k == 0;
        for (int a = 0; a < k; ++a)
            lambda[k] -= m[k][a] * lambda[a];
    }
    for (int k = count - 1; k >= 0; --k) {
        lambda[k] /= m[k][k];
        for (int a = k + 1; a < count; ++a)
            lambda[k] -= m[a][k] * lambda[a];
    }
}

/** Values of the fit with `count` terms. Differences from the nearest neighbour are fitted, so that a uniform field is
 *  reproduced to the last bit. */
static void evaluate(surroundings *s, int count, double values[FIELDS])
{
    double lambda[TERMS], terms[TERMS];
    solve(s->matrix, count, lambda);
    for (int k = 0; k < FIELDS; ++k)
        values[k] = s->fields[k][s->nearest];
    SPH2D__FOR_NEIGHBOURS (&s->ranges, r, j) {
        double w = weigh(s, r, j, terms), share = 0;
        if (!(w > 0))
            continue;
        for (int a = 0; a < count; ++a)
            share += lambda[a] * terms[a];
        for (int k = 0; k < FIELDS; ++k)
            values[k] += w * share * (s->fields[k][j] - s->fields[k][s->nearest]);
    }
}

/** Fits each field by the polynomial of highest degree that the neighbours determine and whose value is within their
 *  range, widened by its own width on either side. */
static void fit(surroundings *s, double values[FIELDS])
{
    static const int counts[] = {QUADRATIC, LINEAR, CONSTANT};
    int determined = factor(s->matrix);
    bool done[FIELDS] = {false};
    for (int n = 0; n < 3; ++n) {
        double fitted[FIELDS];
        if (counts[n] > determined)
            continue;
        evaluate(s, counts[n], fitted);
        for (int k = 0; k < FIELDS; ++k) {
            double spread = s->high[k] - s->low[k];
            bool in_range = fitted[k] >= s->low[k] - spread && fitted[k] <= s->high[k] + spread;
            if (!done[k] && (in_range || counts[n] == CONSTANT)) {
                values[k] = fitted[k];
                done[k] = true;
            }
        }
        if (done[0] && done[1] && done[2] && done[3])
            return;
    }
}

static bool sample(const sph2d_sim *sim, sph2d_vec2 at, sph2d_sample *out)
{
    const sph2d__store *f = &sim->system.fluid;
    surroundings s = {.fluid = f, .fields = {f->vx, f->vy, f->pressure, f->density}, .support = sim->system.support};
    double values[FIELDS] = {NAN, NAN, NAN, NAN};
    s.at = at;
    if (sph2d__sim_around(sim, &s.at, &s.ranges))
        sum_matrix(&s);
    if (s.neighbours > 0)
        fit(&s, values);
    *out = (sph2d_sample){{values[0], values[1]}, values[2], values[3], s.neighbours};
    return s.neighbours > 0;
}

bool sph2d_sim_sample(const sph2d_sim *sim, sph2d_vec2 at, sph2d_sample *out)
{
    if (sim && out) {
        sph2d__host_reads(&sim->system, SPH2D__EVERYTHING);
        return sample(sim, at, out);
    }
    if (out)
        *out = (sph2d_sample){{NAN, NAN}, NAN, NAN, 0};
    return false;
}
