/* SPDX-License-Identifier: MIT */
/* Runs all suites of suites.h, or those named: check_all [--list] [SUITE...]
 * Check reads CK_FORK, CK_RUN_CASE, CK_VERBOSITY, CK_DEFAULT_TIMEOUT and CK_TIMEOUT_MULTIPLIER from the environment. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#include "suites.h"
#include "time_limits.h"

/* CPU time of a test [s], and how long it may take by the clock, which is for those that wait for ever. */
enum { MOST_CPU = 600, MOST_BY_CLOCK = 1800 };

static const struct {
    const char *name;
    Suite *(*make)(void);
} suites[] = {
#define SUITE_ROW(name) {#name, suite_##name},
    SUITES(SUITE_ROW)
#undef SUITE_ROW
        {NULL, NULL},
};

static bool add_suites(SRunner *runner, const char *name)
{
    bool found = false;
    for (size_t i = 0; suites[i].name; ++i)
        if (!name || strcmp(name, suites[i].name) == 0) {
            srunner_add_suite(runner, suites[i].make());
            found = true;
        }
    return found || !name;
}

/** Each test is a process, which has the limits of this one for itself. */
static void limit_tests(SRunner *runner)
{
    struct rlimit cpu;
    if (srunner_fork_status(runner) != CK_FORK || getrlimit(RLIMIT_CPU, &cpu) != 0)
        return;
    cpu.rlim_cur = MOST_CPU * limits_factor();
    setrlimit(RLIMIT_CPU, &cpu);
}

/** What Check calls a signal or a timeout may be nothing but a limit. */
static void tell_limits(SRunner *runner)
{
    TestResult **failures = srunner_failures(runner);
    bool limited = false;
    for (int i = 0; i < srunner_ntests_failed(runner); ++i)
        limited = limited || strstr(tr_msg(failures[i]), "timeout") || strstr(tr_msg(failures[i]), "CPU time");
    free(failures);
    if (limited)
        fprintf(stderr, "check_all: limits of a test are %u s of CPU time and %u s by the clock; %s\n",
                MOST_CPU * limits_factor(), MOST_BY_CLOCK * limits_factor(), LIMITS_HINT);
}

static int list_suites(void)
{
    for (size_t i = 0; suites[i].name; ++i)
        puts(suites[i].name);
    return EXIT_SUCCESS;
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "--list") == 0)
        return list_suites();
    char limit[16];
    snprintf(limit, sizeof limit, "%d", MOST_BY_CLOCK);
    setenv("CK_DEFAULT_TIMEOUT", limit, 0);
    SRunner *runner = srunner_create(NULL);
    bool known = argc > 1 || add_suites(runner, NULL);
    for (int i = 1; i < argc; ++i)
        if (!add_suites(runner, argv[i])) {
            fprintf(stderr, "no suite '%s'; --list shows them\n", argv[i]);
            known = false;
        }
    limit_tests(runner);
    if (known)
        srunner_run_all(runner, CK_ENV);
    tell_limits(runner);
    bool passed = known && srunner_ntests_failed(runner) == 0;
    srunner_free(runner);
    return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
