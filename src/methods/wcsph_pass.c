/* SPDX-License-Identifier: MIT */
/** @file wcsph_pass.c
 *  The pair loops of method `wcsph` with symmetric operators. Compiled once for each instruction set, named by
 *  SPH2D__ISA, and in it once for each kernel. */
#include "base/threads.h"
#include "kernels/kernel.h"
#include "methods/traverse.h"
#include "methods/wcsph.h"

/* Particles that a thread takes at a time: enough to stay in a cell row, few enough to share uneven work. */
enum { CHUNK = 256 };

/** Distance to a block's particles, and g of the kernel there, 0 in lanes that count as nothing. */
typedef struct pair {
    sph2d__lanes dx, dy, r2, g;
} pair;

SPH2D__INLINE pair pair_with(sph2d_kernel kernel, double support, double x, double y, const sph2d__ranges *ranges,
                             int range, const sph2d__store *from, size_t j, double left)
{
    pair p;
    p.dx = x + ranges->x[range] - sph2d__lanes_load(from->x + j);
    p.dy = y + ranges->y[range] - sph2d__lanes_load(from->y + j);
    p.r2 = p.dx * p.dx + p.dy * p.dy;
    sph2d__lanes q = sph2d__lanes_sqrt(p.r2) * (1 / support);
    p.g = sph2d__lanes_first(sph2d__kernel_slope(kernel, q), left);
    return p;
}

/** C/H^4: grad W is this times g times the distance. */
static double slope_scale(const sph2d__system *s)
{
    double h2 = s->support * s->support;
    return sph2d__kernel_constant(s->method.kernel) / (h2 * h2);
}

/* ---- density ----------------------------------------------------------------------------------------------------- */

SPH2D__INLINE void density_rate_with(sph2d__system *s, sph2d_kernel kernel)
{
    sph2d__store *f = &s->fluid;
    double scale = slope_scale(s), spread = s->method.density_diffusion * s->support * s->sound_speed;
    bool diffuse = spread > 0;
    int threads = sph2d__threads_for(s->threads, f->count);
#pragma omp parallel num_threads(threads) if (threads > 1)
    {
        sph2d__cursor cursor = SPH2D__CURSOR_START;
#pragma omp for schedule(dynamic, CHUNK)
        for (size_t i = 0; i < f->count; ++i) {
            double vx = f->vx[i], vy = f->vy[i], rho = f->density[i], sx = f->slope_x[i], sy = f->slope_y[i];
            sph2d__lanes flux = {0}, smooth = {0};
            sph2d__cursor_move(&cursor, &s->fluid_cells, f->x[i], f->y[i]);
            SPH2D__FOR_BLOCKS (&cursor.ranges, r, j, left) {
                pair p = pair_with(kernel, s->support, f->x[i], f->y[i], &cursor.ranges, r, f, j, left);
                flux += p.g * ((vx - sph2d__lanes_load(f->vx + j)) * p.dx + (vy - sph2d__lanes_load(f->vy + j)) * p.dy);
                if (diffuse) {
                    sph2d__lanes linear = (sx + sph2d__lanes_load(f->slope_x + j)) * p.dx +
                                          (sy + sph2d__lanes_load(f->slope_y + j)) * p.dy;
                    smooth += p.g * sph2d__lanes_load(f->volume + j) *
                              (rho - sph2d__lanes_load(f->density + j) - 0.5 * linear);
                }
            }
            f->density_rate[i] = scale * (s->mass * sph2d__lanes_total(flux) + spread * sph2d__lanes_total(smooth));
        }
    }
}

/* ---- force ------------------------------------------------------------------------------------------------------- */

/** What is summed for the force and the slope of density. */
typedef struct force_sums {
    sph2d__lanes press_x, press_y, morris_x, morris_y, monaghan_x, monaghan_y;
    sph2d__lanes xx, xy, yy, slope_x, slope_y;
} force_sums;

/** Terms that a scene may do without. */
typedef struct terms {
    double morris, monaghan; /**< dynamic viscosity [Pa s] of each form */
    bool slope;              /**< density diffusion needs the slope of density */
} terms;

SPH2D__INLINE void add_pairs(force_sums *sums, const terms *with, const pair *p, const sph2d__store *f, size_t i,
                             size_t j)
{
    sph2d__lanes volume = sph2d__lanes_load(f->volume + j);
    sph2d__lanes vg = volume * p->g;
    double own = f->pressure[i] * f->volume[i] * f->volume[i];
    sph2d__lanes press = p->g * (own + sph2d__lanes_load(f->pressure + j) * volume * volume);
    sums->press_x += press * p->dx;
    sums->press_y += press * p->dy;
    if (with->morris > 0 || with->monaghan > 0) {
        sph2d__lanes dvx = f->vx[i] - sph2d__lanes_load(f->vx + j), dvy = f->vy[i] - sph2d__lanes_load(f->vy + j);
        sums->morris_x += vg * dvx;
        sums->morris_y += vg * dvy;
        if (with->monaghan > 0) {
            sph2d__lanes tiny = (sph2d__lanes){0} + 1e-300;
            sph2d__lanes along = vg * (dvx * p->dx + dvy * p->dy) / sph2d__lanes_max(p->r2, tiny);
            sums->monaghan_x += along * p->dx;
            sums->monaghan_y += along * p->dy;
        }
    }
    if (with->slope) {
        sph2d__lanes gx = vg * p->dx, gy = vg * p->dy;
        sums->xx += gx * p->dx;
        sums->xy += gx * p->dy;
        sums->yy += gy * p->dy;
        sph2d__lanes drho = sph2d__lanes_load(f->density + j) - f->density[i];
        sums->slope_x += gx * drho;
        sums->slope_y += gy * drho;
    }
}

