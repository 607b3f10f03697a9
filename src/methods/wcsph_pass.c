/* SPDX-License-Identifier: MIT */
/** @file wcsph_pass.c
 *  The pair loops of method `wcsph` with symmetric operators. Compiled once for each instruction set, named by
 *  SPH2D__ISA, and in it once for each kernel. */
#include "base/threads.h"
#include "kernels/kernel.h"
#include "methods/shift.h"
#include "methods/state_equation.h"
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

/** Whether boundary particles are near; then the cursor is at their ranges. */
SPH2D__INLINE bool near_walls(const sph2d__system *s, sph2d__cursor *cursor, double x, double y)
{
    return s->walls_press && sph2d__cursor_move(cursor, &s->wall_cells, x, y);
}

/* ---- density ----------------------------------------------------------------------------------------------------- */

/** m_j v_ij . r_ij g of a block. */
SPH2D__INLINE sph2d__lanes flux_of(const pair *p, double vx, double vy, const sph2d__store *from, size_t j)
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

/* Particles less full than this are the free surface. */
static const double SURFACE = 0.6;

/** Adds what a shifted particle needs: velocity differences around it, and where the surface is. */
SPH2D__INLINE void add_way(rate_sums *sums, const pair *p, double vx, double vy, const sph2d__store *f, size_t j,
                           double left, double far2)
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
    sph2d__lanes far = (sph2d__lanes){0} + far2;
    sph2d__lanes away = sph2d__lanes_below(sph2d__lanes_load(f->fullness + j), SURFACE, p->r2, far);
    away = sph2d__lanes_below(sph2d__lanes_first(far, left), 0.5 * far2, far, away);
    sums->nearest2 = -sph2d__lanes_max(-sums->nearest2, -away);
}

/** The smallest of all lanes. */
static double least(sph2d__lanes a)
{
    double least = a[0];
    for (int l = 1; l < SPH2D__LANES; ++l)
        least = a[l] < least ? a[l] : least;
    return least;
}

/* det M / (tr M)^2 is 0.25 in the bulk, about as much at a flat surface, and 0 where all neighbours are on one line, as
 * in a film on a wall; below this the inverse would magnify noise. */
static const double SOUND = 0.1;

/** Inverts M and gives a gradient from its sums, both without the same constant; zero where neighbours are on a line.
 */
static void corrected(double xx, double xy, double yy, double bx, double by, double *gx, double *gy)
{
    double det = xx * yy - xy * xy;
    bool sound = det > SOUND * (xx + yy) * (xx + yy);
    *gx = sound ? (yy * bx - xy * by) / det : 0;
    *gy = sound ? (xx * by - xy * bx) / det : 0;
}

/** Velocity and density change along the shift as the fields around say (Sun et al. 2019); old_ax and old_ay hold that
 *  of velocity until the step is made. */
static void finish_way(sph2d__system *s, size_t i, const rate_sums *sums)
{
    sph2d__store *f = &s->fluid;
    sph2d_vec2 w = sph2d__shift_velocity(s, i);
    double xx = sph2d__lanes_total(sums->xx), xy = sph2d__lanes_total(sums->xy), yy = sph2d__lanes_total(sums->yy);
    double ux, uy, vx, vy;
    corrected(xx, xy, yy, sph2d__lanes_total(sums->ux), sph2d__lanes_total(sums->uy), &ux, &uy);
    corrected(xx, xy, yy, sph2d__lanes_total(sums->vx), sph2d__lanes_total(sums->vy), &vx, &vy);
    f->old_ax[i] = w.x * ux + w.y * uy;
    f->old_ay[i] = w.x * vx + w.y * vy;
    f->density_rate[i] += w.x * f->slope_x[i] + w.y * f->slope_y[i];
    f->surface[i] = f->fullness[i] < SURFACE ? 0 : sqrt(least(sums->nearest2));
}

