/* SPDX-License-Identifier: MIT */
/** @file study_plot.c
 *  A script for gnuplot with the numbers in it, and gnuplot to run it. */
#include "study_plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../exit.h"
#include "../message.h"
#include "../text.h"
#include "study_front.h"
#include "study_order.h"
#include "study_settings.h"
#include "study_text.h"

/* With more settings than this only those that reach the front have a colour and a name. */
enum { MOST_NAMED = 8, LABEL_SIZE = 120 };

static const char *const names[] = {"error_time", "error_along"};
static const char *const kinds[] = {"svg", "png"};

static bool has_error(const cli_study *s, const study_row *row)
{
    return study_front_error(s, row) > 0;
}

/* A picture needs two points; against the `along` key, two of rows that belong together. */
static int picture_count(const cli_study *s)
{
    size_t points = 0;
    int count = 0;
    for (size_t r = 0; r < s->row_count; ++r) {
        if (!has_error(s, &s->rows[r]))
            continue;
        count = ++points > 1 && count == 0 ? 1 : count;
        for (size_t k = 0; k < r; ++k)
            if (has_error(s, &s->rows[k]) && study_order_belong(s, &s->rows[k], &s->rows[r]) &&
                study_order_along(s, &s->rows[k]) != study_order_along(s, &s->rows[r]))
                return 2;
    }
    return count;
}

/* ---- settings ---------------------------------------------------------------------------------------------------- */

/* Rows that belong together are one line: `leader[r]` is the first of those that row r belongs to. */
typedef struct drawing {
    const cli_study *study;
    size_t *leader;
    bool *on_front; /* whether a line reaches it, by its leader */
    size_t lines;
} drawing;

static bool leads(const drawing *d, size_t row)
{
    return has_error(d->study, &d->study->rows[row]) && d->leader[row] == row;
}

/* Whether a line has a colour and a name. */
static bool is_named(const drawing *d, size_t leader)
{
    return d->lines <= MOST_NAMED || d->on_front[leader];
}

/* Finds the lines. `d` has room for as many as there are rows. */
static void find_lines(drawing *d)
{
    const cli_study *s = d->study;
    for (size_t r = 0; r < s->row_count; ++r) {
        d->leader[r] = r;
        for (size_t k = 0; k < r && d->leader[r] == r && has_error(s, &s->rows[r]); ++k)
            if (leads(d, k) && study_order_belong(s, &s->rows[k], &s->rows[r]))
                d->leader[r] = k;
        d->on_front[d->leader[r]] = d->on_front[d->leader[r]] || s->rows[r].on_front;
        d->lines += leads(d, r);
    }
}

/* Whether a later override of the same key hides this one. */
static bool is_hidden(const sph2d_study_run *run, size_t override)
{
    for (size_t i = override + 1; i < run->override_count; ++i)
        if (strcmp(run->overrides[i].path, run->overrides[override].path) == 0)
            return true;
    return false;
}

/* Quotes would end gnuplot's text. */
static void clean(char *text)
{
    for (; *text != '\0'; ++text)
        if (*text == '\'' || *text == '\\' || *text == '`')
            *text = ' ';
}

/* "kernel=quintic, support_ratio=3": the settings that rows which belong together have in common. */
static void write_label(const cli_study *s, const sph2d_study_run *run, char out[LABEL_SIZE])
{
    bool named = s->study->vary_count > 0 && study_name_without(run, s->study->along, out, LABEL_SIZE) != NULL;
    size_t used = named ? strlen(out) : 0;
    for (size_t i = 0; i < run->override_count && !named && used < LABEL_SIZE; ++i) {
        const char *path = run->overrides[i].path;
        if (strcmp(path, s->study->along) == 0 || is_hidden(run, i))
            continue;
        used += (size_t)snprintf(out + used, LABEL_SIZE - used, "%s%s=%s", used > 0 ? ", " : "", study_key(path),
                                 run->overrides[i].value);
    }
    if (used == 0)
        snprintf(out, LABEL_SIZE, "the scene");
    text_whole(out);
    clean(out);
}

/* ---- the script -------------------------------------------------------------------------------------------------- */

/* What the plots show of a row. */
typedef struct point {
    double time, error, along;
} point;

static int by_along(const void *a, const void *b)
{
    double x = ((const point *)a)->along, y = ((const point *)b)->along;
    return x < y ? 1 : x > y ? -1 : 0;
}

static int by_time(const void *a, const void *b)
{
    double x = ((const point *)a)->time, y = ((const point *)b)->time;
    return x > y ? 1 : x < y ? -1 : 0;
}

static void put_block(FILE *out, const char *name, size_t number, point *points, size_t count,
                      int (*order)(const void *, const void *))
{
    qsort(points, count, sizeof *points, order);
    fprintf(out, "$%s%zu << END\n", name, number);
    for (size_t i = 0; i < count; ++i)
        fprintf(out, "%.9g %.9g %.9g\n", points[i].time, points[i].error, points[i].along);
    fputs("END\n", out);
}

