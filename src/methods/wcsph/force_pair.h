/* SPDX-License-Identifier: MIT */
/** @file force_pair.h
 *  Pair terms of the forces of method `wcsph` and of the neighbourhood sums, and the results of a particle's sums. No
 *  loops: wcsph.h has the equations. */
#ifndef SPH2D_METHODS_WCSPH_FORCE_PAIR_H
#define SPH2D_METHODS_WCSPH_FORCE_PAIR_H

#include <math.h>

#include "kernels/kernel.h"
#include "methods/terms/shift.h"
#include "methods/terms/stick.h"
#include "methods/terms/viscosity.h"
#include "methods/terms/viscosity_pair.h"
#include "methods/wcsph/pair.h"
#include "methods/wcsph/wcsph.h"

/** Sums of the forces, the gradient of density and the neighbourhood; all without the constant of grad W. */
typedef struct force_sums {
    sph2d__lanes press_x, press_y;     /* central forces: pressure, and viscosity of the central form */
    sph2d__drag drag;                  /* viscosity of Morris' form */
    sph2d__lanes bend;                 /* minus the part of the Laplacian that lies behind walls: stick.h */
    sph2d__lanes uniform_x, uniform_y; /* (m_j/m) grad W: the force of a uniform pressure */
    sph2d__lanes xx, xy, yy;           /* minus M */
    sph2d__lanes density_grad_x, density_grad_y;
    sph2d__lanes grad_c_x, grad_c_y;
    sph2d__lanes relative_x, relative_y; /* V_j g v_ij: opposite to the velocity relative to the neighbours, as g < 0 */
    sph2d__lanes packing;                /* W/W(dx) */
    sph2d__block block;
} force_sums;

/** The terms of a scene, constants in each copy of the loops. */
typedef struct terms {
    sph2d_kernel kernel;
    sph2d__detail detail;
    bool laplacian, central; /**< forms of viscosity */
    bool eddies;             /**< subgrid viscosity; never without `central` */
    bool blocks;             /**< the step follows from the viscous blocks; never without `central` */
    bool variable;           /**< viscosity depends on the shear rate; never with `eddies` */
} terms;

/** Parameters of the scene. */
typedef struct constants {
    sph2d__real inverse_support;
    sph2d__real inverse_mass;
    sph2d__real inverse_value; /**< 1/f(dx/H) */
    sph2d__real background;    /**< pressure [Pa] */
    sph2d__viscosity
        viscosity; /**< in the sums: where it differs among particles, 1 for the drag, of the rest artificial */
    sph2d__viscosity limiting; /**< for the step */
    sph2d__real weight;        /**< of the central form [1/m^2] */
    double eddies;             /**< subgrid viscosity over the strain rate [Pa s^2] */
    sph2d__real no_slip;       /**< 1 if walls are rough, else 0 */
    sph2d__real nearest;       /**< least distance from a surface [m]; 0 where liquid does not stick pair by pair */
    const sph2d__store *walls;
    const unsigned char *slips; /**< of boundary particles, where walls differ, by id */
    const double *spins;        /**< how fast they turn, by id, where some do [1/s] */
} constants;

/* Lower bound of divisors that may be 0. */
#ifdef SPH2D__MIXED
#define TINY 1e-37
#else
#define TINY 1e-300
#endif

/** The particles of a group. `pv2` is p V^2, `strain` half the strain rate; `liquid`, `artificial` and `eddies`, the last
 *  over the strain rate, are minus V times the factors of central viscosities. `viscosity` is the particle's own. */
typedef struct group_state {
    sph2d__lanes vx, vy, density, pv2, liquid, artificial, strain, stretch, shear, eddies, viscosity, volume;
} group_state;

/** Adds a neighbour to the neighbourhood sums: `vg` is V_j g, `ratio` its mass over that of a fluid particle. */
SPH2D__INLINE void add_neighbourhood(force_sums *sums, terms with, const constants *k, const pair *p, sph2d__lanes vg,
                                     sph2d__real ratio)
{
    if (with.detail >= SPH2D__DETAIL_EIGENVALUE) {
        sph2d__lanes value = sph2d__kernel_value(with.kernel, p->q) * k->inverse_value;
        sums->packing += value * ratio;
        if (with.detail >= SPH2D__DETAIL_SHIFT) {
            value *= value;
            sph2d__lanes weight = vg * (1 + (sph2d__real)0.2 * value * value);
            sums->grad_c_x += weight * p->dx;
            sums->grad_c_y += weight * p->dy;
        }
    }
    sums->xx += vg * p->dx * p->dx;
    sums->xy += vg * p->dx * p->dy;
    sums->yy += vg * p->dy * p->dy;
}

