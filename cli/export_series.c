/* SPDX-License-Identifier: MIT */
/** @file export_series.c
 *  Snapshots as a series for ParaView: NAME.pvd, which has their times, and beside it NAME_000000.vtp and so on. The former
 *  is written last, so that it names whole files only. */
#include <stdlib.h>
#include <string.h>

#include "exit.h"
#include "export.h"
#include "input.h"
#include "text.h"

typedef struct series {
    const cli_options *options;
    snapshot_list inputs;
    double *times; /* of the inputs */
    char *stem;    /* of the names of files: DIR/NAME */
    char *path;    /* of the file at work */
    size_t path_size;
    size_t done;
} series;

/* The files are named as seen from the folder of the collection. */
static void put_collection(const void *what, FILE *out)
{
    const series *s = what;
    const char *slash = strrchr(s->stem, '/'), *name = slash ? slash + 1 : s->stem;
    fprintf(out, "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n");
    for (size_t i = 0; i < s->inputs.count; ++i) {
        fprintf(out, "<DataSet timestep=\"%.17g\" part=\"0\" file=\"", s->times[i]);
        export_xml_text(name, out);
        fprintf(out, "_%06zu.vtp\"/>\n", i);
    }
    fprintf(out, "</Collection>\n</VTKFile>\n");
}

static sph2d_status write_collection(const series *s, sph2d_report *report)
{
    size_t length = 0;
    char *text = compose(put_collection, s, &length);
    const sph2d_status status = text ? sph2d_text_write(s->options->output, text, length, report) : SPH2D_NOMEM;
    free(text);
    return status;
}

static sph2d_status write_next(series *s, sph2d_report *report)
{
    sph2d_snapshot *snapshot = NULL;
    size_t points;
    sph2d_status status = snapshot_read(s->options, s->inputs.paths[s->done], &snapshot, report);
    if (status == SPH2D_OK) {
        s->times[s->done] = sph2d_snapshot_get_info(snapshot).time;
        snprintf(s->path, s->path_size, "%s_%06zu.vtp", s->stem, s->done);
        status = export_vtp(snapshot, s->path, &points, report);
    }
    sph2d_snapshot_destroy(snapshot);
    return status;
}

/* False when memory is short. */
static bool prepare(series *s)
{
    const char *path = s->options->output;
    const size_t length = strlen(path) - strlen(".pvd");
    s->path_size = length + 32;
    s->times = calloc(s->inputs.count + 1, sizeof *s->times);
    s->stem = strndup(path, length);
    s->path = malloc(s->path_size);
    return s->times && s->stem && s->path;
}

static int write_all(series *s)
{
    sph2d_report report = {0};
    sph2d_status status = prepare(s) ? SPH2D_OK : SPH2D_NOMEM;
    for (; status == SPH2D_OK && s->done < s->inputs.count && signals_caught() == 0; ++s->done)
        status = write_next(s, &report);
    const int stopped = status == SPH2D_OK ? signals_caught() : 0;
    if (status == SPH2D_OK && !stopped)
        status = write_collection(s, &report);
    message_report(status, &report, NULL);
    if (stopped)
        message_note("stopped by %s after %zu of %zu files, without '%s'", signals_name(stopped), s->done,
                     s->inputs.count, s->options->output);
    else if (status == SPH2D_OK)
        message_note("wrote %zu snapshot%s to '%s_*.vtp', and their times to '%s'", s->done, s->done == 1 ? "" : "s",
                     s->stem, s->options->output);
    return stopped ? 128 + stopped : exit_of_status(status);
}

int export_series(const cli_options *options)
{
    series s = {.options = options};
    signals_install();
    signals_note();
    int code = snapshot_list_make(&s.inputs, options);
    if (code == CLI_EXIT_SUCCESS)
        code = write_all(&s);
    snapshot_list_free(&s.inputs);
    free(s.times);
    free(s.stem);
    free(s.path);
    return code;
}
