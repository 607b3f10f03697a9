/* SPDX-License-Identifier: MIT */
/** @file variants.h
 *  Ways to go through the pairs of particles, timed beside each other: what they share.
 *
 *  Every way computes the same three sums of the same particles, of which a brute-force loop says what they should be.
 *  A way is what is made beforehand, timed by itself because it may serve several steps, and the loop over pairs. */
#ifndef SPH2D_TESTS_BENCH_VARIANTS_H
#define SPH2D_TESTS_BENCH_VARIANTS_H

#include "particles/cells.h"

/** A particle's numbers side by side: one line of a cache. */
typedef struct block {
    double x, y, vx, vy, density, pressure, volume;
    uint64_t id;
} block;

/** Rectangles over the particles, with two empty ones on each side. */
typedef struct grid {
    double origin_x, origin_y, inverse_x, inverse_y;
    uint32_t nx, ny;
} grid;

/** The numbers of the scene. Domain and particles are such that padding, at the origin, is far from all of them. */
typedef struct scene {
    double spacing, support, mass, rest_density, sound_speed;
    double diffusion; /**< what V_j (rho_i - rho_j) is multiplied by to stand beside v_ij . r_ij */
    double viscosity; /**< dynamic, of Monaghan's form [Pa s] */
    double scale;     /**< C/H^4 of the kernel */
    double drift;     /**< how far a particle may move in a step [m] */
} scene;

/** Arrays of numbers that grow. */
typedef struct numbers {
    uint32_t *at;
    size_t capacity;
} numbers;

typedef struct field {
    scene scene;
    sph2d__memory memory;
    sph2d__store store;
    sph2d__cells cells;
    grid grid;
    numbers start, key, order;    /**< of particles sorted by key */
    numbers head, next;           /**< of linked lists */
    numbers list_begin, list;     /**< of lists of neighbours, or of those near a group */
    numbers group_first;          /**< of the groups that have lists */
    numbers spread_x, spread_y;   /**< parts of Morton's number of a column, and of a row */
    double *sorted;               /**< coordinates in the new order */
    block *blocks, *other_blocks; /**< a row of these, and where the next sorting writes */
    size_t group_count;
} field;

/** A way through the pairs. */
typedef struct variant {
    const char *name;
    void (*prepare)(field *f, const struct variant *v); /**< sorts, and makes lists */
    void (*pass)(field *f, const struct variant *v);    /**< density_rate, ax, ay of every particle */
    int steps;                                          /**< that one preparation serves; 0 means 1 */
    double cell;                                        /**< size of cells, in support radii; 0 means 1 */
    uint32_t columns;                                   /**< into which a row's cells are cut; 0 means 1 */
    bool mixed;                                         /**< particles lie in memory in no order at all */
    bool packed;                                        /**< particles are blocks: copied before and after, untimed */
} variant;

/** Ways of a file, compiled for each instruction set; a name of NULL ends them. */
#define VARIANTS_NAME_(file, isa) variants_##file##_##isa
#define VARIANTS_NAME(file, isa) VARIANTS_NAME_(file, isa)
#define VARIANTS_OF(file) VARIANTS_NAME(file, SPH2D__ISA)
#define VARIANTS_FILES(X, isa)                                                                                         \
    X(groups, isa) X(linked, isa) X(blocks, isa) X(strips, isa) X(lists, isa) X(newton, isa) X(morton, isa)
#define VARIANTS_DECLARE(file, isa) extern const variant VARIANTS_NAME(file, isa)[];
VARIANTS_FILES(VARIANTS_DECLARE, baseline)
VARIANTS_FILES(VARIANTS_DECLARE, avx2)
VARIANTS_FILES(VARIANTS_DECLARE, avx512)

static inline int steps_of(const variant *v)
{
    return v->steps > 0 ? v->steps : 1;
}

/** How far two particles may have come nearer since the preparation when it serves the last time: it was made at the
 *  first of its steps. */
static inline double skin_of(const field *f, const variant *v)
{
    return 2 * f->scene.drift * (steps_of(v) - 1);
}

/* ---- field.c: the particles -------------------------------------------------------------------------------------- */

/** About so many particles on a lattice, from which each has walked at random. */
void field_create(field *f, double particles);
void field_free(field *f);

/** Puts the particles back where they were first, in the order of the lattice or in none. */
void field_restart(field *f, bool mixed);
/** Moves the particles as in so many steps. */
void field_move(field *f, int steps);
/** Pressure and volume, which follow from density. */
void field_derive(field *f);
/** Copies the particles into blocks, and back. */
void field_pack(field *f);
void field_unpack(field *f);

/** The largest difference of a sum from that of a loop over all particles, over the largest of its kind. */
double field_error(const field *f);

/** Room for so many numbers; what was there is lost. Ends the program when memory is short. */
uint32_t *numbers_reserve(numbers *n, size_t count);

/* ---- sort.c: orders that the library has not --------------------------------------------------------------------- */

/** Lays rectangles over the particles. */
void grid_lay(field *f, double width, double height);

static inline uint32_t grid_column(const grid *g, double x)
{
    return (uint32_t)((x - g->origin_x) * g->inverse_x);
}
static inline uint32_t grid_row(const grid *g, double y)
{
    return (uint32_t)((y - g->origin_y) * g->inverse_y);
}

/** Finds an order of the particles by key[], whose values are below `keys`; start[] says where each begins. */
void sort_by_key(field *f, size_t keys);

/** The library's own sorting, into cells of `support`. */
void sort_in_cells(field *f, double support, uint32_t columns);

/** Ways to sort, as preparations. */
void prepare_cells(field *f, const variant *v);
void prepare_linked(field *f, const variant *v);
void prepare_strips(field *f, const variant *v);
void prepare_morton(field *f, const variant *v);
void prepare_packed(field *f, const variant *v);

#endif
