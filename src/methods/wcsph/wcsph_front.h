/* SPDX-License-Identifier: MIT */
/** @file wcsph_front.h
 *  What the walls around a slice's particles make of them, once B is known: Q, S, q, z and the walls that they are in front
 *  of (wcsph.h). Every lane is a particle. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_FRONT_H
#define SPH2D_METHODS_WCSPH_WCSPH_FRONT_H

#include "methods/wcsph/wcsph_pair.h"

/** `size` of boundary particles between the sides, 0 of those beyond, which stand for the image of an obstacle: their normals
 *  are not those of that. */
SPH2D__INLINE sph2d__lanes within(const sph2d__system *s, SPH2D__ARRAY const uint32_t *b, sph2d__lanes size)
{
    const sph2d__sides *d = &s->frozen->sides;
    const sph2d__lanes x = sph2d__lanes_gather(s->walls.x, b), y = sph2d__lanes_gather(s->walls.y, b);
    size = sph2d__lanes_where(x, sph2d__lanes_all(d->low_x), size);
    size = sph2d__lanes_where(sph2d__lanes_all(d->high_x), x, size);
    size = sph2d__lanes_where(y, sph2d__lanes_all(d->low_y), size);
    return sph2d__lanes_where(sph2d__lanes_all(d->high_y), y, size);
}

/** Sums over the walls of a slice. */
typedef struct shape_sums {
    symmetric normals;   /* |G| n n^T of faces that look at the particle, and 1 for n n^T where there is no normal */
    sph2d__lanes wx, wy; /* G */
    sph2d__lanes weight, bend; /* |G| between the sides, and |G| n . o, o from a particle to the wall's surface at b */
    sph2d__lanes nx, ny, x, y; /* |G| n, |G| o */
    sph2d__lanes foot; /* how much of a row there is at the surface at a particle's foot: 1 in front of a face */
} shape_sums;

SPH2D__INLINE shape_sums sum_shape(const sph2d__system *s, size_t k, uint32_t slots)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__lanes none = {0}, one = sph2d__lanes_all(1), spacing = sph2d__lanes_all(s->spacing);
    shape_sums sum = {0};
    for (uint32_t slot = 0; slot < slots; ++slot, k += SPH2D__STRIDE) {
        SPH2D__ARRAY const uint32_t *b = s->neighbours.index + k;
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k);
        const sph2d__lanes rx = sph2d__floats_load(z->rx + k), ry = sph2d__floats_load(z->ry + k);
        const sph2d__lanes size = sph2d__lanes_sqrt(gx * gx + gy * gy);
        const sph2d__lanes nx = sph2d__lanes_gather(s->walls.normal_x, b),
                           ny = sph2d__lanes_gather(s->walls.normal_y, b),
                           depth = sph2d__lanes_gather(s->walls.depth, b);
        const sph2d__lanes blunt = size * sph2d__lanes_where(0.5 - nx * nx - ny * ny, none, one);
        const sph2d__lanes faces = within(s, b, sph2d__lanes_where(rx * nx + ry * ny, none, size));
        sum.normals.xx += faces * nx * nx + blunt;
        sum.normals.xy += faces * nx * ny;
        sum.normals.yy += faces * ny * ny + blunt;
        sum.wx += gx;
        sum.wy += gy;
        const sph2d__lanes ox = sph2d__lanes_where(size, none, depth * nx - rx),
                           oy = sph2d__lanes_where(size, none, depth * ny - ry);
        const sph2d__lanes in = within(s, b, size);
        sum.weight += in;
        sum.nx += in * nx;
        sum.ny += in * ny;
        sum.x += in * ox;
        sum.y += in * oy;
        sum.bend += in * (nx * ox + ny * oy);
        const sph2d__lanes before = sph2d__lanes_where(size, none, rx * nx + ry * ny - depth),
                           along = rx * ny - ry * nx;
        const sph2d__lanes part = one - sph2d__lanes_max(along, -along) * (1 / s->spacing);
        sum.foot += sph2d__lanes_where(before, none, sph2d__lanes_where(spacing, depth, sph2d__lanes_max(part, none)));
    }
    return sum;
}

