/* SPDX-License-Identifier: MIT */
/** @file energy_guard.c
 *  Energy that adds up, and the guard that stops a run where it does not.
 *
 *  What is brought, by particles that come and go, new gravity, moving walls, interactions and forces along periods, is
 *  booked (work.c), and so is what dissipates. Two figures follow, both over the energy scale of the scene,
 *
 *      m n (g h + U^2/2 + pull)/2,
 *
 *  the potential energy of a column as high as liquid can fall (sph2d__system.head), with n all particles that ever
 *  were, and the surface of a round drop of them. The error is what does not add up,
 *
 *      kinetic + potential + elastic - start - brought + dissipated,
 *
 *  and the rise how far the same without what is dissipated ever rose above an earlier moment: it is above 0 only
 *  where energy comes from nothing, whatever else is lost. The guard is on the rise.
 *
 *  Pressures that keep a density take what liquid has too much that meets liquid or a wall: at an impact 30 to 80 %.
 *  That is the work of their impulses with the mean velocity of each step (projected.c), less that of moving walls and
 *  what compression stores, summed from look to look, in which a liquid that trembles gives back what it took. Where it
 *  is below 0 it dissipated. Where pressures gave more than they took it is not booked, and stays in the error. */
#include <math.h>

#include "run/run.h"
#include "scene/method_table.h"

/** How much denser than the rest the scene's blocks start, where density is a sum; 1 at least. */
static double start_of(const sph2d_sim *sim)
{
    double most = 1, dx = sim->scene.spacing;
    for (size_t k = 0; k < sim->scene.block_count && sph2d__method_row_of(&sim->scene.method)->summed_density; ++k)
        if (sim->scene.blocks[k].spacing > 0)
            most = fmax(most, pow(dx / sim->scene.blocks[k].spacing, 2));
    return most;
}

sph2d__bounds sph2d__sim_bounds(const sph2d_sim *sim)
{
    const sph2d__method_row *row = sph2d__method_row_of(&sim->scene.method);
    double rest = sim->system.rest_density, rise = sim->scene.run.max_energy_rise;
    return (sph2d__bounds){row->min_density * rest, row->max_density * rest * start_of(sim),
                           rise > 0 ? rise : row->energy_rise};
}

/* In so many steps liquid expands that starts compressed, by particles that are too near to each other or to walls.
 * Where density does not tell all of that energy, it is taken as the start's. */
enum { START_STEPS = 32 };

/** Books what pressures that keep the density took since the last look and did not store. Where they gave more than
 *  was stored, nothing is booked, and the error has it. */
static void book_pressed(sph2d__record *r, double elastic)
{
    double stored = elastic - r->energy_elastic;
    r->energy_pressed += fmax(-r->work_pressed - stored, 0);
    r->work_pressed = 0;
    r->energy_elastic = elastic;
}

sph2d_status sph2d__sim_watch_energy(sph2d_sim *sim)
{
    sph2d__record *r = &sim->record;
    sph2d__sim_book_drives(sim);
    if (!sph2d__sim_looks(sim, r->steps))
        return SPH2D_OK;
    if (sph2d__sim_book(sim) != SPH2D_OK)
        return SPH2D_NOMEM;
    sph2d_summary now;
    sph2d__sim_sum_energy(sim, &now);
    if (sim->method->project)
        book_pressed(r, now.elastic);
    double energy = now.kinetic + now.potential + now.elastic - r->energy_fed - r->energy_walls - r->energy_forces;
    bool starts = sph2d__method_row_of(&sim->scene.method)->summed_density && r->steps <= START_STEPS;
    r->energy_low = starts ? energy : fmin(r->energy_low, energy);
    r->energy_rise = fmax(r->energy_rise, energy - r->energy_low);
    r->energy_error =
        energy - r->energy_start + r->energy_viscous + r->energy_diffused + r->energy_stopped + r->energy_pressed;
    r->error_low = fmin(r->error_low, r->energy_error);
    r->error_rise = fmax(r->error_rise, r->energy_error - r->error_low);
    return SPH2D_OK;
}

/** The particle that moves fastest. */
static size_t fastest_of(const sph2d__store *f)
{
    size_t fastest = 0;
    double most = -1;
    for (size_t i = 0; i < f->count; ++i) {
        double v2 = f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i];
        if (v2 > most) {
            most = v2;
            fastest = i;
        }
    }
    return fastest;
}

bool sph2d__sim_guard_energy(const sph2d_sim *sim, sph2d_report *report)
{
    const sph2d__record *r = &sim->record;
    const sph2d__store *f = &sim->system.fluid;
    double scale = sph2d__sim_energy_scale(sim), most = sph2d__sim_bounds(sim).rise;
    if (!(scale > 0) || !(r->energy_rise > most * scale) || !sph2d__sim_rise_is_known(sim) || f->count == 0)
        return true;
    size_t i = fastest_of(f);
    char where[SPH2D__WHERE_SIZE];
    sph2d_diagnostic *d = sph2d_report_add(
        report, SPH2D_ERROR, SPH2D_CODE_ENERGY, NULL,
        "energy came from nothing: %.3g J/m, %.3g %% of the scene's %.3g J/m, by step %llu, time %g s; the fastest "
        "particle %llu is at (%g, %g), %s, with velocity (%g, %g)",
        r->energy_rise, 100 * r->energy_rise / scale, scale, (unsigned long long)r->steps, r->time,
        (unsigned long long)f->id[i], f->x[i], f->y[i], sph2d__sim_where(sim, (sph2d_vec2){f->x[i], f->y[i]}, where),
        f->vx[i], f->vy[i]);
    sph2d_diagnostic_hint(d,
                          "look at what is there; %s or a smaller spacing calms liquid, and run.max_energy_rise lets "
                          "more than %g times the scale pass",
                          sph2d__method_row_of(&sim->scene.method)->calmed_by, most);
    return false;
}
