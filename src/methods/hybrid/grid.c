/* SPDX-License-Identifier: MIT */
/** @file grid.c
 *  Makes the grid of method `hybrid`. */
#include "methods/hybrid/grid.h"

#include <math.h>
#include <string.h>

#include "scene/method_table.h"

/* Squares of a periodic direction are a multiple of this, so that levels divide them. */
enum { PERIODIC_SQUARES = 8, SMALLEST = 4 };

static int squares_of(double length, double spacing, bool wraps)
{
    const double wanted = length / (SPH2D__SQUARE * spacing);
    const int multiple = wraps ? PERIODIC_SQUARES : 1, n = multiple * (int)lround(wanted / multiple);
    return n < multiple ? multiple : n;
}

/* ---- memory ------------------------------------------------------------------------------------------------------ */

/** Hands out parts of the block; without one it counts. */
typedef struct room {
    char *block;
    size_t used;
} room;

static void *take(room *r, size_t count, size_t size)
{
    void *at = r->block ? r->block + r->used : NULL;
    r->used += (count * size + 63) / 64 * 64;
    return at;
}

static void lay_out_level(sph2d__level *l, int nx, int ny, room *r)
{
    l->nx = nx;
    l->ny = ny;
    l->stride = ((size_t)nx + 4 + 15) / 16 * 16;
    l->size = l->stride * ((size_t)ny + 4);
    float **const all[] = {&l->left, &l->below, &l->air, &l->inverse};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        *all[k] = take(r, l->size, sizeof(float));
    l->from = take(r, (size_t)ny + 4, sizeof(int));
    l->to = take(r, (size_t)ny + 4, sizeof(int));
}

static void lay_out_sums(sph2d__sums *s, size_t size, room *r)
{
    s->x = take(r, size, sizeof *s->x);
    s->y = take(r, size, sizeof *s->y);
    s->middle = take(r, size, sizeof *s->middle);
}

static void lay_out_work(const sph2d__grid *g, sph2d__work *w, room *r)
{
    float **const finest[] = {&w->residual, &w->z, &w->direction, &w->product, &w->cycle[0].product};
    for (size_t k = 0; k < sizeof finest / sizeof *finest; ++k)
        *finest[k] = take(r, g->size, sizeof(float));
    for (int n = 1; n < g->levels; ++n) {
        float **const all[] = {&w->cycle[n].value, &w->cycle[n].rest, &w->cycle[n].product};
        for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
            *all[k] = take(r, g->level[n].size, sizeof(float));
    }
}

static void lay_out(sph2d__grid *g, size_t nozzles, room *r)
{
    int nx = g->nx, ny = g->ny;
    for (g->levels = 0; g->levels < SPH2D__LEVELS;) {
        lay_out_level(&g->level[g->levels++], nx, ny, r);
        if ((nx <= SMALLEST && ny <= SMALLEST) || (g->wraps_x && nx % 2 != 0) || (g->wraps_y && ny % 2 != 0))
            break;
        nx = (nx + 1) / 2;
        ny = (ny + 1) / 2;
    }
    g->stride = g->level[0].stride;
    g->size = g->level[0].size;
    float **const all[] = {&g->still,    &g->distance, &g->still_x,     &g->still_y, &g->open_x,
                           &g->open_y,   &g->wall_x,   &g->wall_y,      &g->room,    &g->hidden,
                           &g->corner_u, &g->corner_v, &g->still_stick, &g->stick,   &g->still_hidden,
                           &g->mass,     &g->excess,   &g->u,           &g->v,       &g->air_x,
                           &g->air_y,    &g->q,        &g->s,           &g->wet_x,   &g->wet_y};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        *all[k] = take(r, g->size, sizeof(float));
    lay_out_work(g, &g->pressure, r);
    lay_out_work(g, &g->volume, r);
    g->cut = take(r, g->size, sizeof *g->cut);
    g->filled = take(r, g->size, sizeof *g->filled);
    g->member = take(r, g->size, sizeof *g->member);
    g->pocket_end = take(r, g->size, sizeof *g->pocket_end);
    g->seen = take(r, g->size, sizeof *g->seen);
    g->begin = take(r, (size_t)g->ny + 4, sizeof *g->begin);
    g->end = take(r, (size_t)g->ny + 4, sizeof *g->end);
    g->face_x = take(r, g->size, sizeof(sph2d__quad));
    g->face_y = take(r, g->size, sizeof(sph2d__quad));
    lay_out_sums(&g->sums, g->size, r);
    g->nozzles = take(r, nozzles, sizeof *g->nozzles);
    g->jets = take(r, g->jet_count, sizeof *g->jets);
    g->inverse = take(r, g->body_count, sizeof *g->inverse);
    g->push = take(r, 3 * g->body_count, sizeof *g->push);
    g->impulses = take(r, g->body_count, sizeof *g->impulses);
}

