/* SPDX-License-Identifier: MIT */
/** @file study_pool.c
 *  Rows in processes of their own. Each sends its record through a pipe when it is done. */
#include "study_pool.h"

#include <errno.h>
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
#include "../signals.h"
#include "../text.h"
#include "study_run.h"
#include "study_store.h"

/* A process that runs a row. */
typedef struct worker {
    pid_t pid; /* 0: none */
    int pipe;
    study_row *row;
    char *key;  /* of the row */
    char *text; /* what it has sent so far */
    size_t length, room;
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
    p->code = p->code != CLI_EXIT_SUCCESS ? p->code : code;
}

/* ---- in the worker ----------------------------------------------------------------------------------------------- */

/* Never returns. */
static void work(cli_study *s, const study_row *row, int out)
{
    study_record record = {0};
    study_run(s, &row->run, s->jobs == 1, &record);
    FILE *stream = fdopen(out, "w");
    bool sent = stream != NULL;
    if (sent)
        study_record_write(&record, stream);
    sent = sent && ferror(stream) == 0;
    sent = sent && fclose(stream) == 0;
    _exit(sent ? CLI_EXIT_SUCCESS : CLI_EXIT_SOFTWARE); /* what the parent has buffered is the parent's to write */
}

/* ---- starting ---------------------------------------------------------------------------------------------------- */

/* False, with errno, when there is no process or descriptor left. */
static bool start(pool *p, worker *w)
{
    int ends[2];
    if (pipe(ends) != 0)
        return false;
    fflush(NULL);
    pid_t pid = fork();
    if (pid == 0) {
        setpgid(0, 0); /* Ctrl-C reaches the study alone, which passes it on once */
#ifdef __linux__
        /* The lock on the folder is shared: a row that outlived its study would hold it. */
        prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
        close(ends[0]);
        work(p->study, w->row, ends[1]);
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

/* The next row that must be run, with its key; NULL when there is none. Those kept from earlier are taken on the way.
 */
static study_row *next_row(pool *p, char **key)
{
    cli_study *s = p->study;
    for (; p->next < s->row_count; ++p->next) {
        study_row *row = &s->rows[p->next];
        if (!row->wanted || row->there)
            continue;
        *key = study_store_key(s, &row->run);
        if (*key == NULL) {
            note_code(p, CLI_EXIT_SOFTWARE);
            continue;
        }
        row->there = !s->options->force && study_store_find(s, *key, &row->record);
        if (!row->there) {
            ++p->next;
            return row;
        }
        ++s->kept;
        note_code(p, row->record.code);
        if (row->record.end != STUDY_FINISHED)
            message_error(SPH2D_CODE_GENERAL, NULL, "row '%s', run earlier: %s", row->run.name, row->record.reason);
        free(*key);
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
        char *key;
        study_row *row = next_row(p, &key);
        if (row == NULL)
            return;
        *w = (worker){.row = row, .key = key};
        message_note("row %zu of %zu: %s", row->number, s->row_count, row->run.name);
        if (start(p, w))
            continue;
        free(key);
        if (p->running > 0) { /* when one of them ends there may be room */
            --p->next;
            return;
        }
        message_error(SPH2D_CODE_GENERAL, NULL, "row '%s': cannot start a process: %s", row->run.name, strerror(errno));
        note_code(p, CLI_EXIT_SOFTWARE);
    }
}

/* ---- ending ------------------------------------------------------------------------------------------------------ */

/* A process that did not send its record. */
static void row_died(const worker *w, int status, study_record *record)
{
    record->end = signals_caught() != 0 ? STUDY_STOPPED : STUDY_DIED;
    record->code = CLI_EXIT_SOFTWARE;
    if (WIFSIGNALED(status))
        snprintf(record->reason, sizeof record->reason, "its process was ended by signal %d (%s)", WTERMSIG(status),
                 strsignal(WTERMSIG(status)));
    else
        snprintf(record->reason, sizeof record->reason, "its process ended with %d and no result", WEXITSTATUS(status));
    if (record->end == STUDY_DIED)
        message_error(SPH2D_CODE_GENERAL, NULL, "row '%s': %s", w->row->run.name, record->reason);
}

static void tell_row(const cli_study *s, const study_row *row)
{
    char time[TEXT_SIZE];
    if (s->jobs > 1)
        message_note("row %zu of %zu done, %s CPU: %s", row->number, s->row_count, text_seconds(time, row->record.cpu),
                     row->run.name);
}

static void finish(pool *p, worker *w)
{
    cli_study *s = p->study;
    int status = 0;
    while (waitpid(w->pid, &status, 0) < 0 && errno == EINTR)
        ;
    study_record *record = &w->row->record;
    bool whole = w->text != NULL && study_record_read(record, w->text);
    if (!whole) {
        study_record_free(record);
        row_died(w, status, record);
    }
    if (record->end == STUDY_STOPPED && signals_caught() == 0) {
        record->end = STUDY_DIED;
        record->code = CLI_EXIT_SOFTWARE;
        snprintf(record->reason, sizeof record->reason, "somebody stopped its process at t = %g s", record->time);
        message_error(SPH2D_CODE_GENERAL, NULL, "row '%s': %s", w->row->run.name, record->reason);
    }
    if (record->end == STUDY_STOPPED) {
        message_note("stopped in row '%s' at t = %g s", w->row->run.name, record->time);
        study_record_free(record);
    } else {
        w->row->there = true;
        tell_row(s, w->row);
        note_code(p, record->code);
        if (record->end <= STUDY_GUARD)
            note_code(p, study_store_keep(s, w->key, record));
    }
    close(w->pipe);
    free(w->text);
    free(w->key);
    *w = (worker){0};
    --p->running;
}

/* Takes what a worker sends. */
static void receive(pool *p, worker *w)
{
    if (w->length + 1 >= w->room) {
        size_t room = w->room > 0 ? 2 * w->room : 1 << 16;
        char *grown = realloc(w->text, room);
        if (grown == NULL) {
            kill(w->pid, SIGKILL);
            finish(p, w);
            return;
        }
        w->text = grown;
        w->room = room;
    }
    ssize_t count = read(w->pipe, w->text + w->length, w->room - w->length - 1);
    if (count < 0 && errno == EINTR)
        return;
    if (count <= 0) {
        finish(p, w);
        return;
    }
    w->length += (size_t)count;
    w->text[w->length] = '\0';
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
                receive(p, &p->workers[i]);
    }
}

int study_pool_run(cli_study *s, size_t first)
{
    pool p = {.study = s, .next = first, .workers = calloc(s->jobs, sizeof *p.workers)};
    struct pollfd *polls = calloc(s->jobs, sizeof *polls);
    if (p.workers != NULL && polls != NULL)
        run_all(&p, polls);
    else
        p.code = study_report(s, SPH2D_NOMEM, NULL, NULL);
    s->stopped = s->stopped || signals_caught() != 0;
    free(p.workers);
    free(polls);
    return p.code;
}
