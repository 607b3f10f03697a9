/* SPDX-License-Identifier: MIT */
/** @file test_device.c
 *  Simulations on a device: the bits of the processor's baseline, whatever a program does between steps; what is
 *  refused, and why. They need a device that rounds as the processor does; Debian's pocl-opencl-icd is one. */
#include <limits.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "common.h"
#include "device/device.h"
#include "sim/simulation.h"
#include "sph2d/device.h"
#include "sph2d/io.h"

/* ---- scenes ------------------------------------------------------------------------------------------------------ */

#define TANK                                                                                                           \
    "spacing: 0.05\n"                                                                                                  \
    "method: muller\n"                                                                                                 \
    "fluid: {density: 1000, dynamic_viscosity: 1}\n"                                                                   \
    "run: {until: 1}\n"                                                                                                \
    "probes:\n"                                                                                                        \
    "  - {name: energy, kind: energy, every: 0.01}\n"                                                                  \
    "  - {name: speed, kind: speed, at: [0.3, 0.1], every: 0.01}\n"                                                    \
    "  - {name: gauge, kind: pressure, at: [0.4, 0], along: [1, 0], size: 0.1, rise_time: 0.05, every: 0.01}\n"        \
    "  - {name: elevation, kind: elevation, at: [0.4, 0.2], every: 0.01}\n"                                            \
    "  - {name: extent, kind: extent, every: 0.01}\n"                                                                  \
    "  - {name: axes, kind: axes, every: 0.01}\n"                                                                      \
    "  - {name: quality, kind: quality, every: 0.01}\n"                                                                \
    "  - {name: momentum, kind: momentum, every: 0.01}\n"                                                              \
    "  - {name: volume, kind: volume, every: 0.01}\n"                                                                  \
    "  - {name: level, kind: level, every: 0.01}\n"                                                                    \
    "  - {name: tracer, kind: tracer, at: [0.2, 0.2], every: 0.01}\n"                                                  \
    "domain: {min: [0, 0], max: [1, 3]}\n"
#define PUSH "  - {name: push, kind: force, every: 0.01}\n  - {name: work, kind: work, every: 0.01}\n"
#define FED                                                                                                            \
    "sources: [{at: [0.2, 0.5], direction: [0, -1], width: 0.1, speed: 1}]\n"                                          \
    "drains: [{box: {min: [0.9, 0], max: [1, 0.05]}}]\n"                                                               \
    "interactions: [{path: [[0, 0.2, 0.3], [0.1, 0.3, 0.3]], radius: 0.2, acceleration: 5}]\n"
#define BLOCK "blocks: [{box: {min: [0, 0], max: [1, 0.3]}, velocity: [0.3, 0]}]\n"
#define ROCK "obstacles: [{name: rock, circle: {center: [0.6, 0.2], radius: 0.1}}]\n"

static const char *const scenes[] = {
    TANK BLOCK,
    TANK BLOCK FED ROCK "walls: heavy\n",
    TANK BLOCK ROCK "boundary: {left: periodic, right: periodic}\n",
    TANK BLOCK "boundary: {left: open, right: open}\nabsorbers: [{side: right, length: 0.4}]\n",
    TANK "blocks: [{box: {min: [0, 0], max: [0.4, 0.3]}, color: red}, {circle: {center: [0.7, 0.4], radius: 0.1},\n"
         "  velocity: [0, -2]}]\nmotion: {angle: 0.1, frequency: 1}\n"
         "gravity_path: [[0, 0, -9.81], [0.1, 1, -9]]\ncentral_force: {center: [0.5, 0.3], rate: 2}\n",
    TANK "blocks: []\nsources: [{at: [0.5, 0.5], speed: 2, width: 0.2}]\n",
    TANK BLOCK "obstacles: [{box: {min: [0.5, 0.1], max: [0.7, 0.2]}, motion: {rate: 3}}, {box: {min: [0.2, 0.4],\n"
               "  max: [0.3, 0.5]}, motion: {path: [[0, 0, 0], [1, 0.1, -0.1]]}}]\n",
};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

/* With forces on walls, which have to be fetched in each step. */
static const char loaded[] =
    "spacing: 0.05\nmethod: muller\ndomain: {min: [0, 0], max: [1, 3]}\nrun: {until: 1}\n" BLOCK ROCK "probes:\n" PUSH
    "  - {name: rock, kind: force, on: rock, every: 0.01}\n";