SPH2D__INLINE void density_rate_with(sph2d__system *s, sph2d_kernel kernel)
{
    sph2d__store *f = &s->fluid;
    const sph2d__store *walls = &s->walls;
    double scale = slope_scale(s), spread = s->method.density_diffusion * s->support * s->sound_speed;
    double far2 = s->support * s->support;
    bool diffuse = spread > 0, way = s->method.shifting > 0 || s->method.tensile_control == SPH2D_SWITCH_ON;
    int threads = sph2d__threads_for(s->threads, f->count);
#pragma omp parallel num_threads(threads) if (threads > 1)
    {
        sph2d__cursor cursor = SPH2D__CURSOR_START, wall_cursor = SPH2D__CURSOR_START;
#pragma omp for schedule(dynamic, CHUNK)
        for (size_t i = 0; i < f->count; ++i) {
            double x = f->x[i], y = f->y[i], vx = f->vx[i], vy = f->vy[i];
            double rho = f->density[i], sx = f->slope_x[i], sy = f->slope_y[i];
            rate_sums sums = {.nearest2 = (sph2d__lanes){0} + far2};
            sph2d__cursor_move(&cursor, &s->fluid_cells, x, y);
            SPH2D__FOR_BLOCKS (&cursor.ranges, r, j, left) {
                pair p = pair_with(kernel, s->support, x, y, &cursor.ranges, r, f, j, left);
                sums.flux += flux_of(&p, vx, vy, f, j);
                if (diffuse) {
                    sph2d__lanes linear = (sx + sph2d__lanes_load(f->slope_x + j)) * p.dx +
                                          (sy + sph2d__lanes_load(f->slope_y + j)) * p.dy;
                    sums.smooth += p.g * sph2d__lanes_load(f->volume + j) *
                                   (rho - sph2d__lanes_load(f->density + j) - 0.5 * linear);
                }
                if (way)
                    add_way(&sums, &p, vx, vy, f, j, left, far2);
            }
            double rate = s->mass * sph2d__lanes_total(sums.flux) + spread * sph2d__lanes_total(sums.smooth);
            if (near_walls(s, &wall_cursor, x, y)) {
                sph2d__lanes wall_flux = {0};
                SPH2D__FOR_BLOCKS (&wall_cursor.ranges, r, j, left) {
                    pair p = pair_with(kernel, s->support, x, y, &wall_cursor.ranges, r, walls, j, left);
                    sph2d__lanes dvx = vx - sph2d__lanes_load(walls->image_vx + j);
                    sph2d__lanes dvy = vy - sph2d__lanes_load(walls->image_vy + j);
                    wall_flux += p.g * (dvx * p.dx + dvy * p.dy) * sph2d__lanes_load(walls->mass + j);
                }
                rate += sph2d__lanes_total(wall_flux);
            }
            f->density_rate[i] = scale * rate;
            if (way)
                finish_way(s, i, &sums);
        }
    }
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

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

/** Where no liquid is near, the pressure is 0 and the image is the wall itself. */
static void finish_wall(sph2d__system *s, size_t b, const wall_sums *sums)
{
    sph2d__store *w = &s->walls;
    double weight = sph2d__lanes_total(sums->weight), gx = 0, gy = 0;
    bool wet = weight > 1e-12;
    double share = wet ? 1 / weight : 0;
    sph2d__body_add(&s->body, w->x[b], w->y[b], w->vx[b], w->vy[b], &gx, &gy);
    gx -= w->ax[b];
    gy -= w->ay[b];
    double pressure = share * (sph2d__lanes_total(sums->pressure) + gx * sph2d__lanes_total(sums->weight_x) +
                               gy * sph2d__lanes_total(sums->weight_y));
    w->pressure[b] = pressure;
    w->density[b] = sph2d__density_of(s, pressure);
    w->volume[b] = w->mass[b] / w->density[b];
    double vx = wet ? share * sph2d__lanes_total(sums->vx) : w->vx[b];
    double vy = wet ? share * sph2d__lanes_total(sums->vy) : w->vy[b];
    set_image(w, b, vx, vy, s->wall_slip == SPH2D_SLIP_NONE);
}

SPH2D__INLINE void walls_with(sph2d__system *s, sph2d_kernel kernel)
{
    const sph2d__store *f = &s->fluid;
    sph2d__store *w = &s->walls;
    int threads = sph2d__threads_for(s->threads, w->count);
#pragma omp parallel num_threads(threads) if (threads > 1)
    {
        sph2d__cursor cursor = SPH2D__CURSOR_START;
#pragma omp for schedule(dynamic, CHUNK)
        for (size_t b = 0; b < w->count; ++b) {
            wall_sums sums = {0};
            if (w->bounce[b] < 0 && sph2d__cursor_move(&cursor, &s->fluid_cells, w->x[b], w->y[b]))
                SPH2D__FOR_BLOCKS (&cursor.ranges, r, j, left) {
                    sph2d__lanes dx = w->x[b] + cursor.ranges.x[r] - sph2d__lanes_load(f->x + j);
                    sph2d__lanes dy = w->y[b] + cursor.ranges.y[r] - sph2d__lanes_load(f->y + j);
                    sph2d__lanes q = sph2d__lanes_sqrt(dx * dx + dy * dy) * (1 / s->support);
                    sph2d__lanes weight = sph2d__lanes_first(sph2d__kernel_value(kernel, q), left);
                    sph2d__lanes heavy = weight * sph2d__lanes_load(f->density + j);
                    sums.weight += weight;
                    sums.pressure += weight * sph2d__lanes_load(f->pressure + j);
                    sums.weight_x += heavy * dx;
                    sums.weight_y += heavy * dy;
                    sums.vx += weight * sph2d__lanes_load(f->vx + j);
                    sums.vy += weight * sph2d__lanes_load(f->vy + j);
                }
            finish_wall(s, b, &sums);
        }
    }
}

/* ---- force ------------------------------------------------------------------------------------------------------- */

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
    bool slope;              /**< density diffusion needs the slope of density */
    bool full;               /**< shifting or tensile control needs to know the free surface */
    bool shift;              /**< particles are shifted */
    double near;             /**< 1/f(dx/H) */
    bool sticky;             /**< walls are rough */
} terms;

