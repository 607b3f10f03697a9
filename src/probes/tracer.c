/* SPDX-License-Identifier: MIT */
/** @file tracer.c
 *  Tracers: single particles that are followed, and the places where outputs found them. */
#include <math.h>

#include "methods/common/on_device.h"
#include "probes/probes.h"

/** The particle that is nearest to a place, within a spacing: where there is liquid one is within 0.71 of a square lattice.
 *  Returns its id plus 1; 0: none. */
static uint64_t nearest_to(const sph2d_sim *sim, sph2d_vec2 at)
{
    const sph2d__store *f = &sim->system.fluid;
    double least = sim->system.spacing;
    uint64_t found = 0;
    sph2d__ranges ranges;
    if (!sph2d__sim_around(sim, &at, &ranges))
        return 0;
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
        double distance = hypot(at.x + ranges.x[r] - f->x[j], at.y + ranges.y[r] - f->y[j]);
        if (distance < least || (distance == least && f->id[j] + 1 < found)) {
            least = distance;
            found = f->id[j] + 1;
        }
    }
    return found;
}

void sph2d__tracers_choose(sph2d_sim *sim)
{
    for (size_t k = 0; sim->tracers.particles && k < sim->world.scene.probe_count; ++k)
        if (sim->world.scene.probes[k].kind == SPH2D_PROBE_TRACER && sim->tracers.particles[k] == 0) {
            sph2d__host_reads(&sim->system, SPH2D__EVERYTHING);
            sim->tracers.particles[k] = nearest_to(sim, sim->world.scene.probes[k].at);
        }
}

/** The index of the particle that a probe follows; SIZE_MAX before it has one, and when that has left. */
static size_t followed(const sph2d_sim *sim, size_t probe)
{
    const sph2d__store *f = &sim->system.fluid;
    const uint64_t wanted = sim->tracers.particles[probe];
    for (size_t i = 0; wanted > 0 && i < f->count; ++i)
        if (f->id[i] + 1 == wanted)
            return i;
    return SIZE_MAX;
}

bool sph2d__tracers_reserve(sph2d_sim *sim, size_t count)
{
    sph2d__tracers *t = &sim->tracers;
    const size_t room = count > t->room ? (count > 2 * t->room ? count : 2 * t->room) : t->room;
    const sph2d__growth blocks[] = {{&t->places, 2 * sizeof(double)}, {&t->probes, sizeof(uint64_t)}};
    if (room > t->room && !sph2d__grow_all(&sim->memory, blocks, 2, t->room, room))
        return false;
    t->room = room;
    return true;
}

void sph2d__tracers_free(sph2d_sim *sim)
{
    sph2d__tracers *t = &sim->tracers;
    void *blocks[] = {t->places, t->probes};
    sph2d__release(&sim->memory, &blocks[0], t->room, 2 * sizeof(double));
    sph2d__release(&sim->memory, &blocks[1], t->room, sizeof(uint64_t));
    t->places = NULL;
    t->probes = NULL;
    t->count = t->room = 0;
}

void sph2d__tracers_sampled(sph2d_sim *sim, size_t probe)
{
    sph2d__tracers *t = &sim->tracers;
    sph2d__host_reads(&sim->system, t->particles ? SPH2D__EVERYTHING : 0);
    const size_t i = sim->world.scene.probes[probe].kind == SPH2D_PROBE_TRACER ? followed(sim, probe) : SIZE_MAX;
    if (i == SIZE_MAX || !sph2d__tracers_reserve(sim, t->count + 1)) /* a point less in pictures */
        return;
    t->places[2 * t->count] = sim->system.fluid.x[i];
    t->places[2 * t->count + 1] = sim->system.fluid.y[i];
    t->probes[t->count++] = probe;
}

sph2d_paths sph2d_sim_paths(const sph2d_sim *sim)
{
    return sim ? (sph2d_paths){sim->tracers.count, sim->tracers.places, sim->tracers.probes} : (sph2d_paths){0};
}

size_t sph2d__probe_tracer(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    const sph2d__store *f = &sim->system.fluid;
    const size_t i = followed(sim, (size_t)(probe - sim->world.scene.probes));
    const bool has = i != SIZE_MAX;
    values[0] = has ? f->x[i] : NAN;
    values[1] = has ? f->y[i] : NAN;
    values[2] = has ? f->vx[i] : NAN;
    values[3] = has ? f->vy[i] : NAN;
    values[4] = has ? f->pressure[i] : NAN;
    values[5] = has ? (double)f->id[i] : NAN;
    return 6;
}
