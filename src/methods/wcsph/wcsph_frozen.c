/* SPDX-License-Identifier: MIT */
/** @file wcsph_frozen.c
 *  What stands still over a step of method `wcsph`: its memory, and how it is set. */
#include <math.h>
#include <string.h>

#include "kernels/kernel.h"
#include "methods/common/on_device.h"
#include "methods/wcsph/wcsph.h"
#include "methods/wcsph/wcsph_spans.h"

/* Lattice sites on either side of a particle. */
enum { REACH = SPH2D__LATTICE_REACH };

/* Steps of the distance from a surface, over H, by which s is found. */
enum { DISTANCES = SPH2D__PLANE_PARTS };

/** Sums of K, Sigma and M over the first row of a lattice and those behind it. */
typedef struct row_sums {
    double value, k, xx, yy;
} row_sums;

static row_sums sum_first_row(const sph2d__system *s)
{
    const double ratio = s->spacing / s->support, scale = sph2d__kernel_constant(s->method.kernel) * ratio * ratio;
    row_sums sum = {0};
    for (int i = -REACH; i <= REACH; ++i)
        for (int j = 0; j <= REACH; ++j) {
            const double x = i * ratio, y = j * ratio, q = sqrt(x * x + y * y);
            const double slope = -scale * sph2d__kernel_slope_at(s->method.kernel, q);
            sum.value += sph2d__kernel_value_at(s->method.kernel, q) / s->lattice_values;
            sum.k += slope * q * y;
            sum.xx += slope * x * x;
            sum.yy += slope * y * y;
        }
    return sum;
}

/** The difference of B's eigenvalues over their sum. */
static double uneven_by(row_sums m)
{
    const double part = fmin(m.xx * m.yy / SPH2D__LEAST, 1), x = part / m.xx + 1 - part, y = part / m.yy + 1 - part;
    return fabs(x - y) / (x + y);
}

/** s by K/Sigma of a liquid below a plane, its lack over the part of the lattice that is beyond a first row as large as
 *  there. */
static void find_left(const sph2d__system *s, sph2d__frozen *z)
{
    const sph2d_kernel kernel = s->method.kernel;
    const double step = 1.0 / DISTANCES, scale = sph2d__kernel_constant(kernel) * step;
    double values[DISTANCES + 1], slopes[DISTANCES + 1], value = 0.5, k = 0, row_left = 1;
    for (int a = 0; a <= DISTANCES; ++a) {
        values[a] = slopes[a] = 0;
        for (int b = -DISTANCES; b <= DISTANCES; ++b) {
            const double q = hypot(a, b) * step;
            values[a] += q < 1 ? scale * sph2d__kernel_value_at(kernel, q) : 0;
            slopes[a] -= q < 1 ? scale * sph2d__kernel_slope_at(kernel, q) * q * a * step : 0;
        }
    }
    const row_sums row = sum_first_row(s);
    const double row_near = row.k / row.value;
    for (int a = DISTANCES; a > 0; --a)
        k += (slopes[a] + slopes[a - 1]) * step / 2;
    z->nearness = k / value;
    z->left[SPH2D__FREE_PARTS] = value;
    int entry = SPH2D__FREE_PARTS - 1;
    for (int a = 1; a <= DISTANCES; ++a) {
        const double before = value, near = k / value;
        value = fmin(value + (values[a] + values[a - 1]) * step / 2, 1);
        k = a < DISTANCES ? fmax(k - (slopes[a] + slopes[a - 1]) * step / 2, 0) : 0;
        const double fall = near - k / value;
        if (near >= row_near && k / value < row_near)
            row_left = before + (value - before) * (near - row_near) / fall;
        for (; entry >= 0 && z->nearness * entry / SPH2D__FREE_PARTS >= k / value; --entry)
            z->left[entry] = before + (value - before) * (near - z->nearness * entry / SPH2D__FREE_PARTS) / fall;
    }
    z->uneven = uneven_by(row);
    for (entry = 0; entry <= SPH2D__FREE_PARTS; ++entry)
        z->left[entry] = 1 - (1 - z->left[entry]) * (1 - row.value) / (1 - row_left);
}