/* The rows of the line that `leader` leads, or with row_count those on the front; `room` holds a point a row. */
static size_t collect(const drawing *d, size_t leader, point *room)
{
    const cli_study *s = d->study;
    size_t count = 0;
    for (size_t r = 0; r < s->row_count; ++r) {
        const study_row *row = &s->rows[r];
        bool meant = leader < s->row_count ? d->leader[r] == leader : row->on_front;
        if (meant && has_error(s, row))
            room[count++] = (point){row->record.cpu, study_front_error(s, row), study_order_along(s, row)};
    }
    return count;
}

static void put_data(const drawing *d, FILE *out, point *room)
{
    size_t number = 0, count = d->study->row_count;
    for (size_t r = 0; r < count; ++r)
        if (leads(d, r))
            put_block(out, "rows", number++, room, collect(d, r, room), by_along);
    put_block(out, "front", 0, room, collect(d, count, room), by_time);
}

/* What an axis shows of a row. */
typedef enum axis { AXIS_TIME, AXIS_ALONG, AXIS_ERROR } axis;

static double on_axis(const cli_study *s, const study_row *row, axis what)
{
    return what == AXIS_TIME    ? row->record.cpu
           : what == AXIS_ALONG ? study_order_along(s, row)
                                : study_front_error(s, row);
}

/* How many decades the rows take up; *middle is somewhere among them. */
static double decades(const cli_study *s, axis what, double *middle)
{
    double least = INFINITY, most = 0;
    for (size_t r = 0; r < s->row_count; ++r) {
        if (!has_error(s, &s->rows[r]))
            continue;
        if (!(on_axis(s, &s->rows[r], what) > 0))
            continue;
        least = fmin(least, on_axis(s, &s->rows[r], what));
        most = fmax(most, on_axis(s, &s->rows[r], what));
    }
    if (what == AXIS_ERROR) {
        least = fmin(least, s->target);
        most = fmax(most, s->target);
    }
    *middle = least;
    return log10(most / least);
}

/* By itself a range below a decade has one number or none: the narrower it is, the more there are in a decade. */
static void put_tics(const cli_study *s, FILE *out, axis what)
{
    static const struct {
        double most; /* decades */
        const char *steps;
    } grades[] = {{1, "1 1.5 2 3 4 5 7"}, {4, "1 2 5"}, {INFINITY, "1"}};
    size_t grade = 0;
    double middle, span = decades(s, what, &middle);
    while (grade < 2 && span >= grades[grade].most)
        ++grade;
    if (span == 0) /* gnuplot finds no range for one number */
        fprintf(out, "set %crange [%.9g:%.9g]; ", what == AXIS_ERROR ? 'y' : 'x', middle / 2, 2 * middle);
    else
        fprintf(out, "set autoscale %cfix; ", what == AXIS_ERROR ? 'y' : 'x');
    const char *before = "(";
    fprintf(out, "set %ctics ", what == AXIS_ERROR ? 'y' : 'x');
    for (int decade = -15; decade <= 9; ++decade) {
        for (const char *step = grades[grade].steps; *step != '\0'; before = ", ") {
            size_t length = strcspn(step, " ");
            fprintf(out, "%s%.*se%d", before, (int)length, step, decade);
            step += length + (step[length] == ' ');
        }
    }
    fputs(")\n", out);
}

static void put_head(const cli_study *s, FILE *out)
{
    fputs("# gnuplot plots.gp\n"
          "if (!exists('before')) before = ''\n"
          "if (!exists('after')) after = ''\n"
          "set encoding utf8\nset logscale xy\nset autoscale fix\nset format '%g'\nset grid lt 1 lw 1 lc rgb "
          "'#dddddd'\nset border 3\n"
          "set tics nomirror\nset key tmargin left vertical Left reverse noenhanced maxcols 1\nset offsets graph 0.05, "
          "graph 0.05, graph 0.05, graph 0.05\n",
          out);
    put_tics(s, out, AXIS_ERROR);
    char name[LABEL_SIZE];
    snprintf(name, sizeof name, "%s", s->study->measures[s->judge].name);
    clean(name);
    fprintf(out, "set ylabel 'error: %s' noenhanced\n", name);
}

static void put_plot(const drawing *d, FILE *out, bool time)
{
    const cli_study *s = d->study;
    char label[LABEL_SIZE];
    size_t number = 0, colour = 0;
    fputs("    plot ", out);
    for (size_t r = 0; r < s->row_count; ++r) {
        const study_row *row = &s->rows[r];
        if (!leads(d, r))
            continue;
        size_t count;
        double order = study_order_fit(s, row, &count);
        bool named = is_named(d, r);
        fprintf(out, "$rows%zu using %d:2 with linespoints ", number++, time ? 1 : 3);
        write_label(s, &row->run, label);
        if (!named)
            fprintf(out, "pt 7 ps 0.5 lw 0.5 lc rgb '#bbbbbb' notitle");
        else if (!time && !isnan(order))
            fprintf(out, "pt 7 lw 2 lc %zu title '%s: order %.2f'", ++colour, label, order);
        else
            fprintf(out, "pt 7 lw 2 lc %zu title '%s'", ++colour, label);
        fputs(", \\\n         ", out);
    }
    if (time)
        fprintf(out, "$front0 using 1:2 with steps lw 2 lc rgb '#222222' title 'front', \\\n         ");
    fprintf(out, "%.9g with lines dt 2 lc rgb '#888888' title '%.3g%s wanted'\n", s->target,
            s->percent ? 100 * s->target : s->target, s->percent ? " %" : "");
}