/** A symmetric matrix's eigenvector of the largest eigenvalue, times its transpose, and that across; and the eigenvalues. */
typedef struct axes {
    symmetric e, t;
    sph2d__lanes largest, other;
} axes;

SPH2D__INLINE axes axes_of(symmetric m)
{
    const sph2d__lanes half = 0.5 * (m.xx - m.yy), mean = 0.5 * (m.xx + m.yy);
    const sph2d__lanes root = sph2d__lanes_sqrt(half * half + m.xy * m.xy);
    const sph2d__lanes apart = sph2d__lanes_where(root, (sph2d__lanes){0}, 0.5 / root);
    return (axes){{0.5 + apart * half, apart * m.xy, 0.5 - apart * half},
                  {0.5 - apart * half, -apart * m.xy, 0.5 + apart * half},
                  mean + root,
                  mean - root};
}

/** a . m b */
SPH2D__INLINE sph2d__lanes across(symmetric m, sph2d__lanes ax, sph2d__lanes ay, sph2d__lanes bx, sph2d__lanes by)
{
    return m.xx * ax * bx + m.xy * (ax * by + ay * bx) + m.yy * ay * by;
}

/** How much of walls that press with `walls` squared balances what liquid presses with. */
SPH2D__INLINE sph2d__lanes balanced(sph2d__lanes walls, sph2d__lanes liquid)
{
    return sph2d__lanes_where(walls, (sph2d__lanes){0}, clamp(-liquid / walls));
}

/** In which directions walls act. */
typedef struct directions {
    symmetric q;
    sph2d__lanes part; /* of C */
} directions;

/* By which part a flat wall may seem to have an edge, by rounding: where it did, at random, walls pressed along themselves, by
 * their rows of boundary particles, and liquid at rest on a slope moved. */
SPH2D__FIXED double FLAT = 1e-9;

/** Q of the walls in slots from k on. In inner corners walls also press across the largest eigenvalue's direction, as far as
 *  liquid presses against them: of the far wall of a corner a particle sees little, so that by normals alone it had a small
 *  part of its force on liquid at rest, and what is in the corner bore the rest, up to 3.7 rho g H. A corner is an inner one
 *  where the surface of walls goes back where their normals go on. Around edges walls press along the sum of their
 *  gradients, of which what is along t is no more than liquid presses against: by normals alone liquid around the edge,
 *  which they do not balance, drew particles along the faces with all of its pressure, into a tank through an opening in
 *  its side, and a body floated half a spacing too high. Across that sum they have no force, since liquid that slides
 *  along a face would be held. Walls that a particle is not before, as its foot is beyond their end, press no more than
 *  liquid presses against them, in each direction: a jet that leaves a duct would take itself for liquid that leaves a
 *  wall. */