/** What is beyond a plane, and its integral, by trapezia. */
static void find_beyond(const sph2d__system *s, sph2d__frozen *z)
{
    const double step = 1.0 / DISTANCES, scale = sph2d__kernel_constant(s->method.kernel) * step * step;
    double last = 0;
    z->beyond[DISTANCES] = z->lift[DISTANCES] = 0;
    for (int a = DISTANCES - 1; a >= 0; --a) {
        double line = 0;
        for (int b = -DISTANCES; b <= DISTANCES; ++b)
            line += scale * sph2d__kernel_value_at(s->method.kernel, hypot(a, b) * step);
        z->beyond[a] = z->beyond[a + 1] + (line + last) / 2;
        z->lift[a] = z->lift[a + 1] + (z->beyond[a] + z->beyond[a + 1]) / 2 * step * s->support;
        last = line;
    }
}

/* ---- memory ------------------------------------------------------------------------------------------------------ */

#define COUNT_ONE(name) +1
enum {
    ARRAYS = 0 SPH2D__FROZEN_ARRAYS(COUNT_ONE) SPH2D__FROZEN_RECORDS(COUNT_ONE),
    PAIRS = 0 SPH2D__FROZEN_PAIRS(COUNT_ONE),
    SLICES = 3,
    IMPLICIT = 3 SPH2D__IMPLICIT_ARRAYS(COUNT_ONE),
    ALL = ARRAYS + PAIRS + SLICES + IMPLICIT
};

static void list_blocks(sph2d__frozen *z, sph2d__growth out[ALL])
{
    size_t n = 0;
#define BLOCK(name) out[n++] = (sph2d__growth){&z->name, sizeof *z->name};
    SPH2D__FROZEN_ARRAYS(BLOCK)
#undef BLOCK
#define RECORD(name) out[n++] = (sph2d__growth){&z->name, 4 * sizeof *z->name};
    SPH2D__FROZEN_RECORDS(RECORD)
#undef RECORD
#define PAIR(name) out[n++] = (sph2d__growth){&z->name, sizeof *z->name};
    SPH2D__FROZEN_PAIRS(PAIR)
#undef PAIR
    out[n++] = (sph2d__growth){&z->flags, sizeof *z->flags};
    out[n++] = (sph2d__growth){&z->close, sizeof *z->close};
    out[n++] = (sph2d__growth){&z->imaged, sizeof *z->imaged};
#define BLOCK(name) out[n++] = (sph2d__growth){&z->name, sizeof *z->name};
    SPH2D__IMPLICIT_ARRAYS(BLOCK)
#undef BLOCK
    out[n++] = (sph2d__growth){&z->first_close, sizeof *z->first_close};
    out[n++] = (sph2d__growth){&z->end_close, sizeof *z->end_close};
    out[n++] = (sph2d__growth){&z->close_starts, sizeof *z->close_starts};
}

static bool is_implicit(const sph2d__system *s)
{
    return s->method.name == SPH2D_METHOD_CONSTRAINT;
}

/* ---- room -------------------------------------------------------------------------------------------------------- */

/** New arrays are zeros: what has not been set yet is read, times 0. */
static void tell_device(const sph2d__system *s)
{
    const sph2d__frozen *z = s->frozen;
    if (!sph2d__is_on_device(s))
        return;
#define TELL(name) sph2d__host_changed_block(s, z->name);
    SPH2D__FROZEN_ARRAYS(TELL)
    SPH2D__IMPLICIT_ARRAYS(TELL)
    SPH2D__FROZEN_RECORDS(TELL)
#undef TELL
}

