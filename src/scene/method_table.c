/* SPDX-License-Identifier: MIT */
/** @file method_table.c
 *  The table of methods. */
#include "scene/method_table.h"

#include "kernels/muller.h"

#define HAS(feature) (UINT32_C(1) << SPH2D_FEATURE_##feature)
#define WALL(form) (UINT32_C(1) << SPH2D_WALL_##form)

/** H/dx of pcisph: all kernels have the standard deviation (H over it: Dehnen & Aly 2012, table 1) of
 *  Wendland's C2 at 2.4. For a lattice strained to 1:2 the density sum of narrower kernels is 7 to 13 % too high, so
 *  that liquid expands; with these it is 2 to 3 %. */
static double projected_support(sph2d_kernel kernel)
{
    switch (kernel) {
    case SPH2D_KERNEL_WENDLAND_C4:
        return 2.75;
    case SPH2D_KERNEL_WENDLAND_C2:
        break;
    }
    return 2.4;
}

/* Bounds of the guards. Integrated densities never exceed theirs in a valid run. Summed densities have no lower bound,
 * and an upper one for liquid that collapses into a point. The energy bound is fifteen times the rise in valid
 * scenes. */
#define INTEGRATED_DENSITY .min_density = 0.2, .max_density = 5, .energy_rise = 0.1
#define SUMMED_DENSITY .summed_density = true, .min_density = 0, .max_density = 20, .energy_rise = 0.1

/* What both operators of wcsph share. */
#define WEAKLY_COMPRESSIBLE                                                                                            \
    .side_form = SPH2D_WALL_GENERALISED, .obstacle_form = SPH2D_WALL_GENERALISED, .has_sound = true,                   \
    .sound_compression = 1, INTEGRATED_DENSITY

