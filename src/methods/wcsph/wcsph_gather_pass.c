/* SPDX-License-Identifier: MIT */
/** @file wcsph_gather_pass.c
 *  Finds the neighbours of method `wcsph`, and sums what stands still over a step. Compiled
 *  once for each instruction set, named by SPH2D__ISA, and in it once for each kernel. Every lane is a particle. */
#include <math.h>

#include "kernels/kernel.h"
#include "methods/common/shortest.h"
#include "methods/common/slices.h"
#include "methods/wcsph/wcsph_pair.h"

/** A symmetric matrix. */
typedef struct symmetric {
    double xx, xy, yy;
} symmetric;

/** Sums over the pairs of a slice. */
typedef struct sums {
    sph2d__lanes x, y, vx, vy, theta; /* of the particles */
    sph2d__lanes value;               /* f(q), 1 for the weight of a particle of the liquid */
    sph2d__lanes xx, xy, yy, gx, gy;  /* -G r^T and G */
    sph2d__lanes uxx, uxy, vxx, vxy;  /* (v_j - v_i) G^T */
    sph2d__lanes px, py;              /* (theta_j - theta_i) G */
    sph2d__lanes kx, ky;              /* G |r| */
} sums;

/** What walls add. */
typedef struct wall_sums {
    sph2d__lanes value, xx, xy, yy, gx, gy, kx, ky;
} wall_sums;

/** Sums over images: the weight of those beyond sides along x and along y, as the kernel has it. */
typedef struct image_sums {
    sph2d__lanes x, y;
} image_sums;

SPH2D__INLINE image_sums sum_images(const sph2d__system *s, size_t begin, uint32_t slots, sph2d_kernel kernel)
{
    const sph2d__frozen *z = s->frozen;
    const double ratio = s->spacing / s->support, scale = sph2d__kernel_constant(kernel) * ratio * ratio;
    image_sums sum = {0};
    for (size_t k = begin; k < begin + (size_t)slots * SPH2D__LANES; k += SPH2D__LANES) {
        const uint32_t *j = s->neighbours.index + k;
        const sph2d__float2 r = sph2d__float2_load(z->linear + k);
        const sph2d__lanes rx = sph2d__float2_x(r), ry = sph2d__float2_y(r);
        const sph2d__lanes value =
            scale * sph2d__kernel_value(kernel, sph2d__lanes_sqrt(rx * rx + ry * ry) * (1 / s->support));
        sum.x += value * sph2d__lanes_gather(z->across_x, j);
        sum.y += value * sph2d__lanes_gather(z->across_y, j);
    }
    return sum;
}

/* (|G| H)^2 of pairs that are none: at the end of the support, or what a list ends with. */
static const double NO_PAIR = 1e-20;

/** Keeps the gradients of a slice's pairs with one store and, for the time being, their distances; returns the sum of their
 *  kernels. In a loop of its own: GCC 12 with -O3 drops conversions to float and back that are in sight. */
SPH2D__INLINE sph2d__lanes keep_pairs(const sph2d__system *s, const sums *own, const sph2d__store *from, size_t at,
                                      uint32_t slots, sph2d_kernel kernel)
{
    const sph2d__period *period = &s->fluid_cells.period;
    const double h2 = s->support * s->support, scale = sph2d__kernel_constant(kernel) / (h2 * h2);
    const double volume = s->mass / s->rest_density;
    const bool walls = from == &s->walls;
    const sph2d__lanes least = sph2d__lanes_all(NO_PAIR / (s->support * s->support));
    sph2d__lanes value = {0}, weight = sph2d__lanes_all(1);
    for (size_t k = at; k < at + (size_t)slots * SPH2D__LANES; k += SPH2D__LANES) {
        const uint32_t *j = s->neighbours.index + k;
        const sph2d__lanes dx = sph2d__shortest(own->x - sph2d__lanes_gather(from->x, j), period->length_x);
        const sph2d__lanes dy = sph2d__shortest(own->y - sph2d__lanes_gather(from->y, j), period->length_y);
        const sph2d__lanes r2 = dx * dx + dy * dy, q = sph2d__lanes_sqrt(r2) * (1 / s->support);
        if (walls)
            weight = sph2d__lanes_gather(s->frozen->part, j) * sph2d__lanes_gather(from->mass, j) * (1 / s->mass);
        sph2d__lanes slope = volume * scale * weight * sph2d__kernel_slope(kernel, q);
        slope = sph2d__lanes_where(slope * slope * r2, least, slope);
        value += weight * sph2d__kernel_value(kernel, q);
        sph2d__float2_store(s->neighbours.gradient + k, sph2d__float2_of(slope * dx, slope * dy));
        sph2d__float2_store(s->frozen->linear + k, sph2d__float2_of(dx, dy));
    }
    return value;
}

