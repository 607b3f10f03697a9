/* SPDX-License-Identifier: MIT */
/** @file test_materials.c
 *  Liquids by their names: that their numbers are those of the sources, and that scene files take them. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "common.h"
#include "sph2d/io.h"

#define SCENE                                                                                                          \
    "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.1\nmethod: wcsph\nblocks:\n"                                       \
    "  - box: {min: [0, 0], max: [0.4, 0.8]}\n"

#define KELVIN 293.15 /* 20 C */

/* ---- formulas of the sources ------------------------------------------------------------------------------------- */

/** Surface tension of water [N/m], IAPWS R1-76(2014), Eq. 1. */
static double tension_of_water(void)
{
    double tau = 1 - KELVIN / 647.096;
    return 0.2358 * pow(tau, 1.256) * (1 - 0.625 * tau);
}

/** Viscosity of water at 0.1 MPa [Pa s], Huber et al., J. Phys. Chem. Ref. Data 38 (2009) 101, section 3.7. */
static double viscosity_of_water(void)
{
    static const double a[] = {280.68, 511.45, 61.131, 0.45903}, b[] = {-1.9, -7.7, -19.6, -40};
    double sum = 0;
    for (int i = 0; i < 4; ++i)
        sum += a[i] * pow(KELVIN / 300, b[i]);
    return 1e-6 * sum;
}

/** Viscosity [Pa s] of the three-constant formula of Viswanath & Natarajan (1989). */
static double viswanath_natarajan(double a, double b, double c)
{
    return 1e-3 * pow(10, a + b / (c - KELVIN));
}

/** Viscosity of glycerol without water [Pa s] at t [C], Cheng, Ind. Eng. Chem. Res. 47 (2008) 3285, Eq. 22. */
static double viscosity_of_glycerol(double t)
{
    return 12.1 * exp((-1233 + t) * t / (9900 + 70 * t));
}

/* ---- the table --------------------------------------------------------------------------------------------------- */

START_TEST(the_numbers_are_those_of_the_sources)
{
    /* Each with what its source leaves open: the digits that are kept, or the spread of several sources. */
    const struct {
        sph2d_material material;
        double density, within, viscosity, viscosity_within, tension, tension_within;
    } cases[] = {
        {SPH2D_MATERIAL_WATER, 998.207, 0.01, viscosity_of_water(), 5e-8, tension_of_water(), 5e-6},
        {SPH2D_MATERIAL_OIL, 0.913 * 998.2, 0.5, viswanath_natarajan(-1.911, -699.7, 110.3), 5e-5, 0.033, 1e-3},
        {SPH2D_MATERIAL_GLYCERINE, 1261.08, 0.1, viscosity_of_glycerol(20), 5e-3, 0.0634, 8e-4},
        {SPH2D_MATERIAL_HONEY, (1.4225 * 2 + 1.4171) / 3 * 998.2, 3, 18.96, 0.1, 0, 1e-9},
        {SPH2D_MATERIAL_MERCURY, 13545.9, 0.2, viswanath_natarajan(-0.1105, -51.209, 124.04), 5e-7,
         1e-3 * (490.6 - 0.2049 * 20), 5e-5},
    };
    size_t count;
    const sph2d_material_data *materials = sph2d_materials(&count);
    ck_assert_uint_eq(count, 1 + sizeof cases / sizeof *cases);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const sph2d_material_data *m = &materials[cases[i].material];
        ck_assert_double_eq_tol(m->density, cases[i].density, cases[i].within);
        ck_assert_double_eq_tol(m->dynamic_viscosity, cases[i].viscosity, cases[i].viscosity_within);
        ck_assert_double_eq_tol(m->surface_tension, cases[i].tension, cases[i].tension_within);
    }
}
END_TEST

START_TEST(the_materials_are_those_of_the_table)
{
    size_t count;
    const sph2d_material_data *materials = sph2d_materials(&count);
    ck_assert_uint_eq(count, SPH2D_MATERIAL_MERCURY + 1);
    for (size_t i = 1; i < count; ++i) {
        sph2d_fluid fluid = sph2d_fluid_of((sph2d_material)i);
        ck_assert_int_eq(fluid.material, (int)i);
        ck_assert(fluid.density == materials[i].density && fluid.density > 900);
        ck_assert(fluid.dynamic_viscosity == materials[i].dynamic_viscosity && fluid.dynamic_viscosity > 0);
    }
    ck_assert_double_eq(sph2d_fluid_of((sph2d_material)99).density, 1000);
}
END_TEST

/* ---- scene files ------------------------------------------------------------------------------------------------- */

START_TEST(a_material_is_its_numbers)
{
    /* Alone, with numbers of its own wherever they stand, and by overrides. */
    static const struct {
        const char *fluid;
        sph2d_override override;
        double density, viscosity, tension;
    } cases[] = {
        {"fluid: water\n", {NULL, NULL}, 998.2, 1.0016e-3, 0},
        {"fluid: {material: mercury}\n", {NULL, NULL}, 13546, 1.557e-3, 0},
        {"fluid: {dynamic_viscosity: 2, surface_tension: 0.06, material: glycerine}\n", {NULL, NULL}, 1261, 2, 0.06},
        {"fluid: oil\n", {"fluid.density", "900"}, 900, 0.0823, 0},
        {"fluid: {density: 900}\n", {"fluid", "honey"}, 1420, 19, 0},
        {"fluid: {density: 900}\n", {"fluid.material", "honey"}, 900, 19, 0},
        {"fluid: none\n", {NULL, NULL}, 1000, 1e-3, 0},
    };
    char text[400];
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    snprintf(text, sizeof text, SCENE "%s", cases[_i].fluid);
    sph2d_status status = sph2d_scene_file_parse(text, strlen(text), "s.yaml", &cases[_i].override,
                                                 cases[_i].override.path ? 1 : 0, &file, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    const sph2d_fluid *fluid = &sph2d_scene_file_scene(file)->fluid;
    ck_assert_double_eq(fluid->density, cases[_i].density);
    ck_assert_double_eq(fluid->dynamic_viscosity, cases[_i].viscosity);
    ck_assert_double_eq(fluid->surface_tension, cases[_i].tension);
    ck_assert_int_eq(sph2d_scene_file_scene(file)->method.name, SPH2D_METHOD_WCSPH);
    sph2d_scene_file_destroy(file);
}
END_TEST

Suite *suite_materials(void)
{
    Suite *suite = suite_create("materials");
    TCase *table = tcase_create("table");
    tcase_add_test(table, the_numbers_are_those_of_the_sources);
    tcase_add_test(table, the_materials_are_those_of_the_table);
    tcase_add_loop_test(table, a_material_is_its_numbers, 0, 7);
    suite_add_tcase(suite, table);
    return suite;
}
