/* SPDX-License-Identifier: MIT */
/** @file wcsph_force_pass.c
 *  Forces of method `wcsph`, and what is known of a particle's neighbourhood. Compiled once for each instruction set,
 *  named by SPH2D__ISA, and in it once for each kernel. */
#include <math.h>

#include "kernels/kernel.h"
#include "methods/traverse.h"
#include "methods/wcsph.h"
#include "methods/wcsph_pair.h"

/** What is summed for the force and the slope of density. */
typedef struct force_sums {
    sph2d__lanes plain_x, plain_y; /* m_j grad W: what uniform pressure would do */
    sph2d__lanes press_x, press_y, morris_x, morris_y, monaghan_x, monaghan_y;
    sph2d__lanes xx, xy, yy, slope_x, slope_y;
    sph2d__lanes crowd_x, crowd_y;
} force_sums;

/** Terms that a scene may do without. */
typedef struct terms {
    double morris, monaghan; /**< dynamic viscosity [Pa s] of each form */
    bool slope;              /**< density diffusion and shifting need the slope of density */
    bool full;               /**< shifting or tensile control needs to know the free surface */
    bool shift;              /**< particles are shifted */
    sph2d__real near;        /**< 1/f(dx/H) */
    bool sticky;             /**< walls are rough */
} terms;

/* In place of 0 where it is divided by. */
#ifdef SPH2D__MIXED
#define TINY 1e-37
#else
#define TINY 1e-300
#endif

/** The particle that feels. */
typedef struct receiver {
    double x, y;
    sph2d__real vx, vy, density;
} receiver;

/** Adds what tells how neighbours lie around a particle: `vg` is V_j g. */
SPH2D__INLINE void add_layout(force_sums *sums, const terms *with, sph2d_kernel kernel, const pair *p, sph2d__lanes vg)
{
    if (with->shift) {
        sph2d__lanes near = sph2d__kernel_value(kernel, p->q) * with->near;
        near *= near;
        sph2d__lanes crowd = vg * (1 + (sph2d__real)0.2 * near * near);
        sums->crowd_x += crowd * p->dx;
        sums->crowd_y += crowd * p->dy;
    }
    sums->xx += vg * p->dx * p->dx;
    sums->xy += vg * p->dx * p->dy;
    sums->yy += vg * p->dy * p->dy;
}

SPH2D__INLINE void add_viscosity(force_sums *sums, const terms *with, const pair *p, sph2d__lanes vg, sph2d__lanes dvx,
                                 sph2d__lanes dvy)
{
    sums->morris_x += vg * dvx;
    sums->morris_y += vg * dvy;
    if (with->monaghan > 0) {
        sph2d__lanes tiny = sph2d__lanes_all(TINY);
        sph2d__lanes along = vg * (dvx * p->dx + dvy * p->dy) / sph2d__lanes_max(p->r2, tiny);
        sums->monaghan_x += along * p->dx;
        sums->monaghan_y += along * p->dy;
    }
}

SPH2D__INLINE void add_liquid(force_sums *sums, const terms *with, sph2d_kernel kernel, const pair *p,
                              const receiver *me, const sph2d__packed *f, size_t j)
{
    sph2d__lanes volume = sph2d__lanes_load(f->volume + j), vg = volume * p->g;
    sph2d__lanes press = p->g * sph2d__lanes_load(f->pressure + j) * volume * volume;
    sums->plain_x += p->g * p->dx;
    sums->plain_y += p->g * p->dy;
    sums->press_x += press * p->dx;
    sums->press_y += press * p->dy;
    if (with->morris > 0 || with->monaghan > 0)
        add_viscosity(sums, with, p, vg, me->vx - sph2d__lanes_load(f->vx + j), me->vy - sph2d__lanes_load(f->vy + j));
    if (with->slope || with->full)
        add_layout(sums, with, kernel, p, vg);
    if (with->slope) {
        sph2d__lanes gx = vg * p->dx, gy = vg * p->dy;
        sph2d__lanes drho = sph2d__lanes_load(f->density + j) - me->density;
        sums->slope_x += gx * drho;
        sums->slope_y += gy * drho;
    }
}

