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

/** Density of seawater at the pressure of the air [kg/m^3], s in practical salinity, t [C], EOS-80: Fofonoff & Millard,
 *  UNESCO Technical Papers in Marine Science 44 (1983), eqs. 13 and 14. */
static double density_of_seawater(double s, double t)
{
    static const double water[] = {999.842594, 6.793952e-2, -9.095290e-3, 1.001685e-4, -1.120083e-6, 6.536332e-9};
    static const double linear[] = {8.24493e-1, -4.0899e-3, 7.6438e-5, -8.2467e-7, 5.3875e-9, 0};
    static const double root[] = {-5.72466e-3, 1.0227e-4, -1.6546e-6, 0, 0, 0};
    double sum = 4.8314e-4 * s * s;
    for (int k = 0; k < 6; ++k)
        sum += pow(t, k) * (water[k] + linear[k] * s + root[k] * pow(s, 1.5));
    return sum;
}

/** Viscosity of seawater [Pa s], s [kg/kg], t [C], Sharqawy et al., Desalin. Water Treat. 16 (2010) 354, eqs. 22 and
 *  23. */
static double viscosity_of_seawater(double s, double t)
{
    double water = 4.2844e-5 + 1 / (0.157 * (t + 64.993) * (t + 64.993) - 91.296);
    double a = 1.541 + 1.998e-2 * t - 9.52e-5 * t * t, b = 7.974 - 7.561e-2 * t + 4.724e-4 * t * t;
    return water * (1 + a * s + b * s * s);
}

/** Surface tension of seawater [N/m], s [g/kg], t [C], IAPWS G14-19. */
static double tension_of_seawater(double s, double t)
{
    return tension_of_water() * (1 + 3.766e-4 * s + 2.347e-6 * s * t);
}

/** Viscosity of ethanol [Pa s], Perry's Chemical Engineers' Handbook, 8th ed., table 2-313. */
static double viscosity_of_ethanol(void)
{
    return exp(7.875 + 781.98 / KELVIN - 3.0418 * log(KELVIN));
}

/** Viscosity of milk [Pa s] with fat [%], Bakshi & Smith, J. Dairy Sci. 67 (1984) 1157. */
static double viscosity_of_milk(double fat)
{
    return 1e-3 * exp(-8.9 + 0.1 * fat + 2721.5 / KELVIN);
}

/* Units of the sources: Munson, Young & Okiishi's table 1.5 has the liquids of table 1.6 in those of the foot. */
#define SLUG_PER_FT3 515.379
#define LB_S_PER_FT2 47.8803
#define LB_PER_FT 14.5939
#define POISE 0.1
#define DYN_PER_CM2 0.1

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
        {SPH2D_MATERIAL_SEAWATER, density_of_seawater(35, 20), 0.05, viscosity_of_seawater(0.035165, 20), 5e-7,
         tension_of_seawater(35.165, 20), 5e-6},
        {SPH2D_MATERIAL_ETHANOL, 1.53 * SLUG_PER_FT3, 3, viscosity_of_ethanol(), 5e-6, 1e-3 * (24.05 - 0.0832 * 20),
         5e-6},
        {SPH2D_MATERIAL_GASOLINE, 1.32 * SLUG_PER_FT3, 3, 6.5e-6 * LB_S_PER_FT2, 5e-6, 1.5e-3 * LB_PER_FT, 5e-4},
        {SPH2D_MATERIAL_MILK, 1.029e3, 0.5, viscosity_of_milk(3.6), 5e-6, 1e-3 * (1.8e-4 * 400 - 0.163 * 20 + 55.6),
         5e-5},
        {SPH2D_MATERIAL_ENGINE_OIL, 1.77 * SLUG_PER_FT3, 3, 8e-3 * LB_S_PER_FT2, 5e-3, 2.5e-3 * LB_PER_FT, 5e-4},
        {SPH2D_MATERIAL_LAVA, 2.73e3, 0.5, (2e3 + 4e3) / 2 * POISE, 1e-9, 0, 1e-9},
        {SPH2D_MATERIAL_BLOOD, 1.0506e3, 0.5, 0.56 * POISE, 1e-12, 1e-3 * (70.105 - 0.473 * 37), 5e-5},
        {SPH2D_MATERIAL_CHOCOLATE, 76 * 16.0185, 50, 0, 1e-12, 0, 1e-9}, /* Beckett: 1.2 g/cm3, or 76 lb/ft3 */
        {SPH2D_MATERIAL_MUD, 0.342 * 2650 + 0.658 * 998.2, 0.5, 0, 1e-12, 0, 1e-9},
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

