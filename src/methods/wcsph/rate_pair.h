/* SPDX-License-Identifier: MIT */
/** @file rate_pair.h
 *  What a pair of particles adds to the rate of density of method `wcsph`, to strain and to shifts; and what becomes of
 *  a particle when all is summed. No loops: wcsph.h has the equations. */
#ifndef SPH2D_METHODS_WCSPH_RATE_PAIR_H
#define SPH2D_METHODS_WCSPH_RATE_PAIR_H

#include <math.h>

#include "kernels/kernel.h"
#include "methods/terms/shift.h"
#include "methods/terms/viscosity.h"
#include "methods/wcsph/pair.h"
#include "methods/wcsph/wcsph.h"

/* Particles less full than this are the free surface. */
static const double SURFACE = 0.6;
/* Less full than this, the slope of density is that of few; nor do places say there what density is. */
static const double BULK = 0.75;
/* Time in which density comes to what places say, over H/c0. Energy of a dam break to t sqrt(g/H) = 20 never rose above
 * an earlier moment with 60 to 120; with 400 it did by 0.1 %, and the level took longer to be right. With 30 and less
 * the start of a scene sounds. */
static const double PACKING_TIME = 100;
/* Walls that overlap can fill more than there is. */
static const double ROOM = 0.1;

/** What diffuses. */
typedef enum diffusion {
    NO_DIFFUSION,
    ANTUONO,  /**< density less what its slopes explain */
    FOURTAKAS /**< density less that of a liquid at rest */
} diffusion;

/** The particles of a group that meet a candidate. `density` is the one that diffuses. */
typedef struct group_state {
    sph2d__lanes vx, vy, density, density_grad_x, density_grad_y;
} group_state;

/** What is summed for the rate of density, and for the rate of strain. */
typedef struct rate_sums {
    sph2d__lanes flux;               /* of mass, with what diffuses */
    sph2d__lanes filling;            /* g */
    sph2d__lanes xx, xy, yy;         /* M without its constant */
    sph2d__lanes ux, uy, vx, vy;     /* velocity differences times grad W */
    sph2d__lanes grad_c_x, grad_c_y; /* g H grad C */
    sph2d__lanes nearest2;           /* squared distance to the surface */
} rate_sums;

/** v_ij . r_ij. */
SPH2D__INLINE sph2d__lanes approach_of(const pair *p, const group_state *own, const sph2d__packed *from, size_t j)
{
    return (own->vx - from->vx[j]) * p->dx + (own->vy - from->vy[j]) * p->dy;
}

/** What stands for v_ij . r_ij by the diffusion of density: `strength` times V_j psi. */
SPH2D__INLINE sph2d__lanes diffusion_of(diffusion form, sph2d__real strength, const pair *p, const group_state *own,
                                        const sph2d__packed *f, size_t j)
{
    if (form == FOURTAKAS)
        return (own->density - f->excess[j]) * (strength * f->volume[j]);
    const sph2d__real half = 0.5;
    sph2d__lanes linear =
        (own->density_grad_x + f->density_grad_x[j]) * p->dx + (own->density_grad_y + f->density_grad_y[j]) * p->dy;
    return (own->density - f->density[j] - half * linear) * (strength * f->volume[j]);
}

/** Adds velocity differences and crowding. */
SPH2D__INLINE void add_strain(rate_sums *sums, const pair *p, const group_state *own, const sph2d__packed *f, size_t j)
{
    sph2d__lanes vg = p->g * f->volume[j];
    sph2d__lanes gx = vg * p->dx, gy = vg * p->dy;
    sph2d__lanes dvx = own->vx - f->vx[j], dvy = own->vy - f->vy[j];
    sums->xx += gx * p->dx;
    sums->xy += gx * p->dy;
    sums->yy += gy * p->dy;
    sums->ux += gx * dvx;
    sums->uy += gy * dvx;
    sums->vx += gx * dvy;
    sums->vy += gy * dvy;
    sums->grad_c_x += p->g * f->grad_c_x[j];
    sums->grad_c_y += p->g * f->grad_c_y[j];
}

/** Looks whether a candidate is the nearest of the free surface. */
SPH2D__INLINE void look_for_surface(rate_sums *sums, const pair *p, const sph2d__packed *f, size_t j)
{
    if (f->min_eigenvalue[j] < SURFACE)
        sums->nearest2 = -sph2d__lanes_max(-sums->nearest2, -p->r2);
}

/** Whether a particle is farther than H from the surface. */
SPH2D__INLINE bool is_inside(const sph2d__system *s, size_t i)
{
    return s->fluid.min_eigenvalue[i] > BULK && s->fluid.surface_distance[i] >= s->support;
}

/** The shift. Density changes along it as the density around says (Sun et al. 2019), if that is known. The velocity
 *  does not: taken from the gradients around it fed jets beside a wall with 3 to 28 % of the energy of a dam break. */
