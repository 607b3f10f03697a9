/* SPDX-License-Identifier: MIT */
/** @file options.c
 *  The table of options, and their parsing with getopt_long. */
#include "options.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "film.h"
#include "frame.h"
#include "message.h"
#include "parse.h"
#include "text.h"

/* Options without a short form. */
enum {
    OPTION_JSON = 256,
    OPTION_NO_COLOR,
    OPTION_PROGRESS,
    OPTION_ISA,
    OPTION_MAX_WALL,
    OPTION_NO_FRAMES,
    OPTION_NO_CHECKSUM,
    OPTION_GL,
    OPTION_SHADER_DIR,
    OPTION_SIZE,
    OPTION_STYLE,
    OPTION_LOOK,
    OPTION_BACKGROUND,
    OPTION_VIEW,
    OPTION_FOLLOW,
    OPTION_ARROWS,
    OPTION_STREAMLINES,
    OPTION_ISOLINES,
    OPTION_RADIUS,
    OPTION_COLOR,
    OPTION_RANGE,
    OPTION_FILM,
    OPTION_FPS,
    OPTION_PREVIEW,
    OPTION_TEMPLATE,
    OPTION_ALL,
    OPTION_TARGET,
    OPTION_REPEAT,
    OPTION_PROFILE,
    OPTION_SHARD
};

enum {
    SIMULATES = CLI_RUN | CLI_RESUME | CLI_CHECK,
    DRAWS = CLI_RUN | CLI_RESUME | CLI_RENDER | CLI_CHECK,
};

/* The values of options that have a list of them, in the order of their enums. */
static const char *const isa_words[] = {"auto", "baseline", "avx2", "avx512", NULL};
static const char *const progress_words[] = {"auto", "always", "never", NULL};
static const char *const style_words[] = {"metaballs", "points", NULL};
static const char *const look_words[] = {"water", "flat", "glass", "ink", NULL};
static const char *const background_words[] = {"opaque", "transparent", NULL};
static const char *const gl_words[] = {"osmesa", "egl", NULL};

