/* SPDX-License-Identifier: MIT */
/** @file export.c
 *  `sph2d export SNAPSHOT`: the liquid of a snapshot as CSV; with -o FILE.vtp the snapshot for VTK, with -o FILE.pvd many
 *  of them and their times, which ParaView shows one after the other. */
#include "export.h"

#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "exit.h"
#include "snapshot.h"

/* ---- what the forms share ---------------------------------------------------------------------------------------- */

typedef struct row_of {
    uint64_t id;
    size_t index;
} row_of;

static int by_id(const void *a, const void *b)
{
    const row_of *p = a, *q = b;
    if (p->id != q->id)
        return p->id < q->id ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

size_t *export_order(const sph2d_snapshot *snapshot, sph2d_group group, size_t *count)
{
    /* Corners have no numbers of their own and keep their order. */
    const bool particles = group != SPH2D_GROUP_OUTLINE;
    const sph2d_array *ids = sph2d_snapshot_array(snapshot, group, particles ? "ParticleIDs" : "OutlineIDs");
    *count = ids ? ids->count : 0;
    row_of *rows = calloc(*count + 1, sizeof *rows);
    size_t *order = calloc(*count + 1, sizeof *order);
    if (rows && order) {
        for (size_t i = 0; i < *count; ++i)
            rows[i] = (row_of){particles ? ((const uint64_t *)ids->data[0])[i * ids->stride] : 0, i};
        qsort(rows, *count, sizeof *rows, by_id);
        for (size_t i = 0; i < *count; ++i)
            order[i] = rows[i].index;
    } else {
        free(order);
        order = NULL;
    }
    free(rows);
    return order;
}

void export_xml_text(const char *text, FILE *out)
{
    for (const char *c = text; *c != '\0'; ++c) {
        if (*c == '&')
            fputs("&amp;", out);
        else if (*c == '<')
            fputs("&lt;", out);
        else if (*c == '"')
            fputs("&quot;", out);
        else
            fputc(*c, out);
    }
}

static bool ends_in(const char *path, const char *end)
{
    const size_t length = strlen(path), tail = strlen(end);
    return length > tail && strcmp(path + length - tail, end) == 0;
}

/* ---- one snapshot ------------------------------------------------------------------------------------------------ */

static int export_one(const cli_options *options)
{
    const char *path = options->output;
    sph2d_report report = {0};
    sph2d_snapshot *snapshot = NULL;
    size_t count = 0;
    sph2d_status status = snapshot_read(options, options->operands[0], &snapshot, &report);
    const bool poly_data = path && ends_in(path, ".vtp");
    if (status == SPH2D_OK)
        status = poly_data ? export_vtp(snapshot, path, &count, &report) : export_csv(snapshot, path, &count, &report);
    message_report(status, &report, NULL);
    if (status == SPH2D_OK && path)
        message_note("wrote %zu %s to '%s'", count, poly_data ? "points" : "particles", path);
    sph2d_snapshot_destroy(snapshot);
    return exit_of_status(status);
}

/* ---- the command ------------------------------------------------------------------------------------------------- */

static int check_usage(const cli_options *options)
{
    const char *path = options->output;
    const bool series = path && ends_in(path, ".pvd");
    if (path && !series && !ends_in(path, ".csv") && !ends_in(path, ".vtp"))
        message_usage("export", "--output: '%s' must end in .csv, .vtp or .pvd", path);
    else if (options->operand_count == 0)
        message_usage("export", "a snapshot must be given, or, for a series, the folder of a run");
    else if (options->operand_count > 1 && !series)
        message_usage("export", "one snapshot must be given; several become a series by -o FILE.pvd");
    else
        return CLI_EXIT_SUCCESS;
    return CLI_EXIT_USAGE;
}

int command_export(const cli_options *options)
{
    const int code = check_usage(options);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    snapshot_note(options);
    return options->output && ends_in(options->output, ".pvd") ? export_series(options) : export_one(options);
}
