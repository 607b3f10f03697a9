/* SPDX-License-Identifier: MIT */
/** @file wcsph_sight.h
 *  Which particles walls are between: solids thinner than the support, and the tips of others (wcsph.h). Every lane is a
 *  particle. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_SIGHT_H
#define SPH2D_METHODS_WCSPH_WCSPH_SIGHT_H

#include "kernels/kernel.h"
#include "methods/common/shortest.h"
#include "methods/wcsph/wcsph_finish.h"
#include "methods/wcsph/wcsph_front.h"

/* How much of a row of boundary particles is at the foot of a particle that is before a face, and not past its end. */
SPH2D__FIXED double ON_FACE = 0.5;
/* The distance of particles that no face hides anything from [m]. */
SPH2D__FIXED double NO_FACE = 1e30;

/** The nearest face before which the particles `first` on are, where they are behind another within the support: the wall in
 *  `slots` from k on is thin there. */
SPH2D__INLINE void find_sight(const sph2d__system *s, size_t first, size_t k, uint32_t slots)
{
    const sph2d__store *w = &s->walls;
    const sph2d__period *period = &s->fluid_cells.period;
    sph2d__frozen *z = s->frozen;
    const sph2d__lanes none = {0}, far = sph2d__lanes_all(NO_FACE), spacing = sph2d__lanes_all(s->spacing),
                       one = sph2d__lanes_all(1);
    const sph2d__lanes x = sph2d__lanes_load(s->fluid.x + first), y = sph2d__lanes_load(s->fluid.y + first);
    sph2d__lanes nearest = far, nx = none, ny = none, hidden = none, foot = none;
    for (uint32_t slot = 0; slot < slots; ++slot, k += SPH2D__STRIDE) {
        SPH2D__ARRAY const uint32_t *b = s->neighbours.index + k;
        const sph2d__lanes rx = sph2d__shortest(x - sph2d__lanes_gather(w->x, b), period->length_x),
                           ry = sph2d__shortest(y - sph2d__lanes_gather(w->y, b), period->length_y);
        const sph2d__lanes bx = sph2d__lanes_gather(w->normal_x, b), by = sph2d__lanes_gather(w->normal_y, b);
        const sph2d__lanes listed = sph2d__lanes_where(sph2d__lanes_all(1e20), rx * rx, one), in = within(s, b, listed);
        const sph2d__lanes above = rx * bx + ry * by, along = rx * by - ry * bx,
                           depth = sph2d__lanes_gather(w->depth, b);
        const sph2d__lanes behind =
            sph2d__lanes_where(none, above, in) + (listed - in) * sph2d__lanes_gather(z->part, b);
        hidden = sph2d__lanes_max(hidden, behind);
        const sph2d__lanes row = sph2d__lanes_where(spacing, depth, sph2d__lanes_where(above, depth, in));
        const sph2d__lanes part =
            row * sph2d__lanes_max(one - sph2d__lanes_max(along, -along) * (1 / s->spacing), none);
        foot += part;
        const sph2d__lanes nearer = sph2d__lanes_where(part, none, sph2d__lanes_where(nearest, above - depth, one));
        nearest = pick(nearer, none, above - depth, nearest);
        nx = pick(nearer, none, bx, nx);
        ny = pick(nearer, none, by, ny);
    }
    nearest = pick(foot, sph2d__lanes_all(ON_FACE), nearest, far);
    sph2d__lanes_store(z->sight + first, pick(hidden, none, nearest, far));
    sph2d__lanes_store(z->sight_x + first, nx);
    sph2d__lanes_store(z->sight_y + first, ny);
}

/** Takes the pairs of a slice that a wall is between out of its own sums, and adds them to what is behind walls. They are those
 *  that are each behind the face that the other is before, if the faces look away from each other. */
