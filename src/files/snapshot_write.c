/* SPDX-License-Identifier: MIT */
/** @file snapshot_write.c
 *  Writes a snapshot to a temporary file, with the mark of completeness last, which is then synced and renamed. */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/c_locale.h"
#include "base/null.h"
#include "files/snapshot_parts.h"
#include "files/trailer.h"

/** Writes the text of the scene file and the overrides. */
static void put_scene(sph2d__h5_writer *w, const sph2d_scene_file *file)
{
    size_t count;
    const sph2d_override *overrides = sph2d_scene_file_overrides(file, &count);
    hid_t at = sph2d__h5_group(w, SPH2D__GROUP_SCENE);
    sph2d__h5_put_document(w, at, SPH2D__SCENE_TEXT, sph2d_scene_file_text(file));
    const char **texts = calloc(2 * count + 1, sizeof *texts);
    sph2d__h5_check_memory(w, texts);
    for (size_t i = 0; texts && i < count; ++i) {
        texts[i] = overrides[i].path;
        texts[count + i] = overrides[i].value;
    }
    if (w->ok && count > 0) {
        sph2d__h5_put_texts(w, at, SPH2D__SCENE_PATHS, texts, count);
        sph2d__h5_put_texts(w, at, SPH2D__SCENE_VALUES, texts + count, count);
    }
    free(texts);
    sph2d__h5_close(at);
}

static void put_everything(sph2d__h5_writer *w, const sph2d_sim *sim, const sph2d_scene_file *file,
                           const sph2d_state *state)
{
    static const uint64_t version = SPH2D__FORMAT_VERSION, complete = 1;
    sph2d__h5_put_text(w, w->file, SPH2D__AT_FORMAT, SPH2D__FORMAT);
    sph2d__h5_put_counts(w, w->file, SPH2D__AT_FORMAT_VERSION, &version, 0);
    sph2d__snapshot_put_metadata(w, sim);
    sph2d__snapshot_put_parameters(w, sph2d_sim_scene(sim));
    if (file)
        put_scene(w, file);
    sph2d__snapshot_put_arrays(w, sim, state);
    sph2d__snapshot_put_vtk(w, sim);
    sph2d__h5_put_counts(w, w->file, SPH2D__AT_COMPLETE, &complete, 0);
}

/** Writes the temporary file and closes it. */
static sph2d_status write_file(int fd, sph2d_sim *sim, const sph2d_scene_file *file, const sph2d_state *state,
                               unsigned compress, const char *path, sph2d_report *report)
{
    sph2d__h5_scope scope;
    sph2d__h5_writer w;
    if (!sph2d__h5_scope_begin(&scope)) {
        close(fd);
        return SPH2D_NOMEM;
    }
    sph2d__h5_writer_open(&w, fd, compress, path, report);
    put_everything(&w, sim, file, state);
    sph2d_status status = sph2d__h5_writer_close(&w);
    sph2d__h5_scope_end(&scope);
    int error = 0; /* of the steps after HDF5, whose errors are reported already */
    if (status == SPH2D_OK && !sph2d__trailer_append(fd))
        error = errno;
    if (close(fd) != 0 && status == SPH2D_OK && error == 0)
        error = errno;
    if (error == 0)
        return status;
    sph2d__report_errno(report, SPH2D_CODE_FILE_WRITE, "write", path, error);
    return SPH2D_IO;
}

struct sph2d_snapshot_draft {
    sph2d__atomic_file target;
};

sph2d_status sph2d_snapshot_begin(sph2d_sim *sim, const sph2d_scene_file *file, unsigned compress, const char *path,
                                  sph2d_snapshot_draft **draft, sph2d_report *report)
{
    if (!draft)
        return sph2d__null(report, __func__, "draft");
    *draft = NULL;
    if (!sim)
        return sph2d__null(report, __func__, "sim");
    if (!path)
        return sph2d__null(report, __func__, "path");
    if (compress > 9) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, NULL,
                         "the deflate level %u is out of range: must be at most 9", compress);
        return SPH2D_INVALID;
    }
    sph2d_state state = sph2d_sim_state(sim);
    sph2d__c_locale locale;
    if (!state.arrays || !sph2d__c_locale_begin(&locale))
        return SPH2D_NOMEM;
    sph2d_snapshot_draft *self = calloc(1, sizeof *self);
    sph2d_status status = self ? sph2d__atomic_begin(&self->target, path, report) : SPH2D_NOMEM;
    if (status == SPH2D_OK) {
        int fd = open(self->target.temp_path, O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
        if (fd >= 0) {
            status = write_file(fd, sim, file, &state, compress, path, report);
        } else {
            sph2d__report_errno(report, SPH2D_CODE_FILE_WRITE, "create", path, errno);
            status = SPH2D_CANTCREAT;
        }
    }
    if (status == SPH2D_OK)
        *draft = self;
    else
        sph2d_snapshot_abort(self);
    sph2d__c_locale_end(&locale);
    return status;
}

sph2d_status sph2d_snapshot_commit(sph2d_snapshot_draft *draft, sph2d_report *report)
{
    if (!draft)
        return sph2d__null(report, __func__, "draft");
    sph2d_status status = sph2d__atomic_commit(&draft->target, report);
    free(draft);
    return status;
}

void sph2d_snapshot_abort(sph2d_snapshot_draft *draft)
{
    if (!draft)
        return;
    sph2d__atomic_abort(&draft->target);
    free(draft);
}

sph2d_status sph2d_snapshot_write(sph2d_sim *sim, const sph2d_scene_file *file, unsigned compress, const char *path,
                                  sph2d_report *report)
{
    if (!sim)
        return sph2d__null(report, __func__, "sim");
    if (!path)
        return sph2d__null(report, __func__, "path");
    sph2d_snapshot_draft *draft;
    sph2d_status status = sph2d_snapshot_begin(sim, file, compress, path, &draft, report);
    return status == SPH2D_OK ? sph2d_snapshot_commit(draft, report) : status;
}