static sph2d_scene_file *read_scene(const char *text)
{
    static sph2d_report report;
    sph2d_scene_file *file = NULL;
    sph2d_report_clear(&report);
    ck_assert_msg(sph2d_scene_file_parse(text, strlen(text), "scene", NULL, 0, &file, &report) == SPH2D_OK, "%s",
                  test_report_text(&report));
    return file;
}

/** The first device with the processor's bits. */
static int number(void)
{
    sph2d_device list[8];
    const size_t count = sph2d_devices(list, 8);
    int found = 0;
    for (size_t k = 0; k < count && k < 8 && found == 0; ++k)
        found = list[k].same_bits && list[k].lacks[0] == '\0' ? (int)k + 1 : 0;
    ck_assert_msg(found > 0, "none of %zu devices makes the processor's bits (Debian: pocl-opencl-icd)", count);
    return found;
}

static sph2d_sim *create(const sph2d_scene *scene, bool on_device)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.isa = SPH2D_ISA_BASELINE;
    options.device = on_device ? number() : 0;
    options.same_bits = true;
    return test_create(scene, &options);
}

/* ---- what a program does between steps --------------------------------------------------------------------------- */

static void pull(sph2d_sim *sim)
{
    ck_assert_int_eq(sph2d_sim_set_gravity(sim, (sph2d_vec2){3, -5}), SPH2D_OK);
}

static void point(sph2d_sim *sim)
{
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, (sph2d_vec2){0.55, 0.2}, 0.5, 5), SPH2D_OK);
}

static void let_go(sph2d_sim *sim)
{
    ck_assert_int_eq(sph2d_sim_set_pointer(sim, (sph2d_vec2){0, 0}, 0, 0), SPH2D_OK);
}

static void take(sph2d_sim *sim)
{
    const sph2d_shape shape = {.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.3, 0.16}, 0.08}};
    ck_assert_int_eq(sph2d_sim_remove_particles(sim, &shape, NULL), SPH2D_OK);
}

static void pour(sph2d_sim *sim)
{
    const sph2d_particle drops[] = {{.x = 0.4, .y = 0.5, .vx = 1}, {.x = 0.47, .y = 0.5, .color = 3}};
    ck_assert_int_eq(sph2d_sim_add_particles(sim, drops, 2, NULL), SPH2D_OK);
}

/** So many that all arrays move. */
static void flood(sph2d_sim *sim)
{
    enum { MANY = 700 };
    sph2d_particle drops[MANY];
    for (size_t k = 0; k < MANY; ++k)
        drops[k] = (sph2d_particle){.x = 0.025 + 0.05 * (double)(k % 20), .y = 0.7 + 0.05 * (double)(k / 20)};
    ck_assert_int_eq(sph2d_sim_add_particles(sim, drops, MANY, NULL), SPH2D_OK);
}

static void drain(sph2d_sim *sim)
{
    const sph2d_shape all = {.kind = SPH2D_SHAPE_BOX, .box = {{-9, -9}, {9, 9}}};
    ck_assert_int_eq(sph2d_sim_remove_particles(sim, &all, NULL), SPH2D_OK);
}

static void look(sph2d_sim *sim)
{
    sph2d_sample sample;
    sph2d_sim_sample(sim, (sph2d_vec2){0.3, 0.1}, &sample);
    (void)sph2d_sim_fluid(sim);
    (void)sph2d_sim_densities(sim);
}

typedef void edit(sph2d_sim *sim);
static edit *const edits[] = {look, pull, point, take, pour, let_go, flood, take, drain, pour};
enum { EDITS = sizeof edits / sizeof edits[0] };

/** Whether samples are the same, too, which test_same() leaves out. */
static void same_samples(const sph2d_sim *a, const sph2d_sim *b)
{
    for (int k = 0; k < 12; ++k) {
        const sph2d_vec2 at = {0.08 * k, 0.05 * k};
        sph2d_sample u, v;
        ck_assert_int_eq(sph2d_sim_sample(a, at, &u), sph2d_sim_sample(b, at, &v));
        ck_assert_msg(memcmp(&u, &v, sizeof u) == 0, "the sample at (%g, %g)", at.x, at.y);
    }
    const sph2d_densities u = sph2d_sim_densities(a), v = sph2d_sim_densities(b);
    ck_assert(memcmp(&u.reported, &v.reported, sizeof u.reported) == 0 &&
              memcmp(&u.counted, &v.counted, sizeof u.counted) == 0 &&
              memcmp(&u.covered, &v.covered, sizeof u.covered) == 0);
}

