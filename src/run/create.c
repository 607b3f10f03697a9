/* SPDX-License-Identifier: MIT */
/** @file create.c
 *  Creates a simulation, new or from a state, and destroys it. */
#include <math.h>

#include "base/null.h"
#include "base/parallel.h"
#include "methods/hybrid/grid.h"
#include "methods/projection/body_rows.h"
#include "methods/terms/rheology.h"
#include "methods/wcsph/wcsph.h"
#include "probes/probes.h"
#include "run/run.h"
#include "scene/colors.h"
#include "scene/frame.h"
#include "scene/liquid.h"
#include "scene/method_table.h"
#include "scene/resolve.h"
#include "sim/device_steps.h"
#include "sim/stages.h"
#include "simd/isa.h"
#include "sph2d/device.h"
#include "start/start.h"

sph2d_sim_options sph2d_sim_options_default(void)
{
    return (sph2d_sim_options){.struct_size = sizeof(sph2d_sim_options)};
}

static sph2d_status check_options(const sph2d_sim_options *options, sph2d_report *report)
{
    if (options->struct_size != sizeof *options) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL,
                         "the options were not made by sph2d_sim_options_default() of this version");
        return SPH2D_INVALID;
    }
    if (options->threads < 0 || options->threads > 1024) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, NULL,
                         "%d threads are out of range: 1 to 1024, or 0 for as many as there are processors",
                         options->threads);
        return SPH2D_INVALID;
    }
    if (sph2d__isa_choose(options->isa) == SPH2D_ISA_AUTO) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_UNSUPPORTED, NULL,
                         "this processor or this build has no instruction set '%s'", sph2d_isa_name(options->isa));
        return SPH2D_INVALID;
    }
    if (options->device != 0 && options->isa > SPH2D_ISA_BASELINE) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_UNSUPPORTED, NULL,
                         "instruction set '%s' is the processor's: what a device does is what 'baseline' does",
                         sph2d_isa_name(options->isa));
        return SPH2D_INVALID;
    }
    return SPH2D_OK;
}

/* Cells are a quarter of the support radius wide, for fewer candidates; 1/2 and 1/8 took 5 % longer. Neighbour lists
 * are searched in blocks of candidates: there narrow cells save blocks only from this H/dx on, as below a range has two
 * blocks anyway. */
enum { COLUMNS = 4 };
static const double MIN_NARROW_RATIO = 2.8;

static void set_system(sph2d_sim *sim, const sph2d_sim_options *options)
{
    const sph2d_scene *scene = &sim->world.scene;
    const sph2d__derived d = sim->world.derived;
    const sph2d_box *box = &sim->world.box;
    sph2d__system *s = &sim->system;
    s->memory = &sim->memory;
    s->tables = &sim->tables;
    s->profile.phase = SPH2D_PHASE_COUNT;
    s->isa = options->device != 0 ? SPH2D_ISA_BASELINE : sph2d__isa_choose(options->isa);
    s->spacing = scene->spacing;
    s->support = d.support_radius;
    bool fitted = scene->method.name == SPH2D_METHOD_WCSPH && scene->method.operators == SPH2D_OPERATORS_FITTED;
    s->reach = d.reach;
    s->wall_reach = s->reach + (fitted ? s->spacing : 0); /* boundary particles whose surface is within the support */
    s->mass = d.mass;
    s->rest_density = scene->fluid.density;
    s->sound_speed = d.sound_speed;
    s->spring_head = d.spring_head;
    s->spring_energy = d.spring_energy;
    s->head = d.head > 0 ? d.head : scene->method.max_compression * s->sound_speed * s->sound_speed / 2;
    s->fills = sph2d__liquid_fills(&sim->world);
    s->liquid = &scene->fluid;
    s->viscosity = sph2d__rheology_viscosity(s->liquid, 0);
    s->method = scene->method;
    unsigned slips = sph2d__wall_slips(&sim->world);
    s->walls_rough = slips >> SPH2D_SLIP_NONE & 1;
    s->walls_smooth = slips >> SPH2D_SLIP_SMOOTH & 1;
    s->wall_slip = s->walls_smooth ? SPH2D_SLIP_SMOOTH : s->walls_rough ? SPH2D_SLIP_NONE : SPH2D_SLIP_FREE;
    s->slip_length = scene->slip_length;
    s->surface_tension = scene->fluid.surface_tension;
    sph2d__set unused = sim->method->unused ? sim->method->unused(&scene->method) : 0;
    s->fluid.carried = sim->method->carried & ~unused;
    sph2d__set friction = SPH2D__BIT(skin) | SPH2D__BIT(drag);
    bool lengths = s->walls_smooth || sim->method->surface_force;
    sph2d__set walls = sim->method->walls & ~(lengths ? 0 : friction);
    s->walls.carried = walls;
    s->fluid.has = sim->method->fluid & ~unused;
    s->fluid.colored = sph2d__has_colors(scene);
    s->walls.has = walls;
    s->fluid_cells.period = s->wall_cells.period =
        (sph2d__period){box->min.x, box->min.y, sph2d__period_x(scene), sph2d__period_y(scene)};
    bool wide = sim->method->project && s->reach < MIN_NARROW_RATIO * s->spacing;
    s->fluid_cells.columns = s->wall_cells.columns = wide ? 1 : COLUMNS;
    sph2d__forces_set(&s->forces, scene, s->sound_speed);
    sim->record.gravity_x = scene->gravity.x;
    sim->record.gravity_y = scene->gravity.y;
    sim->record.isa = s->isa;
}

