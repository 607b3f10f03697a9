/* SPDX-License-Identifier: MIT */
/** @file wcsph_images.c
 *  Sides of the domain that mirror the liquid (wcsph.h): images of what is near them, behind the particles in all
 *  arrays, and what is left of boundary particles there. */
#include <math.h>
#include <string.h>

#include "kernels/kernel.h"
#include "methods/wcsph/wcsph.h"

/* ---- sides ------------------------------------------------------------------------------------------------------- */

enum { LOW_X = 1, HIGH_X = 2, LOW_Y = 4, HIGH_Y = 8, IMAGE_SIDES = 16 };

/** The sides of which (x, y) is nearer than the support. */
static int sides_near(const sph2d__system *s, double x, double y)
{
    const sph2d__sides *d = &s->frozen->sides;
    return (x - d->low_x < s->support ? LOW_X : 0) | (d->high_x - x < s->support ? HIGH_X : 0) |
           (y - d->low_y < s->support ? LOW_Y : 0) | (d->high_y - y < s->support ? HIGH_Y : 0);
}

static sph2d_vec2 mirrored(const sph2d__sides *d, int in, sph2d_vec2 p)
{
    return (sph2d_vec2){in & LOW_X    ? 2 * d->low_x - p.x
                        : in & HIGH_X ? 2 * d->high_x - p.x
                                      : p.x,
                        in & LOW_Y    ? 2 * d->low_y - p.y
                        : in & HIGH_Y ? 2 * d->high_y - p.y
                                      : p.y};
}

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
}

/* ---- images ------------------------------------------------------------------------------------------------------ */

bool sph2d__images_place(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *f = &s->fluid, *t = &z->images;
    t->has = t->carried = SPH2D__STORE_BASIC;
    t->count = 0;
    for (size_t i = 0; i < f->count; ++i) {
        const int near = sides_near(s, f->x[i], f->y[i]);
        if (near == 0)
            continue;
        if (t->count + 8 > t->capacity && !sph2d__store_reserve(t, s->memory, 2 * t->count + 64))
            return false;
        for (int x = 0; x <= HIGH_X; ++x)
            for (int y = 0; y <= HIGH_Y; y += LOW_Y)
                if ((x | y) != 0 && (near & (x | y)) == (x | y)) {
                    const sph2d_vec2 at = mirrored(&z->sides, x | y, (sph2d_vec2){f->x[i], f->y[i]});
                    sph2d__store_add(t, i * IMAGE_SIDES + (size_t)(x | y), at.x, at.y);
                }
    }
    z->image_cells.period = s->fluid_cells.period;
    z->image_cells.columns = s->fluid_cells.columns;
    z->first_image = f->count + 2 * SPH2D__WIDEST;
    return t->count == 0 || (sph2d__cells_build(&z->image_cells, t, s->reach, s->memory) &&
                             sph2d__store_reserve(f, s->memory, z->first_image + t->count + SPH2D__WIDEST));
}

size_t sph2d__image_of(const sph2d__frozen *frozen, size_t k)
{
    return (size_t)frozen->images.id[k] / IMAGE_SIDES;
}

/** Signs of an image's components. */
typedef struct image {
    size_t of;
    int sides;
    double x, y;
} image;

static image image_at(const sph2d__frozen *z, size_t k)
{
    const int sides = (int)(z->images.id[k] % IMAGE_SIDES);
    return (image){sph2d__image_of(z, k), sides, sides & (LOW_X | HIGH_X) ? -1 : 1, sides & (LOW_Y | HIGH_Y) ? -1 : 1};
}

/** A record of particle `from` as its image has it. */
static void copy_record(float *records, size_t to, size_t from, double a, double b, double c, double d)
{
    const float *row = records + 4 * from;
    const float seen[4] = {(float)a * row[0], (float)b * row[1], (float)c * row[2], (float)d * row[3]};
    memcpy(records + 4 * to, seen, sizeof seen);
}

/** An entry of a table over a distance from a plane. */
static double by_distance(const sph2d__system *s, const double *table, double d)
{
    const double at = fmax(d / s->support, 0) * SPH2D__PLANE_PARTS;
    if (!(at < SPH2D__PLANE_PARTS))
        return 0;
    const size_t k = (size_t)at;
    return table[k] + (at - (double)k) * (table[k + 1] - table[k]);
}

