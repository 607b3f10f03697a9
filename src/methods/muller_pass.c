/* SPDX-License-Identifier: MIT */
/** @file muller_pass.c
 *  The pair loops of method `muller`. Compiled once for each instruction set, named by SPH2D__ISA. */
#include "kernels/muller.h"
#include "methods/muller.h"
#include "methods/traverse.h"

/** Poly6 shapes of a block; `mass` NULL counts each particle once. */
SPH2D__INLINE sph2d__lanes density_block(double support2, double xi, double yi, const double *x, const double *y,
                                         const double *mass, double left)
{
    sph2d__lanes dx = xi - sph2d__lanes_load(x), dy = yi - sph2d__lanes_load(y);
    sph2d__lanes d = sph2d__lanes_max(support2 - (dx * dx + dy * dy), (sph2d__lanes){0});
    sph2d__lanes shape = sph2d__lanes_first(d * d * d, left);
    return mass ? shape * sph2d__lanes_load(mass) : shape;
}

static void density(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *walls = &s->walls;
    sph2d__store *fluid = &s->fluid;
    double support2 = s->support * s->support;
    double poly6 = sph2d__poly6_constant(s->support);
    double own = poly6 * s->calibration * s->mass;
    bool walls_press = s->walls_press;
    sph2d__cursor cursor = SPH2D__CURSOR_START, wall_cursor = SPH2D__CURSOR_START;
    for (size_t i = first; i < last; ++i) {
        double xi = fluid->x[i], yi = fluid->y[i];
        sph2d__lanes sum = {0};
        sph2d__cursor_move(&cursor, &s->fluid_cells, xi, yi);
        SPH2D__FOR_BLOCKS (&cursor.ranges, r, j, left)
            sum += density_block(support2, xi + cursor.ranges.x[r], yi + cursor.ranges.y[r], fluid->x + j, fluid->y + j,
                                 NULL, left);
        double rho = own * sph2d__lanes_total(sum);
        if (walls_press && sph2d__cursor_move(&wall_cursor, &s->wall_cells, xi, yi)) {
            sph2d__lanes wall_sum = {0};
            SPH2D__FOR_BLOCKS (&wall_cursor.ranges, r, j, left)
                wall_sum += density_block(support2, xi + wall_cursor.ranges.x[r], yi + wall_cursor.ranges.y[r],
                                          walls->x + j, walls->y + j, s->walls.mass + j, left);
            rho += poly6 * sph2d__lanes_total(wall_sum);
        }
        fluid->density[i] = rho;
    }
}

static void wall_density(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *fluid = &s->fluid;
    sph2d__store *walls = &s->walls;
    double support2 = s->support * s->support;
    double own = sph2d__poly6_constant(s->support) * s->calibration * s->mass;
    sph2d__cursor cursor = SPH2D__CURSOR_START;
    for (size_t b = first; b < last; ++b) {
        double xb = walls->x[b], yb = walls->y[b];
        sph2d__lanes sum = {0};
        if (s->walls.mass[b] > 0 && sph2d__cursor_move(&cursor, &s->fluid_cells, xb, yb))
            SPH2D__FOR_BLOCKS (&cursor.ranges, r, j, left)
                sum += density_block(support2, xb + cursor.ranges.x[r], yb + cursor.ranges.y[r], fluid->x + j,
                                     fluid->y + j, NULL, left);
        walls->density[b] = s->rest_density + own * sph2d__lanes_total(sum);
    }
}

/** Sums of the force on one particle, without their constants. */
typedef struct force_sums {
    sph2d__lanes press_x, press_y, drag_x, drag_y;
} force_sums;

/** One particle that feels the block. */
typedef struct receiver {
    double x, y, vx, vy, pressure;
} receiver;

