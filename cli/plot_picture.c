/* SPDX-License-Identifier: MIT */
/** @file plot_picture.c
 *  A script with its data, and gnuplot, which reads it and prints the picture. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "exit.h"
#include "message.h"
#include "plot.h"
#include "text.h"

enum { MOST_ACROSS = 3, PANEL_WIDTH = 460, PANEL_HEIGHT = 260 };
/* Of a longer series the smallest and the largest of that many pieces are drawn, which looks the same. */
enum { PIECES = 1000 };

/* ---- numbers ----------------------------------------------------------------------------------------------------- */

static void put_row(FILE *out, const plot_series *s, size_t column, size_t row)
{
    double time = sph2d_table_value(s->table, row, 0), value = sph2d_table_value(s->table, row, column + 1);
    if (isfinite(value))
        fprintf(out, "%.9g %.9g\n", time, value);
    else
        fprintf(out, "%.9g NaN\n", time); /* the line has a gap */
}

/* Smallest and largest of some rows, in their order; one of them if there is no number. */
static void put_extremes(FILE *out, const plot_series *s, size_t column, size_t first, size_t end)
{
    size_t low = first, high = first;
    for (size_t row = first + 1; row < end; ++row) {
        double value = sph2d_table_value(s->table, row, column + 1);
        double least = sph2d_table_value(s->table, low, column + 1);
        double most = sph2d_table_value(s->table, high, column + 1);
        if (isfinite(value) && !(value >= least))
            low = row;
        if (isfinite(value) && !(value <= most))
            high = row;
    }
    put_row(out, s, column, low < high ? low : high);
    if (low != high)
        put_row(out, s, column, low < high ? high : low);
}

static void put_column(FILE *out, const plot_series *s, size_t column)
{
    size_t rows = sph2d_table_rows(s->table), pieces = rows > 4 * PIECES ? PIECES : rows;
    for (size_t i = 0; i < pieces; ++i)
        put_extremes(out, s, column, rows * i / pieces, rows * (i + 1) / pieces);
}

/* ---- the script -------------------------------------------------------------------------------------------------- */

/* In gnuplot's text a quote is written twice. */
static void put_text(FILE *out, const char *text)
{
    fputc('\'', out);
    for (; *text != '\0'; ++text) {
        if (*text == '\'')
            fputc('\'', out);
        fputc((unsigned char)*text < 0x20 ? ' ' : *text, out);
    }
    fputc('\'', out);
}

/* With one column the axis has its name, else the unit, and a key the names. */
static void put_panel(FILE *out, const plot_series *s, int panel)
{
    size_t columns = 0, first = 0;
    for (size_t i = s->column_count; i-- > 0;)
        if (s->columns[i].panel == panel) {
            ++columns;
            first = i;
            fprintf(out, "$D%zu << EOD\n", i);
            put_column(out, s, i);
            fputs("EOD\n", out);
        }
    fputs("set label 1 ", out);
    put_text(out, s->name);
    fputs(" at graph 0, 1.12 left noenhanced\nset ylabel ", out);
    put_text(out, columns > 1 ? s->columns[first].unit : s->columns[first].label);
    fputs(" noenhanced\nplot ", out);
    for (size_t i = first, k = 1; i < s->column_count; ++i)
        if (s->columns[i].panel == panel) {
            fprintf(out, "%s$D%zu using 1:2 with lines lw 1.5 lc %zu ", k > 1 ? ", " : "", i, k);
            if (columns > 1) {
                fputs("title ", out);
                put_text(out, s->columns[i].name);
            } else {
                fputs("notitle", out);
            }
            ++k;
        }
    fputc('\n', out);
}

typedef struct script {
    const plot_data *data;
    bool png;
} script;

static void put_script(const void *what, FILE *out)
{
    const script *p = what;
    size_t across = p->data->panels < MOST_ACROSS ? p->data->panels : MOST_ACROSS;
    size_t down = (p->data->panels + across - 1) / across;
    size_t width = across * PANEL_WIDTH, height = down * PANEL_HEIGHT;
    fputs("set encoding utf8\n", out);
    if (p->png)
        fprintf(out, "set terminal pngcairo size %zu,%zu font 'sans-serif,12' background 'white'\n", width, height);
    else
        fprintf(out, "set terminal svg size %zu,%zu dynamic font 'sans-serif,12' background 'white'\n", width, height);
    fputs("set format '%g'\nset grid lt 1 lw 1 lc rgb '#dddddd'\nset border 3\nset tics nomirror\n"
          "set tics font ',10'\nset key tmargin right horizontal noenhanced samplen 1\nset tmargin 3.5\nset autoscale "
          "xfix\nset offsets 0, 0, graph 0.05, graph 0.05\n"
          "set xlabel 'time [s]'\nset lmargin 11\nset rmargin 2\n",
          out);
    fprintf(out, "set multiplot layout %zu,%zu\n", down, across);
    for (size_t i = 0; i < p->data->count; ++i)
        for (int k = 0; k < p->data->series[i].panels; ++k)
            put_panel(out, &p->data->series[i], k);
    fputs("unset multiplot\n", out);
}

