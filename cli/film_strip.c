/* SPDX-License-Identifier: MIT */
/** @file film_strip.c
 *  The film of `sph2d render`. */
#include "film_strip.h"

#include <math.h>
#include <sys/stat.h>

#include "exit.h"
#include "input.h"
#include "message.h"
#include "text.h"

/* ---- its pace ---------------------------------------------------------------------------------------------------- */

/* The rate of a film of a single frame, which has no pace. */
static const double LONE_RATE = 25;

/* The time of a snapshot, and the length of a step then [s]. */
static int read_time(const cli_options *options, const char *path, double *time, double *step)
{
    sph2d_report report = {0};
    sph2d_snapshot *snapshot = NULL;
    const sph2d_status status = snapshot_read(options, path, &snapshot, &report);
    if (status == SPH2D_OK) {
        const sph2d_snapshot_info info = sph2d_snapshot_get_info(snapshot);
        *time = info.time;
        *step = info.time_step;
    } else {
        message_report(status, &report, NULL);
    }
    sph2d_snapshot_destroy(snapshot);
    return exit_of_status(status);
}

/* The rate with the fewest digits of so many intervals within a time: snapshots are taken at the first step after theirs,
 * so that the time is known to a step. */
static double rate_of(double intervals, double time, double step)
{
    const double rate = intervals / time, least = intervals / (time + step);
    const double most = time > step ? intervals / (time - step) : rate;
    for (int digits = 0; digits < 6; ++digits) {
        const double unit = pow(10, floor(log10(rate)) - digits), rounded = round(rate / unit) * unit;
        if (rounded >= least && rounded <= most)
            return rounded;
    }
    return rate;
}

static int find_rate(film_strip *strip, const cli_options *options, const snapshot_list *inputs)
{
    double first = 0, last = 0, step = 0;
    int code = read_time(options, inputs->paths[0], &first, &step);
    if (code == CLI_EXIT_SUCCESS)
        code = read_time(options, inputs->paths[inputs->count - 1], &last, &step);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    const double scene = last > first ? rate_of((double)(inputs->count - 1), last - first, step) : 0;
    strip->form.rate = options->fps > 0 ? options->fps : scene > 0 ? scene : LONE_RATE;
    strip->pace = scene > 0 ? strip->form.rate / scene : 0;
    if (options->fps > 0 || scene > 0 || inputs->count == 1)
        return CLI_EXIT_SUCCESS;
    message_error(SPH2D_CODE_GENERAL, "--fps N: that many of them for each second of the film",
                  "the last snapshot is not later than the first, so that the film has no pace");
    return CLI_EXIT_DATA;
}

int film_strip_begin(film_strip *strip, const cli_options *options, const snapshot_list *inputs)
{
    *strip = (film_strip){.options = options, .count = inputs->count, .film.pixels = -1};
    struct stat info;
    if (stat(options->film, &info) == 0 && !S_ISREG(info.st_mode)) {
        message_error(SPH2D_CODE_FILE_WRITE, NULL, "cannot write '%s': it is not a regular file", options->film);
        return CLI_EXIT_CANTCREAT;
    }
    if (stat(options->film, &info) == 0 && !options->force) {
        message_error(SPH2D_CODE_FILE_EXISTS, "--force replaces it by a film that is complete, or not at all",
                      "'%s' exists already", options->film);
        return CLI_EXIT_CANTCREAT;
    }
    const int code = find_rate(strip, options, inputs);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    pthread_mutex_init(&strip->lock, NULL);
    pthread_cond_init(&strip->changed, NULL);
    return CLI_EXIT_SUCCESS;
}

/* ---- frames ------------------------------------------------------------------------------------------------------ */

/* The width of animated images, whose frames are not to be large, unless a size is given [pixels]. */
enum { IMAGE_WIDTH = 640, SIDE_MIN = 16 };

void film_strip_fit(film_strip *strip, sph2d_frames *frames)
{
    film_form *form = &strip->form;
    if (form->width == 0) {
        form->width = (unsigned)frames->size[0];
        form->height = (unsigned)frames->size[1];
        if (film_is_image(strip->options->film) && strip->options->width == 0 && form->width > IMAGE_WIDTH) {
            const double height = round((double)form->height * IMAGE_WIDTH / form->width);
            form->height = (unsigned)fmax(height, SIDE_MIN);
            form->width = IMAGE_WIDTH;
        }
    }
    frames->size[0] = form->width;
    frames->size[1] = form->height;
}

sph2d_status film_strip_open(film_strip *strip, sph2d_report *report)
{
    strip->form.threads = strip->options->threads;
    return film_open(&strip->film, strip->options->film, &strip->form, report);
}

sph2d_status film_strip_add(film_strip *strip, size_t index, const unsigned char *pixels, sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    pthread_mutex_lock(&strip->lock);
    while (strip->next != index && !strip->given_up)
        pthread_cond_wait(&strip->changed, &strip->lock);
    if (!strip->given_up) {
        status = film_add(&strip->film, pixels, report);
        ++strip->next;
        strip->given_up = status != SPH2D_OK;
        pthread_cond_broadcast(&strip->changed);
    }
    pthread_mutex_unlock(&strip->lock);
    return status;
}

void film_strip_give_up(film_strip *strip)
{
    if (!strip)
        return;
    pthread_mutex_lock(&strip->lock);
    strip->given_up = true;
    pthread_cond_broadcast(&strip->changed);
    pthread_mutex_unlock(&strip->lock);
}

/* ---- its end ----------------------------------------------------------------------------------------------------- */

sph2d_status film_strip_close(film_strip *strip, sph2d_report *report)
{
    return film_close(&strip->film, report);
}

void film_strip_tell(const film_strip *strip, const frame_times *times)
{
    char draw[TEXT_SIZE], read[TEXT_SIZE], pace[TEXT_SIZE] = "", shown[TEXT_SIZE] = "";
    const double most = film_rate_max(strip->options->film), rate = strip->form.rate;
    if (strip->pace > 0 && fabs(strip->pace - 1) > 0.005)
        snprintf(pace, sizeof pace, ", %.3g times the pace of the scene", strip->pace);
    else if (strip->pace > 0)
        snprintf(pace, sizeof pace, ", the pace of the scene");
    if (rate > most)
        snprintf(shown, sizeof shown, " (%.3g of them are in the film)", most);
    const double per_frame = 1e3 / (double)times->frames;
    message_note("'%s': %u x %u pixels, %zu frame%s, %.3g a second%s%s; %s ms each to draw, %s to read back",
                 strip->options->film, strip->form.width, strip->form.height, strip->count,
                 strip->count == 1 ? "" : "s", rate, shown, pace, text_short(draw, times->sum.draw * per_frame),
                 text_short(read, times->sum.read * per_frame));
}

void film_strip_end(film_strip *strip)
{
    if (!strip)
        return;
    film_abort(&strip->film);
    pthread_mutex_destroy(&strip->lock);
    pthread_cond_destroy(&strip->changed);
}