/** Sets w. */
static void turn(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__sides *d = &z->sides;
    for (size_t i = first; i < last; ++i) {
        const double x = s->fluid.x[i], y = s->fluid.y[i];
        z->across_x[i] = by_distance(s, z->beyond, x - d->low_x) + by_distance(s, z->beyond, d->high_x - x);
        z->across_y[i] = by_distance(s, z->beyond, y - d->low_y) + by_distance(s, z->beyond, d->high_y - y);
    }
}

double sph2d__side_energy(const sph2d__system *s, double x, double y)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__sides *d = &z->sides;
    return 2 * s->forces.gravity.x * (by_distance(s, z->lift, d->high_x - x) - by_distance(s, z->lift, x - d->low_x)) +
           2 * s->forces.gravity.y * (by_distance(s, z->lift, d->high_y - y) - by_distance(s, z->lift, y - d->low_y));
}

void sph2d__images_start(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *f = &s->fluid;
    sph2d__over_particles(s, f->count, turn, NULL);
    for (size_t k = 0; k < z->images.count; ++k) {
        const image m = image_at(z, k);
        const size_t i = z->first_image + k;
        f->x[i] = z->images.x[k];
        f->y[i] = z->images.y[k];
        f->vx[i] = m.x * f->vx[m.of];
        f->vy[i] = m.y * f->vy[m.of];
        f->log_density[i] = f->log_density[m.of];
        copy_record(z->state, i, m.of, m.x, m.y, 1, 1);
    }
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

static void sight_of(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t k = first; k < last; ++k) {
        const image m = image_at(z, k);
        const size_t i = z->first_image + k;
        z->sight[i] = z->sight[m.of];
        z->sight_x[i] = m.x * z->sight_x[m.of];
        z->sight_y[i] = m.y * z->sight_y[m.of];
    }
}

static void slopes_of(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t k = first; k < last; ++k) {
        const image m = image_at(z, k);
        const size_t i = z->first_image + k;
        copy_record(z->slope, i, m.of, 1, m.x * m.y, 1, 1);
        copy_record(z->bend, i, m.of, m.x, m.y, 1, 1);
    }
}

/** Where an image is now. */
static void place(sph2d__frozen *z, size_t i, image m)
{
    const sph2d_vec2 at = mirrored(&z->sides, m.sides, (sph2d_vec2){z->px[m.of], z->py[m.of]});
    z->px[i] = at.x;
    z->py[i] = at.y;
}

static void velocity_of(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t k = first; k < last; ++k) {
        const image m = image_at(z, k);
        const size_t i = z->first_image + k;
        place(z, i, m);
        copy_record(z->velocity, i, m.of, m.x, m.y, m.x, m.y);
    }
}

static void pressure_of(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t k = first; k < last; ++k) {
        const image m = image_at(z, k);
        const size_t i = z->first_image + k;
        place(z, i, m);
        copy_record(z->press, i, m.of, 1, m.x * m.y, 1, 1);
        z->work[i] = z->work[m.of];
    }
}

static void rest_of(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t k = first; k < last; ++k) {
        const image m = image_at(z, k);
        copy_record(z->rest, z->first_image + k, m.of, m.x, m.y, m.x, m.y);
    }
}

void sph2d__images_of_sight(sph2d__system *s)
{
    sph2d__over_particles(s, s->frozen->images.count, sight_of, NULL);
}
void sph2d__images_of_slopes(sph2d__system *s)
{
    sph2d__over_particles(s, s->frozen->images.count, slopes_of, NULL);
}
void sph2d__images_of_velocity(sph2d__system *s)
{
    sph2d__over_particles(s, s->frozen->images.count, velocity_of, NULL);
}
void sph2d__images_of_pressure(sph2d__system *s)
{
    sph2d__over_particles(s, s->frozen->images.count, pressure_of, NULL);
}
void sph2d__images_of_rest(sph2d__system *s)
{
    sph2d__over_particles(s, s->frozen->images.count, rest_of, NULL);
}