static sph2d_status allocate_arrays(sph2d_sim *sim)
{
    const sph2d_scene *scene = &sim->world.scene;
    sim->points = sph2d__arena_alloc(&sim->arena, &sim->memory, scene->interaction_count + 1, sizeof *sim->points);
    sim->moving = sph2d__arena_alloc(&sim->arena, &sim->memory, sim->world.wall_count, sizeof *sim->moving);
    sim->source_rows = sph2d__arena_alloc(&sim->arena, &sim->memory, scene->source_count + 1, sizeof(uint64_t));
    sim->output_counts =
        sph2d__arena_alloc(&sim->arena, &sim->memory, SPH2D_OUTPUT_PROBE + scene->probe_count, sizeof(uint64_t));
    sim->wall_ids = sph2d__arena_alloc(&sim->arena, &sim->memory, sim->world.wall_count, sizeof *sim->wall_ids);
    sim->gauges = sph2d__arena_alloc(&sim->arena, &sim->memory, 2 * scene->probe_count + 1, sizeof(double));
    for (size_t i = 0; i < scene->probe_count; ++i)
        sim->gauges_lag |= scene->probes[i].kind == SPH2D_PROBE_PRESSURE && scene->probes[i].rise_time > 0;
    for (size_t i = 0; i < scene->probe_count && !sim->tracers.particles; ++i)
        if (scene->probes[i].kind == SPH2D_PROBE_TRACER) {
            sim->tracers.particles =
                sph2d__arena_alloc(&sim->arena, &sim->memory, scene->probe_count, sizeof(uint64_t));
            if (!sim->tracers.particles)
                return SPH2D_NOMEM;
        }
    sim->system.points_room = (scene->interaction_count + 1) * sizeof *sim->points;
    bool ok = sim->gauges && sim->points && sim->moving && sim->wall_ids && sim->source_rows && sim->output_counts;
    return ok ? SPH2D_OK : SPH2D_NOMEM;
}

/** Sets what a method needs that depends on the scene alone. */
static sph2d_status prepare(sph2d_sim *sim)
{
    sim->method->prepare(&sim->system);
    return !sim->method->set_sides || sim->method->set_sides(sim) ? SPH2D_OK : SPH2D_NOMEM;
}

/** Places the fluid of a new simulation and evaluates its first forces and extremes. */
static sph2d_status start_new(sph2d_sim *sim, sph2d_report *report)
{
    sph2d_status status = sph2d__sim_place_fluid(sim, report);
    if (status != SPH2D_OK)
        return status;
    status = prepare(sim);
    if (status == SPH2D_OK)
        status = sph2d__sim_update_forcing(sim, 0);
    if (status != SPH2D_OK)
        return status;
    if (sim->system.fluid.filling)
        for (size_t i = 0; i < sim->system.fluid.count; ++i)
            sim->system.fluid.filling[i] = 1; /* no step has computed it yet: blocks count as bulk */
    if (!sim->method->evaluate(&sim->system))
        return SPH2D_NOMEM;
    if (!sim->method->mean_forces) { /* pressures of the others are those of a step */
        sph2d__bodies_start(sim);
        sim->loads.watched = sph2d__sim_momentum_is_known(sim); /* in the first step */
        sph2d__loads_find(sim, 1);
    }
    sph2d_summary start;
    sim->record.energy_elastic = INFINITY;
    sph2d__sim_sum_energy(sim, &start);
    sim->record.energy_start = sim->record.energy_low = start.kinetic + start.potential + start.elastic + start.bodies;
    sim->record.energy_elastic = start.elastic;
    sim->record.kinetic_max = start.kinetic;
    sim->record.energy_held = sph2d__method_row_of(&sim->system.method)->summed_density ? start.elastic : 0;
    sph2d__sim_start_gauges(sim);
    sph2d__tracers_choose(sim);
    return sph2d__sim_measure(sim, report) ? SPH2D_OK : SPH2D_SCENE;
}