/** v_ij . r_ij times the factors of viscosity: the liquid's, and of what divides by r^2, artificial and subgrid viscosity. */
typedef struct damped {
    sph2d__lanes liquid, near;
} damped;

/** Adds the central forces of a candidate: pressure, and the central form of viscosity. The candidate's mass is `ratio`
 *  times that of a fluid particle, `theirs` its p V^2 over that, `by` v_ij . r_ij times the factors of viscosity.
 *  The particle's own pressure is included here unless tensile control may change its sign (add_sums). */
SPH2D__INLINE void add_central(force_sums *sums, terms with, const group_state *own, const pair *p, sph2d__real ratio,
                               sph2d__real theirs, const damped *by)
{
    sph2d__lanes stress = sph2d__lanes_all(theirs);
    if (with.detail >= SPH2D__DETAIL_EIGENVALUE) {
        sph2d__lanes uniform = p->g * ratio;
        sums->uniform_x += uniform * p->dx;
        sums->uniform_y += uniform * p->dy;
    } else {
        stress += own->pv2 * ratio;
    }
    if (with.central)
        stress += by->liquid + by->near / sph2d__lanes_max(p->r2, sph2d__lanes_all(TINY));
    sph2d__lanes press = p->g * stress;
    sums->press_x += press * p->dx;
    sums->press_y += press * p->dy;
}

/** The part of `jump`, v_ij . r_ij, that subgrid viscosity damps: all of it if a quarter or more is nonlinear, none in
 *  linear flow. */
SPH2D__INLINE sph2d__lanes limited_jump(const group_state *own, const pair *p, const sph2d__packed *f, size_t j,
                                        sph2d__lanes jump)
{
    const sph2d__real half = 0.5, limit = SPH2D__SUBGRID_LIMIT;
    sph2d__lanes linear = (own->stretch + f->stretch[j]) * half * (p->dx * p->dx - p->dy * p->dy) +
                          (own->shear + f->shear[j]) * p->dx * p->dy;
    sph2d__lanes most = limit * sph2d__lanes_max(jump - linear, linear - jump);
    return sph2d__lanes_max(-most, -sph2d__lanes_max(-jump, -most));
}

/** The viscosity between a particle and a candidate, where it differs: to the factor of the drag, or of the jump. */
SPH2D__INLINE void add_viscosity(terms with, const constants *k, const group_state *own, sph2d__lanes viscosity,
                                 sph2d__real volume, sph2d__lanes jump, damped *by, sph2d__lanes *share)
{
    if (with.laplacian)
        *share *= viscosity;
    else
        by->liquid -= k->weight * viscosity * own->volume * volume * jump;
}

/** The largest central viscosity between a particle and a candidate. */
SPH2D__INLINE sph2d__lanes limiting_of(const constants *k, const pair *p)
{
    sph2d__lanes r2 = sph2d__lanes_max(p->r2, sph2d__lanes_all(TINY));
    return (sph2d__real)k->limiting.central + (sph2d__real)k->limiting.artificial / r2;
}

/** Adds a fluid particle. */
SPH2D__INLINE void add_liquid(force_sums *sums, terms with, const constants *k, const group_state *own, const pair *p,
                              const sph2d__packed *f, size_t j)
{
    const sph2d__real volume = f->volume[j];
    sph2d__lanes dvx = own->vx - f->vx[j], dvy = own->vy - f->vy[j];
    sph2d__lanes jump = dvx * p->dx + dvy * p->dy;
    damped by = {own->liquid * volume * jump, own->artificial * volume * jump};
    if (with.eddies) {
        const double stretch = f->stretch[j], shear = f->shear[j];
        const sph2d__real theirs = (sph2d__real)sqrt(stretch * stretch + shear * shear);
        by.near += own->eddies * (own->strain + theirs) * volume * limited_jump(own, p, f, j, jump);
    }
    sph2d__lanes share = p->g * volume;
    if (with.variable) {
        const sph2d__real theirs = f->viscosity[j], tiny = (sph2d__real)TINY;
        sph2d__lanes both = sph2d__lanes_max(own->viscosity + theirs, sph2d__lanes_all(tiny));
        add_viscosity(with, k, own, own->viscosity / both * (theirs + theirs), volume, jump, &by, &share);
    }
    add_central(sums, with, own, p, 1, (f->pressure[j] + k->background) * volume * volume, &by);
    if (with.laplacian)
        sph2d__drag_add(&sums->drag, share, dvx, dvy);
    if (with.blocks)
        sph2d__block_add(&sums->block, p->g * volume * limiting_of(k, p), p->dx, p->dy);
    if (with.detail >= SPH2D__DETAIL_GRADIENT) {
        sph2d__lanes vg = p->g * volume, drho = f->density[j] - own->density;
        add_neighbourhood(sums, with, k, p, vg, 1);
        if (with.detail >= SPH2D__DETAIL_EIGENVALUE) {
            sums->relative_x += vg * dvx;
            sums->relative_y += vg * dvy;
        }
        sums->density_grad_x += vg * p->dx * drho;
        sums->density_grad_y += vg * p->dy * drho;
    }
}