/** Makes room for the neighbour lists' pairs and slices, and the particles of the store. */
static bool reserve(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    const size_t slabs = sph2d__slabs(s->neighbours.particles), pairs = slabs * s->neighbours.each * SPH2D__SLAB;
    const size_t slices = slabs * SPH2D__SLAB / SPH2D__NARROWEST, particles = s->fluid.capacity + SPH2D__PADDING;
    sph2d__growth blocks[ALL];
    bool grown = false;
    list_blocks(z, blocks);
    if (particles > z->capacity) {
        if (!sph2d__grow_all(s->memory, blocks, ARRAYS, z->capacity, particles))
            return false;
        z->capacity = particles;
        grown = true;
    }
    if (pairs > z->pairs) {
        if (!sph2d__grow_all(s->memory, blocks + ARRAYS, PAIRS, z->pairs, pairs))
            return false;
        z->pairs = pairs;
    }
    if (slices > z->slices) {
        if (!sph2d__grow_all(s->memory, blocks + ARRAYS + PAIRS, SLICES, z->slices, slices))
            return false;
        z->slices = slices;
    }
    if (is_implicit(s) && particles > z->implicit) {
        if (!sph2d__grow_all(s->memory, blocks + ARRAYS + PAIRS + SLICES, IMPLICIT, z->implicit, particles))
            return false;
        z->implicit = particles;
        grown = true;
    }
    if (grown)
        tell_device(s);
    return true;
}

/** Makes room for the boundary particles. */
static bool reserve_walls(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    const size_t walls = s->walls.capacity + SPH2D__PADDING;
    const sph2d__growth block = {&z->part, sizeof *z->part};
    if (walls > z->walls) {
        if (!sph2d__grow_all(s->memory, &block, 1, z->walls, walls))
            return false;
        z->walls = walls;
        sph2d__wall_parts_find(s);
    }
    return true;
}

/** Hands it to kernels of a device. */
static void place_frozen(const sph2d__system *s, void *copy)
{
    const sph2d__frozen *z = s->frozen;
    sph2d__frozen to = *z;
#define PLACE(name) sph2d__place_block(s, &to.name, z->capacity * sizeof *z->name, SPH2D__OF_FLUID);
    SPH2D__FROZEN_ARRAYS(PLACE)
#undef PLACE
#define PLACE(name) sph2d__place_block(s, &to.name, z->implicit * sizeof *z->name, SPH2D__OF_FLUID);
    SPH2D__IMPLICIT_ARRAYS(PLACE)
    PLACE(first_close)
    PLACE(end_close)
#undef PLACE
    sph2d__place_block(s, &to.close_starts, sph2d__slabs(z->implicit) * sizeof *z->close_starts, SPH2D__OF_SCENE);
    sph2d__place_block(s, &to.close_rows, z->close_capacity * sizeof *z->close_rows, SPH2D__OF_FLUID);
#define PLACE(name) sph2d__place_block(s, &to.name, z->capacity * 4 * sizeof *z->name, SPH2D__OF_FLUID);
    SPH2D__FROZEN_RECORDS(PLACE)
#undef PLACE
#define PLACE(name) sph2d__place_block(s, &to.name, z->pairs * sizeof *z->name, SPH2D__OF_FLUID);
    SPH2D__FROZEN_PAIRS(PLACE)
#undef PLACE
    sph2d__place_block(s, &to.flags, z->slices * sizeof *z->flags, SPH2D__OF_FLUID);
    sph2d__place_block(s, &to.close, z->slices * sizeof *z->close, SPH2D__OF_FLUID);
    sph2d__place_block(s, &to.imaged, z->slices * sizeof *z->imaged, SPH2D__OF_FLUID);
    sph2d__place_block(s, &to.part, z->walls * sizeof *z->part, SPH2D__OF_WALLS);
    sph2d__place_block(s, &to.image_starts, z->image_slabs * sizeof *z->image_starts, SPH2D__OF_SCENE);
    sph2d__place_block(s, &to.left, (SPH2D__FREE_PARTS + 1) * sizeof *z->left, SPH2D__OF_SCENE);
    sph2d__place_block(s, &to.beyond, (SPH2D__PLANE_PARTS + 1) * sizeof *z->beyond, SPH2D__OF_SCENE);
    sph2d__place_block(s, &to.lift, (SPH2D__PLANE_PARTS + 1) * sizeof *z->lift, SPH2D__OF_SCENE);
    sph2d__place_store(s, &to.images, SPH2D__OF_FLUID);
    sph2d__place_cells(s, &to.image_cells, SPH2D__OF_FLUID);
    memcpy(copy, &to, sizeof to);
}