static void compare(const char *text)
{
    sph2d_scene_file *file = read_scene(text);
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    sph2d_sim *here = create(scene, false), *there = create(scene, true);
    char when[64];
    test_same(there, here, "at the start");
    for (int k = 0; k < EDITS; ++k) {
        test_steps(here, 7);
        test_steps(there, 7);
        snprintf(when, sizeof when, "after edit %d and 7 steps", k);
        test_same(there, here, when);
        same_samples(there, here);
        edits[k](here);
        edits[k](there);
        snprintf(when, sizeof when, "at edit %d", k);
        test_same(there, here, when);
    }
    ck_assert_uint_gt(sph2d_sim_device_memory(there), 0);
    ck_assert_uint_eq(sph2d_sim_device_memory(here), 0);
    sph2d_sim_destroy(here);
    sph2d_sim_destroy(there);
    sph2d_scene_file_destroy(file);
}

START_TEST(the_bits_are_those_of_baseline)
{
    compare(scenes[_i]);
}
END_TEST

START_TEST(so_are_forces_on_walls)
{
    compare(loaded);
}
END_TEST

/** Many steps that nothing looks at: what the host has of them is old, and nothing but the state has to be fetched. */
START_TEST(a_state_goes_on_here_and_there)
{
    sph2d_scene_file *file = read_scene(scenes[1]);
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    sph2d_sim_options options = sph2d_sim_options_default();
    sph2d_sim *whole = create(scene, false), *part = create(scene, true);
    test_steps(whole, 60);
    for (int k = 0; k < 4; ++k) { /* there, here, there, here */
        test_steps(part, 15);
        sph2d_sim *next = NULL;
        const sph2d_state state = sph2d_sim_state(part);
        options.device = k % 2 ? number() : 0;
        ck_assert_int_eq(sph2d_sim_restore(scene, &options, &state, &next, NULL), SPH2D_OK);
        sph2d_sim_destroy(part);
        part = next;
    }
    test_same(part, whole, "after four parts");
    sph2d_sim_destroy(whole);
    sph2d_sim_destroy(part);
    sph2d_scene_file_destroy(file);
}
END_TEST

/** What is asked for is fetched, once, and no more. */
START_TEST(hands_over_what_is_asked_for)
{
    sph2d_scene_file *file = read_scene("spacing: 0.05\nmethod: muller\ndomain: {min: [0, 0], max: [1, 3]}\n" BLOCK);
    sph2d_sim *sim = create(sph2d_scene_file_scene(file), true);
    test_steps(sim, 3);
    const sph2d_device_use before = sph2d_sim_device_use(sim);
    const size_t count = sph2d_sim_count(sim);
    ck_assert_uint_gt(count, 0);
    ck_assert_uint_eq(sph2d_sim_device_use(sim).fetched, before.fetched);
    ck_assert_str_eq(sph2d_field(NULL, SPH2D_GROUP_FLUID, 0).name, "Coordinates");
    const sph2d_array at = sph2d_field(sim, SPH2D_GROUP_FLUID, 0);
    const sph2d_device_use placed = sph2d_sim_device_use(sim);
    ck_assert_uint_ge(placed.fetched - before.fetched, 16 * count);
    const sph2d_view seen = sph2d_sim_fluid(sim);
    const sph2d_device_use all = sph2d_sim_device_use(sim);
    ck_assert_uint_eq(seen.count, count);
    ck_assert_ptr_eq(seen.x, at.data[0]);
    ck_assert_uint_ge(all.fetched - placed.fetched, 5 * (placed.fetched - before.fetched) / 2); /* 5 to 7 of 2 */
    ck_assert_uint_eq(all.waits, placed.waits + 1);
    (void)sph2d_sim_fluid(sim);
    ck_assert_uint_eq(sph2d_sim_device_use(sim).fetched, all.fetched);
    sph2d_sim_destroy(sim);
    sph2d_scene_file_destroy(file);
}
END_TEST