/** Boundary particles have masses of their own. */
SPH2D__INLINE void add_wall(force_sums *sums, const terms *with, sph2d_kernel kernel, const pair *p, const receiver *me,
                            const sph2d__packed *w, size_t j, sph2d__real inverse_mass)
{
    sph2d__lanes volume = sph2d__lanes_load(w->volume + j), ratio = sph2d__lanes_load(w->mass + j) * inverse_mass;
    sph2d__lanes own = sph2d__lanes_max(ratio, sph2d__lanes_all(TINY));
    sph2d__lanes press = p->g * sph2d__lanes_load(w->pressure + j) * volume * volume / own;
    sums->plain_x += p->g * ratio * p->dx;
    sums->plain_y += p->g * ratio * p->dy;
    sums->press_x += press * p->dx;
    sums->press_y += press * p->dy;
    if (with->full)
        add_layout(sums, with, kernel, p, volume * p->g);
    if (with->sticky)
        add_viscosity(sums, with, p, volume * p->g, me->vx - sph2d__lanes_load(w->vx + j),
                      me->vy - sph2d__lanes_load(w->vy + j));
}

/** The corrected gradient of density: M^-1 b with M = sum V (x_j - x_i) grad W and b = sum V (rho_j - rho_i) grad W;
 * both lack the same constant. None where the neighbours are on one line. */
SPH2D__INLINE void finish_slope(sph2d__store *f, size_t i, const force_sums *sums)
{
    double xx = -sph2d__lanes_total(sums->xx), xy = -sph2d__lanes_total(sums->xy), yy = -sph2d__lanes_total(sums->yy);
    double bx = sph2d__lanes_total(sums->slope_x), by = sph2d__lanes_total(sums->slope_y);
    corrected(xx, xy, yy, bx, by, &f->slope_x[i], &f->slope_y[i]);
}

/** How far the neighbourhood is filled: the smaller eigenvalue of M, 1 in the bulk, near 0.5 at a flat surface, less in
 *  spray (Marrone et al. 2010, eq. 8; there of the inverse). */
SPH2D__INLINE double fullness_of(const force_sums *sums, double scale)
{
    double xx = -scale * sph2d__lanes_total(sums->xx), xy = -scale * sph2d__lanes_total(sums->xy);
    double yy = -scale * sph2d__lanes_total(sums->yy);
    double middle = (xx + yy) / 2, half = (xx - yy) / 2;
    return middle - sqrt(half * half + xy * xy);
}

/* Below the first, spray: no shift. Up to the second, near a surface: along it alone (Sun et al. 2017). */
static const double SPRAY = 0.4, BULK = 0.75;

/** The crowding that particles are shifted by, which near a free surface has no part across it. */
SPH2D__INLINE void finish_crowd(sph2d__system *s, size_t i, const force_sums *sums, double fullness, double scale)
{
    sph2d__store *f = &s->fluid;
    double unit = fullness < SPRAY ? 0 : s->support * scale;
    double cx = unit * sph2d__lanes_total(sums->crowd_x), cy = unit * sph2d__lanes_total(sums->crowd_y);
    if (fullness < BULK || f->surface[i] < s->support) {
        double nx = sph2d__lanes_total(sums->plain_x), ny = sph2d__lanes_total(sums->plain_y), n2 = nx * nx + ny * ny;
        double across = n2 > 0 ? (cx * nx + cy * ny) / n2 : 0;
        cx -= across * nx;
        cy -= across * ny;
    }
    f->crowd_x[i] = cx;
    f->crowd_y[i] = cy;
}

/** Adds the acceleration that the sums stand for. `own` is p V^2 of the particle. */
SPH2D__INLINE void add_sums(const sph2d__system *s, const force_sums *sums, const terms *with, double own,
                            double density, double *ax, double *ay)
{
    double scale = slope_scale(s), press = -scale / s->mass;
    *ax += press * own * sph2d__lanes_total(sums->plain_x);
    *ay += press * own * sph2d__lanes_total(sums->plain_y);
    double morris = 2 * with->morris * scale / density, monaghan = 8 * with->monaghan * scale / density;
    *ax += press * sph2d__lanes_total(sums->press_x) + morris * sph2d__lanes_total(sums->morris_x) +
           monaghan * sph2d__lanes_total(sums->monaghan_x);
    *ay += press * sph2d__lanes_total(sums->press_y) + morris * sph2d__lanes_total(sums->morris_y) +
           monaghan * sph2d__lanes_total(sums->monaghan_y);
}

