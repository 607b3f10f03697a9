/* SPDX-License-Identifier: MIT */
/** @file main.c
 *  Finds the command, parses its options, runs it, and checks that all output was written. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "command.h"
#include "exit.h"
#include "message.h"
#include "text.h"

/* The number of a closed standard stream would go to the first file that is opened, which would then receive messages.
 * So it is opened here, in a mode in which every write fails and is reported. */
static void open_standard_streams(void)
{
    static const int modes[] = {O_WRONLY, O_RDONLY, O_RDONLY};
    for (int number = 0; number < 3; ++number)
        if (fcntl(number, F_GETFD) == -1 && errno == EBADF && open("/dev/null", modes[number]) != number)
            return; /* not possible */
}

/* Only closing shows whether buffered output could be written, for example to a full disk. */
static int close_output(int code)
{
    bool failed = ferror(stdout) != 0;
    errno = 0;
    if (fclose(stdout) != 0)
        failed = true;
    if (!failed)
        return code;
    message_error(SPH2D_CODE_FILE_WRITE, NULL, "cannot write to standard output%s%s", errno != 0 ? ": " : "",
                  errno != 0 ? strerror(errno) : "");
    return code == CLI_EXIT_SUCCESS ? CLI_EXIT_IO : code;
}

static void unknown_command(const char *word)
{
    const char *names[CLI_COMMAND_COUNT];
    for (size_t i = 0; i < CLI_COMMAND_COUNT; ++i)
        names[i] = commands[i].name;
    const char *nearest = text_nearest(word, names, CLI_COMMAND_COUNT);
    if (nearest)
        message_usage(NULL, "unknown command '%s'; did you mean '%s'?", word, nearest);
    else
        message_usage(NULL, "unknown command '%s'", word);
}

static int (*const act[CLI_COMMAND_COUNT])(const cli_options *options) = {
#define COMMAND_ACT(name, NAME, operands, text) command_##name,
    CLI_COMMAND_MAP(COMMAND_ACT)
#undef COMMAND_ACT
};

static int run_command(const cli_command *command, int argc, char **argv)
{
    cli_options options;
    int code = CLI_EXIT_SUCCESS;
    if (!options_parse(&options, command->name, command->bit, argc, argv))
        code = options.short_of_memory ? CLI_EXIT_SOFTWARE : CLI_EXIT_USAGE;
    else if (options.help)
        help_print_command(command);
    else if (options.version)
        help_print_version(options.json);
    else
        code = act[command - commands](&options);
    options_free(&options);
    return code;
}

/* Without a command: only --help and --version are valid. */
static int run_without_command(int argc, char **argv)
{
    cli_options options;
    int code = CLI_EXIT_USAGE;
    if (options_parse(&options, NULL, CLI_HELP, argc, argv)) {
        if (options.version || options.help)
            code = CLI_EXIT_SUCCESS;
        if (options.version)
            help_print_version(options.json);
        else if (options.help)
            help_print();
        else if (options.operand_count > 0)
            message_usage(NULL, "options come after the command: sph2d %s ...", options.operands[0]);
        else
            message_usage(NULL, "a command must be given");
    }
    options_free(&options);
    return code;
}

static int run(int argc, char **argv)
{
    if (argc < 2 || argv[1][0] == '-')
        return run_without_command(argc, argv);
    const cli_command *command = command_find(argv[1]);
    if (command)
        return run_command(command, argc - 1, argv + 1);
    unknown_command(argv[1]);
    return CLI_EXIT_USAGE;
}

int main(int argc, char **argv)
{
    breakdown_watch();
    open_standard_streams();
    return breakdown_leave(close_output(run(argc, argv)));
}
