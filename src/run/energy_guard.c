/* SPDX-License-Identifier: MIT */
/** @file energy_guard.c
 *  The energy balance, and the guard that stops a run whose energy grows without a source.
 *
 *  Energy that is added (by sources and drains, a change of gravity, moving walls, interactions, forces along periods)
 *  and energy that is dissipated are summed over time (work.c). From them follow two figures, both compared with the
 *  energy scale of the scene,
 *
 *      (m n + mass of bodies) (g h + U^2/2 + pull)/2,
 *
 *  the potential energy of a column as high as liquid can fall (sph2d__system.head), with n all particles that ever
 *  existed and U but for what springs of bodies give, plus the energy of these springs at the start, the elastic energy
 *  of liquid that starts pressed together, and the surface energy of a round drop of the liquid. The error is
 *
 *      kinetic + potential + elastic - start - added + dissipated.
 *
 *  The rise is how far kinetic + potential + elastic - added ever rose above an earlier value: it is above 0 only where
 *  energy comes from nothing, however much is dissipated elsewhere. The guard limits the rise, by the scale or the largest
 *  kinetic energy, which is twice that where a block starts with the speed U; and a rise of the error.
 *
 *  A pressure projection dissipates energy where liquid meets liquid or a wall: 30 to 80 % at an impact. This is the
 *  work of its impulses with the mean velocity of each step (projected.c), less the work of moving walls and the
 *  elastic energy stored, summed from sample to sample, so that oscillations cancel. A negative sum is dissipation. A
 *  positive sum is not added to the balance, and so remains in the error. */
#include <math.h>
#include <stdio.h>

#include "methods/common/on_device.h"
#include "run/run.h"
#include "scene/method_table.h"

/** Largest initial density of a block over rest density, with methods that sum density; at least 1. */
static double start_compression(const sph2d_sim *sim)
{
    double largest = 1, dx = sim->world.scene.spacing;
    for (size_t k = 0;
         k < sim->world.scene.block_count && sph2d__method_row_of(&sim->world.scene.method)->summed_density; ++k)
        if (sim->world.scene.blocks[k].spacing > 0)
            largest = fmax(largest, pow(dx / sim->world.scene.blocks[k].spacing, 2));
    return largest;
}

sph2d__bounds sph2d__sim_bounds(const sph2d_sim *sim)
{
    const sph2d__method_row *row = sph2d__method_row_of(&sim->world.scene.method);
    double rest = sim->system.rest_density, rise = sim->world.scene.run.max_energy_rise;
    return (sph2d__bounds){row->min_density * rest, row->max_density * rest * start_compression(sim),
                           rise > 0 ? rise : row->energy_rise};
}

/* Steps between two sums of the energy, of methods without a projection, and with surface tension. */
enum { LOOK_STEPS = 4, LOOK_STEPS_TENSION = 8 };

/** Adds the energy that the pressure projection dissipated since the last sample: negative work that is not stored as
 *  elastic energy. A positive difference remains in the error. */
static void book_projection(sph2d__record *r, double elastic)
{
    double stored = elastic - r->energy_elastic;
    r->energy_pressed += fmax(-r->work_pressed - stored, 0);
    r->work_pressed = 0;
    r->energy_elastic = elastic;
}

/** Whether the energy is summed in this step, for the rise alone: a sum over the particles is cheap beside the solver of
 *  a projection, and beside some steps of other methods; the energy of surface tension takes pairs. */
static bool looks(const sph2d_sim *sim)
{
    uint64_t every = sim->system.surface_tension > 0 ? LOOK_STEPS_TENSION : sim->method->project ? 1 : LOOK_STEPS;
    return sim->record.steps % every == 0 && sph2d__sim_external_work_is_booked(sim);
}

sph2d_status sph2d__sim_update_energy_balance(sph2d_sim *sim)
{
    sph2d__record *r = &sim->record;
    bool books = sph2d__sim_samples_energy(sim, r->steps);
    sph2d__sim_book_external_work(sim);
    if (!books && !looks(sim))
        return SPH2D_OK;
    if (books && sph2d__sim_book_dissipation(sim) != SPH2D_OK)
        return SPH2D_NOMEM;
    sph2d_summary now;
    sph2d__sim_sum_energy(sim, &now);
    r->kinetic_max = fmax(r->kinetic_max, now.kinetic);
    double energy =
        now.kinetic + now.potential + now.elastic + now.bodies - r->energy_fed - r->energy_walls - r->energy_forces;
    r->energy_low = fmin(r->energy_low, energy);
    r->energy_rise = fmax(r->energy_rise, energy - r->energy_low);
    if (!books)
        return SPH2D_OK;
    if (sim->method->books_pressure)
        book_projection(r, now.elastic);
    r->energy_error = energy - r->energy_start + r->energy_viscous + r->energy_diffused + r->energy_stopped +
                      r->energy_pressed + r->energy_contacts;
    r->error_low = fmin(r->error_low, r->energy_error);
    r->error_rise = fmax(r->error_rise, r->energy_error - r->error_low);
    return SPH2D_OK;
}

