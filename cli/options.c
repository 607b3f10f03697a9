/* SPDX-License-Identifier: MIT */
/** @file options.c
 *  Options are parsed with getopt_long, whose tables are made from the one of option_table.c. */
#include "options.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "message.h"
#include "option_table.h"
#include "text.h"

/* ---- the tables of getopt ---------------------------------------------------------------------------------------- */

/* The two tables of getopt_long for one command. */
typedef struct getopt_tables {
    char letters[2 * OPTION_ROWS_MAX + 2];
    struct option longs[OPTION_ROWS_MAX + 1];
} getopt_tables;

static void make_tables(getopt_tables *tables, unsigned command)
{
    memset(tables, 0, sizeof *tables);
    char *letter = tables->letters;
    struct option *next = tables->longs;
    *letter++ = ':'; /* distinguishes a missing argument from an unknown option */
    const option_row *row;
    for (size_t i = 0; (row = options_row(i)); ++i) {
        if ((row->commands & command) == 0)
            continue;
        int has_argument = row->argument ? required_argument : no_argument;
        *next++ = (struct option){row->name, has_argument, NULL, row->id};
        if (row->id < 256) {
            *letter++ = (char)row->id;
            if (has_argument == required_argument)
                *letter++ = ':';
        }
    }
}

/* ---- errors ------------------------------------------------------------------------------------------------------ */

static void unknown_option(const char *name, unsigned command, const char *given)
{
    char word[64];
    snprintf(word, sizeof word, "%s", given[0] == '-' && given[1] == '-' ? given + 2 : given);
    word[strcspn(word, "=")] = '\0';
    const char *names[OPTION_ROWS_MAX];
    size_t count = 0;
    const option_row *row;
    for (size_t i = 0; (row = options_row(i)); ++i) {
        if ((row->commands & command) != 0) {
            names[count++] = row->name;
        } else if (strcmp(row->name, word) == 0) {
            message_usage(name, "'--%s' is not an option %s", word, name ? "of this command" : "without a command");
            return;
        }
    }
    const char *nearest = text_nearest(word, names, count);
    if (nearest)
        message_usage(name, "unknown option '%s'; did you mean '--%s'?", given, nearest);
    else
        message_usage(name, "unknown option '%s'", given);
}

static bool is_long(const char *given)
{
    return given[0] == '-' && given[1] == '-' && given[2] != '\0';
}

/* Reports an error of getopt_long. For long options optopt is 0 if the option is unknown, and its id if it takes no
 * argument but got one. */
static void report_error(const char *name, unsigned command, int result, const char *given)
{
    char letter[3] = {'-', (char)optopt, '\0'};
    if (result == ':')
        message_usage(name, "'%s' needs an argument", is_long(given) ? given : letter);
    else if (is_long(given) && optopt != 0)
        message_usage(name, "'%.*s' takes no argument", (int)strcspn(given, "="), given);
    else
        unknown_option(name, command, is_long(given) ? given : letter);
}

/* ---- parsing ----------------------------------------------------------------------------------------------------- */

/* Finds --json and --no-color first, as they change how errors of the options are reported. */
static void find_message_options(cli_options *options, int argc, char **argv)
{
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; ++i) {
        options->json = options->json || strcmp(argv[i], "--json") == 0;
        options->no_color = options->no_color || strcmp(argv[i], "--no-color") == 0;
    }
    message_setup(options);
}

bool options_parse(cli_options *options, const char *name, unsigned command, int argc, char **argv)
{
    *options = (cli_options){0};
    find_message_options(options, argc, argv);
    getopt_tables tables;
    make_tables(&tables, command);
    opterr = 0;
    int id;
    int before = optind;
    while ((id = getopt_long(argc, argv, tables.letters, tables.longs, NULL)) != -1) {
        if (id == '?' || id == ':') {
            /* Within a group of letters optind still points at the group. */
            report_error(name, command, id, argv[optind > before ? optind - 1 : optind]);
            return false;
        }
        if (!option_values_set(options, name, id, optarg))
            return false;
        before = optind;
    }
    if (options->device > 0 && options->isa > SPH2D_ISA_BASELINE) {
        message_usage(name, "--isa %s is the processor's: what a device does is what baseline does",
                      sph2d_isa_name(options->isa));
        return false;
    }
    options->operands = argv + optind;
    options->operand_count = (size_t)(argc - optind);
    message_setup(options);
    return true;
}

void options_free(cli_options *options)
{
    free(options->overrides);
    options->overrides = NULL;
}
