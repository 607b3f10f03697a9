/* SPDX-License-Identifier: MIT */
/** @file wcsph_rate_pass.c
 *  The rate of density of method `wcsph`, and what particles meet on the way of their shift. Compiled once for each
 *  instruction set, named by SPH2D__ISA, and in it once for each kernel. */
#include <math.h>

#include "kernels/kernel.h"
#include "methods/shift.h"
#include "methods/wcsph.h"
#include "methods/wcsph_pair.h"

/* Particles less full than this are the free surface. */
static const double SURFACE = 0.6;
/* Less full than this, the gradients around are those of few: what a shift adds to velocity by them fed the jets beside
 * a wall with a million times the energy of a drop that fell. */
static const double FITTED = 0.75;

/** The particles of a group that meet a candidate. */
typedef struct receiver {
    sph2d__lanes vx, vy, density, slope_x, slope_y;
} receiver;

/** What is summed for the rate of density, and for the way of a shifted particle. */
typedef struct rate_sums {
    sph2d__lanes flux, smooth;
    sph2d__lanes xx, xy, yy;     /* M without its constant */
    sph2d__lanes ux, uy, vx, vy; /* velocity differences times grad W */
    sph2d__lanes nearest2;       /* squared distance to the surface */
} rate_sums;

/** v_ij . r_ij g. */
SPH2D__INLINE sph2d__lanes flux_of(const pair *p, const receiver *me, const sph2d__packed *from, size_t j)
{
    return p->g * ((me->vx - from->vx[j]) * p->dx + (me->vy - from->vy[j]) * p->dy);
}

/** Adds the diffusion of density. */
SPH2D__INLINE void add_diffusion(rate_sums *sums, const pair *p, const receiver *me, const sph2d__packed *f, size_t j)
{
    const sph2d__real half = 0.5;
    sph2d__lanes linear = (me->slope_x + f->slope_x[j]) * p->dx + (me->slope_y + f->slope_y[j]) * p->dy;
    sums->smooth += p->g * f->volume[j] * (me->density - f->density[j] - half * linear);
}

/** Adds what a shifted particle needs: velocity differences around it, and where the surface is. */
SPH2D__INLINE void add_way(rate_sums *sums, const pair *p, const receiver *me, const sph2d__packed *f, size_t j)
{
    sph2d__lanes vg = p->g * f->volume[j];
    sph2d__lanes gx = vg * p->dx, gy = vg * p->dy;
    sph2d__lanes dvx = me->vx - f->vx[j], dvy = me->vy - f->vy[j];
    sums->xx += gx * p->dx;
    sums->xy += gx * p->dy;
    sums->yy += gy * p->dy;
    sums->ux += gx * dvx;
    sums->uy += gy * dvx;
    sums->vx += gx * dvy;
    sums->vy += gy * dvy;
    if (f->fullness[j] < SURFACE)
        sums->nearest2 = -sph2d__lanes_max(-sums->nearest2, -p->r2);
}

/** Velocity and density change along the shift as the fields around say (Sun et al. 2019), if these are known; old_ax
 * and old_ay hold that of velocity until the step is made. */
SPH2D__INLINE void finish_way(sph2d__system *s, size_t i, const rate_sums *sums, int l)
{
    sph2d__store *f = &s->fluid;
    sph2d_vec2 w = sph2d__shift_velocity(s, i);
    double xx = sums->xx[l], xy = sums->xy[l], yy = sums->yy[l];
    double ux, uy, vx, vy;
    if (f->fullness[i] < FITTED)
        w = (sph2d_vec2){0, 0};
    corrected(xx, xy, yy, sums->ux[l], sums->uy[l], &ux, &uy);
    corrected(xx, xy, yy, sums->vx[l], sums->vy[l], &vx, &vy);
    f->old_ax[i] = w.x * ux + w.y * uy;
    f->old_ay[i] = w.x * vx + w.y * vy;
    f->density_rate[i] += w.x * f->slope_x[i] + w.y * f->slope_y[i];
    bool far = sums->nearest2[l] >= (sph2d__real)(s->support * s->support);
    double surface = far ? s->support : sqrt(sums->nearest2[l]);
    f->surface[i] = f->fullness[i] < SURFACE ? 0 : surface;
}

/** m_j v_ij . r_ij g of the boundary particles near a group. */
SPH2D__INLINE sph2d__lanes wall_flux(const sph2d__system *s, sph2d_kernel kernel, const sph2d__grouping *by,
                                     const sph2d__group *g, const receiver *me, const sph2d__packed *walls)
{
    const sph2d__real inverse_support = (sph2d__real)(1 / s->support);
    sph2d__lanes flux = {0};
    sph2d__ranges ranges;
    if (!sph2d__group_near(by, g, &ranges))
        return flux;
    for (int r = 0; r < ranges.count; ++r) {
        place at = place_of(&s->fluid, g, &ranges, r);
        for (size_t j = ranges.begin[r]; j < ranges.end[r]; ++j) {
            pair p = pair_with(kernel, inverse_support, &at, walls, j);
            flux += flux_of(&p, me, walls, j) * walls->mass[j];
        }
    }
    return flux;
}

