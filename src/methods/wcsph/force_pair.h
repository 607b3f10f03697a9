/* SPDX-License-Identifier: MIT */
/** @file force_pair.h
 *  What a pair of particles adds to the forces of method `wcsph`, and to what is known of a neighbourhood; and what
 *  becomes of a particle when all is summed. No loops: wcsph.h has the equations. */
#ifndef SPH2D_METHODS_WCSPH_FORCE_PAIR_H
#define SPH2D_METHODS_WCSPH_FORCE_PAIR_H

#include <math.h>

#include "kernels/kernel.h"
#include "methods/terms/shift.h"
#include "methods/terms/viscosity.h"
#include "methods/terms/viscosity_pair.h"
#include "methods/wcsph/pair.h"
#include "methods/wcsph/wcsph.h"

/** What is summed for the force and the slope of density. */
typedef struct force_sums {
    sph2d__lanes press_x, press_y; /* along the line between two: pressure, and viscosity of the central form */
    sph2d__drag drag;              /* viscosity of Morris' form */
    sph2d__lanes plain_x, plain_y; /* m_j grad W: what uniform pressure would do */
    sph2d__lanes xx, xy, yy, density_grad_x, density_grad_y;
    sph2d__lanes grad_c_x, grad_c_y;
    sph2d__lanes leave_x, leave_y; /* V_j g v_ij: against the velocity among its neighbours */
    sph2d__lanes packing;          /* W/W(dx) */
} force_sums;

/** The terms of a scene, constants in each copy of the loops. */
typedef struct terms {
    sph2d_kernel kernel;
    sph2d__detail detail;
    bool laplacian, central; /**< either form of viscosity acts */
    bool eddies;             /**< Smagorinsky's does; never without `central` */
} terms;

/** Numbers of the scene. */
typedef struct constants {
    sph2d__real inverse_support;
    sph2d__real inverse_mass;
    sph2d__real near; /**< 1/f(dx/H) */
    sph2d__viscosity viscosity;
    double eddies;      /**< dynamic viscosity by eddies over the rate of strain [Pa s^2] */
    sph2d__real sticky; /**< 1 where walls are rough, else 0 */
} constants;

/* In place of 0 where it is divided by. */
#ifdef SPH2D__MIXED
#define TINY 1e-37
#else
#define TINY 1e-300
#endif

/** The particles of a group that feel a candidate. `pv2` is p V^2, `damping` what makes the central viscosity of
 *  the same unit, `eddies` what makes half the rate of strain so, which `strain` is. */
typedef struct group_state {
    sph2d__lanes vx, vy, density, pv2, damping, strain, stretch, shear, eddies;
} group_state;

/** Adds what tells how neighbours lie around a particle: `vg` is V_j g, `ratio` their mass over that of the liquid's
 *  particles. */
SPH2D__INLINE void add_neighbourhood(force_sums *sums, terms with, const constants *k, const pair *p, sph2d__lanes vg,
                                     sph2d__real ratio)
{
    if (with.detail >= SPH2D__DETAIL_EIGENVALUE) {
        sph2d__lanes near = sph2d__kernel_value(with.kernel, p->q) * k->near;
        sums->packing += near * ratio;
        if (with.detail >= SPH2D__DETAIL_SHIFT) {
            near *= near;
            sph2d__lanes crowd = vg * (1 + (sph2d__real)0.2 * near * near);
            sums->grad_c_x += crowd * p->dx;
            sums->grad_c_y += crowd * p->dy;
        }
    }
    sums->xx += vg * p->dx * p->dx;
    sums->xy += vg * p->dx * p->dy;
    sums->yy += vg * p->dy * p->dy;
}

/** Adds what acts along the line to a candidate: pressure, and the central form of viscosity. The candidate's mass is `ratio`
 *  times that of the liquid's particles, `theirs` its p V^2 over that, `damped` v_ij . r_ij times what resists.
 *  Their own pressure is in the sums already where nothing but these can turn it round. */
