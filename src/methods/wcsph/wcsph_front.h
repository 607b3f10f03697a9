/* SPDX-License-Identifier: MIT */
/** @file wcsph_front.h
 *  What the walls around a slice's particles make of them, once B is known: Q, S, q, z and the walls that they are in front
 *  of (wcsph.h). Every lane is a particle. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_FRONT_H
#define SPH2D_METHODS_WCSPH_WCSPH_FRONT_H

#include "methods/wcsph/wcsph_pair.h"

/** `size` of boundary particles between the sides, 0 of those beyond, which stand for the image of an obstacle: their normals
 *  are not those of that. */
SPH2D__INLINE sph2d__lanes within(const sph2d__system *s, const uint32_t *b, sph2d__lanes size)
{
    const sph2d__sides *d = &s->frozen->sides;
    const sph2d__lanes x = sph2d__lanes_gather(s->walls.x, b), y = sph2d__lanes_gather(s->walls.y, b);
    size = sph2d__lanes_where(x, sph2d__lanes_all(d->low_x), size);
    size = sph2d__lanes_where(sph2d__lanes_all(d->high_x), x, size);
    size = sph2d__lanes_where(y, sph2d__lanes_all(d->low_y), size);
    return sph2d__lanes_where(sph2d__lanes_all(d->high_y), y, size);
}

/** Q of the walls in slots from k on. In inner corners walls also press across the largest eigenvalue's direction, as far as
 *  liquid presses against them: of the far wall of a corner a particle sees little, so that by normals alone it had a small
 *  part of its force on liquid at rest, and what is in the corner bore the rest, up to 3.7 rho g H. A corner is an inner one
 *  where the surface of walls goes back where their normals go on. Around edges walls press along the sum of their
 *  gradients, of which what is along t is no more than liquid presses against: by normals alone liquid around the edge,
 *  which they do not balance, drew particles along the faces with all of its pressure, into a tank through an opening in
 *  its side, and a body floated half a spacing too high. Across that sum they have no force, since liquid that slides
 *  along a face would be held. */