/** Makes (dvx, dvy), the velocity relative to boundary particle j, that relative to the image of stick.h, and adds its
 *  share of the Laplacian. */
SPH2D__INLINE void stick_to(force_sums *sums, const constants *k, const pair *p, size_t j, sph2d__real volume,
                            sph2d__lanes *dvx, sph2d__lanes *dvy)
{
    const sph2d__store *w = k->walls;
    const sph2d__real nx = (sph2d__real)w->normal_x[j], ny = (sph2d__real)w->normal_y[j];
    const sph2d__real depth = (sph2d__real)w->depth[j];
    sph2d__lanes gain = sph2d__lanes_all((sph2d__real)SPH2D__IN_CORNERS), bend = p->r2 / (sph2d__real)SPH2D__IN_CORNERS;
    if (depth > 0 && depth < INFINITY) {
        sph2d__lanes before = sph2d__lanes_max(p->dx * nx + p->dy * ny - depth, sph2d__lanes_all(k->nearest));
        gain = 1 + depth / before;
        bend = (before + depth) * depth;
    }
    sums->bend += p->g * volume * bend;
    const sph2d__real spin = k->spins ? (sph2d__real)k->spins[w->id[j]] : 0;
    sph2d__lanes ux = gain * *dvx + (gain - 1) * spin * p->dy, uy = gain * *dvy - (gain - 1) * spin * p->dx;
    *dvx = ux;
    *dvy = uy;
}

/** Adds a boundary particle. They have different masses; smooth ones have no viscosity. */
SPH2D__INLINE void add_wall(force_sums *sums, terms with, const constants *k, const group_state *own, const pair *p,
                            const sph2d__packed *w, size_t j)
{
    const sph2d__real volume = w->volume[j], ratio = w->mass[j] * k->inverse_mass;
    const sph2d__real no_slip = k->slips ? k->slips[k->walls->id[j]] == SPH2D_SLIP_NONE : k->no_slip;
    const sph2d__real theirs = ratio > 0 ? (w->pressure[j] + k->background) * volume * volume / ratio : 0;
    sph2d__lanes dvx = own->vx - w->vx[j], dvy = own->vy - w->vy[j];
    if (k->nearest > 0 && no_slip > 0)
        stick_to(sums, k, p, j, volume, &dvx, &dvy);
    sph2d__lanes jump = dvx * p->dx + dvy * p->dy, felt = volume * no_slip * jump;
    damped by = {own->liquid * felt, own->artificial * felt};
    sph2d__lanes share = p->g * (volume * no_slip);
    if (with.variable)
        add_viscosity(with, k, own, own->viscosity, volume * no_slip, jump, &by, &share);
    add_central(sums, with, own, p, ratio, theirs, &by);
    const sph2d__real along_x = w->along_x[j], along_y = w->along_y[j];
    sph2d__lanes along =
        sph2d__kernel_value(with.kernel, p->q) * w->slide[j] - theirs * p->g * (along_x * p->dx + along_y * p->dy);
    sums->press_x += along * along_x;
    sums->press_y += along * along_y;
    if (with.laplacian)
        sph2d__drag_add(&sums->drag, share, dvx, dvy);
    if (with.blocks)
        sph2d__block_add(&sums->block, p->g * (volume * no_slip) * limiting_of(k, p), p->dx, p->dy);
    if (with.detail >= SPH2D__DETAIL_EIGENVALUE)
        add_neighbourhood(sums, with, k, p, p->g * volume, ratio);
}

/** The renormalised gradient of density: M^-1 b with M = sum V (x_j - x_i) grad W and b = sum V (rho_j - rho_i) grad W,
 *  both without the same constant. Zero if the neighbours are on one line. */
SPH2D__INLINE void finish_density_gradient(sph2d__store *f, size_t i, const force_sums *sums, int l)
{
    double xx = -(double)sums->xx[l], xy = -(double)sums->xy[l], yy = -(double)sums->yy[l];
    double bx = (double)sums->density_grad_x[l], by = (double)sums->density_grad_y[l];
    renormalise(xx, xy, yy, bx, by, &f->density_grad_x[i], &f->density_grad_y[i]);
}