static void set_shape(const sph2d_sim *sim, sph2d__grid *g)
{
    const sph2d_scene *scene = &sim->world.scene;
    const sph2d_boundary *b = &scene->boundary;
    const sph2d_box *d = &sim->world.box;
    const double width = d->max.x - d->min.x, height = d->max.y - d->min.y;
    g->wraps_x = sim->system.fluid_cells.period.length_x > 0;
    g->wraps_y = sim->system.fluid_cells.period.length_y > 0;
    g->open[0] = b->left == SPH2D_SIDE_OPEN;
    g->open[1] = b->right == SPH2D_SIDE_OPEN;
    g->open[2] = b->bottom == SPH2D_SIDE_OPEN;
    g->open[3] = b->top == SPH2D_SIDE_OPEN;
    const int nx = squares_of(width, scene->spacing, g->wraps_x), ny = squares_of(height, scene->spacing, g->wraps_y);
    g->nx = nx * (1 + g->open[0] + g->open[1]);
    g->ny = ny * (1 + g->open[2] + g->open[3]);
    g->low_x = d->min.x - g->open[0] * width;
    g->low_y = d->min.y - g->open[2] * height;
    g->inverse_x = nx / width;
    g->inverse_y = ny / height;
    g->hx = (float)(width / nx);
    g->hy = (float)(height / ny);
}

void sph2d__grid_free(sph2d__system *s)
{
    void *block = s->grid ? s->grid->block : NULL, *parts = s->grid ? s->grid->parts : NULL, *grid = s->grid;
    if (!grid)
        return;
    sph2d__release(s->memory, &parts, s->grid->part_capacity, sizeof *s->grid->parts);
    sph2d__release(s->memory, &block, s->grid->block_size, 1);
    sph2d__release(s->memory, &grid, 1, sizeof *s->grid);
    s->grid = NULL;
    s->extra = NULL;
}

sph2d_status sph2d__grid_prepare(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    if (s->grid)
        return SPH2D_OK;
    sph2d__grid *g = s->grid = sph2d__alloc(s->memory, 1, sizeof *g);
    if (!g)
        return SPH2D_NOMEM;
    g->solver = sph2d__multigrid_find(s->isa);
    g->body_count = sim->bodies.count;
    g->jet_count = sim->world.scene.source_count;
    set_shape(sim, g);
    room counted = {NULL, 0};
    const size_t nozzles = sph2d__grid_most_nozzles(&sim->world.scene, g);
    lay_out(g, nozzles, &counted);
    g->block = sph2d__alloc(s->memory, counted.used + 64, 1);
    if (!g->block) {
        sph2d__grid_free(s);
        return SPH2D_NOMEM;
    }
    g->block_size = counted.used + 64;
    room given = {(char *)g->block + (64 - (uintptr_t)g->block % 64) % 64, 0};
    lay_out(g, nozzles, &given);
    sph2d__grid_place_solids(sim, g);
    sph2d__grid_place_nozzles(&sim->world.scene, g);
    s->extra = &sph2d__grid_extra;
    g->on_device = sph2d__is_on_device(s) ? s : NULL;
    return SPH2D_OK;
}
