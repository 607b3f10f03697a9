/* SPDX-License-Identifier: MIT */
/** @file test_scene_text.c
 *  A scene as text: it is what a person would write, and reads as the same scene again, to the last bit. */
#include <glob.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "common.h"
#include "sph2d/io.h"
#include "sph2d/key.h"

enum { MOST = 20000 };

static sph2d_report report;
static char root[1024]; /**< where the program was started: other suites leave it */

static void set_up(void)
{
    sph2d_report_clear(&report);
    ck_assert_int_eq(chdir(root), 0);
}

static sph2d_scene_file *parse(const char *text)
{
    sph2d_scene_file *file = NULL;
    sph2d_status status = sph2d_scene_file_parse(text, strlen(text), "s.yaml", NULL, 0, &file, &report);
    ck_assert_msg(status == SPH2D_OK, "%s\n%s", test_report_text(&report), text);
    return file;
}

/** The text of a scene in a buffer that holds all of it. */
static const char *text_of(const sph2d_scene *scene, char out[MOST])
{
    size_t length = sph2d_scene_text(scene, out, MOST);
    ck_assert(length > 0 && length < MOST);
    ck_assert_uint_eq(strlen(out), length);
    return out;
}

/* ---- goldens ----------------------------------------------------------------------------------------------------- */

