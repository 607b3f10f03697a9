/* SPDX-License-Identifier: MIT */
/** @file common.c
 *  Helpers of the test suites. */
#include "common.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "time_limits.h"

TCase *test_long(Suite *suite)
{
    TCase *tests = tcase_create("long");
    tcase_set_tags(tests, "long");
    suite_add_tcase(suite, tests);
    return tests;
}

/** Knuth's linear congruential generator (MMIX), upper bits. */
double test_random(uint64_t *state, double low, double high)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*state >> 11) * 0x1p-53;
}

sph2d_scene test_scene(double spacing, double x0, double y0, double x1, double y1)
{
    sph2d_scene scene = sph2d_scene_default();
    scene.spacing = spacing;
    scene.domain = (sph2d_box){{x0, y0}, {x1, y1}};
    scene.boundary.top = SPH2D_SIDE_WALL;
    scene.gravity = (sph2d_vec2){0, 0};
    scene.fluid.dynamic_viscosity = 0;
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.method.sound_speed = 10;
    return scene;
}

sph2d_scene test_open_scene(double spacing, double x0, double y0, double x1, double y1)
{
    sph2d_scene scene = test_scene(spacing, x0, y0, x1, y1);
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    return scene;
}

sph2d_block test_block(double x0, double y0, double x1, double y1)
{
    sph2d_block block = sph2d_block_default();
    block.shape.kind = SPH2D_SHAPE_BOX;
    block.shape.box = (sph2d_box){{x0, y0}, {x1, y1}};
    return block;
}

sph2d_block test_particle(double spacing, double x, double y, double vx, double vy)
{
    double half = spacing / 2;
    sph2d_block block = test_block(x - half, y - half, x + half, y + half);
    block.velocity = (sph2d_vec2){vx, vy};
    return block;
}

sph2d_sim *test_create(const sph2d_scene *scene, const sph2d_sim_options *options)
{
    static sph2d_report report;
    sph2d_report_clear(&report);
    sph2d_sim_options one = sph2d_sim_options_default();
    one.threads = 1;
    sph2d_sim *sim = NULL;
    sph2d_status status = sph2d_sim_create(scene, options ? options : &one, &sim, &report);
    ck_assert_msg(status == SPH2D_OK, "sph2d_sim_create: %s", test_report_text(&report));
    ck_assert_ptr_nonnull(sim);
    return sim;
}

const sph2d__world *test_world(const sph2d_scene *scene)
{
    static sph2d__world world;
    static sph2d__arena arena;
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    sph2d__arena_free(&arena, &memory);
    arena = (sph2d__arena){0};
    ck_assert_int_ne(sph2d__world_make(&world, scene, false, &arena, &memory, NULL), SPH2D_NOMEM);
    ck_assert_double_gt(world.derived.mass, 0); /* it was settled */
    return &world;
}

void test_steps(sph2d_sim *sim, int steps)
{
    static sph2d_report report;
    sph2d_report_clear(&report);
    for (int i = 0; i < steps; ++i)
        if (sph2d_sim_step(sim, &report) != SPH2D_OK)
            ck_abort_msg("step %d of %d: %s", i + 1, steps, test_report_text(&report));
}

size_t test_find(sph2d_view view, uint64_t id)
{
    for (size_t i = 0; i < view.count; ++i)
        if (view.id[i] == id)
            return i;
    ck_abort_msg("no particle has id %llu", (unsigned long long)id);
    return 0;
}

bool test_report_has(const sph2d_report *report, sph2d_code code, const char *path)
{
    for (size_t i = 0; i < report->count; ++i) {
        const sph2d_diagnostic *d = &report->items[i];
        if (d->severity == SPH2D_ERROR && d->code == code && (!path || strcmp(d->path, path) == 0))
            return true;
    }
    return false;
}

const char *test_report_text(const sph2d_report *report)
{
    static char text[8192];
    size_t used = 0;
    text[0] = '\0';
    for (size_t i = 0; i < report->count && used + 1024 < sizeof text; ++i) {
        sph2d_diagnostic_format(&report->items[i], text + used, 1000);
        used = strlen(text);
        text[used++] = '\n';
        text[used] = '\0';
    }
    return text;
}

static bool same_array(const sph2d_array *a, const sph2d_array *b)
{
    bool same = a->group == b->group && strcmp(a->name, b->name) == 0 && a->type == b->type && a->count == b->count &&
                a->components == b->components && a->stride == b->stride;
    for (unsigned c = 0; same && c < a->components; ++c)
        same = a->count == 0 || memcmp(a->data[c], b->data[c], 8 * (a->stride ? a->count * a->stride : 1)) == 0;
    return same;
}

