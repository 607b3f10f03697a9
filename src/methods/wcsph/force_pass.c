/* SPDX-License-Identifier: MIT */
/** @file force_pass.c
 *  The loops of the forces of method `wcsph` over groups and candidates; the pair terms are in force_pair.h. Compiled
 *  once for each instruction set, named by SPH2D__ISA, and within it once for each kernel. */
#include "methods/wcsph/force_pair.h"

/** Adds the boundary particles near a group. There is one for each kernel, with the other terms tested at run time: few
 *  particles are near walls, and copies take long to compile. */
typedef void wall_adder(const sph2d__system *s, const sph2d__grouping *by, const sph2d__group *g, force_sums *sums,
                        terms with, const constants *k, const group_state *own, const sph2d__packed *walls);

SPH2D__INLINE void add_walls(const sph2d__system *s, const sph2d__grouping *by, const sph2d__group *g, force_sums *sums,
                             terms with, const constants *k, const group_state *own, const sph2d__packed *walls)
{
    sph2d__ranges ranges;
    if (!sph2d__group_others(by, g, &ranges))
        return;
    sph2d__sieve sieve;
    sph2d__sieve_start(&sieve, &ranges, s->support);
    while (sph2d__sift(&sieve, g, &ranges, walls->x, walls->y)) {
        positions at = positions_of(&s->fluid, g, sieve.offset_x, sieve.offset_y);
        SPH2D__FOR_FOUND (sieve, j) {
            pair p = pair_with(with.kernel, k->inverse_support, &at, walls, j);
            add_wall(sums, with, k, own, &p, walls, j);
        }
    }
}

SPH2D__INLINE void force_with(sph2d__system *s, size_t first, size_t last, terms with, wall_adder *walls_of)
{
    sph2d__store *f = &s->fluid;
    const constants k = constants_of(s);
    const sph2d__packed liquid = sph2d__packed_of(s, f, false), walls = sph2d__packed_of(s, &s->walls, true);
    const sph2d__grouping by = sph2d__grouping_of(f, &s->fluid_cells, s->walls_press ? &s->wall_cells : NULL);
    sph2d__sieve sieve;
    double rate = 0;
    SPH2D__FOR_GROUPS (&by, g, first, last) {
        sph2d__lanes volume = sph2d__lanes_load(liquid.volume + g.first);
        group_state own = {.vx = sph2d__lanes_load(liquid.vx + g.first),
                           .vy = sph2d__lanes_load(liquid.vy + g.first),
                           .pv2 = (sph2d__lanes_load(liquid.pressure + g.first) + k.background) * volume * volume,
                           .liquid = -(sph2d__real)k.viscosity.central * volume,
                           .artificial = -(sph2d__real)k.viscosity.artificial * volume};
        if (with.detail >= SPH2D__DETAIL_GRADIENT)
            own.density = sph2d__lanes_load(liquid.density + g.first);
        if (with.eddies) {
            own.stretch = sph2d__lanes_load(liquid.stretch + g.first);
            own.shear = sph2d__lanes_load(liquid.shear + g.first);
            own.strain = sph2d__lanes_sqrt(own.stretch * own.stretch + own.shear * own.shear);
            own.eddies = -8 * (sph2d__real)k.eddies * volume;
        }
        if (with.variable) {
            own.viscosity = sph2d__lanes_load(liquid.viscosity + g.first);
            own.volume = volume;
        }
        force_sums sums = {0};
        sph2d__ranges ranges;
        sph2d__patch_ranges(by.cells, &g.patch, &ranges);
        sph2d__group_box(f, &g);
        sph2d__sieve_start(&sieve, &ranges, s->support);
        while (sph2d__sift(&sieve, &g, &ranges, liquid.x, liquid.y)) {
            positions at = positions_of(f, &g, sieve.offset_x, sieve.offset_y);
            SPH2D__FOR_FOUND (sieve, j) {
                pair p = pair_with(with.kernel, k.inverse_support, &at, &liquid, j);
                add_liquid(&sums, with, &k, &own, &p, &liquid, j);
            }
        }
        const force_sums liquid_sums = sums; /* a copy, so that the sums can stay in registers */
        force_sums all = sums;
        if (by.other)
            walls_of(s, &by, &g, &all, with, &k, &own, &walls);
        SPH2D__FOR_LANES (g, l)
            finish(s, g.first + (size_t)l, &all, &liquid_sums, l, with, &k);
        if (with.blocks)
            SPH2D__FOR_LANES (g, l)
                rate = fmax(rate, viscous_rate_of(s, g.first + (size_t)l, &all, l));
    }
    if (with.blocks)
        sph2d__viscous_rate_raise(s, rate);
}

