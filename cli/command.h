/* SPDX-License-Identifier: MIT */
/** @file command.h
 *  The table of subcommands, used for dispatch, help, suggestions and options; what each does is in a file of its name. */
#ifndef SPH2D_CLI_COMMAND_H
#define SPH2D_CLI_COMMAND_H

#include <stdbool.h>
#include <stddef.h>

#include "options.h"

/** Name, upper-case name, operands, one line. */
#define CLI_COMMAND_MAP(X)                                                                                             \
    X(run, RUN, "SCENE [-o DIR]", "simulate a scene; write snapshots, probes and frames")                              \
    X(resume, RESUME, "DIR", "continue a run from its newest complete snapshot")                                       \
    X(play, PLAY, "[SCENE]", "show a scene in a window, and play with it")                                             \
    X(render, RENDER, "PATH... -o DIR", "draw snapshots as a sequence of PNG files, or as a film")                     \
    X(plot, PLOT, "DIR [PROBE...]", "draw what the probes of a run wrote, over time")                                  \
    X(export, EXPORT, "PATH...", "print the particles of a snapshot as CSV, or write files for VTK")                   \
    X(check, CHECK, "SCENE", "report all errors of a scene, then estimate the run")                                    \
    X(study, STUDY, "STUDY", "run a scene several times; print its errors beside its speed")                           \
    X(info, INFO, "PATH...", "print the contents of a snapshot, or what became of a run")                              \
    X(init, INIT, "NAME", "write a commented scene to start from")                                                     \
    X(devices, DEVICES, "", "print the devices that can take the steps of a run")                                      \
    X(help, HELP, "[TOPIC]", "explain a command, or: exit, codes, scene, materials, methods, schema, study.schema")

/** A bit for each command, so that an option can name the commands that take it. */
enum {
#define CLI__COMMAND_INDEX(name, NAME, operands, text) CLI__##NAME,
    CLI_COMMAND_MAP(CLI__COMMAND_INDEX)
#undef CLI__COMMAND_INDEX
        CLI_COMMAND_COUNT
};
enum {
#define CLI__COMMAND_BIT(name, NAME, operands, text) CLI_##NAME = 1 << CLI__##NAME,
    CLI_COMMAND_MAP(CLI__COMMAND_BIT)
#undef CLI__COMMAND_BIT
        CLI_ALL = (1 << CLI_COMMAND_COUNT) - 1
};

typedef struct cli_command {
    const char *name, *operands, *text;
    unsigned bit;
} cli_command;

/** The table; CLI_COMMAND_COUNT rows. */
extern const cli_command commands[];

/** The command of that name, or NULL. */
const cli_command *command_find(const char *name);

/** Print the texts of --help and --version to stdout (help.c): all commands; one of them, with its options and examples;
 *  version, licence and features of the build. */
void help_print(void);
void help_print_command(const cli_command *about);
void help_print_version(bool json);

/** What a command does; returns the exit code. */
#define CLI__COMMAND_ACT(name, NAME, operands, text) int command_##name(const cli_options *options);
CLI_COMMAND_MAP(CLI__COMMAND_ACT)
#undef CLI__COMMAND_ACT

#endif