/* Together they hold every key: a test below sees to it. */
static const char *const goldens[] = {
    "name: \"a: \\\"b\\\" \\\\ c\"\n"
    "domain:\n  min: [-1, 0]\n  max: [3, 2]\n"
    "boundary:\n  left: periodic\n  right: periodic\n  bottom: open\n  top: wall\nwalls: heavy\n"
    "wall_damping: 0.5\ngravity: [0.5, -9.81]\n"
    "gravity_path: [[0, 0.5, -9.81], [1, 0, -5]]\nmotion:\n  path: [[0, 0, 0, 0], [1, 0.25, 0, 0.5], [4, 0, 0, 0]]\n"
    "  rate: 0.5\n"
    "central_force:\n  center: [1, 1]\n  rate: 0.25\nspacing: 0.05\n"
    "fluid:\n  density: 900\n  dynamic_viscosity: 200\n  surface_tension: 0.0728\n"
    "method:\n  name: muller\n  max_compression: 0.2\n  stiffness: 300\n  support_ratio: 2.5\n  cfl: 0.2\n"
    "  time_step: 0.0001\n"
    "blocks:\n"
    "  - box:\n      min: [0, 0]\n      max: [0.5, 0.5]\n"
    "  - circle:\n      center: [2, 1]\n      radius: 0.3\n    velocity: [2, -3]\n    spacing: 0.04\n"
    "    start:\n      flow: rotation\n      speed: 0.5\n      length: 0.3\n      depth: 0.125\n"
    "      center: [2, 1]\n    arrangement: rings\n    perturb:\n      amplitude: 0.1\n      seed: 7\n"
    "  - polygon: [[0, 1], [0.5, 1], [0.25, 1.5]]\n"
    "    start:\n      table: \"wind.csv\"\n      top_speed: 1.5\n"
    "particles: \"cloud 1.csv\"\n"
    "start:\n  snapshot: \"old/1.h5\"\n"
    "sources:\n"
    "  - at: [1, 1.5]\n    direction: [1, -1]\n    width: 0.2\n    speed: 2\n    spread: 0.1\n"
    "    rate: 0.3\n    start: 0.5\n    stop: 3\n    seed: 18446744073709551615\n"
    "  - at: [1.5, 1.5]\n    speed: 1\n"
    "drains:\n"
    "  - box:\n      min: [2, 0]\n      max: [3, 0.1]\n    start: 1\n    stop: 2.5\n"
    "  - circle:\n      center: [2.5, 1]\n      radius: 0.1\n"
    "  - polygon: [[-1, 0], [-0.5, 0], [-1, 0.5]]\n"
    "obstacles:\n"
    "  - line: [[0, 0.75], [0.5, 0.75]]\n    form: reflect\n    restitution: 0.9\n    motion:\n"
    "      path: [[0, 0, 0], [1, 0.25, 0], [2.5, 0, -0.25]]\n      amplitude: [0.1, 0]\n      frequency: 2\n"
    "      phase: -1.5708\n"
    "  - line: [[2.6, 0.5], [2.8, 0.5]]\n    motion:\n"
    "      path: [[0, 0, 0, 0], [1, 0, 0.25, -0.5]]\n      between: cubic\n      rate: 0.125\n      angle: 0.25\n"
    "      frequency: 1\n      swings:\n        - amplitude: [0, 0.01]\n          frequency: 3\n        - angle: 0.1\n"
    "          frequency: 0.5\n      ramp: 2\n      center: [2.7, 0.6]\n"
    "  - polyline: [[2, 0.5], [2.2, 0.6], [2.4, 0.5]]\n    liquid: right\n"
    "  - polygon: [[0, 1.6], [0.5, 1.6], [0.25, 1.8]]\n"
    "  - name: post\n    circle:\n      center: [1, 1]\n      radius: 0.2\n"
    "  - box:\n      min: [0.75, 0.25]\n      max: [1.25, 0.5]\n    form: heavy\n"
    "interactions:\n"
    "  - path: [[0, 1, 1], [1, 2, 1]]\n    radius: 0.5\n    acceleration: -20\n"
    "probes:\n"
    "  - name: \"8\"\n    kind: energy\n    per_second: 10\n"
    "  - name: \"true\"\n    kind: pressure\n    at: [1, 1]\n    size: 0.1\n    along: [1, 0]\n    rise_time: 0.001\n"
    "    every: 0.5\n"
    "  - name: push\n    kind: force\n    at: [1, 1]\n    on: post\n    every: 0.5\n"
    "run:\n  until: 4\n  snapshots:\n    per_second: 60\n    compress: 6\n  frames:\n    every: 0.1\n"
    "    size: [640, 480]\n    style: points\n    look: ink\n    background: transparent\n    view:\n      min: [-1, "
    "0]\n      max: [1, 0.5]\n    follow: post\n    radius: 0.02\n    "
    "color: speed\n    color_range: [0, 5]\n    arrows: on\n    arrow_spacing: 0.1\n    arrow_speed: 2\n    "
    "streamlines: on\n"
    "    streamline_spacing: 0.05\n    isolines: "
    "Pressures\n    isoline_step: 500\n    caption: off\n"
    "  max_energy_rise: 0.25\n  impacts: [0.5, 1, 1e-05]\n",

    "name: belts\n"
    "domain:\n  min: [0, 0]\n  max: [1, 1]\nwall_slip: none\n"
    "wall_speeds:\n  left: 1\n  right: -1\n  bottom: 0.5\n  top: -0.5\ngravity: [0, 0]\nspacing: 0.05\n"
    "method:\n  name: constraint\n  kernel: wendland_c4\n  tolerance: 0.02\n"
    "blocks:\n"
    "  - box:\n      min: [0.25, 0.25]\n      max: [0.75, 0.75]\n"
    "run:\n  snapshots:\n    every: 0.5\n  frames:\n    per_second: 25\n",

    "domain:\n  min: [0, 0]\n  max: [1, 1]\nspacing: 0.05\n"
    "blocks:\n"
    "  - box:\n      min: [0, 0]\n      max: [1, 0.5]\n"
    "bodies:\n"
    "  - name: boat\n    polygon: [[0.25, 0.5], [0.5, 0.25], [0.75, 0.5]]\n    density: 300\n    inertia: 2\n"
    "    center: [0.5, 0.4]\n    velocity: [0.5, 0]\n    rate: -0.25\n    hold:\n      y: on\n"
    "    springs:\n      - at: [0.75, 0.5]\n        to: [1, 0.5]\n        stiffness: 100\n        damping: 2\n"
    "        length: 0.25\n        slack: on\n      - to: [0, 0]\n        stiffness: 5\n"
    "    motor:\n      rate: 6\n      torque: 0.5\n    friction: 0.5\n    restitution: 0.25\n"
    "  - circle:\n      center: [0.5, 0.75]\n      radius: 0.125\n    mass: 20\n    hold:\n      x: on\n      angle: "
    "on\n"
    "  - box:\n      min: [0.125, 0.75]\n      max: [0.25, 1]\n    density: 2700\n"
    "probes:\n"
    "  - name: boat\n    kind: body\n    on: boat\n    every: 0.5\n",

    "domain:\n  min: [0, 0]\n  max: [1, 1]\nwall_slip: smooth\n"
    "side_slip:\n  left: free\n  bottom: none\nslip_length: 0.001\n"
    "wall_speeds:\n  bottom: 0.5\nspacing: 0.05\n"
    "blocks:\n"
    "  - box:\n      min: [0, 0]\n      max: [1, 1]\n"
    "obstacles:\n"
    "  - circle:\n      center: [0.5, 0.5]\n      radius: 0.2\n    slip: none\n"
    "  - arc:\n      center: [0.5, 0.5]\n      radius: 0.4\n      from: -1.5\n      to: 1.5\n    liquid: left\n",

    "domain:\n  min: [0, 0]\n  max: [1, 1]\n"
    "boundary:\n  top: wall\nwall_slip: none\nspacing: 0.05\n"
    "method:\n  operators: fitted\n  density_diffusion: 0.05\n  shifting: 0.5\n"
    "  sound_speed: 10\n"
    "blocks:\n"
    "  - box:\n      min: [0, 0]\n      max: [1, 1]\n",

    "domain:\n  min: [0, 0]\n  max: [1, 1]\nboundary:\n  top: wall\nspacing: 0.05\n"
    "blocks:\n"
    "  - box:\n      min: [0, 0]\n      max: [1, 1]\n"
    "absorbers:\n  - side: right\n    length: 0.5\n    rate: 2\n  - side: left\n    length: 0.25\n"
    "openings:\n"
    "  - name: in\n    side: left\n    from: 0.5\n    velocity: 0.5\n    profile: parabola\n    ramp: 0.25\n"
    "  - side: bottom\n    from: 0.25\n    to: 0.5\n    flow_rate: -0.125\n"
    "  - side: right\n    from: 0.75\n    pressure: 10\n"
    "  - side: right\n    to: 0.5\n    level: 0.25\n"
    "  - side: left\n    from: 0.25\n    to: 0.45\n    history:\n      flow_rate: [[0, 0], [1, 0.5]]\n    "
    "free_surface: on\n"
    "  - side: bottom\n    from: 0.55\n    to: 0.75\n    history:\n      profile: [[0, 0.55, 0], [0, 0.75, -0.25]]\n"
    "probes:\n"
    "  - name: in\n    kind: opening\n    on: in\n    every: 0.5\n",

    "domain:\n  min: [0, 0]\n  max: [1, 1]\nspacing: 0.1\n"
    "method:\n  name: constraint\n  tolerance: 1e-06\n  max_iterations: 50\n"
    "blocks:\n"
    "  - box:\n      min: [0, 0]\n      max: [1, 1]\n",

    "domain:\n  min: [0, 0]\n  max: [1, 1]\nspacing: 0.1\n"
    "fluid:\n  density: 1500\n  model: herschel_bulkley\n  consistency: 5\n  index: 0.8\n  yield_stress: 50\n"
    "  regularisation: 2\n"
    "blocks:\n"
    "  - box:\n      min: [0, 0]\n      max: [1, 1]\n",

    "domain:\n  min: [0, 0]\n  max: [1, 1]\nspacing: 0.1\n"
    "fluid:\n  dynamic_viscosity: 5\n  model: carreau\n  index: 0.5\n  infinite_viscosity: 0.1\n"
    "  relaxation_time: 2\n"
    "blocks:\n"
    "  - box:\n      min: [0, 0]\n      max: [1, 1]\n",

    "domain:\n  min: [0, 0]\n  max: [1, 1]\nspacing: 0.1\n"
    "fluid:\n  material: honey\n  density: 1000\n" /* 1000 is the default, but not honey's */
    "method:\n  name: pcisph\n  artificial_viscosity: 0.02\n  max_iterations: 200\n"
    "blocks:\n"
    "  - box:\n      min: [0, 0]\n      max: [1, 1]\n",

    "domain:\n  min: [0, 0]\n  max: [1, 1]\nspacing: 0.1\n"
    "fluid:\n  material: mud\n  yield_stress: 50\n" /* a model and its numbers, but for one */
    "blocks:\n"
    "  - box:\n      min: [0, 0]\n      max: [1, 1]\n",

    "domain:\n  min: [0, 0]\n  max: [1, 1]\nspacing: 0.1\n"
    "fluid:\n  material: blood\n  dynamic_viscosity: 0.0035\n  model: newtonian\n" /* the default, but not blood's */
    "method:\n  name: pcisph\n"
    "blocks:\n"
    "  - box:\n      min: [0, 0]\n      max: [1, 1]\n",

    /* nothing but what must be there; what it starts with is one of four lists */
    "domain:\n  min: [0, 0]\n  max: [1, 1]\nspacing: 0.1\n"
    "blocks:\n"
    "  - box:\n      min: [0, 0]\n      max: [0.5, 0.5]\n",
};
enum { GOLDENS = sizeof goldens / sizeof *goldens };