static const option_row rows[] = {
    {'o', "output", "DIR", CLI_RUN | CLI_RENDER | CLI_STUDY, "folder for the files; empty, new, or a study's own"},
    {'o', "output", "FILE", CLI_PLOT, "file for the picture, .svg or .png; default DIR/plot.svg"},
    {'o', "output", "FILE", CLI_EXPORT, "CSV file; default the standard output"},
    {'f', "force", NULL, CLI_RUN | CLI_RENDER | CLI_INIT | CLI_STUDY,
     "replace the files of an earlier run there; a study runs all rows again"},
    {'s', "set", "KEY=VALUE", CLI_RUN | CLI_RESUME | CLI_PLAY | CLI_CHECK | CLI_STUDY,
     "change a key of the scene: fluid.density=800"},
    {'n', "dry-run", NULL, CLI_RUN, "only check the scene, as 'sph2d check' does"},
    {'j', "threads", "N", DRAWS | CLI_PLAY | CLI_STUDY,
     "threads; else OMP_NUM_THREADS, else every processor this process may use"},
    {OPTION_ISA, "isa", "NAME", CLI_RUN | CLI_PLAY | CLI_CHECK | CLI_STUDY,
     "instruction set: auto, baseline, avx2 or avx512"},
    {OPTION_MAX_WALL, "max-wall", "TIME", CLI_RUN | CLI_RESUME | CLI_PLAY,
     "stop after TIME (90s, 45m, 3h), a run with a checkpoint"},
    {OPTION_NO_FRAMES, "no-frames", NULL, CLI_RUN | CLI_RESUME, "draw no frames"},
    {OPTION_PROFILE, "profile", NULL, CLI_RUN | CLI_RESUME, "print the time of each phase of the steps"},
    {OPTION_NO_CHECKSUM, "no-checksum", NULL, CLI_RESUME | CLI_RENDER | CLI_EXPORT | CLI_INFO,
     "read snapshots that another program has changed"},
    {'J', "jobs", "N", CLI_STUDY, "rows that run at a time, each in its own process; default 1"},
    {OPTION_SHARD, "shard", "I/N", CLI_STUDY,
     "run every Nth row from row I on, beside other shards on the same folder"},
    {OPTION_REPEAT, "repeat", "N", CLI_STUDY, "repeat rows of less than 10 s; the shortest time counts"},
    {OPTION_TARGET, "target", "ERROR", CLI_STUDY, "name the cheapest row within this error: 1%, 0.01"},
    {OPTION_ALL, "all", NULL, CLI_STUDY, "also run the rows that the study skips"},
    {OPTION_TEMPLATE, "template", "NAME", CLI_INIT, "the template to use; 'sph2d help init' lists them"},
    {OPTION_SIZE, "size", "WxH", CLI_RENDER | CLI_PLAY, "size of the frames or the window in pixels"},
    {OPTION_STYLE, "style", "NAME", CLI_RENDER | CLI_PLAY, "metaballs or points"},
    {OPTION_LOOK, "look", "NAME", CLI_RENDER | CLI_PLAY, "of metaballs: water, flat, glass or ink"},
    {OPTION_BACKGROUND, "background", "NAME", CLI_RENDER, "opaque or transparent"},
    {OPTION_VIEW, "view", "X,Y,X,Y", CLI_RENDER, "lower left and upper right corner of what is shown in metres"},
    {OPTION_FOLLOW, "follow", "NAME", CLI_RENDER, "keep an obstacle or body in the middle"},
    {OPTION_ARROWS, "arrows", NULL, CLI_RENDER, "draw arrows of the velocity"},
    {OPTION_STREAMLINES, "streamlines", NULL, CLI_RENDER, "draw evenly spaced lines along the velocity"},
    {OPTION_ISOLINES, "isolines", "FIELD", CLI_RENDER, "draw lines of equal values: speed, vorticity, Pressures"},
    {OPTION_RADIUS, "radius", "M", CLI_RENDER, "radius of a metaball or point in metres"},
    {OPTION_COLOR, "color", "FIELD", CLI_RENDER | CLI_PLAY, "colour by a field: speed, vorticity, Pressures"},
    {OPTION_RANGE, "range", "MIN,MAX", CLI_RENDER, "values at the ends of the colour bar"},
    {OPTION_FILM, "film", "FILE", CLI_RENDER, "make a film in place of PNG files, by ffmpeg: .mp4, .gif, .png, .apng"},
    {OPTION_FPS, "fps", "N", CLI_RENDER, "snapshots for each second of the film; else it has the scene's pace"},
    {OPTION_PREVIEW, "preview", "FILE", CLI_CHECK, "draw the first frame into a PNG file"},
    {OPTION_GL, "gl", "NAME", DRAWS, "OpenGL context: osmesa or egl"},
    {OPTION_SHADER_DIR, "shader-dir", "DIR", DRAWS | CLI_PLAY,
     "read the shaders from DIR instead of the built-in ones"},
    {OPTION_PROGRESS, "progress", "WHEN", CLI_RUN | CLI_RESUME | CLI_RENDER | CLI_STUDY,
     "auto, always (a bar) or never"},
    {OPTION_JSON, "json", NULL, CLI_ALL, "results and messages as JSON, one object per line"},
    {'q', "quiet", NULL, CLI_ALL, "no notices, progress or summary; errors only"},
    {'v', "verbose", NULL, CLI_ALL, "print more details"},
    {OPTION_NO_COLOR, "no-color", NULL, CLI_ALL, "no colour, as with NO_COLOR set"},
    {'h', "help", NULL, CLI_ALL, "show this help"},
    {'V', "version", NULL, CLI_ALL, "show the version"},
};
enum { ROW_COUNT = sizeof rows / sizeof *rows };

const option_row *options_row(size_t i)
{
    return i < ROW_COUNT ? &rows[i] : NULL;
}

const char *const *options_words(const option_row *row)
{
    switch (row->id) {
    case OPTION_ISA:
        return isa_words;
    case OPTION_PROGRESS:
        return progress_words;
    case OPTION_STYLE:
        return style_words;
    case OPTION_LOOK:
        return look_words;
    case OPTION_BACKGROUND:
        return background_words;
    case OPTION_GL:
        return gl_words;
    default:
        return NULL;
    }
}

