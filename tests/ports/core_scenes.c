/* SPDX-License-Identifier: MIT */
/** @file core_scenes.c
 *  core_scenes [auto]: runs three scenes by all methods for 50 steps, by the baseline instruction set or, with `auto`, the
 *  best of this processor, and two threads, and prints what the liquid is then, to be compared between machines, compilers and C libraries. A line: scene, method,
 *  how it ended, particles, kinetic and potential energy [J/m], mean and largest compression, hash of all particles. */
#include <stdio.h>
#include <string.h>

#include <sph2d/sph2d.h>

enum { STEPS = 50 };

/* By which all runs are. */
static sph2d_isa isa = SPH2D_ISA_BASELINE;

static uint64_t hash_of(const sph2d_view *f)
{
    const double *const all[] = {f->x, f->y, f->vx, f->vy, f->density, f->pressure};
    uint64_t hash = 0;
    for (size_t a = 0; a < sizeof all / sizeof *all; ++a)
        for (size_t i = 0; i < f->count; ++i) {
            uint64_t word;
            memcpy(&word, &all[a][i], sizeof word);
            hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
            hash ^= hash >> 29;
        }
    return hash;
}

/** Runs a scene by a method, and prints a line; false where it does not come to its end. */
static bool run(sph2d_scene scene, const char *name, const char *method, const sph2d_method_options *by)
{
    sph2d_sim *sim = NULL;
    sph2d_report report = {0};
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 2;
    options.isa = isa;
    scene.method = *by;
    sph2d_status status = sph2d_sim_create(&scene, &options, &sim, &report);
    for (int k = 0; k < STEPS && status == SPH2D_OK; ++k)
        status = sph2d_sim_step(sim, &report);
    const sph2d_view fluid = sph2d_sim_fluid(sim);
    const sph2d_summary s = sph2d_sim_summary(sim);
    printf("%s %s %s %zu %.17g %.17g %.17g %.17g %016llx\n", name, method, sph2d_status_name(status), fluid.count,
           s.kinetic, s.potential, s.compression_mean, s.compression_max, (unsigned long long)hash_of(&fluid));
    for (size_t i = 0; i < report.count; ++i)
        fprintf(stderr, "%s by %s: %s\n", name, method, report.items[i].message);
    sph2d_report_clear(&report);
    sph2d_sim_destroy(sim);
    return status == SPH2D_OK;
}

/** A column that falls on a post and floats a disc. */
static bool run_dam(const char *method, const sph2d_method_options *by)
{
    sph2d_scene scene = sph2d_scene_default();
    scene.spacing = 0.03;
    scene.domain = (sph2d_box){{0, 0}, {1.2, 1}};
    sph2d_block column = sph2d_block_default();
    column.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0, 0}, {0.45, 0.6}}};
    scene.blocks = &column;
    scene.block_count = 1;
    sph2d_obstacle post = sph2d_obstacle_default();
    post.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.75, 0.15}, 0.1}};
    scene.obstacles = &post;
    scene.obstacle_count = 1;
    sph2d_body float_ = sph2d_body_default();
    float_.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.2, 0.72}, 0.1}};
    float_.density = 500;
    scene.bodies = &float_;
    scene.body_count = 1;
    return run(scene, "dam", method, by);
}

/** A drop with surface tension that flies onto a wall. */
static bool run_drop(const char *method, const sph2d_method_options *by)
{
    sph2d_scene scene = sph2d_scene_default();
    scene.spacing = 1e-3;
    scene.domain = (sph2d_box){{0, 0}, {0.05, 0.04}};
    scene.fluid.surface_tension = 0.072;
    scene.fluid.dynamic_viscosity = 1e-2;
    sph2d_block drop = sph2d_block_default();
    drop.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.025, 0.0105}, 0.01}};
    drop.velocity = (sph2d_vec2){0.1, -0.3};
    scene.blocks = &drop;
    scene.block_count = 1;
    return run(scene, "drop", method, by);
}

/** Vortices in a periodic square. */
static bool run_vortices(const char *method, const sph2d_method_options *by)
{
    sph2d_scene scene = sph2d_scene_default();
    scene.spacing = 0.05;
    scene.domain = (sph2d_box){{0, 0}, {1, 1}};
    scene.boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    scene.gravity = (sph2d_vec2){0, 0};
    scene.fluid.dynamic_viscosity = 5;
    sph2d_block liquid = sph2d_block_default();
    liquid.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = scene.domain};
    liquid.start.flow.kind = SPH2D_FLOW_TAYLOR_GREEN;
    liquid.start.flow.speed = liquid.start.flow.length = 1;
    scene.blocks = &liquid;
    scene.block_count = 1;

    return run(scene, "vortices", method, by);
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        sph2d_method method;
        sph2d_operators operators;
        bool surface; /* it has free surfaces */
    } methods[] = {{"muller", SPH2D_METHOD_MULLER, SPH2D_OPERATORS_VARIATIONAL, true},
                   {"wcsph", SPH2D_METHOD_WCSPH, SPH2D_OPERATORS_VARIATIONAL, true},
                   {"fitted", SPH2D_METHOD_WCSPH, SPH2D_OPERATORS_FITTED, false},
                   {"pcisph", SPH2D_METHOD_PCISPH, SPH2D_OPERATORS_VARIATIONAL, true},
                   {"constraint", SPH2D_METHOD_CONSTRAINT, SPH2D_OPERATORS_VARIATIONAL, true}};
    if (argc == 2 && strcmp(argv[1], "auto") == 0)
        isa = SPH2D_ISA_AUTO;
    bool fine = true;
    for (size_t k = 0; k < sizeof methods / sizeof *methods; ++k) {
        sph2d_method_options by = sph2d_scene_default().method;
        by.name = methods[k].method;
        by.operators = methods[k].operators;
        fine = run_vortices(methods[k].name, &by) && fine;
        if (methods[k].surface) {
            fine = run_dam(methods[k].name, &by) && fine;
            fine = run_drop(methods[k].name, &by) && fine;
        }
    }
    return fine && fflush(stdout) == 0 ? 0 : 1;
}
