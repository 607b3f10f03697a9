/* SPDX-License-Identifier: MIT */
/** @file outputs.c
 *  The outputs of a run. */
#include "outputs.h"

#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const sph2d_scene *scene_of(const cli_outputs *o)
{
    return sph2d_sim_scene(o->sim);
}

bool outputs_want_frames(const sph2d_scene *scene)
{
    return sph2d_rate_interval(scene->run.frames.rate) > 0;
}

sph2d_status outputs_open(cli_outputs *o, cli_folder *folder, sph2d_sim *sim, const sph2d_scene_file *file,
                          frame_writer *writer, saved_in saved, sph2d_report *report)
{
    const sph2d_scene *scene = sph2d_sim_scene(sim);
    *o = (cli_outputs){.folder = folder,
                       .sim = sim,
                       .file = file,
                       .writer = writer,
                       .style = frame_style_of_scene(scene),
                       .old_checkpoint = true,
                       .saved_step = sph2d_sim_steps(sim),
                       .saved = saved};
    if (scene->probe_count == 0)
        return SPH2D_OK;
    o->series = calloc(scene->probe_count, sizeof *o->series);
    if (!o->series)
        return SPH2D_NOMEM;
    o->series_count = scene->probe_count;
    for (size_t i = 0; i < o->series_count; ++i) {
        const char *path = folder_file(folder, "%s.csv", scene->probes[i].name);
        if (!path)
            return SPH2D_NOMEM;
        uint64_t rows = sph2d_sim_output_count(sim, SPH2D_OUTPUT_PROBE + i);
        sph2d_status status =
            sph2d_series_open(path, sph2d_probe_columns(scene->probes[i].kind), rows, &o->series[i], report);
        if (status != SPH2D_OK)
            return status;
    }
    return SPH2D_OK;
}

/* ---- beside the steps --------------------------------------------------------------------------------------------- */

void outputs_work_beside(cli_outputs *o)
{
    if (o->writer)
        o->queue = output_queue_start(o->writer);
}

double outputs_cpu_beside(const cli_outputs *o)
{
    return o->queue ? output_queue_cpu(o->queue) : 0;
}

sph2d_status outputs_settle(cli_outputs *o, sph2d_report *report)
{
    return o->queue ? output_queue_wait(o->queue, report) : SPH2D_OK;
}

/* ---- one file ---------------------------------------------------------------------------------------------------- */

static sph2d_status write_probe(cli_outputs *o, size_t index, sph2d_report *report)
{
    double values[SPH2D_PROBE_MAX_COLUMNS];
    size_t count = sph2d_sim_probe(o->sim, index, values);
    if (count == 0)
        return SPH2D_NOMEM;
    sph2d_sim_output_done(o->sim, SPH2D_OUTPUT_PROBE + index);
    return sph2d_series_append(o->series[index], sph2d_sim_time(o->sim), values, count, report);
}

static sph2d_status write_frame(cli_outputs *o, sph2d_report *report)
{
    uint64_t number = sph2d_sim_output_count(o->sim, SPH2D_OUTPUT_FRAME);
    sph2d_sim_output_done(o->sim, SPH2D_OUTPUT_FRAME);
    if (!o->writer)
        return SPH2D_OK;
    const char *path = folder_file(o->folder, "frames/frame_%06" PRIu64 ".png", number);
    if (!path)
        return SPH2D_NOMEM;
    particle_source source = {.sim = o->sim};
    return o->queue ? output_queue_frame(o->queue, &source, &o->style, path, report)
                    : frame_writer_write(o->writer, &source, &o->style, path, &o->frames, report);
}

/* When all that comes before it is written. */
static sph2d_status write_state(cli_outputs *o, const char *path, saved_in saved, sph2d_report *report)
{
    if (!path)
        return SPH2D_NOMEM;
    unsigned compress = (unsigned)scene_of(o)->run.snapshots.compress;
    sph2d_status status = outputs_settle(o, report);
    if (status == SPH2D_OK)
        status = sph2d_snapshot_write(o->sim, o->file, compress, path, report);
    if (status == SPH2D_OK) {
        o->saved = saved;
        o->saved_step = sph2d_sim_steps(o->sim);
    }
    return status;
}

/* Beside the steps: the state is written here, and becomes a snapshot when the frame before it is a file. Not the first
 * one, after which an old checkpoint is removed: so `saved` says of every later one, too, that there is something to go
 * on from, whatever becomes of it. */
