/* SPDX-License-Identifier: MIT */
/** @file progress.c
 *  Progress of a long job. */
#include "progress.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "clock.h"
#include "message.h"
#include "text.h"

/* Minimum interval of the bar [s]; maximum interval of plain lines [s], which are also printed at every tenth. */
static const double bar_interval = 0.1;
static const double line_interval = 30;
enum { BAR_WIDTH = 24, LINE_SIZE = 240 };

cli_progress progress_begin(const cli_options *options, double from, double to)
{
    cli_progress p = {.form = PROGRESS_OFF, .from = from, .to = to, .begun = clock_wall()};
    p.printed = p.begun;
    if (options->progress == PROGRESS_NEVER || (options->quiet && options->progress == PROGRESS_AUTO))
        return p;
    /* JSON Lines must not contain a bar that is redrawn. */
    bool bar = options->progress == PROGRESS_ALWAYS || message_terminal();
    p.form = bar && !options->json ? PROGRESS_BAR : PROGRESS_LINES;
    return p;
}

static unsigned terminal_width(void)
{
    struct winsize size;
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        return size.ws_col;
    return 80;
}

/* Truncated to the terminal's width, since a wrapped line cannot be redrawn. */
static void draw_bar(double done, const char *detail, const char *left)
{
    char bar[BAR_WIDTH + 1];
    int filled = (int)(done * BAR_WIDTH);
    for (int i = 0; i < BAR_WIDTH; ++i)
        bar[i] = i < filled ? '=' : i == filled ? '>' : ' ';
    bar[BAR_WIDTH] = '\0';
    char line[LINE_SIZE];
    snprintf(line, sizeof line, "[%s] %3d %%  %s left  %s", bar, (int)(done * 100), left, detail);
    unsigned width = terminal_width();
    if (width - 1 < sizeof line)
        line[width - 1] = '\0';
    message_status(line);
}

void progress_update(cli_progress *p, double now, const char *format, ...)
{
    if (p->form == PROGRESS_OFF)
        return;
    double clock = clock_wall();
    double total = p->to - p->from;
    double done = total > 0 ? fmin(fmax((now - p->from) / total, 0), 1) : 1;
    double tenth = floor(done * 10);
    double since_printed = clock - p->printed;
    if (p->form == PROGRESS_BAR ? since_printed < bar_interval
                                : tenth <= p->printed_tenth && since_printed < line_interval)
        return;
    p->printed = clock;
    p->printed_tenth = tenth;
    char detail[LINE_SIZE / 2];
    va_list values;
    va_start(values, format);
    vsnprintf(detail, sizeof detail, format, values);
    va_end(values);
    char left[TEXT_SIZE];
    text_seconds(left, done > 0 ? (clock - p->begun) * (1 - done) / done : -1);
    if (p->form == PROGRESS_BAR)
        draw_bar(done, detail, left);
    else
        message_note("%3d %%  %s left  %s", (int)(done * 100), left, detail);
}

void progress_end(cli_progress *p)
{
    if (p->form == PROGRESS_BAR)
        message_status(NULL);
}
