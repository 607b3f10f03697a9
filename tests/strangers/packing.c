/* SPDX-License-Identifier: MIT */
/* The density that is there: particles are counted around those that are inside the liquid, whatever the method itself
 * says about its density. */
#include <math.h>
#include <stdlib.h>

#include "judge.h"

static const double pi = 3.14159265358979323846;
enum { SECTORS = 16, LEAST_INSIDE = 20 };

/** Wendland's C2 kernel of support radius 1 in two dimensions [1]. */
static double wendland(double q)
{
    return q < 1 ? 7 / pi * pow(1 - q, 4) * (1 + 4 * q) : 0;
}

/** What counting finds in a filled square lattice, over its density: 1.0051 for a reach of 3 spacings. */
static double lattice_count(double reach)
{
    double sum = 0;
    for (int i = -4; i <= 4; ++i)
        for (int j = -4; j <= 4; ++j)
            sum += wendland(hypot(i, j) / reach);
    return sum / (reach * reach);
}

static double nearest_image(double d, double period)
{
    return period > 0 ? d - period * round(d / period) : d;
}

typedef struct room {
    double reach, period_x, period_y;
    sph2d_view fluid, walls;
    const sph2d_scene *scene;
} room;

static bool near_wall(const room *r, double x, double y)
{
    const sph2d_boundary *side = &r->scene->boundary;
    const sph2d_box *box = &r->scene->domain;
    if ((side->left == SPH2D_SIDE_WALL && x - box->min.x < r->reach) ||
        (side->right == SPH2D_SIDE_WALL && box->max.x - x < r->reach) ||
        (side->bottom == SPH2D_SIDE_WALL && y - box->min.y < r->reach) ||
        (side->top == SPH2D_SIDE_WALL && box->max.y - y < r->reach))
        return true;
    for (size_t i = 0; i < r->walls.count; ++i)
        if (hypot(nearest_image(x - r->walls.x[i], r->period_x), nearest_image(y - r->walls.y[i], r->period_y)) <
            r->reach)
            return true;
    return false;
}

/** Density by counting over rest density around a particle; 0 unless liquid lies all around it, so far and farther. */
static double count_around(const room *r, size_t i)
{
    bool near[SECTORS / 2] = {false}, far[SECTORS] = {false};
    double sum = 0;
    for (size_t j = 0; j < r->fluid.count; ++j) {
        const double dx = nearest_image(r->fluid.x[j] - r->fluid.x[i], r->period_x);
        const double dy = nearest_image(r->fluid.y[j] - r->fluid.y[i], r->period_y);
        const double q = hypot(dx, dy) / r->reach;
        const int sector = (int)((atan2(dy, dx) / (2 * pi) + 0.5) * SECTORS) % SECTORS;
        if (q > 0.5 && q < 1)
            near[sector / 2] = true;
        else if (q >= 1 && q < 1.7)
            far[sector] = true;
        sum += wendland(q);
    }
    for (int k = 0; k < SECTORS; ++k)
        if (!near[k / 2] || !far[k])
            return 0;
    const double reach = r->reach / r->scene->spacing;
    return sum / (reach * reach) / lattice_count(reach);
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void measure_packing(const sph2d_scene *s, const sph2d_sim *sim, library_run *run)
{
    run->packing = run->density = run->p99 = run->highest = NAN;
    for (size_t i = 0; i < s->block_count; ++i)
        if (s->blocks[i].spacing > 0) // compressed at the start, on purpose
            return;
    room r = {.reach = 3 * s->spacing, .fluid = sph2d_sim_fluid(sim), .walls = sph2d_sim_walls(sim), .scene = s};
    r.period_x = s->boundary.left == SPH2D_SIDE_PERIODIC ? s->domain.max.x - s->domain.min.x : 0;
    r.period_y = s->boundary.bottom == SPH2D_SIDE_PERIODIC ? s->domain.max.y - s->domain.min.y : 0;
    double *inside = malloc((r.fluid.count + 1) * sizeof *inside), counted = 0, reported = 0;
    size_t count = 0;
    for (size_t i = 0; inside != NULL && i < r.fluid.count; ++i) {
        const double n = near_wall(&r, r.fluid.x[i], r.fluid.y[i]) ? 0 : count_around(&r, i);
        if (n > 0) {
            inside[count++] = n - 1;
            counted += n;
            reported += r.fluid.density[i] / s->fluid.density;
        }
    }
    if (count >= LEAST_INSIDE) {
        qsort(inside, count, sizeof *inside, ascending);
        run->packing = counted / (double)count;
        run->density = reported / (double)count;
        run->p99 = inside[(count * 99) / 100];
        run->highest = inside[count - 1];
    }
    free(inside);
}
