/* SPDX-License-Identifier: MIT */
/** @file message.c
 *  Messages and progress on stderr. Their style is global to the process, and kept here. */
#include "message.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "clock.h"
#include "exit.h"
#include "json.h"
#include "text.h"

static struct {
    bool json, quiet, color;
    int verbose;
    bool status_shown;
} style;

/* Size of a formatted diagnostic. */
enum { MESSAGE_SIZE = 2048 };

bool message_terminal(void)
{
    const char *term = getenv("TERM");
    return isatty(STDERR_FILENO) && term && strcmp(term, "dumb") != 0;
}

void message_setup(const cli_options *options)
{
    const char *no_color = getenv("NO_COLOR");
    style.json = options->json;
    breakdown_use_json(options->json);
    style.quiet = options->quiet;
    style.verbose = options->verbose;
    style.color = !options->no_color && (!no_color || no_color[0] == '\0') && message_terminal();
}

void message_status(const char *text)
{
    if (!text && !style.status_shown)
        return;
    style.status_shown = text;
    /* back to the first column, erase to the end of the line */
    fprintf(stderr, "\r\033[K%s", text ? text : "");
}

/* ---- text -------------------------------------------------------------------------------------------------------- */

/* Replaces all that a terminal could interpret, with the control characters of Latin-1: the text may come from any
 * file.
 * */