/** The particle that feels. */
typedef struct receiver {
    double x, y, vx, vy, density;
} receiver;

/** Adds what tells how neighbours lie around a particle: `vg` is V_j g. */
SPH2D__INLINE void add_layout(force_sums *sums, const terms *with, sph2d_kernel kernel, double support, const pair *p,
                              sph2d__lanes vg)
{
    if (with->shift) {
        sph2d__lanes q = sph2d__lanes_sqrt(p->r2) * (1 / support);
        sph2d__lanes near = sph2d__kernel_value(kernel, q) * with->near;
        near *= near;
        sph2d__lanes crowd = vg * (1 + 0.2 * near * near);
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
        sph2d__lanes tiny = (sph2d__lanes){0} + 1e-300;
        sph2d__lanes along = vg * (dvx * p->dx + dvy * p->dy) / sph2d__lanes_max(p->r2, tiny);
        sums->monaghan_x += along * p->dx;
        sums->monaghan_y += along * p->dy;
    }
}

SPH2D__INLINE void add_liquid(force_sums *sums, const terms *with, sph2d_kernel kernel, double support, const pair *p,
                              const receiver *me, const sph2d__store *f, size_t j)
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
        add_layout(sums, with, kernel, support, p, vg);
    if (with->slope) {
        sph2d__lanes gx = vg * p->dx, gy = vg * p->dy;
        sph2d__lanes drho = sph2d__lanes_load(f->density + j) - me->density;
        sums->slope_x += gx * drho;
        sums->slope_y += gy * drho;
    }
}

/** Boundary particles have masses of their own. */
SPH2D__INLINE void add_wall(force_sums *sums, const terms *with, sph2d_kernel kernel, double support, const pair *p,
                            const receiver *me, const sph2d__store *w, size_t j, double mass)
{
    sph2d__lanes volume = sph2d__lanes_load(w->volume + j), ratio = sph2d__lanes_load(w->mass + j) * (1 / mass);
    sph2d__lanes own = sph2d__lanes_max(ratio, (sph2d__lanes){0} + 1e-300);
    sph2d__lanes press = p->g * sph2d__lanes_load(w->pressure + j) * volume * volume / own;
    sums->plain_x += p->g * ratio * p->dx;
    sums->plain_y += p->g * ratio * p->dy;
    sums->press_x += press * p->dx;
    sums->press_y += press * p->dy;
    if (with->full)
        add_layout(sums, with, kernel, support, p, volume * p->g);
    if (with->sticky)
        add_viscosity(sums, with, p, volume * p->g, me->vx - sph2d__lanes_load(w->image_vx + j),
                      me->vy - sph2d__lanes_load(w->image_vy + j));
}

/** The corrected gradient of density: M^-1 b with M = sum V (x_j - x_i) grad W and b = sum V (rho_j - rho_i) grad W;
 * both lack the same constant. None where the neighbours are on one line. */
