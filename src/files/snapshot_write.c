/* SPDX-License-Identifier: MIT */
/** @file snapshot_write.c
 *  Writes a snapshot to a temporary file, with the mark of completeness last, which is then synced and renamed. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/null.h"
#include "base/number.h"
#include "files/h5_file.h"
#include "files/snapshot.h"
#include "sph2d/device.h"

/* ---- metadata: not when, where or by how many threads it is written ---------------------------------------------- */

/** Particle types of SWIFT's format: gas (0) is the fluid, dark matter (1) the walls; the others are empty. */
enum { PARTICLE_TYPES = 7 };

static void put_scalar(sph2d__h5_writer *w, hid_t at, const char *name, double value)
{
    sph2d__h5_put_reals(w, at, name, &value, 0);
}

/** What SWIFT has is a list of one, too, as its tools expect. */
static void put_header(sph2d__h5_writer *w, const sph2d_sim *sim)
{
    const sph2d_scene *scene = sph2d_sim_scene(sim);
    const sph2d_plan *plan = sph2d_sim_plan(sim);
    const sph2d_box *d = &scene->domain;
    uint64_t steps = sph2d_sim_steps(sim);
    double size[3] = {d->max.x - d->min.x, d->max.y - d->min.y, 0};
    double low[2] = {d->min.x, d->min.y}, high[2] = {d->max.x, d->max.y};
    double masses[PARTICLE_TYPES] = {0};
    uint64_t counts[PARTICLE_TYPES] = {sph2d_sim_count(sim), sph2d_sim_walls(sim).count}, none[PARTICLE_TYPES] = {0};
    static const int64_t zero = 0, one = 1, two = 2;

    hid_t at = sph2d__h5_group(w, SPH2D__GROUP_HEADER);
    sph2d__h5_put_real(w, at, SPH2D__AT_TIME, sph2d_sim_time(sim));
    put_scalar(w, at, SPH2D__AT_TIME_STEP, sph2d_sim_time_step(sim));
    sph2d__h5_put_counts(w, at, SPH2D__AT_STEP, &steps, 0);
    sph2d__h5_put_reals(w, at, "DomainMin", low, 2);
    sph2d__h5_put_reals(w, at, "DomainMax", high, 2);
    put_scalar(w, at, "Spacing", scene->spacing);
    put_scalar(w, at, SPH2D__AT_SUPPORT, plan->support_radius);
    put_scalar(w, at, "ParticleMass", plan->particle_mass);
    put_scalar(w, at, SPH2D__AT_SOUND_SPEED, plan->sound_speed);
    sph2d__h5_put_reals(w, at, "BoxSize", size, 3);
    sph2d__h5_put_ints(w, at, "Dimension", &two, 1);
    sph2d__h5_put_counts(w, at, "NumPart_ThisFile", counts, PARTICLE_TYPES);
    sph2d__h5_put_counts(w, at, "NumPart_Total", counts, PARTICLE_TYPES);
    sph2d__h5_put_counts(w, at, "NumPart_Total_HighWord", none, PARTICLE_TYPES);
    sph2d__h5_put_reals(w, at, "MassTable", masses, PARTICLE_TYPES);
    sph2d__h5_put_ints(w, at, "NumFilesPerSnapshot", &one, 1);
    sph2d__h5_put_ints(w, at, "ThisFile", &zero, 1);
    sph2d__h5_put_real(w, at, "Redshift", 0);
    sph2d__h5_put_real(w, at, "Scale-factor", 1);
    sph2d__h5_put_text(w, at, "Code", "sph2d");
    sph2d__h5_put_text(w, at, "OutputType", "FullVolume");
    sph2d__h5_put_text(w, at, "RunName", scene->name ? scene->name : "");
    sph2d__h5_close(at);
}

/** SI units as multiples of CGS units, each as a list of one. */
static void put_units(sph2d__h5_writer *w)
{
    hid_t at = sph2d__h5_group(w, "/Units");
    sph2d__h5_put_real(w, at, "Unit mass in cgs (U_M)", 1000);
    sph2d__h5_put_real(w, at, "Unit length in cgs (U_L)", 100);
    sph2d__h5_put_real(w, at, "Unit time in cgs (U_t)", 1);
    sph2d__h5_put_real(w, at, "Unit current in cgs (U_I)", 1);
    sph2d__h5_put_real(w, at, "Unit temperature in cgs (U_T)", 1);
    sph2d__h5_close(at);
}

static void put_code(sph2d__h5_writer *w, const sph2d_sim *sim)
{
    hid_t at = sph2d__h5_group(w, SPH2D__GROUP_CODE);
    sph2d__h5_put_text(w, at, "Code", "sph2d");
    sph2d__h5_put_text(w, at, SPH2D__AT_CODE_VERSION, sph2d_version());
    sph2d__h5_put_text(w, at, SPH2D__AT_ISA, sph2d_isa_name(sph2d_sim_isa(sim)));
    sph2d__h5_put_text(w, at, "HDF5 library version", sph2d_io_hdf5_version());
    sph2d__h5_close(at);
}

static void put_metadata(sph2d__h5_writer *w, const sph2d_sim *sim)
{
    put_header(w, sim);
    put_units(w);
    put_code(w, sim);
}

/* ---- the file ---------------------------------------------------------------------------------------------------- */

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
    put_metadata(w, sim);
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
    if (sph2d_sim_device_status(sim, report) != SPH2D_OK)
        return SPH2D_DEVICE;
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
