/* SPDX-License-Identifier: MIT */
/** @file plot_series.c
 *  Reads the series of a run's probes, and finds which columns are drawn together. */
#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exit.h"
#include "message.h"
#include "plot.h"
#include "text.h"

static const char time_column[] = "time [s]", suffix[] = ".csv";

static int out_of_memory(void)
{
    message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
    return CLI_EXIT_SOFTWARE;
}

/* ---- one series -------------------------------------------------------------------------------------------------- */

/* The first line of a file without its end, to be freed. NULL, with errno (0: it has none). */
static char *read_header(const char *path)
{
    FILE *in = fopen(path, "r");
    if (!in)
        return NULL;
    char *line = NULL;
    size_t size = 0;
    errno = 0;
    if (getline(&line, &size, in) < 0) {
        free(line);
        line = NULL;
    }
    int error = errno;
    fclose(in);
    errno = error;
    if (line)
        line[strcspn(line, "\r\n")] = '\0';
    return line;
}

static bool is_series(const char *header)
{
    size_t length = strlen(time_column);
    return strncmp(header, time_column, length) == 0 && header[length] == ',';
}

/* Splits a header into the columns after the time; false when memory is short. */
static bool split(plot_series *s, char *header)
{
    size_t most = 1;
    for (const char *comma = header; (comma = strchr(comma, ',')); ++comma)
        ++most;
    s->columns = calloc(most, sizeof *s->columns);
    if (!s->columns)
        return false;
    char *rest = NULL;
    for (char *label = strtok_r(header + strlen(time_column) + 1, ",", &rest); label;
         label = strtok_r(NULL, ",", &rest)) {
        plot_column *c = &s->columns[s->column_count++];
        *c = (plot_column){.label = strdup(label), .name = strdup(label)};
        if (!c->label || !c->name)
            return false;
        char *unit = strstr(c->label, " [");
        c->unit = unit ? unit + 1 : "";
        c->name[unit ? (size_t)(unit - c->label) : strlen(c->label)] = '\0';
    }
    return true;
}

static int read_table(plot_series *s, const char *path)
{
    sph2d_table_column *wanted = calloc(s->column_count + 1, sizeof *wanted);
    if (!wanted)
        return out_of_memory();
    wanted[0].name = "time";
    for (size_t i = 0; i < s->column_count; ++i)
        wanted[i + 1].name = s->columns[i].name;
    sph2d_report report = {0};
    sph2d_status status = sph2d_table_read(path, wanted, s->column_count + 1, &s->table, &report);
    free(wanted);
    message_report(status, &report, NULL);
    return status == SPH2D_OK ? CLI_EXIT_SUCCESS : exit_of_status(status);
}

static bool has_number(const plot_series *s, size_t column)
{
    for (size_t row = 0; row < sph2d_table_rows(s->table); ++row)
        if (isfinite(sph2d_table_value(s->table, row, 0)) && isfinite(sph2d_table_value(s->table, row, column + 1)))
            return true;
    return false;
}

/* A column joins the first of its unit; those without a unit are of different kinds. */
static void find_panels(plot_series *s)
{
    for (size_t i = 0; i < s->column_count; ++i) {
        plot_column *c = &s->columns[i];
        c->panel = -1;
        if (!has_number(s, i)) {
            message_note("%s: '%s' has no value yet", s->name, c->label);
            continue;
        }
        for (size_t k = 0; k < i && c->unit[0] != '\0' && c->panel < 0; ++k)
            if (strcmp(s->columns[k].unit, c->unit) == 0)
                c->panel = s->columns[k].panel;
        if (c->panel < 0)
            c->panel = s->panels++;
    }
}

/* Reads a file, if it is a series. One that was `named` must be. */
static int read_series(plot_data *data, cli_folder *folder, const char *name, bool named)
{
    const char *path = folder_file(folder, "%s%s", name, suffix);
    char *header = path ? read_header(path) : NULL;
    if (!path || (!header && errno == ENOMEM))
        return out_of_memory();
    if (!header || !is_series(header)) {
        int error = header ? 0 : errno;
        free(header);
        if (!named && error == 0)
            return CLI_EXIT_SUCCESS;
        message_error(error ? SPH2D_CODE_FILE_OPEN : SPH2D_CODE_FILE_FIELD, NULL, "cannot read '%s': %s", path,
                      error ? strerror(error) : "it is no series, whose first column is time [s]");
        return error ? CLI_EXIT_NOINPUT : CLI_EXIT_DATA;
    }
    plot_series *s = &data->series[data->count++];
    *s = (plot_series){.name = strdup(name)};
    bool ok = split(s, header) && s->name;
    free(header);
    if (!ok)
        return out_of_memory();
    int code = read_table(s, path);
    if (code == CLI_EXIT_SUCCESS) {
        find_panels(s);
        data->panels += (size_t)s->panels;
    }
    return code;
}

