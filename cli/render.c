/* SPDX-License-Identifier: MIT */
/** @file render.c
 *  `sph2d render SNAPSHOT... -o DIR`: draws snapshots as a sequence of PNG files. */
#include "command.h"
#include "exit.h"
#include "folder.h"
#include "message.h"
#include "painter.h"
#include "progress.h"
#include "threads.h"

/* What the command line says about the look stands above what the snapshot says. */
static cli_look wanted_look(const sph2d_snapshot *snapshot, const cli_options *options)
{
    cli_look look = look_of_snapshot(snapshot);
    sph2d_frames *frames = &look.frames;
    if (options->width > 0) {
        frames->size[0] = options->width;
        frames->size[1] = options->height;
    }
    sph2d_style own = frames->style;
    if (options->style_given)
        frames->style = options->style;
    else if (options->color != NULL)
        frames->style = SPH2D_STYLE_POINTS; /* only points have colours */
    if (options->radius > 0)
        frames->radius = options->radius;
    else if (frames->style != own)
        frames->radius = 0; /* that of the other style means nothing for this one */
    if (options->color != NULL) {
        frames->color = options->color;
        frames->color_range = (sph2d_vec2){0, 0};
    }
    if (options->range[0] < options->range[1])
        frames->color_range = (sph2d_vec2){options->range[0], options->range[1]};
    return look;
}

static int usage_fault(const cli_options *options)
{
    if (options->operand_count == 0)
        message_usage("render", "a snapshot must be given");
    else if (options->output == NULL)
        message_usage("render", "a folder for the frames must be given: -o DIR");
    else if (options->color != NULL && options->style_given && options->style != SPH2D_STYLE_POINTS)
        message_usage("render", "--color needs --style points");
    else
        return CLI_EXIT_SUCCESS;
    return CLI_EXIT_USAGE;
}

/* What lasts from one snapshot to the next. */
typedef struct sequence {
    const cli_options *options;
    cli_folder folder;
    cli_painter *painter;
    double time;   /* of the snapshot before [s] */
    bool disorder; /* it was told that times go back */
    sph2d_report report;
} sequence;

/* A shell's order of files is that of time, but for a checkpoint, whose name comes before the snapshots'. */
static void tell_disorder(sequence *s, double time, size_t index)
{
    if (index > 0 && time < s->time && !s->disorder) {
        message_warning(SPH2D_CODE_GENERAL, "'%s' is earlier than the file before it; frames keep the order given",
                        s->options->operands[index]);
        s->disorder = true;
    }
    s->time = time;
}

static int told(sequence *s, sph2d_status status)
{
    message_report(status, &s->report, NULL);
    return exit_of_status(status);
}

/* The painter is made for the first picture, and again when one has another size or style. */
static int make_painter(sequence *s, const cli_look *look)
{
    if (s->painter != NULL && painter_fits(s->painter, look))
        return CLI_EXIT_SUCCESS;
    painter_destroy(s->painter);
    return told(s, painter_create(look, s->options, &s->painter, &s->report));
}

static int draw(sequence *s, const sph2d_snapshot *snapshot, size_t index)
{
    cli_look look = wanted_look(snapshot, s->options);
    int code = make_painter(s, &look);
    /* The folder is not touched before it is known that something can be drawn. */
    if (code == CLI_EXIT_SUCCESS && index == 0)
        code = folder_open_new(&s->folder, s->options->output, s->options->force ? FOLDER_CLEAR_FRAMES : FOLDER_KEEP);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    const char *path = folder_file(&s->folder, "frame_%06zu.png", index);
    particle_source source = {.snapshot = snapshot};
    sph2d_status status = path == NULL ? SPH2D_NOMEM : painter_paint(s->painter, &source, &look, path, &s->report);
    return told(s, status);
}

static int draw_all(sequence *s)
{
    const cli_options *options = s->options;
    int code = folder_refuse(options->output, options->force);
    cli_progress progress = progress_begin(options, 0, (double)options->operand_count);
    for (size_t i = 0; i < options->operand_count && code == CLI_EXIT_SUCCESS; ++i) {
        sph2d_snapshot *snapshot = NULL;
        code = told(s, sph2d_snapshot_read(options->operands[i], &snapshot, &s->report));
        if (code != CLI_EXIT_SUCCESS)
            break;
        tell_disorder(s, sph2d_snapshot_get_info(snapshot).time, i);
        code = draw(s, snapshot, i);
        sph2d_snapshot_destroy(snapshot);
        progress_update(&progress, (double)(i + 1), "frame %zu of %zu", i + 1, options->operand_count);
    }
    progress_end(&progress);
    return code;
}

int command_render(const cli_options *options)
{
    int code = usage_fault(options);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    threads_choose(options);
    sequence s = {.options = options, .folder = FOLDER_CLOSED};
    code = draw_all(&s);
    if (code == CLI_EXIT_SUCCESS)
        message_note("%zu frame%s in '%s'", options->operand_count, options->operand_count == 1 ? "" : "s",
                     options->output);
    painter_destroy(s.painter);
    folder_close(&s.folder);
    return code;
}
