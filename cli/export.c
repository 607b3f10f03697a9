/* SPDX-License-Identifier: MIT */
/** @file export.c
 *  `sph2d export SNAPSHOT`: the liquid of a snapshot as CSV; with -o FILE.vtp the snapshot for VTK, with -o FILE.pvd many
 *  of them and their times, which ParaView shows one after the other. */
#include "export.h"

#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "exit.h"
#include "input.h"

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
