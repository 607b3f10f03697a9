/* SPDX-License-Identifier: MIT */
/** @file wcsph_finish.h
 *  What its sums make of a particle: B, A, C, N, slopes, the way by shifting, and what the neighbours say of its density
 *  (wcsph.h). Every lane is a particle. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_FINISH_H
#define SPH2D_METHODS_WCSPH_WCSPH_FINISH_H

#include "kernels/kernel.h"
#include "methods/wcsph/wcsph_pair.h"

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
    sph2d__lanes around; /* sum |G . n| of what is seen behind the face, past its end */
    sph2d__lanes ex, ey; /* G of what is behind, less what walls have in its place */
} wall_sums;

/** a in lanes where left > right, b in the others. */
SPH2D__INLINE sph2d__lanes pick(sph2d__lanes left, sph2d__lanes right, sph2d__lanes a, sph2d__lanes b)
{
    return sph2d__lanes_where(left, right, a) + (b - sph2d__lanes_where(left, right, b));
}

/** As much as it is, from 0 to 1. */
SPH2D__INLINE sph2d__lanes clamp(sph2d__lanes a)
{
    return sph2d__lanes_max(sph2d__lanes_min(a, sph2d__lanes_all(1)), (sph2d__lanes){0});
}

SPH2D__INLINE sph2d__lanes det_of(symmetric m)
{
    return m.xx * m.yy - m.xy * m.xy;
}

/** The inverse of a matrix whose determinant is at least `least`, which turns into 1 below that (Ren et al. 2023). */
SPH2D__INLINE symmetric inverse_of(symmetric m, double least)
{
    const sph2d__lanes det = det_of(m), tiny = sph2d__lanes_all(1e-6);
    const sph2d__lanes part = sph2d__lanes_where(det, tiny, sph2d__lanes_min(det / least, sph2d__lanes_all(1))),
                       share = sph2d__lanes_where(det, tiny, part / det);
    return (symmetric){share * m.yy + 1 - part, -share * m.xy, share * m.xx + 1 - part};
}

/** B with eigenvalues whose difference over their sum is at most `most`. What M^-1 makes of a place where particles lie in
 *  strings is pressed no more than what lies evenly: it stays, flow adds to it, and density by D, which is not that of
 *  where particles are, lets the liquid shrink as they get into order again. Without a limit a tank after a dam break had
 *  0.85 of its area after 40 s, and what it fell drove it. The first row below a flat surface needs its own, 0.16: with 0.1
 *  a wave keeps 0.82 in ten periods, with 0.2 liquid between slopes still shrinks. */
SPH2D__INLINE symmetric evened(symmetric b, double most)
{
    const sph2d__lanes mean = 0.5 * (b.xx + b.yy), half = 0.5 * (b.xx - b.yy),
                       apart = sph2d__lanes_sqrt(half * half + b.xy * b.xy), limit = most * mean;
    const sph2d__lanes part = pick(apart, limit, limit / apart, sph2d__lanes_all(1));
    return (symmetric){mean + part * half, part * b.xy, mean - part * half};
}

/** How much of B is left beside a wall that fills so much of the support: from 1 down to 0. */
SPH2D__INLINE sph2d__lanes left_beside(sph2d__lanes filled)
{
    const sph2d__lanes s = sph2d__lanes_max(1 - filled, (sph2d__lanes){0});
    return s * s * (3 - 2 * s);
}

/** s, the part of the kernel that a surface leaves, by K/Sigma. */
SPH2D__INLINE sph2d__lanes left_by_surface(const sph2d__frozen *z, sph2d__lanes near)
{
    sph2d__lanes left;
    for (int l = 0; l < SPH2D__LANES; ++l) {
        const double at = SPH2D__FREE_PARTS * fmin(SPH2D__LANE(near, l) / z->nearness, 1);
        const int k = at < SPH2D__FREE_PARTS ? (int)at : SPH2D__FREE_PARTS - 1;
        SPH2D__LANE(left, l) = z->left[k] + (at - k) * (z->left[k + 1] - z->left[k]);
    }
    return left;
}

/* The least determinant of F of which A is the inverse, and by which pressure is continued into walls. */
SPH2D__FIXED double LEAST_FLUID = 0.15;
/* det F from which on, and up to which, dissipation sets in that vanishes for linear fields: none beside walls and at
 * surfaces, where it would slow down a body that floats. From 0.8 on walls keep twice the noise at rest. */
SPH2D__FIXED double SMOOTH_FROM = 0.6, SMOOTH_TO = 1;

