/* SPDX-License-Identifier: MIT */
/** @file signals.c
 *  Signals that stop a command. */
#include "signals.h"

#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <unistd.h>

#include "made_folders.h"

static volatile sig_atomic_t caught;

/* A signal may come to any thread while the main one ends its preparation: whoever changes PREPARING first decides. */
enum { PREPARING, NOTING, ENDING };
static atomic_int phase;

static const int stop_signals[] = {SIGINT, SIGTERM, SIGHUP};
enum { STOP_SIGNAL_COUNT = sizeof stop_signals / sizeof *stop_signals };

static bool change_phase(int to)
{
    int preparing = PREPARING;
    return atomic_compare_exchange_strong(&phase, &preparing, to);
}

static void end_now(int number)
{
    made_folders_remove();
    _exit(128 + number);
}

static void handle_signal(int number)
{
    if (change_phase(ENDING))
        end_now(number);
    caught = number;
    /* A second signal ends the process at once: restore the default actions. */
    struct sigaction default_action = {.sa_handler = SIG_DFL};
    for (size_t i = 0; i < STOP_SIGNAL_COUNT; ++i)
        sigaction(stop_signals[i], &default_action, NULL);
}

void signals_install(void)
{
    struct sigaction action = {.sa_handler = handle_signal, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < STOP_SIGNAL_COUNT; ++i) {
        struct sigaction before;
        if (sigaction(stop_signals[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(stop_signals[i], &action, NULL);
    }
    /* A closed pipe or a file size limit must not kill a long run: writing fails with an error instead. */
    struct sigaction ignore = {.sa_handler = SIG_IGN};
    sigaction(SIGPIPE, &ignore, NULL);
    sigaction(SIGXFSZ, &ignore, NULL);
}

void signals_note(void)
{
    if (change_phase(NOTING))
        return;
    while (atomic_load(&phase) == ENDING) /* another thread is about to end the process */
        pause();
}

void signals_prepare(void)
{
    atomic_store(&phase, PREPARING);
    if (caught != 0)
        end_now(caught);
}

int signals_caught(void)
{
    return caught;
}

const char *signals_name(int number)
{
    return number == SIGINT ? "SIGINT" : number == SIGHUP ? "SIGHUP" : "SIGTERM";
}
