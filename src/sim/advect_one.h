/* SPDX-License-Identifier: MIT */
/** @file advect_one.h
 *  The advection of one particle, in C (advect.c) and in OpenCL C (kernels.cl). The file that includes it has defined the struct `passage`, with the
 *  members `system`, `walls` (the barrier at rest), `quantum` and `holds` (sph2d__method.walls_hold), and
 *
 *      void note_contact(const passage *p, sph2d__events *met, int wall, sph2d_vec2 at, sph2d_vec2 change, double work)
 *      bool reflect(const passage *p, sph2d_vec2 at, sph2d_vec2 *v)                  at reflecting boundary particles
 *      uint64_t sweep_moving(const passage *p, sph2d__events *met, sph2d__kicked who, sph2d_vec2 from, sph2d_vec2 *to,
 *                            sph2d_vec2 *v, double *to_bodies)                       at obstacles and bodies that move */
#ifndef SPH2D_SIM_ADVECT_ONE_H
#define SPH2D_SIM_ADVECT_ONE_H

#include "sim/displaced.h"

/** Keeps a displacement on its side of every wall at rest. */
static inline uint64_t sweep_fixed(const passage *p, sph2d__events *met, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v)
{
    sph2d__stops stops;
    stops.count = 0;
    const int hits = sph2d__barrier_sweep(p->walls, from, to, v, &stops);
    for (int k = 0; k < stops.count; ++k)
        note_contact(p, met, stops.items[k].wall, from, stops.items[k].change, 0);
    return (uint64_t)hits;
}

/** Moves particle i, which may meet a wall or a periodic side. */
static inline void advect_one(const passage *p, size_t i, sph2d__way way, sph2d__events *met)
{
    const sph2d__system *s = p->system;
    const sph2d__store *f = &s->fluid;
    const sph2d__kicked who = {i, way.kick};
    sph2d_vec2 from = {f->x[i], f->y[i]}, v = way.v;
    const sph2d__end free = {{from.x + way.dx, from.y + way.dy}, v};
    uint64_t reflected = 0;
    if (s->walls_reflect && reflect(p, from, &v)) {
        ++reflected;
        way.dx += s->step * (v.x - way.v.x);
        way.dy += s->step * (v.y - way.v.y);
    }
    sph2d_vec2 to = {from.x + way.dx, from.y + way.dy};
    uint64_t stopped = sweep_fixed(p, met, from, &to, &v);
    if (reflected + stopped > 0)
        met->stopped += sph2d__quanta_between(s, p->quantum, who, free, (sph2d__end){to, v});
    const sph2d__end held = {to, v};
    double to_bodies = 0;
    const uint64_t pushed = sweep_moving(p, met, who, from, &to, &v, &to_bodies);
    if (pushed > 0 && p->holds)
        stopped += sweep_fixed(p, met, from, &to, &v);
    if (pushed > 0) {
        const int64_t bodies = sph2d__quanta_of(p->quantum, to_bodies);
        met->driven += sph2d__quanta_between(s, p->quantum, who, (sph2d__end){to, v}, held) - bodies;
        met->stopped -= bodies;
    }
    if (sph2d__wrap_end(&s->fluid_cells.period, &from, &to)) {
        const sph2d__end before = {to, v};
        const uint64_t beside = sweep_fixed(p, met, from, &to, &v);
        if (beside > 0)
            met->stopped += sph2d__quanta_between(s, p->quantum, who, before, (sph2d__end){to, v});
        stopped += beside;
    }
    met->reflections += reflected;
    met->hits += stopped + pushed;
    met->not_finite += isfinite(to.x + to.y + v.x + v.y) ? 0 : 1;
    f->x[i] = to.x;
    f->y[i] = to.y;
    f->vx[i] = v.x;
    f->vy[i] = v.y;
}

#endif
