/* SPDX-License-Identifier: MIT */
/** @file devices.c
 *  `sph2d devices`: what can take the steps in place of the processor. */
#include <stdio.h>
#include <stdlib.h>

#include "command.h"
#include "device.h"
#include "exit.h"
#include "json.h"
#include "message.h"
#include "text.h"

static void print_object(const sph2d_device *d, size_t number)
{
    cli_json line = json_begin(stdout);
    json_count(&line, "number", number);
    json_text(&line, "name", d->name);
    json_flag(&line, "gpu", d->gpu);
    json_flag(&line, "same_bits", d->same_bits);
    json_text(&line, "lacks", d->lacks);
    json_count(&line, "units", d->units);
    json_number(&line, "memory_bytes", d->memory);
    json_number(&line, "largest_block_bytes", d->largest);
    json_text(&line, "platform", d->platform);
    json_text(&line, "driver", d->driver);
    json_end(&line);
}

static void print_rows(const sph2d_device *d, size_t number)
{
    char word[TEXT_SIZE], memory[TEXT_SIZE];
    snprintf(word, sizeof word, "%zu", number);
    text_row(word, "%s", d->name);
    text_row("", "%s, %u compute units, %s of memory", d->gpu ? "graphics card" : "no graphics card", d->units,
             text_bytes(memory, d->memory));
    if (d->lacks[0] != '\0')
        text_row("", "cannot run simulations, as it lacks %s", d->lacks);
    else
        text_row("", "%s", d->same_bits ? "same bits as the processor's baseline" : "differs in the last digits");
    text_row("", "%s, driver %s", d->platform, d->driver);
}

int command_devices(const cli_options *options)
{
    if (options->operand_count > 0) {
        message_usage("devices", "it takes no operand");
        return CLI_EXIT_USAGE;
    }
    size_t count;
    bool short_of_memory;
    sph2d_device *list = device_list(&count, &short_of_memory);
    if (short_of_memory) {
        message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
        return CLI_EXIT_SOFTWARE;
    }
    for (size_t k = 0; k < count; ++k)
        (options->json ? print_object : print_rows)(&list[k], k + 1);
    free(list);
    if (count == 0)
        message_note("there is no device with OpenCL here: %s", device_hint);
    return CLI_EXIT_SUCCESS;
}
