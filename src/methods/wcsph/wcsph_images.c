/* SPDX-License-Identifier: MIT */
/** @file wcsph_images.c
 *  Sides of the domain that mirror the liquid (wcsph.h): images of what is near them, behind the particles in all
 *  arrays, and what is left of boundary particles there. */
#include <math.h>
#include <string.h>

#include "kernels/kernel.h"
#include "methods/common/on_device.h"
#include "methods/wcsph/wcsph.h"
#include "methods/wcsph/wcsph_mirror.h"
#include "sim/device_steps.h"

/* ---- sides ------------------------------------------------------------------------------------------------------- */

/* Support radius of the kernel by which obstacles are looked for at the image of a boundary particle, over dx. */
static const double LOOK_SUPPORT = 2;

static bool is_beyond(const sph2d__sides *d, double x, double y)
{
    return x < d->low_x || x > d->high_x || y < d->low_y || y > d->high_y;
}

/** How much of a boundary particle beyond a side acts: as much as there are obstacles at its image, since the liquid's
 *  images stand for the rest. */
static double behind_side(const sph2d__system *s, size_t b)
{
    const sph2d__store *w = &s->walls;
    const sph2d__sides *d = &s->frozen->sides;
    if (w->id[b] < d->first)
        return 0; /* an obstacle's, which no liquid sees */
    const int beyond = (w->x[b] < d->low_x ? LOW_X : 0) | (w->x[b] > d->high_x ? HIGH_X : 0) |
                       (w->y[b] < d->low_y ? LOW_Y : 0) | (w->y[b] > d->high_y ? HIGH_Y : 0);
    const sph2d_vec2 at = mirrored(d, beyond, (sph2d_vec2){w->x[b], w->y[b]});
    const double h = LOOK_SUPPORT * s->spacing;
    const double scale = sph2d__kernel_constant(s->method.kernel) / (h * h * s->rest_density);
    const uint32_t cell = sph2d__cells_find(&s->wall_cells, at.x, at.y);
    double of[2] = {0, 0}; /* area of obstacles, of sides */
    sph2d__ranges ranges = {0};
    if (cell != UINT32_MAX)
        sph2d__cells_ranges(&s->wall_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
        const double dx = at.x + ranges.x[r] - w->x[j], dy = at.y + ranges.y[r] - w->y[j], r2 = dx * dx + dy * dy;
        if (r2 < h * h)
            of[is_beyond(d, w->x[j], w->y[j])] +=
                scale * w->mass[j] * sph2d__kernel_value_at(s->method.kernel, sqrt(r2) / h);
    }
    return fmin(of[0] / fmax(1 - of[1], 0.1), 1);
}

void sph2d__wall_parts_find(sph2d__system *s)
{
    const sph2d__store *w = &s->walls;
    const sph2d__sides *d = &s->frozen->sides;
    for (size_t b = 0; b < w->count; ++b)
        s->frozen->part[b] = is_beyond(d, w->x[b], w->y[b]) ? behind_side(s, b) : 1;
    if (sph2d__is_on_device(s))
        sph2d__host_changed_block(s, s->frozen->part);
}

/* ---- images ------------------------------------------------------------------------------------------------------ */

/** Lists them, particle by particle. */
static bool list_images(sph2d__system *s)
{
    sph2d__store *f = &s->fluid, *t = &s->frozen->images;
    t->count = 0;
    for (size_t i = 0; i < f->count; ++i) {
        int in[MOST_IMAGES];
        const int count = images_of(s, i, in);
        if (count > 0 && t->count + MOST_IMAGES > t->capacity && !sph2d__store_reserve(t, s->memory, 2 * t->count + 64))
            return false;
        for (int k = 0; k < count; ++k) {
            const sph2d_vec2 at = mirrored(&s->frozen->sides, in[k], (sph2d_vec2){f->x[i], f->y[i]});
            sph2d__store_add(t, i * IMAGE_SIDES + (size_t)in[k], at.x, at.y);
        }
    }
    return true;
}

