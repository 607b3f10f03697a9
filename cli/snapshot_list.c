/* SPDX-License-Identifier: MIT */
/** @file snapshot_list.c
 *  The snapshots that operands stand for. */
#include "snapshot_list.h"

#include <dirent.h>
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "exit.h"
#include "folder.h"
#include "message.h"

static int compare(const void *a, const void *b)
{
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

uint64_t *snapshot_numbers(const char *folder, size_t *count, sph2d_status *status)
{
    *count = 0;
    DIR *listing = opendir(folder);
    if (!listing) {
        *status = errno == ENOMEM ? SPH2D_NOMEM : SPH2D_OK;
        return NULL;
    }
    uint64_t *numbers = NULL;
    uint64_t number;
    const struct dirent *entry;
    while ((entry = readdir(listing))) {
        if (!folder_numbered(entry->d_name, "snapshot_", ".h5", &number))
            continue;
        if ((*count & (*count + 1)) == 0) { /* full: 0, 1, 3, 7, ... */
            uint64_t *grown = realloc(numbers, (2 * *count + 1) * sizeof *grown);
            if (!grown) {
                *status = SPH2D_NOMEM;
                break;
            }
            numbers = grown;
        }
        numbers[(*count)++] = number;
    }
    closedir(listing);
    if (*count > 0)
        qsort(numbers, *count, sizeof *numbers, compare);
    return numbers;
}

static int short_of_memory(void)
{
    message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
    return CLI_EXIT_SOFTWARE;
}

static int add(snapshot_list *list, const char *path)
{
    char **grown = path ? realloc(list->paths, (list->count + 1) * sizeof *grown) : NULL;
    if (!grown)
        return short_of_memory();
    list->paths = grown;
    list->paths[list->count] = strdup(path);
    return list->paths[list->count] ? (++list->count, CLI_EXIT_SUCCESS) : short_of_memory();
}

static int refuse_folder(cli_folder *folder)
{
    const char *frames = folder_file(folder, "frames/frame_000000.png");
    struct stat info;
    if (frames && stat(frames, &info) == 0)
        message_error(SPH2D_CODE_FILE_OPEN,
                      "its frames become a film by: ffmpeg -framerate 60 -i DIR/frames/frame_%06d.png -pix_fmt yuv420p "
                      "film.mp4",
                      "no snapshots in '%s', only frames", folder->path);
    else
        message_error(SPH2D_CODE_FILE_OPEN, "a run writes them if its scene has run.snapshots", "no snapshots in '%s'",
                      folder->path);
    return CLI_EXIT_NOINPUT;
}

static int add_folder(snapshot_list *list, const char *path)
{
    cli_folder folder = FOLDER_CLOSED;
    folder.path = path;
    size_t count;
    sph2d_status status = SPH2D_OK;
    uint64_t *numbers = snapshot_numbers(path, &count, &status);
    int code = status == SPH2D_OK ? CLI_EXIT_SUCCESS : short_of_memory();
    if (code == CLI_EXIT_SUCCESS && count == 0)
        code = refuse_folder(&folder);
    for (size_t i = 0; i < count && code == CLI_EXIT_SUCCESS; ++i)
        code = add(list, folder_file(&folder, "snapshot_%06" PRIu64 ".h5", numbers[i]));
    free(numbers);
    free(folder.file);
    return code;
}

int snapshot_list_make(snapshot_list *list, const cli_options *options)
{
    *list = (snapshot_list){0};
    int code = CLI_EXIT_SUCCESS;
    for (size_t i = 0; i < options->operand_count && code == CLI_EXIT_SUCCESS; ++i) {
        const char *path = options->operands[i];
        struct stat info;
        bool is_folder = stat(path, &info) == 0 && S_ISDIR(info.st_mode);
        code = is_folder ? add_folder(list, path) : add(list, path);
    }
    return code;
}

void snapshot_list_free(snapshot_list *list)
{
    for (size_t i = 0; i < list->count; ++i)
        free(list->paths[i]);
    free(list->paths);
    *list = (snapshot_list){0};
}
