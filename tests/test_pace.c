/* SPDX-License-Identifier: MIT */
/** @file test_pace.c
 *  Choosing a number of threads, on made-up machines: what each number of threads gets done is told. */
#include <math.h>

#include "base/pace.h"
#include "common.h"

/** Work a second of so many threads at a time. */
typedef double machine(int threads, double time);

/** What came of some time on a machine. */
typedef struct outcome {
    double work; /**< done */
    int threads; /**< at the end */
} outcome;

/** Goes on with steps of `step` units of work for some time. */
static outcome live(sph2d__pace *p, machine *m, double from, double to, double step)
{
    outcome o = {.threads = p->rival > 0 && p->turn % 2 == 0 ? p->rival : p->chosen};
    for (double time = from; time < to;) {
        double takes = step / m(o.threads, time);
        time += takes;
        o.work += step;
        o.threads = sph2d__pace_note(p, step, takes);
    }
    return o;
}

static double ideal(int threads, double time)
{
    (void)time;
    return 1000 * threads;
}

/** Loops too short: each thread more is a loss. */
static double hopeless(int threads, double time)
{
    (void)time;
    return 1000 / (double)threads;
}

/** Three processors are free. */
static double crowded(int threads, double time)
{
    (void)time;
    return threads <= 3 ? 1000 * threads : 1000;
}

/** Beside another job between seconds 2 and 6 two threads get less done than one. */
static double visited(int threads, double time)
{
    return time < 2 || time >= 6 || threads == 1 ? 1000 * threads : 600;
}

/* Of everything that could be done. Steps of ten microseconds and of 20 ms. */
START_TEST(what_is_best_is_found_and_kept)
{
    static const struct {
        machine *machine;
        int limit, best;
        double least;
    } cases[] = {
        {ideal, 1, 1, 1},       {ideal, 2, 2, 0.985},   {ideal, 8, 8, 0.985},
        {hopeless, 2, 1, 0.98}, {hopeless, 8, 1, 0.95}, {crowded, 8, 2, 1.9 / 3},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k)
        for (int slow = 0; slow < 2; ++slow) {
            sph2d__pace p = sph2d__pace_start(cases[k].limit);
            outcome o = live(&p, cases[k].machine, 0, 20, slow ? 20 : 0.01);
            double most = 0;
            for (int n = 1; n <= cases[k].limit; ++n)
                most = fmax(most, cases[k].machine(n, 0));
            ck_assert_int_eq(p.chosen, cases[k].best);
            ck_assert_double_ge(o.work, (slow ? 0.95 : 1) * cases[k].least * 20 * most);
        }
}
END_TEST

/* Fewer threads soon after another job comes, more soon after it has gone; beside it at least 0.95 of one thread. */
START_TEST(it_gives_way_and_comes_back)
{
    sph2d__pace p = sph2d__pace_start(2);
    live(&p, visited, 0, 2, 0.5);
    ck_assert_int_eq(p.chosen, 2);
    outcome beside = live(&p, visited, 2, 6, 0.5);
    ck_assert_int_eq(p.chosen, 1);
    ck_assert_double_ge(beside.work, 0.95 * 4 * 1000);
    live(&p, visited, 6, 9, 0.5);
    ck_assert_int_eq(p.chosen, 2);
    ck_assert_double_ge(live(&p, visited, 9, 20, 0.5).work, 0.985 * 11 * 2000);
}
END_TEST

/** A machine whose processors others take for slices of 4 ms, two of three at random: then hardly anything is done. */
static double twice;
static uint64_t series;
static double sliced(int threads, double time)
{
    const double slice = 0.004;
    uint64_t random = series + 1000003 * (uint64_t)(time / slice);
    test_random(&random, 0, 1);
    return test_random(&random, 0, 1) < 1 / 3. ? (threads > 1 ? twice : 1) * 1000 : 20;
}

/* Turns then scatter by a factor of ten, and only many of them tell which is better. */
START_TEST(slices_of_others_do_not_deceive)
{
    enum { SERIES = 8 };
    double best = 0, own = 0;
    twice = _i ? 0.8 : 1.8;
    for (series = 1; series <= SERIES; ++series) {
        sph2d__pace one = sph2d__pace_start(_i ? 1 : 2), p = sph2d__pace_start(2);
        own += live(&p, sliced, 0, 5, 0.1).work;
        if (_i)
            best += live(&one, sliced, 0, 5, 0.1).work;
        else
            for (double time = 0; time < 5; best += 0.1)
                time += 0.1 / sliced(2, time);
    }
    ck_assert_double_ge(own / best, 0.9);
}
END_TEST

Suite *suite_pace(void)
{
    Suite *suite = suite_create("pace");
    TCase *tests = tcase_create("pace");
    tcase_add_test(tests, what_is_best_is_found_and_kept);
    tcase_add_test(tests, it_gives_way_and_comes_back);
    tcase_add_loop_test(tests, slices_of_others_do_not_deceive, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
