/* SPDX-License-Identifier: MIT */
/** @file wcsph_rate_pass.c
 *  The rate of density of method `wcsph`, and what particles meet on the way of their shift. Compiled once for each
 *  instruction set, named by SPH2D__ISA, and in it once for each kernel. */
#include <math.h>

#include "kernels/kernel.h"
#include "methods/shift.h"
#include "methods/traverse.h"
#include "methods/wcsph.h"
#include "methods/wcsph_pair.h"

/* Particles less full than this are the free surface. */
static const double SURFACE = 0.6;
/* Less full than this, the gradients around are those of few: what a shift adds to velocity by them fed the jets beside
 * a wall with a million times the energy of a drop that fell. */
static const double FITTED = 0.75;

/** m_j v_ij . r_ij g of a block. */
SPH2D__INLINE sph2d__lanes flux_of(const pair *p, sph2d__real vx, sph2d__real vy, const sph2d__packed *from, size_t j)
{
    return p->g * ((vx - sph2d__lanes_load(from->vx + j)) * p->dx + (vy - sph2d__lanes_load(from->vy + j)) * p->dy);
}

/** What is summed for the rate of density, and for the way of a shifted particle. */
typedef struct rate_sums {
    sph2d__lanes flux, smooth;
    sph2d__lanes xx, xy, yy;     /* M without its constant */
    sph2d__lanes ux, uy, vx, vy; /* velocity differences times grad W */
    sph2d__lanes nearest2;       /* squared distance to the surface */
} rate_sums;

/** Adds what a shifted particle needs: velocity differences around it, and where the surface is. */
SPH2D__INLINE void add_way(rate_sums *sums, const pair *p, sph2d__real vx, sph2d__real vy, const sph2d__packed *f,
                           size_t j, double left, double far2)
{
    sph2d__lanes vg = p->g * sph2d__lanes_load(f->volume + j);
    sph2d__lanes gx = vg * p->dx, gy = vg * p->dy;
    sph2d__lanes dvx = vx - sph2d__lanes_load(f->vx + j), dvy = vy - sph2d__lanes_load(f->vy + j);
    sums->xx += gx * p->dx;
    sums->xy += gx * p->dy;
    sums->yy += gy * p->dy;
    sums->ux += gx * dvx;
    sums->uy += gy * dvx;
    sums->vx += gx * dvy;
    sums->vy += gy * dvy;
    sph2d__lanes far = sph2d__lanes_all(far2);
    sph2d__lanes away = sph2d__lanes_below(sph2d__lanes_load(f->fullness + j), SURFACE, p->r2, far);
    away = sph2d__lanes_below(sph2d__lanes_first(far, left), 0.5 * far2, far, away);
    sums->nearest2 = -sph2d__lanes_max(-sums->nearest2, -away);
}

/** The smallest of all lanes. */
SPH2D__INLINE double least(sph2d__lanes a)
{
    double least = a[0];
    for (int l = 1; l < SPH2D__LANES; ++l)
        least = a[l] < least ? a[l] : least;
    return least;
}

/** Velocity and density change along the shift as the fields around say (Sun et al. 2019), if these are known; old_ax
 * and old_ay hold that of velocity until the step is made. */
SPH2D__INLINE void finish_way(sph2d__system *s, size_t i, const rate_sums *sums)
{
    sph2d__store *f = &s->fluid;
    sph2d_vec2 w = sph2d__shift_velocity(s, i);
    double xx = sph2d__lanes_total(sums->xx), xy = sph2d__lanes_total(sums->xy), yy = sph2d__lanes_total(sums->yy);
    double ux, uy, vx, vy;
    if (f->fullness[i] < FITTED)
        w = (sph2d_vec2){0, 0};
    corrected(xx, xy, yy, sph2d__lanes_total(sums->ux), sph2d__lanes_total(sums->uy), &ux, &uy);
    corrected(xx, xy, yy, sph2d__lanes_total(sums->vx), sph2d__lanes_total(sums->vy), &vx, &vy);
    f->old_ax[i] = w.x * ux + w.y * uy;
    f->old_ay[i] = w.x * vx + w.y * vy;
    f->density_rate[i] += w.x * f->slope_x[i] + w.y * f->slope_y[i];
    f->surface[i] = f->fullness[i] < SURFACE ? 0 : sqrt(least(sums->nearest2));
}

