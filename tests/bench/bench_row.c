/* SPDX-License-Identifier: MIT */
/** @file bench_row.c
 *  Measuring one scene, and printing what came out. */
#include <math.h>
#include <string.h>

#include "bench.h"

/** Takes steps; false when one fails. */
static bool take_steps(sph2d_sim *sim, int steps, double *sum, sph2d_report *report)
{
    for (int k = 0; k < steps; ++k) {
        *sum += sph2d_sim_time_step(sim);
        if (sph2d_sim_step(sim, report) != SPH2D_OK)
            return false;
    }
    return true;
}

static bool complain(const bench_job *job, const sph2d_report *report)
{
    fprintf(stderr, "bench: %s with %g particles: %s\n", job->scene->name, job->particles,
            report->count > 0 ? report->items[0].message : "failed");
    return false;
}

/* Steps before the first that counts, so that the start is over. */
enum { WARM_UP = 20 };

static sph2d_sim *make(const bench_job *job, sph2d_report *report)
{
    sph2d_scene scene = sph2d_scene_default();
    sph2d_block block = sph2d_block_default();
    sph2d_sim_options options = sph2d_sim_options_default();
    sph2d_sim *sim = NULL;
    job->scene->make(&scene, &block, job->particles);
    scene.blocks = &block;
    scene.block_count = 1;
    scene.run.until = 100;
    options.threads = job->threads;
    options.isa = job->isa;
    options.device = job->device;
    options.profile = true;
    return sph2d_sim_create(&scene, &options, &sim, report) == SPH2D_OK ? sim : NULL;
}

static sph2d_profile less(sph2d_profile a, const sph2d_profile *b)
{
    for (int k = 0; k < SPH2D_PHASE_COUNT; ++k) {
        a.wall[k] -= b->wall[k];
        a.cpu[k] -= b->cpu[k];
        a.calls[k] -= b->calls[k];
    }
    return a;
}

bool bench_measure(const bench_job *job, bench_row *row)
{
    sph2d_report report = {0};
    double time = 0;
    sph2d_sim *sim = make(job, &report);
    if (!sim || !take_steps(sim, WARM_UP, &time, &report)) {
        sph2d_sim_destroy(sim);
        return complain(job, &report);
    }
    *row = (bench_row){.job = *job, .cpu = INFINITY, .wall = INFINITY};
    time = 0;
    const sph2d_device_use start = sph2d_sim_device_use(sim);
    for (int run = 0; run < job->runs; ++run) {
        sph2d_profile before = sph2d_sim_profile(sim);
        double wall = bench_wall(), cpu = bench_cpu();
        if (!take_steps(sim, job->steps, &time, &report)) {
            sph2d_sim_destroy(sim);
            return complain(job, &report);
        }
        wall = bench_wall() - wall;
        cpu = bench_cpu() - cpu;
        row->wall = fmin(row->wall, wall);
        if (cpu < row->cpu) {
            row->cpu = cpu;
            row->profile = less(sph2d_sim_profile(sim), &before);
        }
    }
    row->use = sph2d_sim_device_use(sim);
    row->use.launches -= start.launches;
    row->use.waits -= start.waits;
    row->use.sent -= start.sent;
    row->use.fetched -= start.fetched;
    const sph2d_plan *plan = sph2d_sim_plan(sim);
    row->summary = sph2d_sim_summary(sim);
    row->particles = sph2d_sim_fluid(sim).count;
    row->memory = job->device > 0 ? sph2d_sim_device_memory(sim) : sph2d_sim_memory(sim);
    row->isa = sph2d_sim_isa(sim);
    row->particle_steps = (double)row->particles * job->steps;
    row->neighbours = row->summary.neighbours;
    row->carried = plan->sound_speed * time / (job->steps * job->runs) / sph2d_sim_scene(sim)->spacing;
    sph2d_sim_destroy(sim);
    return true;
}

double bench_traversals(const bench_row *row)
{
    const sph2d_summary *s = &row->summary;
    double sums = (double)(row->profile.calls[SPH2D_PHASE_SEARCH] + row->profile.calls[SPH2D_PHASE_DENSITY] +
                           row->profile.calls[SPH2D_PHASE_FORCES]);
    return sums / row->job.steps + 2 * (double)s->iterations / (double)s->steps;
}

/* ---- printing ---------------------------------------------------------------------------------------------------- */

