/* SPDX-License-Identifier: MIT */
/** @file render.c
 *  `sph2d render PATH... -o DIR`: draws snapshots as a sequence of PNG files, one snapshot as one file, FILE.png; with
 *  --film FILE as a film. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include "command.h"
#include "exit.h"
#include "film_strip.h"
#include "folder.h"
#include "frame_writer.h"
#include "input.h"
#include "message.h"
#include "threads.h"

/* The frame style of a snapshot, with the options of the command line, and a range of colours where neither has one;
 * (0, 0) for none. */
static frame_style style_of(const sph2d_snapshot *snapshot, const cli_options *options, sph2d_vec2 range)
{
    frame_style style = frame_style_of_snapshot(snapshot);
    sph2d_frames *frames = &style.frames;
    if (options->width > 0) {
        frames->size[0] = options->width;
        frames->size[1] = options->height;
    }
    sph2d_style scene_style = frames->style;
    if (options->style_given)
        frames->style = options->style;
    if (options->view[0] < options->view[2])
        frames->view = (sph2d_box){{options->view[0], options->view[1]}, {options->view[2], options->view[3]}};
    if (options->follow)
        frames->follow = options->follow;
    if (options->arrows)
        frames->arrows = SPH2D_SWITCH_ON;
    if (options->streamlines)
        frames->streamlines = SPH2D_SWITCH_ON;
    if (options->isolines && (!frames->isolines || strcmp(options->isolines, frames->isolines) != 0))
        frames->isoline_step = 0; /* that of another field does not apply */
    if (options->isolines)
        frames->isolines = options->isolines;
    if (options->look_given)
        frames->look = options->look;
    if (options->background_given)
        frames->background = options->background;
    if (options->radius > 0)
        frames->radius = options->radius;
    else if (frames->style != scene_style)
        frames->radius = 0; /* the radius of another style does not apply */
    if (options->color && (!frames->color || strcmp(options->color, frames->color) != 0))
        frames->color_range = (sph2d_vec2){0, 0}; /* that of another field does not apply */
    if (options->color)
        frames->color = options->color;
    style.full_range = options->range_kind == RANGE_FULL;
    if (options->range_kind == RANGE_FIXED)
        frames->color_range = (sph2d_vec2){options->range[0], options->range[1]};
    else if (options->range_kind != RANGE_DEFAULT || (frames->color_range.x == 0 && frames->color_range.y == 0))
        frames->color_range = range;
    return style;
}

static int check_usage(const cli_options *options)
{
    if (options->operand_count == 0)
        message_usage("render", "a snapshot, or the folder of a run, must be given");
    else if (!options->output && !options->film)
        message_usage("render", "a folder for the frames must be given, -o DIR, or a film, --film FILE");
    else if (options->output && options->film)
        message_usage("render", "-o DIR or --film FILE: one of the two");
    else if (options->fps > 0 && !options->film)
        message_usage("render", "--fps is for films: --film FILE");
    else
        return CLI_EXIT_SUCCESS;
    return CLI_EXIT_USAGE;
}

/* Shared by all workers, used by one at a time. */
typedef struct sequence {
    const cli_options *options;
    snapshot_list inputs;
    film_strip *strip; /* NULL: PNG files in the folder ... */
    bool alone;        /* ... or the only one, which the output is the name of */
    cli_folder folder;
    cli_progress progress;
    size_t next, drawn; /* the snapshot to read next; frames that are done */
    frame_times times;
    sph2d_vec2 range; /* of the colours over all frames, where no range is given */
    double time;      /* of the last snapshot [s] */
    bool warned;      /* of decreasing times */
    int code;         /* exit code of the first failure, after which nothing more is read */
} sequence;

/* A drawing thread, with a frame writer, which is replaced for frames of another size or style. */
typedef struct worker {
    sequence *sequence;
    frame_writer *writer;
    frame_times times;
    sph2d_report report;
} worker;

/* A frame to draw. */
typedef struct frame_job {
    size_t index;
    sph2d_snapshot *snapshot;
    char *path; /* NULL before the folder exists, and for a film */
} frame_job;

/* A shell's order of files is that of time, except for a checkpoint, whose name comes before the snapshots'. */
static void warn_disorder(sequence *s, double time, size_t index)
{
    if (index > 0 && time < s->time && !s->warned) {
        message_warning(SPH2D_CODE_GENERAL, "'%s' is earlier than the file before it; frames keep the order given",
                        s->inputs.paths[index]);
        s->warned = true;
    }
    s->time = time;
}

/* Reports the first failure. No worker waits any more for the frame before its own. */
static void fail(worker *w, sph2d_status status)
{
    film_strip_give_up(w->sequence->strip);
    if (w->sequence->code == CLI_EXIT_SUCCESS) {
        message_report(status, &w->report, NULL);
        w->sequence->code = exit_of_status(status);
    }
}