SPH2D__INLINE void hide_pairs(const sph2d__system *s, size_t first, size_t at, uint32_t slots, sph2d_kernel kernel,
                              sums *own, wall_sums *behind)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__lanes none = {0}, one = sph2d__lanes_all(1);
    const sph2d__lanes d = sph2d__lanes_load(z->sight + first), nx = sph2d__lanes_load(z->sight_x + first),
                       ny = sph2d__lanes_load(z->sight_y + first);
    if (sph2d__lanes_which(d, 1e20) == 0)
        return;
    for (size_t k = at; k < at + (size_t)slots * SPH2D__STRIDE; k += SPH2D__STRIDE) {
        SPH2D__ARRAY const uint32_t *j = s->neighbours.index + k;
        const sph2d__lanes rx = sph2d__floats_load(z->rx + k), ry = sph2d__floats_load(z->ry + k),
                           gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k);
        const sph2d__lanes mx = sph2d__lanes_gather(z->sight_x, j), my = sph2d__lanes_gather(z->sight_y, j);
        const sph2d__lanes below = sph2d__lanes_where(rx * nx + ry * ny, d, one);
        sph2d__lanes hidden = sph2d__lanes_where(-(rx * mx + ry * my), sph2d__lanes_gather(z->sight, j), below);
        hidden = sph2d__lanes_where(none, nx * mx + ny * my, hidden);
        hidden = sph2d__lanes_where(gx * gx + gy * gy, none, hidden);
        const sph2d__lanes r = sph2d__lanes_sqrt(rx * rx + ry * ry), q = r * (1 / s->support);
        const sph2d__lanes value = sph2d__lanes_where(hidden, none, sph2d__kernel_value(kernel, q));
        const sph2d__lanes hx = hidden * gx, hy = hidden * gy;
        own->value -= value;
        own->kx -= r * hx;
        own->ky -= r * hy;
        behind->value += value;
        behind->around -= (below - hidden) * (gx * nx + gy * ny);
        behind->gx += hx;
        behind->gy += hy;
        behind->xx -= hx * rx;
        behind->xy -= hx * ry;
        behind->yy -= hy * ry;
        behind->kx += r * hx;
        behind->ky += r * hy;
        sph2d__floats_store(z->gx + k, gx - hx);
        sph2d__floats_store(z->gy + k, gy - hy);
        sph2d__floats_store(z->inverse + k, (one - hidden) * sph2d__floats_load(z->inverse + k));
    }
}

/* Part of what is beyond a plane that is missed for certain: sums over rows of boundary particles differ by less. */
SPH2D__FIXED double KNOWN = 0.85;
/* Over the part of a plane that liquid behind a wall fills, from which on none of it counts as empty. */
SPH2D__FIXED double COUNTS = 2;

/** sum |G| beyond a plane at these distances [1/m]. */
SPH2D__INLINE sph2d__lanes beyond_plane(const sph2d__system *s, sph2d__lanes distance)
{
    SPH2D__ARRAY const double *beyond = s->frozen->beyond;
    sph2d__lanes sum;
    for (int l = 0; l < SPH2D__LANES; ++l) {
        const double at = SPH2D__LANE(distance, l) / s->support * SPH2D__PLANE_PARTS;
        const int k = at < SPH2D__PLANE_PARTS ? (int)at : SPH2D__PLANE_PARTS;
        SPH2D__LANE(sum, l) =
            k < SPH2D__PLANE_PARTS ? (beyond[k] - beyond[k + 1]) * (SPH2D__PLANE_PARTS / s->support) : 0;
    }
    return sum;
}

/** 1 for boundary particles of the face before which a particle is, with normal n, else 0. r: from them to it. Walls on its
 *  other side have normals like n, too, where it is in a gap: with theirs the face's own sum was next to nothing. */
SPH2D__INLINE sph2d__lanes on_face(const sph2d__system *s, SPH2D__ARRAY const uint32_t *b, sph2d__lanes nx,
                                   sph2d__lanes ny, sph2d__lanes rx, sph2d__lanes ry)
{
    const sph2d__lanes none = {0}, along = nx * sph2d__lanes_gather(s->walls.normal_x, b) +
                                           ny * sph2d__lanes_gather(s->walls.normal_y, b);
    const sph2d__lanes behind = sph2d__lanes_where(rx * nx + ry * ny, none, sph2d__lanes_all(1));
    return within(s, b, sph2d__lanes_where(along, none, behind));
}

