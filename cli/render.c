/* SPDX-License-Identifier: MIT */
/** @file render.c
 *  `sph2d render SNAPSHOT... -o DIR`: draws snapshots as a sequence of PNG files. */
#include <stdlib.h>
#include <string.h>

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

/* What all workers share; only one of them uses it at a time. */
typedef struct sequence {
    const cli_options *options;
    cli_folder folder;
    cli_progress progress;
    size_t next, drawn; /* the snapshot to read next; frames that are done */
    painter_times spent;
    double time;   /* of the snapshot before [s] */
    bool disorder; /* it was reported that times go back */
    int code;      /* of the first failure, after which no more is read */
} sequence;

/* Who draws: each has a painter, made for the first picture and again when one has another size or style. */
typedef struct worker {
    sequence *sequence;
    cli_painter *painter;
    painter_times spent;
    sph2d_report report;
} worker;

/* A frame to draw. */
typedef struct frame {
    size_t index;
    sph2d_snapshot *snapshot;
    char *path; /* NULL before the folder is there */
} frame;

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

/* Tells what went wrong, unless something did before. */
static void fail(worker *w, sph2d_status status)
{
    if (w->sequence->code == CLI_EXIT_SUCCESS) {
        message_report(status, &w->report, NULL);
        w->sequence->code = exit_of_status(status);
    }
}

/* Reads the next snapshot; false when there is none, or something failed. */
static bool read_next(worker *w, frame *out)
{
    sequence *s = w->sequence;
    *out = (frame){.index = s->next};
    if (s->code != CLI_EXIT_SUCCESS || s->next == s->options->operand_count)
        return false;
    ++s->next;
    sph2d_status status = sph2d_snapshot_read(s->options->operands[out->index], &out->snapshot, &w->report);
    if (status == SPH2D_OK)
        tell_disorder(s, sph2d_snapshot_get_info(out->snapshot).time, out->index);
    else
        fail(w, status);
    return status == SPH2D_OK;
}

/* Names its file; false without memory. */
static bool name_frame(worker *w, frame *f)
{
    const char *path = folder_file(&w->sequence->folder, "frame_%06zu.png", f->index);
    f->path = path != NULL ? strdup(path) : NULL;
    if (f->path == NULL)
        fail(w, SPH2D_NOMEM);
    return f->path != NULL;
}

static void end_frame(frame *f)
{
    sph2d_snapshot_destroy(f->snapshot);
    free(f->path);
}

static sph2d_status make_painter(worker *w, const cli_look *look)
{
    if (w->painter != NULL && painter_fits(w->painter, look))
        return SPH2D_OK;
    painter_destroy(w->painter);
    return painter_create(look, w->sequence->options, &w->painter, &w->report);
}

static sph2d_status draw(worker *w, const frame *f)
{
    cli_look look = wanted_look(f->snapshot, w->sequence->options);
    particle_source source = {.snapshot = f->snapshot};
    sph2d_status status = make_painter(w, &look);
    return status == SPH2D_OK ? painter_paint(w->painter, &source, &look, f->path, &w->spent, &w->report) : status;
}

static void count_frame(worker *w, sph2d_status status)
{
    sequence *s = w->sequence;
    if (status != SPH2D_OK) {
        fail(w, status);
        return;
    }
    ++s->drawn;
    progress_update(&s->progress, (double)s->drawn, "frame %zu of %zu", s->drawn, s->options->operand_count);
}

/* The first frame, before the others: the folder is not touched before it is known that something can be drawn. */
static void draw_first(worker *w)
{
    sequence *s = w->sequence;
    const cli_options *options = s->options;
    frame f;
    if (read_next(w, &f)) {
        cli_look look = wanted_look(f.snapshot, options);
        sph2d_status status = make_painter(w, &look);
        if (status == SPH2D_OK)
            s->code = folder_open_new(&s->folder, options->output, options->force ? FOLDER_CLEAR_FRAMES : FOLDER_KEEP);
        if (s->code == CLI_EXIT_SUCCESS && (status != SPH2D_OK || name_frame(w, &f)))
            count_frame(w, status == SPH2D_OK ? draw(w, &f) : status);
    }
    end_frame(&f);
}

/* Draws frame after frame until there are no more. */
static void draw_rest(worker *w)
{
    for (;;) {
        frame f;
        bool more;
#pragma omp critical(sequence)
        more = read_next(w, &f) && name_frame(w, &f);
        if (!more) {
            end_frame(&f);
            return;
        }
        sph2d_status status = draw(w, &f);
#pragma omp critical(sequence)
        count_frame(w, status);
        end_frame(&f);
    }
}

/* Frames are drawn side by side, each by one thread: pictures of this size do not keep several busy. */
static void draw_all(sequence *s, int workers)
{
    worker first = {.sequence = s};
    draw_first(&first);
#pragma omp parallel num_threads(workers) if (workers > 1)
    {
        worker other = {.sequence = s};
        bool mine = false; /* the first painter is used again */
#pragma omp single nowait
        mine = true;
        worker *w = mine ? &first : &other;
        draw_rest(w);
        painter_destroy(w->painter);
#pragma omp critical(sequence)
        painter_times_add(&s->spent, &w->spent);
    }
}

int command_render(const cli_options *options)
{
    int code = usage_fault(options);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    sequence s = {.options = options, .folder = FOLDER_CLOSED};
    s.code = folder_refuse(options->output, options->force);
    if (s.code != CLI_EXIT_SUCCESS)
        return s.code;
    int workers = threads_for_frames(options, options->operand_count - 1);
    s.progress = progress_begin(options, 0, (double)options->operand_count);
    draw_all(&s, workers);
    progress_end(&s.progress);
    char spent[TEXT_SIZE];
    if (s.code == CLI_EXIT_SUCCESS)
        message_note("%zu frame%s in '%s': %s", s.drawn, s.drawn == 1 ? "" : "s", options->output,
                     painter_times_describe(spent, &s.spent));
    folder_close(&s.folder);
    return s.code;
}