static const void *frozen_of(const sph2d__system *s)
{
    return s->frozen;
}

static const struct sph2d__extra frozen_extra = {sizeof(sph2d__frozen), frozen_of, place_frozen};

/* Entries of s, of what is beyond a plane, and of its integral. */
enum { TABLES = SPH2D__FREE_PARTS + 1 + 2 * (SPH2D__PLANE_PARTS + 1) };

bool sph2d__frozen_start(sph2d__system *s, const sph2d__sides *sides)
{
    s->frozen = sph2d__alloc(s->memory, 1, sizeof *s->frozen);
    if (!s->frozen)
        return false;
    s->frozen->left = sph2d__alloc(s->memory, TABLES, sizeof(double));
    if (!s->frozen->left) {
        sph2d__frozen_free(s);
        return false;
    }
    s->extra = &frozen_extra;
    s->frozen->beyond = s->frozen->left + SPH2D__FREE_PARTS + 1;
    s->frozen->lift = s->frozen->beyond + SPH2D__PLANE_PARTS + 1;
    s->frozen->sides = *sides;
    find_left(s, s->frozen);
    find_beyond(s, s->frozen);
    return true;
}

void sph2d__frozen_free(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    if (!z)
        return;
    sph2d__growth blocks[ALL];
    list_blocks(z, blocks);
    for (size_t k = 0; k < ALL; ++k)
        sph2d__release(s->memory, blocks[k].slot,
                       k < ARRAYS                    ? z->capacity
                       : k < ARRAYS + PAIRS          ? z->pairs
                       : k < ARRAYS + PAIRS + SLICES ? z->slices
                                                     : z->implicit,
                       blocks[k].size);
    sph2d__frozen_bodies_free(s);
    sph2d__close_free(s);
    void *starts = z->image_starts;
    sph2d__release(s->memory, &starts, z->image_slabs, sizeof *z->image_starts);
    void *of_walls = z->part, *tables = z->left, *all = z;
    sph2d__release(s->memory, &tables, tables ? TABLES : 0, sizeof(double));
    sph2d__release(s->memory, &of_walls, z->walls, sizeof *z->part);
    sph2d__store_free(&z->images, s->memory);
    sph2d__cells_free(&z->image_cells, s->memory);
    sph2d__release(s->memory, &all, 1, sizeof *z);
    s->frozen = NULL;
}

/* ---- what stands still ------------------------------------------------------------------------------------------- */

/** Puts the particles that shorter lists end with where no kernel reaches, with values that are numbers. */
static void end_store(const sph2d__store *t)
{
    const size_t end = t->count + SPH2D__WIDEST - t->count % SPH2D__WIDEST;
    for (size_t i = t->count; i < end && t->capacity > 0; ++i)
        t->x[i] = t->y[i] = 1e30;
}

