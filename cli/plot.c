/* SPDX-License-Identifier: MIT */
/** @file plot.c
 *  `sph2d plot DIR [PROBE...]`: draws the series of a run over time. */
#include "plot.h"

#include <string.h>

#include "command.h"
#include "exit.h"
#include "json.h"
#include "message.h"

static bool ends_with(const char *text, const char *end)
{
    size_t length = strlen(text), tail = strlen(end);
    return length > tail && strcmp(text + length - tail, end) == 0;
}

static int check_usage(const cli_options *options)
{
    if (options->operand_count == 0)
        message_usage("plot", "the folder of a run must be given");
    else if (options->output && !ends_with(options->output, ".svg") && !ends_with(options->output, ".png"))
        message_usage("plot", "--output: '%s' must end in .svg or .png", options->output);
    else
        return CLI_EXIT_SUCCESS;
    return CLI_EXIT_USAGE;
}

static void tell(const cli_options *options, const plot_data *data, const char *path)
{
    if (!options->json) {
        message_note("wrote '%s'", path);
        return;
    }
    cli_json line = json_begin(stdout);
    json_text(&line, "file", path);
    json_open_array(&line, "series");
    for (size_t i = 0; i < data->count; ++i)
        if (data->series[i].panels > 0)
            json_text(&line, NULL, data->series[i].name);
    json_close_array(&line);
    json_count(&line, "panels", data->panels);
    json_end(&line);
}

int command_plot(const cli_options *options)
{
    int code = check_usage(options);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    cli_folder folder = FOLDER_CLOSED;
    code = folder_look(&folder, options->operands[0]);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    plot_data data = {0};
    code = plot_read(&data, &folder, options->operands + 1, options->operand_count - 1);
    const char *path = options->output ? options->output : folder_file(&folder, "plot.svg");
    if (code == CLI_EXIT_SUCCESS && !path) {
        message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
        code = CLI_EXIT_SOFTWARE;
    }
    if (code == CLI_EXIT_SUCCESS)
        code = plot_draw(&data, ends_with(path, ".png"), path);
    if (code == CLI_EXIT_SUCCESS)
        tell(options, &data, path);
    plot_free(&data);
    folder_close(&folder);
    return code;
}
