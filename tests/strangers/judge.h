/* SPDX-License-Identifier: MIT */
/** @file judge.h
 *  Invariants of a scene, whatever it is. The program is known as a stranger knows it: by the public headers and by the
 *  command. */
#ifndef SPH2D_STRANGERS_JUDGE_H
#define SPH2D_STRANGERS_JUDGE_H

#include <stdbool.h>
#include <stdio.h>

#include <sph2d/io.h>

/** What was found, written down at once, so that it outlives a crash: "invariant<TAB>sentence" a line. */
typedef struct verdict {
    FILE *file;
    const char *only; /**< the invariant that is judged; NULL: all */
} verdict;

/** Notes that an invariant does not hold, in a sentence with the numbers. */
void verdict_fail(verdict *v, const char *invariant, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

/** The bounds. */
#define GRID_ENERGY_BOUND 0.02 /* the same of method hybrid, whose summary tells what came from nothing */
#define ENERGY_BOUND 0.001     /* rise above any earlier moment over the scene's scale */
#define PACKING_BOUND 0.02     /* mean density by counting less the mean of what is reported, over rest density */
#define PACKING_SLACK                                                                                                  \
    0.2 /* and this part of what is reported: kernels of other widths see other means where it varies */
#define DENSITY_LOW 0.25    /* least density over rest density where density is integrated */
#define DENSITY_HIGH 4.0    /* largest, of liquid that does not start compressed */
#define CONTACTS_BOUND 0.01 /* energy that contacts give back of what they took: a step's forces act on both sides */
#define GAPS_BOUND 0.05     /* work of the pressure in thin gaps, of the energy scale: it lifts a body by a spacing */
#define OPENED_BOUND 0.05   /* energy unaccounted for, of the scene's, where liquid flows in and out */
#define OVERLAP_BOUND 0.1   /* of bodies with each other, obstacles and sides [spacings] */
#define INSIDE_BOUND 0.2    /* how deep liquid is in a body [spacings] */
#define STEPS_BOUND 1.5     /* steps over those that check foretells, or these over those; the worst of 90 had 1.4 */
#define STEPS_SLACK 10      /* and so many more or less, of short runs */
#define SPEED_BOUND 4       /* largest speed over that of the plan's heads: a jet from a corner had 3.3 times it */
#define PRESSED_BOUND                                                                                                  \
    3.5 /* compression over max_compression, or what check tells instead; two blocks that meet had 3.2 */
#define UNPRESSED_BOUND 0.1 /* compression over what a warning tells */

/** What a run by the library found. Numbers that were not judged are NaN. */
typedef struct library_run {
    bool started, finished;
    bool opened;               /**< the scene has openings */
    double compression_max;    /**< largest rho/rho0 - 1 over all particles and steps */
    double fastest;            /**< largest speed over all particles and steps [m/s] */
    double scale, rise, since; /**< energy scale [J/m]; largest rise over it; when that was reached [s] */
    double packing, density;   /**< mean density over rest density inside the liquid, by counting and as reported */
    double p99, highest;       /**< of the compression by counting */
    double overlap, taken;     /**< of bodies, the deepest [spacings]; most that contacts gave back over the scale */
    sph2d_summary summary;
} library_run;

/** Whether `check` warns that gravity along a period makes the liquid too fast. */
bool foretells_fall(const char *messages);
/** Compares what `check` told, its numbers as a line of JSON and its messages, with what the run found. */
void judge_plan(const char *told, const char *messages, const sph2d_sim *sim, const library_run *run, verdict *v);
/** The first number with that key in a text of JSON; NaN without one. */
double number(const char *json, const char *key);

/** Whether the scene has no drive, so that its energy cannot rise. */
bool scene_is_closed(const sph2d_scene *scene);
/** Whether no obstacle moves. */
bool walls_are_at_rest(const sph2d_scene *scene);
/** The energy that a scene has to spend at its start [J/m], by which a rise is measured; see energy.c. */
double energy_scale(const sph2d_scene *scene, const sph2d_sim *sim);
/** Elastic energy [J/m] of liquid with a state equation; 0 for the others. */
double elastic_energy(const sph2d_scene *scene, const sph2d_plan *plan, const sph2d_view *fluid);
/** The same of method pcisph, by the compression that pressure holds, or, at the start, that density
 *  has; of pcisph what is beyond the compression that its solver stops at. */
double held_energy(const sph2d_scene *scene, const sph2d_plan *plan, const sph2d_view *fluid, bool start);
/** Counts particles inside the liquid, at least 20, away from walls and surfaces: fills packing to highest. */
void measure_packing(const sph2d_scene *scene, const sph2d_sim *sim, library_run *run);

/** Mass of a body [kg/m], and energy of all bodies and springs that counts for energy_scale() [J/m]. */
double body_mass(const sph2d_body *body);
double bodies_scale(const sph2d_scene *scene, double (*fall)(const sph2d_scene *, double x, double y));
/** How deep bodies overlap each other, obstacles and sides that are walls now, the most [m]; says what does. */
double bodies_overlap(const sph2d_scene *scene, const sph2d_sim *sim, char text[200]);
/** Particles that lie in bodies deeper than so much [m]. */
size_t particles_in_bodies(const sph2d_scene *scene, const sph2d_sim *sim, double depth);
/** Whether all that is known of bodies is finite. */
bool bodies_are_finite(const sph2d_scene *scene, const sph2d_sim *sim);

/** A judgement that is asked for. Strings are borrowed. */
typedef struct judge_request {
    const char *command;  /**< path of sph2d; NULL: the library alone */
    const char *scene;    /**< path of the scene file */
    const char *folder;   /**< for what is written */
    const char *isa;      /**< instruction set, by its name */
    const char **changes; /**< `key=value`, on top of the scene */
    size_t change_count;
} judge_request;
enum { MOST_CHANGES = 16, CHANGE_SIZE = 600 };

/** Runs a scene in this process on one thread, and looks at every step. What is left is in *sim, to be destroyed by the
 *  caller; NULL where it did not start. */
library_run judge_by_library(const judge_request *request, const sph2d_scene *scene, verdict *v, sph2d_sim **sim);

/** Reads the scene with its changes; false when it is refused. The caller destroys *file. */
bool read_scene(const judge_request *request, sph2d_scene_file **file);

/** Checks, runs, stops and resumes a scene by the command, and compares all of that with each other and with a run in
 *  this process. */
library_run judge_scene(const judge_request *request, verdict *v);

/** Prints the keys of scenes that none of these files gives another value than the default; returns 0, or 2 when one
 *  cannot be read. */
int tell_unused(const char *const *scenes, size_t count);

#endif
