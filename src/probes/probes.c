/* SPDX-License-Identifier: MIT */
/** @file probes.c
 *  The kinds of probes that take a few lines, and the table of all. */
#include "probes/probes.h"
#include "methods/common/on_device.h"

#include <math.h>

#include "probes/coverage.h"
#include "sim/loads.h"

/* ---- at a point: velocity, pressure ------------------------------------------------------------------------------ */

static void sample(const sph2d_sim *sim, const sph2d_probe *probe, sph2d_sample *out)
{
    sph2d_vec2 along;
    sph2d_sim_sample(sim, sph2d__probe_place(sim, probe, &along), out);
}

size_t sph2d__probe_speed(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    sph2d_sample now;
    sample(sim, probe, &now);
    values[0] = now.velocity[0];
    values[1] = now.velocity[1];
    values[2] = hypot(now.velocity[0], now.velocity[1]);
    values[3] = now.neighbours;
    return 4;
}

size_t sph2d__probe_pressure(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    sph2d_sample now;
    sample(sim, probe, &now);
    bool gauge = probe->size > 0 || probe->rise_time > 0;
    values[0] = gauge ? sph2d__gauge_reading(sim, (size_t)(probe - sim->world.scene.probes)) : now.pressure;
    values[1] = now.density;
    values[2] = now.neighbours;
    return 3;
}

/* ---- the liquid's area, and its level at rest (coverage.h) ------------------------------------------------------- */

size_t sph2d__probe_volume(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    (void)probe;
    sph2d__coverage coverage;
    values[0] = NAN;
    values[1] = sph2d__placed_area(sim);
    if (sph2d__coverage_make(&coverage, sim)) {
        values[0] = sph2d__coverage_area(&coverage);
        sph2d__coverage_free(&coverage);
    }
    return 2;
}

size_t sph2d__probe_level(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    (void)probe;
    sph2d__coverage coverage;
    values[0] = NAN;
    if (sph2d__coverage_make(&coverage, sim)) {
        values[0] = sph2d__coverage_level(&coverage, sph2d__coverage_area(&coverage));
        sph2d__coverage_free(&coverage);
    }
    return 1;
}

/* ---- walls: forces of the liquid, and their work (sim/loads.h) --------------------------------------------------- */

static const sph2d__load_state *load_of(const sph2d_sim *sim, const sph2d_probe *probe)
{
    return &sim->loads.states[sim->loads.of_probe[probe - sim->world.scene.probes]];
}

size_t sph2d__probe_force(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    const sph2d__load_state *l = load_of(sim, probe);
    const sph2d__pull contact = {l->springs.x + l->contact.x, l->springs.y + l->contact.y,
                                 l->springs.torque + l->contact.torque};
    values[0] = l->pressure.x + l->friction.x + contact.x;
    values[1] = l->pressure.y + l->friction.y + contact.y;
    values[2] = l->pressure.torque + l->friction.torque + contact.torque;
    values[3] = l->pressure.x;
    values[4] = l->pressure.y;
    values[5] = l->friction.x;
    values[6] = l->friction.y;
    values[7] = contact.x;
    values[8] = contact.y;
    values[9] = l->impulse.x;
    values[10] = l->impulse.y;
    values[11] = l->impulse.torque;
    return 12;
}

size_t sph2d__probe_work(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    values[0] = load_of(sim, probe)->power;
    values[1] = load_of(sim, probe)->work;
    return 2;
}

/* ---- a body: where it is, how it moves, and the force of the liquid ---------------------------------------------- */

size_t sph2d__probe_body(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    const int wall = sph2d__wall_named(&sim->world, probe->on);
    const sph2d__rigid *r = &sim->bodies.items[sim->world.walls[wall].index];
    const sph2d__rigid_state *now = r->state;
    const double all[] = {r->center.x + now->place.x,
                          r->center.y + now->place.y,
                          now->place.turn,
                          now->velocity.x,
                          now->velocity.y,
                          now->velocity.turn,
                          now->liquid.x,
                          now->liquid.y,
                          now->liquid.turn,
                          sph2d__body_energy(sim, r)};
    const size_t count = sizeof all / sizeof *all;
    for (size_t k = 0; k < count; ++k)
        values[k] = all[k];
    return count;
}

/* ---- what flows through an opening ------------------------------------------------------------------------------- */

size_t sph2d__probe_opening(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    const sph2d_opening *opening = sph2d__opening_named(&sim->world.scene, probe->on);
    sph2d__opening_read(sim, (size_t)(opening - sim->world.scene.openings), values);
    return SPH2D__OPENING_READINGS;
}

/* ---- the table --------------------------------------------------------------------------------------------------- */

static const struct {
    sph2d__probe_kind *evaluate;
    const char *columns;
} rows[] = {
#define ROW(name, word, columns_) [SPH2D_PROBE_##name] = {sph2d__probe_##word, columns_},
    SPH2D_PROBE_MAP(ROW)
#undef ROW
};

const char *sph2d_probe_columns(sph2d_probe_kind kind)
{
    return (size_t)kind < sizeof rows / sizeof rows[0] ? rows[kind].columns : "";
}

size_t sph2d_sim_probe(const sph2d_sim *sim, size_t index, double values[SPH2D_PROBE_MAX_COLUMNS])
{
    if (!sim || !values)
        return 0;
    if (index >= sim->world.scene.probe_count || sph2d__sim_is_broken(sim))
        return 0;
    const sph2d_probe *probe = &sim->world.scene.probes[index];
    sph2d__host_reads(&sim->system, SPH2D__EVERYTHING);
    size_t failures = sim->system.memory->failures, count = rows[probe->kind].evaluate(sim, probe, values);
    return sim->system.memory->failures == failures ? count : 0;
}
