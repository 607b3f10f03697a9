/* SPDX-License-Identifier: MIT */
/** @file variational.c
 *  Method `wcsph` with variational operators: setup, what stands still over a step, wall forces. */
#include "methods/variational/variational.h"

#include <math.h>

#include "kernels/kernel.h"

/* Lattice sites on either side of a particle. */
enum { REACH = 6 };

/** Sets the sums over a full lattice: of f(q); of |G|, as lattice_slopes; and the weight of viscosity, of |G| r^2. Of
 *  forces along the lines between particles that go with w |G|, an eighth of half the second moment is shear. */
static void prepare(sph2d__system *s)
{
    const double h2 = s->support * s->support, dx = s->spacing;
    const double scale = s->mass / s->rest_density * sph2d__kernel_constant(s->method.kernel) / (h2 * h2);
    double values = 0, slopes = 0, squares = 0;
    for (int i = -REACH; i <= REACH; ++i)
        for (int j = -REACH; j <= REACH; ++j) {
            const double r = hypot(i, j) * dx,
                         g = -scale * r * sph2d__kernel_slope_at(s->method.kernel, r / s->support);
            values += sph2d__kernel_value_at(s->method.kernel, r / s->support);
            slopes += g;
            squares += g * r * r;
        }
    s->lattice_values = values;
    s->lattice_slopes = slopes;
    s->central_weight = 16 / squares;
}

/* ---- memory ------------------------------------------------------------------------------------------------------ */

#define COUNT_ONE(name) +1
enum { ARRAYS = 0 SPH2D__FROZEN_ARRAYS(COUNT_ONE), ALL = ARRAYS + 4 };

static void list_blocks(sph2d__frozen *z, sph2d__growth out[ALL])
{
    size_t n = 0;
#define BLOCK(name) out[n++] = (sph2d__growth){&z->name, sizeof *z->name};
    SPH2D__FROZEN_ARRAYS(BLOCK)
#undef BLOCK
    out[n++] = (sph2d__growth){&z->linear, sizeof *z->linear};
    out[n++] = (sph2d__growth){&z->inverse, sizeof *z->inverse};
    out[n++] = (sph2d__growth){&z->flags, sizeof *z->flags};
    out[n++] = (sph2d__growth){&z->close, sizeof *z->close};
}

/* ---- wet walls --------------------------------------------------------------------------------------------------- */

/* Support radius of the kernel by which liquid is looked for at a boundary particle's image in the liquid, over dx; the
 * parts of the room there that liquid fills from which on, and up to which, a boundary particle acts. */
static const double WET_SUPPORT = 2, WET_FROM = 0.3, WET_TO = 0.7;

/** The image of boundary particle b in the liquid. */
static sph2d_vec2 image_of(const sph2d__system *s, size_t b)
{
    const sph2d__store *w = &s->walls;
    return (sph2d_vec2){w->x[b] + 2 * w->depth[b] * w->normal_x[b], w->y[b] + 2 * w->depth[b] * w->normal_y[b]};
}

/** Area by the kernel of what is around (x, y), particles of one store with the mass that is given or their own. */
static double area_at(const sph2d__system *s, const sph2d__store *t, const sph2d__cells *cells, const double *mass,
                      sph2d_vec2 at)
{
    const double h = WET_SUPPORT * s->spacing;
    const double scale = sph2d__kernel_constant(s->method.kernel) / (h * h * s->rest_density);
    const uint32_t cell = sph2d__cells_find(cells, at.x, at.y);
    if (cell == UINT32_MAX)
        return 0;
    double sum = 0;
    sph2d__ranges ranges;
    sph2d__cells_ranges(cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
        const double dx = at.x + ranges.x[r] - t->x[j], dy = at.y + ranges.y[r] - t->y[j], r2 = dx * dx + dy * dy;
        if (r2 < h * h)
            sum += scale * (mass ? mass[j] : s->mass) * sph2d__kernel_value_at(s->method.kernel, sqrt(r2) / h);
    }
    return sum;
}

/** Whether the wall before boundary particle b has a direction: in corners it has none. */
static bool is_flat(const sph2d__store *w, size_t b)
{
    return w->depth[b] > 0 && w->depth[b] < INFINITY;
}

static void find_room(sph2d__system *s)
{
    const sph2d__store *w = &s->walls;
    for (size_t b = 0; b < w->count; ++b)
        s->frozen->room[b] = is_flat(w, b) ? fmax(1 - area_at(s, w, &s->wall_cells, w->mass, image_of(s, b)), 0.1) : 1;
}