void options_print(unsigned command)
{
    for (size_t i = 0; i < ROW_COUNT; ++i) {
        if ((rows[i].commands & command) == 0)
            continue;
        char left[48];
        char letter[5] = "    ";
        if (rows[i].id < 256)
            snprintf(letter, sizeof letter, "-%c, ", rows[i].id);
        snprintf(left, sizeof left, "%s--%s%s%s", letter, rows[i].name, rows[i].argument ? " " : "",
                 rows[i].argument ? rows[i].argument : "");
        printf("  %-24s %s\n", left, rows[i].text);
    }
}

/* ---- errors ------------------------------------------------------------------------------------------------------ */

static bool bad_value(const char *name, const char *option, const char *value, const char *expected)
{
    message_usage(name, "--%s: '%s' is not %s", option, value, expected);
    return false;
}

static void unknown_option(const char *name, unsigned command, const char *given)
{
    char word[64];
    snprintf(word, sizeof word, "%s", given[0] == '-' && given[1] == '-' ? given + 2 : given);
    word[strcspn(word, "=")] = '\0';
    const char *names[ROW_COUNT];
    size_t count = 0;
    for (size_t i = 0; i < ROW_COUNT; ++i) {
        if ((rows[i].commands & command) != 0) {
            names[count++] = rows[i].name;
        } else if (strcmp(rows[i].name, word) == 0) {
            message_usage(name, "'--%s' is not an option %s", word, name ? "of this command" : "without a command");
            return;
        }
    }
    const char *nearest = text_nearest(word, names, count);
    if (nearest)
        message_usage(name, "unknown option '%s'; did you mean '--%s'?", given, nearest);
    else
        message_usage(name, "unknown option '%s'", given);
}

/* ---- values ------------------------------------------------------------------------------------------------------ */

/* The index of `value` in a NULL-terminated list, or -1. */
static int find_word(const char *value, const char *const *words)
{
    for (int i = 0; words[i]; ++i)
        if (strcmp(value, words[i]) == 0)
            return i;
    return -1;
}

static bool add_override(cli_options *options, const char *name, char *pair)
{
    char *equals = strchr(pair, '=');
    if (!equals || equals == pair)
        return bad_value(name, "set", pair, "KEY=VALUE");
    sph2d_override *grown = realloc(options->overrides, (options->override_count + 1) * sizeof *grown);
    if (!grown) {
        message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
        options->short_of_memory = true;
        return false;
    }
    *equals = '\0';
    grown[options->override_count++] = (sph2d_override){pair, equals + 1};
    options->overrides = grown;
    return true;
}

static bool set_isa(cli_options *options, const char *name, const char *value)
{
    int isa = find_word(value, isa_words);
    if (isa < 0)
        return bad_value(name, "isa", value, "auto, baseline, avx2 or avx512");
    options->isa = (sph2d_isa)isa;
    if (options->isa != SPH2D_ISA_AUTO && !sph2d_isa_available(options->isa)) {
        message_usage(name, "--isa: this processor or this build has no %s", value);
        return false;
    }
    return true;
}

static bool set_progress(cli_options *options, const char *name, const char *value)
{
    int mode = find_word(value, progress_words);
    if (mode < 0)
        return bad_value(name, "progress", value, "auto, always or never");
    options->progress = (progress_mode)mode;
    return true;
}

static bool set_style(cli_options *options, const char *name, const char *value)
{
    int style = find_word(value, style_words);
    if (style < 0)
        return bad_value(name, "style", value, "metaballs or points");
    options->style = (sph2d_style)style;
    options->style_given = true;
    return true;
}

static bool set_look(cli_options *options, const char *name, const char *value)
{
    int look = find_word(value, look_words);
    if (look < 0)
        return bad_value(name, "look", value, "water, flat, glass or ink");
    options->look = (sph2d_look)look;
    options->look_given = true;
    return true;
}