SPH2D__INLINE void density_rate_with(sph2d__system *s, size_t first, size_t last, sph2d_kernel kernel)
{
    sph2d__store *f = &s->fluid;
    const sph2d__packed liquid = sph2d__packed_of(s, f, false), walls = sph2d__packed_of(s, &s->walls, true);
    double scale = slope_scale(s), spread = s->method.density_diffusion * s->support * s->sound_speed;
    double far2 = s->support * s->support;
    const sph2d__real half = 0.5;
    bool diffuse = spread > 0, way = s->method.shifting > 0 || s->method.tensile_control == SPH2D_SWITCH_ON;
    sph2d__cursor cursor = SPH2D__CURSOR_START, wall_cursor = SPH2D__CURSOR_START;
    for (size_t i = first; i < last; ++i) {
        double x = f->x[i], y = f->y[i];
        sph2d__real vx = (sph2d__real)f->vx[i], vy = (sph2d__real)f->vy[i];
        sph2d__real rho = (sph2d__real)(f->density[i] - liquid.from);
        sph2d__real sx = (sph2d__real)f->slope_x[i], sy = (sph2d__real)f->slope_y[i];
        rate_sums sums = {.nearest2 = sph2d__lanes_all(far2)};
        sph2d__cursor_move(&cursor, &s->fluid_cells, x, y);
        SPH2D__FOR_BLOCKS (&cursor.ranges, r, j, left) {
            pair p = pair_with(kernel, s->support, x, y, &cursor.ranges, r, &liquid, j, left);
            sums.flux += flux_of(&p, vx, vy, &liquid, j);
            if (diffuse) {
                sph2d__lanes linear = (sx + sph2d__lanes_load(liquid.slope_x + j)) * p.dx +
                                      (sy + sph2d__lanes_load(liquid.slope_y + j)) * p.dy;
                sums.smooth += p.g * sph2d__lanes_load(liquid.volume + j) *
                               (rho - sph2d__lanes_load(liquid.density + j) - half * linear);
            }
            if (way)
                add_way(&sums, &p, vx, vy, &liquid, j, left, far2);
        }
        double rate = s->mass * sph2d__lanes_total(sums.flux) + spread * sph2d__lanes_total(sums.smooth);
        if (near_walls(s, &wall_cursor, x, y)) {
            sph2d__lanes wall_flux = {0};
            SPH2D__FOR_BLOCKS (&wall_cursor.ranges, r, j, left) {
                pair p = pair_with(kernel, s->support, x, y, &wall_cursor.ranges, r, &walls, j, left);
                wall_flux += flux_of(&p, vx, vy, &walls, j) * sph2d__lanes_load(walls.mass + j);
            }
            rate += sph2d__lanes_total(wall_flux);
        }
        f->density_rate[i] = scale * rate;
        if (way)
            finish_way(s, i, &sums);
    }
}

/* ---- one for every kernel ---------------------------------------------------------------------------------------- */

#define FOR_KERNEL(name, kernel)                                                                                       \
    static void rate_##name(sph2d__system *s, size_t first, size_t last)                                               \
    {                                                                                                                  \
        density_rate_with(s, first, last, kernel);                                                                     \
    }
FOR_KERNEL(c2, SPH2D_KERNEL_WENDLAND_C2)
FOR_KERNEL(c4, SPH2D_KERNEL_WENDLAND_C4)
FOR_KERNEL(c6, SPH2D_KERNEL_WENDLAND_C6)
FOR_KERNEL(cubic, SPH2D_KERNEL_CUBIC)
FOR_KERNEL(quintic, SPH2D_KERNEL_QUINTIC)

#define NAME_(isa) sph2d__wcsph_rate_##isa
#define NAME(isa) NAME_(isa)
sph2d__span_work *const NAME(SPH2D__ISA)[5] = {rate_c2, rate_c4, rate_c6, rate_cubic, rate_quintic};
