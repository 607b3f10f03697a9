/* SPDX-License-Identifier: MIT */
/* The program of method `constraint`. */
#include "methods/wcsph/wcsph_shared.cl"

#include "methods/wcsph/implicit_spans.h"
#include "methods/wcsph/implicit_sweeps.h"
#include "methods/wcsph/thick_sweeps.h"

/* ---- close pairs ------------------------------------------------------------------------------------------------- */

KERNEL(count_close)
{
    __local uint32_t counts[SPH2D__SLAB];
    const size_t i = get_global_id(0);
    SYSTEM
    uint32_t all;
    places_of(counts, i < count ? (uint32_t)most_rows(&s, i) : 0, &all);
    if (get_local_id(0) == 0)
        ((__global uint32_t *)results)[get_group_id(0)] = all;
}

KERNEL(find_close)
{
    __local uint32_t counts[SPH2D__SLAB];
    const size_t i = get_global_id(0);
    SYSTEM
    uint32_t all;
    const size_t first = frozen.close_starts[get_group_id(0)] +
                         places_of(counts, i < count ? (uint32_t)most_rows(&s, i) : 0, &all);
    if (i < count)
        find_rows(&s, i, first);
}

/* ---- the solve --------------------------------------------------------------------------------------------------- */

SPAN(rest_pass, rest_some)
SPAN(expect_pass, expect_some)
SWEEP(loosen_pass, loosen_some)
WITH(relax_pass, double, relax_step)
TOTAL(cost_pass, add_cost)
SPAN(start_flow_pass, start_flow)
SPAN(transpose_pass, transpose_some)
SPAN(diverge_pass, diverge_some)
SUM(load_pass, bool, load_one)

static inline void multiply_one(sph2d__system *s, size_t i, sph2d__slab_sum *sum)
{
    multiply_some(s, i, i + 1, sum);
    sum->second = close_multiply(s, i);
}
TOTAL(multiply_pass, multiply_one)

SPAN(keep_first_pass, keep_first)
SUM(step_pass, factors, step_one)
WITH(direct_pass, factors, direct_one)

/* ---- after it ---------------------------------------------------------------------------------------------------- */

static inline void one_drawn(const sph2d__system *s, size_t i, sph2d__slab_sum *sum)
{
    sum->first = is_drawn(s, i);
}
TOTAL(count_drawn_pass, one_drawn)

WITH(take_back_pass, double, take_back)
SPAN(keep_found_pass, keep_found)
SPAN(press_found_pass, press_found)
SPAN(press_solved_pass, press_solved)
SPAN(expect_pressed_pass, expect_pressed)
SWEEP(finish_pass, finish_some)
TOTAL(compress_pass, compress)

/* ---- where the liquid is thick ----------------------------------------------------------------------------------- */

SPAN(thick_start_pass, thick_start)
SPAN(show_found_pass, show_found)
SPAN(show_way_pass, show_way)
SWEEP(thick_load_pass, thick_load)
SWEEP(thick_multiply_pass, thick_multiply)
SUM(thick_step_pass, double, thick_step)
WITH(thick_turn_pass, double, thick_turn)
SPAN(thick_finish_pass, thick_finish)
SPAN(thick_sides_pass, thick_sides)
