/* SPDX-License-Identifier: MIT */
/** @file transfer_pass.c
 *  Velocities from the particles to the grid of method `hybrid`, and back. Compiled once for each instruction set, named by
 *  SPH2D__ISA. */
#include "methods/hybrid/grid.h"
#include "methods/hybrid/transfer.h"
#include "sim/stages.h"

static void sum(const sph2d_sim *sim, int first, int last, double dt)
{
    const sph2d__system *s = &sim->system;
    const sph2d__cells *c = &s->fluid_cells;
    const units unit = units_of(s, dt);
    sph2d__target to = {s->grid, first, last};
    size_t begin, end;
    if (c->nx == 0 || c->ny == 0)
        return;
    rows_touching(c, s->grid, first, last, &begin, &end);
    for (size_t i = c->start[begin * c->nx]; i < c->start[(end + 1) * c->nx]; ++i)
        add_one(s, unit, i, &to);
}

static void move(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    const pace p = pace_of(&sim->system, dt);
    for (size_t k = 0; k < w->count; ++k) {
        const sph2d__way way = way_of(&sim->system, &p, w->first + k);
        w->dx[k] = way.dx;
        w->dy[k] = way.dy;
        w->vx[k] = way.v.x;
        w->vy[k] = way.v.y;
    }
}

const sph2d__transfer_passes SPH2D__OF_ISA(sph2d__transfer_passes) = {sum, move};