/** The smaller eigenvalue of M: 1 in the bulk, near 0.5 at a flat surface, less in spray (Marrone et al. 2010, eq. 8;
 *  there of the inverse). */
SPH2D__INLINE double min_eigenvalue_of(const force_sums *sums, int l, double scale)
{
    double xx = -scale * (double)sums->xx[l], xy = -scale * (double)sums->xy[l];
    double yy = -scale * (double)sums->yy[l];
    double middle = (xx + yy) / 2, half = (xx - yy) / 2;
    return middle - sqrt(half * half + xy * xy);
}

/* Near the surface, the walls' part of the packing above which a particle is not shifted. With 0.1 the final level in a
 * tube 10 spacings wide was 0.44 % low, with 0.3 0.37 %; the edge of liquid on a slope comes to rest with either. */
static const double CONTACT_WALLS = 0.3;
/* |S| H/c0 above which it is shifted nevertheless, since jets along walls would clump: in the impact of
 * examples/dam_break_pressure a gauge of 90 mm read 5 to 18 rho g H for a moment, 1.4 with this. */
static const double CONTACT_STRAIN = 0.1;
/* Eigenvalues: below the first, spray, no shift; below the second, near a surface, shift along it (Sun et al. 2017). */
static const double SPRAY = 0.4, BULK = 0.75;

/** The concentration gradient for shifting. Near a free surface its normal component is removed, and all of it where
 *  walls are near, too: in the thin edge of liquid on a slope there is space only uphill, and liquid shifted there ran
 *  down again, permanently with 0.2 to 0.5 sqrt(gH) on walls 160 degrees apart. Liquid that is strained fast is shifted
 *  nevertheless. */
SPH2D__INLINE void finish_concentration(sph2d__system *s, size_t i, const force_sums *sums, int l,
                                        double min_eigenvalue, double scale, double wall_packing)
{
    sph2d__store *f = &s->fluid;
    double ratio = sph2d__strain_rate(f, i) * s->support / (CONTACT_STRAIN * s->sound_speed);
    bool at_surface = f->surface_distance[i] < s->support;
    double contact = at_surface ? fmin(wall_packing / CONTACT_WALLS, 1) / (1 + ratio * ratio) : 0;
    if (s->rigid_count > 0 && wall_packing > 0 && sph2d__wcsph_near_body(s, i))
        contact = 1; /* it would be shifted into the gap that opens where liquid parts from a body */
    double unit = min_eigenvalue < SPRAY ? 0 : (1 - contact) * s->support * scale;
    double cx = unit * (double)sums->grad_c_x[l], cy = unit * (double)sums->grad_c_y[l];
    if (min_eigenvalue < BULK || at_surface) {
        double nx = (double)sums->uniform_x[l], ny = (double)sums->uniform_y[l], n2 = nx * nx + ny * ny;
        double across = n2 > 0 ? (cx * nx + cy * ny) / n2 : 0;
        cx -= across * nx;
        cy -= across * ny;
    }
    f->grad_c_x[i] = cx;
    f->grad_c_y[i] = cy;
}

/** The acceleration by viscosity in Morris' form, of particle i, which is kept where the force of walls needs it. */
SPH2D__INLINE sph2d_vec2 drag_of(sph2d__system *s, size_t i, const force_sums *sums, int l, const constants *k)
{
    sph2d__store *f = &s->fluid;
    double drag = 2 * k->viscosity.laplacian * slope_scale(s) / f->density[i];
    if (k->nearest > 0)
        drag *= sph2d__unbend(-slope_scale(s) * (double)sums->bend[l]);
    sph2d_vec2 a = {drag * (double)sums->drag.x[l], drag * (double)sums->drag.y[l]};
    if (k->nearest > 0) {
        f->image_vx[i] = a.x;
        f->image_vy[i] = a.y;
    }
    return a;
}

/** Adds the acceleration of the sums. `pv2` is the particle's own p V^2, for sums without it. */
SPH2D__INLINE void add_sums(sph2d__system *s, size_t i, const force_sums *sums, int l, terms with, const constants *k,
                            double pv2, double *ax, double *ay)
{
    double scale = slope_scale(s), press = -scale / s->mass;
    double x = sums->press_x[l], y = sums->press_y[l];
    if (with.detail >= SPH2D__DETAIL_EIGENVALUE) {
        x += pv2 * (double)sums->uniform_x[l];
        y += pv2 * (double)sums->uniform_y[l];
    }
    *ax += press * x;
    *ay += press * y;
    if (with.laplacian) {
        sph2d_vec2 drag = drag_of(s, i, sums, l, k);
        *ax += drag.x;
        *ay += drag.y;
    }
}

