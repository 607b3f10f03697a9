/* SPDX-License-Identifier: MIT */
/** @file cloud.c
 *  Interpolation between the particles of a snapshot.
 *
 *  Moving least squares (Lancaster & Salkauskas 1981): of all quadratic functions of the place relative to x the value is
 *  that of the one with the least sum of w_j (f_j - f(r_j))^2, w a kernel around x. With the vector p(r) of the six
 *  monomials 1, x, y, x^2, xy, y^2,
 *
 *      f(x) = z . sum w_j p(r_j) f_j,   M z = (1, 0, ...),   M = sum w_j p(r_j) p(r_j)^T
 *
 *  z_0 sum w_j is one for a mean, and large where errors of the particles are amplified: beyond a surface, beside a row of
 *  particles. Where it is too large, linear functions are taken, or else the mean by the weights (Shepard 1968). */
#include "start/cloud.h"

#include <math.h>

#include "base/pi.h"

/* Radius within which particles count, for values and for cover [spacings]. */
static const double VALUE_REACH = 2.5, COVER_REACH = 1.6;
/* Largest z_0 sum w_j of a function that is taken. It is 2 inside the liquid for quadratic ones; for linear ones 5 half a
 * spacing beyond a surface and 9 beyond a corner, and 300 a spacing beside a row that is crooked by a tenth of that. */
static const double MOST_AMPLIFIED = 12;

/** Wendland's C2 kernel, without its factor. */
static double kernel(double q)
{
    double t = fmax(1 - q, 0);
    return t * t * t * t * (1 + 4 * q);
}

/* ---- making ------------------------------------------------------------------------------------------------------ */

/** Adds image (i, j) of all particles, or only counts: those within `reach` of the domain. */
static void add_images(sph2d__cloud *cloud, const sph2d_sim *sim, int i, int j, double reach)
{
    const sph2d_box *d = &sim->world.box;
    const sph2d__period *period = &sim->system.fluid_cells.period;
    for (size_t k = 0; k < cloud->given->count; ++k) {
        const sph2d_cloud_point *s = &cloud->given->items[k];
        sph2d_vec2 p = {sph2d__period_wrap(s->x, period->low_x, period->length_x) + i * period->length_x,
                        sph2d__period_wrap(s->y, period->low_y, period->length_y) + j * period->length_y};
        bool inside =
            p.x > d->min.x - reach && p.x < d->max.x + reach && p.y > d->min.y - reach && p.y < d->max.y + reach;
        if (!inside)
            continue;
        if (cloud->sample) {
            cloud->x[cloud->count] = p.x;
            cloud->y[cloud->count] = p.y;
            cloud->sample[cloud->count] = (uint32_t)k;
        }
        ++cloud->count;
    }
}

static void add_all(sph2d__cloud *cloud, const sph2d_sim *sim, double reach)
{
    const sph2d__period *period = &sim->system.fluid_cells.period;
    int across = period->length_x > 0, along = period->length_y > 0;
    cloud->count = 0;
    for (int j = -along; j <= along; ++j)
        for (int i = -across; i <= across; ++i)
            add_images(cloud, sim, i, j, reach);
}

bool sph2d__cloud_make(sph2d__cloud *cloud, const sph2d_cloud *given, sph2d_sim *sim)
{
    *cloud = (sph2d__cloud){.given = given, .spacing = fmax(given->spacing, sim->world.scene.spacing)};
    double reach = VALUE_REACH * cloud->spacing;
    add_all(cloud, sim, reach);
    if (given->count >= UINT32_MAX || cloud->count >= UINT32_MAX)
        return false;
    size_t size = cloud->size = cloud->count + 1;
    cloud->x = sph2d__alloc(&sim->memory, size, sizeof *cloud->x);
    cloud->y = sph2d__alloc(&sim->memory, size, sizeof *cloud->y);
    cloud->sample = sph2d__alloc(&sim->memory, size, sizeof *cloud->sample);
    bool ok = cloud->x && cloud->y && cloud->sample;
    if (ok)
        add_all(cloud, sim, reach);
    ok = ok && sph2d__near_build(&cloud->near, cloud->x, cloud->y, cloud->count, reach, &sim->memory);
    if (!ok)
        sph2d__cloud_free(cloud, &sim->memory);
    return ok;
}

void sph2d__cloud_free(sph2d__cloud *cloud, sph2d__memory *memory)
{
    void *x = cloud->x, *y = cloud->y, *sample = cloud->sample;
    sph2d__near_free(&cloud->near, memory);
    sph2d__release(memory, &x, cloud->size, sizeof *cloud->x);
    sph2d__release(memory, &y, cloud->size, sizeof *cloud->y);
    sph2d__release(memory, &sample, cloud->size, sizeof *cloud->sample);
    *cloud = (sph2d__cloud){0};
}

