/* SPDX-License-Identifier: MIT */
/** @file study_results.h
 *  Running a study: each row from scene to record, and from records to errors, orders of convergence, the Pareto front
 *  of error and time, and the cheapest row. Library libsph2d-study.
 *
 *      sph2d_study_file *file = NULL;
 *      sph2d_study_results *results = NULL;
 *      if (sph2d_study_file_read("study.yaml", &file, &report) != SPH2D_OK) ...;
 *      if (sph2d_study_results_create(file, NULL, 0, false, &results, &report) != SPH2D_OK) ...;
 *      for (size_t r = 0; r < results->row_count; ++r)
 *          if (results->rows[r].wanted)
 *              sph2d_study_row_run(results, &results->rows[r], NULL, &report);
 *      if (sph2d_study_results_measure(results) != SPH2D_OK) ...;
 *      const sph2d_study_row *row = sph2d_study_cheapest(results, 0.01);
 *      if (row) printf("%s: %g s\n", row->run.name, row->record.cpu);
 *
 *  Rows may be run in any order, and by different processes: sph2d_study_record_pack() serialises the record of a row.
 *  Nothing here prints; messages are in the report. Only one thread at a time may be in this library. Measured values
 *  that are not known are NaN. */
#ifndef SPH2D_STUDY_RESULTS_H
#define SPH2D_STUDY_RESULTS_H

#include "sph2d/study.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- records of rows --------------------------------------------------------------------------------------------- */

/** How a row ended. */
typedef enum sph2d_study_end {
    SPH2D_STUDY_FINISHED = 0,
    /** A guard stopped the run. */
    SPH2D_STUDY_GUARD = 1,
    /** It could not be created, or memory was short. */
    SPH2D_STUDY_FAILED = 2,
    /** The caller asked to stop. */
    SPH2D_STUDY_STOPPED = 3,
    /** Its process was killed, or crashed: for programs that run rows in separate processes. */
    SPH2D_STUDY_DIED = 4
} sph2d_study_end;

/** A table of results: the time series of a probe, or the liquid at the end at points along the line of a profile. */
typedef struct sph2d_study_series {
    /** Name of the probe, which has 64 letters at most; "" for a profile. */
    char probe[72];
    /** Of the probe: sph2d_probe_columns() names its columns. */
    sph2d_probe_kind kind;
    /** Of a profile: its quantity ... */
    sph2d_quantity quantity;
    /** ... and the ends of its line [m]. */
    sph2d_vec2 ends[2];
    /** Values in a row, besides the time [s] or the position, 0 to 1 from end to end, which comes first. */
    size_t columns;
    /** Number of rows, and capacity. */
    size_t count, room;
    /** The rows, one after another; NaN where no particle is near. Owned. */
    double *rows;
} sph2d_study_series;

/** The data from which all measures are computed. Times are the least of the repeats. Start it with {0}. */
typedef struct sph2d_study_record {
    sph2d_study_end end;
    /** Status at its end; SPH2D_OK unless a guard stopped it or it failed. */
    sph2d_status status;
    /** Why it did not finish, in one line; "" if it did. */
    char reason[320];
    /** The instruction set in use, "avx2"; "" if it could not be created. */
    char isa[16];
    /** [m] */
    double spacing;
    /** Simulated [s]. */
    double time;
    /** Particles at the end, and those lost through open sides. */
    uint64_t particles, left;
    uint64_t steps, particle_steps;
    /** How often it was run. */
    uint64_t repeats;
    /** CPU time and wall time of the steps only [s]; wall is NaN if other rows ran at the same time. */
    double cpu, wall;
    /** CPU time of reading the scene and placing particles, and of evaluating the probes [s]. */
    double start, probes;
    /** By sph2d_summary_value. */
    double summary[SPH2D_SUMMARY_VALUES];
    /** One for each probe of the scene, then one for each profile of the study. Owned. */
    sph2d_study_series *series;
    size_t series_count;
} sph2d_study_record;

/** Serialises a record as a block of bytes with a checksum, for this build of the library: at most `size` bytes to
 *  `out`. Returns the length of the whole block, like snprintf. */
SPH2D_API size_t sph2d_study_record_pack(const sph2d_study_record *record, void *out, size_t size);

/** Reads such a block into an empty record, which the caller frees. After an error it is empty. Errors: SPH2D_FORMAT
 *  when the block is incomplete or invalid, SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_study_record_unpack(sph2d_study_record *record, const void *block, size_t size);

/** Frees what a record owns and empties it. */
SPH2D_API void sph2d_study_record_free(sph2d_study_record *record);