static void put_picture(const drawing *d, FILE *out, bool time, const char *label)
{
    fputs("    ", out);
    put_tics(d->study, out, time ? AXIS_TIME : AXIS_ALONG);
    fprintf(out, "    set output before.'%s.'.kind.after\n    set xlabel '%s' noenhanced\n", names[time ? 0 : 1],
            label);
    put_plot(d, out, time);
}

static void put_script(const drawing *d, FILE *out, point *room)
{
    const cli_study *s = d->study;
    put_head(s, out);
    put_data(d, out, room);
    fputs(
        "do for [kind in 'svg png'] {\n"
        "    if (kind eq 'svg') { set terminal svg size 600,480 dynamic enhanced font 'sans-serif,13' background "
        "'white' }\n"
        "    if (kind eq 'png') { set terminal pngcairo size 1140,840 enhanced font 'sans-serif,13' fontscale 1.1 }\n",
        out);
    char along[LABEL_SIZE];
    bool spacing = strcmp(s->study->along, "spacing") == 0;
    snprintf(along, sizeof along, "%s", spacing ? "spacing [m]" : s->study->along);
    clean(along);
    put_picture(d, out, true, "CPU time of stepping [s]");
    if (picture_count(s) > 1)
        put_picture(d, out, false, along);
    fputs("    unset output\n}\n", out);
}

/* ---- gnuplot ----------------------------------------------------------------------------------------------------- */

/* Runs the script in the folder; its pictures get names that say they are not whole yet. */
static bool run_gnuplot(const cli_study *s)
{
    char names_are[64];
    snprintf(names_are, sizeof names_are, "before='.'; after='.tmp.%ld'", (long)getpid());
    fflush(NULL);
    pid_t pid = fork();
    if (pid == 0) {
        const char *arguments[] = {"gnuplot", "-d", "-e", names_are, "plots.gp", NULL};
        setenv("LC_ALL", "C.UTF-8", 1); /* elsewhere it warns of its own encoding */
        if (chdir(s->folder.path) == 0)
            execvp(arguments[0], (char *const *)(uintptr_t)arguments);
        _exit(127);
    }
    int status = 0;
    if (pid < 0 || waitpid(pid, &status, 0) != pid)
        return false;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
        message_note("gnuplot is not installed: no plots; 'gnuplot plots.gp' in '%s' draws them", s->folder.path);
    else if (status != 0)
        message_warning(SPH2D_CODE_GENERAL, "gnuplot failed on '%s/plots.gp'", s->folder.path);
    return status == 0;
}

static bool keep_picture(cli_study *s, const char *name, const char *kind)
{
    const char *path = folder_file(&s->folder, ".%s.%s.tmp.%ld", name, kind, (long)getpid());
    char *unfinished = path != NULL ? strdup(path) : NULL;
    path = folder_file(&s->folder, "%s.%s", name, kind);
    bool kept = unfinished != NULL && path != NULL && rename(unfinished, path) == 0;
    free(unfinished);
    return kept;
}

static int draw(cli_study *s)
{
    bool kept = true;
    if (!run_gnuplot(s))
        return CLI_EXIT_SUCCESS;
    for (int i = 0; i < picture_count(s); ++i)
        for (int k = 0; k < 2; ++k)
            kept = keep_picture(s, names[i], kinds[k]) && kept;
    if (!kept)
        message_error(SPH2D_CODE_FILE_WRITE, NULL, "gnuplot did not write all pictures to '%s'", s->folder.path);
    return kept ? CLI_EXIT_SUCCESS : CLI_EXIT_IO;
}

static sph2d_status write_script(cli_study *s)
{
    study_text script;
    point *room = malloc((s->row_count + 1) * sizeof *room);
    drawing d = {s, calloc(s->row_count + 1, sizeof *d.leader), calloc(s->row_count + 1, sizeof *d.on_front), 0};
    sph2d_status status = SPH2D_NOMEM;
    if (room != NULL && d.leader != NULL && d.on_front != NULL && study_text_begin(&script)) {
        find_lines(&d);
        put_script(&d, script.out, room);
        status = study_text_write(&script, folder_file(&s->folder, "plots.gp"), &s->report);
    }
    free(room);
    free(d.leader);
    free(d.on_front);
    return status;
}

int study_plot(cli_study *s)
{
    if (s->options->output == NULL || s->rows == NULL || picture_count(s) == 0)
        return CLI_EXIT_SUCCESS;
    int code = study_report(s, write_script(s), NULL, NULL);
    return code == CLI_EXIT_SUCCESS ? draw(s) : code;
}
