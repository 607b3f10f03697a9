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
    sph2d__place_block(s, &g->q, g->size * sizeof *g->q, SPH2D__OF_GRID);
    sph2d__place_block(s, &g->s, g->size * sizeof *g->s, SPH2D__OF_GRID);
    sph2d__place_block(s, &g->face_x, g->size * sizeof *g->face_x, SPH2D__OF_GRID);
    sph2d__place_block(s, &g->face_y, g->size * sizeof *g->face_y, SPH2D__OF_GRID);
    sph2d__place_block(s, &g->jets, g->jet_count * sizeof *g->jets, SPH2D__OF_SCENE);
    sph2d__place_block(s, &g->sums.x, g->size * sizeof *g->sums.x, SPH2D__OF_GRID);
    sph2d__place_block(s, &g->sums.y, g->size * sizeof *g->sums.y, SPH2D__OF_GRID);
    sph2d__place_block(s, &g->sums.middle, g->size * sizeof *g->sums.middle, SPH2D__OF_GRID);
}

_Static_assert(sizeof(sph2d__grid) <= SPH2D__MOST_EXTRA, "kernels get a grid of this size");
const struct sph2d__extra sph2d__grid_extra = {sizeof(sph2d__grid), data_of, place};

static void changed(const sph2d__grid *g, void *const *blocks, size_t count)
{
    for (size_t k = 0; g->on_device && k < count; ++k)
        sph2d__host_changed_block(g->on_device, blocks[k]);
}

void sph2d__grid_send(const sph2d__grid *g)
{
    const sph2d__level *l = g->level;
    void *const all[] = {
        l->left, l->below, l->air, l->inverse, l->from, l->to, g->pressure.residual, g->volume.residual, g->q, g->s};
    changed(g, all, sizeof all / sizeof *all);
}

void sph2d__grid_fetch(const sph2d__grid *g)
{
    if (!g->on_device)
        return;
    sph2d__host_reads_block(g->on_device, g->q);
    sph2d__host_reads_block(g->on_device, g->s);
}

void sph2d__grid_send_faces(const sph2d__grid *g)
{
    void *const all[] = {g->q, g->face_x, g->face_y, g->jets};
    changed(g, all, sizeof all / sizeof *all);
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