START_TEST(a_scene_in_the_form_of_the_text_comes_back_byte_for_byte)
{
    char out[MOST];
    sph2d_scene_file *file = parse(goldens[_i]);
    ck_assert_str_eq(text_of(sph2d_scene_file_scene(file), out), goldens[_i]);
    sph2d_scene_file_destroy(file);
}
END_TEST

/** Whether a line of a golden, behind its indent and dash, begins with `name:`. */
static bool is_in_a_golden(const char *name)
{
    char wanted[80];
    bool found = false;
    for (size_t i = 0; i < 2 * GOLDENS && !found; ++i) {
        snprintf(wanted, sizeof wanted, "%c%s:", i % 2 ? ' ' : '\n', name);
        found = strstr(goldens[i / 2], wanted) != NULL;
    }
    return found;
}

static void look_for_keys(const sph2d_keys *keys)
{
    for (size_t i = 0; i < keys->count; ++i) {
        const char *name = keys->items[i].name;
        bool becomes_path = strcmp(name, "file") == 0 || strcmp(name, "gravity_file") == 0 ||
                            strcmp(name, "svg") == 0; /* once it is read */
        ck_assert_msg(is_in_a_golden(name) || becomes_path, "no golden has '%s'", name);
        if (keys->items[i].keys)
            look_for_keys(keys->items[i].keys);
    }
}

