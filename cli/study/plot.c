/* SPDX-License-Identifier: MIT */
/** @file plot.c
 *  The numbers of the plots, the script plots.gp that draws them, and gnuplot to run it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "../exit.h"
#include "../message.h"
#include "parts.h"

/* With more settings than this only those that reach the front have a colour and a name. */
enum { MOST_NAMED = 8, LABEL_SIZE = 120 };

static const char *const names[] = {"error_time", "error_along"};

/* What the plots show of a row. */
typedef struct point {
    const sph2d_study_row *row;
    const sph2d_study_row *leader; /* the first of those that it belongs to: they are one line */
    double time, error, along;
    bool named; /* its line has a colour and a name */
} point;

typedef struct drawing {
    const cli_study *study;
    point *points; /* those of lines with a name first, line by line */
    size_t count, lines, named;
    int pictures;
    char unfinished[48]; /* what the names of pictures end in before they are whole */
} drawing;

/* ---- lines ------------------------------------------------------------------------------------------------------- */

/* Finds out which line a point is part of. A picture needs two points; against the `along` key, two of one line. */
static void join_line(drawing *d, point *p)
{
    p->leader = p->row;
    for (const point *q = d->points; q < p && p->leader == p->row; ++q)
        if (q->leader == q->row && sph2d_study_rows_belong(d->study->results, q->row, p->row)) {
            p->leader = q->row;
            d->pictures = q->along != p->along ? 2 : d->pictures;
        }
    d->lines += p->leader == p->row;
    d->pictures = p > d->points && d->pictures == 0 ? 1 : d->pictures;
}

static int by_line(const void *a, const void *b)
{
    const point *p = a, *q = b;
    if (p->named != q->named)
        return p->named ? -1 : 1;
    if (p->leader != q->leader)
        return p->leader < q->leader ? -1 : 1;
    return p->along < q->along ? 1 : p->along > q->along ? -1 : 0;
}

static int by_time(const void *a, const void *b)
{
    const point *p = a, *q = b;
    return p->time > q->time ? 1 : p->time < q->time ? -1 : 0;
}

/* False when memory is short. */
static bool find_points(drawing *d)
{
    const cli_study *s = d->study;
    d->points = calloc(s->results->row_count, sizeof *d->points);
    if (!d->points)
        return false;
    STUDY_FOR_ROWS (s, row) {
        point *p = &d->points[d->count];
        *p = (point){
            row,  row, row->record.cpu, sph2d_study_row_error(s->results, row), sph2d_study_row_along(s->results, row),
            false};
        if (!(p->error > 0))
            continue;
        join_line(d, p);
        ++d->count;
    }
    for (point *p = d->points; p < d->points + d->count; ++p) {
        for (const point *q = d->points; q < d->points + d->count && !p->named; ++q)
            p->named = d->lines <= MOST_NAMED || (q->leader == p->leader && q->row->on_front);
        d->named += p->named && p->leader == p->row;
    }
    return true;
}

/* ---- the numbers ------------------------------------------------------------------------------------------------- */

static void put_point(FILE *out, const point *p)
{
    fprintf(out, "%.9g\t%.9g\t%.9g\n", p->time, p->error, p->along);
}

static void put_front(const drawing *d, FILE *out)
{
    fputs("\"front\"\t\"\"\t\"\"\n", out);
    for (size_t i = 0; i < d->count; ++i)
        if (d->points[i].row->on_front)
            put_point(out, &d->points[i]);
}

/* The titles of a line in the two pictures, above the columns of times and of keys; "" is none. */
static void put_titles(const cli_study *s, const point *p, FILE *out)
{
    char label[LABEL_SIZE] = "", order_is[32] = "";
    sph2d_study_run run = p->row->run;
    if (s->study->vary_count == 0) /* a name that was given says what the row differs in from its line */
        run.given = NULL;
    if (p->named)
        sph2d_study_run_name(&run, s->study->along, label, sizeof label);
    study_clean(label, "\"\t", '\'');
    double order = p->named ? sph2d_study_row_order(s->results, p->row) : NAN;
    if (!isnan(order))
        snprintf(order_is, sizeof order_is, ": order %.2f", order);
    fprintf(out, "\n\n\"%s\"\t\"\"\t\"%s%s\"\n", label, label, order_is);
}

