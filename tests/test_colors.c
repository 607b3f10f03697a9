/* SPDX-License-Identifier: MIT */
/** @file test_colors.c
 *  Colours of liquid: how they are written, that each particle keeps its own wherever it comes from, and that they change
 *  nothing else. */
#include <math.h>
#include <string.h>

#include "common.h"

enum { RED = 0xff0000, GOLD = 0xffd700, TEAL = 0x008080, OWN = 0x123456, WATER = 0x2b82cf, HONEY = 0xe0930f };

static sph2d_scene scene;
static sph2d_block blocks[2];
static sph2d_source source;

/** Two blocks of 10 x 10 that fall into each other, one of them red, and a source of gold above. */
static void set_scene(sph2d_method method)
{
    scene = test_scene(0.05, 0, 0, 2, 2);
    scene.method = sph2d_scene_default().method;
    scene.method.name = method;
    scene.gravity = (sph2d_vec2){0, -9.81};
    blocks[0] = test_block(0.2, 0, 0.7, 0.5);
    blocks[1] = test_block(0.8, 0, 1.3, 0.5);
    blocks[0].color = "red";
    scene.blocks = blocks;
    scene.block_count = 2;
    source = sph2d_source_default();
    source.at = (sph2d_vec2){1, 1.8};
    source.speed = 2;
    source.width = 0.1;
    source.color = "gold";
    scene.sources = &source;
    scene.source_count = 1;
}

static size_t count_of(const sph2d_sim *sim, uint64_t color)
{
    const uint64_t *colors = sph2d_sim_colors(sim);
    size_t count = 0;
    for (size_t i = 0; i < sph2d_sim_fluid(sim).count; ++i)
        count += colors[i] == color;
    return count;
}

/* ---- how they are written ---------------------------------------------------------------------------------------- */

START_TEST(names_and_digits_are_read)
{
    static const struct {
        const char *text;
        uint32_t rgb;
    } good[] = {{"red", 0xff0000}, {"navy", 0x000080}, {"pink", 0xffc0cb}, {"#000000", 0}, {"#09afAF", 0x09afaf}};
    uint32_t rgb = 1;
    for (size_t k = 0; k < sizeof good / sizeof *good; ++k) {
        ck_assert(sph2d_color_parse(good[k].text, &rgb));
        ck_assert_uint_eq(rgb, good[k].rgb);
    }
    static const char *const bad[] = {"", "Red", "#fff", "#12345g", "#1234567", "123456", "reddish", NULL};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k)
        ck_assert(!sph2d_color_parse(bad[k], &rgb));
    ck_assert_uint_eq(rgb, 0x09afaf);
    size_t names = 0;
    uint32_t sum = 0;
    while (sph2d_color_name(names)) {
        ck_assert(sph2d_color_parse(sph2d_color_name(names), &rgb));
        sum = 31 * sum + rgb;
        ++names;
    }
    ck_assert_uint_eq(names, 148 + 1);  /* of CSS Color 4, and water */
    ck_assert_uint_eq(sum, 2721534075); /* of the table of the standard, in the order of the alphabet */
    ck_assert_ptr_null(sph2d_color_name(names + 1));
}
END_TEST

START_TEST(a_fluid_has_its_own_or_its_materials)
{
    sph2d_fluid fluid = sph2d_fluid_of(SPH2D_MATERIAL_WATER);
    uint32_t rgb = 7;
    ck_assert(!sph2d_fluid_color(&fluid, &rgb));
    ck_assert_uint_eq(rgb, 7);
    fluid = sph2d_fluid_of(SPH2D_MATERIAL_HONEY);
    ck_assert(sph2d_fluid_color(&fluid, &rgb));
    ck_assert_uint_eq(rgb, HONEY);
    fluid.color = "teal";
    ck_assert(sph2d_fluid_color(&fluid, &rgb));
    ck_assert_uint_eq(rgb, TEAL);
    fluid = (sph2d_fluid){.material = (sph2d_material)1000};
    ck_assert(!sph2d_fluid_color(&fluid, &rgb));
    size_t count;
    const sph2d_material_data *materials = sph2d_materials(&count);
    for (size_t k = 0; k < count; ++k)
        ck_assert_msg(!materials[k].color || sph2d_color_parse(materials[k].color, &rgb), "%s", materials[k].name);
}
END_TEST