static void make_printable(char *text)
{
    for (char *c = text; *c != '\0'; ++c) {
        unsigned char byte = (unsigned char)*c;
        size_t length = byte < 0x80 ? 1 : text_utf8_length(c);
        bool control = (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7F;
        if (length == 0 || control || (byte == 0xC2 && (unsigned char)c[1] < 0xA0))
            *c = '?';
        else
            c += length - 1;
    }
}

/* Writes one or more lines in a single write, so that those of several processes do not mix. The word at `mark`, up to
 * its colon, is coloured; NULL for none. */
static void write_text(char *text, const char *mark, const char *color)
{
    message_status(NULL);
    make_printable(text);
    char out[MESSAGE_SIZE + 32];
    size_t before = mark && style.color ? (size_t)(mark - text) : 0;
    size_t word = mark && style.color ? strcspn(mark, ":") : 0;
    int length = snprintf(out, sizeof out, "%.*s%s%.*s%s%s\n", (int)before, text, word > 0 ? color : "", (int)word,
                          text + before, word > 0 ? "\033[0m" : "", text + before + word);
    if (length > 0)
        fwrite(out, 1, (size_t)length < sizeof out ? (size_t)length : sizeof out - 1, stderr);
}

static void write_diagnostic_text(const sph2d_diagnostic *diagnostic)
{
    char text[MESSAGE_SIZE] = "";
    /* A diagnostic without a file starts with "sph2d:", and has no code if that is the general one. */
    bool warning = diagnostic->severity == SPH2D_WARNING;
    const char *kind = warning ? "warning" : "error";
    if (diagnostic->file[0] == '\0')
        snprintf(text, sizeof text, "sph2d: ");
    size_t used = strlen(text);
    if (diagnostic->file[0] == '\0' && diagnostic->path[0] == '\0' && diagnostic->code == SPH2D_CODE_GENERAL)
        snprintf(text + used, sizeof text - used, "%s: %s%s%s", kind, diagnostic->message,
                 diagnostic->hint[0] != '\0' ? "\n    hint: " : "", diagnostic->hint);
    else
        sph2d_diagnostic_format(diagnostic, text + used, sizeof text - used);
    /* Search after the file's name, which may contain the same word. */
    size_t name = strlen(diagnostic->file);
    write_text(text, strstr(text + name, kind), warning ? "\033[1;35m" : "\033[1;31m");
}

/* ---- JSON -------------------------------------------------------------------------------------------------------- */

/* A diagnostic as JSON. */
typedef struct object {
    const char *severity;
    const sph2d_diagnostic *diagnostic;
} object;

static void put_object(const void *what, FILE *out)
{
    const object *o = what;
    const sph2d_diagnostic *d = o->diagnostic;
    cli_json line = json_begin(out);
    json_text(&line, "severity", o->severity);
    json_text(&line, "code", sph2d_code_text(d->code));
    if (d->file[0] != '\0')
        json_text(&line, "file", d->file);
    if (d->line > 0) {
        json_count(&line, "line", (uint64_t)d->line);
        json_count(&line, "column", (uint64_t)d->column);
    }
    if (d->path[0] != '\0')
        json_text(&line, "path", d->path);
    json_text(&line, "message", d->message);
    if (d->hint[0] != '\0')
        json_text(&line, "hint", d->hint);
    json_end(&line);
}

/* Composed first, so that the object reaches stderr in one write; directly if memory is short. */
static void write_composed(void (*put)(const void *what, FILE *out), const void *what)
{
    size_t length = 0;
    char *text = compose(put, what, &length);
    if (text)
        fwrite(text, 1, length, stderr);
    else
        put(what, stderr);
    free(text);
}

static void write_object(const char *severity, const sph2d_diagnostic *d)
{
    write_composed(put_object, &(const object){severity, d});
}

static void write_diagnostic(const sph2d_diagnostic *diagnostic)
{
    if (style.json)
        write_object(diagnostic->severity == SPH2D_WARNING ? "warning" : "error", diagnostic);
    else
        write_diagnostic_text(diagnostic);
}

/* ---- interface --------------------------------------------------------------------------------------------------- */

#define FORMAT_INTO(buffer, format)                                                                                    \
    do {                                                                                                               \
        va_list values;                                                                                                \
        va_start(values, format);                                                                                      \
        vsnprintf(buffer, sizeof(buffer), format, values);                                                             \
        va_end(values);                                                                                                \
    } while (0)

void message_usage(const char *command, const char *format, ...)
{
    sph2d_diagnostic d = {0};
    FORMAT_INTO(d.message, format);
    if (style.json) {
        write_diagnostic(&d);
        return;
    }
    char text[MESSAGE_SIZE];
    const char *space = command ? " " : "";
    const char *name = command ? command : "";
    snprintf(text, sizeof text, "sph2d%s%s: %s\nTry 'sph2d%s%s --help'.", space, name, d.message, space, name);
    write_text(text, NULL, NULL);
}

void message_error(sph2d_code code, const char *hint, const char *format, ...)
{
    sph2d_diagnostic d = {.code = code};
    FORMAT_INTO(d.message, format);
    snprintf(d.hint, sizeof d.hint, "%s", hint ? hint : "");
    write_diagnostic(&d);
}

void message_warning(sph2d_code code, const char *format, ...)
{
    sph2d_diagnostic d = {.severity = SPH2D_WARNING, .code = code};
    FORMAT_INTO(d.message, format);
    write_diagnostic(&d);
}

static void write_note(sph2d_diagnostic *d)
{
    if (style.json) {
        write_object("note", d);
        return;
    }
    char text[MESSAGE_SIZE];
    snprintf(text, sizeof text, "sph2d: %s", d->message);
    write_text(text, NULL, NULL);
}

void message_note(const char *format, ...)
{
    if (style.quiet)
        return;
    sph2d_diagnostic d = {0};
    FORMAT_INTO(d.message, format);
    write_note(&d);
}

void message_detail(const char *format, ...)
{
    if (style.verbose == 0)
        return;
    sph2d_diagnostic d = {0};
    FORMAT_INTO(d.message, format);
    write_note(&d);
}

void message_report(sph2d_status status, sph2d_report *report, const sph2d_scene_file *file)
{
    for (size_t i = 0; i < report->count; ++i) {
        if (file && report->items[i].file[0] == '\0' && report->items[i].path[0] != '\0')
            sph2d_scene_file_locate(file, &report->items[i]);
        write_diagnostic(&report->items[i]);
    }
    if (report->dropped > 0)
        message_note("%zu more not shown", report->dropped);
    if (status != SPH2D_OK && report->errors == 0)
        message_error(SPH2D_CODE_GENERAL, NULL, "%s", sph2d_status_text(status));
    sph2d_report_clear(report);
}

/* ---- progress ---------------------------------------------------------------------------------------------------- */

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

/* A line of progress as JSON. */
typedef struct stand {
    double done, elapsed, remaining;
    const progress_fact *facts;
} stand;

static void put_stand(const void *what, FILE *out)
{
    const stand *s = what;
    cli_json line = json_begin(out);
    json_text(&line, "severity", "progress");
    json_number(&line, "ratio", s->done);
    json_number(&line, "elapsed_seconds", s->elapsed);
    json_number(&line, "remaining_seconds", s->remaining);
    for (const progress_fact *f = s->facts; f->key; ++f)
        if (f->text)
            json_text(&line, f->key, f->text);
        else
            json_number(&line, f->key, f->number);
    json_end(&line);
}

void progress_update(cli_progress *p, double now, const progress_fact *facts, const char *format, ...)
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
    const double elapsed = clock - p->begun, remaining = done > 0 ? elapsed * (1 - done) / done : NAN;
    if (style.json) {
        if (!style.quiet)
            write_composed(put_stand, &(const stand){done, elapsed, remaining, facts});
        return;
    }
    char detail[LINE_SIZE / 2];
    va_list values;
    va_start(values, format);
    vsnprintf(detail, sizeof detail, format, values);
    va_end(values);
    char left[TEXT_SIZE];
    text_seconds(left, done > 0 ? remaining : -1);
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
