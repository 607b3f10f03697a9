/* SPDX-License-Identifier: MIT */
/** @file output_queue.c
 *  A ring of jobs between the thread that steps and the one that writes. */
#include "output_queue.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "frame_writer.h"

/* A frame and a snapshot of one step, twice. */
enum { FRAMES = 2, JOBS = 2 * FRAMES };

/* A frame, or a snapshot. */
typedef struct job {
    char *path;            /* owned; NULL for a snapshot */
    unsigned char *pixels; /* one of the queue's buffers */
    sph2d_snapshot_draft *draft;
} job;

struct output_queue {
    pthread_t thread;
    clockid_t cpu_clock;
    unsigned width, height;
    sph2d_background background;
    unsigned char *buffers[FRAMES];
    size_t frames; /* that were taken: the next is copied to the buffer of the last but one */

    pthread_mutex_t lock; /* for what follows */
    pthread_cond_t changed;
    job jobs[JOBS]; /* a ring: `count` from `first` on, which is being worked on */
    size_t first, count;
    size_t frames_done;
    bool ending;
    double encoding;
    sph2d_status status; /* of the first failure */
    sph2d_report report; /* of it, until it is told */
};

/* ---- the thread -------------------------------------------------------------------------------------------------- */

static sph2d_status do_job(const output_queue *q, const job *j, sph2d_report *report)
{
    return j->draft ? sph2d_snapshot_commit(j->draft, report)
                    : frame_encode(j->path, j->pixels, q->width, q->height, q->background, report);
}

/* With the lock, which it gives back while it works. */
static void work_off(output_queue *q)
{
    const job j = q->jobs[q->first];
    const bool skip = q->status != SPH2D_OK;
    pthread_mutex_unlock(&q->lock);
    sph2d_report report = {0};
    sph2d_status status = SPH2D_OK;
    const double begun = clock_wall();
    if (!skip)
        status = do_job(q, &j, &report);
    else
        sph2d_snapshot_abort(j.draft);
    const double taken = j.draft ? 0 : clock_wall() - begun;
    free(j.path);
    pthread_mutex_lock(&q->lock);
    q->encoding += taken;
    q->frames_done += !j.draft;
    if (status != SPH2D_OK) {
        q->status = status;
        q->report = report;
    }
    q->first = (q->first + 1) % JOBS;
    --q->count;
    pthread_cond_broadcast(&q->changed);
}

static void *work(void *queue)
{
    output_queue *q = queue;
    pthread_mutex_lock(&q->lock);
    while (q->count > 0 || !q->ending) {
        if (q->count > 0)
            work_off(q);
        else
            pthread_cond_wait(&q->changed, &q->lock);
    }
    pthread_mutex_unlock(&q->lock);
    return NULL;
}

/* ---- its start and end ------------------------------------------------------------------------------------------- */

static void free_all(output_queue *q)
{
    for (int i = 0; i < FRAMES; ++i)
        free(q->buffers[i]);
    pthread_mutex_destroy(&q->lock);
    pthread_cond_destroy(&q->changed);
    free(q);
}

output_queue *output_queue_start(unsigned width, unsigned height, sph2d_background background)
{
    output_queue *q = calloc(1, sizeof *q);
    if (!q)
        return NULL;
    q->width = width;
    q->height = height;
    q->background = background;
    pthread_mutex_init(&q->lock, NULL);
    pthread_cond_init(&q->changed, NULL);
    bool room = true;
    for (int i = 0; i < FRAMES; ++i)
        room = (q->buffers[i] = malloc((size_t)width * height * 4)) && room;
    if (room && pthread_create(&q->thread, NULL, work, q) == 0) {
        if (pthread_getcpuclockid(q->thread, &q->cpu_clock) != 0)
            q->cpu_clock = CLOCK_PROCESS_CPUTIME_ID;
        return q;
    }
    free_all(q);
    return NULL;
}

void output_queue_end(output_queue *q)
{
    if (!q)
        return;
    pthread_mutex_lock(&q->lock);
    q->ending = true;
    pthread_cond_broadcast(&q->changed);
    pthread_mutex_unlock(&q->lock);
    pthread_join(q->thread, NULL);
    free_all(q);
}

/* ---- jobs -------------------------------------------------------------------------------------------------------- */

/* With the lock: the first failure, whose message is told once. */
static sph2d_status tell(output_queue *q, sph2d_report *report)
{
    for (size_t i = 0; i < q->report.count; ++i) {
        const sph2d_diagnostic *from = &q->report.items[i];
        sph2d_diagnostic *to = sph2d_report_add(report, from->severity, from->code, NULL, "%s", from->message);
        if (to)
            *to = *from;
    }
    sph2d_report_clear(&q->report);
    return q->status;
}

/* Waits for a place in the ring, and for a buffer where it is a frame. */
static sph2d_status add(output_queue *q, job *j, const unsigned char *pixels, sph2d_report *report)
{
    pthread_mutex_lock(&q->lock);
    while (q->count == JOBS || (!j->draft && q->frames - q->frames_done == FRAMES))
        pthread_cond_wait(&q->changed, &q->lock);
    const sph2d_status status = tell(q, report);
    if (status == SPH2D_OK) {
        if (!j->draft) {
            j->pixels = q->buffers[q->frames++ % FRAMES];
            memcpy(j->pixels, pixels, (size_t)q->width * q->height * 4);
        }
        q->jobs[(q->first + q->count++) % JOBS] = *j;
        pthread_cond_broadcast(&q->changed);
    }
    pthread_mutex_unlock(&q->lock);
    return status;
}

sph2d_status output_queue_frame(output_queue *q, const unsigned char *pixels, const char *path, sph2d_report *report)
{
    job j = {.path = strdup(path)};
    const sph2d_status status = j.path ? add(q, &j, pixels, report) : SPH2D_NOMEM;
    if (status != SPH2D_OK)
        free(j.path);
    return status;
}

sph2d_status output_queue_snapshot(output_queue *q, sph2d_snapshot_draft *draft, sph2d_report *report)
{
    job j = {.draft = draft};
    const sph2d_status status = add(q, &j, NULL, report);
    if (status != SPH2D_OK)
        sph2d_snapshot_abort(draft);
    return status;
}

sph2d_status output_queue_wait(output_queue *q, sph2d_report *report)
{
    pthread_mutex_lock(&q->lock);
    while (q->count > 0)
        pthread_cond_wait(&q->changed, &q->lock);
    const sph2d_status status = tell(q, report);
    pthread_mutex_unlock(&q->lock);
    return status;
}

double output_queue_cpu(const output_queue *q)
{
    return q->cpu_clock == CLOCK_PROCESS_CPUTIME_ID ? 0 : clock_seconds(q->cpu_clock);
}

double output_queue_encoding(const output_queue *q)
{
    return q->encoding;
}