/** rho/rho0 of its logarithm, as sph2d__density_ratio. */
SPH2D__INLINE sph2d__lanes density_of(sph2d__lanes theta)
{
    const sph2d__lanes x = 0.25 * theta;
    sph2d__lanes sum = sph2d__lanes_all(1);
    for (int k = 14; k > 0; --k)
        sum = 1 + x * (1.0 / k) * sum;
    return sum * sum * (sum * sum);
}

/** How far density is from what the neighbours say, over rest density: their sum over that of a lattice is `sum`, of which
 *  a surface leaves `left`; det is that of M. */
SPH2D__INLINE sph2d__lanes summed_apart(sph2d__lanes density, sph2d__lanes sum, sph2d__lanes left, sph2d__lanes det)
{
    const sph2d__lanes none = {0}, full = sum / left;
    const sph2d__lanes least = sph2d__lanes_max(sum, sph2d__lanes_min(full, sph2d__lanes_all(1)));
    return sph2d__lanes_max(least - density, none) +
           clamp(det * (1 / SPH2D__LEAST)) * sph2d__lanes_min(full - density, none);
}

/* Diffusivity of particles over S H^2, and the largest times the step over H^2. */
SPH2D__FIXED double SHIFTING = 2.5, MOST_SHIFT = 0.1;

/** Shifts particles to where fewer are, as far as shear brings them out of order: in liquid without a surface, where
 *  particles that flow past each other for ever line up, and voids open where pressure is below zero. Beside surfaces it
 *  took 8 % of a wave in ten periods, and held liquid behind a circle. */
SPH2D__INLINE void shift(const sph2d__system *s, size_t first, sph2d__lanes strain, sph2d__lanes cx, sph2d__lanes cy)
{
    sph2d__frozen *z = s->frozen;
    const double h2 = s->fills ? s->support * s->support : 0;
    const sph2d__lanes part = sph2d__lanes_min(SHIFTING * s->step * strain, sph2d__lanes_all(MOST_SHIFT));
    sph2d__lanes_store(z->shift_x + first, -h2 * part * cx);
    sph2d__lanes_store(z->shift_y + first, -h2 * part * cy);
}

/** Slopes of velocity by the liquid and its images, of density by the liquid alone. Returns the rate of strain, S. */
SPH2D__INLINE sph2d__lanes find_slopes(sph2d__frozen *z, size_t first, const sums *f, const sums *all, symmetric a,
                                       symmetric alone, sph2d__lanes walled)
{
    const sph2d__lanes vx_x = a.xx * all->uxx + a.xy * all->uxy, vx_y = a.xy * all->uxx + a.yy * all->uxy,
                       vy_x = a.xx * all->vxx + a.xy * all->vxy, vy_y = a.xy * all->vxx + a.yy * all->vxy;
    sph2d__four_store(z->slope + 4 * first, (sph2d__four){vx_x, 0.5 * (vx_y + vy_x), vy_y, walled});
    sph2d__four_store(z->bend + 4 * first,
                      (sph2d__four){alone.xx * f->px + alone.xy * f->py, alone.xy * f->px + alone.yy * f->py,
                                    0.5 * (vx_y - vy_x), (sph2d__lanes){0}});
    const sph2d__lanes stretch = vx_x - vy_y, shear = vx_y + vy_x;
    return sph2d__lanes_sqrt(stretch * stretch + shear * shear);
}

/** C = -B (M - F) A. */
SPH2D__INLINE void find_turn(sph2d__frozen *z, size_t first, symmetric b, symmetric wall, symmetric a,
                             sph2d__lanes walled)
{
    const sph2d__lanes txx = -walled * (b.xx * wall.xx + b.xy * wall.xy),
                       txy = -walled * (b.xx * wall.xy + b.xy * wall.yy),
                       tyx = -walled * (b.xy * wall.xx + b.yy * wall.xy),
                       tyy = -walled * (b.xy * wall.xy + b.yy * wall.yy);
    sph2d__lanes_store(z->cxx + first, txx * a.xx + txy * a.xy);
    sph2d__lanes_store(z->cxy + first, txx * a.xy + txy * a.yy);
    sph2d__lanes_store(z->cyx + first, tyx * a.xx + tyy * a.xy);
    sph2d__lanes_store(z->cyy + first, tyx * a.xy + tyy * a.yy);
}

SPH2D__INLINE void keep(SPH2D__ARRAY double *xx, SPH2D__ARRAY double *xy, SPH2D__ARRAY double *yy, size_t first,
                        symmetric m)
{
    sph2d__lanes_store(xx + first, m.xx);
    sph2d__lanes_store(xy + first, m.xy);
    sph2d__lanes_store(yy + first, m.yy);
}

