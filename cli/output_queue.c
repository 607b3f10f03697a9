/* SPDX-License-Identifier: MIT */
/** @file output_queue.c
 *  A ring of jobs between the thread that steps and the one that draws and writes. */
#include "output_queue.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "threads.h"

/* A frame and a snapshot of one step, twice. */
enum { FRAMES = 2, JOBS = 2 * FRAMES };

/* A frame to draw. */
typedef struct drawable {
    sph2d_picture picture;
    frame_buffers buffers;
} drawable;

/* A frame, or a snapshot. */
typedef struct job {
    char *path;            /* owned; NULL for a snapshot */
    const drawable *frame; /* one of the queue's */
    sph2d_snapshot_draft *draft;
} job;

struct output_queue {
    pthread_t thread;
    clockid_t cpu_clock;
    frame_writer *writer;
    drawable drawables[FRAMES];
    size_t frames; /* that were taken: the next takes the place of the last but one */
    frame_times times;

    pthread_mutex_t lock; /* for what follows */
    pthread_cond_t changed;
    job jobs[JOBS]; /* a ring: `count` from `first` on, which is being worked on */
    size_t first, count;
    size_t frames_done;
    bool ending;
    sph2d_status status; /* of the first failure */
    sph2d_report report; /* of it, until it is told */
};

/* ---- the thread -------------------------------------------------------------------------------------------------- */

static sph2d_status do_job(output_queue *q, const job *j, sph2d_report *report)
{
    return j->draft ? sph2d_snapshot_commit(j->draft, report)
                    : frame_writer_save(q->writer, &j->frame->picture, j->path, &q->times, report);
}

/* With the lock, which it gives back while it works. */
static void work_off(output_queue *q)
{
    const job j = q->jobs[q->first];
    const bool skip = q->status != SPH2D_OK;
    pthread_mutex_unlock(&q->lock);
    sph2d_report report = {0};
    sph2d_status status = SPH2D_OK;
    if (!skip)
        status = do_job(q, &j, &report);
    else
        sph2d_snapshot_abort(j.draft);
    free(j.path);
    pthread_mutex_lock(&q->lock);
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
    threads_count_caller();
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
        frame_free(&q->drawables[i].buffers);
    pthread_mutex_destroy(&q->lock);
    pthread_cond_destroy(&q->changed);
    free(q);
}

output_queue *output_queue_start(frame_writer *writer)
{
    output_queue *q = calloc(1, sizeof *q);
    if (!q)
        return NULL;
    q->writer = writer;
    pthread_mutex_init(&q->lock, NULL);
    pthread_cond_init(&q->changed, NULL);
    if (pthread_create(&q->thread, NULL, work, q) == 0) {
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

/* Waits for a place in the ring. */
static sph2d_status add(output_queue *q, const job *j, sph2d_report *report)
{
    pthread_mutex_lock(&q->lock);
    while (q->count == JOBS)
        pthread_cond_wait(&q->changed, &q->lock);
    const sph2d_status status = tell(q, report);
    if (status == SPH2D_OK) {
        q->jobs[(q->first + q->count++) % JOBS] = *j;
        pthread_cond_broadcast(&q->changed);
    }
    pthread_mutex_unlock(&q->lock);
    return status;
}

/* Waits until the next drawable is free. */
static drawable *find_free(output_queue *q)
{
    pthread_mutex_lock(&q->lock);
    while (q->frames - q->frames_done == FRAMES)
        pthread_cond_wait(&q->changed, &q->lock);
    pthread_mutex_unlock(&q->lock);
    return &q->drawables[q->frames % FRAMES];
}

sph2d_status output_queue_frame(output_queue *q, const particle_source *source, const frame_style *style,
                                const char *path, sph2d_report *report)
{
    drawable *frame = find_free(q);
    sph2d_status status = frame_make(source, style, &frame->buffers, &frame->picture, report);
    if (status != SPH2D_OK)
        return status;
    const job j = {.path = strdup(path), .frame = frame};
    status = j.path ? add(q, &j, report) : SPH2D_NOMEM;
    if (status == SPH2D_OK)
        ++q->frames;
    else
        free(j.path);
    return status;
}

sph2d_status output_queue_snapshot(output_queue *q, sph2d_snapshot_draft *draft, sph2d_report *report)
{
    job j = {.draft = draft};
    const sph2d_status status = add(q, &j, report);
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

frame_times output_queue_times(const output_queue *q)
{
    return q->times;
}