SPH2D__INLINE void add_along(force_sums *sums, terms with, const group_state *own, const pair *p, sph2d__real ratio,
                             sph2d__real theirs, sph2d__lanes damped)
{
    sph2d__lanes stress = sph2d__lanes_all(theirs);
    if (with.detail >= SPH2D__DETAIL_EIGENVALUE) {
        sph2d__lanes plain = p->g * ratio;
        sums->plain_x += plain * p->dx;
        sums->plain_y += plain * p->dy;
    } else {
        stress += own->pv2 * ratio;
    }
    if (with.central)
        stress += sph2d__central_stress(damped, p->r2, sph2d__lanes_all(TINY));
    sph2d__lanes press = p->g * stress;
    sums->press_x += press * p->dx;
    sums->press_y += press * p->dy;
}

/** What eddies damp of `jump`, v_ij . r_ij: all of it where a quarter or more is not linear, nothing in liquid that is
 *  strained smoothly. */
SPH2D__INLINE sph2d__lanes rough_part(const group_state *own, const pair *p, const sph2d__packed *f, size_t j,
                                      sph2d__lanes jump)
{
    const sph2d__real half = 0.5, past = SPH2D__PAST_LINEAR;
    sph2d__lanes linear = (own->stretch + f->stretch[j]) * half * (p->dx * p->dx - p->dy * p->dy) +
                          (own->shear + f->shear[j]) * p->dx * p->dy;
    sph2d__lanes most = past * sph2d__lanes_max(jump - linear, linear - jump);
    return sph2d__lanes_max(-most, -sph2d__lanes_max(-jump, -most));
}

SPH2D__INLINE void add_liquid(force_sums *sums, terms with, const constants *k, const group_state *own, const pair *p,
                              const sph2d__packed *f, size_t j)
{
    const sph2d__real volume = f->volume[j];
    sph2d__lanes dvx = own->vx - f->vx[j], dvy = own->vy - f->vy[j];
    sph2d__lanes jump = dvx * p->dx + dvy * p->dy, damped = own->damping * volume * jump;
    if (with.eddies) {
        const double stretch = f->stretch[j], shear = f->shear[j];
        const sph2d__real theirs = (sph2d__real)sqrt(stretch * stretch + shear * shear);
        damped += own->eddies * (own->strain + theirs) * volume * rough_part(own, p, f, j, jump);
    }
    add_along(sums, with, own, p, 1, f->pressure[j] * volume * volume, damped);
    if (with.laplacian)
        sph2d__drag_add(&sums->drag, p->g * volume, dvx, dvy);
    if (with.detail >= SPH2D__DETAIL_GRADIENT) {
        sph2d__lanes vg = p->g * volume, drho = f->density[j] - own->density;
        add_neighbourhood(sums, with, k, p, vg, 1);
        if (with.detail >= SPH2D__DETAIL_EIGENVALUE) {
            sums->leave_x += vg * dvx;
            sums->leave_y += vg * dvy;
        }
        sums->density_grad_x += vg * p->dx * drho;
        sums->density_grad_y += vg * p->dy * drho;
    }
}

/** Boundary particles have masses of their own; smooth ones have no viscosity. */
SPH2D__INLINE void add_wall(force_sums *sums, terms with, const constants *k, const group_state *own, const pair *p,
                            const sph2d__packed *w, size_t j)
{
    const sph2d__real volume = w->volume[j], ratio = w->mass[j] * k->inverse_mass, sticky = k->sticky;
    const sph2d__real theirs = ratio > 0 ? w->pressure[j] * volume * volume / ratio : 0;
    sph2d__lanes dvx = own->vx - w->vx[j], dvy = own->vy - w->vy[j];
    add_along(sums, with, own, p, ratio, theirs, own->damping * (volume * sticky) * (dvx * p->dx + dvy * p->dy));
    const sph2d__real along_x = w->along_x[j], along_y = w->along_y[j];
    sph2d__lanes along =
        sph2d__kernel_value(with.kernel, p->q) * w->slide[j] - theirs * p->g * (along_x * p->dx + along_y * p->dy);
    sums->press_x += along * along_x;
    sums->press_y += along * along_y;
    if (with.laplacian)
        sph2d__drag_add(&sums->drag, p->g * (volume * sticky), dvx, dvy);
    if (with.detail >= SPH2D__DETAIL_EIGENVALUE)
        add_neighbourhood(sums, with, k, p, p->g * volume, ratio);
}

