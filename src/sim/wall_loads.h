/* SPDX-License-Identifier: MIT */
/** @file wall_loads.h
 *  The force of a boundary particle on the liquid around it, in C and in OpenCL C. */
#ifndef SPH2D_SIM_WALL_LOADS_H
#define SPH2D_SIM_WALL_LOADS_H

#include "methods/common/system.h"
#include "methods/common/wall_force.h"

/** Defines function `name`, which sums the forces `force` (sph2d__method.wall_force) of boundary particle b over the liquid around it;
 *  `of` is an argument that it is looked up in. */
#define SPH2D__FORCE_OF_WALL(name, type, of, force)                                                                    \
    static inline sph2d__wall_force name(const sph2d__system *s, type of, size_t b)                                    \
    {                                                                                                                  \
        const sph2d__store *w = &s->walls, *f = &s->fluid;                                                             \
        sph2d__wall_force sum = {{0, 0}, {0, 0}};                                                                      \
        const uint32_t cell = sph2d__cells_find(&s->fluid_cells, w->x[b], w->y[b]);                                    \
        if (w->bounce[b] >= 0 || cell == UINT32_MAX)                                                                   \
            return sum;                                                                                                \
        sph2d__ranges ranges;                                                                                          \
        sph2d__cells_ranges(&s->fluid_cells, cell, &ranges);                                                           \
        SPH2D__FOR_NEIGHBOURS (&ranges, r, i) {                                                                        \
            const double dx = f->x[i] - (w->x[b] + ranges.x[r]), dy = f->y[i] - (w->y[b] + ranges.y[r]);               \
            if (!(dx * dx + dy * dy < s->support * s->support))                                                        \
                continue;                                                                                              \
            const sph2d__wall_force part = force(s, i, b, dx, dy);                                                     \
            sum.pressure.x += part.pressure.x;                                                                         \
            sum.pressure.y += part.pressure.y;                                                                         \
            sum.friction.x += part.friction.x;                                                                         \
            sum.friction.y += part.friction.y;                                                                         \
        }                                                                                                              \
        return sum;                                                                                                    \
    }

#endif
