/* SPDX-License-Identifier: MIT */
/** @file lists_rows.c
 *  Lists of neighbours that serve a few steps (Verlet 1967): they hold what may come near meanwhile. Particles are
 *  sorted whenever lists are made. */
#include <stdlib.h>
#include <string.h>

#include "sift.h"

/** Makes room for one more list, of what is in `near`. Returns where it begins. */
static uint32_t *room_for(field *f, uint32_t begin, const sph2d__ranges *near)
{
    size_t needed = (size_t)begin + 2 * SPH2D__LANES;
    for (int r = 0; r < near->count; ++r)
        needed += near->end[r] - near->begin[r] + SPH2D__LANES;
    if (needed > f->list.capacity) { /* keeps what is there */
        numbers larger = {0};
        numbers_reserve(&larger, needed + needed / 2 + 64 * f->store.count);
        if (begin > 0)
            memcpy(larger.at, f->list.at, begin * sizeof(uint32_t));
        free(f->list.at);
        f->list = larger;
    }
    return f->list.at + begin;
}

/** Lists of each particle, filled up to whole blocks with one that is far from all. */
static void prepare_lists(field *f, const variant *v)
{
    const double reach = f->scene.support + skin_of(f, v);
    sort_in_cells(f, reach, v->columns);
    const sph2d__store *s = &f->store;
    uint32_t *begin = numbers_reserve(&f->list_begin, s->count + 1);
    begin[0] = 0;
    for (size_t i = 0; i < s->count; ++i) {
        const sph2d__lanes x = sph2d__lanes_all(s->x[i]), y = sph2d__lanes_all(s->y[i]);
        sph2d__ranges near;
        sph2d__cells_ranges(&f->cells, f->cells.cell[f->cells.order[i]], &near);
        uint32_t *to = room_for(f, begin[i], &near);
        for (int r = 0; r < near.count; ++r)
            for (size_t j = near.begin[r]; j < near.end[r]; j += SPH2D__LANES) {
                sph2d__lanes dx = x - sph2d__lanes_load(s->x + j), dy = y - sph2d__lanes_load(s->y + j);
                unsigned which = sph2d__lanes_which(dx * dx + dy * dy, reach * reach);
                sph2d__lanes_pack_index(to, (uint32_t)j, which);
                to += __builtin_popcount(which);
            }
        while ((size_t)(to - f->list.at - begin[i]) % SPH2D__LANES != 0)
            *to++ = (uint32_t)s->count;
        begin[i + 1] = (uint32_t)(to - f->list.at);
    }
}

/** One particle at a time, neighbours gathered. */
static void pass_lists(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    for (size_t i = 0; i < s->count; ++i) {
        const receiver me = receiver_at(s, &n, i);
        sums sum = {0};
        for (uint32_t k = f->list_begin.at[i]; k < f->list_begin.at[i + 1]; k += SPH2D__LANES) {
            const uint32_t *j = f->list.at + k;
            candidate you = {sph2d__lanes_gather(s->x, j),       sph2d__lanes_gather(s->y, j),
                             sph2d__lanes_gather(s->vx, j),      sph2d__lanes_gather(s->vy, j),
                             sph2d__lanes_gather(s->density, j), sph2d__lanes_gather(s->pressure, j),
                             sph2d__lanes_gather(s->volume, j)};
            add_pair(&sum, &n, &me, &you);
        }
        write_total(f, i, &sum);
    }
}

/** One list for all particles of a group (Pall & Hess 2013): what is near its box. */
static void prepare_group_lists(field *f, const variant *v)
{
    const double reach = f->scene.support + skin_of(f, v);
    sort_in_cells(f, reach, v->columns);
    const sph2d__store *s = &f->store;
    const sph2d__grouping by = sph2d__grouping_of(s, &f->cells, NULL);
    uint32_t *begin = numbers_reserve(&f->list_begin, s->count + 1);
    uint32_t *first = numbers_reserve(&f->group_first, s->count + 1);
    size_t count = 0;
    begin[0] = 0;
    SPH2D__FOR_GROUPS (&by, g, 0, s->count) {
        sph2d__ranges near;
        sph2d__group_box(s, &g);
        sph2d__patch_ranges(by.cells, &g.patch, &near);
        uint32_t *to = room_for(f, begin[count], &near);
        for (int r = 0; r < near.count; ++r)
            to = sift_by_box(s, &g, reach * reach, near.begin[r], near.end[r], to);
        first[count++] = (uint32_t)g.first;
        begin[count] = (uint32_t)(to - f->list.at);
    }
    first[count] = (uint32_t)s->count;
    f->group_count = count;
}

/** A particle in each lane, those of the list one by one. */
static void pass_group_lists(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    for (size_t g = 0; g < f->group_count; ++g) {
        size_t first = f->group_first.at[g];
        const receiver me = receivers_at(s, &n, first);
        sums sum = {0};
        for (uint32_t k = f->list_begin.at[g]; k < f->list_begin.at[g + 1]; ++k) {
            candidate you = candidate_at(s, f->list.at[k]);
            add_pair(&sum, &n, &me, &you);
        }
        const sums done = sum;
        write_lanes(f, first, (int)(f->group_first.at[g + 1] - first), &done);
    }
}

#define LISTS(k, text)                                                                                                 \
    {"lists of a particle, for " text, prepare_lists, pass_lists, .columns = 4, .steps = k},                           \
    {                                                                                                                  \
        "lists of a group, for " text, prepare_group_lists, pass_group_lists, .columns = 4, .steps = k                 \
    }
const variant VARIANTS_OF(lists)[] = {
    LISTS(1, "one step"), LISTS(2, "2 steps"), LISTS(4, "4 steps"), LISTS(8, "8 steps"), {0}};
