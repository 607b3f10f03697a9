/* SPDX-License-Identifier: MIT */
/** @file worker.c
 *  The process of a row. */
#include "parts.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <unistd.h>

#include "../exit.h"
#include "../message.h"

typedef struct work {
    cli_study *study;
    pid_t parent;
    cli_progress progress;
} work;

/* Nobody waits for a row whose study was killed. One that runs alone shows how far it is. */
static bool go_on(void *user, const sph2d_study_run *run, const sph2d_sim *sim)
{
    work *w = user;
    double time = sph2d_sim_time(sim), until = sph2d_sim_scene(sim)->run.until;
    if (sph2d_sim_steps(sim) == 0) {
        signals_note();
        study_report(w->study, SPH2D_OK); /* warnings do not wait for the end */
        w->progress = progress_begin(w->study->options, 0, until);
        w->progress.printed_tenth = 10; /* rows are printed anyway: lines come only where one takes long */
    }
    const progress_fact facts[] = {{"row", 0, run->name},
                                   {"time", time, NULL},
                                   {"until", until, NULL},
                                   {"steps", (double)sph2d_sim_steps(sim), NULL},
                                   {NULL, 0, NULL}};
    if (w->study->jobs == 1)
        progress_update(&w->progress, time, facts, "t %.4g of %.4g s  step %" PRIu64 "  %s", time, until,
                        sph2d_sim_steps(sim), run->name);
    return signals_caught() == 0 && getppid() == w->parent;
}

static bool send_record(int out, const sph2d_study_record *record)
{
    size_t size = sph2d_study_record_pack(record, NULL, 0);
    char *block = malloc(size);
    ssize_t count = 0;
    if (!block)
        return false;
    sph2d_study_record_pack(record, block, size);
    for (size_t sent = 0; sent < size && (count >= 0 || errno == EINTR); sent += count > 0 ? (size_t)count : 0)
        count = write(out, block + sent, size - sent);
    free(block);
    return count >= 0;
}

void study_work(cli_study *s, sph2d_study_row *row, pid_t parent, int out)
{
    work w = {.study = s, .parent = parent, .progress = {.form = PROGRESS_OFF}};
    sph2d_study_run_options options = {.threads = s->threads.wanted,
                                       .isa = s->options->isa,
                                       .device = s->device.number,
                                       .same_bits = s->device.same_bits,
                                       .repeat = s->repeat,
                                       .beside_others = s->jobs > 1 || s->options->shards > 0,
                                       .go_on = go_on,
                                       .user = &w};
    signals_prepare();
    sph2d_status status = sph2d_study_row_run(s->results, row, &options, &s->report);
    progress_end(&w.progress);
    study_report(s, status);
    bool sent = send_record(out, &row->record);
    _exit(sent ? CLI_EXIT_SUCCESS : CLI_EXIT_SOFTWARE); /* what the parent has buffered is the parent's to write */
}

bool study_receive(int in, sph2d_study_record *record)
{
    size_t length = 0, room = 0;
    char *block = NULL;
    for (;;) {
        if (length == room) {
            room = room > 0 ? 2 * room : 1 << 16;
            char *grown = realloc(block, room);
            if (!grown)
                break;
            block = grown;
        }
        ssize_t count = read(in, block + length, room - length);
        if (count == 0 || (count < 0 && errno != EINTR))
            break;
        length += count > 0 ? (size_t)count : 0;
    }
    bool whole = sph2d_study_record_unpack(record, block, length) == SPH2D_OK;
    free(block);
    return whole;
}
