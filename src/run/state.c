/* SPDX-License-Identifier: MIT */
/** @file state.c
 *  The state of a simulation as named arrays: output and restoring. */
#include <math.h>
#include <string.h>

#include "methods/common/on_device.h"
#include "probes/probes.h"
#include "run/fields.h"
#include "run/run.h"
#include "simd/isa.h"

#define ONE_MORE(...) +1

enum {
    RECORD_ARRAYS = 0 SPH2D__RECORD_REALS(ONE_MORE) SPH2D__RECORD_COUNTS(ONE_MORE),
    STATE_ARRAYS = RECORD_ARRAYS + SPH2D__FIELDS_OF_STATE + 11
};

static sph2d__lent run_array(const char *name, const char *description, sph2d_type type, size_t count, void *data)
{
    return (sph2d__lent){.array = {.group = SPH2D_GROUP_RUN,
                                   .name = name,
                                   .description = description,
                                   .type = type,
                                   .components = 1,
                                   .count = count,
                                   .stride = 1,
                                   .data = {data, NULL}},
                         .data = {data, NULL}};
}

static const char BODIES[] = "Bodies";

static sph2d__lent bodies_array(sph2d_sim *sim)
{
    return run_array(BODIES, "of each body: place, velocity, acceleration, what holds it up, force of the liquid",
                     SPH2D_F64, SPH2D__RIGID_VALUES * sim->bodies.count, sim->bodies.states);
}

/** Writes all arrays of the state and returns their number. */
static size_t list_arrays(sph2d_sim *sim, sph2d__lent out[STATE_ARRAYS])
{
    sph2d__record *r = &sim->record;
    size_t n = sph2d__fields_of_state(sim, out);
#define REAL(member, label, m, kg, s, text)                                                                            \
    out[n] = run_array(label, text, SPH2D_F64, 1, &r->member);                                                         \
    memcpy(out[n++].array.unit, (signed char[3]){m, kg, s}, 3);
    SPH2D__RECORD_REALS(REAL)
#undef REAL
#define COUNT(member, label, text) out[n++] = run_array(label, text, SPH2D_U64, 1, &r->member);
    SPH2D__RECORD_COUNTS(COUNT)
#undef COUNT
    out[n++] = run_array("ActingForces", "gravity, place, reach and strength of the pointer in the last evaluation",
                         SPH2D_F64, SPH2D__STEERING_VALUES, &sim->acting);
    out[n++] = run_array("SourceRows", "rows that each source has fed", SPH2D_U64, sim->world.scene.source_count,
                         sim->source_rows);
    out[n++] = run_array("OutputCounts", "outputs taken: snapshots, frames, then each probe", SPH2D_U64,
                         SPH2D_OUTPUT_PROBE + sim->world.scene.probe_count, sim->output_counts);
    if (sim->gauges_lag) {
        out[n] = run_array("GaugePressures", "of each probe: pressure on a gauge's face, and what it shows", SPH2D_F64,
                           2 * sim->world.scene.probe_count, sim->gauges);
        memcpy(out[n++].array.unit, (signed char[3]){-1, 1, -2}, 3);
    }
    out[n++] =
        run_array("WallLoads", "of each probe of kind force or work, then of all walls: forces, impulses, power, work",
                  SPH2D_F64, SPH2D__LOAD_VALUES * (sim->loads.count + 1), sim->loads.states);
    if (sim->openings.count > 0)
        out[n++] = run_array("OpeningMeans",
                             "of each opening: velocity, pressure, slope, depth, fed width in the mean over a time; "
                             "that time; particles in, out, first",
                             SPH2D_F64, SPH2D__OPENING_VALUES * sim->openings.count, sim->openings.means);
    if (sim->bodies.count > 0)
        out[n++] = bodies_array(sim);
    if (sim->tracers.particles) {
        sph2d__tracers *t = &sim->tracers;
        out[n++] =
            run_array("TracerParticles", "of each probe: id of the particle that a tracer follows, plus 1; 0: none",
                      SPH2D_U64, sim->world.scene.probe_count, t->particles);
        out[n] = run_array("TracerPlaces", "x and y where outputs found the particles of tracers", SPH2D_F64,
                           2 * t->count, t->places);
        out[n++].array.unit[0] = 1;
        out[n++] =
            run_array("TracerProbes", "number of the probe of each of these places", SPH2D_U64, t->count, t->probes);
    }
    return n;
}

