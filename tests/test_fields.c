/* SPDX-License-Identifier: MIT */
/** @file test_fields.c
 *  The field table: names, units and types are pinned, since files are made of them; its data is that of the views. */
#include <string.h>

#include "common.h"

static const struct {
    const char *name;
    signed char unit[3];
    sph2d_type type;
    unsigned components;
} expected[] = {
    {"Coordinates", {1, 0, 0}, SPH2D_F64, 2}, {"Velocities", {1, 0, -1}, SPH2D_F64, 2},
    {"Masses", {-1, 1, 0}, SPH2D_F64, 1},     {"Densities", {-3, 1, 0}, SPH2D_F64, 1},
    {"Pressures", {-1, 1, -2}, SPH2D_F64, 1}, {"SmoothingLengths", {1, 0, 0}, SPH2D_F64, 1},
    {"ParticleIDs", {0, 0, 0}, SPH2D_U64, 1}, {"Accelerations", {1, 0, -2}, SPH2D_F64, 2},
};
enum { FIELDS = sizeof expected / sizeof expected[0] };

static sph2d_sim *pool(void)
{
    sph2d_scene scene = test_scene(0.02, 0, 0, 1, 0.5);
    sph2d_block block = test_block(0, 0, 0.3, 0.2);
    sph2d_vec2 ends[2] = {{0.6, 0.1}, {0.8, 0.1}};
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_LINE;
    obstacle.shape.points = (sph2d_points){ends, 2};
    scene.gravity.y = -9.81;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 30);
    return sim;
}

static sph2d_array find(const sph2d_sim *sim, sph2d_group group, const char *name)
{
    for (size_t i = 0; i < sph2d_field_count(group); ++i) {
        sph2d_array field = sph2d_field(sim, group, i);
        if (strcmp(field.name, name) == 0)
            return field;
    }
    ck_abort_msg("no field '%s'", name);
    return (sph2d_array){.group = group};
}

START_TEST(names_units_and_types_are_pinned)
{
    for (int g = SPH2D_GROUP_FLUID; g <= SPH2D_GROUP_WALL; ++g)
        for (size_t k = 0; k < FIELDS; ++k) {
            if (g == SPH2D_GROUP_WALL && strcmp(expected[k].name, "Accelerations") == 0)
                continue; /* walls do not move */
            sph2d_array field = find(NULL, (sph2d_group)g, expected[k].name);
            ck_assert_int_eq(field.group, g);
            ck_assert_mem_eq(field.unit, expected[k].unit, 3);
            ck_assert_int_eq(field.type, expected[k].type);
            ck_assert_uint_eq(field.components, expected[k].components);
            ck_assert_uint_gt(strlen(field.description), 5);
            ck_assert_uint_eq(field.count, 0); /* a description alone */
            ck_assert(field.data[0] == NULL && field.data[1] == NULL);
        }
    ck_assert_uint_eq(sph2d_field_count(SPH2D_GROUP_FLUID), FIELDS);
    ck_assert_uint_eq(sph2d_field_count(SPH2D_GROUP_WALL), FIELDS - 1);
    ck_assert_uint_eq(sph2d_field_count(SPH2D_GROUP_RUN), 0);
}
END_TEST

START_TEST(names_are_unique_and_indices_end)
{
    for (int g = SPH2D_GROUP_FLUID; g <= SPH2D_GROUP_WALL; ++g) {
        size_t count = sph2d_field_count((sph2d_group)g);
        for (size_t i = 0; i < count; ++i)
            for (size_t j = 0; j < i; ++j)
                ck_assert_str_ne(sph2d_field(NULL, (sph2d_group)g, i).name, sph2d_field(NULL, (sph2d_group)g, j).name);
        ck_assert_ptr_null(sph2d_field(NULL, (sph2d_group)g, count).name);
        ck_assert_ptr_null(sph2d_field(NULL, (sph2d_group)g, SIZE_MAX).name);
    }
    ck_assert_ptr_null(sph2d_field(NULL, SPH2D_GROUP_RUN, 0).name);
}
END_TEST