/* ---- rows and results -------------------------------------------------------------------------------------------- */

/** The result of one measure in one row. */
typedef struct sph2d_study_value {
    /** In units of the measure's scale; NaN for a measure that compares whole curves. */
    double value;
    /** Difference from the expected value. */
    double error;
    /** Order of convergence, from a coarser row before. */
    double order;
} sph2d_study_value;

/** A run of the study and its results. */
typedef struct sph2d_study_row {
    /** From 1: runs in the order of the study file, then refinements. */
    uint64_t number;
    /** Its pointers belong to the study file, or to the row if `owned` is set: a refinement. */
    sph2d_study_run run;
    bool owned;
    /** It is to be run: the study does not skip it, or all rows are requested. */
    bool wanted;
    /** The record is present. Set by those who fill it. */
    bool there;
    /** On the Pareto front: no other row has both a smaller error and less time. */
    bool on_front;
    /** Everything that the row depends on, by sph2d_study_row_key(); NULL before. Owned. */
    char *key;
    sph2d_study_record record;
    /** Particle-steps per second of stepping: of wall time if that is known, else of CPU time. */
    double rate;
    /** One for each measure. Owned. */
    sph2d_study_value *values;
} sph2d_study_row;

/** Points of a curve, x ascending unless they are a reference's. */
typedef struct sph2d_study_curve {
    const double *x, *y;
    size_t count;
} sph2d_study_curve;

/** A study in progress, made by sph2d_study_results_create(). Its members may be read. */
typedef struct sph2d_study_results {
    /** Borrowed, as are the overrides on top of every row. */
    const sph2d_study_file *file;
    const sph2d_study *study;
    const sph2d_override *overrides;
    size_t override_count;
    /** The reference of each measure; for a profile of the finest run only the positions; else empty. */
    sph2d_study_curve *references;
    sph2d_study_row *rows;
    size_t row_count;
    /** The measure whose error is compared with the time; measure_count if none has an error. */
    size_t judge;
} sph2d_study_results;

/** Prepares a study: reads the references, reads the scene of every row, places the particles of those that are wanted
 *  and checks that the measures fit the scene, so that errors are found before the runs. `overrides` are those on top
 *  of every row; with `all` the rows that the study skips are wanted too. File and overrides are borrowed until the
 *  results are destroyed. Errors, in the report with their positions: SPH2D_NOINPUT, SPH2D_FORMAT, SPH2D_SCENE,
 *  SPH2D_NOMEM. The caller owns *results, which is NULL after a failure. */
SPH2D_API sph2d_status sph2d_study_results_create(const sph2d_study_file *file, const sph2d_override *overrides,
                                                  size_t override_count, bool all, sph2d_study_results **results,
                                                  sph2d_report *report);

/** Frees results; NULL is fine. */
SPH2D_API void sph2d_study_results_destroy(sph2d_study_results *results);

/** The text of a study of the spacing and the stiffness of a scene: three spacings with two stiffnesses each, then the
 *  best of the finest at a smaller spacing, with which all are compared. The overrides become part of it. Errors: as
 *  sph2d_scene_file_read(). The caller frees *text with free(). */
SPH2D_API sph2d_status sph2d_study_text_for_scene(const char *path, const sph2d_override *overrides,
                                                  size_t override_count, char **text, sph2d_report *report);

/* ---- running ----------------------------------------------------------------------------------------------------- */

/** How rows are run. Start it with {0}. */
typedef struct sph2d_study_run_options {
    /** As in sph2d_sim_options; default 0: those of OpenMP, fewer where there are few particles. */
    int threads;
    /** Default auto. */
    sph2d_isa isa;
    /** As in sph2d_sim_options; default 0: the processor, and false. */
    int device;
    bool same_bits;
    /** How often a row of less than SPH2D_STUDY_REPEATED seconds is run; default 0: the study's value. */
    uint64_t repeat;
    /** Other rows run at the same time, so that wall time is not recorded; default false. */
    bool beside_others;
    /** Called before every step; false ends the row as SPH2D_STUDY_STOPPED. It may print the report so far and clear
     *  it. Default NULL: runs to the end. */
    bool (*go_on)(void *user, const sph2d_study_run *run, const sph2d_sim *sim);
    void *user;
} sph2d_study_run_options;