static void wet_some(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *w = &s->walls;
    for (size_t b = first; b < last; ++b) {
        if (!is_flat(w, b)) {
            s->frozen->wet[b] = 1;
            continue;
        }
        const double filled = area_at(s, &s->fluid, &s->fluid_cells, NULL, image_of(s, b)) / s->frozen->room[b];
        const double part = fmax(fmin((filled - WET_FROM) / (WET_TO - WET_FROM), 1), 0);
        s->frozen->wet[b] = part * part * (3 - 2 * part);
    }
}

/** When walls have moved. */
static void walls_placed(sph2d__system *s)
{
    if (s->frozen)
        find_room(s);
}

/* ---- room -------------------------------------------------------------------------------------------------------- */

/** Makes room for the neighbour lists' pairs and slices, and the particles of the store. */
static bool reserve(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    const size_t slabs = sph2d__slabs(s->neighbours.particles), pairs = slabs * s->neighbours.each * SPH2D__SLAB;
    const size_t slices = slabs * SPH2D__SLAB / SPH2D__NARROWEST, particles = s->fluid.capacity + SPH2D__PADDING;
    sph2d__growth blocks[ALL];
    list_blocks(z, blocks);
    if (particles > z->capacity) {
        if (!sph2d__grow_all(s->memory, blocks, ARRAYS, z->capacity, particles))
            return false;
        z->capacity = particles;
    }
    if (pairs > z->pairs) {
        if (!sph2d__grow_all(s->memory, blocks + ARRAYS, 2, z->pairs, pairs))
            return false;
        z->pairs = pairs;
    }
    if (slices > z->slices) {
        if (!sph2d__grow_all(s->memory, blocks + ARRAYS + 2, 2, z->slices, slices))
            return false;
        z->slices = slices;
    }
    return true;
}

/** Makes room for the boundary particles. */
static bool reserve_walls(sph2d__system *s)
{
    if (!s->frozen)
        s->frozen = sph2d__alloc(s->memory, 1, sizeof *s->frozen);
    sph2d__frozen *z = s->frozen;
    if (!z)
        return false;
    const size_t walls = s->walls.capacity + SPH2D__PADDING;
    const sph2d__growth blocks[] = {{&z->wet, sizeof *z->wet}, {&z->room, sizeof *z->room}};
    if (walls > z->walls) {
        if (!sph2d__grow_all(s->memory, blocks, 2, z->walls, walls))
            return false;
        z->walls = walls;
        find_room(s);
    }
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
                       k < ARRAYS       ? z->capacity
                       : k < ARRAYS + 2 ? z->pairs
                                        : z->slices,
                       blocks[k].size);
    void *of_walls[] = {z->wet, z->room}, *all = z;
    for (int k = 0; k < 2; ++k)
        sph2d__release(s->memory, &of_walls[k], z->walls, sizeof(double));
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
        f->vx[i] = f->vy[i] = f->excess[i] = 0;
#define ZERO(name) z->name[i] = 0;
        SPH2D__FROZEN_ARRAYS(ZERO)
#undef ZERO
        z->px[i] = z->py[i] = 1e30;
    }
}

/* By how much particles may become faster during a step. */
static const double MARGIN = 1.5;

static void gather_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    sum->most = !sph2d__variational_gather_find(s->isa)->gather[s->method.kernel](s, slab->first / SPH2D__SLAB);
}

bool sph2d__frozen_gather(sph2d__system *s)
{
    const sph2d__variational_gather_pass *pass = sph2d__variational_gather_find(s->isa);
    const double ratio = s->support / s->spacing;
    size_t each = (size_t)(2 * SPH2D__PI * ratio * ratio) + 8; /* with walls, and half as many again for disorder */
    if (!reserve_walls(s))
        return false;
    sph2d__over_particles(s, s->walls.count, wet_some);
    for (;; each = 2 * s->neighbours.each) {
        if (!sph2d__neighbours_reserve(&s->neighbours, s->memory, s->fluid.count, each) || !reserve(s))
            return false;
        s->neighbours.lanes = pass->lanes;
        s->frozen->apart = SPH2D__CLOSE * s->spacing + MARGIN * s->speed * s->step;
        end_rows(s);
        if (sph2d__over_fluid(s, gather_slab, NULL).most == 0)
            break;
    }
    sph2d__over_particles(s, s->fluid.count, pass->compare);
    return true;
}

/* ---- the method -------------------------------------------------------------------------------------------------- */

/** The logarithm of a ratio of densities, by Newton's method. */
static double log_density(double ratio)
{
    double theta = ratio - 1;
    for (int k = 0; k < 8; ++k)
        theta += ratio / sph2d__density_ratio(theta) - 1;
    return theta;
}