/** Continues from a state, which contains density, pressure and acceleration. */
static sph2d_status start_restored(sph2d_sim *sim, const sph2d_state *state, sph2d_report *report)
{
    sph2d_status status = prepare(sim);
    if (status == SPH2D_OK)
        status = sph2d__sim_load(sim, state, report);
    if (status != SPH2D_OK)
        return status;
    if (!sph2d__rheology_set(&sim->system))
        return SPH2D_NOMEM;
    status = sph2d__sim_repeat_forcing(sim, sim->record.time);
    sph2d__sim_steer(sim);
    sph2d__bodies_know(sim, false);
    double time = sim->record.time; /* obstacles are where the last step left them */
    sph2d__sim_set_drift_interval(sim, time, time);
    if (status == SPH2D_OK && sim->bodies.count > 0 && sph2d__state_lacks_bodies(state))
        sph2d__sim_book_new_bodies(sim);
    return status;
}

/** Checks and resolves the scene, and sets the system, before anything is placed. */
static sph2d_status set_up(sph2d_sim *sim, const sph2d_scene *scene, const sph2d_sim_options *options, bool started,
                           sph2d_report *report)
{
    sph2d_status status = sph2d__world_make(&sim->world, scene, started, &sim->arena, &sim->memory, report);
    if (status != SPH2D_OK)
        return status;
    size_t bends = sph2d__tank_bends(&sim->world.scene);
    sph2d_pose_point *points = bends ? sph2d__arena_alloc(&sim->arena, &sim->memory, bends, sizeof *points) : NULL;
    if (bends && !points)
        return SPH2D_NOMEM;
    sim->tank = sph2d__tank_course(&sim->world.scene, points);
    sim->method = sph2d__method_find(&sim->world.scene.method);
    set_system(sim, options);
    return SPH2D_OK;
}

static sph2d_status build(sph2d_sim *sim, const sph2d_scene *scene, const sph2d_sim_options *options,
                          const sph2d_state *state, sph2d_report *report)
{
    sph2d_status status = set_up(sim, scene, options, state != NULL, report);
    if (status != SPH2D_OK)
        return status;
    if (!state && sph2d__sim_is_too_large(sim, report))
        return SPH2D_SCENE;
    const char *refused = options->device != 0 ? sph2d_device_refuses(&sim->world.scene) : NULL;
    if (refused) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_UNSUPPORTED, NULL, "no device takes this scene: %s", refused);
        return SPH2D_SCENE;
    }
    if (state && sph2d__state_has_colors(state)) /* of particles whose file is not there any more, too */
        sim->system.fluid.colored = true;
    sim->threads = options->threads;
    sph2d__prepare_threads();
    status = allocate_arrays(sim);
    if (status == SPH2D_OK)
        status = sph2d__sim_place_walls(sim, report);
    if (status == SPH2D_OK)
        status = sph2d__bodies_create(sim);
    if (status == SPH2D_OK)
        status = sph2d__loads_create(sim);
    if (status == SPH2D_OK)
        status = sph2d__openings_create(sim);
    if (status == SPH2D_OK)
        status = state ? start_restored(sim, state, report) : start_new(sim, report);
    if (options->device != 0) /* a state may be of another one */
        sim->record.isa = sim->system.isa = SPH2D_ISA_BASELINE;
    if (status == SPH2D_OK && !sph2d__outlines_create(sim))
        status = SPH2D_NOMEM;
    if (status == SPH2D_OK)
        sph2d__sim_make_plan(sim);
    if (status == SPH2D_OK && options->device != 0)
        status = sph2d__device_start(sim, options->device, options->same_bits, report);
    return status;
}

static sph2d_sim *new_sim(const sph2d_sim_options *options)
{
    sph2d__memory memory = sph2d__memory_from(options->allocator);
    sph2d_sim *sim = sph2d__alloc(&memory, 1, sizeof *sim);
    if (sim)
        sim->memory = memory;
    return sim;
}

