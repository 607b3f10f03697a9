/* SPDX-License-Identifier: MIT */
/** @file folder.h
 *  The folder that outputs go to: taken only when it is ours to take, and the names of the files in it. */
#ifndef SPH2D_CLI_FOLDER_H
#define SPH2D_CLI_FOLDER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct cli_folder {
    const char *path;
    int lock;   /**< descriptor that holds the lock, -1 for none */
    char *file; /**< the last name that folder_file made */
} cli_folder;

/** What to remove from a folder that is taken anew. Nothing but files with names of ours ever is. */
typedef enum folder_clearing {
    FOLDER_KEEP,
    FOLDER_CLEAR_RUN,   /**< all that a run writes but its probes, which it overwrites */
    FOLDER_CLEAR_STUDY, /**< nothing yet: folder_clear_study() does when there is something new */
    FOLDER_CLEAR_FRAMES /**< frames alone: the snapshots beside them may be the ones being drawn */
} folder_clearing;

#define FOLDER_CLOSED                                                                                                  \
    {                                                                                                                  \
        NULL, -1, NULL                                                                                                 \
    }

/** Says no, with a message and an exit code, to a folder that cannot take new outputs: it holds something and `force`
 *  was not given, it is no folder, it cannot be written to. Touches nothing, so that it can be asked before the work.
 */
int folder_refuse(const char *path, bool force);

/** Makes the folder where needed, locks it and removes temporary files that an earlier run left, and what `clearing`
 *  says. Returns an exit code. */
int folder_open_new(cli_folder *f, const char *path, folder_clearing clearing);

/** Removes series, plots and pages that a study left; not its rows. Returns an exit code. */
int folder_clear_study(cli_folder *f);

/** Locks a folder that an earlier run wrote, and removes its temporary files. Returns an exit code. */
int folder_open_again(cli_folder *f, const char *path);

/** Whether a folder holds something called `name`. */
bool folder_holds(const char *path, const char *name);

/** Makes a folder inside, if it is not there. Returns an exit code. */
int folder_make_inside(cli_folder *f, const char *name);

/** The path of a file in the folder; `format` is printf's. Valid until the next call; NULL without memory. */
const char *folder_file(cli_folder *f, const char *format, ...) __attribute__((format(printf, 2, 3)));

void folder_close(cli_folder *f);

/** Whether `name` is PREFIX, six digits or more, SUFFIX; *number is what they say. */
bool folder_numbered(const char *name, const char *prefix, const char *suffix, uint64_t *number);

#endif