START_TEST(the_goldens_have_every_key)
{
    look_for_keys(sph2d_scene_keys());
}
END_TEST

START_TEST(a_scene_of_defaults_is_what_must_be_given)
{
    char out[MOST];
    sph2d_scene scene = sph2d_scene_default();
    ck_assert_str_eq(text_of(&scene, out), "domain:\n  min: [0, 0]\n  max: [0, 0]\nspacing: 0\n");
    /* what a file says although it is the default is not said again */
    sph2d_scene_file *file = parse("name: scene\ndomain: {min: [0, 0], max: [1, 1]}\nspacing: 1.0e-1\nfluid: {}\n"
                                   "boundary: {left: wall, top: open}\nsources: []\nrun: {until: 1, frames: {}}\n"
                                   "blocks: [{box: {min: [0, 0], max: [.5, .5]}, velocity: [0, 0]}]\n");
    ck_assert_str_eq(text_of(sph2d_scene_file_scene(file), out), goldens[GOLDENS - 1]);
    sph2d_scene_file_destroy(file);
}
END_TEST

/* ---- room -------------------------------------------------------------------------------------------------------- */

START_TEST(text_is_cut_like_snprintf_does)
{
    sph2d_scene_file *file = parse(goldens[1]);
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    size_t whole = strlen(goldens[1]);
    char out[MOST];
    for (size_t size = 0; size < whole + 3; ++size) {
        memset(out, '#', whole + 4);
        ck_assert_uint_eq(sph2d_scene_text(scene, out, size), whole);
        size_t kept = size == 0 ? 0 : size <= whole ? size - 1 : whole;
        ck_assert_int_eq(memcmp(out, goldens[1], kept), 0);
        ck_assert_int_eq(out[kept], size == 0 ? '#' : '\0');
        for (size_t i = size > 0 ? kept + 1 : 0; i < whole + 4; ++i)
            ck_assert_msg(out[i] == '#', "size %zu writes to byte %zu", size, i);
    }
    ck_assert_uint_eq(sph2d_scene_text(scene, NULL, 0), whole);
    ck_assert_uint_eq(sph2d_scene_text(scene, NULL, 100), whole);
    ck_assert_uint_eq(sph2d_scene_text(NULL, out, sizeof out), 0);
    sph2d_scene_file_destroy(file);
}
END_TEST

