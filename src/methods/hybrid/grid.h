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

#include "sim/simulation.h"
#include "simd/isa.h"

/** Most levels of the multigrid. */
enum { SPH2D__LEVELS = 12 };

/** A level of the equations: of square k the couplings with its neighbours on the left and below, and those with air. */
typedef struct sph2d__level {
    int nx, ny;
    size_t stride, size;
    float *left, *below, *air;
    float *inverse; /**< 1 over the diagonal; 0: no liquid */
    int *from, *to; /**< first and last liquid square of each row; to < from: none */
} sph2d__level;

/** What a solution needs beside the equations: two are found at the same time. */
typedef struct sph2d__work {
    float *residual; /**< the right side, then what is left */
    float *z, *direction,
        *product; /**< of conjugate gradients: the residual preconditioned, the direction, the matrix times it */
    struct {
        float *value, *rest, *product;
    } cycle[SPH2D__LEVELS]; /**< of multigrid, on each level; on the finest only `product` */
} sph2d__work;

/** Two and four floats that are read together. */
typedef struct sph2d__pair2 {
    float value, weight;
} sph2d__pair2;
typedef float sph2d__quad __attribute__((vector_size(16)));

/** What a face says: its new velocity, a displacement, and 1; zeros where it is not known. */
enum { SPH2D__NEW, SPH2D__DISPLACEMENT, SPH2D__KNOWN };

/** Sums over particles, with bilinear weights. */
typedef struct sph2d__sums {
    sph2d__pair2 *x, *y; /**< on faces: velocities and weights */
    sph2d__quad *middle; /**< in squares: weight, rho/rho0 - 1, q */
} sph2d__sums;

/** The part of the face between two squares that a solid closes which moves. */
typedef struct sph2d__part {
    uint32_t before, after;      /**< the squares; `before` is on the left or below */
    uint32_t body;               /**< the body that the solid is of, from 1; 0: its motion is given */
    float wet_before, wet_after; /**< 1 where they are liquid, else 0 */
    float speed;                 /**< of the part, across the face [m/s] */
    float by[3];                 /**< what flows across when the solid moves by 1 m/s, or turns by 1 rad/s */
} sph2d__part;

/** A face in the mouth of a source. */
typedef struct sph2d__nozzle {
    uint32_t face, square; /**< the square into which liquid flows */
    uint32_t source;
    bool x, side, open; /**< a left face, else a lower one; one of the domain's; the source emits */
    float part, hidden; /**< of the face, and of the square behind that */
    float speed;        /**< across the face [m/s] */
    float flow;         /**< into the square [m^2/s] */
} sph2d__nozzle;

typedef struct sph2d__grid {
    int nx, ny, levels;
    size_t stride, size;
    bool wraps_x, wraps_y;
    int first, last;     /**< rows that a step sets: those with particles, and some around them */
    int *begin, *end;    /**< of these rows the first square, and the one behind the last; elsewhere fields are 0 */
    bool open[4];        /**< sides beyond which there is air: left, right, bottom, top */
    double low_x, low_y; /**< its lower left corner [m] */
    double inverse_x, inverse_y; /**< 1 over the sides of a square [1/m] */
    float hx, hy;                /**< these sides [m] */
    sph2d__level level[SPH2D__LEVELS];

    float *still, *distance;    /**< of corners from solids: from those at rest, and from all [m] */
    float *still_x, *still_y;   /**< open part of left and lower faces beside solids at rest */
    float *open_x, *open_y;     /**< and beside all */
    float *wall_x, *wall_y;     /**< velocity of their closed part across them [m/s] */
    float *corner_u, *corner_v; /**< velocity of the solid or side at a corner [m/s] */
    float *still_stick, *stick; /**< of corners: 1 where the nearest solid, or side, has no slip; at rest, and of all */
    float *room;                /**< 1 over the weight of a square that is full */
    float *still_hidden;        /**< the part of it that lies in solids at rest */
    float *hidden;              /**< and in all */
    float *mass, *excess;       /**< weight over that; mean of rho/rho0 - 1 */
    uint32_t *cut;              /**< squares with a part in solids */
    float *filled;              /**< their masses, for a while */
    size_t cut_count, still_cut_count; /**< of all, and by solids at rest */
    uint32_t *member, *pocket_end;     /**< squares of pockets, one after the other, and where each ends (pockets.c) */
    uint8_t *seen;
    size_t pockets;
    float *u, *v; /**< velocities across left and lower faces [m/s] */
    float *wet_x,
        *wet_y; /**< part of the difference over a square that acts: 1 between liquid, air_x beside air, else 0 */
    float *air_x, *air_y; /**< 1 over the part of the way to the surface where one side is air, else 0 */
    float *q, *s;         /**< p dt/rho0 [m^2/s]; potential of displacements [m^2] */
    sph2d__work pressure, volume;
    sph2d__quad *face_x, *face_y;
    sph2d__sums sums;

    sph2d__part *parts; /**< of faces, closed by solids that move (grid_cut.c) */
    size_t part_count, part_capacity;
    sph2d__nozzle *nozzles; /**< grid_nozzles.c */
    size_t nozzle_count;
    double (*inverse)[3]; /**< of bodies: rest density over mass and moment of inertia; 0 where they are held */
    double *push;         /**< of each body three sums */
    struct sph2d__twist *impulses;
    size_t body_count;
    const struct sph2d__multigrid *solver;
    uint64_t next_id; /**< with the count it tells whether particles came or went since the last step */
    size_t count;
    double surface_energy; /**< at the last evaluation [J/m] */
    size_t packed; /**< places of the particles are in floats, too, in arrays of this capacity (hybrid.c); 0: not */
    void *block;   /**< all arrays */
    size_t block_size;
} sph2d__grid;

/** Part of the bilinear weights around a point that is beyond a straight wall at a distance, in squares. */
static inline float sph2d__hidden_part(float t)
{
    return t >= 1 ? 0 : t >= 0 ? (1 - t) * (1 - t) / 2 : t > -1 ? 1 - (1 + t) * (1 + t) / 2 : 1;
}

/** The index of square (i, j), of its left and lower faces and of its lower left corner. */
static inline size_t sph2d__at(const sph2d__grid *g, int i, int j)
{
    return (size_t)j * g->stride + (size_t)i;
}

/** The square or corner at a place, in squares, from 0 to `last`. */
static inline int sph2d__grid_clamp(double at, int last)
{
    return at > 0 ? at < last ? (int)at : last : 0;
}

/** Runs the statement behind it for the squares k of row j that a step sets. */
#define SPH2D__FOR_SPAN(g, j, k)                                                                                       \
    for (size_t k = sph2d__at(g, (g)->begin[j], j), last_##k = sph2d__at(g, (g)->end[j], j); k < last_##k; ++k)

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

struct sph2d__batch;

/** Keeps the displacements of a batch from falling behind the jets that it leaves sources with (grid_nozzles.c). */
void sph2d__grid_keep_pace(const sph2d_sim *sim, double dt, struct sph2d__batch *batch);

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

#endif
