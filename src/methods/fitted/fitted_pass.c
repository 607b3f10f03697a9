/* SPDX-License-Identifier: MIT */
/** @file fitted_pass.c
 *  The pair loop of method `wcsph` with fitted operators. Compiled once for each instruction set and precision, named
 *  by SPH2D__ISA.
 *
 *  The sums of a fit cost so much more than a distance that candidates are first filtered: a quarter of them, farther
 *  than H from the box around a group, is left out. Normal equations are solved for all particles of a group at once.
 */
#include <math.h>

#include "base/pi.h"
#include "kernels/kernel.h"
#include "methods/common/traverse.h"
#include "methods/fitted/fitted_solve.h"

/* ---- neighbours -------------------------------------------------------------------------------------------------- */

/* Capacity of the list of candidates: more than a group has in liquid at rest. */
enum { LISTED = 128 };

/** Candidates that are not yet summed. */
typedef struct list {
    size_t count;
    uint32_t index[LISTED];
    sph2d__real x[LISTED + 1], y[LISTED + 1]; /**< from the group's first particle, in units of H */
} list;

/** The particles of a group and their bounding box, in the same units. */
typedef struct group_state {
    sph2d__lanes x, y, vx, vy, density;
    double from_x, from_y;                    /**< the first particle [m] */
    sph2d__real low_x, low_y, high_x, high_y; /**< the box */
} group_state;

/** Appends the candidates of the block from j on, in range r, within H of the box. */
SPH2D__INLINE void list_block(list *to, const group_state *own, const sph2d__ranges *ranges, int r, size_t j,
                              const constants *k)
{
    const sph2d__real from_x = (sph2d__real)(ranges->x[r] + own->from_x);
    const sph2d__real from_y = (sph2d__real)(ranges->y[r] + own->from_y);
    sph2d__lanes x = (sph2d__lanes_load(k->liquid->x + j) - from_x) * k->inverse_support;
    sph2d__lanes y = (sph2d__lanes_load(k->liquid->y + j) - from_y) * k->inverse_support;
    sph2d__lanes dx = sph2d__above_zero(sph2d__lanes_max(own->low_x - x, x - own->high_x));
    sph2d__lanes dy = sph2d__above_zero(sph2d__lanes_max(own->low_y - y, y - own->high_y));
    unsigned near = sph2d__lanes_which(dx * dx + dy * dy, 1);
    size_t left = ranges->end[r] - j;
    if (left < SPH2D__LANES)
        near &= (1u << left) - 1;
    sph2d__lanes_pack_index(to->index + to->count, (uint32_t)j, near);
    sph2d__lanes_pack(to->x + to->count, x, near);
    sph2d__lanes_pack(to->y + to->count, y, near);
    to->count += (size_t)__builtin_popcount(near);
}

/** Adds the listed candidates to the sums: those of the fields in one loop, all others in a second, since together they
 *  need more registers than there are. The next candidate's square root overlaps the sums, which saves 8 % of the time.
 */
static void sum_listed(fit_sums *to, list *from, const group_state *own, const constants *k)
{
    const sph2d__store *f = k->liquid;
    sph2d__lanes kept[LISTED];
    fit_sums sums = *to;
    from->x[from->count] = from->y[from->count] = 0;
    offset next = offset_to(from->x[0] - own->x, from->y[0] - own->y);
    for (size_t n = 0; n < from->count; ++n) {
        const size_t j = from->index[n];
        const offset at = next;
        sph2d__lanes w = at.t * at.t * at.t;
        next = offset_to(from->x[n + 1] - own->x, from->y[n + 1] - own->y);
        kept[n] = at.t;
        add_field(&sums, 0, &at, w, f->vx[j] - own->vx);
        add_field(&sums, 1, &at, w, f->vy[j] - own->vy);
        add_field(&sums, 2, &at, w, f->density[j] - own->density);
    }
    for (size_t n = 0; n < from->count; ++n)
        add_moments(&sums, from->x[n] - own->x, from->y[n] - own->y, kept[n], k);
    *to = sums;
    from->count = 0;
}