/** Sums over the fluid's slots. */
SPH2D__INLINE void sum_fluid(const sph2d__system *s, size_t begin, uint32_t slots, sph2d_kernel kernel, sums *to)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__store *f = &s->fluid;
    sums sum = *to;
    sum.value += keep_pairs(s, &sum, f, begin, slots, kernel);
    for (size_t k = begin; k < begin + (size_t)slots * SPH2D__LANES; k += SPH2D__LANES) {
        const uint32_t *j = n->index + k;
        const sph2d__float2 g = sph2d__float2_load(n->gradient + k), r = sph2d__float2_load(s->frozen->linear + k);
        const sph2d__lanes gx = sph2d__float2_x(g), gy = sph2d__float2_y(g), rx = sph2d__float2_x(r),
                           ry = sph2d__float2_y(r);
        const sph2d__lanes ux = sph2d__lanes_gather(f->vx, j) - sum.vx, uy = sph2d__lanes_gather(f->vy, j) - sum.vy;
        const sph2d__lanes jump = sph2d__lanes_gather(f->excess, j) - sum.theta;
        const sph2d__lanes r1 = sph2d__lanes_sqrt(rx * rx + ry * ry);
        sum.gx += gx;
        sum.gy += gy;
        sum.xx -= gx * rx;
        sum.xy -= gx * ry;
        sum.yy -= gy * ry;
        sum.uxx += ux * gx;
        sum.uxy += ux * gy;
        sum.vxx += uy * gx;
        sum.vxy += uy * gy;
        sum.px += jump * gx;
        sum.py += jump * gy;
        sum.kx += r1 * gx;
        sum.ky += r1 * gy;
    }
    *to = sum;
}

SPH2D__INLINE void sum_walls(const sph2d__system *s, const sph2d__slice *at, const sums *own, sph2d_kernel kernel,
                             wall_sums *to)
{
    const size_t begin = at->begin + (size_t)at->fluid * SPH2D__LANES;
    wall_sums sum = *to;
    sum.value = keep_pairs(s, own, &s->walls, begin, at->walls, kernel);
    for (size_t k = begin; k < begin + (size_t)at->walls * SPH2D__LANES; k += SPH2D__LANES) {
        const sph2d__float2 g = sph2d__float2_load(s->neighbours.gradient + k),
                            r = sph2d__float2_load(s->frozen->linear + k);
        const sph2d__lanes gx = sph2d__float2_x(g), gy = sph2d__float2_y(g), rx = sph2d__float2_x(r),
                           ry = sph2d__float2_y(r), r1 = sph2d__lanes_sqrt(rx * rx + ry * ry);
        sum.xx -= gx * rx;
        sum.xy -= gx * ry;
        sum.yy -= gy * ry;
        sum.gx += gx;
        sum.gy += gy;
        sum.kx += r1 * gx;
        sum.ky += r1 * gy;
    }
    *to = sum;
}

/** Writes the slots of pairs that may come close during the step. */
SPH2D__INLINE uint32_t write_close(sph2d__system *s, sph2d__pairs *to, const sph2d__slice *at)
{
    sph2d__neighbours *n = &s->neighbours;
    const double limit2 = s->frozen->apart * s->frozen->apart;
    to->most = 0;
    for (size_t l = 0; l < SPH2D__LANES; ++l) {
        uint32_t *found = to->found + l * to->longest, count = 0;
        size_t k = at->begin + l;
        for (uint32_t slot = 0; slot < at->fluid; ++slot, k += SPH2D__LANES) {
            float r[2];
            memcpy(r, s->frozen->linear + k, sizeof r);
            if ((double)r[0] * (double)r[0] + (double)r[1] * (double)r[1] < limit2)
                found[count++] = n->index[k];
        }
        to->counts[l] = count;
        to->most = count > to->most ? count : to->most;
    }
    return sph2d__pairs_write(n, to, s->fluid.count);
}