sph2d_state sph2d_sim_state(sph2d_sim *sim)
{
    if (!sim)
        return (sph2d_state){0};
    if (!sim->state_arrays && !sph2d__sim_is_broken(sim)) {
        sim->state_arrays = sph2d__alloc(&sim->memory, STATE_ARRAYS, sizeof(sph2d_array));
        sim->state_capacity = sim->state_arrays ? STATE_ARRAYS : 0;
    }
    sph2d_state state = {.version = SPH2D_STATE_VERSION};
    sph2d__host_reads(&sim->system, SPH2D__EVERYTHING);
    sph2d__host_reads_walls(&sim->system);
    if (sim->state_arrays && !sph2d__sim_is_broken(sim)) {
        state.arrays = sim->state_arrays;
        sph2d__lent lent[STATE_ARRAYS];
        state.array_count = list_arrays(sim, lent);
        for (size_t i = 0; i < state.array_count; ++i)
            sim->state_arrays[i] = lent[i].array;
    }
    return state;
}

/* ---- restoring --------------------------------------------------------------------------------------------------- */

typedef struct loader {
    const sph2d_state *state;
    sph2d_report *report;
    bool ok;
} loader;

/** The array of a group and name; NULL if there is none. */
static const sph2d_array *array_named(const sph2d_state *state, sph2d_group group, const char *name)
{
    for (size_t i = 0; i < state->array_count; ++i)
        if (state->arrays[i].group == group && state->arrays[i].name && strcmp(state->arrays[i].name, name) == 0)
            return &state->arrays[i];
    return NULL;
}

static void refuse(loader *l, const char *name, const char *what)
{
    l->ok = false;
    sph2d_report_add(l->report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL, "the state's '%s' %s", name, what);
}

/** The array with the group, name, type and components of `wanted` and `count` values; NULL, with a report, if there is
 *  none. */
static const sph2d_array *find_array(loader *l, const sph2d_array *wanted, size_t count)
{
    const sph2d_array *a = array_named(l->state, wanted->group, wanted->name);
    if (!a) {
        refuse(l, wanted->name, "is missing");
        return NULL;
    }
    if (a->type != wanted->type || a->components != wanted->components || a->count != count) {
        refuse(l, wanted->name, "has the wrong type or shape");
        return NULL;
    }
    for (unsigned c = 0; c < a->components; ++c)
        if (!a->data[c] && count > 0) {
            refuse(l, wanted->name, "has no data");
            return NULL;
        }
    return a;
}

bool sph2d__state_has_colors(const sph2d_state *state)
{
    return array_named(state, SPH2D_GROUP_FLUID, "Colors");
}

/** Gives all liquid the fluid's colour, where the state is that of a scene without colours. */
static void set_colors(sph2d_sim *sim)
{
    sph2d__store *fluid = &sim->system.fluid;
    for (size_t i = 0; i < fluid->count; ++i)
        fluid->color[i] = sph2d__color_of(&sim->world.scene, NULL);
}

static void copy_values(loader *l, const sph2d_array *from, void *to, unsigned component)
{
    const char *data = from->data[component];
    for (size_t i = 0; i < from->count; ++i) {
        const char *value = data + i * from->stride * 8;
        if (from->type == SPH2D_F64) {
            double number;
            memcpy(&number, value, sizeof number);
            if (!isfinite(number)) {
                refuse(l, from->name, "has a value that is not finite");
                return;
            }
        }
        memcpy((char *)to + 8 * i, value, 8);
    }
}