/** By how much more the face of a slice's particles presses than its boundary particles do: with what is behind it, the liquid
 *  and, beyond the face's plane, what neither fills. */
SPH2D__INLINE sph2d__lanes thickness_of(const sph2d__system *s, size_t first, size_t begin, uint32_t slots,
                                        wall_sums *behind)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__lanes none = {0}, distance = sph2d__lanes_load(z->sight + first);
    const sph2d__lanes nx = sph2d__lanes_load(z->sight_x + first), ny = sph2d__lanes_load(z->sight_y + first);
    sph2d__lanes wx = none, wy = none, solid = none;
    for (size_t k = begin; k < begin + (size_t)slots * SPH2D__STRIDE; k += SPH2D__STRIDE) {
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k),
                           rx = sph2d__floats_load(z->rx + k), ry = sph2d__floats_load(z->ry + k);
        const sph2d__lanes on = on_face(s, s->neighbours.index + k, nx, ny, rx, ry);
        wx += on * gx;
        wy += on * gy;
        solid -= sph2d__lanes_where(rx * nx + ry * ny, distance, gx * nx + gy * ny);
    }
    const sph2d__lanes wall = -(nx * wx + ny * wy), liquid = -(nx * behind->gx + ny * behind->gy);
    const sph2d__lanes empty = sph2d__lanes_where(
        sph2d__lanes_all(s->support), distance,
        sph2d__lanes_max(KNOWN * beyond_plane(s, distance) - solid - COUNTS * (liquid + behind->around), none));
    const sph2d__lanes more = sph2d__lanes_where(wall, none, sph2d__lanes_max(liquid + empty, none) / wall);
    behind->ex = behind->gx - empty * nx - more * wx;
    behind->ey = behind->gy - empty * ny - more * wy;
    return more;
}

/** Makes the boundary particles of faces that are thin press as walls of any thickness do. Returns M - F by all walls. */
SPH2D__INLINE symmetric thicken(const sph2d__system *s, size_t first, size_t begin, uint32_t slots,
                                const wall_sums *walls, wall_sums *behind)
{
    const sph2d__frozen *z = s->frozen;
    symmetric sum = {walls->xx, walls->xy, walls->yy};
    sph2d__lanes_store(z->thicker + first, (sph2d__lanes){0});
    if (!z->thin || sph2d__lanes_which(sph2d__lanes_load(z->sight + first), s->support) == 0)
        return sum;
    const sph2d__lanes more = thickness_of(s, first, begin, slots, behind);
    const sph2d__lanes nx = sph2d__lanes_load(z->sight_x + first), ny = sph2d__lanes_load(z->sight_y + first);
    sph2d__lanes_store(z->thicker + first, more);
    for (size_t k = begin; k < begin + (size_t)slots * SPH2D__STRIDE; k += SPH2D__STRIDE) {
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k),
                           rx = sph2d__floats_load(z->rx + k), ry = sph2d__floats_load(z->ry + k);
        const sph2d__lanes on = more * on_face(s, s->neighbours.index + k, nx, ny, rx, ry);
        const sph2d__lanes mx = on * gx, my = on * gy;
        sum.xx -= sph2d__lanes_where(mx * mx, (sph2d__lanes){0}, mx * rx); /* what lists end with is far away */
        sum.xy -= sph2d__lanes_where(mx * mx, (sph2d__lanes){0}, mx * ry);
        sum.yy -= sph2d__lanes_where(my * my, (sph2d__lanes){0}, my * ry);
        sph2d__floats_store(z->gx + k, gx + mx);
        sph2d__floats_store(z->gy + k, gy + my);
    }
    return sum;
}

#endif