/** The rate of viscosity at particle i, by its block: viscosity.h [1/s]. */
SPH2D__INLINE double viscous_rate_of(const sph2d__system *s, size_t i, const force_sums *sums, int l)
{
    double most = sph2d__block_most((double)sums->block.xx[l], (double)sums->block.xy[l], (double)sums->block.yy[l]);
    return SPH2D__RATE_OF_BLOCK * slope_scale(s) * most / s->fluid.density[i];
}

static constants constants_of(const sph2d__system *s)
{
    double value = sph2d__kernel_value_at(s->method.kernel, s->spacing / s->support);
    double filter = SPH2D__SMAGORINSKY * 2 * s->support;
    return (constants){.inverse_support = (sph2d__real)(1 / s->support),
                       .inverse_mass = (sph2d__real)(1 / s->mass),
                       .inverse_value = (sph2d__real)(1 / value),
                       .background = (sph2d__real)s->background,
                       .viscosity = s->viscosities ? sph2d__viscosity_apart(s, 1, 0) : sph2d__viscosity_of(s),
                       .limiting = sph2d__viscosity_of(s),
                       .weight = (sph2d__real)s->central_weight,
                       .eddies = sph2d__has_eddies(&s->method) ? s->rest_density * filter * filter : 0,
                       .no_slip = s->walls_rough,
                       .nearest = (sph2d__real)(s->walls_stick ? SPH2D__NEAREST * s->spacing : 0),
                       .walls = &s->walls,
                       .slips = s->wall_slips,
                       .spins = s->wall_spin};
}

/* |S| H/c0 above which tensile control acts only if it removes energy. */
static const double TENSILE_STRAIN = 0.01;

/** Whether |p_i| replaces a negative p_i of an inner particle: where liquid is strained fast, only if the added force
 *  is against the particle's velocity relative to its neighbours. Both sums have the sign of g. */
SPH2D__INLINE bool uses_absolute_pressure(const sph2d__system *s, size_t i, const force_sums *sums,
                                          const force_sums *liquid, int l, terms with)
{
    bool slow = with.detail >= SPH2D__DETAIL_SHIFT && /* the strain rate is known */
                sph2d__strain_rate(&s->fluid, i) * s->support < TENSILE_STRAIN * s->sound_speed;
    double work = (double)liquid->relative_x[l] * (double)sums->uniform_x[l] +
                  (double)liquid->relative_y[l] * (double)sums->uniform_y[l];
    return slow || work <= 0;
}

/** Sets the results of particle i, whose sums are in lane l; `liquid` are those over the liquid alone. */
SPH2D__INLINE void finish(sph2d__system *s, size_t i, const force_sums *sums, const force_sums *liquid, int l,
                          terms with, const constants *k)
{
    sph2d__store *f = &s->fluid;
    const double volume = s->mass / f->density[i];
    double pv2 = (f->pressure[i] + s->background) * volume * volume, ax = 0, ay = 0;
    if (with.detail >= SPH2D__DETAIL_GRADIENT)
        finish_density_gradient(f, i, liquid, l);
    if (with.detail >= SPH2D__DETAIL_EIGENVALUE) {
        double scale = slope_scale(s), min_eigenvalue = min_eigenvalue_of(sums, l, scale);
        bool inside = min_eigenvalue > BULK && f->surface_distance[i] >= s->support;
        f->min_eigenvalue[i] = min_eigenvalue;
        double packing = sums->packing[l];
        f->packing[i] = s->rest_density / s->lattice_values * packing;
        double wall_packing = packing - (double)liquid->packing[l];
        bool pulled = s->rigid_count > 0 && wall_packing > 0; /* by a wall: a body would be pushed by that */
        bool controlled = s->method.tensile_control == SPH2D_SWITCH_ON && pv2 < 0 && inside && !pulled;
        if (controlled && uses_absolute_pressure(s, i, sums, liquid, l, with))
            pv2 = -pv2;
        f->acting_pressure[i] = pv2 / (volume * volume);
        if (with.detail >= SPH2D__DETAIL_SHIFT)
            finish_concentration(s, i, sums, l, min_eigenvalue, scale, wall_packing / s->lattice_values);
    }
    add_sums(s, i, sums, l, with, k, pv2, &ax, &ay);
    sph2d__body_add(&s->body, f->x[i], f->y[i], f->vx[i], f->vy[i], &ax, &ay);
    f->ax[i] = ax;
    f->ay[i] = ay;
}

#endif
