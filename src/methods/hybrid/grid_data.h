/* SPDX-License-Identifier: MIT */
/** @file grid_data.h
 *  The arrays of the grid of method `hybrid` (grid.h), in C and in OpenCL C. */
#ifndef SPH2D_METHODS_HYBRID_GRID_DATA_H
#define SPH2D_METHODS_HYBRID_GRID_DATA_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/address.h"
#include "methods/hybrid/quads.h"

/** Most levels of the multigrid. */
enum { SPH2D__LEVELS = 12 };

/** A level of the equations: of square k the couplings with its neighbours on the left and below, and those with air. */
typedef struct sph2d__level {
    int nx, ny;
    size_t stride, size;
    SPH2D__ARRAY float *left, *below, *air;
    SPH2D__ARRAY float *inverse; /**< 1 over the diagonal; 0: no liquid */
    SPH2D__ARRAY int *from, *to; /**< first and last liquid square of each row; to < from: none */
} sph2d__level;

/** What a solution needs beside the equations: two are found at the same time. */
typedef struct sph2d__work {
    SPH2D__ARRAY float *residual; /**< the right side, then what is left */
    SPH2D__ARRAY float *z, *direction,
        *product; /**< of conjugate gradients: the residual preconditioned, the direction, the matrix times it */
    struct {
        SPH2D__ARRAY float *value, *rest, *product;
    } cycle[SPH2D__LEVELS]; /**< of multigrid, on each level; on the finest only `product` */
} sph2d__work;

/** Two floats that are read together. */
typedef struct sph2d__pair2 {
    float value, weight;
} sph2d__pair2;

/** What a face says: its new velocity, a displacement, and 1; zeros where it is not known. */
#define SPH2D__NEW(face) SPH2D__PART(face, 0)
#define SPH2D__DISPLACEMENT(face) SPH2D__PART(face, 1)
#define SPH2D__KNOWN(face) SPH2D__PART(face, 2)