static bool set_background(cli_options *options, const char *name, const char *value)
{
    int background = find_word(value, background_words);
    if (background < 0)
        return bad_value(name, "background", value, "opaque or transparent");
    options->background = (sph2d_background)background;
    options->background_given = true;
    return true;
}

static bool set_gl(cli_options *options, const char *name, const char *value)
{
    if (find_word(value, gl_words) < 0)
        return bad_value(name, "gl", value, "osmesa or egl");
    options->gl = value;
    return true;
}

static bool set_count(int *count, long max, const char *name, const char *option, const char *value)
{
    long number;
    char expected[TEXT_SIZE];
    snprintf(expected, sizeof expected, "a number from 1 to %ld", max);
    if (!parse_count(value, 1, max, &number))
        return bad_value(name, option, value, expected);
    *count = (int)number;
    return true;
}

static bool set_field(const char **field, const char *name, const char *option, const char *value)
{
    if (!frame_color_known(value)) {
        char colors[200];
        return bad_value(name, option, value, frame_colors(colors, sizeof colors));
    }
    *field = value;
    return true;
}

static bool set_radius(cli_options *options, const char *name, const char *value)
{
    if (!parse_number(value, &options->radius) || options->radius <= 0)
        return bad_value(name, "radius", value, "a number above 0, in metres");
    return true;
}

/* Sets an option without an argument; false for other options. */
static bool set_flag(cli_options *options, int id)
{
    switch (id) {
    case 'f':
        options->force = true;
        return true;
    case 'n':
        options->dry_run = true;
        return true;
    case 'q':
        options->quiet = true;
        return true;
    case 'v':
        ++options->verbose;
        return true;
    case 'h':
        options->help = true;
        return true;
    case 'V':
        options->version = true;
        return true;
    case OPTION_JSON:
        options->json = true;
        return true;
    case OPTION_NO_COLOR:
        options->no_color = true;
        return true;
    case OPTION_NO_FRAMES:
        options->no_frames = true;
        return true;
    case OPTION_NO_CHECKSUM:
        options->no_checksum = true;
        return true;
    case OPTION_ARROWS:
        options->arrows = true;
        return true;
    case OPTION_STREAMLINES:
        options->streamlines = true;
        return true;
    case OPTION_ALL:
        options->all = true;
        return true;
    case OPTION_PROFILE:
        options->profile = true;
        return true;
    default:
        return false;
    }
}

static bool set_value(cli_options *options, const char *name, int id, char *value)
{
    switch (id) {
    case 'o':
        options->output = value;
        return true;
    case 's':
        return add_override(options, name, value);
    case 'j':
        return set_count(&options->threads, 1024, name, "threads", value);
    case 'J':
        return set_count(&options->jobs, 1024, name, "jobs", value);
    case OPTION_PROGRESS:
        return set_progress(options, name, value);
    case OPTION_ISA:
        return set_isa(options, name, value);
    case OPTION_SHARD:
        return parse_part(value, &options->shard, &options->shards) ||
               bad_value(name, "shard", value, "I/N, with I from 1 to N and N of at most 1000000");
    case OPTION_REPEAT:
        return set_count(&options->repeat, 100, name, "repeat", value);
    case OPTION_TARGET:
        options->percent = strchr(value, '%');
        return parse_fraction(value, &options->target) ||
               bad_value(name, "target", value, "an error above 0, such as 1% or 0.01");
    case OPTION_TEMPLATE:
        options->template_name = value;
        return true;
    case OPTION_PREVIEW:
        options->preview = value;
        return true;
    case OPTION_FILM:
        options->film = value;
        return film_can_be(value) ||
               bad_value(name, "film", value, "the name of a film, which ends in .mp4, .gif, .png or .apng");
    case OPTION_FPS:
        return (parse_number(value, &options->fps) && options->fps > 0 && options->fps <= 1000) ||
               bad_value(name, "fps", value, "a number above 0, of at most 1000");
    case OPTION_GL:
        return set_gl(options, name, value);
    case OPTION_SHADER_DIR:
        options->shader_dir = value;
        return true;
    case OPTION_STYLE:
        return set_style(options, name, value);
    case OPTION_LOOK:
        return set_look(options, name, value);
    case OPTION_BACKGROUND:
        return set_background(options, name, value);
    case OPTION_RADIUS:
        return set_radius(options, name, value);
    case OPTION_COLOR:
        return set_field(&options->color, name, "color", value);
    case OPTION_ISOLINES:
        return set_field(&options->isolines, name, "isolines", value);
    case OPTION_FOLLOW:
        options->follow = value;
        return true;
    case OPTION_VIEW:
        return parse_box(value, options->view) ||
               bad_value(name, "view", value, "X,Y,X,Y: a lower left and an upper right corner");
    case OPTION_MAX_WALL:
        return parse_duration(value, &options->max_wall) ||
               bad_value(name, "max-wall", value, "a time such as 90s, 45m or 1h30m");
    case OPTION_SIZE:
        return parse_size(value, &options->width, &options->height) ||
               bad_value(name, "size", value, "WIDTHxHEIGHT, each from 16 to 16384");
    case OPTION_RANGE:
        return parse_range(value, &options->range[0], &options->range[1]) ||
               bad_value(name, "range", value, "MIN,MAX with MIN below MAX");
    default:
        return false;
    }
}