/** Walls follow from the scene and the time. Their numbers are indices when they are sorted (sim/forcing.c). */
static bool walls_match(loader *l, const sph2d_sim *sim)
{
    const sph2d__store *walls = &sim->system.walls;
    const sph2d_array wanted[] = {
        {.group = SPH2D_GROUP_WALL, .name = "Coordinates", .type = SPH2D_F64, .components = 2},
        {.group = SPH2D_GROUP_WALL, .name = "ParticleIDs", .type = SPH2D_U64, .components = 1}};
    const sph2d_array *places = find_array(l, &wanted[0], walls->count);
    const sph2d_array *ids = find_array(l, &wanted[1], walls->count);
    if (!places || !ids)
        return false;
    const double *x = places->data[0], *y = places->data[1];
    const uint64_t *id = ids->data[0];
    for (size_t i = 0; l->ok && i < walls->count; ++i)
        if (x[i * places->stride] != walls->x[i] || y[i * places->stride] != walls->y[i])
            refuse(l, "Coordinates", "of the walls are not those of the scene");
        else if (id[i * ids->stride] != walls->id[i])
            refuse(l, "ParticleIDs", "of the walls are not those of the scene");
    return l->ok;
}

/** Whether a state says anything of walls. */
static bool has_walls(const sph2d_state *state)
{
    for (size_t i = 0; i < state->array_count; ++i)
        if (state->arrays[i].group == SPH2D_GROUP_WALL)
            return true;
    return false;
}

bool sph2d__state_lacks_bodies(const sph2d_state *state)
{
    return !array_named(state, SPH2D_GROUP_RUN, BODIES) && !has_walls(state);
}

static size_t count_of(const sph2d_state *state, sph2d_group group, const char *name)
{
    const sph2d_array *array = array_named(state, group, name);
    return array ? array->count : 0;
}

/** Makes room for the places of tracers. False when memory is short. */
static bool reserve_tracers(sph2d_sim *sim, const sph2d_state *state)
{
    size_t count = sim->tracers.particles ? count_of(state, SPH2D_GROUP_RUN, "TracerProbes") : 0;
    if (count > count_of(state, SPH2D_GROUP_RUN, "TracerPlaces") / 2)
        count = 0; /* which is told as a wrong shape */
    if (!sph2d__tracers_reserve(sim, count))
        return false;
    sim->tracers.count = count;
    return true;
}

/** Particles are kept up to one more width or height outside the domain. */
static void check_positions(loader *l, const sph2d_sim *sim)
{
    const sph2d__store *f = &sim->system.fluid;
    sph2d_box d = sim->world.box;
    double reach = 100 * fmax(d.max.x - d.min.x, d.max.y - d.min.y);
    for (size_t i = 0; i < f->count; ++i)
        if (fabs(f->x[i] - d.min.x) > reach || fabs(f->y[i] - d.min.y) > reach) {
            refuse(l, "Coordinates", "has a position far outside the domain");
            return;
        }
}

/** The arrays are stored in the order of the cells; after a reordering the arrays that are not carried would not
 *  match. */
static bool in_cell_order(loader *l, const sph2d_sim *sim)
{
    for (size_t k = 0; k < sim->system.fluid.count; ++k)
        if (sim->system.fluid_cells.order[k] != k) {
            refuse(l, "Coordinates", "is not in the order of the cells");
            return false;
        }
    return true;
}

/** Whether a pointer of some strength may reach so far. */
static bool is_reach(double radius, double acceleration)
{
    return acceleration != 0 ? radius > 0 : radius >= 0;
}

/** Ranges that later code relies on. */
static void check_record(loader *l, const sph2d_sim *sim)
{
    const sph2d__record *r = &sim->record;
    if (!(r->time >= 0))
        refuse(l, "Time", "is below 0");
    if (!(r->next_step > 0))
        refuse(l, "NextTimeStep", "is not above 0");
    if (!(r->last_step >= 0))
        refuse(l, "LastTimeStep", "is below 0");
    if (!(r->older_step >= 0))
        refuse(l, "OlderTimeStep", "is below 0");
    if (!is_reach(r->pointer_radius, r->pointer_acceleration))
        refuse(l, "PointerRadius", "is not above 0");
    if (!is_reach(sim->acting.pointer_radius, sim->acting.pointer_acceleration))
        refuse(l, "ActingForces", "have a pointer's reach that is not above 0");
    if (r->next_limit >= SPH2D__LIMIT_COUNT)
        refuse(l, "NextLimit", "is out of range");
    if (r->isa < SPH2D_ISA_BASELINE || r->isa > SPH2D_ISA_AVX512 || !sph2d_isa_available((sph2d_isa)r->isa))
        refuse(l, "InstructionSet", "is not available on this processor or in this build");
    check_positions(l, sim);
    const sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count && l->ok; ++i) {
        if (!(f->density[i] > 0))
            refuse(l, "Densities", "has a value that is not above 0");
        else if (f->colored && f->color[i] > 0xffffff)
            refuse(l, "Colors", "has a value that is no colour");
    }
}