/** `range` is the place of the block among the receiver's ranges. */
SPH2D__INLINE void add_force(force_sums *sums, double support, bool viscous, const receiver *i,
                             const sph2d__ranges *ranges, int range, const sph2d__store *from, size_t j, double left)
{
    sph2d__lanes dx = i->x + ranges->x[range] - sph2d__lanes_load(from->x + j);
    sph2d__lanes dy = i->y + ranges->y[range] - sph2d__lanes_load(from->y + j);
    /* Coincident particles have no direction: 1/r stays finite and meets dx = dy = 0. */
    sph2d__lanes tiny = (sph2d__lanes){0} + 1e-24 * support * support;
    sph2d__lanes r = sph2d__lanes_sqrt(sph2d__lanes_max(dx * dx + dy * dy, tiny));
    sph2d__lanes w = sph2d__lanes_first(sph2d__lanes_max(support - r, (sph2d__lanes){0}), left);
    sph2d__lanes wv = w * sph2d__lanes_load(from->volume + j);
    sph2d__lanes press = wv * w * (i->pressure + sph2d__lanes_load(from->pressure + j)) / r;
    sums->press_x += press * dx;
    sums->press_y += press * dy;
    if (viscous) {
        sums->drag_x += wv * (sph2d__lanes_load(from->vx + j) - i->vx);
        sums->drag_y += wv * (sph2d__lanes_load(from->vy + j) - i->vy);
    }
}

/** Adds the acceleration times density that the sums stand for. */
SPH2D__INLINE void add_sums(double *fx, double *fy, const force_sums *sums, double press, double drag)
{
    *fx += press * sph2d__lanes_total(sums->press_x) + drag * sph2d__lanes_total(sums->drag_x);
    *fy += press * sph2d__lanes_total(sums->press_y) + drag * sph2d__lanes_total(sums->drag_y);
}

SPH2D__INLINE void force_with(sph2d__system *s, bool viscous, size_t first, size_t last)
{
    sph2d__store *fluid = &s->fluid;
    double press = sph2d__spiky_constant(s->support) / 2;
    double laplacian = sph2d__viscosity_constant(s->support);
    bool walls_press = s->walls_press;
    sph2d__cursor cursor = SPH2D__CURSOR_START, wall_cursor = SPH2D__CURSOR_START;
    for (size_t i = first; i < last; ++i) {
        receiver me = {fluid->x[i], fluid->y[i], fluid->vx[i], fluid->vy[i], fluid->pressure[i]};
        double fx = 0, fy = 0;
        force_sums sums = {{0}, {0}, {0}, {0}};
        sph2d__cursor_move(&cursor, &s->fluid_cells, me.x, me.y);
        SPH2D__FOR_BLOCKS (&cursor.ranges, r, j, left)
            add_force(&sums, s->support, viscous, &me, &cursor.ranges, r, fluid, j, left);
        add_sums(&fx, &fy, &sums, press, s->viscosity * laplacian);
        if (walls_press && sph2d__cursor_move(&wall_cursor, &s->wall_cells, me.x, me.y)) {
            force_sums wall_sums = {{0}, {0}, {0}, {0}};
            SPH2D__FOR_BLOCKS (&wall_cursor.ranges, r, j, left)
                add_force(&wall_sums, s->support, true, &me, &wall_cursor.ranges, r, &s->walls, j, left);
            add_sums(&fx, &fy, &wall_sums, press, s->wall_viscosity * laplacian);
        }
        double ax = fx / fluid->density[i], ay = fy / fluid->density[i];
        sph2d__body_add(&s->body, me.x, me.y, me.vx, me.vy, &ax, &ay);
        fluid->ax[i] = ax;
        fluid->ay[i] = ay;
    }
}

static void force(sph2d__system *s, size_t first, size_t last)
{
    if (s->viscosity > 0)
        force_with(s, true, first, last);
    else
        force_with(s, false, first, last);
}

#define NAME_(isa) sph2d__muller_passes_##isa
#define NAME(isa) NAME_(isa)
const sph2d__muller_passes NAME(SPH2D__ISA) = {density, wall_density, force};