/* ---- gnuplot ----------------------------------------------------------------------------------------------------- */

/* What gnuplot reads, prints, and complains of: files without a name. */
typedef struct streams {
    FILE *in, *out, *err;
} streams;

static void close_streams(streams *s)
{
    FILE *all[] = {s->in, s->out, s->err};
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i)
        if (all[i])
            fclose(all[i]);
}

static bool open_streams(streams *s, const char *text, size_t length)
{
    *s = (streams){tmpfile(), tmpfile(), tmpfile()};
    return s->in && s->out && s->err && fwrite(text, 1, length, s->in) == length && fflush(s->in) == 0 &&
           lseek(fileno(s->in), 0, SEEK_SET) == 0;
}

/* Runs gnuplot; its status as of waitpid(), or -1. */
static int run_gnuplot(const streams *s)
{
    fflush(NULL);
    pid_t pid = fork();
    if (pid == 0) {
        char *arguments[] = {(char[]){"gnuplot"}, (char[]){"-d"}, (char[]){"-"}, NULL};
        setenv("LC_ALL", "C.UTF-8", 1); /* elsewhere it warns of its own encoding */
        if (dup2(fileno(s->in), 0) == 0 && dup2(fileno(s->out), 1) == 1 && dup2(fileno(s->err), 2) == 2)
            execvp(arguments[0], arguments);
        _exit(127);
    }
    int status = -1;
    while (pid > 0 && waitpid(pid, &status, 0) < 0 && errno == EINTR)
        status = -1;
    return status;
}

/* All that a stream has, to be freed; NULL when memory is short or it cannot be read. */
static char *read_all(FILE *stream, size_t *length)
{
    off_t end = fseeko(stream, 0, SEEK_END) == 0 ? ftello(stream) : -1;
    char *bytes = end >= 0 ? malloc((size_t)end + 1) : NULL;
    rewind(stream);
    *length = end >= 0 ? (size_t)end : 0;
    if (!bytes || fread(bytes, 1, *length, stream) != *length) {
        free(bytes);
        return NULL;
    }
    bytes[*length] = '\0';
    return bytes;
}

/* The line of a complaint that says why. */
static int complain(FILE *err)
{
    char line[200] = "", text[200] = "";
    rewind(err);
    while (fgets(line, sizeof line, err))
        if (line[strspn(line, " \t\n^")] != '\0')
            snprintf(text, sizeof text, "%s", line + strspn(line, " \t"));
    text[strcspn(text, "\n")] = '\0';
    message_error(SPH2D_CODE_GENERAL, NULL, "gnuplot failed: %s", text[0] != '\0' ? text : "it said nothing");
    return CLI_EXIT_SOFTWARE;
}

/* gnuplot does not say so when it cannot print all of a picture: it must have its end. */
static bool is_whole(const char *bytes, size_t length, bool png)
{
    static const char end_of_svg[] = "</svg>", end_of_png[] = "IEND\xae\x42\x60\x82";
    const char *end = png ? end_of_png : end_of_svg;
    size_t tail = strlen(end);
    while (!png && length > 0 && strchr(" \r\n", bytes[length - 1]))
        --length;
    return length > tail && memcmp(bytes + length - tail, end, tail) == 0;
}

static int keep(FILE *picture, bool png, const char *path)
{
    size_t length = 0;
    char *bytes = read_all(picture, &length);
    if (bytes && !is_whole(bytes, length, png)) {
        free(bytes);
        message_error(SPH2D_CODE_FILE_WRITE, "is the disk of temporary files full?",
                      "gnuplot did not print all of the picture");
        return CLI_EXIT_IO;
    }
    sph2d_report report = {0};
    sph2d_status status = bytes ? sph2d_text_write(path, bytes, length, &report) : SPH2D_NOMEM;
    free(bytes);
    message_report(status, &report, NULL);
    return status == SPH2D_OK ? CLI_EXIT_SUCCESS : exit_of_status(status);
}

int plot_draw(const plot_data *data, bool png, const char *path)
{
    size_t length = 0;
    char *text = compose(put_script, &(script){data, png}, &length);
    if (!text) {
        message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
        return CLI_EXIT_SOFTWARE;
    }
    streams s;
    int code = CLI_EXIT_IO;
    if (!open_streams(&s, text, length)) {
        message_error(SPH2D_CODE_FILE_WRITE, NULL, "cannot make temporary files for gnuplot: %s", strerror(errno));
    } else {
        int status = run_gnuplot(&s);
        if (status != -1 && WIFEXITED(status) && WEXITSTATUS(status) == 127) {
            message_error(SPH2D_CODE_GENERAL, "install it, on Debian: apt install gnuplot-nox",
                          "gnuplot is not installed: it draws the plots");
            code = CLI_EXIT_UNAVAILABLE;
        } else {
            code = status == 0 ? keep(s.out, png, path) : complain(s.err);
        }
    }
    close_streams(&s);
    free(text);
    return code;
}