START_TEST(two_at_a_time)
{
    sph2d_scene_file *file = read_scene(scenes[1]);
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    sph2d_sim *a = create(scene, true), *b = create(scene, true);
    for (int k = 0; k < 10; ++k) {
        test_steps(a, 1);
        test_steps(b, 1);
    }
    test_same(a, b, "step by step");
    sph2d_sim_destroy(a);
    test_steps(b, 5);
    sph2d_sim_destroy(b);
    sph2d_scene_file_destroy(file);
}
END_TEST

/* The first that a process asks of drivers comes from several threads at once. */
enum { THREADS = 4 };

static void *run_of_its_own(void *scene)
{
    sph2d_report report = {0};
    sph2d_sim_options options = sph2d_sim_options_default();
    options.device = number();
    sph2d_sim *sim = NULL;
    sph2d_status status = sph2d_sim_create(scene, &options, &sim, &report);
    for (int k = 0; k < 5 && status == SPH2D_OK; ++k)
        status = sph2d_sim_step(sim, &report);
    return sim;
}

START_TEST(several_threads_at_once)
{
    sph2d_scene_file *file = read_scene(scenes[1]);
    pthread_t threads[THREADS];
    void *sims[THREADS];
    for (int k = 0; k < THREADS; ++k)
        ck_assert_int_eq(
            pthread_create(&threads[k], NULL, run_of_its_own, (void *)(uintptr_t)sph2d_scene_file_scene(file)), 0);
    for (int k = 0; k < THREADS; ++k)
        ck_assert_int_eq(pthread_join(threads[k], &sims[k]), 0);
    for (int k = 0; k < THREADS; ++k) {
        ck_assert_ptr_nonnull(sims[k]);
        test_same(sims[k], sims[0], "in a thread");
    }
    for (int k = 0; k < THREADS; ++k)
        sph2d_sim_destroy(sims[k]);
    sph2d_scene_file_destroy(file);
}
END_TEST

/** A run by another instruction set goes on as baseline, and says so. */
START_TEST(a_state_of_another_instruction_set)
{
    sph2d_scene_file *file = read_scene(scenes[0]);
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    sph2d_sim *here = test_create(scene, NULL), *there = NULL;
    test_steps(here, 3);
    sph2d_sim_options options = sph2d_sim_options_default();
    options.device = number();
    const sph2d_state state = sph2d_sim_state(here);
    ck_assert_int_eq(sph2d_sim_restore(scene, &options, &state, &there, NULL), SPH2D_OK);
    ck_assert_int_eq(sph2d_sim_isa(there), SPH2D_ISA_BASELINE);
    test_steps(there, 3);
    sph2d_sim_destroy(here);
    sph2d_sim_destroy(there);
    sph2d_scene_file_destroy(file);
}
END_TEST

/** More arrays than the list of blocks has room for at first. */
START_TEST(a_scene_with_many_obstacles)
{
    enum { MANY = 220 };
    static char text[64 * 1024];
    size_t at = (size_t)snprintf(
        text, sizeof text,
        "spacing: 0.05\nmethod: muller\ndomain: {min: [0, 0], max: [1, 30]}\nrun: {until: 1}\n" BLOCK "obstacles:\n");
    for (int k = 0; k < MANY; ++k) {
        const double low = 1 + 0.12 * k;
        at += (size_t)snprintf(
            text + at, sizeof text - at,
            "  - {name: o%d, box: {min: [0.4, %.2f], max: [0.5, %.2f]}, motion: {amplitude: [0.02, 0], "
            "frequency: 2}}\n",
            k, low, low + 0.05);
    }
    sph2d_scene_file *file = read_scene(text);
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    sph2d_sim *here = create(scene, false), *there = create(scene, true);
    test_steps(here, 3);
    test_steps(there, 3);
    test_same(here, there, "many obstacles");
    sph2d_sim_destroy(here);
    sph2d_sim_destroy(there);
    sph2d_scene_file_destroy(file);
}
END_TEST

/** Sends the blocks of a list: the kernel's one thread writes where no block is. */
static void send_list(sph2d__device *device)
{
    const uint64_t none = 0;
    (void)sph2d__device_moved(device);
    sph2d__device_run(device, "multiply_add", 1, &none, sizeof none, 0);
}

