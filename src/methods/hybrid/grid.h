/* SPDX-License-Identifier: MIT */
/** @file grid.h
 *  The grid of method `hybrid`: squares over the domain, velocities on their faces.
 *
 *  Beyond an open side it goes on for the width or height of the domain, where particles leave the scene.
 *
 *  Square (i, j), from 1 to nx and ny, has its left face at column i and its lower one at row j; around them is a ring of
 *  squares outside: closed walls, air beyond open ends, or the squares of the opposite side where the domain is
 *  periodic. The side of a square is about 1.9 spacings, divides the domain, and may differ between x and y. */
#ifndef SPH2D_METHODS_HYBRID_GRID_H
#define SPH2D_METHODS_HYBRID_GRID_H

#include <string.h>

#include "methods/hybrid/grid_data.h"
#include "sim/simulation.h"
#include "simd/isa.h"

/** Makes the grid of a simulation, if it has none yet. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__grid_prepare(sph2d_sim *sim);
void sph2d__grid_free(sph2d__system *system);

/** Finds the squares that a step sets, by the cells with particles, and clears those of the last step (to_grid.c). */
void sph2d__grid_find_spans(const sph2d_sim *sim, sph2d__grid *grid);

/** Cuts all squares by the solids at rest. */
void sph2d__grid_place_solids(sph2d_sim *sim, sph2d__grid *grid);

/** Sets the open parts of these squares' faces, by the solids where they are at the end of the drift (grid_cut.c). False:
 *  memory is short. */
bool sph2d__grid_cut(sph2d_sim *sim, sph2d__grid *grid);

/** The faces of sources: most of them, where they are, and which are closed in a step (grid_nozzles.c). */
size_t sph2d__grid_most_nozzles(const sph2d_scene *scene, const sph2d__grid *grid);
void sph2d__grid_place_nozzles(const sph2d_scene *scene, sph2d__grid *grid);
void sph2d__grid_open_nozzles(const sph2d_sim *sim, sph2d__grid *grid);
/** The work of sources on the liquid before them, by pressure [J/m]. */
double sph2d__grid_nozzle_work(const sph2d__grid *grid, double density);

/** What the kernels of a device get of the grid (grid_device.c). */
extern const struct sph2d__extra sph2d__grid_extra;
/** Where a device solves: before the host reads some of the grid's arrays, after it has written some. */
void sph2d__grid_fetch(const sph2d__grid *grid, void *const *arrays, size_t count);
void sph2d__grid_send(const sph2d__grid *grid, void *const *arrays, size_t count);
/** There: sph2d__grid_sum, and what a solution does to squares that solids cut. */
void sph2d__grid_sum_on_device(const sph2d__grid *grid, double dt);
void sph2d__grid_fill_cut_squares(const sph2d__grid *grid);

struct sph2d__batch;

/** Sums velocities, densities and pressures of the particles (to_grid.c). */
void sph2d__grid_sum(sph2d_sim *sim, sph2d__grid *grid, double dt);

/** Loops over particles beside the grid, compiled once for each instruction set (transfer_pass.c). */
typedef struct sph2d__transfer_passes {
    /** Sums velocities, densities and pressures of the particles on rows `first` to `last` - 1. */
    void (*sum)(const sph2d_sim *sim, int first, int last, double dt);
    /** Sets velocities, their slopes, and displacements of a batch by what faces say. */
    void (*move)(sph2d_sim *sim, double dt, struct sph2d__batch *batch);
} sph2d__transfer_passes;
SPH2D__COPIES(sph2d__transfer_passes, sph2d__transfer_passes)

/** Loops over squares, compiled once for each instruction set. */
typedef struct sph2d__grid_passes {
    /** Finds the liquid, its surface and its pressure, and sets what faces say; `viscosity` is nu dt [m^2]
     *  (grid_solve_pass.c). */
    void (*solve)(sph2d__grid *grid, double viscosity);
} sph2d__grid_passes;
SPH2D__COPIES(sph2d__grid_passes, sph2d__grid_passes)

/** Notes on which sides parts are wet, once the liquid is known; adds G M^-1 G' p to `out`, G the columns of bodies; and the
 *  impulses of pressure on bodies, as three numbers each (grid_bodies.c) [N s/m]. */
void sph2d__grid_wet_parts(sph2d__grid *grid);
void sph2d__grid_add_bodies(const sph2d__grid *grid, const float *p, float *out);
void sph2d__grid_impulses(const sph2d__grid *grid, double density, struct sph2d__twist *impulses);

/** The work of solids with a given motion on the liquid, by pressure [J/m]. */
double sph2d__grid_wall_work(const sph2d__grid *grid, double density);

/** Finds the pockets of the equations of level 0, and takes its mean out of a field in each (pockets.c). */
void sph2d__grid_find_pockets(sph2d__grid *grid);
void sph2d__grid_level_pockets(const sph2d__grid *grid, float *field);

/** Whether a viscosity, nu dt [m^2], changes velocities by more than its solver leaves of them; applies it
 *  (grid_viscosity.c). */
bool sph2d__grid_is_viscous(const sph2d__grid *grid, double number);
void sph2d__grid_viscosity(sph2d__grid *grid, double number);

/** The solver (multigrid_pass.c). */
typedef struct sph2d__multigrid {
    /** Sets the coarser levels from the finest one. */
    void (*prepare)(sph2d__grid *grid);
    /** Improves `value` of the equations of level 0, with `bodies` among them, by `iterations` of conjugate gradients, with
     *  one cycle of multigrid each. */
    void (*solve)(const sph2d__grid *grid, const sph2d__work *work, float *value, bool bodies, int iterations);
} sph2d__multigrid;
SPH2D__COPIES(sph2d__multigrid, sph2d__multigrid)

/** Sets rows `first` to `last` of a field to 0, and what the loops over faces and the next level read around them. */
static inline void sph2d__level_clear(const sph2d__level *l, float *field, int first, int last)
{
    const int from = first > 1 ? first - 1 : 0, to = last + 4 < l->ny + 4 ? last + 4 : l->ny + 4;
    memset(field + (size_t)from * l->stride, 0, (size_t)(to - from) * l->stride * sizeof *field);
}

/** Runs a kernel with `count` threads, where a device solves (grid_device.c); one that sums up rows of level 0 in floats: their
 *  sum, in their order. */
void sph2d__grid_run(const sph2d__grid *grid, const char *kernel, size_t count, const sph2d__grid_work *with);
double sph2d__grid_sum_rows(const sph2d__grid *grid, const sph2d__grid_work *with);

/** Sets the squares of the ring of a periodic domain. */
static inline void sph2d__level_wrap(const sph2d__grid *g, const sph2d__level *l, float *field)
{
    for (int j = 1; j <= l->ny && g->wraps_x; ++j) {
        float *row = field + (size_t)j * l->stride;
        row[0] = row[l->nx];
        row[l->nx + 1] = row[1];
    }
    if (g->wraps_y) {
        memcpy(field, field + (size_t)l->ny * l->stride, l->stride * sizeof *field);
        memcpy(field + (size_t)(l->ny + 1) * l->stride, field + l->stride, l->stride * sizeof *field);
    }
}

/** The same, wherever the field is. */
static inline void sph2d__grid_wrap(const sph2d__grid *g, const sph2d__level *l, float *field)
{
    const sph2d__grid_work with = {.field = {field}, .level = (int)(l - g->level)};
    if (!g->on_device)
        sph2d__level_wrap(g, l, field);
    else if (g->wraps_x || g->wraps_y)
        sph2d__grid_run(g, "grid_wrap", l->size, &with);
}

#endif