/** The same by a device: how many each slab has, where those of each begin, and then where they are. */
static bool list_on_device(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *t = &z->images;
    const size_t slabs = sph2d__slabs(s->fluid.count);
    const uint32_t *counts = sph2d__device_read_by(s, "count_images", NULL, 0, sizeof *counts);
    const sph2d__growth block = {&z->image_starts, sizeof *z->image_starts};
    if (!counts || (slabs > z->image_slabs && !sph2d__grow_all(s->memory, &block, 1, z->image_slabs, slabs)))
        return false;
    z->image_slabs = slabs > z->image_slabs ? slabs : z->image_slabs;
    t->count = 0;
    for (size_t k = 0; k < slabs; ++k) {
        z->image_starts[k] = (uint32_t)t->count;
        t->count += counts[k];
    }
    if (t->count > t->capacity && !sph2d__store_reserve(t, s->memory, t->count + t->count / 2))
        return false;
    sph2d__host_changed_block(s, z->image_starts);
    if (t->count > 0)
        sph2d__device_span(s, "list_images", s->fluid.count);
    return true;
}

/** Sorts them into their cells. */
static bool sort_images(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    z->image_cells.period = s->fluid_cells.period;
    z->image_cells.columns = s->fluid_cells.columns;
    if (!sph2d__is_on_device(s))
        return sph2d__cells_build(&z->image_cells, &z->images, s->reach, s->memory);
    sph2d__system view = *s;
    view.whole = s;
    view.fluid = z->images;
    view.fluid_cells = z->image_cells;
    const bool sorted = sph2d__device_sort(&view);
    z->images = view.fluid;
    z->image_cells = view.fluid_cells;
    return sorted;
}

bool sph2d__images_place(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *f = &s->fluid, *t = &z->images;
    t->has = t->carried = SPH2D__STORE_BASIC;
    if (!(sph2d__is_on_device(s) ? list_on_device(s) : list_images(s)))
        return false;
    z->first_image = f->count + 2 * SPH2D__WIDEST;
    return t->count == 0 || (sort_images(s) && sph2d__fluid_reserve(s, z->first_image + t->count + SPH2D__WIDEST));
}

size_t sph2d__image_of(const sph2d__frozen *frozen, size_t k)
{
    return (size_t)frozen->images.id[k] / IMAGE_SIDES;
}

double sph2d__side_energy(const sph2d__system *s, double x, double y)
{
    return side_energy(s, x, y);
}

void sph2d__images_start(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *f = &s->fluid;
    sph2d__over_particles(s, f->count, turn_some, "turn_pass");
    sph2d__over_particles(s, z->images.count, start_of, "start_of_images");
    if (sph2d__is_on_device(s)) /* its lists have no ends that stand for nothing */
        return;
    const size_t end = z->first_image + z->images.count;
    if (z->images.count > 0) {
        f->x[end] = f->y[end] = 1e30;
        f->vx[end] = f->vy[end] = f->log_density[end] = 0;
#define ZERO_END(name) z->name[end] = 0;
        SPH2D__FROZEN_ARRAYS(ZERO_END)
#undef ZERO_END
#define ZERO_END(name) memset(z->name + 4 * end, 0, 4 * sizeof *z->name);
        SPH2D__FROZEN_RECORDS(ZERO_END)
#undef ZERO_END
        z->px[end] = z->py[end] = 1e30;
    }
}

void sph2d__images_of_sight(sph2d__system *s)
{
    sph2d__over_particles(s, s->frozen->images.count, sight_of, "sight_of_images");
}
void sph2d__images_of_slopes(sph2d__system *s)
{
    sph2d__over_particles(s, s->frozen->images.count, slopes_of, "slopes_of_images");
}
void sph2d__images_of_velocity(sph2d__system *s)
{
    sph2d__over_particles(s, s->frozen->images.count, velocity_of, "velocity_of_images");
}
void sph2d__images_of_pressure(sph2d__system *s)
{
    sph2d__over_particles(s, s->frozen->images.count, pressure_of, "pressure_of_images");
}
void sph2d__images_of_rest(sph2d__system *s)
{
    sph2d__over_particles(s, s->frozen->images.count, rest_of, "rest_of_images");
}