/** Of a block that was in no list for a while nothing is known: another one may be where it was, of the same size. */
START_TEST(a_block_in_the_place_of_another)
{
    enum { COUNT = 64 };
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    double block[COUNT] = {1}, other[COUNT] = {0};
    sph2d_status status;
    sph2d__device *device = sph2d__device_open(number(), "machine", 0, false, &memory, &status, NULL);
    ck_assert_ptr_nonnull(device);
    for (int k = 0; k < 4; ++k) {
        block[0] = k;
        sph2d__device_list(device);
        sph2d__device_place(device, other, sizeof other, SPH2D__OF_FLUID);
        if (k % 3 == 0)
            sph2d__device_place(device, block, sizeof block, SPH2D__OF_FLUID);
        send_list(device);
    }
    sph2d__device_changed_on(device, block);
    sph2d__device_fetch(device, block);
    ck_assert_double_eq(block[0], 3);
    sph2d__device_close(device, &memory);
}
END_TEST

/** Small blocks and arguments are sent when the device comes to them, though the host goes on; results of no particles are no
 *  reason to think that it has come so far. */
START_TEST(what_is_sent_stays_as_it_was)
{
    enum { BLOCKS = 200, ROOM = 8 };
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    static double blocks[BLOCKS][ROOM];
    const uint64_t none = 0;
    sph2d_status status;
    sph2d__device *device = sph2d__device_open(number(), "machine", 0, false, &memory, &status, NULL);
    ck_assert_ptr_nonnull(device);
    sph2d__device_list(device);
    for (int k = 0; k < BLOCKS; ++k)
        sph2d__device_place(device, blocks[k], sizeof blocks[k], SPH2D__OF_FLUID);
    send_list(device);
    for (int k = 0; k < BLOCKS; ++k) {
        blocks[k][0] = k + 1;
        sph2d__device_changed_one(device, blocks[k]);
        sph2d__device_run(device, "multiply_add", 1, &none, sizeof none, 0);
        ck_assert_ptr_nonnull(sph2d__device_results(device, "multiply_add", 0, &none, sizeof none, 0, sizeof none));
    }
    for (int k = 0; k < BLOCKS; ++k) {
        blocks[k][0] = 0;
        sph2d__device_changed_on(device, blocks[k]);
        sph2d__device_fetch(device, blocks[k]);
        ck_assert_double_eq(blocks[k][0], k + 1);
    }
    sph2d__device_changed(device, SPH2D__OF_FLUID);
    sph2d__device_run(device, "multiply_add", 1, &none, sizeof none, 0);
    sph2d__device_close(device, &memory); /* which waits */
}
END_TEST

/* ---- a device that fails ----------------------------------------------------------------------------------------- */

/** The run ends, says why and when, and what was known before can still be asked for. */
START_TEST(a_failure_ends_the_run)
{
    static sph2d_report report;
    sph2d_scene_file *file = read_scene(scenes[1]);
    sph2d_sim *sim = create(sph2d_scene_file_scene(file), true);
    test_steps(sim, 3);
    ck_assert_int_eq(sph2d_sim_device_status(sim, NULL), SPH2D_OK);
    sph2d__device_give_up(sim->system.device, "it was taken away");
    ck_assert_int_eq(sph2d_sim_device_status(sim, NULL), SPH2D_DEVICE);
    ck_assert_uint_eq(sph2d_sim_state(sim).array_count, 0); /* it would be one of two steps */
    ck_assert_int_eq(sph2d_snapshot_write(sim, file, 0, "a.h5", NULL), SPH2D_DEVICE);
    ck_assert_int_ne(access("a.h5", F_OK), 0);
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_sim_step(sim, &report), SPH2D_DEVICE);
    ck_assert_uint_eq(report.errors, 1);
    ck_assert_int_eq(report.items[0].code, SPH2D_CODE_DEVICE);
    ck_assert_msg(strstr(report.items[0].message, "it was taken away"), "%s", report.items[0].message);
    ck_assert_int_eq(sph2d_sim_step(sim, NULL), SPH2D_DEVICE);
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, sim->system.fluid.count);
    sph2d_sample sample;
    sph2d_sim_sample(sim, (sph2d_vec2){0.3, 0.1}, &sample);
    (void)sph2d_sim_summary(sim);
    for (size_t k = 0; k < sph2d_sim_scene(sim)->probe_count; ++k) {
        double values[SPH2D_PROBE_MAX_COLUMNS];
        sph2d_sim_probe(sim, k, values);
    }
    sph2d_sim_destroy(sim);
    sph2d_scene_file_destroy(file);
}
END_TEST

