/* SPDX-License-Identifier: MIT */
/** @file test_viscosity_form.c
 *  Which form of viscosity a scene gets by itself: Morris' where liquid of one viscosity fills its room and no wall turns,
 *  else Monaghan's; and eddies at free surfaces alone. */
#include "hand_made.h"
#include "scene/resolve.h"

/** The form that a scene ends with, whose block goes from (0, 0) to (x, y) of a square. */
static sph2d_viscosity_form form_of(sph2d_boundary boundary, double x, double y, sph2d_operators operators)
{
    sph2d_scene scene = test_scene(0.1, 0, 0, 2, 2);
    scene.boundary = boundary;
    scene.method = sph2d_scene_default().method;
    scene.method.operators = operators;
    scene.wall_slip = operators == SPH2D_OPERATORS_FITTED ? SPH2D_SLIP_NONE : SPH2D_SLIP_FREE;
    scene.method.sound_speed = 10;
    sph2d_block block = test_block(0, 0, x, y);
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_viscosity_form form = sim->system.method.viscosity_form;
    ck_assert_int_eq(form, sim->scene.method.viscosity_form);
    sph2d_turbulence eddies = form == SPH2D_VISCOSITY_MORRIS     ? SPH2D_TURBULENCE_NONE
                              : form == SPH2D_VISCOSITY_MONAGHAN ? SPH2D_TURBULENCE_SMAGORINSKY
                                                                 : SPH2D_TURBULENCE_DEFAULT;
    ck_assert_int_eq(sim->system.method.turbulence, eddies);
    sph2d_sim_destroy(sim);
    return form;
}

static const sph2d_boundary closed = {SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL},
                            ring = {SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL},
                            tank = {SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};

START_TEST(a_filled_room_has_morris_a_free_surface_monaghan)
{
    const sph2d_operators symmetric = SPH2D_OPERATORS_SYMMETRIC;
    ck_assert_int_eq(form_of(closed, 2, 2, symmetric), SPH2D_VISCOSITY_MORRIS);
    ck_assert_int_eq(form_of(ring, 2, 2, symmetric), SPH2D_VISCOSITY_MORRIS);
    ck_assert_int_eq(form_of(closed, 2, 1.8, symmetric), SPH2D_VISCOSITY_MONAGHAN);
    ck_assert_int_eq(form_of(closed, 1.8, 2, symmetric), SPH2D_VISCOSITY_MONAGHAN);
    ck_assert_int_eq(form_of(tank, 2, 2, symmetric), SPH2D_VISCOSITY_MONAGHAN);
    ck_assert_int_eq(form_of(ring, 2, 2, SPH2D_OPERATORS_FITTED), SPH2D_VISCOSITY_DEFAULT); /* which has no forms */
}
END_TEST

/* Morris' form lacks mu (grad v)^T, which counts where mu varies, and in the torque on what turns. */
START_TEST(viscosities_that_vary_and_walls_that_turn_have_monaghan)
{
    sph2d_scene scene = test_scene(0.1, 0, 0, 2, 2);
    scene.boundary = closed;
    scene.wall_slip = SPH2D_SLIP_NONE;
    scene.method = sph2d_scene_default().method;
    sph2d_block block = test_block(0, 0, 2, 2);
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_obstacle bar = sph2d_obstacle_default();
    bar.outline = (sph2d_outline){.kind = SPH2D_OUTLINE_CIRCLE, .circle = {{1, 1}, 0.5}};
    scene.obstacles = &bar;
    scene.obstacle_count = 1;
    ck_assert_int_eq(sph2d__viscosity_form(&scene), SPH2D_VISCOSITY_MORRIS);
    ck_assert_int_eq(sph2d__turbulence(&scene), SPH2D_TURBULENCE_NONE);
    bar.motion.rate = 1;
    ck_assert_int_eq(sph2d__viscosity_form(&scene), SPH2D_VISCOSITY_MONAGHAN);
    ck_assert_int_eq(sph2d__turbulence(&scene), SPH2D_TURBULENCE_NONE);
    bar.motion.rate = 0;
    scene.fluid.model = SPH2D_RHEOLOGY_POWER_LAW;
    ck_assert_int_eq(sph2d__viscosity_form(&scene), SPH2D_VISCOSITY_MONAGHAN);
}
END_TEST

Suite *suite_viscosity_form(void)
{
    Suite *suite = suite_create("viscosity_form");
    TCase *tests = tcase_create("viscosity_form");
    tcase_add_test(tests, a_filled_room_has_morris_a_free_surface_monaghan);
    tcase_add_test(tests, viscosities_that_vary_and_walls_that_turn_have_monaghan);
    suite_add_tcase(suite, tests);
    return suite;
}
