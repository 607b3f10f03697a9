/* SPDX-License-Identifier: MIT */
/** @file test_features.c
 *  Which method has which feature: every cell of the table runs, or is refused at its place with a reason. */
#include <math.h>

#include "common.h"

/* ---- methods ----------------------------------------------------------------------------------------------------- */

/** The solvers, one bit each. */
enum { MULLER = 1, WCSPH = 2, FITTED = 4, PCISPH = 8, CONSTRAINT = 16, ALL = 31, FREE = ALL & ~FITTED };

static void choose(sph2d_scene *scene, int solver)
{
    scene->method = sph2d_scene_default().method;
    scene->method.name = solver == MULLER       ? SPH2D_METHOD_MULLER
                         : solver == PCISPH     ? SPH2D_METHOD_PCISPH
                         : solver == CONSTRAINT ? SPH2D_METHOD_CONSTRAINT
                                                : SPH2D_METHOD_WCSPH;
    scene->method.operators = solver == FITTED ? SPH2D_OPERATORS_FITTED : SPH2D_OPERATORS_VARIATIONAL;
    scene->method.sound_speed = 20;
}

/* ---- features ---------------------------------------------------------------------------------------------------- */

/** A scene with all that the features below point at. */
typedef struct stage {
    sph2d_scene scene;
    sph2d_block block;
    sph2d_obstacle obstacle;
    sph2d_source source;
    sph2d_drain drain;
    sph2d_interaction pull;
    sph2d_path_point point;
    sph2d_vec2 line[2];
    sph2d_particle particle;
} stage;

static const double DX = 0.05;

/** A closed box full of liquid with rough walls: what every solver has, but for walls that muller and the projected
 *  ones do not make rough. */
static void set_stage(stage *s, int solver)
{
    s->scene = test_scene(DX, 0, 0, 1, 1);
    choose(&s->scene, solver);
    s->scene.fluid.dynamic_viscosity = 20;
    s->scene.wall_slip = solver == FITTED ? SPH2D_SLIP_NONE : SPH2D_SLIP_FREE;
    s->block = test_block(0, 0, 1, 1);
    s->scene.blocks = &s->block;
    s->scene.block_count = 1;
}

/** With a free surface above, and something to fall. */
static void half_empty(stage *s)
{
    s->block = test_block(0, 0, 1, 0.5);
    s->scene.gravity.y = -9.81;
}

static void set_open(stage *s)
{
    half_empty(s);
    s->scene.boundary.top = SPH2D_SIDE_OPEN;
}

static void set_periodic(stage *s)
{
    s->scene.boundary.left = s->scene.boundary.right = SPH2D_SIDE_PERIODIC;
    s->scene.gravity.x = 1;
}

static void set_rough(stage *s)
{
    s->scene.wall_slip = SPH2D_SLIP_NONE;
    s->scene.wall_speeds.top = 1;
}

static void set_smooth(stage *s)
{
    s->scene.wall_slip = SPH2D_SLIP_SMOOTH;
    s->scene.slip_length = 0.01;
}

static void set_tension(stage *s)
{
    set_open(s);
    s->scene.fluid.surface_tension = 1;
}

static void set_central(stage *s)
{
    s->scene.central_force.center = (sph2d_vec2){0.5, 0.5};
    s->scene.central_force.rate = 2;
}

static void set_pull(stage *s)
{
    s->pull = sph2d_interaction_default();
    s->point = (sph2d_path_point){0, 0.5, 0.4};
    s->pull.path = (sph2d_path){&s->point, 1};
    s->pull.radius = 0.3;
    s->pull.acceleration = 10;
    s->scene.interactions = &s->pull;
    s->scene.interaction_count = 1;
}

static void set_source(stage *s)
{
    half_empty(s);
    s->source = sph2d_source_default();
    s->source.at = (sph2d_vec2){0.5, 0.8};
    s->source.width = 0.2;
    s->source.speed = 2;
    s->scene.sources = &s->source;
    s->scene.source_count = 1;
}

static void set_drain(stage *s)
{
    half_empty(s);
    s->drain = sph2d_drain_default();
    s->drain.shape.kind = SPH2D_SHAPE_BOX;
    s->drain.shape.box = (sph2d_box){{0.8, 0}, {1, 0.2}};
    s->scene.drains = &s->drain;
    s->scene.drain_count = 1;
}

static void set_obstacle(stage *s, sph2d_wall_form form)
{
    s->obstacle = sph2d_obstacle_default();
    s->obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
    s->obstacle.shape.circle = (sph2d_circle){{0.5, 0.5}, 0.2};
    s->obstacle.form = form;
    s->scene.obstacles = &s->obstacle;
    s->scene.obstacle_count = 1;
}

static void set_obstacle_default(stage *s)
{
    set_obstacle(s, SPH2D_WALL_DEFAULT);
}

static void set_obstacle_heavy(stage *s)
{
    set_obstacle(s, SPH2D_WALL_HEAVY);
}

static void set_obstacle_layered(stage *s)
{
    set_obstacle(s, SPH2D_WALL_GENERALISED);
}

