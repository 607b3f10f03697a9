/* SPDX-License-Identifier: MIT */
/** @file snapshot_about.c
 *  Writes the metadata of a snapshot. It does not depend on when, where or by how many threads it is written. */
#include <stdio.h>

#include "files/snapshot_parts.h"

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
    uint64_t counts[PARTICLE_TYPES] = {sph2d_sim_fluid(sim).count, sph2d_sim_walls(sim).count},
             none[PARTICLE_TYPES] = {0};
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

void sph2d__snapshot_put_metadata(sph2d__h5_writer *w, const sph2d_sim *sim)
{
    put_header(w, sim);
    put_units(w);
    put_code(w, sim);
}