/** The corrected gradient of density: M^-1 b with M = sum V (x_j - x_i) grad W and b = sum V (rho_j - rho_i) grad W;
 * both lack the same constant. None where the neighbours are on one line. */
static void finish_slope(sph2d__store *f, size_t i, const force_sums *sums)
{
    double xx = -sph2d__lanes_total(sums->xx), xy = -sph2d__lanes_total(sums->xy), yy = -sph2d__lanes_total(sums->yy);
    double bx = sph2d__lanes_total(sums->slope_x), by = sph2d__lanes_total(sums->slope_y);
    double det = xx * yy - xy * xy;
    bool sound = det > 1e-3 * (xx + yy) * (xx + yy);
    f->slope_x[i] = sound ? (yy * bx - xy * by) / det : 0;
    f->slope_y[i] = sound ? (xx * by - xy * bx) / det : 0;
}

static void finish_force(sph2d__system *s, size_t i, const force_sums *sums, const terms *with, double scale)
{
    sph2d__store *f = &s->fluid;
    double press = -scale / s->mass, morris = 2 * with->morris * scale / f->density[i];
    double monaghan = 8 * with->monaghan * scale / f->density[i];
    double ax = press * sph2d__lanes_total(sums->press_x) + morris * sph2d__lanes_total(sums->morris_x) +
                monaghan * sph2d__lanes_total(sums->monaghan_x);
    double ay = press * sph2d__lanes_total(sums->press_y) + morris * sph2d__lanes_total(sums->morris_y) +
                monaghan * sph2d__lanes_total(sums->monaghan_y);
    sph2d__body_add(&s->body, f->x[i], f->y[i], f->vx[i], f->vy[i], &ax, &ay);
    f->ax[i] = ax;
    f->ay[i] = ay;
    if (with->slope)
        finish_slope(f, i, sums);
}

static terms terms_of(const sph2d__system *s)
{
    bool morris = s->method.viscosity_form == SPH2D_VISCOSITY_MORRIS;
    double artificial = s->rest_density * s->method.artificial_viscosity * s->sound_speed * s->support / 16;
    return (terms){morris ? s->viscosity : 0, artificial + (morris ? 0 : s->viscosity),
                   s->method.density_diffusion > 0};
}

SPH2D__INLINE void force_with(sph2d__system *s, sph2d_kernel kernel)
{
    sph2d__store *f = &s->fluid;
    terms with = terms_of(s);
    double scale = slope_scale(s);
    int threads = sph2d__threads_for(s->threads, f->count);
#pragma omp parallel num_threads(threads) if (threads > 1)
    {
        sph2d__cursor cursor = SPH2D__CURSOR_START;
#pragma omp for schedule(dynamic, CHUNK)
        for (size_t i = 0; i < f->count; ++i) {
            force_sums sums = {0};
            sph2d__cursor_move(&cursor, &s->fluid_cells, f->x[i], f->y[i]);
            SPH2D__FOR_BLOCKS (&cursor.ranges, r, j, left) {
                pair p = pair_with(kernel, s->support, f->x[i], f->y[i], &cursor.ranges, r, f, j, left);
                add_pairs(&sums, &with, &p, f, i, j);
            }
            finish_force(s, i, &sums, &with, scale);
        }
    }
}

/* ---- one of each for every kernel -------------------------------------------------------------------------------- */

#define FOR_KERNEL(name, kernel)                                                                                       \
    static void density_rate_##name(sph2d__system *s)                                                                  \
    {                                                                                                                  \
        density_rate_with(s, kernel);                                                                                  \
    }                                                                                                                  \
    static void force_##name(sph2d__system *s)                                                                         \
    {                                                                                                                  \
        force_with(s, kernel);                                                                                         \
    }
FOR_KERNEL(c2, SPH2D_KERNEL_WENDLAND_C2)
FOR_KERNEL(c4, SPH2D_KERNEL_WENDLAND_C4)
FOR_KERNEL(c6, SPH2D_KERNEL_WENDLAND_C6)
FOR_KERNEL(cubic, SPH2D_KERNEL_CUBIC)
FOR_KERNEL(quintic, SPH2D_KERNEL_QUINTIC)

#define NAME_(isa) sph2d__wcsph_passes_##isa
#define NAME(isa) NAME_(isa)
const sph2d__wcsph_passes NAME(SPH2D__ISA) = {
    .density_rate = {density_rate_c2, density_rate_c4, density_rate_c6, density_rate_cubic, density_rate_quintic},
    .force = {force_c2, force_c4, force_c6, force_cubic, force_quintic},
};
