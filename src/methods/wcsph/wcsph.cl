/* SPDX-License-Identifier: MIT */
/* The program of method `wcsph`. */
#include "methods/wcsph/wcsph_shared.cl"

#include "methods/wcsph/wcsph_sweeps.h"

static inline void one_rate(sph2d__system *s, size_t i, const sweep_times *t, sph2d__slab_sum *sum)
{
    rate(s, i, i + 1, t->before, t->after, t->rest, sum);
}
SUM(rate_pass, sweep_times, one_rate)

static inline void one_force(sph2d__system *s, size_t i, const double *once, sph2d__slab_sum *sum)
{
    force(s, i, i + 1, *once, sum);
}
SUM(force_pass, double, one_force)

SUM(sum_relaxed_pass, double, add_relaxed)
SUM(relax_pass, double, relax_one)
