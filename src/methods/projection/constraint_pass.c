/* SPDX-License-Identifier: MIT */
/** @file constraint_pass.c
 *  The loops of constraint_pass.h, compiled once for each instruction set, named by SPH2D__ISA.
 *
 *  Sums are kept in as many strands as the widest instruction set has lanes, row i in strand i modulo their number, and
 *  added strand by strand: the same bits at any width. Rows behind the last one of a store count as nothing: their
 *  diagonal is 0, which makes them inactive, and so is their direction. */
#include "methods/projection/constraint_pass.h"

#include "simd/lanes.h"

enum { WIDTH = SPH2D__WIDEST / SPH2D__LANES };

/** A sum in strands. */
typedef struct strands {
    sph2d__lanes at[WIDTH];
} strands;

/** Runs the statement behind it for rows i on of a slab, in strands `part` of sums. */
#define FOR_ROWS(slab, i, part)                                                                                        \
    for (size_t block_ = (slab)->first; block_ < (slab)->last; block_ += SPH2D__WIDEST)                                \
        for (size_t part = 0, i = block_; part < WIDTH; ++part, i += SPH2D__LANES)

static double total(const strands *s)
{
    double sum = 0;
    for (int k = 0; k < WIDTH; ++k)
        for (int l = 0; l < SPH2D__LANES; ++l)
            sum += s->at[k][l];
    return sum;
}

static double largest(const strands *s)
{
    double most = 0;
    for (int k = 0; k < WIDTH; ++k)
        for (int l = 0; l < SPH2D__LANES; ++l)
            most = s->at[k][l] > most ? s->at[k][l] : most;
    return most;
}

SPH2D__INLINE sph2d__lanes size_of(sph2d__lanes a)
{
    return sph2d__lanes_max(a, -a);
}

/** What is left of a residual, as compressions: r . r/diagonal, the sum and the largest of its sizes. Of either sign:
 *  where the pressure is too large it must fall. */
typedef struct left {
    strands square, size, most;
} left;

SPH2D__INLINE void add_left(left *to, size_t part, sph2d__lanes r, sph2d__lanes inverse)
{
    sph2d__lanes size = sph2d__lanes_where(inverse, (sph2d__lanes){0}, size_of(r));
    to->square.at[part] += size * size * inverse;
    to->size.at[part] += size;
    to->most.at[part] = sph2d__lanes_max(size, to->most.at[part]);
}

static void put_left(const left *from, sph2d__slab_sum *sum)
{
    sum->first = total(&from->square);
    sum->second = total(&from->size);
    sum->most = largest(&from->most);
}

static void apply(const sph2d__slab *slab, double soft, sph2d__slab_sum *sum)
{
    sph2d__store *t = slab->rows;
    const sph2d__lanes none = {0};
    strands curve = {0}, across = {0}, length = {0};
    FOR_ROWS (slab, i, part) {
        sph2d__lanes way = sph2d__float2_x(sph2d__float2_load(t->direction + i));
        sph2d__lanes product = sph2d__lanes_load(t->product + i) + soft * way;
        sph2d__lanes inverse = sph2d__lanes_max(sph2d__lanes_load(t->diagonal + i), none);
        sph2d__lanes_store(t->product + i, product);
        curve.at[part] += way * product;
        across.at[part] += product * inverse * sph2d__lanes_load(t->residual + i);
        length.at[part] += product * inverse * product;
    }
    sum->first = total(&curve);
    sum->second = total(&across);
    sum->third = total(&length);
}

static void begin(const sph2d__slab *slab, sph2d__slab_sum *sum)
{
    sph2d__store *t = slab->rows;
    const sph2d__lanes none = {0};
    left over = {0};
    FOR_ROWS (slab, i, part) {
        sph2d__lanes inverse = size_of(sph2d__lanes_load(t->diagonal + i)), r = sph2d__lanes_load(t->residual + i);
        sph2d__lanes pushes = sph2d__lanes_max(sph2d__lanes_load(t->multiplier + i), r);
        sph2d__lanes active = sph2d__lanes_where(pushes, none, inverse), way = r * active;
        sph2d__lanes_store(t->diagonal + i, active + active - inverse);
        sph2d__float2_store(t->direction + i, sph2d__float2_of(way, way));
        add_left(&over, part, r, active);
    }
    put_left(&over, sum);
}

static void advance(const sph2d__slab *slab, double length, double keep, sph2d__slab_sum *sum)
{
    sph2d__store *t = slab->rows;
    const sph2d__lanes none = {0};
    left over = {0};
    FOR_ROWS (slab, i, part) {
        sph2d__lanes inverse = sph2d__lanes_load(t->diagonal + i);
        sph2d__lanes way = sph2d__float2_x(sph2d__float2_load(t->direction + i));
        sph2d__lanes r = sph2d__lanes_load(t->residual + i) - length * sph2d__lanes_load(t->product + i);
        sph2d__lanes next = sph2d__lanes_where(inverse, none, inverse * r + keep * way);
        sph2d__lanes_store(t->multiplier + i, sph2d__lanes_load(t->multiplier + i) + length * way);
        sph2d__lanes_store(t->residual + i, r);
        sph2d__float2_store(t->direction + i, sph2d__float2_of(next, next));
        add_left(&over, part, r, inverse);
    }
    put_left(&over, sum);
}

static void clamp(const sph2d__slab *slab, sph2d__slab_sum *sum)
{
    sph2d__store *t = slab->rows;
    const sph2d__lanes none = {0};
    strands cut = {0};
    FOR_ROWS (slab, i, part) {
        sph2d__lanes y = sph2d__lanes_load(t->multiplier + i), below = sph2d__lanes_max(-y, none);
        sph2d__float2 kept = sph2d__float2_of(below, below);
        sph2d__lanes pull = sph2d__float2_x(kept); /* so that the way ends at 0 */
        sph2d__lanes diagonal = size_of(sph2d__lanes_load(t->diagonal + i));
        sph2d__float2_store(t->direction + i, kept);
        sph2d__lanes_store(t->multiplier + i, sph2d__lanes_max(y, none) - pull);
        cut.at[part] += sph2d__lanes_where(pull, none, pull / diagonal);
    }
    sum->second = total(&cut);
}

const sph2d__constraint_passes SPH2D__OF_ISA(sph2d__constraint_passes) = {apply, begin, advance, clamp};
