/* SPDX-License-Identifier: MIT */
/** @file rate_pass.c
 *  The loops of the rate of density of method `wcsph`; the pair terms are in rate_pair.h. Compiled once for each
 *  instruction set, named by SPH2D__ISA, and within it once for each kernel. */
#include "methods/wcsph/rate_pair.h"

SPH2D__INLINE wall_sums sum_walls(const sph2d__system *s, sph2d_kernel kernel, const sph2d__grouping *by,
                                  const sph2d__group *g, const group_state *own, const sph2d__packed *walls)
{
    const sph2d__real inverse_support = (sph2d__real)(1 / s->support);
    wall_sums sums = {0};
    sph2d__ranges ranges;
    if (!sph2d__group_others(by, g, &ranges))
        return sums;
    sph2d__sieve sieve;
    sph2d__sieve_start(&sieve, &ranges, s->support);
    while (sph2d__sift(&sieve, g, &ranges, walls->x, walls->y)) {
        positions at = positions_of(&s->fluid, g, sieve.offset_x, sieve.offset_y);
        SPH2D__FOR_FOUND (sieve, j) {
            pair p = pair_with(kernel, inverse_support, &at, walls, j);
            sums.flux += velocity_term(&p, own, walls, j) * p.g * walls->mass[j];
            sums.filling += p.g * walls->mass[j];
            sums.returned += sph2d__kernel_value(kernel, p.q) * (walls->mass[j] * walls->wall_rate[j]);
        }
    }
    return sums;
}

/** Adds walls without slip to the velocity gradient, of liquids whose viscosity depends on it. */
SPH2D__INLINE void strain_by_walls(const sph2d__system *s, sph2d_kernel kernel, const sph2d__grouping *by,
                                   const sph2d__group *g, const sph2d__packed *walls, rate_sums *sums)
{
    const sph2d__real inverse_support = (sph2d__real)(1 / s->support);
    sph2d__ranges ranges;
    if (!sph2d__group_others(by, g, &ranges))
        return;
    sph2d__sieve sieve;
    sph2d__sieve_start(&sieve, &ranges, s->support);
    while (sph2d__sift(&sieve, g, &ranges, walls->x, walls->y)) {
        positions at = positions_of(&s->fluid, g, sieve.offset_x, sieve.offset_y);
        SPH2D__FOR_FOUND (sieve, b) {
            pair p = pair_with(kernel, inverse_support, &at, walls, b);
            add_wall_strain(sums, s, g, &p, b);
        }
    }
}

SPH2D__INLINE void density_rate_with(sph2d__system *s, size_t first, size_t last, sph2d_kernel kernel, diffusion form,
                                     sph2d__detail detail)
{
    sph2d__store *f = &s->fluid;
    const sph2d__packed liquid = sph2d__packed_of(s, f, false), walls = sph2d__packed_of(s, &s->walls, true);
    const sph2d__grouping by = sph2d__grouping_of(f, &s->fluid_cells, s->walls_press ? &s->wall_cells : NULL);
    const sph2d__real inverse_support = (sph2d__real)(1 / s->support);
    const sph2d__real strength = (sph2d__real)(s->method.density_diffusion * s->support * s->sound_speed / s->mass);
    sph2d__sieve sieve;
    SPH2D__FOR_GROUPS (&by, g, first, last) {
        const group_state own = group_state_of(&liquid, g.first, form);
        rate_sums sums = {.nearest2 = sph2d__lanes_all(s->support * s->support)};
        sph2d__ranges ranges;
        sph2d__patch_ranges(by.cells, &g.patch, &ranges);
        sph2d__group_box(f, &g);
        sph2d__sieve_start(&sieve, &ranges, s->support);
        while (sph2d__sift(&sieve, &g, &ranges, liquid.x, liquid.y)) {
            positions at = positions_of(f, &g, sieve.offset_x, sieve.offset_y);
            SPH2D__FOR_FOUND (sieve, j) {
                pair p = pair_with(kernel, inverse_support, &at, &liquid, j);
                sph2d__lanes term = velocity_term(&p, &own, &liquid, j);
                if (form != NO_DIFFUSION)
                    term += diffusion_of(form, strength, &p, &own, &liquid, j);
                sums.flux += p.g * term;
                sums.filling += p.g;
                if (detail >= SPH2D__DETAIL_SHIFT)
                    add_strain(&sums, &p, &own, &liquid, j);
                if (detail >= SPH2D__DETAIL_EIGENVALUE)
                    update_surface_distance(&sums, &p, &liquid, j);
            }
        }
        rate_sums liquid_sums = sums; /* a copy, so that the sums can stay in registers */
        if (detail >= SPH2D__DETAIL_SHIFT && s->walls_rough && s->liquid->model != SPH2D_RHEOLOGY_NEWTONIAN)
            strain_by_walls(s, kernel, &by, &g, &walls, &liquid_sums);
        const wall_sums of_walls = sum_walls(s, kernel, &by, &g, &own, &walls);
        SPH2D__FOR_LANES (g, l) {
            const size_t i = g.first + (size_t)l;
            f->density_rate[i] = total_rate(s, i, &of_walls, &liquid_sums, l);
            finish_filling(s, i, &of_walls, &liquid_sums, l);
            if (detail >= SPH2D__DETAIL_EIGENVALUE) {
                finish_surface(s, i, &liquid_sums, l);
                relax_density(s, i);
            }
            if (detail >= SPH2D__DETAIL_SHIFT) {
                finish_strain(s, i, &liquid_sums, l);
                finish_shift(s, i, &liquid_sums, l);
            }
        }
    }
}

/* ---- one for each kernel ----------------------------------------------------------------------------------------- */

/** Runs the copy of the loops with exactly the scene's terms. */
SPH2D__INLINE void rate_by_terms(sph2d__system *s, size_t first, size_t last, sph2d_kernel kernel)
{
    sph2d__detail detail = sph2d__wcsph_detail(&s->method);
    if (detail == SPH2D__DETAIL_SHIFT)
        density_rate_with(s, first, last, kernel, ANTUONO, SPH2D__DETAIL_SHIFT);
    else if (detail == SPH2D__DETAIL_EIGENVALUE)
        density_rate_with(s, first, last, kernel, ANTUONO, SPH2D__DETAIL_EIGENVALUE);
    else if (!(s->method.density_diffusion > 0))
        density_rate_with(s, first, last, kernel, NO_DIFFUSION, SPH2D__DETAIL_NONE);
    else if (s->method.diffusion_form == SPH2D_DIFFUSION_FOURTAKAS)
        density_rate_with(s, first, last, kernel, FOURTAKAS, SPH2D__DETAIL_NONE);
    else
        density_rate_with(s, first, last, kernel, ANTUONO, SPH2D__DETAIL_NONE);
}

#define FOR_KERNEL(name, word)                                                                                         \
    static void rate_##word(sph2d__system *s, size_t first, size_t last)                                               \
    {                                                                                                                  \
        rate_by_terms(s, first, last, SPH2D_KERNEL_##name);                                                            \
    }
SPH2D_KERNEL_MAP(FOR_KERNEL)

#define ENTRY(name, word) [SPH2D_KERNEL_##name] = rate_##word,
const sph2d__wcsph_pass SPH2D__OF_ISA(sph2d__wcsph_rate) = {{SPH2D_KERNEL_MAP(ENTRY)}};