/* ---- values ------------------------------------------------------------------------------------------------------ */

/** A scene that can hold any text as its name, and any number as a probe's place. */
static sph2d_scene holder(sph2d_block *block, sph2d_probe *probe)
{
    sph2d_scene scene = test_scene(0.1, 0, 0, 1, 1);
    *block = test_block(0, 0, 0.5, 0.5);
    *probe = sph2d_probe_default();
    probe->name = "p";
    probe->kind = SPH2D_PROBE_ENERGY;
    probe->rate.every = 1;
    scene.blocks = block;
    scene.probes = probe;
    scene.block_count = scene.probe_count = 1;
    return scene;
}

START_TEST(texts_are_quoted_where_they_would_be_read_otherwise)
{
    static const struct {
        const char *text, *written; /**< NULL: however */
    } names[] = {
        {"plain_1", "plain_1"},
        {"8", "\"8\""},
        {"-1", "\"-1\""},
        {"true", "\"true\""},
        {"False", "\"False\""},
        {"ON", "\"ON\""},
        {"null", "\"null\""},
        {"~", "\"~\""},
        {"", "\"\""},
        {" a # b ", "\" a # b \""},
        {"two words", "\"two words\""},
        {"a: b", "\"a: b\""},
        {"back\\slash", "\"back\\\\slash\""},
        {"\"quoted\"", "\"\\\"quoted\\\"\""},
        {"a\nb\tc\x1b\x7f", "\"a\\x0Ab\\x09c\\x1B\\x7F\""},
        {"\xc3\xa9\xe2\x82\xac\xf0\x9f\x8c\x8a", "\"\xc3\xa9\xe2\x82\xac\xf0\x9f\x8c\x8a\""},
        {"next\xc2\x85line", NULL},
        {"line\xe2\x80\xa8separator\xe2\x80\xa9", NULL},
    };
    sph2d_block block;
    sph2d_probe probe;
    sph2d_scene scene = holder(&block, &probe);
    char out[MOST], expected[200];
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        scene.name = names[i].text;
        snprintf(expected, sizeof expected, "name: %s\ndomain:", names[i].written ? names[i].written : "");
        text_of(&scene, out);
        if (names[i].written)
            ck_assert_msg(strncmp(out, expected, strlen(expected)) == 0, "expected %s in\n%s", expected, out);
        sph2d_scene_file *file = parse(out);
        ck_assert_str_eq(sph2d_scene_file_scene(file)->name, names[i].text);
        sph2d_scene_file_destroy(file);
    }
}
END_TEST