static void put_data(const void *drawing_, FILE *out)
{
    const drawing *d = drawing_;
    qsort(d->points, d->count, sizeof *d->points, by_time);
    put_front(d, out);
    qsort(d->points, d->count, sizeof *d->points, by_line);
    for (size_t i = 0; i < d->count; ++i) {
        if (i == 0 || d->points[i].leader != d->points[i - 1].leader)
            put_titles(d->study, &d->points[i], out);
        put_point(out, &d->points[i]);
    }
}

/* ---- the script -------------------------------------------------------------------------------------------------- */

/* Quotes would end gnuplot's text. */
static void put_quoted(FILE *out, const char *text)
{
    char label[LABEL_SIZE];
    snprintf(label, sizeof label, "%s", text);
    study_clean(label, "'\\`", ' ');
    fputs(label, out);
}

static void put_settings(const void *drawing_, FILE *out)
{
    const drawing *d = drawing_;
    const cli_study *s = d->study;
    fputs("judge = '", out);
    put_quoted(out, s->study->measures[s->results->judge].name);
    fputs("'\nalong = '", out);
    put_quoted(out, strcmp(s->study->along, "spacing") == 0 ? "spacing [m]" : s->study->along);
    fprintf(out, s->percent ? "'\nwanted = '%.3g %% wanted'\n" : "'\nwanted = '%.3g wanted'\n",
            s->percent ? 100 * s->target : s->target);
    fprintf(out, "target = %.9g\nnamed = %zu\nlines = %zu\npictures = %d", s->target, d->named, d->lines, d->pictures);
}

static void put_script(const void *d, FILE *out)
{
    static const study_slot slots[] = {{"settings", put_settings}};
    study_fill(out, study_plots_gp, slots, d);
}

/* ---- gnuplot ----------------------------------------------------------------------------------------------------- */

/* Pictures get names that say they are not whole yet, and that no other process has, on any machine. */
static void name_unfinished(drawing *d)
{
    struct timespec now = {0};
    clock_gettime(CLOCK_REALTIME, &now);
    snprintf(d->unfinished, sizeof d->unfinished, ".tmp.%ld%09ld", (long)getpid(), now.tv_nsec);
}

/* Runs the script in the folder. */
static bool run_gnuplot(const cli_study *s, const char *unfinished)
{
    char names_are[80];
    snprintf(names_are, sizeof names_are, "before='.'; after='%s'", unfinished);
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

static bool keep_picture(cli_study *s, const char *after, const char *name, const char *kind)
{
    const char *path = folder_file(&s->folder, ".%s.%s%s", name, kind, after);
    char *unfinished = path ? strdup(path) : NULL;
    path = folder_file(&s->folder, "%s.%s", name, kind);
    bool kept = unfinished && path && rename(unfinished, path) == 0;
    free(unfinished);
    return kept;
}

static int draw(cli_study *s, drawing *d)
{
    bool kept = true;
    name_unfinished(d);
    if (!run_gnuplot(s, d->unfinished))
        return CLI_EXIT_SUCCESS;
    s->pictures = d->pictures;
    for (int i = 0; i < d->pictures && i < 2; ++i)
        kept =
            keep_picture(s, d->unfinished, names[i], "svg") && keep_picture(s, d->unfinished, names[i], "png") && kept;
    if (!kept)
        message_error(SPH2D_CODE_FILE_WRITE, NULL, "gnuplot did not write all pictures to '%s'", s->folder.path);
    return kept ? CLI_EXIT_SUCCESS : CLI_EXIT_IO;
}

int study_plot(cli_study *s)
{
    drawing d = {.study = s};
    int code = find_points(&d) ? CLI_EXIT_SUCCESS : study_report(s, SPH2D_NOMEM);
    s->plotted = d.pictures > 0;
    s->pictures = 0;
    if (code == CLI_EXIT_SUCCESS && s->plotted) {
        code = study_first(study_write(s, "plots.dat", put_data, &d), study_write(s, "plots.gp", put_script, &d));
        code = code == CLI_EXIT_SUCCESS ? draw(s, &d) : code;
    }
    free(d.points);
    return code;
}