SPH2D__INLINE void finish_shift(sph2d__system *s, size_t i, const rate_sums *sums, int l)
{
    sph2d__store *f = &s->fluid;
    sph2d_vec2 mean = {0, 0};
    if (is_inside(s, i))
        mean = (sph2d_vec2){(double)sums->grad_c_x[l] / (double)sums->filling[l],
                            (double)sums->grad_c_y[l] / (double)sums->filling[l]};
    sph2d_vec2 w = sph2d__shift_velocity(s, i, mean);
    f->shift_x[i] = w.x;
    f->shift_y[i] = w.y;
    if (f->min_eigenvalue[i] >= BULK)
        f->density_rate[i] += w.x * f->density_grad_x[i] + w.y * f->density_grad_y[i];
}

/** |S| of which a step stands the viscosity (2 C H)^2 |S|, a third of what it stands in Morris' form; shifts grow with
 *  it up to 0.05/dt (shift.h). */
SPH2D__INLINE double most_strain(const sph2d__system *s)
{
    const double filter = 2 * SPH2D__SMAGORINSKY;
    return sph2d__viscosity_step(s->method.kernel) / (3 * filter * filter * s->step);
}

/** The rate of strain, by which the next step shifts and eddies damp; no larger than what a step stands of either. */
SPH2D__INLINE void finish_strain(const sph2d__system *s, size_t i, const rate_sums *sums, int l)
{
    double xx = sums->xx[l], xy = sums->xy[l], yy = sums->yy[l];
    double ux, uy, vx, vy;
    corrected(xx, xy, yy, sums->ux[l], sums->uy[l], &ux, &uy);
    corrected(xx, xy, yy, sums->vx[l], sums->vy[l], &vx, &vy);
    s->fluid.stretch[i] = (ux - vy) / 2;
    s->fluid.shear[i] = (uy + vx) / 2;
    double part = fmin(most_strain(s) / sph2d__strain_rate(&s->fluid, i), 1);
    s->fluid.stretch[i] *= part;
    s->fluid.shear[i] *= part;
}

/** Inside the liquid, density comes to what places say: its rate forgets what surfaces that met or parted did to it. */
SPH2D__INLINE void finish_packing(sph2d__system *s, size_t i)
{
    sph2d__store *f = &s->fluid;
    if (is_inside(s, i))
        f->density_rate[i] += (f->packing[i] - f->density[i]) * s->sound_speed / (PACKING_TIME * s->support);
}

/** What boundary particles do: m_b v_ib . r_ib g, and m_b f times their wall_rate. */
typedef struct wall_sums {
    sph2d__lanes flux, returned, filling; /* the last: m_b g */
} wall_sums;

/** The filling by other liquid, of the room that walls leave. */
SPH2D__INLINE void finish_filling(sph2d__system *s, size_t i, const wall_sums *walls, const rate_sums *sums, int l)
{
    double others = (double)sums->filling[l] - sph2d__kernel_slope_at(s->method.kernel, 0);
    double room = s->lattice_slopes - (double)walls->filling[l] / s->mass; /* both are negative */
    s->fluid.filling[i] = others / fmin(room, ROOM * s->lattice_slopes);
}

/** Distance to the surface. */
SPH2D__INLINE void finish_surface(sph2d__system *s, size_t i, const rate_sums *sums, int l)
{
    sph2d__store *f = &s->fluid;
    bool far = sums->nearest2[l] >= (sph2d__real)(s->support * s->support);
    double surface = far ? s->support : sqrt(sums->nearest2[l]);
    f->surface_distance[i] = f->min_eigenvalue[i] < SURFACE ? 0 : surface;
}

/** The receivers of a group. */
SPH2D__INLINE group_state group_state_of(const sph2d__packed *f, size_t first, diffusion form)
{
    group_state own = {.vx = sph2d__lanes_load(f->vx + first), .vy = sph2d__lanes_load(f->vy + first)};
    if (form == FOURTAKAS)
        own.density = sph2d__lanes_load(f->excess + first);
    if (form == ANTUONO) {
        own.density = sph2d__lanes_load(f->density + first);
        own.density_grad_x = sph2d__lanes_load(f->density_grad_x + first);
        own.density_grad_y = sph2d__lanes_load(f->density_grad_y + first);
    }
    return own;
}

/** The rate that the sums of a lane stand for. */
SPH2D__INLINE double total_rate(const sph2d__system *s, size_t i, const wall_sums *walls, const rate_sums *sums, int l)
{
    double ratio = s->fluid.density[i] / s->rest_density;
    return slope_scale(s) *
           (s->mass * (double)sums->flux[l] + (double)walls->flux[l] + ratio * ratio * (double)walls->returned[l]);
}

#endif