/** Reads the scene of a run, with its overrides and those on top of every row. Errors in overrides are reported at
 *  their positions in the study. Errors: as sph2d_scene_file_read(). The caller owns *file, which is NULL after a
 *  failure. */
SPH2D_API sph2d_status sph2d_study_run_scene(const sph2d_study_results *results, const sph2d_study_run *run,
                                             sph2d_scene_file **file, sph2d_report *report);

/** The scene of a run as text that reads the same from any folder. Errors: as sph2d_study_run_scene(). The caller frees
 *  *text with free(). */
SPH2D_API sph2d_status sph2d_study_run_scene_text(const sph2d_study_results *results, const sph2d_study_run *run,
                                                  char **text, sph2d_report *report);

/** Runs a row and fills its record, which must be empty. `options` may be NULL. Returns the record's status; messages
 *  in the report name the row. */
SPH2D_API sph2d_status sph2d_study_row_run(const sph2d_study_results *results, sph2d_study_row *row,
                                           const sph2d_study_run_options *options, sph2d_report *report);

/** Sets the row's key: `program`, a text that identifies everything but the scene (version, compiler, processor,
 *  threads), and the scene with all values. Errors: as sph2d_study_run_scene(). */
SPH2D_API sph2d_status sph2d_study_row_key(const sph2d_study_results *results, sph2d_study_row *row,
                                           const char *program, sph2d_report *report);

/** Fills a row, whose record must be empty, with the record that sph2d_study_row_keep() stored in `folder` under the
 *  row's key. False if there is no key or no file, or if the file is damaged or lacks a quantity that the study
 *  measures now: the record is then empty. */
SPH2D_API bool sph2d_study_row_find(const sph2d_study_results *results, sph2d_study_row *row, const char *folder);

/** Stores the record of a row that finished or that a guard stopped in `folder`, as a file named after its key. Errors:
 *  SPH2D_INVALID without a key, SPH2D_CANTCREAT, SPH2D_IO, SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_study_row_keep(const sph2d_study_row *row, const char *folder, sph2d_report *report);

/* ---- results ----------------------------------------------------------------------------------------------------- */

/** Whether a measure has a value, not only the error of a whole curve; whether it has an expected value. */
SPH2D_API bool sph2d_study_has_value(const sph2d_study_measure *measure);
SPH2D_API bool sph2d_study_has_error(const sph2d_study_measure *measure);

/** Sets the values, errors and orders of all rows that have a record, and marks the Pareto front. Errors: SPH2D_NOMEM.
 */
SPH2D_API sph2d_status sph2d_study_results_measure(sph2d_study_results *results);

/** Reports problems with the values of a measured row: a warning with the reason for each that is not known, an error
 *  for each with an error above its bound, or not known. What is compared with the finest row is not judged while a row
 *  that is wanted has no record. */
SPH2D_API void sph2d_study_row_judge(const sph2d_study_results *results, const sph2d_study_row *row,
                                     sph2d_report *report);

/** Adds the rows of refinement `step` of the study: the rows on the Pareto front of those with the smallest spacing,
 *  each with the step's overrides on top. The rows must have been measured; pointers to them become invalid. Errors:
 *  SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_study_results_refine(sph2d_study_results *results, size_t step);

/** The error of a row in the measure `judge`; NaN when it has none. */
SPH2D_API double sph2d_study_row_error(const sph2d_study_results *results, const sph2d_study_row *row);

/** The row with the least CPU time of those whose error is at most `target`, and the row with the smallest error; NULL
 *  when there is none. */
SPH2D_API const sph2d_study_row *sph2d_study_cheapest(const sph2d_study_results *results, double target);
SPH2D_API const sph2d_study_row *sph2d_study_best(const sph2d_study_results *results);

/** The value of the study's `along` key in a row: its spacing, or the number that it sets; NaN if it sets none. */
SPH2D_API double sph2d_study_row_along(const sph2d_study_results *results, const sph2d_study_row *row);

/** Whether two rows differ only in the `along` key: they are on one line of a plot. */
SPH2D_API bool sph2d_study_rows_belong(const sph2d_study_results *results, const sph2d_study_row *a,
                                       const sph2d_study_row *b);

/** The order of convergence of the rows on one line with `row`: the slope of log(error) over log(along), by least
 *  squares; NaN for fewer than two values of the key. */
SPH2D_API double sph2d_study_row_order(const sph2d_study_results *results, const sph2d_study_row *row);

#ifdef __cplusplus
}
#endif
#endif
