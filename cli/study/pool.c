/* SPDX-License-Identifier: MIT */
/** @file pool.c
 *  Rows in processes of their own. Each sends its record through a pipe when it is done. */
#include "parts.h"

#include <errno.h>
#include <inttypes.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <unistd.h>

#include "../exit.h"
#include "../message.h"
#include "../text.h"

/* A process that runs a row. */
typedef struct worker {
    pid_t pid; /* 0: none */
    int pipe;
    sph2d_study_row *row;
} worker;

typedef struct pool {
    cli_study *study;
    worker *workers; /* one a job */
    size_t next;     /* row to look at next */
    size_t running;
    bool stop_sent; /* the workers know that they shall stop */
    int code;
} pool;

static void note_code(pool *p, int code)
{
    p->code = study_first(p->code, code);
}

/* ---- starting ---------------------------------------------------------------------------------------------------- */

/* False, with errno, when there is no process or descriptor left. */
static bool start(pool *p, worker *w)
{
    int ends[2];
    if (pipe(ends) != 0)
        return false;
    fflush(NULL);
    pid_t parent = getpid(), pid = fork();
    if (pid == 0) {
        setpgid(0, 0); /* Ctrl-C reaches the study alone, which passes it on once */
#ifdef __linux__
        /* The lock on the folder is shared: a row that outlived its study would hold it. */
        prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
        close(ends[0]);
        study_work(p->study, w->row, parent, ends[1]);
    }
    int error = errno;
    close(ends[1]);
    if (pid < 0) {
        close(ends[0]);
        errno = error;
        return false;
    }
    setpgid(pid, pid); /* whoever comes first */
    w->pid = pid;
    w->pipe = ends[0];
    ++p->running;
    return true;
}

/* The next row that must be run; NULL when there is none. Those kept from earlier are taken on the way. */
static sph2d_study_row *next_row(pool *p)
{
    cli_study *s = p->study;
    for (; p->next < s->results->row_count; ++p->next) {
        sph2d_study_row *row = &s->results->rows[p->next];
        if (!row->wanted || row->there || !study_owns(s, row))
            continue;
        int code = study_find(s, row);
        note_code(p, code != CLI_EXIT_SUCCESS ? code : exit_of_status(row->record.status));
        if (code != CLI_EXIT_SUCCESS)
            continue;
        if (!row->there) {
            ++p->next;
            return row;
        }
        ++s->kept;
        if (row->record.end != SPH2D_STUDY_FINISHED)
            message_error(SPH2D_CODE_GENERAL, NULL, "row '%s', run earlier: %s", row->run.name, row->record.reason);
    }
    return NULL;
}

static void fill(pool *p)
{
    cli_study *s = p->study;
    for (size_t i = 0; i < s->jobs && signals_caught() == 0; ++i) {
        worker *w = &p->workers[i];
        if (w->pid != 0)
            continue;
        sph2d_study_row *row = w->row = next_row(p);
        if (!row)
            return;
        message_note("row %" PRIu64 " of %zu: %s", row->number, s->results->row_count, row->run.name);
        if (start(p, w))
            continue;
        if (p->running > 0) { /* when one of them ends there may be room */
            --p->next;
            return;
        }
        message_error(SPH2D_CODE_GENERAL, NULL, "row '%s': cannot start a process: %s", row->run.name, strerror(errno));
        note_code(p, CLI_EXIT_SOFTWARE);
    }
}

/* ---- ending ------------------------------------------------------------------------------------------------------ */

/* Why a process that sent no record did not, or one that was not asked to stop did. */
static void row_died(sph2d_study_row *row, int status, bool sent)
{
    sph2d_study_record *record = &row->record;
    char *reason = record->reason;
    record->end = SPH2D_STUDY_DIED;
    if (sent)
        snprintf(reason, sizeof record->reason, "somebody stopped its process at t = %g s", record->time);
    else if (WIFSIGNALED(status))
        snprintf(reason, sizeof record->reason, "its process was ended by signal %d (%s)", WTERMSIG(status),
                 strsignal(WTERMSIG(status)));
    else
        snprintf(reason, sizeof record->reason, "its process ended with %d and no result", WEXITSTATUS(status));
    message_error(SPH2D_CODE_GENERAL, NULL, "row '%s': %s", row->run.name, reason);
}

/* A worker sends all that it has in the end, so that nobody waits long here. */
static void finish(pool *p, worker *w)
{
    cli_study *s = p->study;
    sph2d_study_row *row = w->row;
    sph2d_study_record *record = &row->record;
    int status = 0;
    bool sent = study_receive(w->pipe, record);
    close(w->pipe);
    while (waitpid(w->pid, &status, 0) < 0 && errno == EINTR)
        ;
    w->pid = 0;
    --p->running;
    if (signals_caught() != 0 && (!sent || record->end == SPH2D_STUDY_STOPPED)) {
        message_note("stopped in row '%s' at t = %g s", row->run.name, record->time);
        sph2d_study_record_free(record);
        return;
    }
    if (!sent || record->end == SPH2D_STUDY_STOPPED)
        row_died(row, status, sent);
    row->there = true;
    char time[TEXT_SIZE];
    if (s->jobs > 1)
        message_note("row %" PRIu64 " of %zu done, %s CPU: %s", row->number, s->results->row_count,
                     text_seconds(time, record->cpu), row->run.name);
    note_code(p, record->end == SPH2D_STUDY_DIED ? CLI_EXIT_SOFTWARE : exit_of_status(record->status));
    if (record->end <= SPH2D_STUDY_GUARD)
        note_code(p, study_keep(s, row));
}

static void pass_signal_on(pool *p)
{
    if (signals_caught() == 0 || p->stop_sent)
        return;
    p->stop_sent = true;
    for (size_t i = 0; i < p->study->jobs; ++i)
        if (p->workers[i].pid != 0)
            kill(p->workers[i].pid, SIGTERM);
}

static int wait_for_some(pool *p, struct pollfd *polls)
{
    for (size_t i = 0; i < p->study->jobs; ++i)
        polls[i] = (struct pollfd){.fd = p->workers[i].pid != 0 ? p->workers[i].pipe : -1, .events = POLLIN};
    /* A signal that comes between the look at it and the wait is seen after this. */
    int count = poll(polls, p->study->jobs, 200);
    return count < 0 && errno != EINTR ? CLI_EXIT_SOFTWARE : CLI_EXIT_SUCCESS;
}

static void run_all(pool *p, struct pollfd *polls)
{
    for (fill(p); p->running > 0; fill(p)) {
        pass_signal_on(p);
        int code = wait_for_some(p, polls);
        note_code(p, code);
        for (size_t i = 0; i < p->study->jobs; ++i)
            if (p->workers[i].pid != 0 && (polls[i].revents != 0 || code != CLI_EXIT_SUCCESS))
                finish(p, &p->workers[i]);
    }
}

int study_pool_run(cli_study *s, size_t first)
{
    pool p = {.study = s, .next = first, .workers = calloc(s->jobs, sizeof *p.workers)};
    struct pollfd *polls = calloc(s->jobs, sizeof *polls);
    if (p.workers && polls)
        run_all(&p, polls);
    else
        p.code = study_report(s, SPH2D_NOMEM);
    s->stopped = s->stopped || signals_caught() != 0;
    free(p.workers);
    free(polls);
    return p.code;
}
