/* SPDX-License-Identifier: MIT */
/** @file sort.c
 *  Orders of the particles: the library's, and those that it has not. Compiled once, as the library's sorting is. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "variants.h"

enum { RIM = 2 };

void grid_lay(field *f, double width, double height)
{
    const sph2d__store *s = &f->store;
    double low_x = s->x[0], low_y = s->y[0], high_x = low_x, high_y = low_y;
    for (size_t i = 1; i < s->count; ++i) {
        low_x = s->x[i] < low_x ? s->x[i] : low_x;
        low_y = s->y[i] < low_y ? s->y[i] : low_y;
        high_x = s->x[i] > high_x ? s->x[i] : high_x;
        high_y = s->y[i] > high_y ? s->y[i] : high_y;
    }
    f->grid = (grid){low_x - RIM * width, low_y - RIM * height, 1 / width, 1 / height, 0, 0};
    f->grid.nx = grid_column(&f->grid, high_x) + RIM + 1;
    f->grid.ny = grid_row(&f->grid, high_y) + RIM + 1;
}

/** A little more than a support radius, so that rounding of a cell's number does not matter. */
static double safe(double support)
{
    return support * (1 + 1e-6);
}

void sort_by_key(field *f, size_t keys)
{
    size_t count = f->store.count;
    uint32_t *start = numbers_reserve(&f->start, keys + 1), *order = numbers_reserve(&f->order, count);
    const uint32_t *key = f->key.at;
    memset(start, 0, (keys + 1) * sizeof *start);
    for (size_t i = 0; i < count; ++i)
        ++start[key[i]];
    uint32_t sum = 0;
    for (size_t k = 0; k <= keys; ++k) {
        sum += start[k];
        start[k] = sum;
    }
    for (size_t i = count; i-- > 0;) /* from behind: those of one key keep their order */
        order[--start[key[i]]] = (uint32_t)i;
}

void sort_in_cells(field *f, double support, uint32_t columns)
{
    f->cells.columns = columns > 0 ? columns : 1;
    if (sph2d__cells_build(&f->cells, &f->store, support, &f->memory))
        return;
    fputs("variants: out of memory\n", stderr);
    exit(1);
}

void prepare_cells(field *f, const variant *v)
{
    double support = f->scene.support + skin_of(f, v);
    sort_in_cells(f, v->cell > 0 ? v->cell * support : support, v->columns);
}

/** Linked lists of the particles in cells of a support radius, in the order of memory as it is: Hockney & Eastwood
 *  1981, and most introductions to SPH. */
void prepare_linked(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    grid_lay(f, safe(f->scene.support), safe(f->scene.support));
    size_t cells = (size_t)f->grid.nx * f->grid.ny;
    uint32_t *head = numbers_reserve(&f->head, cells), *next = numbers_reserve(&f->next, s->count);
    memset(head, 0xff, cells * sizeof *head);
    for (size_t i = 0; i < s->count; ++i) {
        uint32_t cell = grid_row(&f->grid, s->y[i]) * f->grid.nx + grid_column(&f->grid, s->x[i]);
        next[i] = head[cell];
        head[cell] = (uint32_t)i;
    }
}

/** Gives each particle the number of its rectangle as key. */
static void key_by_rectangle(field *f)
{
    const sph2d__store *s = &f->store;
    uint32_t *key = numbers_reserve(&f->key, s->count);
    for (size_t i = 0; i < s->count; ++i)
        key[i] = grid_row(&f->grid, s->y[i]) * f->grid.nx + grid_column(&f->grid, s->x[i]);
}

/** Sorts the particles of a row by x, by insertion: by narrow columns they are sorted already. */
static void sort_row(uint32_t *order, double *x, size_t first, size_t last)
{
    for (size_t k = first + 1; k < last; ++k) {
        double place = x[k];
        uint32_t particle = order[k];
        size_t to = k;
        for (; to > first && x[to - 1] > place; --to) {
            x[to] = x[to - 1];
            order[to] = order[to - 1];
        }
        x[to] = place;
        order[to] = particle;
    }
}

void prepare_strips(field *f, const variant *v)
{
    sph2d__store *s = &f->store;
    double support = safe(f->scene.support);
    grid_lay(f, support / v->columns, support);
    key_by_rectangle(f);
    sort_by_key(f, (size_t)f->grid.nx * f->grid.ny);
    for (size_t k = 0; k < s->count; ++k)
        f->sorted[k] = s->x[f->order.at[k]];
    for (size_t row = 0; row < f->grid.ny; ++row)
        sort_row(f->order.at, f->sorted, f->start.at[row * f->grid.nx], f->start.at[(row + 1) * f->grid.nx]);
    sph2d__store_reorder(s, f->order.at);
}

/** The bits of a number with a free place beside each. */
static uint32_t spread(uint32_t a)
{
    a = (a | a << 8) & 0x00ff00ffu;
    a = (a | a << 4) & 0x0f0f0f0fu;
    a = (a | a << 2) & 0x33333333u;
    return (a | a << 1) & 0x55555555u;
}

/** Cells in the order of Morton 1966, so that those near in both directions are near in memory. */
void prepare_morton(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    grid_lay(f, safe(f->scene.support), safe(f->scene.support));
    uint32_t *column = numbers_reserve(&f->spread_x, f->grid.nx), *row = numbers_reserve(&f->spread_y, f->grid.ny);
    for (uint32_t k = 0; k < f->grid.nx; ++k)
        column[k] = spread(k);
    for (uint32_t k = 0; k < f->grid.ny; ++k)
        row[k] = spread(k) << 1;
    uint32_t *key = numbers_reserve(&f->key, s->count);
    for (size_t i = 0; i < s->count; ++i)
        key[i] = row[grid_row(&f->grid, s->y[i])] | column[grid_column(&f->grid, s->x[i])];
    sort_by_key(f, (size_t)(row[f->grid.ny - 1] | column[f->grid.nx - 1] | 1) + 1);
    sph2d__store_reorder(&f->store, f->order.at);
}

/** Blocks in the order of cells as the library has them. */
void prepare_packed(field *f, const variant *v)
{
    size_t count = f->store.count;
    block *from = f->blocks;
    double support = safe(f->scene.support), low_x = from[0].x, low_y = from[0].y, high_x = low_x, high_y = low_y;
    for (size_t i = 1; i < count; ++i) {
        low_x = from[i].x < low_x ? from[i].x : low_x;
        low_y = from[i].y < low_y ? from[i].y : low_y;
        high_x = from[i].x > high_x ? from[i].x : high_x;
        high_y = from[i].y > high_y ? from[i].y : high_y;
    }
    double width = support / v->columns;
    f->grid = (grid){low_x - RIM * support, low_y - RIM * support, 1 / width, 1 / support, 0, 0};
    f->grid.nx = grid_column(&f->grid, high_x) + RIM * v->columns + 1;
    f->grid.ny = grid_row(&f->grid, high_y) + RIM + 1;
    uint32_t *key = numbers_reserve(&f->key, count);
    for (size_t i = 0; i < count; ++i)
        key[i] = grid_row(&f->grid, from[i].y) * f->grid.nx + grid_column(&f->grid, from[i].x);
    sort_by_key(f, (size_t)f->grid.nx * f->grid.ny);
    for (size_t k = 0; k < count; ++k)
        f->other_blocks[k] = from[f->order.at[k]];
    f->blocks = f->other_blocks;
    f->other_blocks = from;
}
