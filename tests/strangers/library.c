/* SPDX-License-Identifier: MIT */
/* A run in this process, with a look at every step. */
#include <math.h>
#include <string.h>

#include <sph2d/contacts.h>
#include <sph2d/state.h>

#include "judge.h"

static const double pi = 3.14159265358979323846;

/** What is watched while a scene runs. */
typedef struct watch {
    const sph2d_scene *scene;
    sph2d_sim *sim;
    verdict *verdict;
    bool energy, ruined, walls_rest;
    double lowest, held; // least energy; of pcisph, whose solver stores nothing, least elastic energy
    double taken;        // most energy that contacts have taken
    char overlap[200];   // what overlaps deepest
} watch;

/** Finite, and of a density that a liquid can have. */
static void look_at_particles(watch *w, library_run *run)
{
    const sph2d_view f = sph2d_sim_fluid(w->sim);
    const bool integrated = w->scene->method.name == SPH2D_METHOD_WCSPH;
    bool compressed = w->scene->method.name == SPH2D_METHOD_HYBRID; // for a moment, where two are on one spot
    for (size_t i = 0; i < w->scene->block_count; ++i)
        compressed = compressed || w->scene->blocks[i].spacing > 0;
    for (size_t i = 0; i < f.count && !w->ruined; ++i) {
        const double r = f.density[i] / w->scene->fluid.density;
        run->compression_max = fmax(run->compression_max, r - 1);
        run->fastest = fmax(run->fastest, hypot(f.vx[i], f.vy[i]));
        if (!isfinite(f.x[i] + f.y[i] + f.vx[i] + f.vy[i] + f.ax[i] + f.ay[i] + f.pressure[i] + r)) {
            verdict_fail(w->verdict, "finite", "particle %llu has a value that is not finite at t = %g s, step %llu",
                         (unsigned long long)f.id[i], sph2d_sim_time(w->sim),
                         (unsigned long long)sph2d_sim_steps(w->sim));
            w->ruined = true;
        } else if (r <= 0 || (integrated && r < DENSITY_LOW) || (!compressed && r > DENSITY_HIGH)) {
            verdict_fail(w->verdict, "density",
                         "particle %llu at (%g, %g) has %g times the rest density at t = %g s, step %llu, and the run "
                         "goes on",
                         (unsigned long long)f.id[i], f.x[i], f.y[i], r, sph2d_sim_time(w->sim),
                         (unsigned long long)sph2d_sim_steps(w->sim));
            w->ruined = true;
        }
    }
}

/** The pressures by which particles act, which are part of the state; `reported` where there are no others. */
static const double *acting_pressure(sph2d_sim *sim, const double *reported)
{
    const sph2d_state state = sph2d_sim_state(sim);
    for (size_t i = 0; i < state.array_count; ++i)
        if (state.arrays[i].group == SPH2D_GROUP_FLUID && strcmp(state.arrays[i].name, "ActingPressures") == 0)
            return state.arrays[i].data[0];
    return reported;
}

static void look_at_energy(watch *w, library_run *run)
{
    const sph2d_summary s = sph2d_sim_summary(w->sim);
    // What leaves takes its energy along, but a surface under tension is nobody's: it closes behind what left.
    for (int side = 0; side < 4 && w->scene->fluid.surface_tension > 0; ++side)
        w->energy = w->energy && s.left_open[side] == 0;
    if (!w->energy)
        return;
    sph2d_view fluid = sph2d_sim_fluid(w->sim);
    const sph2d_plan *plan = sph2d_sim_plan(w->sim);
    const bool projected = w->scene->method.name == SPH2D_METHOD_PCISPH;
    if (projected)
        fluid.pressure = acting_pressure(w->sim, fluid.pressure);
    const bool pairs = w->scene->method.name == SPH2D_METHOD_CONSTRAINT ||
                       (w->scene->method.name == SPH2D_METHOD_WCSPH &&
                        w->scene->method.operators == SPH2D_OPERATORS_VARIATIONAL); // close ones have energy, too
    double elastic = w->scene->method.name == SPH2D_METHOD_HYBRID ? 0
                     : pairs                                      ? s.elastic
                     : projected ? held_energy(w->scene, plan, &fluid, sph2d_sim_steps(w->sim) == 0)
                                 : elastic_energy(w->scene, plan, &fluid);
    if (w->scene->method.name == SPH2D_METHOD_PCISPH)
        elastic = w->held = fmin(w->held, elastic);
    // Forces in such a scene are dampers of springs, which take, and gaps too thin for liquid, which presses on bodies there.
    const double gaps = fmax(0, fmin(GAPS_BOUND * run->scale, s.energy_forces));
    const double energy = s.kinetic + s.potential + s.bodies - s.energy_fed + elastic - gaps;
    w->taken = fmax(w->taken, s.energy_contacts);
    run->taken = fmax(run->taken, (w->taken - s.energy_contacts) / run->scale);
    w->lowest = fmin(w->lowest, energy);
    const double rise = (energy - w->lowest) / run->scale;
    if (rise > run->rise) {
        run->rise = rise;
        run->since = s.time;
    }
}