/* ---- what becomes of a particle ---------------------------------------------------------------------------------- */

/** The inverse of a matrix whose determinant is at least `least`, which turns into 1 below that (Ren et al. 2023). */
static symmetric inverse_of(symmetric m, double least)
{
    const double det = m.xx * m.yy - m.xy * m.xy;
    if (!(det > 1e-6))
        return (symmetric){1, 0, 1};
    const double part = det >= least ? 1 : det / least, share = part / det;
    return (symmetric){share * m.yy + 1 - part, -share * m.xy, share * m.xx + 1 - part};
}

/** B with eigenvalues whose difference over their sum is at most `most`. What M^-1 makes of a place where particles lie in
 *  strings is pressed no more than what lies evenly: it stays, flow adds to it, and density by D, which is not that of
 *  where particles are, lets the liquid shrink as they get into order again. Without a limit a tank after a dam break had
 *  0.85 of its area after 40 s, and what it fell drove it. The first row below a flat surface needs its own, 0.16: with 0.1
 *  a wave keeps 0.82 in ten periods, with 0.2 liquid between slopes still shrinks. */
static symmetric evened(symmetric b, double most)
{
    const double mean = (b.xx + b.yy) / 2, half = (b.xx - b.yy) / 2, apart = sqrt(half * half + b.xy * b.xy);
    const double part = apart > most * mean ? most * mean / apart : 1;
    return (symmetric){mean + part * half, part * b.xy, mean - part * half};
}

/** How much of B is left beside a wall that fills so much of the support: from 1 down to 0. */
static double left_beside(double filled)
{
    const double s = fmax(1 - filled, 0);
    return s * s * (3 - 2 * s);
}

/** A symmetric matrix in each lane. */
typedef struct symmetric_lanes {
    sph2d__lanes xx, xy, yy;
} symmetric_lanes;

/** Q of the walls in slots from k on. In inner corners walls also press across the largest eigenvalue's direction, as far as
 *  liquid presses against them: of the far wall of a corner a particle sees little, so that by normals alone it had a small
 *  part of its force on liquid at rest, and what is in the corner bore the rest, up to 3.7 rho g H. A corner is an inner one
 *  where the surface of walls goes back where their normals go on. Around edges walls press along the sum of their
 *  gradients, of which what is along t is no more than liquid presses against: by normals alone liquid around the edge,
 *  which they do not balance, drew particles along the faces with all of its pressure, into a tank through an opening in
 *  its side, and a body floated half a spacing too high. Across that sum they have no force, since liquid that slides
 *  along a face would be held. */
