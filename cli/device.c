/* SPDX-License-Identifier: MIT */
/** @file device.c
 *  The device of --device. */
#include "device.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "exit.h"
#include "message.h"
#include "text.h"

const char device_hint[] =
    "install OpenCL's loader (Debian: ocl-icd-libopencl1) and the driver of the graphics card, or "
    "pocl-opencl-icd, whose device is the processor and which needs a folder to write to, ~/.cache or POCL_CACHE_DIR";

sph2d_device *device_list(size_t *count, bool *short_of_memory)
{
    *count = sph2d_devices(NULL, 0);
    sph2d_device *list = *count > 0 ? calloc(*count, sizeof *list) : NULL;
    *short_of_memory = *count > 0 && !list;
    const size_t now = list ? sph2d_devices(list, *count) : 0;
    *count = now < *count ? now : *count;
    return list;
}

/* The number of graphics card `nth` in a list, from 1 on; 0: there are fewer. */
static int number_of_card(const sph2d_device *list, size_t count, int nth)
{
    for (size_t k = 0; k < count; ++k)
        if (list[k].gpu && --nth == 0)
            return (int)k + 1;
    return 0;
}

static int refuse(const char *hint, const char *format, const char *name)
{
    message_error(SPH2D_CODE_DEVICE, hint, format, name);
    return CLI_EXIT_UNAVAILABLE;
}

/* The device of a list that the options name. */
static int find(device_choice *choice, const cli_options *options, const sph2d_device *list, size_t count)
{
    static const char see[] = "'sph2d devices' lists what there is";
    char name[TEXT_SIZE];
    snprintf(name, sizeof name, options->device > 1 && options->device_is_card ? "gpu:%d" : "gpu", options->device);
    if (!options->device_is_card)
        snprintf(name, sizeof name, "%d", options->device);
    if (count == 0)
        return refuse(device_hint, "--device %s: there is no device with OpenCL here", name);
    choice->number = options->device_is_card ? number_of_card(list, count, options->device) : options->device;
    if (choice->number == 0)
        return refuse(see, "--device %s: there is no such graphics card with OpenCL here", name);
    if ((size_t)choice->number > count)
        return refuse(see, "--device %s: there is no such device with OpenCL here", name);
    choice->about = list[choice->number - 1];
    if (choice->about.lacks[0] != '\0') {
        message_error(SPH2D_CODE_DEVICE, see, "--device %s: %s cannot run simulations, as it lacks %s", name,
                      choice->about.name, choice->about.lacks);
        return CLI_EXIT_UNAVAILABLE;
    }
    if (choice->same_bits && !choice->about.same_bits) {
        message_error(SPH2D_CODE_DEVICE, "without --same-bits it runs, and differs in the last digits",
                      "--device %s: %s does not round as the processor does", name, choice->about.name);
        return CLI_EXIT_UNAVAILABLE;
    }
    return CLI_EXIT_SUCCESS;
}

int device_choose(device_choice *choice, const cli_options *options)
{
    *choice = (device_choice){.same_bits = options->same_bits};
    if (options->device == 0)
        return CLI_EXIT_SUCCESS;
    size_t count;
    bool short_of_memory;
    sph2d_device *list = device_list(&count, &short_of_memory);
    int code = CLI_EXIT_SOFTWARE;
    if (short_of_memory)
        message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
    else
        code = find(choice, options, list, count);
    free(list);
    return code;
}

int device_choose_apart(device_choice *choice, const cli_options *options)
{
    *choice = (device_choice){.same_bits = options->same_bits};
    int ends[2], status;
    if (options->device == 0)
        return CLI_EXIT_SUCCESS;
    fflush(NULL); /* else both processes write what is buffered */
    if (pipe(ends) != 0) {
        message_error(SPH2D_CODE_GENERAL, NULL, "no pipe to ask for the device");
        return CLI_EXIT_SOFTWARE;
    }
    const pid_t pid = fork();
    if (pid == 0) {
        int code = device_choose(choice, options);
        if (write(ends[1], choice, sizeof *choice) != (ssize_t)sizeof *choice && code == CLI_EXIT_SUCCESS)
            code = CLI_EXIT_SOFTWARE;
        fflush(NULL);
        _exit(code);
    }
    close(ends[1]);
    device_choice told;
    const bool whole = pid > 0 && read(ends[0], &told, sizeof told) == (ssize_t)sizeof told;
    close(ends[0]);
    if (pid > 0 && waitpid(pid, &status, 0) == pid && WIFEXITED(status) && (whole || WEXITSTATUS(status) != 0)) {
        *choice = whole ? told : *choice;
        return WEXITSTATUS(status);
    }
    message_error(SPH2D_CODE_DEVICE, NULL, "the process that asked for the device broke down");
    return CLI_EXIT_SOFTWARE;
}

void device_set(sph2d_sim_options *sim, const device_choice *choice)
{
    sim->device = choice->number;
    sim->same_bits = choice->same_bits;
}

char *device_describe(char out[TEXT_DEVICE_SIZE], const device_choice *choice)
{
    out[0] = '\0';
    if (choice->number > 0)
        snprintf(out, TEXT_DEVICE_SIZE, "device %d (%s)", choice->number, choice->about.name);
    return out;
}

void device_tell(const device_choice *choice)
{
    char text[TEXT_DEVICE_SIZE];
    if (choice->number > 0)
        message_note("the steps are taken by %s", device_describe(text, choice));
}

const char *device_name(const device_choice *choice)
{
    return choice->number > 0 ? choice->about.name : "cpu";
}