/* ---- memory ------------------------------------------------------------------------------------------------------ */

/** How many allocations are left until one fails, and the bytes that are held. */
typedef struct budget {
    long left;
    size_t held;
} budget;

static void *take_memory(void *user, void *block, size_t old_size, size_t new_size)
{
    budget *b = user;
    if (new_size > 0 && b->left-- <= 0)
        return NULL;
    void *fresh = test_resize(block, old_size, new_size);
    b->held += new_size - old_size;
    return fresh;
}

/** Runs until an allocation fails; true when none has. */
static bool run_within(const sph2d_scene *scene, budget *b)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.device = number();
    options.allocator = (sph2d_allocator){take_memory, b};
    sph2d_sim *sim = NULL;
    sph2d_status status = sph2d_sim_create(scene, &options, &sim, NULL);
    ck_assert_msg(status == SPH2D_OK || (status == SPH2D_NOMEM && !sim), "%s", sph2d_status_name(status));
    for (int k = 0; k < 3 && status == SPH2D_OK; ++k)
        status = sph2d_sim_step(sim, NULL);
    (void)sph2d_sim_summary(sim);
    (void)sph2d_sim_fluid(sim);
    sph2d_sim_destroy(sim);
    ck_assert_uint_eq(b->held, 0);
    ck_assert_msg(status == SPH2D_OK || status == SPH2D_NOMEM, "%s", sph2d_status_name(status));
    return status == SPH2D_OK;
}

START_TEST(each_allocation_fails_once)
{
    sph2d_scene_file *file = read_scene(loaded);
    for (long most = 0;; ++most) {
        budget b = {.left = most};
        if (run_within(sph2d_scene_file_scene(file), &b))
            break;
    }
    sph2d_scene_file_destroy(file);
}
END_TEST

static void take_count(void *to, const void *results, size_t groups)
{
    (void)results;
    *(size_t *)to = groups;
}

/** Results for which the host has no room end the device's work: its kernel has not run, and those that were to come later are none. */
START_TEST(room_for_results_is_missing)
{
    budget b = {.left = LONG_MAX};
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){take_memory, &b});
    sph2d_status status;
    const char *why, *kernel;
    sph2d__device *device = sph2d__device_open(number(), "muller", 0, false, &memory, &status, NULL);
    ck_assert_ptr_nonnull(device);
    ck_assert(!sph2d__device_failed(device, &why, &kernel));
    b.left = 0;
    size_t groups = SIZE_MAX;
    sph2d__device_results_later(device, "layout", 1, NULL, 0, 0, 1000, take_count, &groups);
    ck_assert_uint_eq(groups, 0);
    ck_assert_ptr_null(sph2d__device_results(device, "layout", 1, NULL, 0, 0, 1000));
    ck_assert(sph2d__device_failed(device, &why, &kernel));
    ck_assert_str_eq(kernel, "layout");
    sph2d__device_close(device, &memory);
    ck_assert_uint_eq(b.held, 0);
}
END_TEST

/* ---- refusals ---------------------------------------------------------------------------------------------------- */

static void refused(const char *text, const sph2d_sim_options *options, sph2d_status wanted, const char *said)
{
    static sph2d_report report;
    sph2d_scene_file *file = read_scene(text);
    sph2d_sim *sim = NULL;
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_sim_create(sph2d_scene_file_scene(file), options, &sim, &report), wanted);
    ck_assert_ptr_null(sim);
    ck_assert_uint_eq(report.errors, 1);
    ck_assert_msg(strstr(test_report_text(&report), said), "no '%s' in: %s", said, test_report_text(&report));
    sph2d_scene_file_destroy(file);
}

