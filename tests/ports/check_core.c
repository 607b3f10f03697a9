/* SPDX-License-Identifier: MIT */
/** @file check_core.c
 *  check_core [--list] [SUITE...]: runs the suites of the core, or those named, without Check. Environment:
 *  CK_TIMEOUT_MULTIPLIER, as Check has it. */
#include <check.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core_suites.h"

/* Of a test that says nothing else; as main.c sets it [s]. */
static const double USUAL_SECONDS = 120;

typedef struct one_test {
    struct one_test *next;
    void (*test)(int);
    int first, end;
} one_test;

struct port_case {
    TCase *next;
    const char *name;
    double seconds;
    void (*before)(void), (*after)(void);
    one_test *tests, **last;
};

struct port_suite {
    TCase *cases, **last;
};

#define DECLARE_SUITE(name) Suite *suite_##name(void);
CORE_SUITES(DECLARE_SUITE)

static const struct {
    const char *name;
    Suite *(*make)(void);
} suites[] = {
#define SUITE_ROW(name) {#name, suite_##name},
    CORE_SUITES(SUITE_ROW)};
enum { SUITES = sizeof suites / sizeof *suites };

/* ---- what suites are made of ------------------------------------------------------------------------------------- */

static void *make(size_t size)
{
    void *made = calloc(1, size); /* and lives as long as the program */
    if (!made) {
        fputs("check_core: no memory\n", stderr);
        exit(2);
    }
    return made;
}

Suite *suite_create(const char *name)
{
    (void)name;
    Suite *suite = make(sizeof *suite);
    suite->last = &suite->cases;
    return suite;
}

TCase *tcase_create(const char *name)
{
    TCase *tests = make(sizeof *tests);
    *tests = (TCase){.name = name, .seconds = USUAL_SECONDS, .last = &tests->tests};
    return tests;
}

void suite_add_tcase(Suite *suite, TCase *tests)
{
    *suite->last = tests;
    suite->last = &tests->next;
}

void tcase_set_timeout(TCase *tests, double seconds)
{
    tests->seconds = seconds;
}

void tcase_add_checked_fixture(TCase *tests, void (*before)(void), void (*after)(void))
{
    tests->before = before;
    tests->after = after;
}

void tcase_add_loop_test(TCase *tests, void (*test)(int), int first, int end)
{
    one_test *one = make(sizeof *one);
    *one = (one_test){NULL, test, first, end};
    *tests->last = one;
    tests->last = &one->next;
}

/* ---- running ----------------------------------------------------------------------------------------------------- */

void port_fail(const char *file, int line, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    fprintf(stderr, "%s:%d: ", file, line);
    vfprintf(stderr, format, values);
    fputc('\n', stderr);
    va_end(values);
    _exit(EXIT_FAILURE);
}

static bool passes(const TCase *tests, const one_test *one, int i)
{
    const char *factor = getenv("CK_TIMEOUT_MULTIPLIER");
    fflush(NULL);
    const pid_t pid = fork();
    if (pid == 0) {
        alarm((unsigned)ceil(tests->seconds * (factor ? strtod(factor, NULL) : 1)));
        if (tests->before)
            tests->before();
        one->test(i);
        if (tests->after)
            tests->after();
        _exit(EXIT_SUCCESS);
    }
    int status = 0;
    if (pid < 0 || waitpid(pid, &status, 0) != pid)
        return false;
    if (WIFSIGNALED(status))
        fprintf(stderr, "ended by signal %d%s\n", WTERMSIG(status), WTERMSIG(status) == SIGALRM ? ": too slow" : "");
    return status == 0;
}

/** Runs a suite; adds to how many tests there were, and how many failed. */
static void run_suite(const char *name, const Suite *suite, unsigned *count, unsigned *failed)
{
    for (const TCase *tests = suite->cases; tests; tests = tests->next)
        for (const one_test *one = tests->tests; one; one = one->next)
            for (int i = one->first; i < one->end; ++i, ++*count)
                if (!passes(tests, one, i)) {
                    fprintf(stderr, "FAILED: %s, case %s, round %d\n", name, tests->name, i);
                    ++*failed;
                }
}

int main(int argc, char **argv)
{
    unsigned count = 0, failed = 0;
    int found = 0;
    const bool list = argc == 2 && strcmp(argv[1], "--list") == 0;
    for (size_t k = 0; k < SUITES; ++k) {
        bool wanted = argc == 1;
        for (int i = 1; i < argc; ++i)
            wanted = wanted || strcmp(argv[i], suites[k].name) == 0;
        found += wanted;
        if (list)
            puts(suites[k].name);
        else if (wanted)
            run_suite(suites[k].name, suites[k].make(), &count, &failed);
    }
    if (list)
        return EXIT_SUCCESS;
    if (argc > 1 && found != argc - 1) {
        fputs("check_core: no such suite; --list shows them\n", stderr);
        return 2;
    }
    printf("%u tests of %d suites, %u failed\n", count, found, failed);
    return failed > 0;
}