/* ---- getopt ------------------------------------------------------------------------------------------------------ */

/* The two tables of getopt_long for one command. */
typedef struct getopt_tables {
    char letters[2 * ROW_COUNT + 2];
    struct option longs[ROW_COUNT + 1];
} getopt_tables;

static void make_tables(getopt_tables *tables, unsigned command)
{
    memset(tables, 0, sizeof *tables);
    char *letter = tables->letters;
    struct option *next = tables->longs;
    *letter++ = ':'; /* distinguishes a missing argument from an unknown option */
    for (size_t i = 0; i < ROW_COUNT; ++i) {
        if ((rows[i].commands & command) == 0)
            continue;
        int has_argument = rows[i].argument ? required_argument : no_argument;
        *next++ = (struct option){rows[i].name, has_argument, NULL, rows[i].id};
        if (rows[i].id < 256) {
            *letter++ = (char)rows[i].id;
            if (has_argument == required_argument)
                *letter++ = ':';
        }
    }
}

static bool is_long(const char *given)
{
    return given[0] == '-' && given[1] == '-' && given[2] != '\0';
}

/* Reports an error of getopt_long. For long options optopt is 0 if the option is unknown, and its id if it takes no
 * argument but got one. */
static void report_error(const char *name, unsigned command, int result, const char *given)
{
    char letter[3] = {'-', (char)optopt, '\0'};
    if (result == ':')
        message_usage(name, "'%s' needs an argument", is_long(given) ? given : letter);
    else if (is_long(given) && optopt != 0)
        message_usage(name, "'%.*s' takes no argument", (int)strcspn(given, "="), given);
    else
        unknown_option(name, command, is_long(given) ? given : letter);
}

/* Finds --json and --no-color first, as they change how errors of the options are reported. */
static void find_message_options(cli_options *options, int argc, char **argv)
{
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; ++i) {
        options->json = options->json || strcmp(argv[i], "--json") == 0;
        options->no_color = options->no_color || strcmp(argv[i], "--no-color") == 0;
    }
    message_setup(options);
}

bool options_parse(cli_options *options, const char *name, unsigned command, int argc, char **argv)
{
    *options = (cli_options){0};
    find_message_options(options, argc, argv);
    getopt_tables tables;
    make_tables(&tables, command);
    opterr = 0;
    int id;
    int before = optind;
    while ((id = getopt_long(argc, argv, tables.letters, tables.longs, NULL)) != -1) {
        if (id == '?' || id == ':') {
            /* Within a group of letters optind still points at the group. */
            report_error(name, command, id, argv[optind > before ? optind - 1 : optind]);
            return false;
        }
        if (!set_flag(options, id) && !set_value(options, name, id, optarg))
            return false;
        before = optind;
    }
    options->operands = argv + optind;
    options->operand_count = (size_t)(argc - optind);
    message_setup(options);
    return true;
}

void options_free(cli_options *options)
{
    free(options->overrides);
    options->overrides = NULL;
}
