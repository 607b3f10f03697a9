/* SPDX-License-Identifier: MIT */
/* Runs all suites of suites.h, or those named: check_all [--list] [SUITE...]
 * Check reads CK_FORK, CK_RUN_CASE, CK_VERBOSITY and CK_DEFAULT_TIMEOUT from the environment. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "suites.h"

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
    /* Check's own limit of 4 s is for tests that compute nothing. */
    setenv("CK_DEFAULT_TIMEOUT", "120", 0);
    SRunner *runner = srunner_create(NULL);
    bool known = argc > 1 || add_suites(runner, NULL);
    for (int i = 1; i < argc; ++i)
        if (!add_suites(runner, argv[i])) {
            fprintf(stderr, "no suite '%s'; --list shows them\n", argv[i]);
            known = false;
        }
    if (known)
        srunner_run_all(runner, CK_ENV);
    bool passed = known && srunner_ntests_failed(runner) == 0;
    srunner_free(runner);
    return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