START_TEST(what_is_no_colour_is_refused_at_its_key)
{
    static const char *const paths[] = {"fluid.color", "blocks[1].color", "sources[0].color", "openings[0].color"};
    sph2d_opening opening = sph2d_opening_default();
    opening.side = SPH2D_SIDE_NAME_LEFT;
    opening.velocity = 0.1;
    set_scene(SPH2D_METHOD_WCSPH);
    scene.openings = &opening;
    scene.opening_count = 1;
    const char **const slots[] = {&scene.fluid.color, &blocks[1].color, &source.color, &opening.color};
    *slots[_i] = "crimsn";
    sph2d_report report = {0};
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    const char *text = test_report_text(&report);
    ck_assert_msg(strstr(text, paths[_i]) && strstr(text, "'crimsn' is no colour") && strstr(text, "'crimson'"), "%s",
                  text);
    sph2d_report_clear(&report);
}
END_TEST

/* ---- each particle keeps its own --------------------------------------------------------------------------------- */

START_TEST(particles_keep_their_colours)
{
    set_scene((sph2d_method)_i);
    scene.fluid.color = "teal";
    sph2d_sim *sim = test_create(&scene, NULL);
    enum { MOST = 1000 };
    static uint64_t by_id[MOST];
    memset(by_id, 0, sizeof by_id);
    for (int k = 0; k < 8; ++k) {
        test_steps(sim, 25);
        const sph2d_view fluid = sph2d_sim_fluid(sim);
        const uint64_t *colors = sph2d_sim_colors(sim);
        for (size_t i = 0; i < fluid.count; ++i) {
            ck_assert_uint_lt(fluid.id[i], MOST);
            ck_assert(by_id[fluid.id[i]] == 0 || by_id[fluid.id[i]] == colors[i]);
            by_id[fluid.id[i]] = colors[i];
        }
    }
    ck_assert_uint_eq(count_of(sim, RED), 100);
    ck_assert_uint_eq(count_of(sim, TEAL), 100);
    ck_assert_uint_gt(count_of(sim, GOLD), 1);
    ck_assert_uint_eq(count_of(sim, GOLD), sph2d_sim_summary(sim).fed);
    const sph2d_shape area = {.kind = SPH2D_SHAPE_BOX, .box = {{0, 0}, {2, 0.1}}};
    size_t removed = 0;
    ck_assert_int_eq(sph2d_sim_remove_particles(sim, &area, &removed), SPH2D_OK);
    ck_assert_uint_gt(removed, 10);
    const sph2d_view fluid = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < fluid.count; ++i)
        ck_assert_uint_eq(sph2d_sim_colors(sim)[i], by_id[fluid.id[i]]);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(added_particles_have_theirs)
{
    set_scene(SPH2D_METHOD_WCSPH);
    scene.source_count = 0;
    scene.fluid = sph2d_fluid_of(SPH2D_MATERIAL_HONEY);
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d_particle drops[] = {{.x = 1, .y = 1.5, .color = OWN}, {.x = 1.5, .y = 1.5}};
    size_t added;
    ck_assert_int_eq(sph2d_sim_add_particles(sim, drops, 2, &added), SPH2D_OK);
    ck_assert_uint_eq(added, 2);
    ck_assert_uint_eq(count_of(sim, OWN), 1);
    ck_assert_uint_eq(count_of(sim, HONEY), 101);
    const double bad[] = {-1, 0.5, 0x1000000, NAN};
    for (size_t k = 0; k < 4; ++k)
        ck_assert_int_eq(sph2d_sim_add_particles(sim, &(sph2d_particle){.x = 1, .y = 1.7, .color = bad[k]}, 1, NULL),
                         SPH2D_INVALID);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(liquid_of_an_opening_has_its_colour)
{
    set_scene(SPH2D_METHOD_WCSPH);
    sph2d_opening opening = sph2d_opening_default();
    opening.side = SPH2D_SIDE_NAME_LEFT;
    opening.to = 0.3;
    opening.velocity = 1;
    opening.color = "teal";
    blocks[0] = test_block(0, 0, 2, 0.5);
    blocks[0].color = "red";
    scene.openings = &opening;
    scene.opening_count = scene.block_count = 1;
    scene.source_count = 0;
    sph2d_sim *sim = test_create(&scene, NULL);
    const size_t before = count_of(sim, TEAL); /* the reservoir */
    ck_assert_uint_gt(before, 10);
    ck_assert_uint_eq(count_of(sim, RED), 400);
    test_steps(sim, 200);
    ck_assert_uint_eq(count_of(sim, TEAL), before + sph2d_sim_summary(sim).let_in);
    ck_assert_uint_gt(count_of(sim, TEAL), before + 5);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- and nothing else changes ------------------------------------------------------------------------------------ */

START_TEST(a_scene_without_has_the_same_bits)
{
    set_scene((sph2d_method)_i);
    sph2d_sim *colored = test_create(&scene, NULL);
    blocks[0].color = source.color = NULL;
    sph2d_sim *plain = test_create(&scene, NULL);
    ck_assert_ptr_null(sph2d_sim_colors(plain));
    ck_assert_uint_eq(count_of(colored, WATER), 100);
    test_steps(colored, 100);
    test_steps(plain, 100);
    const sph2d_view a = sph2d_sim_fluid(colored), b = sph2d_sim_fluid(plain);
    ck_assert_uint_eq(a.count, b.count);
    ck_assert_mem_eq(a.x, b.x, a.count * sizeof *a.x);
    ck_assert_mem_eq(a.vy, b.vy, a.count * sizeof *a.vy);
    sph2d_sim_destroy(colored);
    sph2d_sim_destroy(plain);
}
END_TEST

START_TEST(a_state_has_them)
{
    set_scene(SPH2D_METHOD_CONSTRAINT);
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 50);
    const sph2d_state state = sph2d_sim_state(sim);
    sph2d_sim *again = NULL, *later = NULL, *tinted = NULL;
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state, &again, NULL), SPH2D_OK);
    const size_t count = sph2d_sim_fluid(sim).count;
    ck_assert_mem_eq(sph2d_sim_colors(again), sph2d_sim_colors(sim), count * sizeof(uint64_t));
    blocks[0].color = source.color = NULL; /* as where a file had given them to particles */
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state, &later, NULL), SPH2D_OK);
    ck_assert_mem_eq(sph2d_sim_colors(later), sph2d_sim_colors(sim), count * sizeof(uint64_t));
    sph2d_sim *plain = test_create(&scene, NULL);
    ck_assert_ptr_null(sph2d_sim_colors(plain));
    scene.fluid.color = "teal"; /* a scene without any, whose liquid gets one later */
    const sph2d_state without = sph2d_sim_state(plain);
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &without, &tinted, NULL), SPH2D_OK);
    ck_assert_uint_eq(count_of(tinted, TEAL), sph2d_sim_fluid(plain).count);
    sph2d_sim_destroy(sim);
    sph2d_sim_destroy(again);
    sph2d_sim_destroy(later);
    sph2d_sim_destroy(plain);
    sph2d_sim_destroy(tinted);
}
END_TEST