/** The corrected gradient of density: M^-1 b with M = sum V (x_j - x_i) grad W and b = sum V (rho_j - rho_i) grad W;
 *  both lack the same constant. None where the neighbours are on one line. */
SPH2D__INLINE void finish_density_gradient(sph2d__store *f, size_t i, const force_sums *sums, int l)
{
    double xx = -(double)sums->xx[l], xy = -(double)sums->xy[l], yy = -(double)sums->yy[l];
    double bx = (double)sums->density_grad_x[l], by = (double)sums->density_grad_y[l];
    corrected(xx, xy, yy, bx, by, &f->density_grad_x[i], &f->density_grad_y[i]);
}

/** How far the neighbourhood is filled: the smaller eigenvalue of M, 1 in the bulk, near 0.5 at a flat surface, less in
 *  spray (Marrone et al. 2010, eq. 8; there of the inverse). */
SPH2D__INLINE double min_eigenvalue_of(const force_sums *sums, int l, double scale)
{
    double xx = -scale * (double)sums->xx[l], xy = -scale * (double)sums->xy[l];
    double yy = -scale * (double)sums->yy[l];
    double middle = (xx + yy) / 2, half = (xx - yy) / 2;
    return middle - sqrt(half * half + xy * xy);
}

/* Of the packing around a particle near the surface, the part of walls from which on it is not shifted. With 0.1 the
 * level of a tube 10 spacings wide ended 0.44 % low, with 0.3 0.37 %; the edge on a slope rests alike. */
static const double EDGE = 0.3;
/* And |S| H/c0 from which on it is shifted all the same, since jets along walls would clump: in the impact of
 * examples/dam_break_pressure a gauge of 90 mm read 5 to 18 rho g H for a moment, 1.4 with this. */
static const double CALM = 0.1;
/* Below the first, spray: no shift. Up to the second, near a surface: along it alone (Sun et al. 2017). */
static const double SPRAY = 0.4, BULK = 0.75;

/** The crowding that particles are shifted by, which near a free surface has no part across it, and none at all where
 *  walls are near, too: in the thin edge of liquid on a slope there is room uphill alone, and liquid that was shifted
 *  there ran down again, with 0.2 to 0.5 sqrt(gH) for ever on walls 160 degrees apart. Where it is strained fast, it is
 *  shifted all the same. */
SPH2D__INLINE void finish_concentration(sph2d__system *s, size_t i, const force_sums *sums, int l,
                                        double min_eigenvalue, double scale, double by_walls)
{
    sph2d__store *f = &s->fluid;
    double ratio = sph2d__strain_rate(f, i) * s->support / (CALM * s->sound_speed);
    double edge = f->surface_distance[i] < s->support ? fmin(by_walls / EDGE, 1) / (1 + ratio * ratio) : 0;
    double unit = min_eigenvalue < SPRAY ? 0 : (1 - edge) * s->support * scale;
    double cx = unit * (double)sums->grad_c_x[l], cy = unit * (double)sums->grad_c_y[l];
    if (min_eigenvalue < BULK || f->surface_distance[i] < s->support) {
        double nx = (double)sums->plain_x[l], ny = (double)sums->plain_y[l], n2 = nx * nx + ny * ny;
        double across = n2 > 0 ? (cx * nx + cy * ny) / n2 : 0;
        cx -= across * nx;
        cy -= across * ny;
    }
    f->grad_c_x[i] = cx;
    f->grad_c_y[i] = cy;
}

