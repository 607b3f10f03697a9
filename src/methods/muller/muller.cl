/* SPDX-License-Identifier: MIT */
/* The program of method `muller`. */
#include "sim/shapes.cl"
#define SYSTEM sph2d__system s = placed(arena, numbers + system_at);
#include "sim/kernels.cl"

#include "methods/common/state_equation.h"
#include "methods/muller/leapfrog.h"
#include "methods/muller/muller_loops.h"
#include "methods/muller/muller_walls.h"
#include "sim/wall_loads.h"

SPAN(density_pass, density)
SPAN(pressures_pass, pressures)
SPAN(wall_density_pass, wall_density)
SPAN(wall_pressures_pass, wall_pressures)
SPAN(force_pass, force)
SPAN(second_kick_pass, sph2d__second_kick)
ADVECT(sph2d__kick_drift, sph2d__predict)

static inline void one_energy(const sph2d__system *s, size_t i, const int *none, sph2d__slab_sum *sum)
{
    sph2d__add_energy(s, i, sph2d__elastic_of(s, s->fluid.density[i]), sum);
}
SUM(sum_energy, int, one_energy)

LOADS(side_push, wall_force)