/** The numbers go through text, and come back with all their bits. */
static void check_numbers(double x, double y)
{
    sph2d_block block;
    sph2d_probe probe;
    sph2d_scene scene = holder(&block, &probe);
    char out[MOST];
    probe.at = (sph2d_vec2){x, y};
    sph2d_scene_file *file = parse(text_of(&scene, out));
    sph2d_vec2 back = sph2d_scene_file_scene(file)->probes[0].at;
    ck_assert_msg(memcmp(&back.x, &x, sizeof x) == 0, "%.17g became %.17g", x, back.x);
    ck_assert_msg(memcmp(&back.y, &y, sizeof y) == 0, "%.17g became %.17g", y, back.y);
    sph2d_scene_file_destroy(file);
}

START_TEST(numbers_keep_all_their_bits)
{
    static const double values[] = {0.1,
                                    1 / 3.,
                                    2 / 3.,
                                    1e-300,
                                    5e-324,
                                    1e11,
                                    1e12,
                                    -0.0,
                                    999999999999.9999,
                                    0x1p39,
                                    0x1p-1022,
                                    -1e-5,
                                    123456789012.345,
                                    0.30000000000000004};
    for (size_t i = 0; i < sizeof values / sizeof *values; ++i)
        check_numbers(values[i], nextafter(values[i], 0));
    uint64_t state = 1;
    for (int i = 0; i < 500; ++i) {
        double x = ldexp(test_random(&state, -1, 1), (int)test_random(&state, -1000, 39));
        check_numbers(x, test_random(&state, -10, 10));
    }
}
END_TEST

START_TEST(numbers_are_as_short_as_their_bits_allow)
{
    char out[MOST];
    sph2d_scene scene = sph2d_scene_default();
    scene.spacing = 0.1;
    scene.domain = (sph2d_box){{0.1 + 0.2, 1 / 3.}, {1e22, 9.7}};
    ck_assert_str_eq(text_of(&scene, out), "domain:\n  min: [0.30000000000000004, 0.3333333333333333]\n"
                                           "  max: [1e+22, 9.7]\nspacing: 0.1\n");
}
END_TEST

START_TEST(a_comma_in_the_callers_numbers_changes_nothing)
{
    static const char *const commas[] = {"de_DE.UTF-8", "de_DE.utf8",  "de_DE",
                                         "fr_FR.UTF-8", "nl_NL.UTF-8", "ru_RU.UTF-8"};
    const char *found = NULL;
    for (size_t i = 0; i < sizeof commas / sizeof *commas && !found; ++i)
        found = setlocale(LC_ALL, commas[i]);
    char out[MOST], half[8];
    snprintf(half, sizeof half, "%.1f", 0.5);
    if (found) /* none may be installed */
        ck_assert_str_eq(half, "0,5");
    locale_t before = uselocale((locale_t)0);
    sph2d_scene_file *file = parse(goldens[0]);
    text_of(sph2d_scene_file_scene(file), out);
    ck_assert(uselocale((locale_t)0) == before);
    sph2d_scene_file_destroy(file);
    setlocale(LC_ALL, "C");
    ck_assert_str_eq(out, goldens[0]);
}
END_TEST

/* ---- scenes that people wrote ------------------------------------------------------------------------------------ */