SPH2D__INLINE directions directions_of(const sph2d__system *s, size_t first, size_t k, uint32_t slots,
                                       const wall_sums *behind)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__lanes none = {0}, one = sph2d__lanes_all(1);
    shape_sums sum = sum_shape(s, k, slots);
    sum.wx += behind->ex;
    sum.wy += behind->ey;
    const axes a = axes_of(sum.normals);
    const sph2d__lanes bxx = sph2d__lanes_load(z->bxx + first), bxy = sph2d__lanes_load(z->bxy + first),
                       byy = sph2d__lanes_load(z->byy + first);
    const sph2d__lanes lx = sph2d__lanes_load(z->nx + first), ly = sph2d__lanes_load(z->ny + first);
    const sph2d__lanes wx = bxx * sum.wx + bxy * sum.wy, wy = bxy * sum.wx + byy * sum.wy;
    const sph2d__lanes px = bxx * lx + bxy * ly, py = bxy * lx + byy * ly;
    const sph2d__lanes walls = across(a.t, wx, wy, wx, wy);
    const sph2d__lanes by_t = balanced(walls, across(a.t, wx, wy, px, py)),
                       by_e = balanced(across(a.e, wx, wy, wx, wy), across(a.e, wx, wy, px, py));
    const sph2d__lanes unit = sph2d__lanes_where(a.largest, none, 1 / a.largest);
    const sph2d__lanes inner =
        sph2d__lanes_where(sum.nx * sum.x + sum.ny * sum.y, (1 + FLAT) * sum.bend * sum.weight, one);
    /* not more than those have whose normals are that way: flat walls and slits have none */
    const sph2d__lanes most = sph2d__lanes_where(walls, none, a.other / sph2d__lanes_sqrt(walls));
    const sph2d__lanes more = inner * sph2d__lanes_max(sph2d__lanes_min(by_t, most) - unit * a.other, none);
    const sph2d__lanes ex = sum.wx - (one - by_t) * (a.t.xx * sum.wx + a.t.xy * sum.wy),
                       ey = sum.wy - (one - by_t) * (a.t.xy * sum.wx + a.t.yy * sum.wy);
    const sph2d__lanes e2 = ex * ex + ey * ey, edge = (one - inner) * sph2d__lanes_where(e2, none, 1 / e2);
    const sph2d__lanes foot = sph2d__lanes_min(sum.foot, one), beyond = one - foot;
    const sph2d__lanes n = foot * inner * unit, t = foot * more + beyond * by_t, e = beyond * by_e, g = foot * edge;
    return (directions){{n * sum.normals.xx + t * a.t.xx + e * a.e.xx + g * ex * ex,
                         n * sum.normals.xy + t * a.t.xy + e * a.e.xy + g * ex * ey,
                         n * sum.normals.yy + t * a.t.yy + e * a.e.yy + g * ey * ey},
                        foot + beyond * sph2d__lanes_min(by_e, by_t)};
}

/** Takes a part of C. */
SPH2D__INLINE void take_turn(sph2d__frozen *z, size_t first, sph2d__lanes part)
{
#define TAKE(name) sph2d__lanes_store(z->name + first, part * sph2d__lanes_load(z->name + first));
    TAKE(walled)
    TAKE(cxx)
    TAKE(cxy)
    TAKE(cyx)
    TAKE(cyy)
#undef TAKE
}

/** Finds the walls that particles are in front of: those at their foot, no more than a spacing away, or a sheet would stop
 *  what falls past its end. */
SPH2D__INLINE void find_front(const sph2d__system *s, size_t first, size_t k, uint32_t slots)
{
    const sph2d__store *w = &s->walls;
    sph2d__frozen *z = s->frozen;
    const sph2d__lanes none = {0};
    sph2d__lanes weight = {0}, away = {0}, x = {0}, y = {0}, vx = {0}, vy = {0};
    for (uint32_t slot = 0; slot < slots; ++slot, k += SPH2D__STRIDE) {
        SPH2D__ARRAY const uint32_t *b = s->neighbours.index + k;
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k);
        const sph2d__lanes rx = sph2d__floats_load(z->rx + k), ry = sph2d__floats_load(z->ry + k);
        const sph2d__lanes nx = sph2d__lanes_gather(w->normal_x, b), ny = sph2d__lanes_gather(w->normal_y, b);
        const sph2d__lanes before = rx * nx + ry * ny - sph2d__lanes_gather(w->depth, b), along = rx * ny - ry * nx;
        const sph2d__lanes size =
            sph2d__lanes_where(sph2d__lanes_all(s->spacing * s->spacing), along * along,
                               within(s, b, sph2d__lanes_where(before, none, sph2d__lanes_sqrt(gx * gx + gy * gy))));
        weight += size;
        away += sph2d__lanes_where(size, none, size * before);
        x += size * nx;
        y += size * ny;
        vx += size * sph2d__lanes_gather(w->vx, b);
        vy += size * sph2d__lanes_gather(w->vy, b);
    }
    const sph2d__lanes length = sph2d__lanes_sqrt(x * x + y * y);
    const sph2d__lanes nx = sph2d__lanes_where(length, none, x / length),
                       ny = sph2d__lanes_where(length, none, y / length);
    sph2d__lanes_store(z->front_nx + first, nx);
    sph2d__lanes_store(z->front_ny + first, ny);
    sph2d__lanes_store(z->front + first, sph2d__lanes_where(weight, none, away / weight));
    sph2d__lanes_store(z->front_weight + first, weight);
    sph2d__lanes_store(z->front_speed + first, sph2d__lanes_where(weight, none, (vx * nx + vy * ny) / weight));
}