/** Finite, and clear of each other and of walls at rest. */
static void look_at_bodies(watch *w, library_run *run)
{
    if (w->scene->body_count == 0 || w->ruined)
        return;
    if (!bodies_are_finite(w->scene, w->sim)) {
        verdict_fail(w->verdict, "finite", "a body has a value that is not finite at t = %g s, step %llu",
                     sph2d_sim_time(w->sim), (unsigned long long)sph2d_sim_steps(w->sim));
        w->ruined = true;
        return;
    }
    char text[200];
    const double depth = w->walls_rest ? bodies_overlap(w->scene, w->sim, text) / w->scene->spacing : 0;
    if (depth > run->overlap) {
        run->overlap = depth;
        snprintf(w->overlap, sizeof w->overlap, "%s at t = %g s", text, sph2d_sim_time(w->sim));
    }
}

// ---- walls ---------------------------------------------------------------------------------------------------------

static sph2d_vec2 displacement(const sph2d_motion *m, double t)
{
    sph2d_vec2 at = {0, 0};
    const sph2d_pose_path *path = &m->path;
    for (size_t i = 0; i < path->count; ++i) {
        const sph2d_pose_point *b = &path->items[i], *a = i > 0 ? b - 1 : b;
        if (i > 0 && t < b->t) {
            const double part = fmax(0, (t - a->t) / (b->t - a->t));
            at = (sph2d_vec2){a->x + part * (b->x - a->x), a->y + part * (b->y - a->y)};
            break;
        }
        at = (sph2d_vec2){b->x, b->y};
    }
    const double swing = sin(2 * pi * m->frequency * t + m->phase) - sin(m->phase);
    return (sph2d_vec2){at.x + m->amplitude.x * swing, at.y + m->amplitude.y * swing};
}

/** Particles inside closed obstacles, deeper than a fifth of a spacing: circles are chains of boundary particles. */
static size_t count_inside(const sph2d_scene *s, const sph2d_sim *sim)
{
    const sph2d_view f = sph2d_sim_fluid(sim);
    const double skin = 0.2 * s->spacing;
    size_t count = 0;
    for (size_t k = 0; k < s->obstacle_count; ++k) {
        const sph2d_shape *o = &s->obstacles[k].shape;
        const sph2d_vec2 moved = displacement(&s->obstacles[k].motion, sph2d_sim_time(sim));
        const sph2d_vec2 c = o->kind == SPH2D_SHAPE_CIRCLE
                                 ? o->circle.center
                                 : (sph2d_vec2){(o->box.min.x + o->box.max.x) / 2, (o->box.min.y + o->box.max.y) / 2};
        const double angle = s->obstacles[k].motion.rate * sph2d_sim_time(sim), co = cos(angle), si = sin(angle);
        for (size_t i = 0; i < f.count; ++i) {
            const double rx = f.x[i] - moved.x - c.x, ry = f.y[i] - moved.y - c.y;
            const double x = c.x + co * rx + si * ry, y = c.y + co * ry - si * rx;
            if (o->kind == SPH2D_SHAPE_CIRCLE)
                count += hypot(x - o->circle.center.x, y - o->circle.center.y) < o->circle.radius - skin;
            else if (o->kind == SPH2D_SHAPE_BOX)
                count += x > o->box.min.x + skin && x < o->box.max.x - skin && y > o->box.min.y + skin &&
                         y < o->box.max.y - skin;
        }
    }
    return count;
}

/** Whether a side is a wall without openings: behind these are reservoirs. */
static bool is_shut(const sph2d_scene *s, sph2d_side_name side)
{
    const sph2d_side kinds[] = {s->boundary.left, s->boundary.right, s->boundary.bottom, s->boundary.top};
    bool shut = kinds[side] == SPH2D_SIDE_WALL;
    for (size_t i = 0; i < s->opening_count; ++i)
        shut = shut && s->openings[i].side != side;
    return shut;
}

