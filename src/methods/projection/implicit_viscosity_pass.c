/* SPDX-License-Identifier: MIT */
/** @file implicit_viscosity_pass.c
 *  The loops of implicit_viscosity.h over the neighbours that were gathered. Compiled once for each instruction set,
 *  named by SPH2D__ISA. Every lane is a particle. */
#include "methods/common/shortest.h"
#include "methods/projection/implicit_viscosity.h"
#include "methods/terms/stick.h"
#include "simd/lanes.h"

/* ---- the matrix -------------------------------------------------------------------------------------------------- */

/** Distances of the particles at (x, y) from their neighbours. */
typedef struct apart {
    sph2d__lanes dx, dy;
} apart;

SPH2D__INLINE apart apart_from(const sph2d__system *s, const sph2d__store *from, sph2d__lanes x, sph2d__lanes y,
                               const uint32_t *index)
{
    const sph2d__period *period = &s->fluid_cells.period;
    return (apart){sph2d__shortest(x - sph2d__lanes_gather(from->x, index), period->length_x),
                   sph2d__shortest(y - sph2d__lanes_gather(from->y, index), period->length_y)};
}

/** sqrt(b mu |g|)/H for gradients G = g r, so that times r it is c; `brake` is b mu/H^2. */
SPH2D__INLINE sph2d__lanes root_of(apart d, sph2d__float2 gradient, sph2d__lanes brake)
{
    const double tiny = 1e-300; /* of two particles in one place G and r are 0 */
    sph2d__lanes gx = sph2d__float2_x(gradient), gy = sph2d__float2_y(gradient);
    sph2d__lanes r2 = sph2d__lanes_max(d.dx * d.dx + d.dy * d.dy, (sph2d__lanes){0} + tiny);
    return sph2d__lanes_sqrt(brake * sph2d__lanes_sqrt((gx * gx + gy * gy) / r2));
}

/** What walls add to a particle's row: dyads with the factor 1 + d_b/d_i, and the velocities of the walls through them.
 */
typedef struct wall_sums {
    double xx, xy, yy, x, y;
} wall_sums;

/** Adds the boundary particles of a slot to each lane. Where they slip nothing: the loop is over lanes. */
SPH2D__INLINE void add_walls(const sph2d__system *s, wall_sums sums[SPH2D__LANES], apart d, sph2d__float2 gradient,
                             sph2d__lanes brake, const uint32_t *index)
{
    const sph2d__store *w = &s->walls;
    sph2d__lanes root = root_of(d, gradient, brake);
    for (int l = 0; l < SPH2D__LANES; ++l) {
        double k = root[l] * root[l], dx = d.dx[l], dy = d.dy[l];
        if (!(k > 0))
            continue;
        size_t b = index[l];
        k *= sph2d__stick(s, b, dx, dy);
        double along = w->vx[b] * dx + w->vy[b] * dy;
        sums[l].xx += k * dx * dx;
        sums[l].xy += k * dx * dy;
        sums[l].yy += k * dy * dy;
        sums[l].x += k * along * dx;
        sums[l].y += k * along * dy;
    }
}

/** Of two that are not negative; 0 if both are 0. */
SPH2D__INLINE sph2d__lanes harmonic_mean(sph2d__lanes a, sph2d__lanes b)
{
    return a / sph2d__lanes_max(a + b, sph2d__lanes_all(1e-300)) * (b + b);
}

SPH2D__INLINE void build_slice(sph2d__system *s, double dt, size_t first)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__slice *at = &n->slices[first / SPH2D__LANES];
    sph2d__implicit *m = &s->implicit;
    sph2d__store *f = &s->fluid;
    sph2d__lanes x = sph2d__lanes_load(f->x + first), y = sph2d__lanes_load(f->y + first), xx = {0}, yy = {0};
    sph2d__lanes own = {0};
    own += m->brake * s->viscosity;
    if (s->viscosities)
        own = m->brake * sph2d__lanes_load(s->viscosities + first);
    size_t k = at->begin, end = k + (size_t)at->fluid * SPH2D__LANES;
    for (; k < end; k += SPH2D__LANES) {
        apart d = apart_from(s, f, x, y, n->index + k);
        sph2d__lanes brake = own;
        if (s->viscosities)
            brake = harmonic_mean(own, m->brake * sph2d__lanes_gather(s->viscosities, n->index + k));
        sph2d__lanes root = root_of(d, sph2d__float2_load(n->gradient + k), brake);
        sph2d__lanes cx = root * d.dx, cy = root * d.dy;
        sph2d__float2_store(m->dyads + k, sph2d__float2_of(cx, cy));
        xx += cx * cx;
        yy += cy * cy;
    }
    wall_sums walls[SPH2D__LANES] = {{0}};
    end = k + (size_t)at->walls * SPH2D__LANES;
    for (; k < end && s->walls_rough; k += SPH2D__LANES)
        add_walls(s, walls, apart_from(s, &s->walls, x, y, n->index + k), sph2d__float2_load(n->gradient + k), own,
                  n->index + k);
    for (int l = 0; l < SPH2D__LANES; ++l) {
        size_t i = first + (size_t)l;
        m->xx[i] = walls[l].xx;
        m->xy[i] = walls[l].xy;
        m->yy[i] = walls[l].yy;
        m->wall_x[i] = walls[l].x;
        m->wall_y[i] = walls[l].y;
        m->inverse_x[i] = 1 / (1 + dt * (xx[l] + walls[l].xx));
        m->inverse_y[i] = 1 / (1 + dt * (yy[l] + walls[l].yy));
    }
}