SPH2D__INLINE symmetric_lanes directions_of(const sph2d__system *s, size_t first, size_t k, uint32_t slots)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__frozen *z = s->frozen;
    const sph2d__sides *d = &z->sides;
    const sph2d__lanes none = {0}, one = sph2d__lanes_all(1);
    symmetric_lanes q = {0};
    sph2d__lanes wx = {0}, wy = {0}, weight = {0}, nx_mean = {0}, ny_mean = {0}, x = {0}, y = {0}, bend = {0};
    for (uint32_t slot = 0; slot < slots; ++slot, k += SPH2D__LANES) {
        const sph2d__float2 g = sph2d__float2_load(n->gradient + k);
        const sph2d__lanes gx = sph2d__float2_x(g), gy = sph2d__float2_y(g);
        const sph2d__lanes size = sph2d__lanes_sqrt(gx * gx + gy * gy);
        const sph2d__lanes nx = sph2d__lanes_gather(s->walls.normal_x, n->index + k),
                           ny = sph2d__lanes_gather(s->walls.normal_y, n->index + k);
        const sph2d__lanes blunt = size * sph2d__lanes_where(0.5 - nx * nx - ny * ny, none, one);
        q.xx += size * nx * nx + blunt;
        q.xy += size * nx * ny;
        q.yy += size * ny * ny + blunt;
        wx += gx;
        wy += gy;
        const sph2d__float2 r = sph2d__float2_load(z->linear + k);
        const sph2d__lanes depth = sph2d__lanes_gather(s->walls.depth, n->index + k);
        const sph2d__lanes ox = sph2d__lanes_where(size, none, depth * nx - sph2d__float2_x(r)),
                           oy = sph2d__lanes_where(size, none, depth * ny - sph2d__float2_y(r));
        /* beyond a side they stand for the image of an obstacle, which their normals are not those of */
        const sph2d__lanes bx = sph2d__lanes_gather(s->walls.x, n->index + k),
                           by = sph2d__lanes_gather(s->walls.y, n->index + k);
        sph2d__lanes in = sph2d__lanes_where(bx, sph2d__lanes_all(d->low_x), size);
        in = sph2d__lanes_where(sph2d__lanes_all(d->high_x), bx, in);
        in = sph2d__lanes_where(by, sph2d__lanes_all(d->low_y), in);
        in = sph2d__lanes_where(sph2d__lanes_all(d->high_y), by, in);
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
    const symmetric_lanes t = {0.5 - apart * half, -apart * q.xy, 0.5 + apart * half};
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
    return (symmetric_lanes){inner * unit * q.xx + more * t.xx + edge * ex * ex,
                             inner * unit * q.xy + more * t.xy + edge * ex * ey,
                             inner * unit * q.yy + more * t.yy + edge * ey * ey};
}