static const sph2d__method_row rows[] = {
    {.info = {.method = SPH2D_METHOD_WCSPH,
              .operators = SPH2D_OPERATORS_VARIATIONAL,
              .word = "wcsph",
              .name = "wcsph with variational operators",
              .use = "water with a free surface, the default: pressures and waves with known errors",
              .scheme = "density by a rate that is exact for linear velocities, its transpose as force",
              .source = "Bonet & Lok 1999; Zhang, Hu & Adams 2017; Ren et al. 2023",
              .support_ratio = 3,
              .max_compression = 0.01,
              .features = HAS(OPERATORS) | HAS(KERNEL) | HAS(FREE_SURFACE) | HAS(BODIES) | HAS(WALL_FORCES) |
                          HAS(SURFACE_TENSION) | HAS(WALL_SLIP) | HAS(SMOOTH_WALLS) | HAS(RHEOLOGY) | HAS(OPENINGS),
              .wall_forms = WALL(GENERALISED)},
     .cfl = 0.2,
     .most_cfl = 0.25,
     .damping_hint = "more fluid.dynamic_viscosity",
     WEAKLY_COMPRESSIBLE},
    {.info = {.method = SPH2D_METHOD_WCSPH,
              .operators = SPH2D_OPERATORS_FITTED,
              .word = "wcsph",
              .name = "wcsph with fitted operators",
              .use = "liquid that fills its domain, without a surface: second order",
              .scheme = "quadratic least-squares derivatives, third-order Adams-Bashforth in time",
              .source = "Lancaster & Salkauskas 1981; Lind et al. 2012; Sun et al. 2019",
              .support_ratio = 2.5,
              .max_compression = 0.01,
              .features = HAS(OPERATORS) | HAS(DENSITY_DIFFUSION) | HAS(SHIFTING) | HAS(WALL_SLIP) | HAS(OPENINGS) |
                          HAS(WALL_FORCES),
              .wall_forms = WALL(GENERALISED)},
     .cfl = 0.25,
     .damping_hint = "more fluid.dynamic_viscosity",
     WEAKLY_COMPRESSIBLE},
    {.info = {.method = SPH2D_METHOD_CONSTRAINT,
              .word = "constraint",
              .name = "constraint",
              .use = "nearly incompressible liquid at large steps: images in a fraction of the time of wcsph",
              .scheme = "the operators of wcsph, one implicit solve over a step by conjugate gradients",
              .source = "Bonet & Lok 1999; Zhang, Hu & Adams 2017; Saad et al. 2000",
              .support_ratio = 3,
              .max_compression = 0.01,
              .features = HAS(KERNEL) | HAS(TOLERANCE) | HAS(MAX_ITERATIONS) | HAS(FREE_SURFACE) | HAS(BODIES) |
                          HAS(WALL_FORCES) | HAS(SURFACE_TENSION) | HAS(WALL_SLIP) | HAS(SMOOTH_WALLS) | HAS(RHEOLOGY) |
                          HAS(OPENINGS),
              .wall_forms = WALL(GENERALISED)},
     .cfl = 0.8,
     .cfl_by_spacing = true,
     .side_form = SPH2D_WALL_GENERALISED,
     .obstacle_form = SPH2D_WALL_GENERALISED,
     .sound_compression = 1,
     .convergence_hint = "method.tolerance",
     .damping_hint = "more fluid.dynamic_viscosity",
     INTEGRATED_DENSITY},
    {.info = {.method = SPH2D_METHOD_PCISPH,
              .word = "pcisph",
              .name = "pcisph",
              .use = "the same by prediction and correction, without a matrix, for comparison with the literature",
              .scheme = "pressure corrected iteratively until the density error is small",
              .source = "Solenthaler & Pajarola 2009",
              .support_ratio = 2.4,
              .max_compression = 0.01,
              .features = HAS(KERNEL) | HAS(MAX_ITERATIONS) | HAS(ARTIFICIAL_VISCOSITY) | HAS(SURFACE_TENSION) |
                          HAS(FREE_SURFACE) | HAS(BODIES) | HAS(WALL_FORCES),
              .wall_forms = WALL(GENERALISED)},
     .artificial_viscosity = 0.1,
     .free_compression = true,
     .sound_compression = 0.1, /* the iteration keeps max_compression */
     .convergence_hint = "method.max_compression",
     .support_of_kernel = projected_support,
     .cfl = 0.4,
     .cfl_by_spacing = true,
     .side_form = SPH2D_WALL_GENERALISED,
     .obstacle_form = SPH2D_WALL_GENERALISED,
     .damping_hint = "more fluid.dynamic_viscosity",
     SUMMED_DENSITY},
    {.info = {.method = SPH2D_METHOD_MULLER,
              .word = "muller",
              .name = "muller",
              .use = "compressible liquid in real time: plausible splashes, with compressions of several per cent",
              .scheme = "density as a sum, p = c0^2 (rho - rho0), leapfrog",
              .source = "Mueller, Charypar & Gross 2003, with two-dimensional kernel constants",
              .support_ratio = 2,
              .max_compression = 0.1,
              .features =
                  HAS(ARTIFICIAL_VISCOSITY) | HAS(SURFACE_TENSION) | HAS(FREE_SURFACE) | HAS(BODIES) | HAS(WALL_FORCES),
              .wall_forms = WALL(SPRING) | WALL(HEAVY) | WALL(REFLECT)},
     .cfl = 0.4,
     .artificial_viscosity = 0.1,
     .side_form = SPH2D_WALL_SPRING,
     .obstacle_form = SPH2D_WALL_HEAVY,
     .has_sound = true,
     .sound_compression = 1,
     .stiffness_part = sph2d__muller_stiffness,
     .damping_hint = "more fluid.dynamic_viscosity",
     SUMMED_DENSITY},
    {.info = {.method = SPH2D_METHOD_HYBRID,
              .word = "hybrid",
              .name = "hybrid",
              .use = "looking and playing: a fraction of the time of constraint, no pressures finer than its grid",
              .scheme = "densities and order by SPH, pressure and transport by a grid of 1.9 spacings",
              .source = "Raveendran, Wojtan & Turk 2011; Jiang et al. 2015; Kugelstadt et al. 2021",
              .support_ratio = 2.4,
              .max_compression = 0.02,
              .features = HAS(SURFACE_TENSION) | HAS(FREE_SURFACE) | HAS(WALL_SLIP) | HAS(BODIES),
              .wall_forms = WALL(GENERALISED)},
     .cfl = 0.9,
     .side_form = SPH2D_WALL_GENERALISED,
     .obstacle_form = SPH2D_WALL_GENERALISED,
     .sound_compression = 1,
     .keeps_volume = true,
     .damping_hint = "a smaller method.time_step",
     SUMMED_DENSITY},
};
enum { ROWS = sizeof rows / sizeof *rows };

#define ONE(name, word) +1
_Static_assert(ROWS == 0 SPH2D_METHOD_MAP(ONE) + 1, "a row for each method, and one more for wcsph's fitted operators");
#undef ONE

const sph2d__method_row *sph2d__method_row_of(const sph2d_method_options *options)
{
    const sph2d__method_row *found = NULL;
    for (size_t k = 0; k < ROWS; ++k)
        if (rows[k].info.method == options->name && (!found || rows[k].info.operators == options->operators))
            found = &rows[k];
    return found ? found : &rows[0];
}

const sph2d_method_info *sph2d_method_row(size_t index)
{
    return index < ROWS ? &rows[index].info : NULL;
}

const sph2d_method_info *sph2d_method_of(const sph2d_method_options *options)
{
    if (!options)
        return &rows[0].info;
    return &sph2d__method_row_of(options)->info;
}

bool sph2d_method_has(const sph2d_method_info *method, sph2d_feature feature)
{
    return method && (feature == SPH2D_FEATURE_NONE || (method->features >> feature & 1));
}

const char *sph2d_feature_key(sph2d_feature feature)
{
    switch (feature) {
    case SPH2D_FEATURE_NONE:
        break;
#define KEY(name, key)                                                                                                 \
    case SPH2D_FEATURE_##name:                                                                                         \
        return key;
        SPH2D_FEATURE_MAP(KEY)
#undef KEY
    }
    return NULL;
}
