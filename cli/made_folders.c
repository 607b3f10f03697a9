/* SPDX-License-Identifier: MIT */
/** @file made_folders.c
 *  A list of folders, the last one made first. */
#include "made_folders.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct made_folder {
    struct made_folder *earlier;
    char path[];
} made_folder;

static made_folder *newest;

static int make_one(const char *path)
{
    size_t size = strlen(path) + 1;
    made_folder *made = malloc(sizeof *made + size);
    if (!made)
        return ENOMEM;
    made->earlier = newest;
    memcpy(made->path, path, size);
    int error = mkdir(path, 0777) == 0 ? 0 : errno;
    if (error == 0)
        newest = made;
    else
        free(made);
    return error;
}

int made_folders_make(const char *path)
{
    char *part = path[0] != '\0' ? strdup(path) : NULL;
    if (!part)
        return path[0] != '\0' ? ENOMEM : ENOENT;
    int error = 0;
    for (char *end = part; end;) {
        end = strchr(end + 1, '/');
        if (end)
            *end = '\0';
        /* A parent that cannot be made may exist all the same, so only the last error counts. */
        error = make_one(part);
        if (end)
            *end = '/';
    }
    free(part);
    return error == EEXIST ? 0 : error;
}

void made_folders_remove(void)
{
    for (const made_folder *made = newest; made; made = made->earlier)
        rmdir(made->path);
}

void made_folders_keep(void)
{
    while (newest) {
        made_folder *made = newest;
        newest = made->earlier;
        free(made);
    }
}