/** Finds the walls that particles are in front of. */
SPH2D__INLINE void find_front(const sph2d__system *s, size_t first, size_t k, uint32_t slots)
{
    const sph2d__store *w = &s->walls;
    sph2d__frozen *z = s->frozen;
    const sph2d__lanes none = {0};
    sph2d__lanes weight = {0}, away = {0}, x = {0}, y = {0}, vx = {0}, vy = {0};
    for (uint32_t slot = 0; slot < slots; ++slot, k += SPH2D__LANES) {
        const uint32_t *b = s->neighbours.index + k;
        const sph2d__float2 g = sph2d__float2_load(s->neighbours.gradient + k), r = sph2d__float2_load(z->linear + k);
        const sph2d__lanes gx = sph2d__float2_x(g), gy = sph2d__float2_y(g);
        const sph2d__lanes nx = sph2d__lanes_gather(w->normal_x, b), ny = sph2d__lanes_gather(w->normal_y, b);
        const sph2d__lanes before =
            sph2d__float2_x(r) * nx + sph2d__float2_y(r) * ny - sph2d__lanes_gather(w->depth, b);
        const sph2d__lanes size = sph2d__lanes_where(before, none, sph2d__lanes_sqrt(gx * gx + gy * gy));
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
    const symmetric_lanes q = directions_of(s, first, k, at->walls);
    sph2d__lanes_store(z->wall_xx + first, q.xx);
    sph2d__lanes_store(z->wall_xy + first, q.xy);
    sph2d__lanes_store(z->wall_yy + first, q.yy);
    for (uint32_t slot = 0; slot < at->walls; ++slot, k += SPH2D__LANES) {
        const uint32_t *b = n->index + k;
        const sph2d__float2 g = sph2d__float2_load(n->gradient + k), r = sph2d__float2_load(z->linear + k);
        const sph2d__lanes gx = sph2d__float2_x(g), gy = sph2d__float2_y(g), rx = sph2d__float2_x(r),
                           ry = sph2d__float2_y(r);
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
    const sph2d__float2 v = sph2d__float2_load(z->slope_v + first), u = sph2d__float2_load(z->slope_w + first);
    const sph2d__lanes stretch =
        sph2d__float2_x(v) * sx * sx + 2 * sph2d__float2_y(v) * sx * sy + sph2d__float2_x(u) * sy * sy;
    const sph2d__lanes distance = sph2d__lanes_where(weight, none, away / weight);
    sph2d__lanes_store(z->wall_linear + first, sph2d__lanes_where(size2, none, -2 * distance * stretch / size2));
}

/** s, the part of the kernel that a surface leaves, by K/Sigma. */
static double left_by_surface(const sph2d__frozen *z, double near)
{
    const double at = SPH2D__FREE_PARTS * fmin(near / z->nearness, 1);
    const int k = at < SPH2D__FREE_PARTS ? (int)at : SPH2D__FREE_PARTS - 1;
    return z->left[k] + (at - k) * (z->left[k + 1] - z->left[k]);
}

/* The least determinants of F for slopes, and for a gradient that continues a pressure into walls. */
static const double LEAST_FLUID = 0.1, LEAST_CONTINUED = 0.15;
/* det F from which on, and up to which, dissipation sets in that vanishes for linear fields: none beside walls and at
 * surfaces, where it would slow down a body that floats. From 0.8 on walls keep twice the noise at rest. */
static const double SMOOTH_FROM = 0.6, SMOOTH_TO = 1;

/** What the neighbours say of density that is not so, over rest density: their sum is `sum` over that of a lattice, of
 *  which `filled` is the walls', and a surface leaves `left`; det is that of M. */
static double summed_apart(const sph2d__frozen *z, double density, double sum, double left, double filled, double det)
{
    const double full = sum / left;
    const double up = sum + (full - sum) * fmax(1 - filled / z->first_row, 0);
    return up > density ? up - density : fmin(fmax(det / SPH2D__LEAST, 0), 1) * fmin(full - density, 0);
}

/* Diffusivity of particles over S H^2, and the largest times the step over H^2. */
static const double SHIFTING = 2.5, MOST_SHIFT = 0.1;

/** Shifts a particle to where fewer are, as far as shear brings them out of order: in liquid without a surface, where
 *  particles that flow past each other for ever line up, and voids open where pressure is below zero. Beside surfaces it
 *  took 8 % of a wave in ten periods, and held liquid behind a circle. */
static void shift(const sph2d__system *s, size_t i, double cx, double cy)
{
    sph2d__frozen *z = s->frozen;
    float v[2], w[2];
    memcpy(v, z->slope_v + i, sizeof v);
    memcpy(w, z->slope_w + i, sizeof w);
    const double stretch = (double)v[0] - (double)w[0], shear = 2 * (double)v[1];
    const double part = fmin(SHIFTING * sqrt(stretch * stretch + shear * shear) * s->step, MOST_SHIFT);
    const double way = -part * s->support * s->support;
    z->shift_x[i] = s->fills ? way * cx : 0;
    z->shift_y[i] = s->fills ? way * cy : 0;
}

static void finish(const sph2d__system *s, size_t i, int l, const sums *f, const sums *all, const wall_sums *w,
                   sph2d_kernel kernel)
{
    sph2d__frozen *z = s->frozen;
    const symmetric fluid = {f->xx[l], f->xy[l], f->yy[l]}, wall = {w->xx[l], w->xy[l], w->yy[l]};
    const symmetric seen = {all->xx[l], all->xy[l], all->yy[l]};
    const symmetric both = {seen.xx + wall.xx, seen.xy + wall.xy, seen.yy + wall.yy};
    const double ratio = s->spacing / s->support;
    const double filled = w->value[l] * sph2d__kernel_constant(kernel) * ratio * ratio, beside = left_beside(filled);
    symmetric b = inverse_of(both, SPH2D__LEAST);
    b = evened((symmetric){1 + beside * (b.xx - 1), beside * b.xy, 1 + beside * (b.yy - 1)}, z->uneven);
    const symmetric a = inverse_of(seen, LEAST_FLUID), alone = inverse_of(fluid, LEAST_FLUID);
    z->slope_v[i] =
        sph2d__pair_of_floats(a.xx * all->uxx[l] + a.xy * all->uxy[l],
                              (a.xy * all->uxx[l] + a.yy * all->uxy[l] + a.xx * all->vxx[l] + a.xy * all->vxy[l]) / 2);
    z->slope_w[i] =
        sph2d__pair_of_floats(a.xy * all->vxx[l] + a.yy * all->vxy[l],
                              (a.xy * all->uxx[l] + a.yy * all->uxy[l] - a.xx * all->vxx[l] - a.xy * all->vxy[l]) / 2);
    const double own = sph2d__kernel_value_at(kernel, 0), kx = all->kx[l] + w->kx[l], ky = all->ky[l] + w->ky[l];
    const double sum = (own + all->value[l] + w->value[l]) / s->lattice_values;
    const double left = s->fills ? 1 : left_by_surface(z, sqrt(kx * kx + ky * ky) / sum);
    z->slope_p[i] =
        sph2d__pair_of_floats(alone.xx * f->px[l] + alone.xy * f->py[l], alone.xy * f->px[l] + alone.yy * f->py[l]);
    const bool walled = filled > 0 && seen.xx * seen.yy - seen.xy * seen.xy > LEAST_CONTINUED;
    const double det = seen.xx * seen.yy - seen.xy * seen.xy,
                 reach = fmax(fmin((det - SMOOTH_FROM) / (SMOOTH_TO - SMOOTH_FROM), 1), 0);
    z->smooth[i] = reach * reach * (3 - 2 * reach);
    shift(s, i, all->gx[l] + w->gx[l], all->gy[l] + w->gy[l]);
    /* C = -B (M - F) A */
    const double c = walled ? -1 : 0;
    const double txx = c * (b.xx * wall.xx + b.xy * wall.xy), txy = c * (b.xx * wall.xy + b.xy * wall.yy);
    const double tyx = c * (b.xy * wall.xx + b.yy * wall.xy), tyy = c * (b.xy * wall.xy + b.yy * wall.yy);
    z->cxx[i] = txx * a.xx + txy * a.xy;
    z->cxy[i] = txx * a.xy + txy * a.yy;
    z->cyx[i] = tyx * a.xx + tyy * a.xy;
    z->cyy[i] = tyx * a.xy + tyy * a.yy;
    z->axx[i] = a.xx;
    z->axy[i] = a.xy;
    z->ayy[i] = a.yy;
    z->bxx[i] = b.xx;
    z->bxy[i] = b.xy;
    z->byy[i] = b.yy;
    z->nx[i] = all->gx[l];
    z->ny[i] = all->gy[l];
    z->image_nx[i] = all->gx[l] - f->gx[l];
    z->image_ny[i] = all->gy[l] - f->gy[l];
    z->push_x[i] = z->push_y[i] = z->mean_repelled[i] = z->wall_xx[i] = z->wall_xy[i] = z->wall_yy[i] = 0;
    z->sx[i] = z->sy[i] = z->wall_rate[i] = z->wall_zx[i] = z->wall_zy[i] = z->wall_linear[i] = 0;
    z->walled[i] = walled;
    z->summed[i] = summed_apart(z, sph2d__density_ratio(s->fluid.excess[i]), sum, left, filled,
                                both.xx * both.yy - both.xy * both.xy);
    z->mean_work[i] = z->mean_ex[i] = z->mean_ey[i] = 0;
}

/** Everything about the particles `first` on of a slice. */
SPH2D__INLINE void gather_slice(sph2d__system *s, sph2d__pairs *to, size_t first, sph2d_kernel kernel)
{
    sph2d__neighbours *n = &s->neighbours;
    const sph2d__store *f = &s->fluid;
    sph2d__slice *at = &n->slices[first / SPH2D__LANES];
    const double h2 = s->support * s->support;
    sums sum = {.x = sph2d__lanes_load(f->x + first),
                .y = sph2d__lanes_load(f->y + first),
                .vx = sph2d__lanes_load(f->vx + first),
                .vy = sph2d__lanes_load(f->vy + first),
                .theta = sph2d__lanes_load(f->excess + first)};
    wall_sums walls = {0};
    *at = (sph2d__slice){.begin = to->next};
    sph2d__pairs_search(to, &to->fluid, &s->fluid_cells, f, f, first, h2, true, NULL);
    at->fluid = sph2d__pairs_write(n, to, f->count);
    sum_fluid(s, at->begin, at->fluid, kernel, &sum);
    sums all = sum;
    image_sums mirrored = {0};
    uint32_t *imaged = &s->frozen->imaged[first / SPH2D__LANES];
    *imaged = 0;
    if (s->frozen->images.count > 0) {
        const size_t start = to->next;
        sph2d__pairs_search(to, &to->images, &s->frozen->image_cells, &s->frozen->images, f, first, h2, false, NULL);
        *imaged = sph2d__pairs_write(n, to, s->frozen->images.count);
        for (size_t k = start; k < start + (size_t)*imaged * SPH2D__LANES; ++k)
            n->index[k] += (uint32_t)s->frozen->first_image;
        sum_fluid(s, start, *imaged, kernel, &all);
        mirrored = sum_images(s, start, *imaged, kernel);
        at->fluid += *imaged;
    }
    if (s->walls_press && s->frozen->sides.first > 0) {
        sph2d__pairs_search(to, &to->walls, &s->wall_cells, &s->walls, f, first, h2, false, NULL);
        at->walls = sph2d__pairs_write(n, to, s->walls.count);
        sum_walls(s, at, &sum, kernel, &walls);
    }
    s->frozen->close[first / SPH2D__LANES] = write_close(s, to, at);
    for (int l = 0; l < SPH2D__LANES && first + (size_t)l < f->count; ++l)
        finish(s, first + (size_t)l, l, &sum, &all, &walls, kernel);
    sph2d__lanes_store(s->frozen->across_x + first, mirrored.x);
    sph2d__lanes_store(s->frozen->across_y + first, mirrored.y);
    if (at->walls > 0)
        finish_walls(s, first, at);
}

/** Gathers for the particles of slab k. False when it is full. */
SPH2D__INLINE bool gather_slab(sph2d__system *s, size_t k, sph2d_kernel kernel)
{
    sph2d__pairs to = sph2d__pairs_start(&s->neighbours, k);
    const size_t count = s->fluid.count, end = (k + 1) * SPH2D__SLAB < count ? (k + 1) * SPH2D__SLAB : count;
    for (size_t i = k * SPH2D__SLAB; i < end && !to.full; i += SPH2D__LANES)
        gather_slice(s, &to, i, kernel);
    return !to.full;
}

/* ---- what is linear ---------------------------------------------------------------------------------------------- */

/** Keeps 1/|G| and r of a slice's pairs. */
SPH2D__INLINE void keep_inverse(const sph2d__system *s, const sph2d__slice *at)
{
    const sph2d__lanes none = {0};
    for (size_t k = at->begin; k < at->begin + (size_t)at->fluid * SPH2D__LANES; k += SPH2D__LANES) {
        const sph2d__float2 g = sph2d__float2_load(s->neighbours.gradient + k);
        const sph2d__lanes gx = sph2d__float2_x(g), gy = sph2d__float2_y(g), g2 = gx * gx + gy * gy;
        const sph2d__float2 apart = sph2d__float2_load(s->frozen->linear + k);
        const sph2d__lanes rx = sph2d__float2_x(apart), ry = sph2d__float2_y(apart);
        const sph2d__lanes inverse = sph2d__lanes_where(g2, none, 1 / sph2d__lanes_sqrt(g2)),
                           distance = sph2d__lanes_where(g2, none, sph2d__lanes_sqrt(rx * rx + ry * ry));
        for (int l = 0; l < SPH2D__LANES; ++l) {
            s->frozen->inverse[k + (size_t)l] = (float)inverse[l];
            s->frozen->distance[k + (size_t)l] = (float)distance[l];
        }
    }
}

/** Sums over a slice's pairs once all slopes are known. */
typedef struct compared {
    sph2d__lanes weight, image_weight, sx, sy; /* of |G|, with images and of them; and |G| r */
    sph2d__lanes walled;                       /* 1 where one of the neighbours is */
} compared;

/** Replaces the distances of a slice's pairs by what is linear in them. */
SPH2D__INLINE compared compare_pairs(const sph2d__system *s, size_t first, const sph2d__slice *at)
{
    const sph2d__neighbours *n = &s->neighbours;
    sph2d__frozen *z = s->frozen;
    const sph2d__float2 v = sph2d__float2_load(z->slope_v + first), w = sph2d__float2_load(z->slope_w + first),
                        p = sph2d__float2_load(z->slope_p + first);
    const sph2d__lanes none = {0};
    const size_t own = at->begin + (size_t)(at->fluid - z->imaged[first / SPH2D__LANES]) * SPH2D__LANES;
    compared sum = {.walled = sph2d__lanes_load(z->walled + first)};
    for (size_t k = at->begin; k < at->begin + (size_t)at->fluid * SPH2D__LANES; k += SPH2D__LANES) {
        const uint32_t *j = n->index + k;
        const sph2d__float2 g = sph2d__float2_load(n->gradient + k), r = sph2d__float2_load(z->linear + k);
        const sph2d__float2 vs = v + sph2d__float2_gather(z->slope_v, j), ws = w + sph2d__float2_gather(z->slope_w, j),
                            ps = p + sph2d__float2_gather(z->slope_p, j);
        const sph2d__lanes gx = sph2d__float2_x(g), gy = sph2d__float2_y(g);
        const sph2d__lanes rx = sph2d__float2_x(r), ry = sph2d__float2_y(r);
        const sph2d__lanes inverse = sph2d__lanes_of_floats(z->inverse + k), size = (gx * gx + gy * gy) * inverse;
        /* e . S r with e = -G/|G| */
        const sph2d__lanes along = gx * (sph2d__float2_x(vs) * rx + sph2d__float2_y(vs) * ry) +
                                   gy * (sph2d__float2_y(vs) * rx + sph2d__float2_x(ws) * ry);
        const sph2d__lanes jump = sph2d__float2_x(ps) * rx + sph2d__float2_y(ps) * ry;
        sph2d__float2_store(z->linear + k, sph2d__float2_of(sph2d__lanes_where(inverse, none, -0.5 * inverse * along),
                                                            sph2d__lanes_where(inverse, none, 0.5 * jump)));
        sum.weight += size;
        if (k >= own)
            sum.image_weight += size;
        sum.sx += sph2d__lanes_where(inverse, none, size * rx);
        sum.sy += sph2d__lanes_where(inverse, none, size * ry);
        sum.walled = sph2d__lanes_max(sum.walled, sph2d__lanes_where(inverse, none, sph2d__lanes_gather(z->walled, j)));
    }
    return sum;
}

SPH2D__INLINE void compare_slice(const sph2d__system *s, size_t first)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__slice *at = &s->neighbours.slices[first / SPH2D__LANES];
    keep_inverse(s, at);
    const compared sum = compare_pairs(s, first, at);
    const sph2d__lanes mean = sph2d__lanes_where(sum.weight, (sph2d__lanes){0}, 1 / sum.weight);
    const sph2d__lanes axy = sph2d__lanes_load(z->axy + first);
    sph2d__lanes_store(z->weight + first, sum.weight);
    sph2d__lanes_store(z->image_weight + first, sum.image_weight);
    sph2d__lanes_store(z->kx + first, mean * (sph2d__lanes_load(z->axx + first) * sum.sx + axy * sum.sy));
    sph2d__lanes_store(z->ky + first, mean * (axy * sum.sx + sph2d__lanes_load(z->ayy + first) * sum.sy));
    int flags = 0;
    for (int l = 0; l < SPH2D__LANES && first + (size_t)l < s->fluid.count; ++l) {
        const size_t i = first + (size_t)l;
        flags |= (z->walled[i] > 0 ? SPH2D__FROZEN_WALLED : 0) | (sum.walled[l] > 0 ? SPH2D__FROZEN_BESIDE : 0);
    }
    z->flags[first / SPH2D__LANES] = (unsigned char)flags;
}

static void compare(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; i += SPH2D__LANES)
        compare_slice(s, i);
}

/* ---- one for every kernel ---------------------------------------------------------------------------------------- */

#define FOR_KERNEL(name, word)                                                                                         \
    static bool gather_##word(sph2d__system *s, size_t k)                                                              \
    {                                                                                                                  \
        return gather_slab(s, k, SPH2D_KERNEL_##name);                                                                 \
    }
SPH2D_KERNEL_MAP(FOR_KERNEL)

#define ENTRY(name, word) [SPH2D_KERNEL_##name] = gather_##word,
const sph2d__wcsph_gather_pass SPH2D__OF_ISA(sph2d__wcsph_gather) = {
    .lanes = SPH2D__LANES, .gather = {SPH2D_KERNEL_MAP(ENTRY)}, .compare = compare};