static void build(sph2d__system *s, double dt, size_t first, size_t last)
{
    for (size_t i = first; i < last; i += SPH2D__LANES)
        build_slice(s, dt, i);
}

/* ---- products ---------------------------------------------------------------------------------------------------- */

static void accelerate(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__neighbours *n = &s->neighbours;
    sph2d__implicit *m = &s->implicit;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        const sph2d__slice *at = &n->slices[i / SPH2D__LANES];
        sph2d__lanes vx = sph2d__lanes_load(m->vx + i), vy = sph2d__lanes_load(m->vy + i);
        sph2d__lanes xy = sph2d__lanes_load(m->xy + i);
        sph2d__lanes ax = sph2d__lanes_load(m->xx + i) * vx + xy * vy;
        sph2d__lanes ay = xy * vx + sph2d__lanes_load(m->yy + i) * vy;
        size_t k = at->begin, end = k + (size_t)at->fluid * SPH2D__LANES;
        for (; k < end; k += SPH2D__LANES) {
            sph2d__float2 c = sph2d__float2_load(m->dyads + k);
            sph2d__lanes cx = sph2d__float2_x(c), cy = sph2d__float2_y(c);
            sph2d__lanes along = cx * (vx - sph2d__lanes_gather(m->vx, n->index + k)) +
                                 cy * (vy - sph2d__lanes_gather(m->vy, n->index + k));
            ax += along * cx;
            ay += along * cy;
        }
        sph2d__lanes_store(m->ax + i, sph2d__lanes_load(m->wall_x + i) - ax);
        sph2d__lanes_store(m->ay + i, sph2d__lanes_load(m->wall_y + i) - ay);
    }
}

static double multiply(sph2d__system *s, double dt, size_t first, size_t last)
{
    const sph2d__neighbours *n = &s->neighbours;
    sph2d__implicit *m = &s->implicit;
    double total = 0;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        const sph2d__slice *at = &n->slices[i / SPH2D__LANES];
        sph2d__float2 own = sph2d__float2_load(m->direction + i), sum = {0};
        size_t k = at->begin, end = k + (size_t)at->fluid * SPH2D__LANES;
        for (; k < end; k += SPH2D__LANES) {
            sph2d__float2 c = sph2d__float2_load(m->dyads + k);
            sph2d__float2 part = c * (own - sph2d__float2_gather(m->direction, n->index + k));
            sum += c * (part + sph2d__float2_swapped(part));
        }
        sph2d__lanes px = sph2d__float2_x(own), py = sph2d__float2_y(own), xy = sph2d__lanes_load(m->xy + i);
        sph2d__lanes qx = px + dt * (sph2d__float2_x(sum) + sph2d__lanes_load(m->xx + i) * px + xy * py);
        sph2d__lanes qy = py + dt * (sph2d__float2_y(sum) + xy * px + sph2d__lanes_load(m->yy + i) * py);
        sph2d__lanes_store(m->product_x + i, qx);
        sph2d__lanes_store(m->product_y + i, qy);
        sph2d__lanes both = px * qx + py * qy;
        for (int l = 0; l < SPH2D__LANES && i + (size_t)l < last; ++l)
            total += both[l];
    }
    return total;
}

const sph2d__implicit_viscosity_pass SPH2D__OF_ISA(sph2d__implicit_viscosity_pass) = {
    .build = build, .accelerate = accelerate, .multiply = multiply};
