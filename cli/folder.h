/* SPDX-License-Identifier: MIT */
/** @file folder.h
 *  The output folder: checks before overwriting, a lock, and the names of the files in it. */
#ifndef SPH2D_CLI_FOLDER_H
#define SPH2D_CLI_FOLDER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct cli_folder {
    const char *path;
    int lock;    /**< file descriptor with the lock, -1 for none */
    char *file;  /**< the last result of folder_file */
    bool shared; /**< with other processes */
} cli_folder;

/** What to remove when an existing folder is used again: only files with names that this program writes. */
typedef enum folder_clearing {
    FOLDER_KEEP,
    FOLDER_CLEAR_RUN,   /**< all files of a run except probes, which it overwrites */
    FOLDER_CLEAR_STUDY, /**< nothing yet: folder_clear_study() removes old results when there are new ones */
    FOLDER_CLEAR_FRAMES /**< frames only: the snapshots in the folder may be the ones being drawn */
} folder_clearing;

#define FOLDER_CLOSED                                                                                                  \
    {                                                                                                                  \
        NULL, -1, NULL, false                                                                                          \
    }

/** Takes a folder for new outputs: makes it if needed, locks it against other processes, and checks that it is empty,
 *  that `force` is given, or that it holds `own` (NULL for none), and that it is writable. Nothing in it changes, so
 *  that it is taken before anything slow is prepared. Returns an exit code; otherwise prints an error, and the folder
 *  is closed. */
int folder_claim(cli_folder *f, const char *path, bool force, const char *own);

/** The same for processes that share a folder, each as the first that comes: with each other only where all ask for it
 *  so, and not with one that claimed it. They write the same files at the same time, or different ones; of `own` it is
 *  enough that another of them is about to write it. The folder stays, whoever fails. */
int folder_share(cli_folder *f, const char *path, bool force, const char *own);

/** Removes temporary files of earlier runs from a claimed folder, and files selected by `clearing`; from that of a study
 *  only those of a day or more ago, as other processes may write there. Returns an exit code. */
int folder_clear(cli_folder *f, folder_clearing clearing);

/** Removes series, plots and pages of an earlier study that `stays` has not for its own; not its rows. Returns an exit
 *  code. */
int folder_clear_study(cli_folder *f, bool (*stays)(void *user, const char *name), void *user);

/** Locks the folder of an earlier run, and removes its temporary files. Returns an exit code. */
int folder_reopen(cli_folder *f, const char *path);

/** Takes a folder only to look into it: it is not locked, and nothing in it changes. Returns an exit code. */
int folder_look(cli_folder *f, const char *path);

/** Whether another process has locked a folder that folder_look() took. */
bool folder_is_taken(const cli_folder *f);

/** Whether a folder contains `name`. */
bool folder_holds(const char *path, const char *name);

/** Creates a subfolder, if it does not exist. Returns an exit code. */
int folder_make_inside(cli_folder *f, const char *name);

/** The path of a file in the folder; `format` is printf's. Valid until the next call; NULL when memory is short. */
const char *folder_file(cli_folder *f, const char *format, ...) __attribute__((format(printf, 2, 3)));

void folder_close(cli_folder *f);

/** The same for a command that failed: removes the folders that it made and that are empty. */
void folder_abandon(cli_folder *f);

/** Whether `name` is PREFIX, six digits or more, SUFFIX; *number is the value of the digits. */
bool folder_numbered(const char *name, const char *prefix, const char *suffix, uint64_t *number);

#endif
