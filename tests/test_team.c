/* SPDX-License-Identifier: MIT */
/** @file test_team.c
 *  Loops that threads share: every index once, whoever comes late; helpers that sleep, end, or are not there after a
 *  fork. */
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "base/team.h"
#include "common.h"

static sph2d__memory memory;

static void begin(void)
{
    memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
}

static void finish(void)
{
    ck_assert_uint_eq(memory.bytes, 0);
}

static double clock_of(clockid_t id)
{
    struct timespec t;
    clock_gettime(id, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void doze(double seconds)
{
    nanosleep(&(struct timespec){(time_t)seconds, (long)(1e9 * (seconds - (double)(time_t)seconds))}, NULL);
}

/* ---- every index once -------------------------------------------------------------------------------------------- */

enum { MOST = 5000 };

/** How often each index was worked on, by whom, and in which parts. */
typedef struct tally {
    unsigned char times[MOST];
    size_t grain;
    atomic_int crooked; /**< parts that do not begin at a multiple of the grain */
    pthread_t caller;
    atomic_size_t helped; /**< indices that others than the caller did */
} tally;

static void count(void *with, size_t first, size_t last)
{
    tally *t = with;
    t->crooked += first % t->grain != 0 || last <= first;
    for (size_t i = first; i < last; ++i)
        ++t->times[i];
    if (!pthread_equal(pthread_self(), t->caller))
        t->helped += last - first;
}

/** Indices that were not done once, and crooked parts. */
static size_t wrong(const tally *t, size_t indices)
{
    size_t sum = (size_t)t->crooked;
    for (size_t i = 0; i < MOST; ++i)
        sum += t->times[i] != (i < indices);
    return sum;
}

static void check_once(sph2d__team *team, size_t indices, size_t grain)
{
    tally t = {.grain = grain, .caller = pthread_self()};
    sph2d__share(team, indices, grain, count, &t);
    ck_assert_uint_eq(wrong(&t, indices), 0);
}

/* Loops so short that the next begins before a helper has seen the last, and pauses in which helpers fall asleep. */
START_TEST(every_index_is_done_once)
{
    static const int limits[] = {1, 2, 3, 8};
    sph2d__team *team = sph2d__team_create(&memory, limits[_i]);
    ck_assert_int_eq(sph2d__team_limit(team), limits[_i]);
    uint64_t random = 7;
    for (int k = 0; k < 4000; ++k) {
        size_t indices = k < 8 ? (size_t)k : (size_t)test_random(&random, 0, MOST);
        check_once(team, indices, 1 + (size_t)test_random(&random, 0, k % 2 ? 3 : 600));
        if (k % 1000 == 999)
            doze(0.002);
    }
    sph2d__team_destroy(team, &memory);
}
END_TEST

START_TEST(no_team_is_one_thread)
{
    check_once(NULL, MOST, 1);
    ck_assert_int_eq(sph2d__team_limit(NULL), 1);
    ck_assert_int_eq(sph2d__team_members(NULL, MOST, 1), 1);
    sph2d__team_lock(NULL);
    sph2d__team_unlock(NULL);
    sph2d__team_begin(NULL);
    sph2d__team_end(NULL);
    sph2d__team_destroy(NULL, &memory);
}
END_TEST

START_TEST(short_loops_get_few_threads)
{
    sph2d__team *team = sph2d__team_create(&memory, 4);
    static const struct {
        size_t count, grain;
        int members;
    } cases[] = {{0, 1, 1}, {1, 1, 1}, {2, 1, 2}, {399, 200, 1}, {400, 200, 2}, {799, 200, 3}, {9999, 200, 4}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k)
        ck_assert_int_eq(sph2d__team_members(team, cases[k].count, cases[k].grain), cases[k].members);
    sph2d__team_destroy(team, &memory);
}
END_TEST

static void doze_a_little(void *with, size_t first, size_t last)
{
    doze(0.002 * (double)(last - first));
    count(with, first, last);
}

/* Also when there is one processor alone: who dozes leaves it to others. */
START_TEST(helpers_help)
{
    sph2d__team *team = sph2d__team_create(&memory, 3);
    tally t = {.grain = 1, .caller = pthread_self()};
    sph2d__share(team, 60, 1, doze_a_little, &t);
    ck_assert_uint_ge(t.helped, 20);
    sph2d__team_destroy(team, &memory);
}
END_TEST

/** A helper that dozes with its first part in hand while the caller does all the others. */
static void be_late(void *with, size_t first, size_t last)
{
    tally *t = with;
    if (!pthread_equal(pthread_self(), t->caller))
        doze(0.1);
    count(with, first, last);
}

START_TEST(others_do_what_a_late_helper_leaves)
{
    sph2d__team *team = sph2d__team_create(&memory, 2);
    for (int k = 0; k < 3; ++k) {
        tally t = {.grain = 1, .caller = pthread_self()};
        sph2d__share(team, 400, 1, be_late, &t);
        ck_assert_uint_eq(wrong(&t, 400), 0);
        ck_assert_uint_le(t.helped, 2);
    }
    sph2d__team_destroy(team, &memory);
}
END_TEST

/* ---- loops in loops, and sums ------------------------------------------------------------------------------------ */

typedef struct nest {
    sph2d__team *team;
    tally inner[8];
} nest;

static void share_again(void *with, size_t first, size_t last)
{
    nest *n = with;
    for (size_t k = first; k < last; ++k)
        sph2d__share(n->team, 500, 1, count, &n->inner[k]);
}

START_TEST(a_loop_in_a_loop_is_not_shared)
{
    static nest n;
    n.team = sph2d__team_create(&memory, 3);
    for (int k = 0; k < 8; ++k)
        n.inner[k] = (tally){.grain = 1};
    sph2d__share(n.team, 8, 1, share_again, &n);
    for (int k = 0; k < 8; ++k)
        ck_assert_uint_eq(wrong(&n.inner[k], 500), 0);
    sph2d__team_destroy(n.team, &memory);
}
END_TEST

typedef struct total {
    sph2d__team *team;
    size_t sum;
} total;

static void add(void *with, size_t first, size_t last)
{
    total *t = with;
    sph2d__team_lock(t->team);
    for (size_t i = first; i < last; ++i)
        t->sum += i;
    sph2d__team_unlock(t->team);
}

START_TEST(one_at_a_time_under_the_lock)
{
    total t = {.team = sph2d__team_create(&memory, 3)};
    for (int k = 0; k < 200; ++k) {
        t.sum = 0;
        sph2d__share(t.team, 1000, 7, add, &t);
        ck_assert_uint_eq(t.sum, 999 * 500);
    }
    sph2d__team_destroy(t.team, &memory);
}
END_TEST

/* ---- helpers between loops --------------------------------------------------------------------------------------- */

START_TEST(idle_helpers_sleep)
{
    sph2d__team *team = sph2d__team_create(&memory, 3);
    check_once(team, MOST, 1);
    doze(0.02);
    double from = clock_of(CLOCK_PROCESS_CPUTIME_ID);
    doze(0.2);
    ck_assert_double_lt(clock_of(CLOCK_PROCESS_CPUTIME_ID) - from, 0.01);
    check_once(team, MOST, 1);
    sph2d__team_destroy(team, &memory);
}
END_TEST

START_TEST(teams_come_and_go)
{
    for (int k = 0; k < 100; ++k) {
        sph2d__team *team = sph2d__team_create(&memory, 1 + k % 5);
        if (k % 3 > 0)
            check_once(team, 300, 10);
        if (k % 3 > 1)
            doze(0.0003);
        sph2d__team_destroy(team, &memory);
    }
}
END_TEST

static void *share_much(void *argument)
{
    for (int k = 0; k < 500; ++k)
        check_once(argument, MOST, 50);
    return NULL;
}

START_TEST(teams_of_several_threads_do_not_meet)
{
    sph2d__team *teams[3];
    pthread_t threads[3];
    for (int k = 0; k < 3; ++k) {
        teams[k] = sph2d__team_create(&memory, 2);
        ck_assert_int_eq(pthread_create(&threads[k], NULL, share_much, teams[k]), 0);
    }
    for (int k = 0; k < 3; ++k) {
        pthread_join(threads[k], NULL);
        sph2d__team_destroy(teams[k], &memory);
    }
}
END_TEST

START_TEST(any_thread_may_share)
{
    sph2d__team *team = sph2d__team_create(&memory, 2);
    for (int k = 0; k < 3; ++k) {
        pthread_t thread;
        ck_assert_int_eq(pthread_create(&thread, NULL, share_much, team), 0);
        pthread_join(thread, NULL);
        check_once(team, MOST, 50);
    }
    sph2d__team_destroy(team, &memory);
}
END_TEST

/* Where helpers wait, awake or asleep, and where there are none yet. */
START_TEST(a_forked_process_goes_on_alone)
{
    sph2d__team *team = sph2d__team_create(&memory, 3);
    if (_i > 0)
        check_once(team, MOST, 1);
    if (_i > 1)
        doze(0.01);
    pid_t child = fork();
    if (child == 0) {
        for (int k = 0; k < 20; ++k)
            check_once(team, MOST, 10);
        sph2d__team_destroy(team, &memory);
        _exit(memory.bytes == 0 ? 0 : 1);
    }
    int status = 1;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    ck_assert_int_eq(status, 0);
    check_once(team, MOST, 1);
    sph2d__team_destroy(team, &memory);
}
END_TEST

Suite *suite_team(void)
{
    Suite *suite = suite_create("team");
    TCase *tests = tcase_create("team");
    tcase_add_checked_fixture(tests, begin, finish);
    tcase_add_loop_test(tests, every_index_is_done_once, 0, 4);
    tcase_add_test(tests, no_team_is_one_thread);
    tcase_add_test(tests, short_loops_get_few_threads);
    tcase_add_test(tests, helpers_help);
    tcase_add_test(tests, others_do_what_a_late_helper_leaves);
    tcase_add_test(tests, a_loop_in_a_loop_is_not_shared);
    tcase_add_test(tests, one_at_a_time_under_the_lock);
    tcase_add_test(tests, idle_helpers_sleep);
    tcase_add_test(tests, teams_come_and_go);
    tcase_add_test(tests, teams_of_several_threads_do_not_meet);
    tcase_add_test(tests, any_thread_may_share);
    tcase_add_loop_test(tests, a_forked_process_goes_on_alone, 0, 3);
    suite_add_tcase(suite, tests);
    return suite;
}
