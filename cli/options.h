/* SPDX-License-Identifier: MIT */
/** @file options.h
 *  The options of all subcommands: parsed here, listed in option_table.c, given their meaning in option_values.c. */
#ifndef SPH2D_CLI_OPTIONS_H
#define SPH2D_CLI_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>

#include <sph2d/io.h>
#include <sph2d/sim.h>

/** What the colour bar of `render` shows: the range of the scene, else as percentiles; LOW..HIGH; the smallest to the
 *  largest value; the 1st to the 99th percentile. */
typedef enum range_kind { RANGE_DEFAULT, RANGE_FIXED, RANGE_FULL, RANGE_PERCENTILES } range_kind;

typedef enum progress_mode { PROGRESS_AUTO, PROGRESS_ALWAYS, PROGRESS_NEVER } progress_mode;

/** The parsed command line. Zero means not given. Strings are borrowed from argv. */
typedef struct cli_options {
    char *const *operands; /**< arguments that are not options: scenes, folders, snapshots */
    size_t operand_count;
    bool help, version;
    bool short_of_memory; /**< why they could not be read, if not for what they say */

    bool quiet, json, no_color;
    int verbose;
    progress_mode progress;

    const char *output;
    bool force;
    int threads, jobs, repeat;
    int shard, shards; /**< shard 1 to `shards`; 0 of 0: not given */
    double target;     /**< an error, > 0 */
    bool percent;      /**< given in per cent */
    sph2d_isa isa;
    int device;          /**< its number in the list, or among the graphics cards; 0: the processor */
    bool device_is_card; /**< the number is one of graphics cards */
    bool same_bits;
    double max_wall; /**< [s] */
    bool no_frames, no_checksum, dry_run, all, profile;
    sph2d_override *overrides; /**< owned; freed by options_free */
    size_t override_count;

    const char *gl, *shader_dir, *preview, *template_name, *film;
    double fps;             /**< frames for a second of the film; 0: not given */
    unsigned width, height; /**< [pixels] */
    bool style_given;
    sph2d_style style;
    bool background_given;
    sph2d_background background;
    bool look_given;
    sph2d_look look;
    double radius;  /**< [m] */
    double view[4]; /**< left, bottom, right, top [m]; all 0: not given */
    bool arrows, streamlines;
    const char *follow, *isolines;
    const char *color;
    range_kind range_kind;
    double range[2]; /**< of RANGE_FIXED */
} cli_options;

/** Parses argv[1] and on for the command `name`, whose bit is `command`; argv[0] is the command's own name. False after
 *  an error, which is reported. */
bool options_parse(cli_options *options, const char *name, unsigned command, int argc, char **argv);
void options_free(cli_options *options);

#endif