/* ---- copies ------------------------------------------------------------------------------------------------------ */

/** The terms of a scene. */
static terms terms_of(const sph2d__system *s, sph2d_kernel kernel)
{
    const constants k = constants_of(s);
    terms with = {.kernel = kernel,
                  .detail = sph2d__wcsph_detail(&s->method),
                  .eddies = k.eddies > 0,
                  .blocks = s->viscosity_limits,
                  .variable = s->viscosities != NULL};
#ifndef SPH2D__BARE
    with.laplacian = k.viscosity.laplacian > 0;
#endif
    with.central =
        k.viscosity.central + k.viscosity.artificial > 0 || with.eddies || (with.variable && !with.laplacian);
    return with;
}

/* The copies of the loops for the usual kernel: detail, Laplacian and central form of viscosity, subgrid viscosity,
 * blocks; for syrups only with the usual terms. */
#define OF_DETAIL(X, detail) X(detail, 0, 0, 0, 0) X(detail, 0, 1, 0, 0) X(detail, 1, 0, 0, 0) X(detail, 1, 1, 0, 0)
#define WITH_EDDIES(X) X(SHIFT, 0, 1, 1, 0) X(SHIFT, 1, 1, 1, 0) X(SHIFT, 0, 1, 1, 1)
#ifdef SPH2D__SMALL /* a small library has none */
#define FOR_COPIES(X)
#else
#define FOR_COPIES(X)                                                                                                  \
    OF_DETAIL(X, NONE)                                                                                                 \
    OF_DETAIL(X, GRADIENT)                                                                                             \
    OF_DETAIL(X, EIGENVALUE)                                                                                           \
    OF_DETAIL(X, SHIFT)                                                                                                \
    WITH_EDDIES(X)
#endif

/* The kernel of nearly all scenes. */
static const sph2d_kernel USUAL = SPH2D_KERNEL_WENDLAND_C2;

/** Loops that test the terms: for those without a copy. */
static __attribute__((noinline)) void force_by_tests(sph2d__system *s, size_t first, size_t last, wall_adder *walls_of)
{
    force_with(s, first, last, terms_of(s, USUAL), walls_of);
}

/** Runs the copy with exactly the scene's terms, if there is one. */
SPH2D__INLINE void force_by_copy(sph2d__system *s, size_t first, size_t last, wall_adder *walls_of)
{
    const terms with = terms_of(s, USUAL);
#define TRY(of, form1, form2, form3, form4)                                                                            \
    if (with.detail == SPH2D__DETAIL_##of && with.laplacian == form1 && with.central == form2 &&                       \
        with.eddies == form3 && with.blocks == form4 && !with.variable) {                                              \
        force_with(s, first, last, (terms){USUAL, SPH2D__DETAIL_##of, form1, form2, form3, form4, false}, walls_of);   \
        return;                                                                                                        \
    }
    FOR_COPIES(TRY)
#undef TRY
    force_by_tests(s, first, last, walls_of);
}

/* For each kernel; unusual ones test their terms in the loops, which takes 2 % of a step. */
#define FOR_KERNEL(name, word)                                                                                         \
    static __attribute__((noinline)) void walls_##word(                                                                \
        const sph2d__system *s, const sph2d__grouping *by, const sph2d__group *g, force_sums *sums, terms with,        \
        const constants *k, const group_state *own, const sph2d__packed *walls)                                        \
    {                                                                                                                  \
        with.kernel = SPH2D_KERNEL_##name;                                                                             \
        add_walls(s, by, g, sums, with, k, own, walls);                                                                \
    }                                                                                                                  \
    static void force_##word(sph2d__system *s, size_t first, size_t last)                                              \
    {                                                                                                                  \
        if (SPH2D_KERNEL_##name == USUAL)                                                                              \
            force_by_copy(s, first, last, walls_##word);                                                               \
        else                                                                                                           \
            force_with(s, first, last, terms_of(s, SPH2D_KERNEL_##name), walls_##word);                                \
    }
SPH2D_KERNEL_MAP(FOR_KERNEL)

#define ENTRY(name, word) [SPH2D_KERNEL_##name] = force_##word,
const sph2d__wcsph_pass SPH2D__OF_ISA(sph2d__wcsph_force) = {{SPH2D_KERNEL_MAP(ENTRY)}};
