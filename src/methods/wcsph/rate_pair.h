/* SPDX-License-Identifier: MIT */
/** @file rate_pair.h
 *  Pair terms of the rate of density of method `wcsph`, of strain and shifts, and the results of a particle's sums. No
 *  loops: wcsph.h has the equations. */
#ifndef SPH2D_METHODS_WCSPH_RATE_PAIR_H
#define SPH2D_METHODS_WCSPH_RATE_PAIR_H

#include <math.h>

#include "kernels/kernel.h"
#include "methods/terms/shift.h"
#include "methods/terms/stick.h"
#include "methods/terms/viscosity.h"
#include "methods/wcsph/pair.h"
#include "methods/wcsph/wcsph.h"

/* Eigenvalue below which particles are the free surface. */
static const double SURFACE_EIGENVALUE = 0.6;
/* Eigenvalue below which the gradient of density is of few neighbours, and the density sum incomplete. */
static const double BULK = 0.75;
/* Relaxation time of density to its sum, over H/c0. With 60 to 120 the energy of a dam break never rose above an
 * earlier value until t sqrt(g/H) = 20; with 400 it did by 0.1 %, and the level took longer to become right. With 30
 * and less the start of a scene excites sound. */
static const double RELAXATION_TIME = 100;
/* Least free part of the support: overlapping walls can fill more than all of it. */
static const double MIN_FREE_PART = 0.1;

/** Forms of density diffusion. */
typedef enum diffusion {
    NO_DIFFUSION,
    ANTUONO,  /**< of density minus its linear part */
    FOURTAKAS /**< of density minus the hydrostatic density */
} diffusion;

/** The particles of a group. `density` is the one that diffuses. */
typedef struct group_state {
    sph2d__lanes vx, vy, density, density_grad_x, density_grad_y;
} group_state;

/** Sums of the rate of density and the strain rate; all without the constant of grad W. */
typedef struct rate_sums {
    sph2d__lanes flux;               /* of mass, with diffusion */
    sph2d__lanes filling;            /* g */
    sph2d__lanes xx, xy, yy;         /* minus M */
    sph2d__lanes ux, uy, vx, vy;     /* velocity differences times grad W */
    sph2d__lanes grad_c_x, grad_c_y; /* H grad C of the neighbours times g */
    sph2d__lanes nearest2;           /* squared distance to the nearest particle of the surface */
} rate_sums;

/** v_ij . r_ij. */
SPH2D__INLINE sph2d__lanes velocity_term(const pair *p, const group_state *own, const sph2d__packed *from, size_t j)
{
    return (own->vx - from->vx[j]) * p->dx + (own->vy - from->vy[j]) * p->dy;
}

/** The diffusion's equivalent of v_ij . r_ij: `strength` times V_j psi . r_ij/2. */
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

/** Adds a neighbour to the sums of the velocity gradient and of the mean concentration gradient. */
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

/** Adds boundary particle b to the sums of the velocity gradient where liquid sticks to it. Without them the shear rate
 *  at a wall is that farther inside: liquid that is thick by shear alone never began to follow a lid. */
SPH2D__INLINE void add_wall_strain(rate_sums *sums, const sph2d__system *s, const sph2d__group *g, const pair *p,
                                   size_t b)
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    double volume = w->mass[b] / s->rest_density;
    SPH2D__FOR_LANES (*g, l) {
        const size_t i = g->first + (size_t)l;
        double dx = (double)p->dx[l], dy = (double)p->dy[l], stick = sph2d__stick(s, b, dx, dy);
        double vg = stick > 0 ? (double)p->g[l] * volume : 0, gx = vg * dx, gy = vg * dy;
        sph2d_vec2 jump = sph2d__stick_jump(s, b, stick, dx, dy, f->vx[i] - w->vx[b], f->vy[i] - w->vy[b]);
        sums->xx[l] += (sph2d__real)(gx * dx);
        sums->xy[l] += (sph2d__real)(gx * dy);
        sums->yy[l] += (sph2d__real)(gy * dy);
        sums->ux[l] += (sph2d__real)(gx * jump.x);
        sums->uy[l] += (sph2d__real)(gy * jump.x);
        sums->vx[l] += (sph2d__real)(gx * jump.y);
        sums->vy[l] += (sph2d__real)(gy * jump.y);
    }
}