/** A column: its name and how wide it is in a table; negative for what stands at the left. */
typedef struct column {
    const char *name;
    int width, digits;
} column;

enum { TEXTS = 2, COLUMNS = 24, OF_DEVICE = 4 };
static const column columns[COLUMNS + OF_DEVICE] = {
    {"scene", -11, 0},        {"isa", -8, 0},          {"threads", 7, 0},   {"particles", 9, 0},
    {"neighbours", 10, 1},    {"M/s", 6, 2},           {"M/CPU s", 7, 2},   {"c dt/dx", 7, 3},
    {"carried M/s", 11, 2},   {"Mpairs/CPU s", 12, 0}, {"ns/pair", 7, 2},   {"traversals", 10, 1},
    {"ns/traversal", 12, 1},  {"move %", 6, 0},        {"sort %", 6, 0},    {"walls %", 7, 0},
    {"search %", 8, 0},       {"density %", 9, 0},     {"forces %", 8, 0},  {"solve %", 7, 0},
    {"bookkeeping %", 13, 0}, {"B/particle", 10, 0},   {"of peak %", 9, 1}, {"of memory %", 11, 1},
    {"launches", 8, 1},       {"waits", 6, 1},         {"B sent", 9, 0},    {"B fetched", 9, 0},
};

/* By form. */
static const char *const between[] = {"  ", ",", ", "};

static void fill(const bench_row *row, const bench_machine *machine, double values[COLUMNS + OF_DEVICE])
{
    double pairs = row->particle_steps * row->neighbours, all = 0, traversals = bench_traversals(row);
    for (int k = 0; k < SPH2D_PHASE_COUNT; ++k)
        all += row->profile.cpu[k];
    double rate = row->particle_steps / row->wall / 1e6;
    double other[] = {row->job.threads,
                      (double)row->particles,
                      row->neighbours,
                      rate,
                      row->particle_steps / row->cpu / 1e6,
                      row->carried,
                      rate * row->carried,
                      pairs / row->cpu / 1e6,
                      1e9 * row->cpu / pairs,
                      traversals,
                      1e9 * row->cpu / row->particle_steps / traversals};
    memcpy(values + TEXTS, other, sizeof other);
    for (int k = 0; k < SPH2D_PHASE_COUNT; ++k)
        values[13 + k] = 100 * row->profile.cpu[k] / all;
    values[21] = (double)row->memory / (double)row->particles;
    values[22] = 100 * pairs * row->job.scene->flops / row->wall / machine->flops;
    values[23] = 100 * row->particle_steps * 8 * row->job.scene->doubles / row->wall / machine->bandwidth;
    const double steps = (double)row->job.steps * row->job.runs;
    values[24] = (double)row->use.launches / steps;
    values[25] = (double)row->use.waits / steps;
    values[26] = (double)row->use.sent / steps;
    values[27] = (double)row->use.fetched / steps;
}

void bench_print_head(FILE *out, bench_form form, bool device)
{
    if (form == BENCH_JSON)
        return;
    for (int k = 0; k < COLUMNS + (device ? OF_DEVICE : 0); ++k)
        fprintf(out, "%s%*s", k > 0 ? between[form] : "", form == BENCH_CSV ? 0 : columns[k].width, columns[k].name);
    fputc('\n', out);
}

void bench_print(FILE *out, bench_form form, const bench_row *row, const bench_machine *machine)
{
    const char *texts[TEXTS] = {row->job.scene->name, sph2d_isa_name(row->isa)};
    double values[COLUMNS + OF_DEVICE];
    fill(row, machine, values);
    for (int k = 0; k < COLUMNS + (row->job.device > 0 ? OF_DEVICE : 0); ++k) {
        const column *c = &columns[k];
        fputs(k > 0 ? between[form] : form == BENCH_JSON ? "{" : "", out);
        if (form == BENCH_JSON)
            fprintf(out, "\"%s\": ", c->name);
        if (form == BENCH_TABLE && k < TEXTS)
            fprintf(out, "%*s", c->width, texts[k]);
        else if (k < TEXTS)
            fprintf(out, form == BENCH_JSON ? "\"%s\"" : "%s", texts[k]);
        else if (form == BENCH_TABLE)
            fprintf(out, "%*.*f", c->width, c->digits, values[k]);
        else
            fprintf(out, "%.6g", values[k]);
    }
    fputs(form == BENCH_JSON ? "}\n" : "\n", out);
    fflush(out);
}