void sph2d__sim_book_new_bodies(sph2d_sim *sim)
{
    sph2d__record *r = &sim->record;
    sph2d_summary now;
    sph2d__sim_sum_energy(sim, &now);
    const double lost =
        r->energy_viscous + r->energy_diffused + r->energy_stopped + r->energy_pressed + r->energy_contacts;
    r->energy_fed += now.kinetic + now.potential + now.elastic + now.bodies - r->energy_fed - r->energy_walls -
                     r->energy_forces - (r->energy_start + r->energy_error - lost);
}

/** The fastest particle. */
static size_t find_fastest(const sph2d__store *f)
{
    size_t fastest = 0;
    double largest = -1;
    for (size_t i = 0; i < f->count; ++i) {
        double v2 = f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i];
        if (v2 > largest) {
            largest = v2;
            fastest = i;
        }
    }
    return fastest;
}

/** The keys that may help: cfl shortens no step that viscosity limits, nor one of a fixed length, and a liquid so viscous
 *  needs no damping. */
static void find_remedies(const sph2d_sim *sim, char *out, size_t size)
{
    const sph2d__record *r = &sim->record;
    if (sim->world.scene.method.time_step > 0)
        snprintf(out, size, "leaving method.time_step out, for an adaptive step, or a shorter one");
    else if (2 * r->limited_viscous <= r->steps)
        snprintf(out, size, "a smaller method.cfl, %s", sph2d__method_row_of(&sim->world.scene.method)->damping_hint);
    else
        snprintf(out, size, "shorter steps, by a method.time_step of %.2g s", r->last_step / 2);
}

/* Of all that was booked, this part may have come from nothing although the sum never rose: what appears while as much is
 * booked as lost. A balance that does not know half of it says nothing. Single drops on spring walls have 0.38, as damping
 * is sampled between few and sudden pushes, openings 0.25, other examples 0.11 at most. */
static const double UNBOOKED = 0.5;

/** The scale, and all energy that came and went [J/m]. */
static double all_booked(const sph2d_sim *sim)
{
    const sph2d__record *r = &sim->record;
    return sph2d__sim_energy_scale(sim) + fabs(r->energy_fed) + fabs(r->energy_walls) + fabs(r->energy_forces) +
           fabs(r->energy_viscous) + fabs(r->energy_diffused) + fabs(r->energy_stopped) + fabs(r->energy_pressed) +
           fabs(r->energy_contacts);
}

bool sph2d__sim_guard_energy(const sph2d_sim *sim, sph2d_report *report)
{
    const sph2d__record *r = &sim->record;
    const sph2d__store *f = &sim->system.fluid;
    double scale = fmax(sph2d__sim_energy_scale(sim), r->kinetic_max), largest = sph2d__sim_bounds(sim).rise;
    bool rises = r->energy_rise > largest * scale, unbooked = r->error_rise > fmax(UNBOOKED, largest) * all_booked(sim);
    if (!(scale > 0) || !(rises || unbooked) || !sph2d__sim_rise_is_known(sim) || f->count == 0)
        return true;
    sph2d__host_reads(&sim->system, SPH2D__EVERYTHING);
    size_t i = find_fastest(f);
    double from_nothing = rises ? r->energy_rise : r->error_rise, part = rises ? scale : all_booked(sim);
    char where[SPH2D__WHERE_SIZE], remedies[120];
    sph2d_diagnostic *d = sph2d_report_add(
        report, SPH2D_ERROR, SPH2D_CODE_ENERGY, NULL,
        "energy came from nothing: %.3g J/m, %.3g %% of the %s %.3g J/m, by step %llu, time %g s; the fastest "
        "particle %llu is at (%g, %g), %s, with velocity (%g, %g)",
        from_nothing, 100 * from_nothing / part, rises ? "scene's" : "balance's", part, (unsigned long long)r->steps,
        r->time, (unsigned long long)f->id[i], f->x[i], f->y[i],
        sph2d__sim_where(sim, (sph2d_vec2){f->x[i], f->y[i]}, where), f->vx[i], f->vy[i]);
    find_remedies(sim, remedies, sizeof remedies);
    if (rises)
        sph2d_diagnostic_hint(d,
                              "check the scene at that position; try %s, or a smaller spacing; run.max_energy_rise "
                              "allows more than %g times the scale",
                              remedies, largest);
    else
        sph2d_diagnostic_hint(d, "check the scene at that position; try %s, or a smaller spacing", remedies);
    return false;
}