/** Updates the distance to the free surface by a candidate. */
SPH2D__INLINE void update_surface_distance(rate_sums *sums, const pair *p, const sph2d__packed *f, size_t j)
{
    if (f->min_eigenvalue[j] < SURFACE_EIGENVALUE)
        sums->nearest2 = -sph2d__lanes_max(-sums->nearest2, -p->r2);
}

/** Whether a particle is farther than H from the surface. */
SPH2D__INLINE bool is_inside(const sph2d__system *s, size_t i)
{
    return s->fluid.min_eigenvalue[i] > BULK && s->fluid.surface_distance[i] >= s->support;
}

/** Sets the shift velocity w. Density changes by w . grad rho (Sun et al. 2019) where the gradient is known. Velocity
 *  does not: w . grad v fed jets beside a wall with 3 to 28 % of the energy of a dam break. */
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

/** The largest |S| for which the step is stable with the viscosity (2 C H)^2 |S|, whose limit is a third of that of
 *  Morris' form; shifts grow with |S| up to 0.05/dt (shift.h). */
SPH2D__INLINE double max_strain_rate(const sph2d__system *s)
{
    const double filter = 2 * SPH2D__SMAGORINSKY;
    return sph2d__viscosity_step(s->method.kernel) / (3 * filter * filter * s->step);
}

/** Sets the strain rate, which scales shifts and subgrid viscosity; limited so that the step is stable with both. */
SPH2D__INLINE void finish_strain(const sph2d__system *s, size_t i, const rate_sums *sums, int l)
{
    double xx = sums->xx[l], xy = sums->xy[l], yy = sums->yy[l];
    double ux, uy, vx, vy;
    renormalise(xx, xy, yy, sums->ux[l], sums->uy[l], &ux, &uy);
    renormalise(xx, xy, yy, sums->vx[l], sums->vy[l], &vx, &vy);
    s->fluid.stretch[i] = (ux - vy) / 2;
    s->fluid.shear[i] = (uy + vx) / 2;
    double factor = fmin(max_strain_rate(s) / sph2d__strain_rate(&s->fluid, i), 1);
    s->fluid.stretch[i] *= factor;
    s->fluid.shear[i] *= factor;
}

/** Inside the liquid, density relaxes to its sum, which corrects errors due to surfaces that merged or separated. */
SPH2D__INLINE void relax_density(sph2d__system *s, size_t i)
{
    sph2d__store *f = &s->fluid;
    if (is_inside(s, i) && !s->only_divergence)
        f->density_rate[i] += (f->packing[i] - f->density[i]) * s->sound_speed / (RELAXATION_TIME * s->support);
}

/** Sums over boundary particles: m_b v_ib . r_ib g; m_b f times their wall_rate; m_b g. */
typedef struct wall_sums {
    sph2d__lanes flux, returned, filling;
} wall_sums;

/** Sets the part of the support outside walls that other liquid fills. */
SPH2D__INLINE void finish_filling(sph2d__system *s, size_t i, const wall_sums *walls, const rate_sums *sums, int l)
{
    double others = (double)sums->filling[l] - sph2d__kernel_slope_at(s->method.kernel, 0);
    double space = s->lattice_slopes - (double)walls->filling[l] / s->mass; /* both are negative */
    s->fluid.filling[i] = others / fmin(space, MIN_FREE_PART * s->lattice_slopes);
}

/** Sets the distance to the free surface. */
SPH2D__INLINE void finish_surface(sph2d__system *s, size_t i, const rate_sums *sums, int l)
{
    sph2d__store *f = &s->fluid;
    bool far = sums->nearest2[l] >= (sph2d__real)(s->support * s->support);
    double surface = far ? s->support : sqrt(sums->nearest2[l]);
    f->surface_distance[i] = f->min_eigenvalue[i] < SURFACE_EIGENVALUE ? 0 : surface;
}

/** Loads the particles of a group. */
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

/** The rate of density of particle i, whose sums are in lane l. */
SPH2D__INLINE double total_rate(const sph2d__system *s, size_t i, const wall_sums *walls, const rate_sums *sums, int l)
{
    double ratio = s->fluid.density[i] / s->rest_density;
    return slope_scale(s) *
           (s->mass * (double)sums->flux[l] + (double)walls->flux[l] + ratio * ratio * (double)walls->returned[l]);
}

#endif