/** Sets the sums of a group over the liquid. */
static void sum_liquid(const sph2d__system *s, const sph2d__group *g, const constants *k, fit_sums *to)
{
    const sph2d__store *f = &s->fluid;
    const size_t i = g->first;
    const double x0 = f->x[i], y0 = f->y[i];
    const sph2d__real unit = k->inverse_support;
    const group_state own = {.x = sph2d__group_lanes(f->x + i, -x0) * unit,
                             .y = sph2d__group_lanes(f->y + i, -y0) * unit,
                             .vx = sph2d__lanes_load(k->liquid->vx + i),
                             .vy = sph2d__lanes_load(k->liquid->vy + i),
                             .density = sph2d__lanes_load(k->liquid->density + i),
                             .from_x = x0,
                             .from_y = y0,
                             .low_x = (sph2d__real)(g->low_x - x0) * unit,
                             .low_y = (sph2d__real)(g->low_y - y0) * unit,
                             .high_x = (sph2d__real)(g->high_x - x0) * unit,
                             .high_y = (sph2d__real)(g->high_y - y0) * unit};
    sph2d__ranges ranges;
    list found;
    found.count = 0;
    for (int n = 0; n < SUMS; ++n)
        to->of[n] = (sph2d__lanes){0};
    sph2d__patch_ranges(&s->fluid_cells, &g->patch, &ranges);
    for (int r = 0; r < ranges.count; ++r)
        for (size_t j = ranges.begin[r]; j < ranges.end[r]; j += SPH2D__LANES) {
            list_block(&found, &own, &ranges, r, j, k);
            if (found.count > LISTED - SPH2D__LANES)
                sum_listed(to, &found, &own, k);
        }
    sum_listed(to, &found, &own, k);
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/** Adds the walls near particle i: all layers to its concentration gradient, the surface to its velocity sums. */
static void add_walls(const sph2d__system *s, const sph2d__cursor *cursor, size_t i, const constants *k, fit_sums *sums,
                      fit_sums *velocity_sums, sph2d__lanes matrix[MATRIX], int lane)
{
    const sph2d__store *w = &s->walls, *f = &s->fluid;
    SPH2D__FOR_NEIGHBOURS (&cursor->ranges, r, b) {
        double x = w->x[b] - f->x[i] - cursor->ranges.x[r], y = w->y[b] - f->y[i] - cursor->ranges.y[r];
        add_wall(s, i, b, x, y, k, sums, velocity_sums, matrix, lane);
    }
}

/* ---- groups of particles ----------------------------------------------------------------------------------------- */

/** Sets the rates of a group; `walls` is kept from one particle to the next. */
static void rates_of_group(sph2d__system *s, const sph2d__group *g, sph2d__cursor *walls, const constants *k)
{
    const sph2d__store *f = &s->fluid;
    fit_sums sums, velocity_sums;
    sum_liquid(s, g, k, &sums);
    sph2d__lanes matrix[MATRIX];
    fill_matrix(&sums, matrix);
    bool walled = false;
    for (int lane = 0; lane < g->count && s->walls_press; ++lane) {
        size_t i = g->first + (size_t)lane;
        if (!sph2d__cursor_move(walls, &s->wall_cells, f->x[i], f->y[i]))
            continue;
        if (!walled)
            velocity_sums = sums;
        walled = true;
        add_walls(s, walls, i, k, &sums, &velocity_sums, matrix, lane);
    }
    fit fits;
    if (walled) {
        solve(&sums, g->count, matrix, 2, 3, &fits);
        fill_matrix(&velocity_sums, matrix);
        solve(&velocity_sums, g->count, matrix, 0, 2, &fits);
    } else {
        solve(&sums, g->count, matrix, 0, 3, &fits);
    }
    finish(s, g, &sums, &fits, k);
}

static void rates(sph2d__system *s, size_t first, size_t last)
{
    double ratio = s->support / s->spacing;
    const double value = sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, 1 / ratio);
    const constants k = {.liquid = &s->fluid,
                         .inverse_support = (sph2d__real)(1 / s->support),
                         .value_scale = (sph2d__real)(pow(0.2, 0.25) / value),
                         .grad_c_scale = 140 / (SPH2D__PI * ratio * ratio),
                         .viscosity = s->viscosity / s->rest_density};
    const sph2d__grouping by = sph2d__grouping_of(&s->fluid, &s->fluid_cells, NULL);
    sph2d__cursor walls = SPH2D__CURSOR_START;
    SPH2D__FOR_GROUPS (&by, g, first, last) {
        sph2d__group_box(&s->fluid, &g);
        rates_of_group(s, &g, &walls, &k);
    }
}

const sph2d__fitted_passes SPH2D__OF_ISA(sph2d__fitted_passes) = {rates};