/* ---- values ------------------------------------------------------------------------------------------------------ */

/* Monomials up to the second and the first order, and none. */
enum { QUADRATIC = 6, LINEAR = 3, MEAN = 1 };

/** Sums around a place, with r in spacings. */
typedef struct sums {
    const sph2d__cloud *cloud;
    double m[QUADRATIC][QUADRATIC];           /**< M, its lower half */
    double f[SPH2D__CLOUD_VALUES][QUADRATIC]; /**< sum w p f */
} sums;

static void add_to_sums(void *into, uint32_t k, double x, double y)
{
    sums *s = into;
    const sph2d_cloud_point *point = &s->cloud->given->items[s->cloud->sample[k]];
    const double f[SPH2D__CLOUD_VALUES] = {point->vx, point->vy, point->pressure};
    x /= s->cloud->spacing;
    y /= s->cloud->spacing;
    const double w = kernel(hypot(x, y) / VALUE_REACH), p[QUADRATIC] = {1, x, y, x * x, x * y, y * y};
    for (int i = 0; i < QUADRATIC; ++i) {
        for (int j = 0; j <= i; ++j)
            s->m[i][j] += w * p[i] * p[j];
        for (int n = 0; n < SPH2D__CLOUD_VALUES; ++n)
            s->f[n][i] += w * p[i] * f[n];
    }
}

/** Solves M z = (1, 0, ...) for functions of `size` monomials by Cholesky's decomposition. False where M is singular. */
static bool solve(const sums *s, int size, double z[QUADRATIC])
{
    double l[QUADRATIC][QUADRATIC];
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j <= i; ++j) {
            double sum = s->m[i][j];
            for (int k = 0; k < j; ++k)
                sum -= l[i][k] * l[j][k];
            if (i == j && !(sum > 1e-12 * s->m[i][i]))
                return false;
            l[i][j] = i == j ? sqrt(sum) : sum / l[j][j];
        }
        z[i] = i == 0 ? 1 : 0;
        for (int k = 0; k < i; ++k)
            z[i] -= l[i][k] * z[k];
        z[i] /= l[i][i];
    }
    for (int i = size - 1; i >= 0; --i) {
        for (int k = i + 1; k < size; ++k)
            z[i] -= l[k][i] * z[k];
        z[i] /= l[i][i];
    }
    return true;
}

bool sph2d__cloud_values(const sph2d__cloud *cloud, sph2d_vec2 place, double values[SPH2D__CLOUD_VALUES])
{
    static const int sizes[] = {QUADRATIC, LINEAR, MEAN};
    sums s = {.cloud = cloud};
    sph2d__near_each(&cloud->near, place, add_to_sums, &s);
    double z[QUADRATIC] = {0};
    if (!(s.m[0][0] > 0))
        return false;
    int order = 0;
    while (sizes[order] > MEAN && !(solve(&s, sizes[order], z) && z[0] * s.m[0][0] <= MOST_AMPLIFIED))
        ++order;
    if (sizes[order] == MEAN)
        z[0] = 1 / s.m[0][0];
    for (int n = 0; n < SPH2D__CLOUD_VALUES; ++n) {
        values[n] = 0;
        for (int i = 0; i < sizes[order]; ++i)
            values[n] += z[i] * s.f[n][i];
    }
    return true;
}

/* ---- cover ------------------------------------------------------------------------------------------------------- */

/** A sum of kernels, and the nearest particle. */
typedef struct cover {
    double reach, sum;
    double x, y, distance; /**< from the place */
} cover;

static void add_cover(void *into, uint32_t k, double x, double y)
{
    cover *c = into;
    double distance = hypot(x, y);
    (void)k;
    c->sum += kernel(distance / c->reach);
    if (distance < c->distance)
        *c = (cover){c->reach, c->sum, x, y, distance};
}

static cover cover_at(const sph2d__cloud *cloud, sph2d_vec2 place)
{
    cover c = {.reach = COVER_REACH * cloud->spacing, .distance = INFINITY};
    sph2d__near_each(&cloud->near, place, add_cover, &c);
    double width = cloud->given->spacing / c.reach;
    c.sum *= 7 / SPH2D__PI * width * width;
    return c;
}

double sph2d__cloud_cover(const sph2d__cloud *cloud, sph2d_vec2 place)
{
    return cover_at(cloud, place).sum;
}

double sph2d__cloud_cover_of(const sph2d__cloud *cloud, const sph2d_sim *sim, sph2d_vec2 place)
{
    cover c = cover_at(cloud, place);
    bool behind = c.sum > 0 && sph2d__sim_crosses_wall(sim, place, (sph2d_vec2){place.x + c.x, place.y + c.y});
    return behind ? 0 : c.sum;
}