static void start(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        f->excess[i] = log_density(f->density[i] / s->rest_density);
        f->pressure[i] = f->density[i] * s->sound_speed * s->sound_speed * f->excess[i];
        f->ax[i] = f->ay[i] = 0;
        sph2d__body_add(&s->body, f->x[i], f->y[i], f->vx[i], f->vy[i], &f->ax[i], &f->ay[i]);
    }
}

/** At the start: forces are those of a step. */
static bool evaluate(sph2d__system *s)
{
    sph2d__over_particles(s, s->fluid.count, start);
    return true;
}

static double elastic(const sph2d__system *s, size_t i, bool stepped)
{
    (void)stepped;
    return s->sound_speed * s->sound_speed * s->fluid.excess[i] * s->fluid.excess[i] / 2;
}

/** By the means over the step, at the places of its middle. */
static sph2d__wall_force wall_force(const sph2d__system *s, size_t i, size_t b, double dx, double dy)
{
    const sph2d__frozen *z = s->frozen;
    const double h2 = s->support * s->support;
    const double weight =
        s->frozen->wet[b] * s->walls.mass[b] / s->rest_density * sph2d__kernel_constant(s->method.kernel) / (h2 * h2);
    const double slope = weight * sph2d__kernel_slope_at(s->method.kernel, sqrt(dx * dx + dy * dy) / s->support);
    const sph2d__store *w = &s->walls;
    volatile float gx = (float)(slope * dx), gy = (float)(slope * dy); /* as rounded as they act */
    const double x = (double)gx, y = (double)gy;
    const double ax = z->bxx[i] * x + z->bxy[i] * y, ay = z->bxy[i] * x + z->byy[i] * y;
    const double along = ax * w->normal_x[b] + ay * w->normal_y[b], pull = z->mean_ex[i] * dx + z->mean_ey[i] * dy;
    const bool flat = is_flat(w, b);
    const double nx = flat ? along * w->normal_x[b] : ax, ny = flat ? along * w->normal_y[b] : ay;
    return (sph2d__wall_force){.pressure = {pull * ax - z->mean_work[i] * nx, pull * ay - z->mean_work[i] * ny}};
}

/* Acoustic steps in a step, at most. */
enum { MOST_STEPS = 5 };
/* Way of the fastest particle in a step, over H. */
static const double WAY = 0.125;

/* Part of the longest acoustic step that is stable with viscosity: of 1 over half the largest rate in a lattice. */
static const double VISCOUS = 0.5;

/** The longest acoustic step, and what limits it. */
static double acoustic_step(const sph2d__system *s, double speed, sph2d__limit *limit)
{
    const double sound = s->method.cfl * s->support / (s->sound_speed + speed);
    const double rate = s->viscosity / s->rest_density * s->central_weight * s->lattice_slopes;
    *limit = rate * sound > VISCOUS ? SPH2D__LIMIT_VISCOUS : SPH2D__LIMIT_ACOUSTIC;
    return rate * sound > VISCOUS ? VISCOUS / rate : sound;
}

size_t sph2d__acoustic_steps(const sph2d__system *s, double dt)
{
    sph2d__limit limit;
    return (size_t)fmax(1, ceil(dt / acoustic_step(s, s->speed, &limit) * (1 - 1e-12)));
}

static double stable_step(const sph2d__system *s, double speed, double acceleration, sph2d__limit *limit)
{
    const double step = acoustic_step(s, speed, limit);
    const double steps = speed > 0 ? floor(WAY * s->support / (speed * step)) : MOST_STEPS;
    (void)acceleration;
    return step * fmax(1, fmin(steps, MOST_STEPS));
}

const sph2d__method sph2d__wcsph_variational = {
    .name = "wcsph",
    .step = sph2d__variational_step,
    .fluid = SPH2D__STORE_BASIC | SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(density) | SPH2D__BIT(pressure) |
             SPH2D__BIT(excess) | SPH2D__BIT(next_x) | SPH2D__BIT(next_y),
    .carried = SPH2D__STORE_BASIC | SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(density) | SPH2D__BIT(pressure) |
               SPH2D__BIT(excess) | SPH2D__BIT(next_x) | SPH2D__BIT(next_y),
    .walls = SPH2D__STORE_BASIC | SPH2D__BIT(normal_x) | SPH2D__BIT(normal_y) | SPH2D__BIT(ax) | SPH2D__BIT(ay) |
             SPH2D__BIT(start_x) | SPH2D__BIT(start_y) | SPH2D__BIT(mass) | SPH2D__BIT(bounce) | SPH2D__BIT(density) |
             SPH2D__BIT(pressure) | SPH2D__BIT(depth),
    .prepare = prepare,
    .evaluate = evaluate,
    .elastic = elastic,
    .walls_placed = walls_placed,
    .wall_force = wall_force,
    .books_all = true,
    .mean_forces = true,
    .stable_step = stable_step,
};
