/* SPDX-License-Identifier: MIT */
/** @file grid_device.c
 *  What of the grid of method `hybrid` a device has, and kernels that work on it. */
#include "methods/common/on_device.h"
#include "methods/hybrid/grid.h"
#include "methods/hybrid/multigrid.h"

static const void *data_of(const sph2d__system *s)
{
    return s->grid;
}

/** Fields of a level that are of one float, or number, a square; and of a row. */
static void place_level(const sph2d__system *s, sph2d__level *l)
{
    void *const fields[] = {&l->left, &l->below, &l->air, &l->inverse}, *const rows[] = {&l->from, &l->to};
    for (size_t k = 0; k < sizeof fields / sizeof *fields; ++k)
        sph2d__place_block(s, fields[k], l->size * sizeof(float), SPH2D__OF_GRID);
    for (size_t k = 0; k < sizeof rows / sizeof *rows; ++k)
        sph2d__place_block(s, rows[k], ((size_t)l->ny + 4) * sizeof(int), SPH2D__OF_GRID);
}

static void place_work(const sph2d__system *s, sph2d__grid *g, sph2d__work *w)
{
    void *const finest[] = {&w->residual, &w->z, &w->direction, &w->product, &w->cycle[0].product};
    for (size_t k = 0; k < sizeof finest / sizeof *finest; ++k)
        sph2d__place_block(s, finest[k], g->size * sizeof(float), SPH2D__OF_GRID);
    for (int n = 1; n < g->levels; ++n) {
        void *const all[] = {&w->cycle[n].value, &w->cycle[n].rest, &w->cycle[n].product};
        for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
            sph2d__place_block(s, all[k], g->level[n].size * sizeof(float), SPH2D__OF_GRID);
    }
}

static void place(const sph2d__system *s, void *copy)
{
    sph2d__grid *g = copy;
    *g = *s->grid;
    for (int n = 0; n < g->levels; ++n)
        place_level(s, &g->level[n]);
    place_work(s, g, &g->pressure);
    place_work(s, g, &g->volume);
#define PLACE(name) sph2d__place_block(s, &g->name, g->size * sizeof *g->name, SPH2D__OF_GRID);
    SPH2D__GRID_FIELDS(PLACE)
    PLACE(face_x)
    PLACE(face_y)
    PLACE(sums.x)
    PLACE(sums.y)
    PLACE(sums.middle)
    PLACE(cut)
#undef PLACE
    sph2d__place_block(s, &g->begin, ((size_t)g->ny + 4) * sizeof *g->begin, SPH2D__OF_SCENE);
    sph2d__place_block(s, &g->end, ((size_t)g->ny + 4) * sizeof *g->end, SPH2D__OF_SCENE);
    sph2d__place_block(s, &g->nozzles, g->nozzle_count * sizeof *g->nozzles, SPH2D__OF_SCENE);
    sph2d__place_block(s, &g->jets, g->jet_count * sizeof *g->jets, SPH2D__OF_SCENE);
}

_Static_assert(sizeof(sph2d__grid) <= SPH2D__MOST_EXTRA, "kernels get a grid of this size");
const struct sph2d__extra sph2d__grid_extra = {sizeof(sph2d__grid), data_of, place};

void sph2d__grid_fetch(const sph2d__grid *g, void *const *arrays, size_t count)
{
    for (size_t k = 0; g->on_device && k < count; ++k)
        sph2d__host_reads_block(g->on_device, arrays[k]);
}

void sph2d__grid_send(const sph2d__grid *g, void *const *arrays, size_t count)
{
    for (size_t k = 0; g->on_device && k < count; ++k)
        sph2d__host_changed_block(g->on_device, arrays[k]);
}

/** Fields as offsets. */
static sph2d__grid_work placed(const sph2d__system *s, const sph2d__grid_work *with)
{
    sph2d__grid_work to = *with;
    for (size_t k = 0; k < sizeof to.field / sizeof *to.field; ++k) {
        const uint64_t offset = sph2d__device_offset(s, with->field[k]);
        memcpy(&to.field[k], &offset, sizeof offset);
    }
    return to;
}

void sph2d__grid_run(const sph2d__grid *g, const char *kernel, size_t count, const sph2d__grid_work *with)
{
    const sph2d__grid_work to = placed(g->on_device, with);
    sph2d__device_span_with(g->on_device, kernel, count, &to, sizeof to);
}

double sph2d__grid_sum_rows(const sph2d__grid *g, const sph2d__grid_work *with)
{
    const sph2d__grid_work to = placed(g->on_device, with);
    const size_t rows = (size_t)g->ny + 1;
    const float *sums = sph2d__device_results(g->on_device->device, "grid_dot", rows * SIDE_BY_SIDE, &to, sizeof to, 0,
                                              SPH2D__DEVICE_GROUP / SIDE_BY_SIDE * sizeof *sums);
    double sum = 0;
    for (size_t j = 1; sums && j < rows; ++j)
        sum += (double)sums[j];
    return sum;
}

void sph2d__grid_sum_on_device(const sph2d__grid *g, double dt)
{
    const sph2d__grid_work across = {.times = 0}, along = {.times = 1};
    sph2d__grid_send(g, (void *[]){g->begin, g->end}, 2);
    if (g->nozzle_count > 0)
        sph2d__grid_send(g, (void *[]){g->open_x, g->open_y, g->hidden, g->cut, g->nozzles, g->jets}, 6);
    sph2d__grid_run(g, "grid_clear", g->size, &(sph2d__grid_work){0});
    sph2d__device_span_with(g->on_device, "grid_sum", g->size, &dt, sizeof dt);
    if (g->wraps_x)
        sph2d__grid_run(g, "grid_fold", (size_t)g->ny + 4, &across);
    if (g->wraps_y)
        sph2d__grid_run(g, "grid_fold", (size_t)g->nx + 4, &along);
}

/** How many squares inside solids do not yet tell how full they are, after one sweep more. */
static uint32_t spread(const sph2d__grid *g)
{
    const sph2d__grid_work none = {0};
    sph2d__grid_run(g, "grid_look_beside", g->cut_count, &none);
    const uint32_t *left =
        sph2d__device_results(g->on_device->device, "grid_spread", g->cut_count, NULL, 0, SPH2D__OF_GRID, sizeof *left);
    uint32_t sum = 0;
    for (size_t k = 0; left && k < (g->cut_count + SPH2D__DEVICE_GROUP - 1) / SPH2D__DEVICE_GROUP; ++k)
        sum += left[k];
    return sum;
}

void sph2d__grid_fill_cut_squares(const sph2d__grid *g)
{
    const sph2d__grid_work none = {0};
    if (g->cut_count == 0)
        return;
    sph2d__grid_run(g, "grid_begin_cut", g->cut_count, &none);
    sph2d__grid_run(g, "grid_look_at_cut", g->cut_count, &none);
    uint32_t before, left = UINT32_MAX;
    do {
        before = left;
        left = spread(g);
    } while (left > 0 && left < before);
    sph2d__grid_run(g, "grid_fill_cut", g->cut_count, &none);
}