void test_same(sph2d_sim *a, sph2d_sim *b, const char *when)
{
    sph2d_state s = sph2d_sim_state(a), t = sph2d_sim_state(b);
    ck_assert_uint_eq(s.version, SPH2D_STATE_VERSION);
    ck_assert_uint_eq(s.array_count, t.array_count);
    for (size_t i = 0; i < s.array_count; ++i)
        ck_assert_msg(same_array(&s.arrays[i], &t.arrays[i]), "%s: %s", when, s.arrays[i].name);
    for (int g = SPH2D_GROUP_FLUID; g <= SPH2D_GROUP_OUTLINE; ++g)
        for (size_t i = 0; i < sph2d_field_count((sph2d_group)g); ++i) {
            sph2d_array x = sph2d_field(a, (sph2d_group)g, i), y = sph2d_field(b, (sph2d_group)g, i);
            ck_assert_msg(same_array(&x, &y), "%s: field %s of group %d", when, x.name, g);
        }
    sph2d_summary p = sph2d_sim_summary(a), q = sph2d_sim_summary(b);
    ck_assert_msg(memcmp(&p, &q, sizeof p) == 0, "%s: summary", when);
    const sph2d_scene *scene = sph2d_sim_scene(a);
    for (size_t i = 0; i < scene->probe_count; ++i) {
        double u[SPH2D_PROBE_MAX_COLUMNS], v[SPH2D_PROBE_MAX_COLUMNS];
        size_t n = sph2d_sim_probe(a, i, u);
        ck_assert_uint_eq(sph2d_sim_probe(b, i, v), n);
        ck_assert_msg(memcmp(u, v, n * sizeof *u) == 0, "%s: probe %s", when, scene->probes[i].name);
    }
    for (size_t i = 0; i < scene->body_count; ++i) {
        sph2d_body_state u = sph2d_sim_body(a, i), v = sph2d_sim_body(b, i);
        ck_assert_msg(memcmp(&u, &v, sizeof u) == 0, "%s: body %zu", when, i);
    }
    for (size_t output = 0; output < SPH2D_OUTPUT_PROBE + scene->probe_count; ++output)
        ck_assert_uint_eq(sph2d_sim_output_count(a, output), sph2d_sim_output_count(b, output));
    ck_assert(sph2d_sim_time(a) == sph2d_sim_time(b) && sph2d_sim_time_step(a) == sph2d_sim_time_step(b));
    ck_assert(sph2d_sim_steps(a) == sph2d_sim_steps(b) && sph2d_sim_isa(a) == sph2d_sim_isa(b));
}

static void too_long(int signal)
{
    static const char words[] = "a test passed its limit of time by the clock; " LIMITS_HINT "\n";
    (void)signal;
    _exit(write(STDERR_FILENO, words, sizeof words - 1) > 0 ? EXIT_FAILURE : 2);
}

void test_limit(unsigned seconds)
{
    signal(SIGALRM, too_long);
    alarm(seconds * limits_factor());
}

void *test_resize(void *block, size_t old_size, size_t new_size)
{
    void *fresh = NULL;
    if (new_size > 0) {
        fresh = aligned_alloc(64, (new_size + 63) / 64 * 64);
        if (!fresh)
            return NULL;
        if (block)
            memcpy(fresh, block, old_size < new_size ? old_size : new_size);
    }
    free(block);
    return fresh;
}

static size_t array_bytes(const sph2d_array *array)
{
    return 8 * (array->stride ? array->count * array->stride : 1);
}

test_state test_state_copy(sph2d_sim *sim)
{
    sph2d_state lent = sph2d_sim_state(sim);
    ck_assert_uint_gt(lent.array_count, 0);
    test_state copy = {.count = lent.array_count, .arrays = calloc(lent.array_count, sizeof *copy.arrays)};
    ck_assert_ptr_nonnull(copy.arrays);
    for (size_t i = 0; i < copy.count; ++i) {
        copy.arrays[i] = lent.arrays[i];
        for (unsigned c = 0; c < lent.arrays[i].components; ++c) {
            size_t bytes = array_bytes(&lent.arrays[i]);
            void *data = malloc(bytes ? bytes : 8);
            ck_assert_ptr_nonnull(data);
            if (lent.arrays[i].count > 0)
                memcpy(data, lent.arrays[i].data[c], bytes);
            copy.arrays[i].data[c] = data;
        }
    }
    copy.state = (sph2d_state){lent.version, copy.arrays, copy.count};
    return copy;
}

/** The copy owns its data, which the public type shows as const. */
static void *writable(const void *data)
{
    void *out;
    memcpy(&out, &data, sizeof out);
    return out;
}

void test_state_free(test_state *state)
{
    for (size_t i = 0; i < state->count; ++i)
        for (unsigned c = 0; c < 2; ++c)
            free(writable(state->arrays[i].data[c]));
    free(state->arrays);
    *state = (test_state){0};
}

sph2d_array *test_state_array(test_state *state, sph2d_group group, const char *name)
{
    for (size_t i = 0; i < state->count; ++i)
        if (state->arrays[i].group == group && strcmp(state->arrays[i].name, name) == 0)
            return &state->arrays[i];
    ck_abort_msg("the state has no array '%s'", name);
    return NULL;
}

double *test_state_reals(test_state *state, sph2d_group group, const char *name, unsigned component)
{
    sph2d_array *array = test_state_array(state, group, name);
    ck_assert_int_eq(array->type, SPH2D_F64);
    ck_assert_uint_lt(component, array->components);
    return writable(array->data[component]);
}

uint64_t *test_state_counts(test_state *state, sph2d_group group, const char *name)
{
    sph2d_array *array = test_state_array(state, group, name);
    ck_assert_int_eq(array->type, SPH2D_U64);
    return writable(array->data[0]);
}