static sph2d_status create(const sph2d_scene *scene, const sph2d_sim_options *options, const sph2d_state *state,
                           sph2d_sim **out, sph2d_report *report)
{
    sph2d_sim_options defaults = sph2d_sim_options_default();
    options = options ? options : &defaults;
    sph2d_status status = check_options(options, report);
    if (status != SPH2D_OK)
        return status;
    sph2d_sim *sim = new_sim(options);
    status = sim ? build(sim, scene, options, state, report) : SPH2D_NOMEM;
    if (status == SPH2D_NOMEM)
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory while making the simulation");
    if (status != SPH2D_OK) {
        sph2d_sim_destroy(sim);
        return status;
    }
    sim->system.profile.on = options->profile;
    *out = sim;
    return SPH2D_OK;
}

sph2d_status sph2d_sim_create(const sph2d_scene *scene, const sph2d_sim_options *options, sph2d_sim **sim,
                              sph2d_report *report)
{
    if (!sim)
        return sph2d__null(report, __func__, "sim");
    *sim = NULL;
    if (!scene)
        return sph2d__null(report, __func__, "scene");
    return create(scene, options, NULL, sim, report);
}

sph2d_status sph2d_sim_restore(const sph2d_scene *scene, const sph2d_sim_options *options, const sph2d_state *state,
                               sph2d_sim **sim, sph2d_report *report)
{
    if (!sim)
        return sph2d__null(report, __func__, "sim");
    *sim = NULL;
    if (!scene)
        return sph2d__null(report, __func__, "scene");
    if (!state)
        return sph2d__null(report, __func__, "state");
    if (!state->arrays && state->array_count > 0)
        return sph2d__null(report, __func__, "state->arrays");
    return create(scene, options, state, sim, report);
}

void sph2d_sim_destroy(sph2d_sim *sim)
{
    if (!sim)
        return;
    sph2d__memory *memory = &sim->memory;
    sph2d__system *s = &sim->system;
    sph2d__device_end(sim);
    sph2d__store_free(&s->fluid, memory);
    sph2d__store_free(&s->walls, memory);
    sph2d__cells_free(&s->fluid_cells, memory);
    sph2d__cells_free(&s->wall_cells, memory);
    sph2d__neighbours_free(&s->neighbours, memory);
    sph2d__neighbours_free(&s->wall_neighbours, memory);
    sph2d__body_pairs_free(&s->body_pairs, memory);
    void *blocks[3] = {sim->to_remove, sim->state_arrays, sim->system.viscosities};
    sph2d__release(memory, &blocks[0], sim->to_remove_capacity, 1);
    sph2d__release(memory, &blocks[2], sim->system.viscosity_capacity, sizeof(double));
    sph2d__release(memory, &blocks[1], sim->state_capacity, sizeof(sph2d_array));
    sph2d__tracers_free(sim);
    sph2d__grid_free(s);
    sph2d__frozen_free(s);
    sph2d__barrier_free(&sim->barrier, memory);
    for (size_t k = 0; k < sim->moving_count; ++k)
        sph2d__barrier_free(&sim->moving[k].barrier, memory);
    sph2d__arena_free(&sim->arena, memory);
    sph2d__memory last = *memory; /* the simulation contains its own allocator */
    void *block = sim;
    sph2d__release(&last, &block, 1, sizeof *sim);
}

sph2d_status sph2d_scene_fits(const sph2d_scene *scene, sph2d_report *report)
{
    if (!scene)
        return sph2d__null(report, __func__, "scene");
    sph2d_sim_options options = sph2d_sim_options_default();
    sph2d_sim *sim = new_sim(&options);
    sph2d_status status = sim ? set_up(sim, scene, &options, false, report) : SPH2D_NOMEM;
    if (status == SPH2D_OK && sph2d__sim_is_too_large(sim, report))
        status = SPH2D_SCENE;
    sph2d_sim_destroy(sim);
    return status;
}

sph2d_status sph2d_scene_plan(const sph2d_scene *scene, sph2d_plan *plan, sph2d_report *report)
{
    if (!scene)
        return sph2d__null(report, __func__, "scene");
    if (!plan)
        return sph2d__null(report, __func__, "plan");
    sph2d_sim *sim = NULL;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1; /* more threads would add to the memory */
    sph2d_status status = sph2d_sim_create(scene, &options, &sim, report);
    if (status == SPH2D_OK)
        *plan = sim->plan;
    sph2d_sim_destroy(sim);
    return status;
}
