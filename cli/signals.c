/* SPDX-License-Identifier: MIT */
/** @file signals.c
 *  Signals that stop a run. */
#include "signals.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t caught;

static const int stop_signals[] = {SIGINT, SIGTERM};
enum { STOP_SIGNAL_COUNT = sizeof stop_signals / sizeof *stop_signals };

static void handle_signal(int number)
{
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

int signals_caught(void)
{
    return caught;
}
