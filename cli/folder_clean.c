/* SPDX-License-Identifier: MIT */
/** @file folder_clean.c
 *  What is removed from an output folder: files of an earlier run or study, and what a killed process left. */
#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "exit.h"
#include "folder.h"
#include "folder_parts.h"
#include "message.h"

static bool ends_with(const char *name, const char *end)
{
    size_t length = strlen(name), tail = strlen(end);
    return length > tail && strcmp(name + length - tail, end) == 0;
}

/* Files that a study rewrites each time. Its rows are kept, and study.yaml, which users edit. */
static bool is_of_study(const char *name)
{
    static const char *const files[] = {"study.csv",      "study.html",      "plots.gp",
                                        "plots.dat",      "cheapest.yaml",   "error_time.svg",
                                        "error_time.png", "error_along.svg", "error_along.png"};
    for (size_t i = 0; i < sizeof files / sizeof *files; ++i)
        if (strcmp(name, files[i]) == 0)
            return true;
    return strncmp(name, "series_", 7) == 0 && isdigit((unsigned char)name[7]) && ends_with(name, ".csv");
}

static bool is_cleared(const char *name, folder_clearing clearing)
{
    uint64_t number;
    if (clearing == FOLDER_KEEP)
        return false;
    if (clearing == FOLDER_CLEAR_STUDY)
        return is_of_study(name);
    if (folder_numbered(name, "frame_", ".png", &number))
        return true;
    return clearing == FOLDER_CLEAR_RUN &&
           (folder_numbered(name, "snapshot_", ".h5", &number) || strcmp(name, "checkpoint.h5") == 0 ||
            strcmp(name, "guard.h5") == 0 || strcmp(name, "plot.svg") == 0);
}

/* What to remove from a folder. */
typedef struct cleaning {
    folder_clearing clearing;
    bool old;                                    /* of leftovers only those that nobody can be writing any more */
    bool (*stays)(void *user, const char *name); /* files that stay all the same; NULL: none */
    void *user;
} cleaning;

/* Whether a file was last changed a day ago, so that clocks of several machines need not agree. */
static bool is_old(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && difftime(time(NULL), status.st_mtime) > 24 * 60 * 60;
}

/* Removes leftovers, and selected files, from one folder; `inside` is "" or ends in a slash. What another process has
 * removed meanwhile is gone as well. */
static int clean_listing(cli_folder *f, DIR *listing, const char *inside, const cleaning *c, size_t *leftovers)
{
    const struct dirent *entry;
    while ((entry = readdir(listing))) {
        const char *name = entry->d_name;
        bool leftover = folder_is_leftover(name);
        if (!leftover && (!is_cleared(name, c->clearing) || (c->stays && c->stays(c->user, name))))
            continue;
        const char *path = folder_file(f, "%s%s", inside, name);
        if (!path)
            return folder_refuse_memory();
        if (leftover && c->old && !is_old(path))
            continue;
        if (unlink(path) == 0)
            *leftovers += leftover;
        else if (errno != ENOENT)
            return folder_refuse(path, "remove", errno);
    }
    return CLI_EXIT_SUCCESS;
}

static int clean(cli_folder *f, const char *inside, const cleaning *c)
{
    const char *path = folder_file(f, "%s", inside);
    if (!path)
        return folder_refuse_memory();
    DIR *listing = opendir(path);
    if (!listing)
        return errno == ENOENT ? CLI_EXIT_SUCCESS : folder_refuse(path, "read the folder", errno);
    size_t leftovers = 0;
    int code = clean_listing(f, listing, inside, c, &leftovers);
    closedir(listing);
    if (leftovers > 0)
        message_note("removed %zu unfinished file%s of an earlier run from '%s/%s'", leftovers,
                     leftovers == 1 ? "" : "s", f->path, inside);
    return code;
}

int folder_clear(cli_folder *f, folder_clearing clearing)
{
    /* The results of a study are kept until there are new ones. The frames of a run and the rows of a study are in
     * subfolders. */
    bool study = clearing == FOLDER_CLEAR_STUDY;
    cleaning c = {.clearing = study ? FOLDER_KEEP : clearing, .old = study};
    int code = clean(f, "", &c);
    if (code == CLI_EXIT_SUCCESS && clearing != FOLDER_CLEAR_FRAMES)
        code = clean(f, study ? "rows/" : "frames/", &c);
    if (code == CLI_EXIT_SUCCESS && clearing == FOLDER_CLEAR_RUN) {
        /* The empty frames folder of an earlier run; it stays if it contains other files. */
        const char *frames = folder_file(f, "frames");
        if (frames)
            rmdir(frames);
    }
    return code;
}

int folder_clear_study(cli_folder *f, bool (*stays)(void *user, const char *name), void *user)
{
    return clean(f, "", &(cleaning){FOLDER_CLEAR_STUDY, true, stays, user});
}
