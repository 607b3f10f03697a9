/* SPDX-License-Identifier: MIT */
/** @file test_parallel.c
 *  Threads are those of OpenMP: how many a step gets, who takes part, and that programs with threads, regions and forks
 *  of their own meet no surprise. */
#include <math.h>
#include <pthread.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/parallel.h"
#include "common.h"
#include "run/run.h"

/** A column of water of about so many particles. */
static sph2d_sim *column(double particles, int threads)
{
    sph2d_scene scene = test_scene(sqrt(0.5 / particles), 0, 0, 1, 1);
    sph2d_block block = test_block(0, 0, 0.5, 1);
    sph2d_sim_options options = sph2d_sim_options_default();
    scene.gravity.y = -9.81;
    scene.blocks = &block;
    scene.block_count = 1;
    options.threads = threads;
    return test_create(&scene, &options);
}

enum { STEPS = 8 };

/** What some steps of a column come to: a sum of all bits of its positions. */
static uint64_t fate(sph2d_sim *sim)
{
    test_steps(sim, STEPS);
    sph2d_view fluid = sph2d_sim_fluid(sim);
    uint64_t sum = 0;
    for (size_t i = 0; i < fluid.count; ++i) {
        uint64_t bits[2];
        memcpy(&bits[0], &fluid.x[i], sizeof bits[0]);
        memcpy(&bits[1], &fluid.y[i], sizeof bits[1]);
        sum = sum * 31 + bits[0] + 7 * bits[1];
    }
    sph2d_sim_destroy(sim);
    return sum;
}

enum { MANY = 3000 };

static uint64_t expected; /* of a column of MANY particles, by one thread */

static void begin(void)
{
    expected = fate(column(MANY, 1));
}

/* ---- how many ---------------------------------------------------------------------------------------------------- */

START_TEST(loops_have_as_many_tasks_as_are_worth_it)
{
    ck_assert_int_eq(sph2d__threads(), 1);
    ck_assert_int_eq(sph2d__tasks(0, 10), 1);
    ck_assert_int_eq(sph2d__tasks(29, 10), 2);
    ck_assert_int_eq(sph2d__tasks(310, 10), 4);
    ck_assert_int_eq(sph2d__tasks(1000, 10), 12);
    ck_assert_int_eq(sph2d__tasks(9000, 10), 16);
#ifdef _OPENMP
    int tasks = -1;
#pragma omp parallel num_threads(3)
#pragma omp master
    tasks = sph2d__tasks(900, 10) - 4 * sph2d__threads();
    ck_assert_int_eq(tasks, 0);
#endif
}
END_TEST

