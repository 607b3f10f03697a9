/* SPDX-License-Identifier: MIT */
/** @file option_table.c
 *  The table of options. A new one needs a row here, and a case in option_values.c. */
#include "option_table.h"

#include <stdio.h>

#include "command.h"

enum {
    SIMULATES = CLI_RUN | CLI_RESUME | CLI_CHECK,
    DRAWS = CLI_RUN | CLI_RESUME | CLI_RENDER | CLI_CHECK,
};

/* The values of options that have a list of them, in the order of their enums. */
static const char *const isa_words[] = {"auto", "baseline", "avx2", "avx512", NULL};
static const char *const device_words[] = {"cpu", "gpu", NULL}; /* and with numbers */
static const char *const progress_words[] = {"auto", "always", "never", NULL};
static const char *const style_words[] = {"metaballs", "points", NULL};
static const char *const look_words[] = {"water", "flat", "glass", "ink", NULL};
static const char *const background_words[] = {"opaque", "transparent", NULL};
static const char *const gl_words[] = {"osmesa", "egl", NULL};

static const option_row rows[] = {
    {'o', "output", "DIR", CLI_RUN | CLI_RENDER | CLI_STUDY, "folder for the files; empty, new, or a study's own"},
    {'o', "output", "FILE", CLI_PLOT, "file for the picture, .svg or .png; default DIR/plot.svg"},
    {'o', "output", "FILE", CLI_EXPORT, "file, .csv, .vtp or, for a series, .pvd; default CSV to standard output"},
    {'f', "force", NULL, CLI_RUN | CLI_RENDER | CLI_INIT | CLI_STUDY,
     "replace the files of an earlier run there; a study runs all rows again"},
    {'s', "set", "KEY=VALUE", CLI_RUN | CLI_RESUME | CLI_PLAY | CLI_CHECK | CLI_STUDY,
     "change a key of the scene: fluid.density=800"},
    {'n', "dry-run", NULL, CLI_RUN, "only check the scene, as 'sph2d check' does"},
    {'j', "threads", "N", DRAWS | CLI_PLAY | CLI_STUDY,
     "threads; else those of OpenMP: OMP_NUM_THREADS, or the processors"},
    {OPTION_ISA, "isa", "NAME", CLI_RUN | CLI_PLAY | CLI_CHECK | CLI_STUDY,
     "instruction set: auto, baseline, avx2 or avx512"},
    {OPTION_DEVICE, "device", "NAME", SIMULATES | CLI_PLAY | CLI_STUDY,
     "what takes the steps: cpu, gpu, gpu:2, or a number of 'sph2d devices'"},
    {OPTION_SAME_BITS, "same-bits", NULL, SIMULATES | CLI_PLAY | CLI_STUDY,
     "only a device with the bits of the processor's baseline"},
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
    {OPTION_RANGE, "range", "RANGE", CLI_RENDER, "colour bar: LOW..HIGH, full, or percentiles (1st to 99th)"},
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
_Static_assert((size_t)ROW_COUNT <= OPTION_ROWS_MAX, "tables of getopt have room for all rows");

const option_row *options_row(size_t i)
{
    return i < ROW_COUNT ? &rows[i] : NULL;
}

const char *const *options_words(int id)
{
    switch (id) {
    case OPTION_ISA:
        return isa_words;
    case OPTION_DEVICE:
        return device_words;
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
