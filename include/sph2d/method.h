/* SPDX-License-Identifier: MIT */
/** @file method.h
 *  The table of methods: the use of each, its defaults, keys and walls. The resolver of defaults, the checker, `sph2d
 *  help methods` and the guards read it, so that a new method is one new row, and its forces.
 *
 *      const sph2d_method_info *method;
 *      for (size_t k = 0; (method = sph2d_method_row(k)) != NULL; ++k)
 *          printf("%s: %s\n", method->name, method->use); */
#ifndef SPH2D_METHOD_H
#define SPH2D_METHOD_H

#include "sph2d/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Features that not every method has: name, and the key of a scene that needs it. */
#define SPH2D_FEATURE_MAP(X)                                                                                           \
    X(OPERATORS, "method.operators")                                                                                   \
    X(KERNEL, "method.kernel")                                                                                         \
    X(ARTIFICIAL_VISCOSITY, "method.artificial_viscosity")                                                             \
    X(DENSITY_DIFFUSION, "method.density_diffusion")                                                                   \
    X(SHIFTING, "method.shifting")                                                                                     \
    X(TOLERANCE, "method.tolerance")                                                                                   \
    X(MAX_ITERATIONS, "method.max_iterations")                                                                         \
    X(SURFACE_TENSION, "fluid.surface_tension")                                                                        \
    X(WALL_SLIP, "wall_slip")                                                                                          \
    X(SMOOTH_WALLS, "wall_slip: smooth")                                                                               \
    X(FREE_SURFACE, "open sides, sources and drains")                                                                  \
    X(OPENINGS, "openings")                                                                                            \
    X(RHEOLOGY, "fluid.model")                                                                                         \
    X(BODIES, "bodies")                                                                                                \
    X(WALL_FORCES, "probes of kind force and work")

/** A feature that not every method has. */
typedef enum sph2d_feature {
    /** For keys that all methods have. */
    SPH2D_FEATURE_NONE = 0,
#define SPH2D__FEATURE_ENUM(name, key) SPH2D_FEATURE_##name,
    SPH2D_FEATURE_MAP(SPH2D__FEATURE_ENUM)
#undef SPH2D__FEATURE_ENUM
} sph2d_feature;

/** A method. One with several operators has a row for each of them. */
typedef struct sph2d_method_info {
    /** The method of the scene. */
    sph2d_method method;

    /** The operators that the row is for. */
    sph2d_operators operators;

    /** Word of scene files: "wcsph". */
    const char *word;

    /** Name for display: "wcsph with fitted operators". */
    const char *name;

    /** Its use, in one sentence. */
    const char *use;

    /** How density and pressure are computed. */
    const char *scheme;

    /** Its sources in the literature. */
    const char *source;

    /** Default support radius over spacing, H/dx, with kernel wendland_c2. */
    double support_ratio;

    /** Default intended compression, rho/rho0 - 1. */
    double max_compression;

    /** Features that it has: bits 1 << sph2d_feature. */
    uint32_t features;

    /** Forms of wall that it has: bits 1 << sph2d_wall_form. */
    uint32_t wall_forms;
} sph2d_method_info;

/** Row `index` of the table, recommended ones first; NULL after the last. Static storage. */
SPH2D_API const sph2d_method_info *sph2d_method_row(size_t index);

/** The row of a scene's method; the first one for an invalid value and for NULL. Never NULL. */
SPH2D_API const sph2d_method_info *sph2d_method_of(const sph2d_method_options *options);

/** Whether it has a feature; all have SPH2D_FEATURE_NONE. */
SPH2D_API bool sph2d_method_has(const sph2d_method_info *method, sph2d_feature feature);

/** The key that needs a feature, "method.kernel". Static storage; NULL for none. */
SPH2D_API const char *sph2d_feature_key(sph2d_feature feature);

#ifdef __cplusplus
}
#endif
#endif
