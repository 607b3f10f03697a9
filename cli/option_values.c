/* SPDX-License-Identifier: MIT */
/** @file option_values.c
 *  What options mean: their arguments are read, and a bad one is reported with what would have been right. */
#include "option_table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "film.h"
#include "frame.h"
#include "message.h"
#include "text.h"

static bool bad_value(const char *name, const char *option, const char *value, const char *expected)
{
    message_usage(name, "--%s: '%s' is not %s", option, value, expected);
    return false;
}

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
    int isa = find_word(value, options_words(OPTION_ISA));
    if (isa < 0)
        return bad_value(name, "isa", value, "auto, baseline, avx2 or avx512");
    options->isa = (sph2d_isa)isa;
    if (options->isa != SPH2D_ISA_AUTO && !sph2d_isa_available(options->isa)) {
        message_usage(name, "--isa: this processor or this build has no %s", value);
        return false;
    }
    return true;
}

static bool set_device(cli_options *options, const char *name, const char *value)
{
    const bool card = strncmp(value, "gpu", 3) == 0;
    const char *count = !card ? value : value[3] == ':' ? value + 4 : value[3] == '\0' ? "1" : value;
    long number = 0;
    if (strcmp(value, "cpu") != 0 && !parse_count(count, 1, 1000, &number))
        return bad_value(name, "device", value, "cpu, gpu, gpu:2 for the second card, or a number of 'sph2d devices'");
    options->device = (int)number;
    options->device_is_card = card;
    return true;
}

static bool set_progress(cli_options *options, const char *name, const char *value)
{
    int mode = find_word(value, options_words(OPTION_PROGRESS));
    if (mode < 0)
        return bad_value(name, "progress", value, "auto, always or never");
    options->progress = (progress_mode)mode;
    return true;
}

static bool set_style(cli_options *options, const char *name, const char *value)
{
    int style = find_word(value, options_words(OPTION_STYLE));
    if (style < 0)
        return bad_value(name, "style", value, "metaballs or points");
    options->style = (sph2d_style)style;
    options->style_given = true;
    return true;
}

static bool set_look(cli_options *options, const char *name, const char *value)
{
    int look = find_word(value, options_words(OPTION_LOOK));
    if (look < 0)
        return bad_value(name, "look", value, "water, flat, glass or ink");
    options->look = (sph2d_look)look;
    options->look_given = true;
    return true;
}

static bool set_background(cli_options *options, const char *name, const char *value)
{
    int background = find_word(value, options_words(OPTION_BACKGROUND));
    if (background < 0)
        return bad_value(name, "background", value, "opaque or transparent");
    options->background = (sph2d_background)background;
    options->background_given = true;
    return true;
}

static bool set_gl(cli_options *options, const char *name, const char *value)
{
    if (find_word(value, options_words(OPTION_GL)) < 0)
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

static bool set_range(cli_options *options, const char *name, const char *value)
{
    options->range_kind = strcmp(value, "full") == 0          ? RANGE_FULL
                          : strcmp(value, "percentiles") == 0 ? RANGE_PERCENTILES
                                                              : RANGE_FIXED;
    return options->range_kind != RANGE_FIXED || parse_range(value, &options->range[0], &options->range[1]) ||
           bad_value(name, "range", value, "LOW..HIGH with LOW below HIGH, full or percentiles");
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
    case OPTION_SAME_BITS:
        options->same_bits = true;
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
    case OPTION_DEVICE:
        return set_device(options, name, value);
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
        return set_range(options, name, value);
    default:
        return false;
    }
}

bool option_values_set(cli_options *options, const char *name, int id, char *value)
{
    return set_flag(options, id) || set_value(options, name, id, value);
}