/* Reads the next snapshot; false if there is none, after a failure, or after a signal. */
static bool read_next(worker *w, frame_job *out)
{
    sequence *s = w->sequence;
    *out = (frame_job){.index = s->next};
    if (s->code == CLI_EXIT_SUCCESS && s->next < s->inputs.count && signals_caught() != 0)
        s->code = 128 + signals_caught();
    if (s->code != CLI_EXIT_SUCCESS || s->next == s->inputs.count)
        return false;
    ++s->next;
    sph2d_status status = snapshot_read(s->options, s->inputs.paths[out->index], &out->snapshot, &w->report);
    if (status == SPH2D_OK)
        warn_disorder(s, sph2d_snapshot_get_info(out->snapshot).time, out->index);
    else
        fail(w, status);
    return status == SPH2D_OK;
}

/* Sets the path of a frame; false when memory is short. */
static bool name_frame(worker *w, frame_job *f)
{
    if (w->sequence->strip)
        return true;
    const sequence *s = w->sequence;
    const char *path = s->alone ? s->options->output : folder_file(&w->sequence->folder, "frame_%06zu.png", f->index);
    f->path = path ? strdup(path) : NULL;
    if (!f->path)
        fail(w, SPH2D_NOMEM);
    return f->path;
}

static void end_frame(frame_job *f)
{
    sph2d_snapshot_destroy(f->snapshot);
    free(f->path);
}

static sph2d_status make_writer(worker *w, const frame_style *style)
{
    if (w->writer && frame_writer_accepts(w->writer, style))
        return SPH2D_OK;
    frame_writer_destroy(w->writer);
    return frame_writer_create(style, w->sequence->options, &w->writer, &w->report);
}

static sph2d_status draw(worker *w, const frame_job *f)
{
    film_strip *strip = w->sequence->strip;
    frame_style style = style_of(f->snapshot, w->sequence->options, w->sequence->range);
    if (strip)
        film_strip_fit(strip, &style.frames);
    particle_source source = {.snapshot = f->snapshot};
    sph2d_status status = make_writer(w, &style);
    if (status == SPH2D_OK && !strip)
        return frame_writer_write(w->writer, &source, &style, f->path, &w->times, &w->report);
    if (status == SPH2D_OK)
        status = frame_writer_draw(w->writer, &source, &style, &w->times, &w->report);
    if (status == SPH2D_OK)
        status = film_strip_add(strip, f->index, frame_writer_pixels(w->writer), &w->report);
    return status;
}

static void count_frame(worker *w, sph2d_status status)
{
    sequence *s = w->sequence;
    if (status != SPH2D_OK) {
        fail(w, status);
        return;
    }
    ++s->drawn;
    const progress_fact facts[] = {
        {"frames_drawn", (double)s->drawn, NULL}, {"frames", (double)s->inputs.count, NULL}, {NULL, 0, NULL}};
    progress_update(&s->progress, (double)s->drawn, facts, "frame %zu of %zu", s->drawn, s->inputs.count);
}

/* Finds one range of colours for all frames, by reading the snapshots once more, so that a colour means the same in each.
 * What cannot be read is reported when it is drawn. */
static void find_range(sequence *s)
{
    const cli_options *options = s->options;
    frame_buffers buffers = {0};
    sph2d_vec2 range = {INFINITY, -INFINITY};
    bool wanted = s->inputs.count > 1 && options->range_kind != RANGE_FIXED;
    for (size_t i = 0; wanted && i < s->inputs.count && signals_caught() == 0; ++i) {
        sph2d_report report = {0};
        sph2d_snapshot *snapshot = NULL;
        if (snapshot_read(options, s->inputs.paths[i], &snapshot, &report) == SPH2D_OK) {
            const frame_style style = style_of(snapshot, options, (sph2d_vec2){0, 0});
            const particle_source source = {.snapshot = snapshot};
            wanted = style.frames.color && style.frames.color_range.x == 0 && style.frames.color_range.y == 0 &&
                     frame_widen_range(&source, &style, &buffers, &range, &report) == SPH2D_OK;
        }
        sph2d_snapshot_destroy(snapshot);
        sph2d_report_clear(&report);
    }
    frame_free(&buffers);
    if (wanted && range.x < range.y)
        s->range = range;
}

/* Where the frames go, when it is clear that they can be drawn. */
static int prepare_output(worker *w)
{
    sequence *s = w->sequence;
    signals_note();
    if (s->strip) {
        const sph2d_status status = film_strip_open(s->strip, &w->report);
        if (status != SPH2D_OK)
            fail(w, status);
        return s->code;
    }
    if (s->alone)
        return s->code;
    return folder_clear(&s->folder, s->options->force ? FOLDER_CLEAR_FRAMES : FOLDER_KEEP);
}

