/* SPDX-License-Identifier: MIT */
/** @file wcsph_wall_pass.c
 *  Boundary particles of method `wcsph`: pressure and velocity of the liquid in front, carried on behind the surface.
 *  Compiled once for each instruction set, named by SPH2D__ISA, and in it once for each kernel. */
#include "kernels/kernel.h"
#include "methods/state_equation.h"
#include "methods/wcsph.h"
#include "methods/wcsph_pair.h"

/** Sums over the liquid around a boundary particle, weighted by the kernel. */
typedef struct wall_sums {
    sph2d__lanes weight, pressure, weight_x, weight_y, vx, vy;
} wall_sums;

/** The velocity of the liquid behind the surface: what is in front, reflected at a smooth wall, turned round at a rough
 *  one and in corners, which have no normal. The wall's own velocity there, as in Adami et al. (2012), would halve the
 *  rate at which liquid that runs against a wall is compressed: sloshing in a tank 50 spacings wide is then 2.6 % too
 *  fast. */
static void set_image(sph2d__store *w, size_t b, double vx, double vy, bool rough)
{
    double nx = w->normal_x[b], ny = w->normal_y[b];
    double back_x = 2 * (vx - w->vx[b]), back_y = 2 * (vy - w->vy[b]), across = back_x * nx + back_y * ny;
    bool turned = rough || (nx == 0 && ny == 0);
    w->image_vx[b] = vx - (turned ? back_x : across * nx);
    w->image_vy[b] = vy - (turned ? back_y : across * ny);
}

/** Pressure, density and volume; none where no liquid is near. `share` is one over the summed weight, or 0. */
SPH2D__INLINE void finish_pressure(sph2d__system *s, size_t b, const wall_sums *sums, int l, double share)
{
    sph2d__store *w = &s->walls;
    double gx = -w->ax[b], gy = -w->ay[b];
    sph2d__body_add(&s->body, w->x[b], w->y[b], w->vx[b], w->vy[b], &gx, &gy);
    double pressure =
        share * ((double)sums->pressure[l] + gx * (double)sums->weight_x[l] + gy * (double)sums->weight_y[l]);
    w->pressure[b] = pressure;
    w->density[b] = sph2d__density_of(s, pressure);
    w->volume[b] = w->mass[b] / w->density[b];
}

SPH2D__INLINE void finish_wall(sph2d__system *s, size_t b, const wall_sums *sums, int l, bool pressed, bool moved)
{
    sph2d__store *w = &s->walls;
    double weight = sums->weight[l];
    bool wet = weight > 1e-12 && w->bounce[b] < 0;
    double share = wet ? 1 / weight : 0;
    if (pressed)
        finish_pressure(s, b, sums, l, share);
    if (moved) {
        double vx = wet ? share * (double)sums->vx[l] : w->vx[b]; /* where all is dry, the wall's own */
        double vy = wet ? share * (double)sums->vy[l] : w->vy[b];
        set_image(w, b, vx, vy, s->wall_slip == SPH2D_SLIP_NONE);
    }
}

/** Sums up what is asked for: pressures, velocities or both. */
SPH2D__INLINE void walls_with(sph2d__system *s, size_t first, size_t last, sph2d_kernel kernel, bool pressed,
                              bool moved)
{
    const sph2d__packed f = sph2d__packed_of(s, &s->fluid, false);
    const sph2d__grouping by = sph2d__grouping_of(&s->walls, &s->wall_cells, &s->fluid_cells);
    const sph2d__real inverse_support = (sph2d__real)(1 / s->support), mass = (sph2d__real)s->mass;
    SPH2D__FOR_GROUPS (&by, g, first, last) {
        wall_sums sums = {0};
        sph2d__sieve sieve;
        sph2d__ranges ranges = {0};
        sph2d__group_near(&by, &g, &ranges);
        sph2d__sieve_start(&sieve, &ranges, s->support);
        while (sph2d__sift(&sieve, &g, &ranges, f.x, f.y)) {
            place at = place_of(&s->walls, &g, sieve.way_x, sieve.way_y);
            SPH2D__FOR_FOUND (sieve, j) {
                sph2d__lanes dx = at.x - f.x[j], dy = at.y - f.y[j];
                sph2d__lanes q = sph2d__lanes_sqrt(dx * dx + dy * dy) * inverse_support;
                sph2d__lanes weight = sph2d__kernel_value(kernel, q);
                sums.weight += weight;
                if (pressed) {
                    sph2d__lanes heavy = weight * (mass / f.volume[j]);
                    sums.pressure += weight * f.pressure[j];
                    sums.weight_x += heavy * dx;
                    sums.weight_y += heavy * dy;
                }
                if (moved) {
                    sums.vx += weight * f.vx[j];
                    sums.vy += weight * f.vy[j];
                }
            }
        }
        const wall_sums done = sums; /* the sums themselves can then stay in registers */
        SPH2D__FOR_LANES (g, l)
            finish_wall(s, g.first + (size_t)l, &done, l, pressed, moved);
    }
}

/* ---- one for every kernel ---------------------------------------------------------------------------------------- */

#define FOR_KERNEL(name, kernel)                                                                                       \
    static void image_##name(sph2d__system *s, size_t first, size_t last)                                              \
    {                                                                                                                  \
        walls_with(s, first, last, kernel, false, true);                                                               \
    }                                                                                                                  \
    static void wall_##name(sph2d__system *s, size_t first, size_t last)                                               \
    {                                                                                                                  \
        if (s->wall_slip == SPH2D_SLIP_NONE)                                                                           \
            walls_with(s, first, last, kernel, true, true);                                                            \
        else                                                                                                           \
            walls_with(s, first, last, kernel, true, false);                                                           \
    }
FOR_KERNEL(c2, SPH2D_KERNEL_WENDLAND_C2)
FOR_KERNEL(c4, SPH2D_KERNEL_WENDLAND_C4)
FOR_KERNEL(c6, SPH2D_KERNEL_WENDLAND_C6)
FOR_KERNEL(cubic, SPH2D_KERNEL_CUBIC)
FOR_KERNEL(quintic, SPH2D_KERNEL_QUINTIC)

#define NAME_(kind, isa) sph2d__wcsph_##kind##_##isa
#define NAME(kind, isa) NAME_(kind, isa)
sph2d__span_work *const NAME(image, SPH2D__ISA)[5] = {image_c2, image_c4, image_c6, image_cubic, image_quintic};
sph2d__span_work *const NAME(wall, SPH2D__ISA)[5] = {wall_c2, wall_c4, wall_c6, wall_cubic, wall_quintic};
