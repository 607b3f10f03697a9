/* SPDX-License-Identifier: MIT */
/** @file cases.h
 *  The hard cases, after a list of ways to break a 2D SPH code: each is a function that a method can be put through,
 *  and tells figures with bounds. The program knows the libraries as a stranger does, by the public headers.
 *
 *  A case runs in a process of its own, on one thread and without wide vectors, so that its figures are the same on all
 *  machines of a kind. */
#ifndef SPH2D_HARD_CASES_H
#define SPH2D_HARD_CASES_H

#include <stdbool.h>
#include <stdio.h>

#include <sph2d/io.h>

/** The rows of a case. */
typedef enum case_method { MULLER, WCSPH, FITTED, PCISPH, CONSTRAINT, METHODS } case_method;

/** Sets of them. */
enum {
    BY_MULLER = 1 << MULLER,
    BY_WCSPH = 1 << WCSPH,
    BY_FITTED = 1 << FITTED,
    BY_PCISPH = 1 << PCISPH,
    BY_CONSTRAINT = 1 << CONSTRAINT,
    BY_SOLVERS = BY_PCISPH | BY_CONSTRAINT,
    BY_FREE = BY_MULLER | BY_WCSPH | BY_SOLVERS, /**< those with free surfaces */
    BY_ALL = BY_FREE | BY_FITTED
};

/** Where a case tells its figures. */
typedef struct outcome {
    FILE *file;
    case_method method;
} outcome;

/** A case. */
typedef struct hard_case {
    const char *id;        /**< letter and number of the list */
    const char *what;      /**< what is done to the liquid */
    const char *criterion; /**< what is asked of it */
    unsigned methods;      /**< BY_... */
    double seconds;        /**< CPU seconds that the slowest method takes; those below 1 are short */
    void (*run)(outcome *o);
} hard_case;

/** Cases of a letter. */
typedef struct case_list {
    const hard_case *items;
    size_t count;
} case_list;

/** A case that others judge already. */
typedef struct studied_case {
    const char *id, *what, *where;
} studied_case;

extern const case_list degenerate_cases, place_cases, invariance_cases, tension_cases, wall_cases, stiffness_cases,
    violent_cases;
extern const studied_case studied_cases[];
extern const size_t studied_case_count;

/** Tells a figure: it is met if value <= bound, so not if it is NaN. Measures of a case have names of their own. */
void tell(outcome *o, const char *name, double value, double bound);
/** Tells a figure that is looked at and not judged. */
void tell_only(outcome *o, const char *name, double value);
/** The same with a part of the name that varies. */
void tell_of(outcome *o, const char *name, const char *which, double value, double bound);

// ---- scenes ---------------------------------------------------------------------------------------------------------

/** A scene and its simulation. */
typedef struct stage {
    sph2d_scene_file *file;
    sph2d_scene scene; /**< a copy, to be changed before the start */
    sph2d_sim *sim;
    sph2d_report report; /**< of what was refused, or stopped the run */
    sph2d_status status;
} stage;

/** Reads a scene: `method` line by the row's method with `options` (as `time_step: 1e-3, cfl: 0.2`, or ""), then the
 *  text. False, and said, when it is refused. */
bool stage_read(stage *s, outcome *o, const char *options, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 4, 5)))
#endif
    ;
/** Adds particles, of rest density unless they say otherwise; borrowed. */
void stage_put(stage *s, const sph2d_particle *items, size_t count);
/** Creates the simulation. False, and said, when it is refused. */
bool stage_start(stage *s, outcome *o);
/** Both. */
#define STAGE_OPEN(s, o, options, ...) (stage_read(s, o, options, __VA_ARGS__) && stage_start(s, o))
/** The same without a word when it is refused: what there was to say is in the report. */
bool stage_try(stage *s);
/** Steps until `time`, or some steps; false when a guard stopped it, which is not said. */
bool stage_run(stage *s, double time);
bool stage_steps(stage *s, unsigned long steps);
/** The same, and said as the measure `stopped`. */
bool stage_finish(stage *s, outcome *o, double time);
void stage_close(stage *s);
/** The first error of the report, or what the status says. */
const char *stage_error(const stage *s);
/** Whether the report has this code. */
bool stage_reports(const stage *s, sph2d_code code);

// ---- particles ------------------------------------------------------------------------------------------------------

/** Fluid particles in the order of their numbers. */
typedef struct cloud {
    size_t count;
    double *x, *y, *vx, *vy, *density;
    double time;
} cloud;

cloud cloud_of(const sph2d_sim *sim);
void cloud_free(cloud *c);
/** Largest distance between a particle of `a` and the same of `b`; infinite when they are not as many. */
double cloud_apart(const cloud *a, const cloud *b);
/** Least distance to a neighbour; the part of particles with one nearer than `near`. */
double cloud_least(const cloud *c, double period);
double cloud_paired(const cloud *c, double period, double near);
/** Whether all numbers of all particles are finite. */
bool all_finite(const sph2d_sim *sim);
/** Largest speed, density over rest density, rms of density over rest density - 1. */
double speed_of(const sph2d_sim *sim);
double density_of(const sph2d_sim *sim);
double density_rms(const sph2d_sim *sim);
/** Particles at the start and those fed, without those now there, drained or lost: 0 unless some vanished. */
double ledger(const sph2d_sim *sim, size_t at_start);

/** Random numbers in [0, 1), the same everywhere. */
double uniform(uint64_t *seed);
/** A lattice of columns x rows particles at rest from `corner`, half a spacing inside; to be freed. */
sph2d_particle *lattice(size_t columns, size_t rows, double dx, sph2d_vec2 corner);

#define CASE_PI 3.14159265358979323846

#endif