/** A field shows this array of a view. */
static void check_field(const sph2d_sim *sim, sph2d_group group, const char *name, const void *first,
                        const void *second)
{
    sph2d_array field = find(sim, group, name);
    size_t count = group == SPH2D_GROUP_FLUID ? sph2d_sim_fluid(sim).count : sph2d_sim_walls(sim).count;
    ck_assert_uint_eq(field.count, count);
    ck_assert_uint_eq(field.stride, 1);
    ck_assert_msg(field.data[0] == first && field.data[1] == second, "%s", name);
}

START_TEST(fields_are_the_views)
{
    sph2d_sim *sim = pool();
    for (int g = SPH2D_GROUP_FLUID; g <= SPH2D_GROUP_WALL; ++g) {
        sph2d_group group = (sph2d_group)g;
        sph2d_view v = g == SPH2D_GROUP_FLUID ? sph2d_sim_fluid(sim) : sph2d_sim_walls(sim);
        ck_assert_uint_eq(v.count, g == SPH2D_GROUP_FLUID ? 150 : 11);
        check_field(sim, group, "Coordinates", v.x, v.y);
        check_field(sim, group, "Velocities", v.vx, v.vy);
        check_field(sim, group, "Densities", v.density, NULL);
        check_field(sim, group, "Pressures", v.pressure, NULL);
        check_field(sim, group, "ParticleIDs", v.id, NULL);
        if (g == SPH2D_GROUP_FLUID)
            check_field(sim, group, "Accelerations", v.ax, v.ay);
        else
            ck_assert(v.ax == NULL && v.ay == NULL);
        sph2d_array support = find(sim, group, "SmoothingLengths");
        ck_assert_uint_eq(support.count, v.count);
        ck_assert_uint_eq(support.stride, 0);
        ck_assert_double_eq_tol(*(const double *)support.data[0], 0.04, 1e-15);
    }
    sph2d_array mass = find(sim, SPH2D_GROUP_FLUID, "Masses");
    ck_assert_uint_eq(mass.stride, 0);
    ck_assert_double_eq_tol(*(const double *)mass.data[0], 0.4, 1e-14); /* density dx^2 */
    sph2d_array heavy = find(sim, SPH2D_GROUP_WALL, "Masses");
    ck_assert_uint_eq(heavy.count, 11);
    ck_assert_uint_eq(heavy.stride, 1);
    const double *masses = heavy.data[0]; /* heavier than the liquid's where the wall is one particle thick */
    for (size_t b = 0; b < heavy.count; ++b)
        ck_assert_double_gt(masses[b], 0.4);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(the_state_has_what_a_run_needs)
{
    sph2d_sim *sim = pool();
    sph2d_state state = sph2d_sim_state(sim);
    static const char *const needed[] = {"Coordinates", "Velocities", "Accelerations",
                                         "Densities",   "Pressures",  "ParticleIDs"};
    for (size_t k = 0; k < sizeof needed / sizeof needed[0]; ++k) {
        sph2d_array field = find(sim, SPH2D_GROUP_FLUID, needed[k]);
        size_t found = 0;
        for (size_t i = 0; i < state.array_count; ++i)
            found += state.arrays[i].group == SPH2D_GROUP_FLUID && strcmp(state.arrays[i].name, needed[k]) == 0 &&
                     state.arrays[i].data[0] == field.data[0];
        ck_assert_msg(found == 1, "%s", needed[k]);
    }
    for (size_t i = 0; i < state.array_count; ++i) { /* unique inside a group, described, with data */
        const sph2d_array *a = &state.arrays[i];
        ck_assert(a->name && a->name[0] && a->description && a->description[0]);
        ck_assert_msg(a->count == 0 || a->data[0], "%s", a->name);
        for (size_t j = 0; j < i; ++j)
            ck_assert_msg(a->group != state.arrays[j].group || strcmp(a->name, state.arrays[j].name) != 0, "%s",
                          a->name);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_fields(void)
{
    Suite *suite = suite_create("fields");
    TCase *tests = tcase_create("fields");
    tcase_add_test(tests, names_units_and_types_are_pinned);
    tcase_add_test(tests, names_are_unique_and_indices_end);
    tcase_add_test(tests, fields_are_the_views);
    tcase_add_test(tests, the_state_has_what_a_run_needs);
    suite_add_tcase(suite, tests);
    return suite;
}