/** Bodies say where their boundary particles are. */
static bool load_bodies(loader *l, sph2d_sim *sim)
{
    if (sim->bodies.count == 0)
        return true;
    const sph2d__lent bodies = bodies_array(sim);
    const bool anew = sph2d__state_lacks_bodies(l->state);
    const sph2d_array *from = anew ? NULL : find_array(l, &bodies.array, bodies.array.count);
    if (from)
        copy_values(l, from, sim->bodies.states, 0);
    sph2d__bodies_stand(sim, sim->record.time);
    sph2d__bodies_know(sim, true); /* until the run goes on */
    return l->ok;
}

sph2d_status sph2d__sim_load(sph2d_sim *sim, const sph2d_state *state, sph2d_report *report)
{
    loader l = {state, report, true};
    if (state->version != SPH2D_STATE_VERSION) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_VERSION, NULL,
                         "the state has version %llu, this program reads %u", (unsigned long long)state->version,
                         SPH2D_STATE_VERSION);
        return SPH2D_FORMAT;
    }
    sph2d__store *fluid = &sim->system.fluid;
    size_t count = count_of(state, SPH2D_GROUP_FLUID, "Coordinates");
    if (count >= UINT32_MAX || !sph2d__store_reserve(fluid, &sim->memory, count > 0 ? count : 1))
        return SPH2D_NOMEM;
    fluid->count = count;
    if (!reserve_tracers(sim, state))
        return SPH2D_NOMEM;
    const sph2d__lent clock = run_array("Time", NULL, SPH2D_F64, 1, &sim->record.time);
    const sph2d_array *time = find_array(&l, &clock.array, 1);
    if (!time)
        return SPH2D_FORMAT;
    copy_values(&l, time, &sim->record.time, 0);
    if (!l.ok)
        return SPH2D_FORMAT;
    if (!load_bodies(&l, sim))
        return SPH2D_FORMAT;
    if (sph2d__sim_update_forcing(sim, sim->record.time) != SPH2D_OK)
        return SPH2D_NOMEM;
    bool walls = has_walls(state);
    if (walls && !walls_match(&l, sim))
        return SPH2D_FORMAT;
    sph2d__lent wanted[STATE_ARRAYS];
    size_t n = list_arrays(sim, wanted);
    for (size_t i = 0; i < n; ++i) {
        if (wanted[i].array.group == SPH2D_GROUP_WALL && !walls)
            continue;
        if (fluid->colored && wanted[i].data[0] == fluid->color && !sph2d__state_has_colors(state)) {
            set_colors(sim);
            continue;
        }
        if (strcmp(wanted[i].array.name, BODIES) == 0 && sph2d__state_lacks_bodies(state))
            continue;
        const sph2d_array *from = find_array(&l, &wanted[i].array, wanted[i].array.count);
        for (unsigned c = 0; from && c < from->components; ++c)
            copy_values(&l, from, wanted[i].data[c], c);
    }
    if (l.ok)
        check_record(&l, sim);
    if (!l.ok)
        return SPH2D_FORMAT;
    sim->system.isa = (sph2d_isa)sim->record.isa;
    if (!sph2d__cells_build(&sim->system.fluid_cells, fluid, sim->system.reach, &sim->memory))
        return SPH2D_NOMEM;
    return in_cell_order(&l, sim) ? SPH2D_OK : SPH2D_FORMAT;
}