/** Sums over the walls of a slice whose B are known. Walls act along their normals alone, as smooth as they are, but for
 *  the pressure's gradient. */
SPH2D__INLINE void finish_walls(const sph2d__system *s, size_t first, SPH2D__ARRAY const sph2d__slice *at,
                                const wall_sums *behind)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__store *w = &s->walls;
    sph2d__frozen *z = s->frozen;
    const sph2d__lanes bxx = sph2d__lanes_load(z->bxx + first), bxy = sph2d__lanes_load(z->bxy + first),
                       byy = sph2d__lanes_load(z->byy + first), none = {0};
    sph2d__lanes sx = {0}, sy = {0}, rate = {0}, tx = {0}, ty = {0}, away = {0}, weight = {0};
    size_t k = at->begin + (size_t)at->fluid * SPH2D__STRIDE;
    find_front(s, first, k, at->walls);
    const directions to = directions_of(s, first, k, at->walls, behind);
    const symmetric q = to.q;
    take_turn(z, first, to.part);
    sph2d__lanes_store(z->wall_xx + first, q.xx);
    sph2d__lanes_store(z->wall_xy + first, q.xy);
    sph2d__lanes_store(z->wall_yy + first, q.yy);
    for (uint32_t slot = 0; slot < at->walls; ++slot, k += SPH2D__STRIDE) {
        SPH2D__ARRAY const uint32_t *b = n->index + k;
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k),
                           rx = sph2d__floats_load(z->rx + k), ry = sph2d__floats_load(z->ry + k);
        const sph2d__lanes nx = sph2d__lanes_gather(w->normal_x, b), ny = sph2d__lanes_gather(w->normal_y, b);
        const sph2d__lanes ax = bxx * gx + bxy * gy, ay = bxy * gx + byy * gy;
        const sph2d__lanes along = ax * nx + ay * ny;
        const sph2d__lanes vx = sph2d__lanes_gather(w->vx, b), vy = sph2d__lanes_gather(w->vy, b),
                           flux = vx * ax + vy * ay;
        const sph2d__lanes near = sph2d__lanes_where(gx * gx + gy * gy, none, flux);
        tx += sph2d__lanes_where(near * near, none, flux * rx);
        ty += sph2d__lanes_where(near * near, none, flux * ry);
        const sph2d__lanes px = q.xx * ax + q.xy * ay, py = q.xy * ax + q.yy * ay;
        sx += px;
        sy += py;
        rate += 2 * (vx * px + vy * py);
        const sph2d__lanes size = sph2d__lanes_where(nx * nx + ny * ny, none, sph2d__lanes_max(along, -along));
        weight += size;
        away += sph2d__lanes_where(size, none, size * (rx * nx + ry * ny - sph2d__lanes_gather(w->depth, b)));
    }
    const sph2d__lanes axx = sph2d__lanes_load(z->axx + first), axy = sph2d__lanes_load(z->axy + first),
                       ayy = sph2d__lanes_load(z->ayy + first), walled = sph2d__lanes_load(z->walled + first);
    sph2d__lanes_store(z->sx + first, sx);
    sph2d__lanes_store(z->sy + first, sy);
    sph2d__lanes_store(z->wall_rate + first, rate);
    sph2d__lanes_store(z->wall_zx + first, -walled * (axx * tx + axy * ty));
    sph2d__lanes_store(z->wall_zy + first, -walled * (axy * tx + ayy * ty));
    /* What is linear of the speed towards the wall and its image. */
    const sph2d__lanes size2 = sx * sx + sy * sy;
    const sph2d__four v = sph2d__four_load(z->slope + 4 * first);
    const sph2d__lanes stretch = v.a * sx * sx + 2 * v.b * sx * sy + v.c * sy * sy;
    const sph2d__lanes distance = sph2d__lanes_where(weight, none, away / weight);
    sph2d__lanes_store(z->wall_linear + first, sph2d__lanes_where(size2, none, -2 * distance * stretch / size2));
}

#endif