START_TEST(scenes_that_no_device_takes)
{
    static const struct {
        const char *more, *said;
    } others[] = {
        {"method: pcisph\n", "method"},
        {"fluid: {model: herschel_bulkley, consistency: 1, index: 1, yield_stress: 10}\n", "viscosity"},
        {"wall_slip: smooth\nfluid: water\n", "smooth"},
        {"side_slip: {right: smooth}\nfluid: water\n", "smooth"},
        {"obstacles: [{box: {min: [0.6, 0.4], max: [0.7, 0.5]}, slip: smooth}]\nfluid: water\n", "smooth"},
        {"method: muller\nbodies: [{circle: {center: [0.5, 0.5], radius: 0.1}, density: 500}]\n", "bodies"},
        {"method: hybrid\nobstacles: [{box: {min: [0.6, 0.4], max: [0.7, 0.5]}, motion: {amplitude: [0.02, 0], "
         "frequency: 2}}]\n",
         "move"},
        {"method: muller\nwalls: reflect\n", "reflect"},
        {"method: muller\nfluid: {surface_tension: 0.07}\n", "surface tension"},
    };
    static const char begin[] = "spacing: 0.05\ndomain: {min: [0, 0], max: [1, 0.6]}\nrun: {until: 1}\n" BLOCK;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.device = number();
    for (size_t k = 0; k < sizeof others / sizeof *others; ++k) {
        char text[1000];
        snprintf(text, sizeof text, "%s%s", begin, others[k].more);
        sph2d_scene_file *file = read_scene(text);
        const char *why = sph2d_device_refuses(sph2d_scene_file_scene(file));
        ck_assert_msg(why && strstr(why, others[k].said), "%s: %s", others[k].more, why ? why : "taken");
        sph2d_scene_file_destroy(file);
        refused(text, &options, SPH2D_SCENE, why);
    }
    ck_assert_ptr_nonnull(sph2d_device_refuses(NULL));
}
END_TEST

START_TEST(options_that_cannot_be)
{
    const int beyond = (int)sph2d_devices(NULL, 0) + 1, wrong[] = {-1, beyond, 1000000};
    sph2d_sim_options options = sph2d_sim_options_default();
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; ++k) {
        options.device = wrong[k];
        refused(scenes[0], &options, SPH2D_INVALID, "there is no device");
    }
    options.device = number();
    options.isa = SPH2D_ISA_AVX2;
    if (sph2d_isa_available(SPH2D_ISA_AVX2))
        refused(scenes[0], &options, SPH2D_INVALID, "instruction set 'avx2'");
}
END_TEST

START_TEST(the_list_of_devices)
{
    sph2d_device list[3] = {0}, again = {0};
    const size_t count = sph2d_devices(NULL, 0), told = sph2d_devices(list, 2);
    ck_assert_uint_gt(count, 0);
    ck_assert_uint_eq(told, count);
    ck_assert_uint_eq(sph2d_devices(&again, 1), count);
    ck_assert_mem_eq(&again, &list[0], sizeof again);
    ck_assert(list[0].name[0] != '\0' && list[0].platform[0] != '\0' && list[0].memory > 0);
    ck_assert(list[0].largest > 0 && list[0].largest <= list[0].memory && list[0].units > 0);
    ck_assert(list[2].name[0] == '\0'); /* beyond the room */
}
END_TEST

Suite *suite_device(void)
{
    Suite *suite = suite_create("device");
    TCase *tests = tcase_create("device");
    tcase_set_timeout(tests, 60); /* the first compiles the kernels */
    tcase_add_loop_test(tests, the_bits_are_those_of_baseline, 0, SCENES);
    tcase_add_test(tests, so_are_forces_on_walls);
    tcase_add_test(tests, a_state_goes_on_here_and_there);
    tcase_add_test(tests, hands_over_what_is_asked_for);
    tcase_add_test(tests, two_at_a_time);
    tcase_add_test(tests, several_threads_at_once);
    tcase_add_test(tests, a_state_of_another_instruction_set);
    tcase_add_test(tests, a_scene_with_many_obstacles);
    tcase_add_test(tests, a_block_in_the_place_of_another);
    tcase_add_test(tests, what_is_sent_stays_as_it_was);
    tcase_add_test(tests, scenes_that_no_device_takes);
    tcase_add_test(tests, options_that_cannot_be);
    tcase_add_test(tests, the_list_of_devices);
    tcase_add_test(tests, a_failure_ends_the_run);
    tcase_add_test(tests, each_allocation_fails_once);
    tcase_add_test(tests, room_for_results_is_missing);
    suite_add_tcase(suite, tests);
    return suite;
}