/** What walls set, and what is summed up over the step. */
#define SPH2D__CLEARED(X)                                                                                              \
    X(push_x)                                                                                                          \
    X(push_y)                                                                                                          \
    X(mean_repelled)                                                                                                   \
    X(wall_xx)                                                                                                         \
    X(wall_xy)                                                                                                         \
    X(wall_yy) X(sx) X(sy) X(wall_rate) X(wall_zx) X(wall_zy) X(wall_linear) X(mean_work) X(mean_ex) X(mean_ey)

/** It is none. */
SPH2D__INLINE void clear(sph2d__frozen *z, size_t first)
{
    const sph2d__lanes none = {0};
#define CLEAR(name) sph2d__lanes_store(z->name + first, none);
    SPH2D__CLEARED(CLEAR)
#undef CLEAR
}

/** The part of M - F by thickened walls that is left for them: M is at most 1 in the mean of its directions. Boundary particles
 *  in a tip that ends in nothing are few and press much more, all of it near the particle. */
SPH2D__INLINE sph2d__lanes fitting(const symmetric *fluid, const symmetric *thick, const wall_sums *walls)
{
    const sph2d__lanes none = {0}, trace = thick->xx + thick->yy,
                       most = sph2d__lanes_max(2 - fluid->xx - fluid->yy, walls->xx + walls->yy);
    return clamp(sph2d__lanes_where(trace, none, most / trace));
}

SPH2D__INLINE wall_sums sum_of(const wall_sums *a, const wall_sums *b)
{
    return (wall_sums){.value = a->value + b->value,
                       .xx = a->xx + b->xx,
                       .xy = a->xy + b->xy,
                       .yy = a->yy + b->yy,
                       .gx = a->gx + b->gx,
                       .gy = a->gy + b->gy,
                       .kx = a->kx + b->kx,
                       .ky = a->ky + b->ky};
}

/** Sums of the liquid alone, f, with its images, of walls, of the liquid behind them, and M - F by walls as
 *  thick as they press. */
SPH2D__INLINE void finish(const sph2d__system *s, size_t first, const sums *f, const sums *all, const wall_sums *walls,
                          const wall_sums *behind, symmetric thick, sph2d_kernel kernel)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__lanes none = {0}, one = sph2d__lanes_all(1);
    const wall_sums w = sum_of(walls, behind);
    const symmetric fluid = {f->xx, f->xy, f->yy}, wall = {w.xx, w.xy, w.yy}, seen = {all->xx, all->xy, all->yy};
    const symmetric both = {seen.xx + wall.xx, seen.xy + wall.xy, seen.yy + wall.yy};
    const double ratio = s->spacing / s->support;
    const sph2d__lanes filled = w.value * (sph2d__kernel_constant(kernel) * ratio * ratio),
                       beside = left_beside(filled);
    const symmetric m = inverse_of(both, SPH2D__LEAST);
    const symmetric b = evened((symmetric){1 + beside * (m.xx - 1), beside * m.xy, 1 + beside * (m.yy - 1)}, z->uneven);
    const symmetric a = inverse_of(seen, LEAST_FLUID), alone = inverse_of(fluid, LEAST_FLUID);
    const sph2d__lanes det = det_of(seen), reach = clamp((det - SMOOTH_FROM) * (1 / (SMOOTH_TO - SMOOTH_FROM)));
    const sph2d__lanes walled =
        sph2d__lanes_where(w.value, none, sph2d__lanes_where(det, sph2d__lanes_all(LEAST_FLUID), one));
    const sph2d__lanes strain = find_slopes(z, first, f, all, a, alone, walled);
    shift(s, first, strain, all->gx + w.gx, all->gy + w.gy);
    const sph2d__lanes turned = walled * fitting(&seen, &thick, walls);
    find_turn(z, first, b, thick, a, turned);
    const sph2d__lanes kx = all->kx + w.kx, ky = all->ky + w.ky;
    const sph2d__lanes sum = (sph2d__kernel_value_at(kernel, 0) + all->value + w.value) * (1 / s->lattice_values);
    const sph2d__lanes left = s->fills ? one : left_by_surface(z, sph2d__lanes_sqrt(kx * kx + ky * ky) / sum);
    sph2d__lanes_store(z->summed + first, summed_apart(density_of(sph2d__lanes_load(s->fluid.log_density + first)), sum,
                                                       left, det_of(both)));
    sph2d__lanes_store(z->smooth + first, reach * reach * (3 - 2 * reach));
    sph2d__lanes_store(z->walled + first, turned);
    keep(z->axx, z->axy, z->ayy, first, a);
    keep(z->bxx, z->bxy, z->byy, first, b);
    sph2d__lanes_store(z->nx + first, all->gx);
    sph2d__lanes_store(z->ny + first, all->gy);
    sph2d__lanes_store(z->image_nx + first, all->gx - f->gx);
    sph2d__lanes_store(z->image_ny + first, all->gy - f->gy);
    clear(z, first);
}

#endif