SPH2D__INLINE symmetric directions_of(const sph2d__system *s, size_t first, size_t k, uint32_t slots)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__frozen *z = s->frozen;
    const sph2d__lanes none = {0}, one = sph2d__lanes_all(1);
    symmetric q = {0};
    sph2d__lanes wx = {0}, wy = {0}, weight = {0}, nx_mean = {0}, ny_mean = {0}, x = {0}, y = {0}, bend = {0};
    for (uint32_t slot = 0; slot < slots; ++slot, k += SPH2D__LANES) {
        const sph2d__lanes gx = sph2d__floats_load(z->gx + k), gy = sph2d__floats_load(z->gy + k);
        const sph2d__lanes size = sph2d__lanes_sqrt(gx * gx + gy * gy);
        const sph2d__lanes nx = sph2d__lanes_gather(s->walls.normal_x, n->index + k),
                           ny = sph2d__lanes_gather(s->walls.normal_y, n->index + k);
        const sph2d__lanes blunt = size * sph2d__lanes_where(0.5 - nx * nx - ny * ny, none, one);
        q.xx += size * nx * nx + blunt;
        q.xy += size * nx * ny;
        q.yy += size * ny * ny + blunt;
        wx += gx;
        wy += gy;
        const sph2d__lanes rx = sph2d__floats_load(z->rx + k), ry = sph2d__floats_load(z->ry + k);
        const sph2d__lanes depth = sph2d__lanes_gather(s->walls.depth, n->index + k);
        const sph2d__lanes ox = sph2d__lanes_where(size, none, depth * nx - rx),
                           oy = sph2d__lanes_where(size, none, depth * ny - ry);
        const sph2d__lanes in = within(s, n->index + k, size);
        weight += in;
        nx_mean += in * nx;
        ny_mean += in * ny;
        x += in * ox;
        y += in * oy;
        bend += in * (nx * ox + ny * oy);
    }
    const sph2d__lanes half = 0.5 * (q.xx - q.yy), mean = 0.5 * (q.xx + q.yy);
    const sph2d__lanes root = sph2d__lanes_sqrt(half * half + q.xy * q.xy), largest = mean + root;
    const sph2d__lanes unit = sph2d__lanes_where(largest, none, 1 / largest),
                       apart = sph2d__lanes_where(root, none, 0.5 / root);
    /* t t^T, with t across the direction of the largest eigenvalue */
    const symmetric t = {0.5 - apart * half, -apart * q.xy, 0.5 + apart * half};
    const sph2d__lanes bxx = sph2d__lanes_load(z->bxx + first), bxy = sph2d__lanes_load(z->bxy + first),
                       byy = sph2d__lanes_load(z->byy + first);
    const sph2d__lanes lx = sph2d__lanes_load(z->nx + first), ly = sph2d__lanes_load(z->ny + first);
    const sph2d__lanes ax = bxx * wx + bxy * wy, ay = bxy * wx + byy * wy;
    const sph2d__lanes px = bxx * lx + bxy * ly, py = bxy * lx + byy * ly;
    const sph2d__lanes walls = t.xx * ax * ax + 2 * t.xy * ax * ay + t.yy * ay * ay;
    const sph2d__lanes liquid = -(t.xx * ax * px + t.xy * (ax * py + ay * px) + t.yy * ay * py);
    const sph2d__lanes balanced = sph2d__lanes_where(
        walls, none, sph2d__lanes_max(sph2d__lanes_min(liquid / walls, one), none)); /* of what walls have along t */
    const sph2d__lanes inner = sph2d__lanes_where(nx_mean * x + ny_mean * y, bend * weight, one);
    /* not more than those have whose normals are that way: flat walls and slits have none */
    const sph2d__lanes most = sph2d__lanes_where(walls, none, (mean - root) / sph2d__lanes_sqrt(walls));
    const sph2d__lanes more = inner * sph2d__lanes_max(sph2d__lanes_min(balanced, most) - unit * (mean - root), none);
    const sph2d__lanes ex = wx - (one - balanced) * (t.xx * wx + t.xy * wy),
                       ey = wy - (one - balanced) * (t.xy * wx + t.yy * wy);
    const sph2d__lanes e2 = ex * ex + ey * ey, edge = (one - inner) * sph2d__lanes_where(e2, none, 1 / e2);
    return (symmetric){inner * unit * q.xx + more * t.xx + edge * ex * ex,
                       inner * unit * q.xy + more * t.xy + edge * ex * ey,
                       inner * unit * q.yy + more * t.yy + edge * ey * ey};
}

/** Finds the walls that particles are in front of: those at their foot, no more than a spacing away, or a sheet would stop
 *  what falls past its end. */
SPH2D__INLINE void find_front(const sph2d__system *s, size_t first, size_t k, uint32_t slots)
{
    const sph2d__store *w = &s->walls;
    sph2d__frozen *z = s->frozen;
    const sph2d__lanes none = {0};
    sph2d__lanes weight = {0}, away = {0}, x = {0}, y = {0}, vx = {0}, vy = {0};
    for (uint32_t slot = 0; slot < slots; ++slot, k += SPH2D__LANES) {
        const uint32_t *b = s->neighbours.index + k;
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
SPH2D__INLINE void finish_walls(const sph2d__system *s, size_t first, const sph2d__slice *at)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__store *w = &s->walls;
    sph2d__frozen *z = s->frozen;
    const sph2d__lanes bxx = sph2d__lanes_load(z->bxx + first), bxy = sph2d__lanes_load(z->bxy + first),
                       byy = sph2d__lanes_load(z->byy + first), none = {0};
    sph2d__lanes sx = {0}, sy = {0}, rate = {0}, tx = {0}, ty = {0}, away = {0}, weight = {0};
    size_t k = at->begin + (size_t)at->fluid * SPH2D__LANES;
    find_front(s, first, k, at->walls);
    const symmetric q = directions_of(s, first, k, at->walls);
    sph2d__lanes_store(z->wall_xx + first, q.xx);
    sph2d__lanes_store(z->wall_xy + first, q.xy);
    sph2d__lanes_store(z->wall_yy + first, q.yy);
    for (uint32_t slot = 0; slot < at->walls; ++slot, k += SPH2D__LANES) {
        const uint32_t *b = n->index + k;
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
