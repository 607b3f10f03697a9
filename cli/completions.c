/* SPDX-License-Identifier: MIT */
/** @file completions.c
 *  What the completions of shells ask the command. */
#include "completions.h"

#include <stdio.h>
#include <string.h>

#include "command.h"
#include "frame.h"
#include "option_table.h"
#include "templates.h"

static void print_words(const option_row *row)
{
    char colors[200];
    const char *separator = "";
    const char *const *words = options_words(row->id);
    if (strcmp(row->name, "color") == 0) { /* "speed, Densities": without the commas */
        for (const char *c = frame_colors(colors, sizeof colors); *c != '\0'; ++c)
            if (*c != ',')
                putchar(*c);
    } else if (strcmp(row->name, "template") == 0) {
        for (size_t i = 0; i < scene_template_count; ++i, separator = " ")
            printf("%s%s", separator, scene_templates[i].name);
    } else if (words) {
        for (size_t i = 0; words[i]; ++i, separator = " ")
            printf("%s%s", separator, words[i]);
    } else {
        putchar('-');
    }
}

static void print_option(const cli_command *command, const option_row *row)
{
    char letter[] = "-?";
    letter[1] = (char)row->id;
    printf("option\t%s\t%s\t--%s\t%s\t", command->name, row->id < 256 ? letter : "-", row->name,
           row->argument ? row->argument : "-");
    print_words(row);
    printf("\t%s\n", row->text);
}

void completions_print_commands(void)
{
    for (size_t i = 0; i < CLI_COMMAND_COUNT; ++i) {
        const cli_command *command = &commands[i];
        printf("command\t%s\t%s\t%s\n", command->name, command->operands[0] != '\0' ? command->operands : "-",
               command->text);
        const option_row *row;
        for (size_t k = 0; (row = options_row(k)); ++k)
            if (row->commands & command->bit)
                print_option(command, row);
    }
}
