/* SPDX-License-Identifier: MIT */
/** @file wcsph_mirror.h
 *  Images in the domain's sides, one by one, in C and in OpenCL C (wcsph_images.c). */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_MIRROR_H
#define SPH2D_METHODS_WCSPH_WCSPH_MIRROR_H

#include "methods/wcsph/wcsph_frozen.h"
#include "simd/lanes.h"

enum { LOW_X = 1, HIGH_X = 2, LOW_Y = 4, HIGH_Y = 8, IMAGE_SIDES = 16 };

/** The sides of which (x, y) is nearer than the support. */
SPH2D__INLINE int sides_near(const sph2d__system *s, double x, double y)
{
    const sph2d__sides *d = &s->frozen->sides;
    return (x - d->low_x < s->support ? LOW_X : 0) | (d->high_x - x < s->support ? HIGH_X : 0) |
           (y - d->low_y < s->support ? LOW_Y : 0) | (d->high_y - y < s->support ? HIGH_Y : 0);
}

SPH2D__INLINE sph2d_vec2 mirrored(const sph2d__sides *d, int in, sph2d_vec2 p)
{
    return (sph2d_vec2){in & LOW_X    ? 2 * d->low_x - p.x
                        : in & HIGH_X ? 2 * d->high_x - p.x
                                      : p.x,
                        in & LOW_Y    ? 2 * d->low_y - p.y
                        : in & HIGH_Y ? 2 * d->high_y - p.y
                                      : p.y};
}

/** Signs of an image's components. */
typedef struct image {
    size_t of;
    int sides;
    double x, y;
} image;

SPH2D__INLINE image image_at(const sph2d__frozen *z, size_t k)
{
    const int sides = (int)(z->images.id[k] % IMAGE_SIDES);
    return (image){(size_t)z->images.id[k] / IMAGE_SIDES, sides, sides & (LOW_X | HIGH_X) ? -1 : 1,
                   sides & (LOW_Y | HIGH_Y) ? -1 : 1};
}

/** A record of particle `from` as its image has it. */
SPH2D__INLINE void copy_record(SPH2D__ARRAY float *records, size_t to, size_t from, double a, double b, double c,
                               double d)
{
    SPH2D__ARRAY const float *row = records + 4 * from;
    SPH2D__ARRAY float *seen = records + 4 * to;
    seen[0] = (float)a * row[0];
    seen[1] = (float)b * row[1];
    seen[2] = (float)c * row[2];
    seen[3] = (float)d * row[3];
}

/** An entry of a table over a distance from a plane. */
SPH2D__INLINE double by_distance(const sph2d__system *s, SPH2D__ARRAY const double *table, double d)
{
    const double at = fmax(d / s->support, 0) * SPH2D__PLANE_PARTS;
    if (!(at < SPH2D__PLANE_PARTS))
        return 0;
    const size_t k = (size_t)at;
    return table[k] + (at - (double)k) * (table[k + 1] - table[k]);
}

/** Sets w. */
SPH2D__INLINE void turn_some(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__sides *d = &z->sides;
    for (size_t i = first; i < last; ++i) {
        const double x = s->fluid.x[i], y = s->fluid.y[i];
        z->across_x[i] = by_distance(s, z->beyond, x - d->low_x) + by_distance(s, z->beyond, d->high_x - x);
        z->across_y[i] = by_distance(s, z->beyond, y - d->low_y) + by_distance(s, z->beyond, d->high_y - y);
    }
}

SPH2D__INLINE double side_energy(const sph2d__system *s, double x, double y)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__sides *d = &z->sides;
    return 2 * s->forces.gravity.x * (by_distance(s, z->lift, d->high_x - x) - by_distance(s, z->lift, x - d->low_x)) +
           2 * s->forces.gravity.y * (by_distance(s, z->lift, d->high_y - y) - by_distance(s, z->lift, y - d->low_y));
}

/** Images as their particles are, before neighbours are searched. */
SPH2D__INLINE void start_of(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *f = &s->fluid;
    for (size_t k = first; k < last; ++k) {
        const image m = image_at(z, k);
        const size_t i = z->first_image + k;
        f->x[i] = z->images.x[k];
        f->y[i] = z->images.y[k];
        f->vx[i] = m.x * f->vx[m.of];
        f->vy[i] = m.y * f->vy[m.of];
        f->log_density[i] = f->log_density[m.of];
        copy_record(z->state, i, m.of, m.x, m.y, 1, 1);
    }
}

SPH2D__INLINE void sight_of(sph2d__system *s, size_t first, size_t last)
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

SPH2D__INLINE void slopes_of(sph2d__system *s, size_t first, size_t last)
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
SPH2D__INLINE void place(sph2d__frozen *z, size_t i, image m)
{
    const sph2d_vec2 at = mirrored(&z->sides, m.sides, (sph2d_vec2){z->px[m.of], z->py[m.of]});
    z->px[i] = at.x;
    z->py[i] = at.y;
}

SPH2D__INLINE void velocity_of(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t k = first; k < last; ++k) {
        const image m = image_at(z, k);
        const size_t i = z->first_image + k;
        place(z, i, m);
        copy_record(z->velocity, i, m.of, m.x, m.y, m.x, m.y);
    }
}

SPH2D__INLINE void pressure_of(sph2d__system *s, size_t first, size_t last)
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

SPH2D__INLINE void rest_of(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t k = first; k < last; ++k) {
        const image m = image_at(z, k);
        copy_record(z->rest, z->first_image + k, m.of, m.x, m.y, m.x, m.y);
    }
}

/* The most images of a particle. */
enum { MOST_IMAGES = 8 };

/** The images of particle i: which sides they are in, in the order in which they are listed. Returns how many. */
SPH2D__INLINE int images_of(const sph2d__system *s, size_t i, int in[MOST_IMAGES])
{
    const int near = sides_near(s, s->fluid.x[i], s->fluid.y[i]);
    int count = 0;
    for (int x = 0; x <= HIGH_X; ++x)
        for (int y = 0; y <= HIGH_Y; y += LOW_Y)
            if ((x | y) != 0 && (near & (x | y)) == (x | y))
                in[count++] = x | y;
    return count;
}

#endif