/** Nothing passes a wall: neither a side of the domain nor a closed obstacle. */
static void look_behind_walls(const watch *w, size_t inside_at_start)
{
    const sph2d_view f = sph2d_sim_fluid(w->sim);
    const bool left = is_shut(w->scene, SPH2D_SIDE_NAME_LEFT), right = is_shut(w->scene, SPH2D_SIDE_NAME_RIGHT);
    const bool bottom = is_shut(w->scene, SPH2D_SIDE_NAME_BOTTOM), top = is_shut(w->scene, SPH2D_SIDE_NAME_TOP);
    const sph2d_box *box = &w->scene->domain;
    const double skin = 1e-3 * w->scene->spacing;
    for (size_t i = 0; i < f.count; ++i) {
        // Beside an open side walls go on for one domain more; beyond that liquid is removed, before the next step.
        const bool gone =
            (!left && f.x[i] < 2 * box->min.x - box->max.x) || (!right && f.x[i] > 2 * box->max.x - box->min.x) ||
            (!bottom && f.y[i] < 2 * box->min.y - box->max.y) || (!top && f.y[i] > 2 * box->max.y - box->min.y);
        if (gone)
            continue;
        if ((left && f.x[i] < box->min.x - skin) || (right && f.x[i] > box->max.x + skin) ||
            (bottom && f.y[i] < box->min.y - skin) || (top && f.y[i] > box->max.y + skin)) {
            verdict_fail(w->verdict, "walls", "particle %llu is at (%g, %g), behind a side that is a wall",
                         (unsigned long long)f.id[i], f.x[i], f.y[i]);
            break;
        }
    }
    if (w->scene->source_count == 0) {
        const size_t inside = count_inside(w->scene, w->sim);
        if (inside > inside_at_start)
            verdict_fail(w->verdict, "walls", "%zu particles are inside closed obstacles, %zu were at the start",
                         inside, inside_at_start);
        const size_t in_bodies = particles_in_bodies(w->scene, w->sim, INSIDE_BOUND * w->scene->spacing);
        if (in_bodies > 0 && !w->ruined)
            verdict_fail(w->verdict, "walls", "%zu particles are inside bodies", in_bodies);
    }
}

// ---- the whole -----------------------------------------------------------------------------------------------------

static void judge_end(const watch *w, library_run *run, size_t inside_at_start)
{
    look_behind_walls(w, inside_at_start);
    if (isfinite(run->rise) &&
        run->rise > (w->scene->method.name == SPH2D_METHOD_HYBRID ? GRID_ENERGY_BOUND : ENERGY_BOUND))
        verdict_fail(w->verdict, "energy", "kinetic + potential + elastic rises by %.3g %% of %.4g J/m until t = %g s",
                     100 * run->rise, run->scale, run->since);
    if (isfinite(run->rise) && run->taken > CONTACTS_BOUND)
        verdict_fail(w->verdict, "energy", "contacts gave %.3g %% of %.4g J/m", 100 * run->taken, run->scale);
    if (run->overlap > OVERLAP_BOUND)
        verdict_fail(w->verdict, "bodies", "%s overlap by %.3g spacings", w->overlap, run->overlap);
    measure_packing(w->scene, w->sim, run);
    if (fabs(run->packing - run->density) > PACKING_BOUND + PACKING_SLACK * fabs(run->density - 1))
        verdict_fail(w->verdict, "packing", "mean density inside is %.4f of rest density by counting, %.4f as reported",
                     run->packing, run->density);
    if (run->summary.compression_max < run->compression_max * (1 - 1e-6) - 1e-9)
        verdict_fail(w->verdict, "compression", "the summary tells a maximum of %g %%, a particle had %g %%",
                     100 * run->summary.compression_max, 100 * run->compression_max);
}

static sph2d_isa isa_of_name(const char *name)
{
    for (sph2d_isa isa = SPH2D_ISA_BASELINE; isa <= SPH2D_ISA_AVX512; ++isa)
        if (strcmp(name, sph2d_isa_name(isa)) == 0)
            return isa;
    return SPH2D_ISA_AUTO;
}

library_run judge_by_library(const judge_request *request, const sph2d_scene *scene, verdict *v, sph2d_sim **sim)
{
    library_run run = {.rise = NAN, .packing = NAN, .density = NAN, .p99 = NAN, .highest = NAN};
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    options.isa = isa_of_name(request->isa);
    *sim = NULL;
    if (sph2d_sim_create(scene, &options, sim, NULL) != SPH2D_OK || sph2d_contacts_attach(*sim) != SPH2D_OK)
        return run;
    run.started = true;
    run.opened = scene->opening_count > 0;
    run.scale = energy_scale(scene, *sim);
    watch w = {.scene = scene, .sim = *sim, .verdict = v, .lowest = INFINITY, .held = INFINITY};
    w.energy = scene_is_closed(scene);
    w.walls_rest = walls_are_at_rest(scene);
    if (w.energy)
        run.rise = 0;
    const size_t inside = count_inside(scene, *sim);
    look_at_particles(&w, &run);
    look_at_energy(&w, &run);
    sph2d_status status = SPH2D_OK;
    while (status == SPH2D_OK && sph2d_sim_time(*sim) < scene->run.until) {
        status = sph2d_sim_step(*sim, NULL);
        look_at_particles(&w, &run);
        look_at_energy(&w, &run);
        look_at_bodies(&w, &run);
    }
    run.finished = status == SPH2D_OK;
    run.summary = sph2d_sim_summary(*sim);
    judge_end(&w, &run, inside);
    return run;
}