/* Draws the first frame before the others, as nothing in the folder is changed before drawing works. */
static void draw_first(worker *w)
{
    sequence *s = w->sequence;
    const cli_options *options = s->options;
    frame_job f;
    if (read_next(w, &f)) {
        frame_style style = style_of(f.snapshot, options, s->range);
        if (s->strip)
            film_strip_fit(s->strip, &style.frames);
        sph2d_status status = make_writer(w, &style);
        if (status == SPH2D_OK)
            s->code = prepare_output(w);
        if (s->code == CLI_EXIT_SUCCESS && (status != SPH2D_OK || name_frame(w, &f)))
            count_frame(w, status == SPH2D_OK ? draw(w, &f) : status);
    }
    end_frame(&f);
}

/* Draws frame after frame until there are no more. */
static void draw_rest(worker *w)
{
    for (;;) {
        frame_job f;
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

/* Draws several frames in parallel, each by one thread, as frames are too small for more. */
static void draw_all(sequence *s, int workers)
{
    worker first = {.sequence = s};
    draw_first(&first);
#pragma omp parallel num_threads(workers) if (workers > 1)
    {
        worker other = {.sequence = s};
        bool is_first = false; /* one thread reuses the first worker */
#pragma omp single nowait
        is_first = true;
        worker *w = is_first ? &first : &other;
        draw_rest(w);
        frame_writer_destroy(w->writer);
#pragma omp critical(sequence)
        frame_times_add(&s->times, &w->times);
    }
}

/* Whether a name is that of a picture, not of a folder that is there. */
static bool is_picture(const char *name)
{
    const size_t length = strlen(name);
    struct stat found;
    return length > 4 && strcasecmp(name + length - 4, ".png") == 0 &&
           (stat(name, &found) != 0 || !S_ISDIR(found.st_mode));
}

static int claim_picture(const sequence *s)
{
    const char *name = s->options->output;
    struct stat found;
    if (s->inputs.count > 1) {
        message_error(SPH2D_CODE_GENERAL, "give a folder, -o DIR, or one snapshot",
                      "%zu snapshots are no single picture, '%s'", s->inputs.count, name);
        return CLI_EXIT_USAGE;
    }
    if (stat(name, &found) == 0 && !s->options->force) {
        message_error(SPH2D_CODE_FILE_EXISTS, "--force replaces it", "'%s' exists already", name);
        return CLI_EXIT_CANTCREAT;
    }
    return CLI_EXIT_SUCCESS;
}

/* Takes the folder or the name of the picture, or looks for what a film must have. */
static int claim_output(sequence *s)
{
    const cli_options *options = s->options;
    if (s->alone)
        return claim_picture(s);
    if (!s->strip)
        return folder_claim(&s->folder, options->output, options->force, NULL);
    return film_strip_begin(s->strip, options, &s->inputs);
}

/* Gives a film its name, if all went well; reports the end. */
static void finish(sequence *s)
{
    worker last = {.sequence = s};
    char times[TEXT_SIZE];
    if (s->strip && s->code == CLI_EXIT_SUCCESS) {
        const sph2d_status status = film_strip_close(s->strip, &last.report);
        if (status != SPH2D_OK)
            fail(&last, status);
    }
    if (s->strip && s->code == CLI_EXIT_SUCCESS)
        film_strip_tell(s->strip, &s->times);
    else if (s->code == CLI_EXIT_SUCCESS)
        message_note("%zu frame%s in '%s': %s", s->drawn, s->drawn == 1 ? "" : "s", s->options->output,
                     frame_times_describe(times, &s->times));
    else if (signals_caught() != 0 && s->code == 128 + signals_caught())
        message_note("stopped by %s after %zu of %zu frames", signals_name(signals_caught()), s->drawn,
                     s->inputs.count);
    film_strip_end(s->strip);
    if (s->code == CLI_EXIT_SUCCESS)
        folder_close(&s->folder);
    else
        folder_abandon(&s->folder);
}

static void draw_sequence(sequence *s)
{
    snapshot_note(s->options);
    int workers = threads_for_frames(s->options, s->inputs.count - 1);
    find_range(s);
    s->progress = progress_begin(s->options, 0, (double)s->inputs.count);
    draw_all(s, workers);
    progress_end(&s->progress);
}

int command_render(const cli_options *options)
{
    int code = check_usage(options);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    film_strip strip = {0};
    sequence s = {.options = options, .folder = FOLDER_CLOSED, .strip = options->film ? &strip : NULL};
    s.alone = !options->film && is_picture(options->output);
    signals_install();
    s.code = snapshot_list_make(&s.inputs, options);
    if (s.code == CLI_EXIT_SUCCESS)
        s.code = claim_output(&s);
    if (s.code == CLI_EXIT_SUCCESS) {
        draw_sequence(&s);
        finish(&s);
    }
    snapshot_list_free(&s.inputs);
    return s.code;
}