START_TEST(the_number_asked_for_is_used)
{
    sph2d_sim *sim = column(100, 3);
#ifdef _OPENMP
    ck_assert_int_eq(sph2d_sim_threads(sim), 3);
#else
    ck_assert_int_eq(sph2d_sim_threads(sim), 1);
#endif
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(few_particles_get_few_threads)
{
#ifdef _OPENMP
    omp_set_num_threads(3);
    static const double sizes[] = {400, 1000, 1800, 4000};
    static const int threads[] = {1, 2, 3, 3};
    for (int k = 0; k < 4; ++k) {
        sph2d_sim *sim = column(sizes[k], 0);
        ck_assert_int_eq(sph2d_sim_threads(sim), threads[k]);
        sph2d_sim_destroy(sim);
    }
    omp_set_num_threads(1);
    sph2d_sim *sim = column(4000, 0);
    ck_assert_int_eq(sph2d_sim_threads(sim), 1);
    sph2d_sim_destroy(sim);
#endif
}
END_TEST

static bool until_done(void *left, sph2d_sim *sim)
{
    (void)sim;
    return --*(int *)left >= 0;
}

START_TEST(a_run_is_its_steps)
{
    sph2d_sim *steps = column(MANY, 2), *run = column(MANY, 2);
    int none = 0, left = STEPS;
    test_steps(steps, STEPS);
    ck_assert_int_eq(sph2d_sim_run(run, until_done, &none, NULL), SPH2D_OK);
    ck_assert_uint_eq(sph2d_sim_steps(run), 0);
    ck_assert_int_eq(sph2d_sim_run(run, until_done, &left, NULL), SPH2D_OK);
    ck_assert_uint_eq(sph2d_sim_steps(run), STEPS);
    ck_assert_uint_eq(fate(steps), fate(run));
}
END_TEST

#ifdef _OPENMP
static bool gives_particles(void *left, sph2d_sim *sim)
{
    enum { ACROSS = 17, MORE = ACROSS * 38 };
    if (*(int *)left == STEPS) {
        sph2d_particle more[MORE] = {{0}};
        size_t added = 0;
        for (int k = 0; k < MORE; ++k) {
            more[k].x = 0.55 + 0.025 * (k % ACROSS);
            more[k].y = 0.03 + 0.025 * (k / ACROSS);
        }
        ck_assert_int_eq(sph2d_sim_add_particles(sim, more, MORE, &added), SPH2D_OK);
        ck_assert_uint_eq(added, MORE);
    }
    return until_done(left, sim);
}
#endif

/* More particles get more threads, in the midst of a run; and a list of numbers has another one for inner regions. */
START_TEST(threads_follow_the_particles)
{
#ifdef _OPENMP
    omp_set_num_threads(2);
    sph2d_sim *sim = column(700, 0);
    int left = STEPS;
    ck_assert_int_eq(sph2d_sim_threads(sim), 1);
    ck_assert_int_eq(sph2d_sim_run(sim, gives_particles, &left, NULL), SPH2D_OK);
    ck_assert_uint_eq(sph2d_sim_steps(sim), STEPS);
    ck_assert_int_eq(sph2d_sim_threads(sim), 2);
    sph2d_sim_destroy(sim);
#endif
}
END_TEST

START_TEST(a_stopped_run_is_not_asked)
{
    sph2d_sim *sim = column(MANY, 2);
    int left = STEPS;
    sim->system.fluid.x[5] = NAN;
    sph2d_report report = {0};
    ck_assert_int_eq(sph2d_sim_run(sim, until_done, &left, &report), SPH2D_GUARD);
    sph2d_report_clear(&report);
    int before = left;
    ck_assert_int_eq(sph2d_sim_run(sim, until_done, &left, &report), SPH2D_GUARD);
    ck_assert_int_eq(left, before);
    ck_assert_ptr_nonnull(strstr(report.items[0].message, "takes no more steps"));
    sph2d_report_clear(&report);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- who takes part ---------------------------------------------------------------------------------------------- */

#ifdef _OPENMP

/** Waits in a task until `wanted` threads have come, or for some seconds. */
static void meet(int *come, int wanted)
{
    double begun = omp_get_wtime();
    int now;
#pragma omp atomic capture
    now = ++*come;
    while (now < wanted && omp_get_wtime() - begun < 20) {
#pragma omp atomic read
        now = *come;
    }
}

START_TEST(tasks_are_shared)
{
    int come = 0, seen[3] = {0};
#pragma omp parallel num_threads(3)
#pragma omp master
    {
#pragma omp taskloop num_tasks(3) shared(come, seen)
        for (int k = 0; k < 3; ++k) {
            seen[omp_get_thread_num()] = 1;
            meet(&come, 3);
        }
    }
    ck_assert_int_eq(seen[0] + seen[1] + seen[2], 3);
}
END_TEST

#endif

START_TEST(threads_do_not_change_bits)
{
    ck_assert_uint_eq(fate(column(MANY, _i)), expected);
}
END_TEST

/* ---- hosts with threads of their own ----------------------------------------------------------------------------- */

static void *one_step(void *sim)
{
    test_steps(sim, 1);
    return NULL;
}

static void *run_alone(void *fate_)
{
    *(uint64_t *)fate_ = fate(column(MANY, 2));
    return NULL;
}

START_TEST(threads_of_the_host_have_simulations_side_by_side)
{
    enum { HOSTS = 4 };
    pthread_t hosts[HOSTS];
    uint64_t fates[HOSTS];
    for (int k = 0; k < HOSTS; ++k)
        ck_assert_int_eq(pthread_create(&hosts[k], NULL, run_alone, &fates[k]), 0);
    for (int k = 0; k < HOSTS; ++k) {
        pthread_join(hosts[k], NULL);
        ck_assert_uint_eq(fates[k], expected);
    }
}
END_TEST

/* LLVM's runtime breaks down after a few such threads, if they have others do their tasks. */
START_TEST(a_simulation_moves_from_thread_to_thread)
{
    enum { TURNS = 40 };
    sph2d_sim *sim = column(MANY, 2);
    for (int k = 0; k < TURNS; ++k) {
        pthread_t host;
        ck_assert_int_eq(pthread_create(&host, NULL, one_step, sim), 0);
        pthread_join(host, NULL);
    }
    ck_assert_uint_eq(sph2d_sim_steps(sim), TURNS);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(regions_of_the_host_have_simulations_side_by_side)
{
    enum { HOSTS = 6 };
    uint64_t fates[HOSTS];
#pragma omp parallel for num_threads(3) schedule(dynamic)
    for (int k = 0; k < HOSTS; ++k)
        fates[k] = fate(column(MANY, 2));
    for (int k = 0; k < HOSTS; ++k)
        ck_assert_uint_eq(fates[k], expected);
}
END_TEST

/* ---- forks ------------------------------------------------------------------------------------------------------- */

/** Whether a child, which may take 60 s, ends with 0. */
static bool child_is_well(pid_t child)
{
    int how = -1;
    return child > 0 && waitpid(child, &how, 0) == child && WIFEXITED(how) && WEXITSTATUS(how) == 0;
}

START_TEST(a_fork_goes_on_with_its_copy)
{
    sph2d_sim *sim = column(MANY, 2);
    test_steps(sim, STEPS / 2);
    pid_t child = fork();
    if (child == 0) {
        test_limit(60);
        test_steps(sim, STEPS / 2);
        bool same = fate(column(MANY, 2)) == expected;
        sph2d_sim_destroy(sim);
        _exit(!same);
    }
    test_steps(sim, STEPS / 2);
    sph2d_sim_destroy(sim);
    ck_assert(child_is_well(child));
    ck_assert_uint_eq(fate(column(MANY, 2)), expected);
}
END_TEST

static void *fork_and_wait(void *well)
{
    pid_t child = fork();
    if (child == 0) {
        test_limit(60);
        _exit(fate(column(MANY, 2)) != expected);
    }
    *(bool *)well = child_is_well(child);
    return NULL;
}

START_TEST(another_thread_forks)
{
    bool well = false;
    pthread_t host;
    ck_assert_uint_eq(fate(column(MANY, 2)), expected);
    ck_assert_int_eq(pthread_create(&host, NULL, fork_and_wait, &well), 0);
    pthread_join(host, NULL);
    ck_assert(well);
}
END_TEST

Suite *suite_parallel(void)
{
    Suite *suite = suite_create("parallel");
    TCase *core = tcase_create("threads"), *forks = tcase_create("forks");
    tcase_add_checked_fixture(core, begin, NULL);
    tcase_add_checked_fixture(forks, begin, NULL);
    tcase_add_test(core, loops_have_as_many_tasks_as_are_worth_it);
    tcase_add_test(core, the_number_asked_for_is_used);
    tcase_add_test(core, few_particles_get_few_threads);
    tcase_add_test(core, a_run_is_its_steps);
    tcase_add_test(core, threads_follow_the_particles);
    tcase_add_test(core, a_stopped_run_is_not_asked);
#ifdef _OPENMP
    tcase_add_test(core, tasks_are_shared);
#endif
    tcase_add_loop_test(core, threads_do_not_change_bits, 2, 6);
    tcase_add_test(core, threads_of_the_host_have_simulations_side_by_side);
    tcase_add_test(core, a_simulation_moves_from_thread_to_thread);
    tcase_add_test(core, regions_of_the_host_have_simulations_side_by_side);
    tcase_add_test(forks, a_fork_goes_on_with_its_copy);
    tcase_add_test(forks, another_thread_forks);
    suite_add_tcase(suite, core);
    suite_add_tcase(suite, forks);
    return suite;
}