/** Both scenes become the same simulation, as far as a plan tells. One thread is enough for that. */
static void check_plans(const sph2d_scene *a, const sph2d_scene *b, const char *path)
{
    sph2d_sim *first = test_create(a, NULL), *second = test_create(b, NULL);
    const sph2d_plan *p = sph2d_sim_plan(first), *q = sph2d_sim_plan(second);
    ck_assert_msg(p->fluid_particles == q->fluid_particles && p->wall_particles == q->wall_particles, "%s", path);
    ck_assert_msg(p->places_left_free == q->places_left_free && p->memory == q->memory, "%s", path);
    ck_assert_msg(p->particle_mass == q->particle_mass && p->support_radius == q->support_radius, "%s", path);
    ck_assert_msg(p->sound_speed == q->sound_speed && p->head == q->head, "%s", path);
    ck_assert_msg(p->impact_compression == q->impact_compression && p->time_step == q->time_step, "%s", path);
    ck_assert_msg(p->steps == q->steps && p->disk == q->disk, "%s", path);
    ck_assert_msg(p->snapshots == q->snapshots && p->frames == q->frames, "%s", path);
    ck_assert_str_eq(p->sound_speed_formula, q->sound_speed_formula);
    ck_assert_str_eq(p->time_step_limit, q->time_step_limit);
    sph2d_sim_destroy(first);
    sph2d_sim_destroy(second);
}

/** Text, scene, text: nothing changes. */
static void check_scene(const char *path)
{
    char first[MOST], second[MOST];
    sph2d_scene_file *file = NULL;
    sph2d_report_clear(&report);
    sph2d_status status = sph2d_scene_file_read(path, NULL, 0, &file, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    sph2d_scene_file *again = parse(text_of(scene, first));
    const sph2d_scene *back = sph2d_scene_file_scene(again);
    ck_assert_str_eq(text_of(back, second), first);
    check_plans(scene, back, path);
    sph2d_scene_file_destroy(again);
    sph2d_scene_file_destroy(file);
}

/** Whether a file is a study: it has the key `scene`. */
static bool is_study(const char *path)
{
    char line[400];
    bool found = false;
    FILE *stream = fopen(path, "r");
    ck_assert_msg(stream != NULL, "%s", path);
    while (!found && fgets(line, sizeof line, stream))
        found = strncmp(line, "scene:", 6) == 0;
    fclose(stream);
    return found;
}

START_TEST(each_example_survives_the_way_through_text)
{
    static const char *const patterns[] = {"examples/*/*.yaml", "tests/cases/*.yaml"};
    size_t checked = 0;
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; ++i) {
        glob_t found = {0};
        ck_assert_msg(glob(patterns[i], 0, NULL, &found) == 0, "%s: is this the source tree?", patterns[i]);
        for (size_t k = 0; k < found.gl_pathc; ++k)
            if (!is_study(found.gl_pathv[k])) {
                check_scene(found.gl_pathv[k]);
                ++checked;
            }
        globfree(&found);
    }
    ck_assert_uint_ge(checked, 20);
}
END_TEST

Suite *suite_scene_text(void)
{
    if (!getcwd(root, sizeof root))
        snprintf(root, sizeof root, ".");
    Suite *suite = suite_create("scene_text");
    TCase *text = tcase_create("text");
    tcase_add_checked_fixture(text, set_up, NULL);
    tcase_add_loop_test(text, a_scene_in_the_form_of_the_text_comes_back_byte_for_byte, 0, GOLDENS);
    tcase_add_test(text, the_goldens_have_every_key);
    tcase_add_test(text, a_scene_of_defaults_is_what_must_be_given);
    tcase_add_test(text, text_is_cut_like_snprintf_does);
    tcase_add_test(text, texts_are_quoted_where_they_would_be_read_otherwise);
    tcase_add_test(text, numbers_keep_all_their_bits);
    tcase_add_test(text, numbers_are_as_short_as_their_bits_allow);
    tcase_add_test(text, a_comma_in_the_callers_numbers_changes_nothing);
    suite_add_tcase(suite, text);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, set_up, NULL);
    tcase_add_test(slow, each_example_survives_the_way_through_text);
    return suite;
}