START_TEST(the_laws_are_those_of_the_sources)
{
    size_t count;
    const sph2d_material_data *materials = sph2d_materials(&count);
    for (size_t i = 0; i < count; ++i)
        ck_assert_int_eq(materials[i].model != SPH2D_RHEOLOGY_NEWTONIAN, i >= SPH2D_MATERIAL_BLOOD);

    /* Cho & Kensey, Biorheology 28 (1991) 241 */
    const sph2d_material_data *blood = &materials[SPH2D_MATERIAL_BLOOD];
    ck_assert_int_eq(blood->model, SPH2D_RHEOLOGY_CARREAU);
    ck_assert_double_eq_tol(blood->infinite_viscosity, 0.0345 * POISE, 1e-12);
    ck_assert_double_eq(blood->relaxation_time, 3.313);
    ck_assert_double_eq(blood->index, 0.3568);

    /* Bergemann, Heil, Smith & Juel, J. Rheol. 62 (2018) 1187: Bingham's liquid */
    const sph2d_material_data *chocolate = &materials[SPH2D_MATERIAL_CHOCOLATE];
    ck_assert_int_eq(chocolate->model, SPH2D_RHEOLOGY_HERSCHEL_BULKLEY);
    ck_assert_double_eq_tol(chocolate->yield_stress, 36.1, 1e-12);
    ck_assert_double_eq_tol(chocolate->consistency, 8.7, 1e-12);
    ck_assert_double_eq(chocolate->index, 0); /* 1 */

    /* O'Brien & Julien, J. Hydraul. Eng. 114 (1988) 877, table 2, for 34.2 % solids by volume: the same */
    const sph2d_material_data *mud = &materials[SPH2D_MATERIAL_MUD];
    ck_assert_int_eq(mud->model, SPH2D_RHEOLOGY_HERSCHEL_BULKLEY);
    ck_assert_double_eq_tol(mud->yield_stress, 1.52e-1 * exp(18.7 * 0.342) * DYN_PER_CM2, 5e-3);
    ck_assert_double_eq_tol(mud->consistency, 1.36e-3 * exp(28.4 * 0.342) * POISE, 5e-3);
    ck_assert_double_eq(mud->index, 0);
}
END_TEST

START_TEST(the_materials_are_those_of_the_table)
{
    size_t count;
    const sph2d_material_data *materials = sph2d_materials(&count);
    ck_assert_uint_eq(count, SPH2D_MATERIAL_MUD + 1);
    for (size_t i = 1; i < count; ++i) {
        const sph2d_material_data *m = &materials[i];
        sph2d_fluid fluid = sph2d_fluid_of((sph2d_material)i);
        ck_assert_int_eq(fluid.material, (int)i);
        ck_assert(fluid.density == m->density && fluid.density > 600 && fluid.surface_tension == 0);
        ck_assert(fluid.dynamic_viscosity == (m->dynamic_viscosity > 0 ? m->dynamic_viscosity : 1e-3));
        ck_assert(fluid.model == m->model && fluid.regularisation == 0);
        ck_assert(fluid.consistency == m->consistency && fluid.index == m->index);
        ck_assert(fluid.yield_stress == m->yield_stress && fluid.infinite_viscosity == m->infinite_viscosity);
        ck_assert(fluid.relaxation_time == m->relaxation_time);
    }
    ck_assert_double_eq(sph2d_fluid_of((sph2d_material)99).density, 1000);
}
END_TEST

/** Fails when two liquids differ; memory between their members may. */
static void check_same(const sph2d_fluid *a, const sph2d_fluid *b)
{
    ck_assert(a->material == b->material && a->model == b->model && a->density == b->density);
    ck_assert(a->dynamic_viscosity == b->dynamic_viscosity && a->surface_tension == b->surface_tension);
    ck_assert(a->consistency == b->consistency && a->index == b->index && a->yield_stress == b->yield_stress);
    ck_assert(a->regularisation == b->regularisation && a->infinite_viscosity == b->infinite_viscosity);
    ck_assert(a->relaxation_time == b->relaxation_time);
}

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
        {"fluid: water\n", {"fluid", "mud"}, 1563, 1e-3, 0},
        {"fluid: {material: blood, surface_tension: 0.05}\n", {"fluid.density", "1060"}, 1060, 0.056, 0.05},
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