/** Sums over particles, with bilinear weights. */
typedef struct sph2d__sums {
    SPH2D__ARRAY sph2d__pair2 *x, *y; /**< on faces: velocities and weights */
    SPH2D__ARRAY sph2d__quad *middle; /**< in squares: weight, rho/rho0 - 1, q */
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

/** What a source emits. */
typedef struct sph2d__jet {
    double x, y, ux, uy; /**< the middle of its mouth, and its direction, of length 1 */
    double half_width;   /**< [m] */
    double speed;        /**< [m/s] */
    bool open;           /**< it flows */
} sph2d__jet;

typedef struct sph2d__grid {
    int nx, ny, levels;
    size_t stride, size;
    bool wraps_x, wraps_y;
    int first, last; /**< rows that a step sets: those with particles, and some around them */
    SPH2D__ARRAY int *begin,
        *end;            /**< of these rows the first square, and the one behind the last; elsewhere fields are 0 */
    bool open[4];        /**< sides beyond which there is air: left, right, bottom, top */
    double low_x, low_y; /**< its lower left corner [m] */
    double inverse_x, inverse_y; /**< 1 over the sides of a square [1/m] */
    float hx, hy;                /**< these sides [m] */
    sph2d__level level[SPH2D__LEVELS];

    SPH2D__ARRAY float *still, *distance;    /**< of corners from solids: from those at rest, and from all [m] */
    SPH2D__ARRAY float *still_x, *still_y;   /**< open part of left and lower faces beside solids at rest */
    SPH2D__ARRAY float *open_x, *open_y;     /**< and beside all */
    SPH2D__ARRAY float *wall_x, *wall_y;     /**< velocity of their closed part across them [m/s] */
    SPH2D__ARRAY float *corner_u, *corner_v; /**< velocity of the solid or side at a corner [m/s] */
    SPH2D__ARRAY float *still_stick,
        *stick;               /**< of corners: 1 where the nearest solid, or side, has no slip; at rest, and of all */
    SPH2D__ARRAY float *room; /**< 1 over the weight of a square that is full */
    SPH2D__ARRAY float *still_hidden;  /**< the part of it that lies in solids at rest */
    SPH2D__ARRAY float *hidden;        /**< and in all */
    SPH2D__ARRAY float *mass, *excess; /**< weight over that; mean of rho/rho0 - 1 */
    SPH2D__ARRAY uint32_t *cut;        /**< squares with a part in solids */
    SPH2D__ARRAY float *filled;        /**< their masses, for a while */
    size_t cut_count, still_cut_count; /**< of all, and by solids at rest */
    SPH2D__ARRAY uint32_t *member,
        *pocket_end; /**< squares of pockets, one after the other, and where each ends (pockets.c) */
    SPH2D__ARRAY uint8_t *seen;
    size_t pockets;
    SPH2D__ARRAY float *u, *v; /**< velocities across left and lower faces [m/s] */
    SPH2D__ARRAY float *wet_x,
        *wet_y; /**< part of the difference over a square that acts: 1 between liquid, air_x beside air, else 0 */
    SPH2D__ARRAY float *air_x, *air_y; /**< 1 over the part of the way to the surface where one side is air, else 0 */
    SPH2D__ARRAY float *q, *s;         /**< p dt/rho0 [m^2/s]; potential of displacements [m^2] */
    sph2d__work pressure, volume;
    SPH2D__ARRAY sph2d__quad *face_x, *face_y;
    sph2d__sums sums;

    SPH2D__ARRAY sph2d__part *parts; /**< of faces, closed by solids that move (grid_cut.c) */
    size_t part_count, part_capacity;
    SPH2D__ARRAY sph2d__nozzle *nozzles; /**< grid_nozzles.c */
    size_t nozzle_count;
    SPH2D__ARRAY sph2d__jet *jets;
    size_t jet_count;
    SPH2D__ARRAY double (
        *inverse)[3];          /**< of bodies: rest density over mass and moment of inertia; 0 where they are held */
    SPH2D__ARRAY double *push; /**< of each body three sums */
    struct sph2d__twist *impulses;
    size_t body_count;
    const struct sph2d__multigrid *solver;
    const struct sph2d__system *on_device; /**< whose device solves; NULL: the host does */
    uint64_t next_id; /**< with the count it tells whether particles came or went since the last step */
    size_t count;
    double surface_energy; /**< at the last evaluation [J/m] */
    size_t packed; /**< places of the particles are in floats, too, in arrays of this capacity (hybrid.c); 0: not */
    void *block;   /**< all arrays */
    size_t block_size;
} sph2d__grid;

/** The fields of squares that kernels read and write, besides those of levels and solutions. */
/* clang-format off */
#define SPH2D__GRID_FIELDS(X)                                                                                          \
    X(open_x) X(open_y) X(wall_x) X(wall_y) X(room) X(hidden) X(mass) X(excess) X(filled)                              \
    X(u) X(v) X(wet_x) X(wet_y) X(air_x) X(air_y) X(q) X(s)
/* clang-format on */

/** What a kernel that works on the squares of a level gets: fields of it or of the next one, numbers. */
typedef struct sph2d__grid_work {
    SPH2D__ARRAY float *field[4];
    float factor;
    int level, times;
} sph2d__grid_work;

/** The square itself, or that inside which square (i, j) of the ring of a periodic domain stands for. */
static inline size_t sph2d__inside_of(const sph2d__grid *g, const sph2d__level *l, int i, int j)
{
    const int column = !g->wraps_x ? i : i == 0 ? l->nx : i == l->nx + 1 ? 1 : i;
    const int row = !g->wraps_y ? j : j == 0 ? l->ny : j == l->ny + 1 ? 1 : j;
    return (size_t)row * l->stride + (size_t)column;
}

/** Adds what lies beyond one end of a period, along a line of `n` squares `step` apart, to the other end. */
static inline void sph2d__fold(const sph2d__sums *s, size_t into, size_t from)
{
    s->x[into].value += s->x[from].value;
    s->x[into].weight += s->x[from].weight;
    s->y[into].value += s->y[from].value;
    s->y[into].weight += s->y[from].weight;
    s->middle[into] += s->middle[from];
}

static inline void sph2d__fold_line(const sph2d__sums *s, size_t at, int n, size_t step)
{
    const size_t last = at + (size_t)n * step;
    sph2d__fold(s, last, at);                       /* 0 is n */
    sph2d__fold(s, at + step, last + step);         /* n + 1 is 1 */
    sph2d__fold(s, at + 2 * step, last + 2 * step); /* n + 2 is 2 */
    const size_t to[2] = {at, last + step}, from[2] = {last, at + step};
    for (int k = 0; k < 2; ++k) {
        s->x[to[k]] = s->x[from[k]];
        s->y[to[k]] = s->y[from[k]];
        s->middle[to[k]] = s->middle[from[k]];
    }
}

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

#endif