START_TEST(a_state_with_none_of_ours_is_refused)
{
    set_scene(SPH2D_METHOD_WCSPH);
    sph2d_sim *sim = test_create(&scene, NULL), *again = NULL;
    sph2d_state state = sph2d_sim_state(sim);
    static sph2d_array arrays[200];
    static uint64_t wrong[1000];
    wrong[7] = 0x1000000;
    ck_assert_uint_le(state.array_count, 200);
    for (size_t k = 0; k < state.array_count; ++k) {
        arrays[k] = state.arrays[k];
        if (strcmp(arrays[k].name, "Colors") == 0)
            arrays[k].data[0] = wrong;
    }
    state.arrays = arrays;
    sph2d_report report = {0};
    ck_assert_int_eq(sph2d_sim_restore(&scene, NULL, &state, &again, &report), SPH2D_FORMAT);
    ck_assert_ptr_nonnull(strstr(test_report_text(&report), "'Colors' has a value that is no colour"));
    sph2d_report_clear(&report);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_colors(void)
{
    Suite *suite = suite_create("colors");
    TCase *cases = tcase_create("colors");
    tcase_add_test(cases, names_and_digits_are_read);
    tcase_add_test(cases, a_fluid_has_its_own_or_its_materials);
    tcase_add_loop_test(cases, what_is_no_colour_is_refused_at_its_key, 0, 4);
    tcase_add_loop_test(cases, particles_keep_their_colours, SPH2D_METHOD_MULLER, SPH2D_METHOD_HYBRID + 1);
    tcase_add_test(cases, added_particles_have_theirs);
    tcase_add_test(cases, liquid_of_an_opening_has_its_colour);
    tcase_add_loop_test(cases, a_scene_without_has_the_same_bits, SPH2D_METHOD_MULLER, SPH2D_METHOD_HYBRID + 1);
    tcase_add_test(cases, a_state_has_them);
    tcase_add_test(cases, a_state_with_none_of_ours_is_refused);
    suite_add_tcase(suite, cases);
    return suite;
}
