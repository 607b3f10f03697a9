/* SPDX-License-Identifier: MIT */
/** @file linked_rows.c
 *  One pair at a time, as textbooks have it. */
#include <math.h>
#include <string.h>

#include "pair.h"

/** The particle for which sums are made. */
typedef struct single {
    double x, y, vx, vy, density, own, damping, flux, sum_x, sum_y;
} single;

static inline single single_at(const sph2d__store *s, const terms *n, size_t i)
{
    double volume = s->volume[i];
    return (single){.x = s->x[i],
                    .y = s->y[i],
                    .vx = s->vx[i],
                    .vy = s->vy[i],
                    .density = s->density[i],
                    .own = s->pressure[i] * volume * volume,
                    .damping = n->damping * volume};
}

/** Adds particle j, if it is near; particle j is given its share, too, where `both`. */
SPH2D__INLINE void meet(field *f, const terms *n, single *me, size_t i, size_t j, double support2, bool both)
{
    sph2d__store *s = &f->store;
    double dx = me->x - s->x[j], dy = me->y - s->y[j], r2 = dx * dx + dy * dy;
    if (r2 >= support2 || i == j)
        return;
    double t = 1 - sqrt(r2) * n->inverse_support, g = -20 * t * t * t, volume = s->volume[j];
    double approach = (me->vx - s->vx[j]) * dx + (me->vy - s->vy[j]) * dy;
    double spread = (me->density - s->density[j]) * n->diffusion;
    double press = g * (me->own + s->pressure[j] * volume * volume + approach / r2 * me->damping * volume);
    me->flux += g * (approach + spread * volume);
    me->sum_x += press * dx;
    me->sum_y += press * dy;
    if (both) {
        s->density_rate[j] += g * (approach - spread * s->volume[i]);
        s->ax[j] -= press * dx;
        s->ay[j] -= press * dy;
    }
}

/** Linked lists, particles unsorted. */
static void pass_linked(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    const uint32_t *head = f->head.at, *next = f->next.at, nx = f->grid.nx;
    const double support2 = f->scene.support * f->scene.support;
    for (size_t i = 0; i < s->count; ++i) {
        single me = single_at(s, &n, i);
        uint32_t middle = grid_row(&f->grid, me.y) * nx + grid_column(&f->grid, me.x);
        for (uint32_t row = middle - nx; row <= middle + nx; row += nx)
            for (uint32_t cell = row - 1; cell <= row + 1; ++cell)
                for (uint32_t j = head[cell]; j != UINT32_MAX; j = next[j])
                    meet(f, &n, &me, i, j, support2, false);
        write_sums(f, i, me.flux, me.sum_x, me.sum_y);
    }
}

/** Each pair once, by Newton's third law, particles sorted: those behind a particle in its own row of cells, and those
 *  in the row above. */
static void pass_half(field *f, const variant *v)
{
    (void)v;
    sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    const sph2d__cells *c = &f->cells;
    const double support2 = f->scene.support * f->scene.support;
    memset(s->density_rate, 0, s->count * sizeof(double));
    memset(s->ax, 0, s->count * sizeof(double));
    memset(s->ay, 0, s->count * sizeof(double));
    for (size_t i = 0; i < s->count; ++i) {
        single me = single_at(s, &n, i);
        const uint32_t *own = c->start + c->cell[c->order[i]], *above = own + c->nx;
        for (size_t j = i + 1; j < own[c->columns + 1]; ++j)
            meet(f, &n, &me, i, j, support2, true);
        for (size_t j = *(above - c->columns); j < above[c->columns + 1]; ++j)
            meet(f, &n, &me, i, j, support2, true);
        write_sums(f, i, s->density_rate[i] + me.flux, s->ax[i] + me.sum_x, s->ay[i] + me.sum_y);
    }
}

/** Every pair twice, particles sorted: what sorting alone gives. */
static void pass_single(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    const double support2 = f->scene.support * f->scene.support;
    for (size_t i = 0; i < s->count; ++i) {
        single me = single_at(s, &n, i);
        sph2d__ranges near;
        sph2d__cells_ranges(&f->cells, f->cells.cell[f->cells.order[i]], &near);
        SPH2D__FOR_NEIGHBOURS (&near, r, j)
            meet(f, &n, &me, i, j, support2, false);
        write_sums(f, i, me.flux, me.sum_x, me.sum_y);
    }
}

const variant VARIANTS_OF(linked)[] = {
    {"scalar, linked lists, particles in no order", prepare_linked, pass_linked, .mixed = true},
    {"scalar, linked lists, particles as first placed", prepare_linked, pass_linked, .mixed = false},
    {"scalar, sorted", prepare_cells, pass_single, .columns = 4},
    {"scalar, sorted, each pair once", prepare_cells, pass_half, .columns = 4},
    {0}};