static void finish_slope(sph2d__store *f, size_t i, const force_sums *sums)
{
    double xx = -sph2d__lanes_total(sums->xx), xy = -sph2d__lanes_total(sums->xy), yy = -sph2d__lanes_total(sums->yy);
    double bx = sph2d__lanes_total(sums->slope_x), by = sph2d__lanes_total(sums->slope_y);
    corrected(xx, xy, yy, bx, by, &f->slope_x[i], &f->slope_y[i]);
}

/** How far the neighbourhood is filled: the smaller eigenvalue of M, 1 in the bulk, near 0.5 at a flat surface, less in
 *  spray (Marrone et al. 2010, eq. 8; there of the inverse). */
static double fullness_of(const force_sums *sums, double scale)
{
    double xx = -scale * sph2d__lanes_total(sums->xx), xy = -scale * sph2d__lanes_total(sums->xy);
    double yy = -scale * sph2d__lanes_total(sums->yy);
    double middle = (xx + yy) / 2, half = (xx - yy) / 2;
    return middle - sqrt(half * half + xy * xy);
}

/* Below the first, spray: no shift. Up to the second, near a surface: along it alone (Sun et al. 2017). */
static const double SPRAY = 0.4, BULK = 0.75;

/** The crowding that particles are shifted by, which near a free surface has no part across it. */
static void finish_crowd(sph2d__system *s, size_t i, const force_sums *sums, double fullness, double scale)
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
static void add_sums(const sph2d__system *s, const force_sums *sums, const terms *with, double own, double density,
                     double *ax, double *ay)
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
                  .slope = s->method.density_diffusion > 0,
                  .shift = s->method.shifting > 0};
    with.full = with.shift || s->method.tensile_control == SPH2D_SWITCH_ON;
    with.near = 1 / sph2d__kernel_value_at(s->method.kernel, s->spacing / s->support);
    with.sticky = s->wall_slip == SPH2D_SLIP_NONE && (with.morris > 0 || with.monaghan > 0);
    return with;
}

SPH2D__INLINE void force_with(sph2d__system *s, sph2d_kernel kernel)
{
    sph2d__store *f = &s->fluid;
    terms with = terms_of(s);
    double scale = slope_scale(s);
    int threads = sph2d__threads_for(s->threads, f->count);
#pragma omp parallel num_threads(threads) if (threads > 1)
    {
        sph2d__cursor cursor = SPH2D__CURSOR_START, wall_cursor = SPH2D__CURSOR_START;
#pragma omp for schedule(dynamic, CHUNK)
        for (size_t i = 0; i < f->count; ++i) {
            receiver me = {f->x[i], f->y[i], f->vx[i], f->vy[i], f->density[i]};
            double own = f->pressure[i] * f->volume[i] * f->volume[i], ax = 0, ay = 0;
            force_sums sums = {0};
            sph2d__cursor_move(&cursor, &s->fluid_cells, me.x, me.y);
            SPH2D__FOR_BLOCKS (&cursor.ranges, r, j, left) {
                pair p = pair_with(kernel, s->support, me.x, me.y, &cursor.ranges, r, f, j, left);
                add_liquid(&sums, &with, kernel, s->support, &p, &me, f, j);
            }
            if (with.slope)
                finish_slope(f, i, &sums);
            if (near_walls(s, &wall_cursor, me.x, me.y))
                SPH2D__FOR_BLOCKS (&wall_cursor.ranges, r, j, left) {
                    pair p = pair_with(kernel, s->support, me.x, me.y, &wall_cursor.ranges, r, &s->walls, j, left);
                    add_wall(&sums, &with, kernel, s->support, &p, &me, &s->walls, j, s->mass);
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
            add_sums(s, &sums, &with, own, me.density, &ax, &ay);
            sph2d__body_add(&s->body, me.x, me.y, me.vx, me.vy, &ax, &ay);
            f->ax[i] = ax;
            f->ay[i] = ay;
        }
    }
}

/* ---- one of each for every kernel -------------------------------------------------------------------------------- */

#define FOR_KERNEL(name, kernel)                                                                                       \
    static void density_rate_##name(sph2d__system *s)                                                                  \
    {                                                                                                                  \
        density_rate_with(s, kernel);                                                                                  \
    }                                                                                                                  \
    static void walls_##name(sph2d__system *s)                                                                         \
    {                                                                                                                  \
        walls_with(s, kernel);                                                                                         \
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
    .walls = {walls_c2, walls_c4, walls_c6, walls_cubic, walls_quintic},
    .force = {force_c2, force_c4, force_c6, force_cubic, force_quintic},
};
