/* SPDX-License-Identifier: MIT */
/** @file library.c
 *  A program on the libraries alone: every allocation, write and thread of it may fail. It prints what it computed and
 *  ends with 0; or it says which status a call returned and ends with 70, or, for a file, with 74. Its own allocator
 *  must have everything back in any case. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sph2d/io.h>
#include <sph2d/sph2d.h>
#include <sph2d/study_results.h>

/** Bytes that the simulations hold. */
static size_t held;

static void *resize(void *user, void *block, size_t old_size, size_t new_size)
{
    (void)user;
    void *fresh = NULL;
    if (new_size > 0) {
        fresh = aligned_alloc(64, (new_size + 63) / 64 * 64);
        if (!fresh)
            return NULL;
        if (block)
            memcpy(fresh, block, old_size < new_size ? old_size : new_size);
    }
    free(block);
    held += new_size - old_size;
    return fresh;
}

static sph2d_report report;
static uint64_t hash = 14695981039346656037u;

static void add(const void *bytes, size_t size)
{
    for (size_t i = 0; i < size; ++i)
        hash = (hash ^ ((const unsigned char *)bytes)[i]) * 1099511628211u;
}

/** Asks a simulation for everything, also when a step has failed. */
static void read_sim(sph2d_sim *sim)
{
    sph2d_view v = sph2d_sim_fluid(sim);
    add(v.x, v.count * sizeof *v.x);
    add(v.density, v.count * sizeof *v.density);
    sph2d_summary summary = sph2d_sim_summary(sim);
    add(&summary.kinetic, sizeof summary.kinetic);
    add(&summary.neighbours, sizeof summary.neighbours);
    sph2d_sample sample;
    sph2d_sim_sample(sim, (sph2d_vec2){0.1, 0.1}, &sample);
    add(&sample, sizeof sample);
    sph2d_body_state body = sph2d_sim_body(sim, 0);
    add(&body, sizeof body);
}

static sph2d_status steps(sph2d_sim *sim, int count)
{
    sph2d_status status = SPH2D_OK;
    for (int n = 0; n < count && status == SPH2D_OK; ++n)
        status = sph2d_sim_step(sim, &report);
    read_sim(sim);
    return status;
}

/** Half of a run, and the other half from its state, on two threads. */
static sph2d_status run(const sph2d_scene *scene)
{
    enum { STEPS = 8 };
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 2;
    options.allocator.resize = resize;
    sph2d_sim *sim = NULL, *other = NULL;
    sph2d_status status = sph2d_sim_create(scene, &options, &sim, &report);
    if (status == SPH2D_OK)
        status = steps(sim, STEPS);
    double values[SPH2D_PROBE_MAX_COLUMNS] = {0};
    if (status == SPH2D_OK && sph2d_sim_probe(sim, 0, values) == 0)
        status = SPH2D_NOMEM;
    add(values, sizeof values);
    if (status == SPH2D_OK) {
        sph2d_state state = sph2d_sim_state(sim);
        status = state.arrays ? sph2d_sim_restore(scene, &options, &state, &other, &report) : SPH2D_NOMEM;
    }
    if (status == SPH2D_OK)
        status = steps(other, STEPS);
    sph2d_sim_destroy(sim);
    sph2d_sim_destroy(other);
    return status;
}

/** A series written, continued and read. */
static sph2d_status write_files(void)
{
    static const sph2d_table_column columns[] = {{"time", "s", false}, {"a", NULL, false}};
    sph2d_series *series = NULL;
    sph2d_status status = SPH2D_OK;
    for (unsigned part = 0; part < 2 && status == SPH2D_OK; ++part) {
        status = sph2d_series_open("series.csv", "a [m]", 2 * part, &series, &report);
        for (unsigned k = 2 * part; k < 3 + 2 * part && status == SPH2D_OK; ++k)
            status = sph2d_series_append(series, k, &(double){k * k}, 1, &report);
        sph2d_status closed = sph2d_series_close(series, &report);
        status = status == SPH2D_OK ? closed : status;
        series = NULL;
    }
    sph2d_table *table = NULL;
    if (status == SPH2D_OK)
        status = sph2d_table_read("series.csv", columns, 2, &table, &report);
    for (size_t row = 0; row < sph2d_table_rows(table); ++row)
        add(&(double){sph2d_table_value(table, row, 1)}, sizeof(double));
    sph2d_table_destroy(table);
    return status == SPH2D_OK ? sph2d_text_write("text", "text\n", 5, &report) : status;
}

int main(void)
{
    sph2d_scene scene = sph2d_scene_default();
    scene.spacing = 0.02;
    scene.domain = (sph2d_box){{0, 0}, {1, 1}};
    scene.fluid.dynamic_viscosity = 10;
    scene.fluid.surface_tension = 0.07;
    sph2d_block block = sph2d_block_default();
    block.shape.kind = SPH2D_SHAPE_BOX;
    block.shape.box = (sph2d_box){{0, 0}, {0.5, 0.6}};
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0.8, 0.8};
    source.width = 0.2;
    source.speed = 20;
    sph2d_spring spring = sph2d_spring_default();
    spring.to = (sph2d_vec2){0.7, 0.5};
    spring.stiffness = 10;
    sph2d_body body = sph2d_body_default();
    body.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.7, 0.2}, 0.1}};
    body.density = 500;
    body.springs = &spring;
    body.spring_count = 1;
    sph2d_probe probe = sph2d_probe_default();
    probe.name = "level";
    probe.kind = SPH2D_PROBE_LEVEL;
    probe.rate.every = 1;
    scene.blocks = &block;
    scene.sources = &source;
    scene.probes = &probe;
    scene.bodies = &body;
    scene.block_count = scene.body_count = scene.source_count = scene.probe_count = 1;
    sph2d_status status = run(&scene);
    if (status == SPH2D_OK)
        status = write_files();
    char text[4096];
    if (status == SPH2D_OK && sph2d_scene_text(&scene, text, sizeof text) == 0)
        status = SPH2D_NOMEM;
    if (held != 0) {
        fprintf(stderr, "%zu bytes are not given back\n", held);
        return 1;
    }
    if (status == SPH2D_OK) {
        printf("%016" PRIx64 "\n", hash);
        return 0;
    }
    fprintf(stderr, "sph2d: %s: %s\n", sph2d_status_text(status), report.count > 0 ? report.items[0].message : "");
    return status == SPH2D_NOMEM ? 70 : 74;
}