static void end_rows(sph2d__system *s)
{
    const sph2d__store *f = &s->fluid;
    sph2d__frozen *z = s->frozen;
    end_store(f);
    if (s->walls.capacity > 0) {
        end_store(&s->walls);
        s->walls.mass[s->walls.count] = 0;
    }
    if (f->capacity == 0)
        return;
    const size_t end = f->count + SPH2D__WIDEST - f->count % SPH2D__WIDEST;
    for (size_t i = f->count; i < end; ++i) {
        f->vx[i] = f->vy[i] = f->log_density[i] = 0;
#define ZERO(name) z->name[i] = 0;
        SPH2D__FROZEN_ARRAYS(ZERO)
#undef ZERO
#define ZERO(name) memset(z->name + 4 * i, 0, 4 * sizeof *z->name);
        SPH2D__FROZEN_RECORDS(ZERO)
#undef ZERO
        z->px[i] = z->py[i] = f->next_x[i] = f->next_y[i] = 1e30;
#define ZERO(name) z->name[i] = 0;
        if (is_implicit(s)) {
            SPH2D__IMPLICIT_ARRAYS(ZERO)
        }
#undef ZERO
    }
}

/* By how much particles may become faster during a step. */
static const double MARGIN = 1.5;
/* Particles of a close pair that come nearer by more than this, over dx, are none in the middle of the step. */
static const double MOST_APART = 0.8;

static void gather_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    sum->most = !sph2d__wcsph_gather_find(s->isa)->gather[s->method.kernel](s, slab->first / SPH2D__SLAB);
}

static void see_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    (void)sum;
    sph2d__wcsph_gather_find(s->isa)->see(s, slab->first / SPH2D__SLAB);
}

/* An acoustic step over H/c0, by which C is bounded where a step has none. */
static const double ACOUSTIC = 0.2;

/* R in an implicit step, over rho0 c0^2 dx and max_compression: four times the head that the sound speed is made for, so
 * that a pair at r0/2 bears the pressure of it. What pressure drives together within a step takes no work for its energy. */
static const double BEARS_HEAD = 2;

bool sph2d__frozen_gather(sph2d__system *s)
{
    const sph2d__wcsph_gather_pass *pass = sph2d__wcsph_gather_find(s->isa);
    const double ratio = s->support / s->spacing;
    size_t each = (size_t)(2 * SPH2D__PI * ratio * ratio) + 8; /* with walls, and half as many again for disorder */
    if (!reserve_walls(s) || !sph2d__images_place(s))
        return false;
    for (;; each = 2 * s->neighbours.each) {
        if (!sph2d__neighbours_reserve(&s->neighbours, s->memory, s->fluid.count, each, false) || !reserve(s))
            return false;
        s->neighbours.lanes = sph2d__is_on_device(s) ? SPH2D__NARROWEST : pass->lanes;
        s->neighbours.stride = sph2d__is_on_device(s) ? SPH2D__DEVICE_STRIDE : pass->lanes;
        s->frozen->apart = SPH2D__CLOSE * s->spacing + fmin(MARGIN * s->speed * s->step, MOST_APART * s->spacing);
        if (!sph2d__is_on_device(s)) /* its lists have no ends that stand for nothing */
            end_rows(s);
        sph2d__over_particles(s, s->fluid.count, keep_state, "keep_state_pass");
        sph2d__images_start(s);
        s->frozen->thin = s->walls_press && s->frozen->sides.first > 0;
        if (s->frozen->thin) {
            sph2d__over_fluid(s, see_slab, NULL, "see_pass", 0);
            sph2d__images_of_sight(s);
        }
        if (sph2d__over_fluid(s, gather_slab, NULL, "gather_pass", 0).most == 0)
            break;
    }
    sph2d__images_of_slopes(s);
    sph2d__over_particles(s, s->fluid.count, pass->compare, "compare_pass");
    s->frozen->dt =
        is_implicit(s) ? ACOUSTIC * s->support / s->sound_speed : s->step / (double)sph2d__acoustic_steps(s, s->step);
    s->frozen->most_brake = 1;
    s->frozen->repulsion =
        is_implicit(s) ? fmin(BEARS_HEAD * s->method.max_compression, SPH2D__REPULSION) : SPH2D__REPULSION;
    sph2d__over_particles(s, s->fluid.count, bound_some, "bound_pass");
    return !is_implicit(s) || sph2d__close_reserve(s);
}