/* ---- the folder -------------------------------------------------------------------------------------------------- */

typedef struct name_list {
    char **names;
    size_t count;
} name_list;

static void free_names(name_list *l)
{
    for (size_t i = 0; i < l->count; ++i)
        free(l->names[i]);
    free(l->names);
}

static int by_text(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* Lists NAME of all files NAME.csv, sorted. Returns an exit code. */
static int list_names(name_list *l, const char *path)
{
    DIR *listing = opendir(path);
    if (!listing) {
        message_error(SPH2D_CODE_FILE_OPEN, NULL, "cannot read the folder '%s': %s", path, strerror(errno));
        return CLI_EXIT_NOINPUT;
    }
    bool ok = true;
    const struct dirent *entry;
    while (ok && (entry = readdir(listing))) {
        size_t length = strlen(entry->d_name), tail = strlen(suffix);
        if (entry->d_name[0] == '.' || length <= tail || strcmp(entry->d_name + length - tail, suffix) != 0)
            continue;
        char **grown = realloc(l->names, (l->count + 1) * sizeof *grown);
        if ((ok = grown != NULL)) {
            l->names = grown;
            grown[l->count] = strndup(entry->d_name, length - tail);
            ok = grown[l->count] != NULL;
            l->count += ok;
        }
    }
    closedir(listing);
    if (!ok)
        return out_of_memory();
    if (l->count > 0)
        qsort(l->names, l->count, sizeof *l->names, by_text);
    return CLI_EXIT_SUCCESS;
}

/* Whether the folder has every probe that was named; otherwise prints an error. */
static bool has_all(const name_list *l, const char *path, char *const *wanted, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        if (l->count > 0 && bsearch(&wanted[i], l->names, l->count, sizeof *l->names, by_text))
            continue;
        const char *nearest = text_nearest(wanted[i], (const char *const *)l->names, l->count);
        message_error(SPH2D_CODE_FILE_OPEN, NULL, "'%s' has no series '%s%s'%s%s%s", path, wanted[i], suffix,
                      nearest ? "; did you mean '" : "", nearest ? nearest : "", nearest ? "'?" : "");
        return false;
    }
    return true;
}

static int refuse(const plot_data *data, const char *path)
{
    if (data->count == 0)
        message_error(SPH2D_CODE_FILE_OPEN,
                      "a run writes one for each probe of its scene, such as {name: energy, kind: energy, every: 0.01}",
                      "'%s' has no series of probes", path);
    else
        message_error(SPH2D_CODE_FILE_FIELD, NULL, "the series in '%s' have no values yet", path);
    return data->count == 0 ? CLI_EXIT_NOINPUT : CLI_EXIT_DATA;
}

int plot_read(plot_data *data, cli_folder *folder, char *const *names, size_t name_count)
{
    name_list all = {0};
    int code = list_names(&all, folder->path);
    if (code == CLI_EXIT_SUCCESS && !has_all(&all, folder->path, names, name_count))
        code = CLI_EXIT_NOINPUT;
    char *const *chosen = name_count > 0 ? names : all.names;
    size_t count = name_count > 0 ? name_count : all.count;
    data->series = calloc(count + 1, sizeof *data->series);
    if (code == CLI_EXIT_SUCCESS && !data->series)
        code = out_of_memory();
    for (size_t i = 0; i < count && code == CLI_EXIT_SUCCESS; ++i)
        code = read_series(data, folder, chosen[i], name_count > 0);
    free_names(&all);
    return code == CLI_EXIT_SUCCESS && data->panels == 0 ? refuse(data, folder->path) : code;
}

void plot_free(plot_data *data)
{
    for (size_t i = 0; i < data->count; ++i) {
        plot_series *s = &data->series[i];
        for (size_t k = 0; k < s->column_count; ++k) {
            free(s->columns[k].label);
            free(s->columns[k].name);
        }
        free(s->columns);
        free(s->name);
        sph2d_table_destroy(s->table);
    }
    free(data->series);
}