/** The rates that the sums of all lanes stand for. */
SPH2D__INLINE void total_rates(const sph2d__system *s, sph2d__lanes wall_flux, const rate_sums *sums, bool diffuse,
                               double out[SPH2D__LANES])
{
    double scale = slope_scale(s), spread = s->method.density_diffusion * s->support * s->sound_speed;
    for (int l = 0; l < SPH2D__LANES; ++l) {
        double smooth = diffuse ? spread * (double)sums->smooth[l] : 0;
        out[l] = scale * (s->mass * (double)sums->flux[l] + smooth + (double)wall_flux[l]);
    }
}

SPH2D__INLINE void density_rate_with(sph2d__system *s, size_t first, size_t last, sph2d_kernel kernel, bool diffuse,
                                     bool way)
{
    sph2d__store *f = &s->fluid;
    const sph2d__packed liquid = sph2d__packed_of(s, f, false), walls = sph2d__packed_of(s, &s->walls, true);
    const sph2d__grouping by = sph2d__grouping_of(f, &s->fluid_cells, s->walls_press ? &s->wall_cells : NULL);
    const sph2d__real inverse_support = (sph2d__real)(1 / s->support);
    SPH2D__FOR_GROUPS(&by, g, first, last)
    {
        receiver me = {.vx = sph2d__lanes_load(liquid.vx + g.first), .vy = sph2d__lanes_load(liquid.vy + g.first)};
        if (diffuse) {
            me.density = sph2d__lanes_load(liquid.density + g.first);
            me.slope_x = sph2d__lanes_load(liquid.slope_x + g.first);
            me.slope_y = sph2d__lanes_load(liquid.slope_y + g.first);
        }
        rate_sums sums = {.nearest2 = sph2d__lanes_all(s->support * s->support)};
        sph2d__ranges ranges;
        sph2d__patch_ranges(by.cells, &g.patch, &ranges);
        for (int r = 0; r < ranges.count; ++r) {
            place at = place_of(f, &g, &ranges, r);
            for (size_t j = ranges.begin[r]; j < ranges.end[r]; ++j) {
                pair p = pair_with(kernel, inverse_support, &at, &liquid, j);
                sums.flux += flux_of(&p, &me, &liquid, j);
                if (diffuse)
                    add_diffusion(&sums, &p, &me, &liquid, j);
                if (way)
                    add_way(&sums, &p, &me, &liquid, j);
            }
        }
        const rate_sums done = sums; /* the sums themselves can then stay in registers */
        double rates[SPH2D__LANES];
        total_rates(s, wall_flux(s, kernel, &by, &g, &me, &walls), &done, diffuse, rates);
        for (int l = 0; l < g.count; ++l) {
            f->density_rate[g.first + (size_t)l] = rates[l];
            if (way)
                finish_way(s, g.first + (size_t)l, &done, l);
        }
    }
}

/* ---- one for every kernel ---------------------------------------------------------------------------------------- */

#define FOR_KERNEL(name, kernel)                                                                                       \
    static void rate_##name(sph2d__system *s, size_t first, size_t last)                                               \
    {                                                                                                                  \
        bool diffuse = s->method.density_diffusion > 0;                                                                \
        bool way = s->method.shifting > 0 || s->method.tensile_control == SPH2D_SWITCH_ON;                             \
        if (way)                                                                                                       \
            density_rate_with(s, first, last, kernel, true, true);                                                     \
        else if (diffuse)                                                                                              \
            density_rate_with(s, first, last, kernel, true, false);                                                    \
        else                                                                                                           \
            density_rate_with(s, first, last, kernel, false, false);                                                   \
    }
FOR_KERNEL(c2, SPH2D_KERNEL_WENDLAND_C2)
FOR_KERNEL(c4, SPH2D_KERNEL_WENDLAND_C4)
FOR_KERNEL(c6, SPH2D_KERNEL_WENDLAND_C6)
FOR_KERNEL(cubic, SPH2D_KERNEL_CUBIC)
FOR_KERNEL(quintic, SPH2D_KERNEL_QUINTIC)

#define NAME_(isa) sph2d__wcsph_rate_##isa
#define NAME(isa) NAME_(isa)
sph2d__span_work *const NAME(SPH2D__ISA)[5] = {rate_c2, rate_c4, rate_c6, rate_cubic, rate_quintic};
