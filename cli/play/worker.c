/* SPDX-License-Identifier: MIT */
/** @file worker.c
 *  A thread that waits for work, by POSIX threads: the one that asks goes on, which a region of OpenMP is not made for. */
#include "turn.h"

#include <pthread.h>
#include <stdlib.h>

typedef enum work_state { IDLE, WORKING, ENDING } work_state;

struct worker {
    void (*work)(void *);
    void *context;
    pthread_t thread;
    pthread_mutex_t lock; /* for the state */
    pthread_cond_t changed;
    work_state state;
};

static void set_state(worker *w, work_state state)
{
    w->state = state;
    pthread_cond_broadcast(&w->changed);
}

static void *work_off(void *worker_)
{
    worker *w = worker_;
    pthread_mutex_lock(&w->lock);
    for (;;) {
        while (w->state == IDLE)
            pthread_cond_wait(&w->changed, &w->lock);
        if (w->state == ENDING)
            break;
        pthread_mutex_unlock(&w->lock);
        w->work(w->context);
        pthread_mutex_lock(&w->lock);
        set_state(w, IDLE);
    }
    pthread_mutex_unlock(&w->lock);
    return NULL;
}

worker *worker_start(void (*work)(void *), void *context)
{
    worker *w = calloc(1, sizeof *w);
    if (!w)
        return NULL;
    w->work = work;
    w->context = context;
    pthread_mutex_init(&w->lock, NULL);
    pthread_cond_init(&w->changed, NULL);
    if (pthread_create(&w->thread, NULL, work_off, w) == 0)
        return w;
    pthread_cond_destroy(&w->changed);
    pthread_mutex_destroy(&w->lock);
    free(w);
    return NULL;
}

void worker_begin(worker *w)
{
    pthread_mutex_lock(&w->lock);
    set_state(w, WORKING);
    pthread_mutex_unlock(&w->lock);
}

void worker_wait(worker *w)
{
    pthread_mutex_lock(&w->lock);
    while (w->state == WORKING)
        pthread_cond_wait(&w->changed, &w->lock);
    pthread_mutex_unlock(&w->lock);
}

void worker_stop(worker *w)
{
    if (!w)
        return;
    worker_wait(w);
    pthread_mutex_lock(&w->lock);
    set_state(w, ENDING);
    pthread_mutex_unlock(&w->lock);
    pthread_join(w->thread, NULL);
    pthread_cond_destroy(&w->changed);
    pthread_mutex_destroy(&w->lock);
    free(w);
}