static void set_obstacle_reflecting(stage *s)
{
    set_obstacle(s, SPH2D_WALL_REFLECT);
}

static void set_obstacle_moving(stage *s)
{
    set_obstacle(s, SPH2D_WALL_DEFAULT);
    s->obstacle.motion.amplitude.x = 0.05;
    s->obstacle.motion.frequency = 1;
}

static void set_spring(stage *s)
{
    s->scene.walls = SPH2D_WALL_SPRING;
}

static void set_heavy(stage *s)
{
    s->scene.walls = SPH2D_WALL_HEAVY;
}

static void set_reflecting(stage *s)
{
    s->scene.walls = SPH2D_WALL_REFLECT;
}

static void set_layers(stage *s)
{
    s->scene.walls = SPH2D_WALL_GENERALISED;
}

static void set_kernel(stage *s)
{
    s->scene.method.kernel = SPH2D_KERNEL_WENDLAND_C4;
}

static void set_alpha(stage *s)
{
    s->scene.method.artificial_viscosity = 0.1;
}

static void set_delta(stage *s)
{
    s->scene.method.density_diffusion = 0.05;
}

static void set_shifting(stage *s)
{
    s->scene.method.shifting = 0.5;
}

static void set_tolerance(stage *s)
{
    s->scene.method.tolerance = 2e-4;
}

static void set_max_iterations(stage *s)
{
    s->scene.method.max_iterations = 50;
}

static void set_particles(stage *s)
{
    s->block = test_block(0, 0, 1, 0.95);
    s->particle = (sph2d_particle){0.525, 0.975, 0, 0, 1000, 0};
    s->scene.particles = (sph2d_particles){NULL, &s->particle, 1};
}

static const struct feature {
    const char *path; /**< where it is refused */
    int have;
    void (*set)(stage *);
} features[] = {
    {"boundary.top", FREE, set_open},
    {"boundary.left", ALL, set_periodic},
    {"wall_slip", ALL & ~(MULLER | PCISPH), set_rough},
    {"wall_slip", WCSPH | CONSTRAINT, set_smooth},
    {"fluid.surface_tension", FREE, set_tension},
    {"central_force", ALL, set_central},
    {"interactions", ALL, set_pull},
    {"sources", FREE, set_source},
    {"drains", FREE, set_drain},
    {"obstacles", ALL, set_obstacle_default},
    {"obstacles[0].form", MULLER, set_obstacle_heavy},
    {"obstacles[0].form", ALL & ~MULLER, set_obstacle_layered},
    {"obstacles[0].form", MULLER, set_obstacle_reflecting},
    {"obstacles[0].motion", ALL, set_obstacle_moving},
    {"walls", MULLER, set_spring},
    {"walls", MULLER, set_heavy},
    {"walls", MULLER, set_reflecting},
    {"walls", ALL & ~MULLER, set_layers},
    {"method.kernel", WCSPH | PCISPH | CONSTRAINT, set_kernel},
    {"method.artificial_viscosity", MULLER | PCISPH, set_alpha},
    {"method.density_diffusion", FITTED, set_delta},
    {"method.shifting", FITTED, set_shifting},
    {"method.tolerance", CONSTRAINT, set_tolerance},
    {"method.max_iterations", PCISPH | CONSTRAINT, set_max_iterations},
    {"particles", ALL, set_particles},
};
enum { FEATURES = sizeof features / sizeof *features, SOLVERS = 5 };

static void check_runs(const stage *s, int solver)
{
    sph2d_sim *sim = test_create(&s->scene, NULL);
    test_steps(sim, 20);
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_msg(isfinite(sum.kinetic) && sum.speed_max < 20, "solver %d: speed %g", solver, sum.speed_max);
    ck_assert_uint_gt(sum.particles, 100);
    sph2d_sim_destroy(sim);
}

START_TEST(a_cell_of_the_table)
{
    const struct feature *feature = &features[_i / SOLVERS];
    int solver = 1 << _i % SOLVERS;
    stage s = {0};
    set_stage(&s, solver);
    feature->set(&s);
    sph2d_report report = {0};
    sph2d_status status = sph2d_scene_check(&s.scene, &report);
    if (feature->have & solver) {
        ck_assert_msg(status == SPH2D_OK, "%s with solver %d: %s", feature->path, solver, test_report_text(&report));
        check_runs(&s, solver);
    } else {
        ck_assert_int_eq(status, SPH2D_SCENE);
        ck_assert_msg(test_report_has(&report, SPH2D_CODE_UNSUPPORTED, feature->path), "%s with solver %d: %s",
                      feature->path, solver, test_report_text(&report));
    }
}
END_TEST

Suite *suite_features(void)
{
    Suite *suite = suite_create("features");
    TCase *cases = tcase_create("features");
    tcase_add_loop_test(cases, a_cell_of_the_table, 0, FEATURES * SOLVERS);
    tcase_set_tags(cases, "long");
    suite_add_tcase(suite, cases);
    return suite;
}