START_TEST(every_material_makes_a_scene_that_comes_back)
{
    char text[400], out[2000], again[2000];
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL, *copy = NULL;
    const char *name = sph2d_materials(NULL)[_i].name;
    snprintf(text, sizeof text, SCENE "fluid: %s\n", name);
    sph2d_status status = sph2d_scene_file_parse(text, strlen(text), "s.yaml", NULL, 0, &file, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    sph2d_fluid fluid = sph2d_fluid_of((sph2d_material)_i);
    check_same(&scene->fluid, &fluid);
    ck_assert(sph2d_scene_text(scene, out, sizeof out) < sizeof out);
    snprintf(text, sizeof text, "spacing: 0.1\n%s%s%sblocks:", _i > 0 ? "fluid:\n  material: " : "", _i > 0 ? name : "",
             _i > 0 ? "\n" : "");
    ck_assert_msg(strstr(out, text) != NULL, "%s", out); /* nothing else of the liquid is said */
    ck_assert_int_eq(sph2d_scene_file_parse(out, strlen(out), "s.yaml", NULL, 0, &copy, &report), SPH2D_OK);
    check_same(&sph2d_scene_file_scene(copy)->fluid, &fluid);
    ck_assert(sph2d_scene_text(sph2d_scene_file_scene(copy), again, sizeof again) < sizeof again);
    ck_assert_str_eq(out, again);

    sph2d_sim *sim = test_create(scene, NULL);
    test_steps(sim, 2);
    sph2d_sim_destroy(sim);
    sph2d_scene_file_destroy(file);
    sph2d_scene_file_destroy(copy);
}
END_TEST

/* Numbers of a law that are given replace the material's; a law of its own needs all of its numbers. */
static const struct {
    const char *fluid, *method;
    sph2d_rheology model;
    double viscosity, yield_stress, consistency, index;
} laws[] = {
    {"{material: mud, yield_stress: 50, index: 0.5}", "wcsph", SPH2D_RHEOLOGY_HERSCHEL_BULKLEY, 1e-3, 50, 2.25, 0.5},
    {"{consistency: 3, material: chocolate}", "wcsph", SPH2D_RHEOLOGY_HERSCHEL_BULKLEY, 1e-3, 36.1, 3, 0},
    {"{material: blood, index: 0.5, infinite_viscosity: 0}", "wcsph", SPH2D_RHEOLOGY_CARREAU, 0.056, 0, 0, 0.5},
    {"{material: chocolate, model: power_law, index: 0.5}", "wcsph", SPH2D_RHEOLOGY_POWER_LAW, 1e-3, 36.1, 8.7, 0.5},
    {"{material: honey, model: power_law, consistency: 10}", "wcsph", SPH2D_RHEOLOGY_POWER_LAW, 19, 0, 10, 0},
    {"{material: blood, model: newtonian, dynamic_viscosity: 0.0035}", "pcisph", SPH2D_RHEOLOGY_NEWTONIAN, 0.0035, 0, 0,
     0.3568},
    {"{model: newtonian, dynamic_viscosity: 0, material: mud}", "constraint", SPH2D_RHEOLOGY_NEWTONIAN, 0, 9.11, 2.25,
     0},
};
enum { LAWS = sizeof laws / sizeof *laws };

static sph2d_status read_liquid(const char *fluid, const char *method, sph2d_scene_file **out, sph2d_report *report)
{
    char text[500];
    snprintf(text, sizeof text,
             "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.1\nmethod: %s\nfluid: %s\nblocks:\n"
             "  - box: {min: [0, 0], max: [0.4, 0.8]}\n",
             method, fluid);
    return sph2d_scene_file_parse(text, strlen(text), "s.yaml", NULL, 0, out, report);
}

START_TEST(numbers_of_a_law_replace_those_of_the_material)
{
    char out[2000];
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL, *copy = NULL;
    sph2d_status status = read_liquid(laws[_i].fluid, laws[_i].method, &file, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    const sph2d_fluid *f = &sph2d_scene_file_scene(file)->fluid;
    ck_assert_int_eq(f->model, laws[_i].model);
    ck_assert_double_eq(f->dynamic_viscosity, laws[_i].viscosity);
    ck_assert_double_eq(f->yield_stress, laws[_i].yield_stress);
    ck_assert_double_eq(f->consistency, laws[_i].consistency);
    ck_assert_double_eq(f->index, laws[_i].index);
    ck_assert(sph2d_scene_text(sph2d_scene_file_scene(file), out, sizeof out) < sizeof out);
    ck_assert_int_eq(sph2d_scene_file_parse(out, strlen(out), "s.yaml", NULL, 0, &copy, &report), SPH2D_OK);
    check_same(&sph2d_scene_file_scene(copy)->fluid, f);
    sph2d_scene_file_destroy(file);
    sph2d_scene_file_destroy(copy);
}
END_TEST

/* ---- what is refused --------------------------------------------------------------------------------------------- */

static const struct {
    const char *fluid, *method, *path;
    sph2d_code code;
    const char *says;
} refusals[] = {
    {"blood", "muller", "fluid.material", SPH2D_CODE_UNSUPPORTED,
     "blood is carreau, and this method knows no shear rate"},
    {"mud", "muller", "fluid.material", SPH2D_CODE_UNSUPPORTED,
     "mud is herschel_bulkley, and this method knows no shear"},
    {"{material: mud, model: power_law, consistency: 2}", "muller", "fluid.model", SPH2D_CODE_UNSUPPORTED,
     "this method knows no shear rate"},
    {"{material: blood, dynamic_viscosity: 0.003}", "wcsph", "fluid.dynamic_viscosity", SPH2D_CODE_CONFLICT,
     "blood has no single viscosity: it is carreau"},
    {"{material: blood, dynamic_viscosity: 0.1}", "wcsph", "fluid.dynamic_viscosity", SPH2D_CODE_CONFLICT,
     "blood has no single viscosity: it is carreau"},
    {"{material: mud, dynamic_viscosity: 3}", "wcsph", "fluid.dynamic_viscosity", SPH2D_CODE_CONFLICT,
     "is no part of a liquid that is herschel_bulkley, as mud is"},
    {"{material: blood, model: newtonian}", "wcsph", "fluid.dynamic_viscosity", SPH2D_CODE_MISSING_KEY,
     "must be given: blood is carreau and has no single viscosity"},
    {"{material: mud, model: newtonian}", "constraint", "fluid.dynamic_viscosity", SPH2D_CODE_MISSING_KEY,
     "must be given: mud is herschel_bulkley and has no single viscosity"},
    {"{material: blood, infinite_viscosity: 0.1}", "wcsph", "fluid.infinite_viscosity", SPH2D_CODE_CONFLICT,
     "must be less than dynamic_viscosity"},
    {"{material: mud, relaxation_time: 3}", "wcsph", "fluid.relaxation_time", SPH2D_CODE_CONFLICT,
     "is no part of a liquid that is herschel_bulkley, as mud is"},
    {"{material: blood, model: newtonian, dynamic_viscosity: 0.003, index: 0.5}", "wcsph", "fluid.index",
     SPH2D_CODE_CONFLICT, "is no part of a liquid that is newtonian"},
    {"{material: mud, model: carreau}", "wcsph", "fluid.index", SPH2D_CODE_MISSING_KEY, "it is a part of carreau"},
    {"{material: water, consistency: 3}", "wcsph", "fluid.consistency", SPH2D_CODE_CONFLICT,
     "is no part of a liquid that is newtonian"},
};
enum { REFUSALS = sizeof refusals / sizeof *refusals };

START_TEST(what_is_not_clear_is_refused)
{
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    ck_assert_int_eq(read_liquid(refusals[_i].fluid, refusals[_i].method, &file, &report), SPH2D_SCENE);
    ck_assert_uint_eq(report.count, strcmp(refusals[_i].fluid, "{material: mud, model: carreau}") ? 1 : 2);
    ck_assert_msg(test_report_has(&report, refusals[_i].code, refusals[_i].path), "%s", test_report_text(&report));
    ck_assert_msg(strstr(test_report_text(&report), refusals[_i].says) != NULL, "%s", test_report_text(&report));
    sph2d_report_clear(&report);
}
END_TEST

Suite *suite_materials(void)
{
    Suite *suite = suite_create("materials");
    TCase *table = tcase_create("table");
    tcase_add_test(table, the_numbers_are_those_of_the_sources);
    tcase_add_test(table, the_laws_are_those_of_the_sources);
    tcase_add_test(table, the_materials_are_those_of_the_table);
    tcase_add_loop_test(table, a_material_is_its_numbers, 0, 9);
    tcase_add_loop_test(table, every_material_makes_a_scene_that_comes_back, 0, SPH2D_MATERIAL_MUD + 1);
    tcase_add_loop_test(table, numbers_of_a_law_replace_those_of_the_material, 0, LAWS);
    tcase_add_loop_test(table, what_is_not_clear_is_refused, 0, REFUSALS);
    suite_add_tcase(suite, table);
    return suite;
}