static sph2d_status queue_snapshot(cli_outputs *o, const char *path, sph2d_report *report)
{
    if (!path)
        return SPH2D_NOMEM;
    sph2d_snapshot_draft *draft;
    unsigned compress = (unsigned)scene_of(o)->run.snapshots.compress;
    sph2d_status status = sph2d_snapshot_begin(o->sim, o->file, compress, path, &draft, report);
    if (status == SPH2D_OK)
        status = output_queue_snapshot(o->queue, draft, report);
    if (status == SPH2D_OK) {
        o->saved = SAVED_IN_SNAPSHOT;
        o->saved_step = sph2d_sim_steps(o->sim);
    }
    return status;
}

static sph2d_status remove_checkpoint(cli_outputs *o, sph2d_report *report)
{
    const char *path = folder_file(o->folder, "checkpoint.h5");
    if (!path)
        return SPH2D_NOMEM;
    if (unlink(path) == 0 || errno == ENOENT)
        return SPH2D_OK;
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_WRITE, NULL, "cannot remove '%s': %s", path, strerror(errno));
    return SPH2D_IO;
}

static sph2d_status write_snapshot(cli_outputs *o, sph2d_report *report)
{
    uint64_t number = sph2d_sim_output_count(o->sim, SPH2D_OUTPUT_SNAPSHOT);
    sph2d_sim_output_done(o->sim, SPH2D_OUTPUT_SNAPSHOT);
    const char *path = folder_file(o->folder, "snapshot_%06" PRIu64 ".h5", number);
    if (o->queue && !o->old_checkpoint)
        return queue_snapshot(o, path, report);
    sph2d_status status = write_state(o, path, SAVED_IN_SNAPSHOT, report);
    if (status != SPH2D_OK)
        return status;
    o->old_checkpoint = false; /* the snapshot is newer than the checkpoint */
    return remove_checkpoint(o, report);
}

/* ---- outputs that are due ---------------------------------------------------------------------------------------- */

/* The snapshot comes last, as its state says that all other outputs of this step are written. */
sph2d_status outputs_write_due(cli_outputs *o, sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    for (size_t i = 0; i < o->series_count && status == SPH2D_OK; ++i)
        if (sph2d_sim_output_due(o->sim, SPH2D_OUTPUT_PROBE + i))
            status = write_probe(o, i, report);
    if (status == SPH2D_OK && sph2d_sim_output_due(o->sim, SPH2D_OUTPUT_FRAME))
        status = write_frame(o, report);
    if (status == SPH2D_OK && sph2d_sim_output_due(o->sim, SPH2D_OUTPUT_SNAPSHOT))
        status = write_snapshot(o, report);
    return status;
}

sph2d_status outputs_write_guard(cli_outputs *o, sph2d_report *report)
{
    sph2d_status status = write_state(o, folder_file(o->folder, "guard.h5"), SAVED_NOWHERE, report);
    /* A run that was never stopped has none, and one that is resumed meets the guard again. */
    return status == SPH2D_OK ? remove_checkpoint(o, report) : status;
}

/* Whether all of a run left no file: its only result is then its last moment. */
static bool left_nothing(const cli_outputs *o)
{
    return o->series_count == 0 && !o->writer && !(sph2d_rate_interval(scene_of(o)->run.snapshots.rate) > 0);
}

sph2d_status outputs_finish(cli_outputs *o, bool stopped, sph2d_report *report)
{
    sph2d_status status = outputs_settle(o, report);
    if (status != SPH2D_OK)
        return status;
    if (!stopped && left_nothing(o)) {
        o->last_only = true;
        return write_snapshot(o, report);
    }
    bool is_saved = o->saved_step == sph2d_sim_steps(o->sim);
    bool needed = stopped || sph2d_rate_interval(scene_of(o)->run.snapshots.rate) > 0;
    if (is_saved && o->saved == SAVED_IN_CHECKPOINT && needed)
        return SPH2D_OK;
    if (needed && !(is_saved && o->saved == SAVED_IN_SNAPSHOT))
        return write_state(o, folder_file(o->folder, "checkpoint.h5"), SAVED_IN_CHECKPOINT, report);
    return remove_checkpoint(o, report);
}

sph2d_status outputs_close(cli_outputs *o, sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    output_queue_end(o->queue);
    o->queue = NULL;
    for (size_t i = 0; i < o->series_count; ++i) {
        sph2d_status closed = sph2d_series_close(o->series[i], report);
        if (status == SPH2D_OK)
            status = closed;
    }
    free(o->series);
    o->series = NULL;
    o->series_count = 0;
    return status;
}