/** Adds the acceleration that the sums stand for. `pv2` is p V^2 of the particle where it is not in them. */
SPH2D__INLINE void add_sums(const sph2d__system *s, const force_sums *sums, int l, terms with, const constants *k,
                            double pv2, double density, double *ax, double *ay)
{
    double scale = slope_scale(s), press = -scale / s->mass;
    double x = sums->press_x[l], y = sums->press_y[l];
    if (with.detail >= SPH2D__DETAIL_EIGENVALUE) {
        x += pv2 * (double)sums->plain_x[l];
        y += pv2 * (double)sums->plain_y[l];
    }
    *ax += press * x;
    *ay += press * y;
    if (with.laplacian) {
        double drag = 2 * k->viscosity.laplacian * scale / density;
        *ax += drag * (double)sums->drag.x[l];
        *ay += drag * (double)sums->drag.y[l];
    }
}

static constants constants_of(const sph2d__system *s)
{
    double near = sph2d__kernel_value_at(s->method.kernel, s->spacing / s->support);
    double filter = SPH2D__SMAGORINSKY * 2 * s->support;
    return (constants){.inverse_support = (sph2d__real)(1 / s->support),
                       .inverse_mass = (sph2d__real)(1 / s->mass),
                       .near = (sph2d__real)(1 / near),
                       .viscosity = sph2d__viscosity_of(s),
                       .eddies = sph2d__has_eddies(&s->method) ? s->rest_density * filter * filter : 0,
                       .sticky = s->wall_slip == SPH2D_SLIP_NONE};
}

/* |S| H/c0 from which on tension is controlled one way alone. */
static const double ROUGH = 0.01;

/** Whether |p_i| stands for a negative p_i of an inner particle: where liquid is strained fast, only if that pushes the
 *  particle against the way that it goes among its neighbours. Both sums have the sign of g. */
SPH2D__INLINE bool is_pushed(const sph2d__system *s, size_t i, const force_sums *sums, const force_sums *liquid, int l,
                             terms with)
{
    bool calm = with.detail >= SPH2D__DETAIL_SHIFT && /* the strain is known */
                sph2d__strain_rate(&s->fluid, i) * s->support < ROUGH * s->sound_speed;
    double work =
        (double)liquid->leave_x[l] * (double)sums->plain_x[l] + (double)liquid->leave_y[l] * (double)sums->plain_y[l];
    return calm || work <= 0;
}

/** What becomes of particle i when all is summed in lane l; `slope` is of the liquid alone. */
SPH2D__INLINE void finish(sph2d__system *s, size_t i, const force_sums *sums, const force_sums *liquid, int l,
                          terms with, const constants *k)
{
    sph2d__store *f = &s->fluid;
    const double volume = s->mass / f->density[i];
    double pv2 = f->pressure[i] * volume * volume, ax = 0, ay = 0;
    if (with.detail >= SPH2D__DETAIL_GRADIENT)
        finish_density_gradient(f, i, liquid, l);
    if (with.detail >= SPH2D__DETAIL_EIGENVALUE) {
        double scale = slope_scale(s), min_eigenvalue = min_eigenvalue_of(sums, l, scale);
        bool inside = min_eigenvalue > BULK && f->surface_distance[i] >= s->support;
        f->min_eigenvalue[i] = min_eigenvalue;
        double packing = sums->packing[l];
        f->packing[i] = s->rest_density / s->lattice_values * packing;
        if (s->method.tensile_control == SPH2D_SWITCH_ON && pv2 < 0 && inside && is_pushed(s, i, sums, liquid, l, with))
            pv2 = -pv2;
        if (with.detail >= SPH2D__DETAIL_SHIFT)
            finish_concentration(s, i, sums, l, min_eigenvalue, scale,
                                 (packing - (double)liquid->packing[l]) / s->lattice_values);
    }
    add_sums(s, sums, l, with, k, pv2, f->density[i], &ax, &ay);
    sph2d__body_add(&s->body, f->x[i], f->y[i], f->vx[i], f->vy[i], &ax, &ay);
    f->ax[i] = ax;
    f->ay[i] = ay;
}

#endif
