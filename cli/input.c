/* SPDX-License-Identifier: MIT */
/** @file input.c
 *  Reads scenes and snapshots that a command is given. */
#include "input.h"

#include <dirent.h>
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "exit.h"
#include "folder.h"
#include "message.h"

/* ---- scenes ------------------------------------------------------------------------------------------------------ */

bool scene_input_is_stream(const char *operand)
{
    return strcmp(operand, "-") == 0;
}

sph2d_status scene_input_read(const cli_options *options, sph2d_scene_file **file, sph2d_report *report)
{
    const char *scene = options->operands[0];
    if (!scene_input_is_stream(scene))
        return sph2d_scene_file_read(scene, options->overrides, options->override_count, file, report);
    if (isatty(STDIN_FILENO))
        message_note("reading the scene from the terminal; Ctrl-D on an empty line ends it");
    return sph2d_scene_file_read_open(STDIN_FILENO, "<stdin>", options->overrides, options->override_count, file,
                                      report);
}

/* ---- lists of snapshots ------------------------------------------------------------------------------------------ */

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

/* ---- the newest snapshot ----------------------------------------------------------------------------------------- */

sph2d_snapshot *newest_try(const cli_options *options, const char *path, sph2d_report *report, sph2d_status *status)
{
    sph2d_snapshot *snapshot = NULL;
    sph2d_status read = path ? snapshot_read(options, path, &snapshot, report) : SPH2D_NOMEM;
    if (read == SPH2D_NOMEM) /* which says nothing about the file */
        *status = read;
    if (read == SPH2D_OK || read == SPH2D_NOMEM)
        return snapshot;
    for (size_t i = 0; i < report->count; ++i)
        report->items[i].severity = SPH2D_WARNING;
    report->errors = 0;
    message_report(SPH2D_OK, report, NULL);
    message_warning(SPH2D_CODE_FILE_INCOMPLETE, "'%s' is skipped", path);
    return NULL;
}

/* The numbers of a run's snapshots increase with its steps, so the last valid one is the newest. */
static sph2d_status find_snapshot(newest_snapshot *newest, const cli_options *options, cli_folder *folder,
                                  sph2d_report *report)
{
    size_t count;
    sph2d_status status = SPH2D_OK;
    uint64_t *numbers = snapshot_numbers(folder->path, &count, &status);
    for (size_t i = count; i > 0 && !newest->snapshot && status == SPH2D_OK; --i) {
        const char *path = folder_file(folder, "snapshot_%06" PRIu64 ".h5", numbers[i - 1]);
        newest->snapshot = newest_try(options, path, report, &status);
        newest->number = numbers[i - 1];
    }
    free(numbers);
    return status;
}

/* A checkpoint is newer if it has more steps. */
static sph2d_status find_checkpoint(newest_snapshot *newest, const cli_options *options, cli_folder *folder,
                                    sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    const char *path = folder_file(folder, "checkpoint.h5");
    if (path && access(path, F_OK) != 0)
        return SPH2D_OK;
    sph2d_snapshot *checkpoint = newest_try(options, path, report, &status);
    const uint64_t steps = newest->snapshot ? sph2d_snapshot_get_info(newest->snapshot).steps : 0;
    if (!checkpoint || (newest->snapshot && steps >= sph2d_snapshot_get_info(checkpoint).steps)) {
        sph2d_snapshot_destroy(checkpoint);
        return status;
    }
    sph2d_snapshot_destroy(newest->snapshot);
    *newest = (newest_snapshot){.snapshot = checkpoint, .saved = SAVED_IN_CHECKPOINT};
    return SPH2D_OK;
}

sph2d_status newest_find(newest_snapshot *newest, const cli_options *options, cli_folder *folder, sph2d_report *report)
{
    *newest = (newest_snapshot){.saved = SAVED_IN_SNAPSHOT};
    sph2d_status status = find_snapshot(newest, options, folder, report);
    if (status == SPH2D_OK)
        status = find_checkpoint(newest, options, folder, report);
    if (status != SPH2D_OK) {
        sph2d_snapshot_destroy(newest->snapshot);
        *newest = (newest_snapshot){.saved = SAVED_NOWHERE};
    }
    return status;
}