static terms terms_of(const sph2d__system *s)
{
    bool morris = s->method.viscosity_form == SPH2D_VISCOSITY_MORRIS;
    double artificial = s->rest_density * s->method.artificial_viscosity * s->sound_speed * s->support / 16;
    terms with = {.morris = morris ? s->viscosity : 0,
                  .monaghan = artificial + (morris ? 0 : s->viscosity),
                  .slope = s->method.density_diffusion > 0 || s->method.shifting > 0,
                  .shift = s->method.shifting > 0};
    with.full = with.shift || s->method.tensile_control == SPH2D_SWITCH_ON;
    with.near = (sph2d__real)1 / (sph2d__real)sph2d__kernel_value_at(s->method.kernel, s->spacing / s->support);
    with.sticky = s->wall_slip == SPH2D_SLIP_NONE && (with.morris > 0 || with.monaghan > 0);
    return with;
}

SPH2D__INLINE void force_with(sph2d__system *s, size_t first, size_t last, sph2d_kernel kernel)
{
    sph2d__store *f = &s->fluid;
    terms with = terms_of(s);
    const sph2d__packed liquid = sph2d__packed_of(s, f, false), walls = sph2d__packed_of(s, &s->walls, true);
    const sph2d__real inverse_mass = (sph2d__real)(1 / s->mass);
    double scale = slope_scale(s);
    sph2d__cursor cursor = SPH2D__CURSOR_START, wall_cursor = SPH2D__CURSOR_START;
    for (size_t i = first; i < last; ++i) {
        receiver me = {f->x[i], f->y[i], (sph2d__real)f->vx[i], (sph2d__real)f->vy[i],
                       (sph2d__real)(f->density[i] - liquid.from)};
        double own = f->pressure[i] * f->volume[i] * f->volume[i], ax = 0, ay = 0;
        force_sums sums = {0};
        sph2d__cursor_move(&cursor, &s->fluid_cells, me.x, me.y);
        SPH2D__FOR_BLOCKS (&cursor.ranges, r, j, left) {
            pair p = pair_with(kernel, s->support, me.x, me.y, &cursor.ranges, r, &liquid, j, left);
            add_liquid(&sums, &with, kernel, &p, &me, &liquid, j);
        }
        if (with.slope)
            finish_slope(f, i, &sums);
        if (near_walls(s, &wall_cursor, me.x, me.y))
            SPH2D__FOR_BLOCKS (&wall_cursor.ranges, r, j, left) {
                pair p = pair_with(kernel, s->support, me.x, me.y, &wall_cursor.ranges, r, &walls, j, left);
                add_wall(&sums, &with, kernel, &p, &me, &walls, j, inverse_mass);
            }
        if (with.full) {
            double fullness = fullness_of(&sums, scale);
            bool inside = fullness > BULK && f->surface[i] >= s->support;
            f->fullness[i] = fullness;
            if (s->method.tensile_control == SPH2D_SWITCH_ON && own < 0 && inside)
                own = -own;
            if (with.shift)
                finish_crowd(s, i, &sums, fullness, scale);
        }
        add_sums(s, &sums, &with, own, f->density[i], &ax, &ay);
        sph2d__body_add(&s->body, me.x, me.y, f->vx[i], f->vy[i], &ax, &ay);
        f->ax[i] = ax;
        f->ay[i] = ay;
    }
}

/* ---- one for every kernel ---------------------------------------------------------------------------------------- */

#define FOR_KERNEL(name, kernel)                                                                                       \
    static void force_##name(sph2d__system *s, size_t first, size_t last)                                              \
    {                                                                                                                  \
        force_with(s, first, last, kernel);                                                                            \
    }
FOR_KERNEL(c2, SPH2D_KERNEL_WENDLAND_C2)
FOR_KERNEL(c4, SPH2D_KERNEL_WENDLAND_C4)
FOR_KERNEL(c6, SPH2D_KERNEL_WENDLAND_C6)
FOR_KERNEL(cubic, SPH2D_KERNEL_CUBIC)
FOR_KERNEL(quintic, SPH2D_KERNEL_QUINTIC)

#define NAME_(isa) sph2d__wcsph_force_##isa
#define NAME(isa) NAME_(isa)
sph2d__span_work *const NAME(SPH2D__ISA)[5] = {force_c2, force_c4, force_c6, force_cubic, force_quintic};
