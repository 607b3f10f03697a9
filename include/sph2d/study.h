/* SPDX-License-Identifier: MIT */
/** @file study.h
 *  Studies: runs of one scene with overrides, what is measured in each run, and the expected results. Library
 *  libsph2d-io. This header describes study files; sph2d/study_results.h runs them.
 *
 *      scene: scene.yaml
 *      runs:
 *        - {name: coarse, set: {spacing: 0.02}}
 *        - {name: fine, set: {spacing: 0.01}}
 *      vary: {method.kernel: [wendland_c2, wendland_c4]}
 *      measures:
 *        - {name: decay rate, probe: energy, column: kinetic, take: last, expect: 0.25, bound: 0.01, order: true}
 *
 *  In fields documented with "NaN: none" NaN means that the value is not given; a file cannot give NaN. */
#ifndef SPH2D_STUDY_H
#define SPH2D_STUDY_H

#include "sph2d/io.h"

#ifdef __cplusplus
extern "C" {
#endif

/** One run of the scene: a row of the study's table. A study file lists runs, or values of keys whose combinations are
 *  runs, or both: then each run is combined with each of these. */
typedef struct sph2d_study_run {
    const char *name;                /**< for display; default: made from the overrides, "spacing=0.02" */
    const sph2d_override *overrides; /**< on top of the scene, in this order; default none */
    size_t override_count;
    const char *const *places; /**< of each override in the study, for sph2d_study_file_locate: `runs[0].set[2]`,
                                    `vary[1][0]` */
    int skip;                  /**< 1: runs only on demand, because it takes long; default 0 */
    const char *given;         /**< the name that a file gives it; NULL: none */
    size_t given_count;        /**< the number of first overrides that this name covers */
} sph2d_study_run;

/** Source of a measure. */
typedef enum sph2d_measure_source {
    SPH2D_MEASURE_NONE = 0,
    SPH2D_MEASURE_PROBE = 1,   /**< a column of a probe's series: value against time */
    SPH2D_MEASURE_PROFILE = 2, /**< the liquid along a line, at the end of the run */
    SPH2D_MEASURE_SUMMARY = 3  /**< a value of the run's summary */
} sph2d_measure_source;

/** How a series is reduced to one number. Undefined samples, where no particle is near the probe, are ignored; between
 *  samples the series is interpolated linearly. */
typedef enum sph2d_take {
    SPH2D_TAKE_DEFAULT = 0, /**< the whole series if a reference or the finest run is given, else `last` */
    SPH2D_TAKE_LAST,        /**< the last sample */
    SPH2D_TAKE_MAX,
    SPH2D_TAKE_MIN,
    SPH2D_TAKE_MEAN,     /**< over time */
    SPH2D_TAKE_RMS,      /**< root mean square over time */
    SPH2D_TAKE_SPREAD,   /**< max - min */
    SPH2D_TAKE_PERIOD,   /**< mean time [s] from one upward crossing of `level` to the next */
    SPH2D_TAKE_CROSSING, /**< time [s] when the series first reaches `level`, from either side */
    SPH2D_TAKE_VALUE,    /**< at the time `at` */
    SPH2D_TAKE_DECAY     /**< decay rate [1/s] of oscillations about `level`: minus the slope of the line fitted to the
                              logarithms of their peaks; a peak lies between two crossings in either direction */
} sph2d_take;

/** How the differences from a reference are reduced to one number. */
typedef enum sph2d_norm {
    SPH2D_NORM_MAX = 0, /**< the largest absolute difference */
    SPH2D_NORM_RMS = 1, /**< root mean square over the points of the reference */
    SPH2D_NORM_MEAN = 2 /**< mean of the absolute differences over the points of the reference */
} sph2d_norm;

/** Quantity of a profile. */
typedef enum sph2d_quantity {
    SPH2D_QUANTITY_VX = 0,       /**< [m/s] */
    SPH2D_QUANTITY_VY = 1,       /**< [m/s] */
    SPH2D_QUANTITY_SPEED = 2,    /**< [m/s] */
    SPH2D_QUANTITY_PRESSURE = 3, /**< [Pa] */
    SPH2D_QUANTITY_DENSITY = 4   /**< [kg/m^3] */
} sph2d_quantity;

/** A line across the liquid. */
typedef struct sph2d_study_profile {
    sph2d_points line; /**< its two ends [m]; must be given */
    sph2d_quantity value;
} sph2d_study_profile;

/** Points to compare with: two columns of a CSV file. Lines that start with # are comments, the first other line names
 *  the columns. A name matches with and without its unit in brackets; rows with an empty cell or nan are ignored. */
typedef struct sph2d_study_reference {
    const char *file; /**< path; in a study file relative to its folder */
    const char *x;    /**< column of times [s], or for a profile of positions along the line, 0 to 1 from end to end */
    const char *y;    /**< column of values, in units of `scale` */
    double shift;     /**< largest shift of its times for the best fit [s], >= 0: for experiments that start when a
                           gate opens; default 0 */
} sph2d_study_reference;

/** Values of a run's summary: fields of sph2d_summary. */
typedef enum sph2d_summary_value {
    SPH2D_SUMMARY_COMPRESSION = 0,      /**< compression_p99 */
    SPH2D_SUMMARY_COMPRESSION_MEAN = 1, /**< compression_mean */
    SPH2D_SUMMARY_COMPRESSION_MAX = 2,  /**< compression_max */
    SPH2D_SUMMARY_ENERGY_CHANGE = 3,    /**< kinetic + potential + elastic - energy_start - energy_fed, over
                                             |energy_start| unless that is 0 */
    SPH2D_SUMMARY_ITERATIONS = 4,       /**< iterations over steps */
    SPH2D_SUMMARY_ENERGY_RISE = 5,      /**< energy_rise over energy_scale */
    SPH2D_SUMMARY_ENERGY_ERROR = 6,     /**< energy_error over energy_scale */
    SPH2D_SUMMARY_DENSITY_APART = 7,    /**< density_apart, or the difference at the end if that is larger */
    SPH2D_SUMMARY_LEFT = 8              /**< particles lost through open sides */
} sph2d_summary_value;

enum { SPH2D_SUMMARY_VALUES = 9 };

/** The expected value of a measure. */
typedef enum sph2d_expectation {
    SPH2D_EXPECT_NOTHING = 0,
    SPH2D_EXPECT_NUMBER = 1,    /**< `expect` */
    SPH2D_EXPECT_REFERENCE = 2, /**< `reference` */
    SPH2D_EXPECT_FINEST = 3     /**< the result of the run with the smallest spacing; of several the last one */
} sph2d_expectation;

/** A quantity that is measured in every run. */
typedef struct sph2d_study_measure {
    const char *name; /**< heading of its column; must be given */
    sph2d_measure_source source;
    const char *probe;           /**< name of a probe of the scene */
    const char *column;          /**< of that probe, without its unit: sph2d_probe_columns() */
    sph2d_study_profile profile; /**< needs a reference, or the finest run, with which 101 points are compared */
    sph2d_summary_value summary;
    sph2d_take take; /**< default: see there */
    double level;    /**< period, crossing: in units of the column; NaN: none, for a period the mean */
    double at;       /**< value: when [s]; NaN: none */
    double from, to; /**< the part of the series that is used [s], both ends included; NaN: all of it */
    double scale;    /**< unit of the value, which is divided by it, > 0; default 1 */
    sph2d_expectation expectation;
    double expect; /**< in units of `scale` */
    sph2d_study_reference reference;
    int finest;      /**< 1 if the finest run is expected: its value if `take` is given, else its series */
    sph2d_norm norm; /**< of the differences from the reference or the finest run's series; default max */
    int relative;    /**< 1: the error is |value/expect - 1|, or the norm over the largest value of the finest run's
                          series; default 0: |value - expect|, and the norm itself */
    double bound;    /**< an error above it makes the study fail, >= 0; NaN: none */
    int order;       /**< 1: report the observed order of convergence, log(e1/e2)/log(dx1/dx2); default 0 */
} sph2d_study_measure;

/** A study. */
typedef struct sph2d_study {
    const char *scene; /**< path of the scene file; in a study file relative to its folder */
    const sph2d_study_run *runs;
    size_t run_count;           /**< 1 to SPH2D_STUDY_MOST_RUNS */
    const sph2d_override *vary; /**< what a file varies, {"spacing", "[0.02, 0.01]"}; `runs` has the combinations */
    size_t vary_count;
    /** Steps after the runs: each takes the rows with the smallest spacing so far that are on the Pareto front of error
     *  and time, and runs them again with its own overrides on top. Default none. */
    const sph2d_study_run *refinements;
    size_t refinement_count;
    const sph2d_study_measure *measures;
    size_t measure_count;
    uint64_t repeat;   /**< how often a run of less than SPH2D_STUDY_REPEATED seconds is repeated, 1 to 100; its time is
                            the least; default 1 */
    const char *judge; /**< the measure whose error is compared with the time; default: the first that has an error */
    const char *along; /**< the key on the axis of plots, in which the rows of one line differ; default spacing */
    double target;     /**< the error for which the cheapest run is reported, > 0; default 0.01 */
    const char *target_text; /**< as given in the file, "0.01" or "1%"; NULL: not given */
    int percent;             /**< 1: it is given in per cent, and errors are printed in per cent; default 0 */
} sph2d_study;

enum {
    SPH2D_STUDY_MOST_RUNS = 10000,
    SPH2D_STUDY_MOST_MEASURES = 1000, /**< and refinements */
    SPH2D_STUDY_REPEATED = 10         /**< [s] of stepping */
};

/** A study that was read, with everything it points to. */
typedef struct sph2d_study_file sph2d_study_file;

/** Reads and checks a study file. Every fault is reported at once with file, line, column and source line. The scene
 *  and the references are not opened: their paths are joined with the study file's folder. Errors: SPH2D_NOINPUT,
 *  SPH2D_SCENE (rejected), SPH2D_NOMEM. The caller owns *file (NULL after a failure). */
SPH2D_API sph2d_status sph2d_study_file_read(const char *path, sph2d_study_file **file, sph2d_report *report);

/** The same from memory. `name` is the name of the file in messages, and gives the folder of paths. */
SPH2D_API sph2d_status sph2d_study_file_parse(const char *text, size_t length, const char *name,
                                              sph2d_study_file **file, sph2d_report *report);

/** Frees a study file and the study in it; NULL is fine. */
SPH2D_API void sph2d_study_file_destroy(sph2d_study_file *file);

/** The study, valid as long as the file. */
SPH2D_API const sph2d_study *sph2d_study_file_study(const sph2d_study_file *file);

/** Completes a diagnostic about a key path of the study with file, line, column and source line: `measures[1].column`,
 *  or a place of a run's override. */
SPH2D_API void sph2d_study_file_locate(const sph2d_study_file *file, sph2d_diagnostic *diagnostic);

/** Writes a name of a run: its given name, then the overrides that this does not cover, "fine, support_ratio=3";
 *  "scene" if there are none. The key `but` (NULL: none) is omitted, and with it a given name that covers it. At most
 *  `size` bytes are written to `out`; returns the length of the whole name, like snprintf. */
SPH2D_API size_t sph2d_study_run_name(const sph2d_study_run *run, const char *but, char *out, size_t size);

/** The keys of a study file. Static storage. */
SPH2D_API const sph2d_keys *sph2d_study_keys(void);

#ifdef __cplusplus
}
#endif
#endif
