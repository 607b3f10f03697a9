/* SPDX-License-Identifier: MIT */
/** @file command.c
 *  The table of subcommands. */
#include "command.h"

#include <string.h>

const cli_command commands[CLI_COMMAND_COUNT] = {
#define COMMAND_ROW(name, NAME, operands, text) {#name, operands, text, CLI_##NAME},
    CLI_COMMAND_MAP(COMMAND_ROW)
#undef COMMAND_ROW
};

const cli_command *command_find(const char *name)
{
    for (size_t i = 0; i < CLI_COMMAND_COUNT; ++i)
        if (strcmp(commands[i].name, name) == 0)
            return &commands[i];
    return NULL;
}
