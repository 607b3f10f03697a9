/* SPDX-License-Identifier: MIT */
/** @file folder.c
 *  The output folder: it is made, locked, opened, and cleared of what an earlier run or study left. */
#include "folder.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "exit.h"
#include "message.h"

/* ---- names ------------------------------------------------------------------------------------------------------- */

bool folder_numbered(const char *name, const char *prefix, const char *suffix, uint64_t *number)
{
    size_t skip = strlen(prefix);
    if (strncmp(name, prefix, skip) != 0)
        return false;
    const char *digits = name + skip;
    size_t count = strspn(digits, "0123456789");
    if (count < 6 || count > 19 || strcmp(digits + count, suffix) != 0)
        return false;
    *number = strtoull(digits, NULL, 10);
    return true;
}

/* A temporary file of a process that was killed. */
static bool is_leftover(const char *name)
{
    const char *mark = name[0] == '.' ? strstr(name, ".tmp.") : NULL;
    if (!mark || !isdigit((unsigned char)mark[5]))
        return false;
    return mark[5 + strspn(mark + 5, "0123456789")] == '\0';
}

static bool is_dot(const char *name)
{
    return strcmp(name, ".") == 0 || strcmp(name, "..") == 0;
}

const char *folder_file(cli_folder *f, const char *format, ...)
{
    va_list values, again;
    va_start(values, format);
    va_copy(again, values);
    int length = vsnprintf(NULL, 0, format, again);
    va_end(again);
    size_t start = strlen(f->path);
    size_t size = start + (size_t)(length > 0 ? length : 0) + 2;
    char *grown = realloc(f->file, size);
    if (grown) {
        f->file = grown;
        bool slash = start > 0 && f->path[start - 1] == '/';
        snprintf(grown, size, "%s%s", f->path, slash ? "" : "/");
        start = strlen(grown);
        vsnprintf(grown + start, size - start, format, values);
    }
    va_end(values);
    return grown;
}

/* ---- opening ----------------------------------------------------------------------------------------------------- */

static int refuse(const char *path, const char *what, int error)
{
    message_error(SPH2D_CODE_FILE_WRITE, NULL, "cannot %s '%s': %s", what, path, strerror(error));
    return CLI_EXIT_CANTCREAT;
}

static int refuse_memory(void)
{
    message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
    return CLI_EXIT_SOFTWARE;
}

/* Whether a folder holds nothing, or nothing but `name` (NULL for none) and temporary files. Returns 0 or an errno. */
static int holds_nothing(const char *path, const char *name, bool *nothing)
{
    DIR *listing = opendir(path);
    if (!listing)
        return errno;
    const struct dirent *entry;
    *nothing = true;
    while (*nothing && (entry = readdir(listing)))
        *nothing = is_dot(entry->d_name) || (name && (strcmp(entry->d_name, name) == 0 || is_leftover(entry->d_name)));
    closedir(listing);
    return 0;
}

/* Whether the folder that is open is the one of that path: another process that made it and failed may have removed it
 * before this one had the lock. */
static bool is_current(const cli_folder *f)
{
    struct stat opened, named;
    return fstat(f->lock, &opened) == 0 && stat(f->path, &named) == 0 && opened.st_dev == named.st_dev &&
           opened.st_ino == named.st_ino;
}

/* Prevents other sessions from writing to the folder. The kernel releases the lock when the process ends; file systems
 * without locks are accepted, and those whose locks other machines do not see. folder_is_taken() has it for a moment: then
 * it is tried again. */
static int lock_folder(cli_folder *f)
{
    enum { ATTEMPTS = 4 };
    const struct timespec moment = {0, 5000000};
    for (int attempt = 0; attempt < ATTEMPTS; ++attempt) {
        if (flock(f->lock, (f->shared ? LOCK_SH : LOCK_EX) | LOCK_NB) == 0 || errno != EWOULDBLOCK)
            return CLI_EXIT_SUCCESS;
        nanosleep(&moment, NULL);
    }
    message_error(SPH2D_CODE_FILE_WRITE, "wait for it to end, or stop it", "another sph2d is writing to '%s'", f->path);
    return CLI_EXIT_CANTCREAT;
}

/* Makes the folder if needed and opens it. Returns 0 or an errno. */
static int make_and_open(cli_folder *f)
{
    int error = made_folders_make(f->path);
    if (error != 0)
        return error;
    f->lock = open(f->path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    return f->lock < 0 ? errno : 0;
}

/* Makes the folder and locks it. What others remove between the two is made again. */
static int make_locked(cli_folder *f)
{
    enum { ATTEMPTS = 100 };
    int error = ENOENT;
    for (int attempt = 0; attempt < ATTEMPTS && error == ENOENT; ++attempt) {
        error = make_and_open(f);
        if (error != 0)
            continue;
        if (lock_folder(f) != CLI_EXIT_SUCCESS) {
            made_folders_keep(); /* it is another's now */
            return CLI_EXIT_CANTCREAT;
        }
        if (is_current(f))
            return CLI_EXIT_SUCCESS;
        close(f->lock);
        f->lock = -1;
        error = ENOENT;
    }
    return error == ENOMEM ? refuse_memory() : refuse(f->path, "make the folder", error);
}

/* Signals wait until a folder is made and locked, as only then it may be removed; one that is shared is never. */
static sigset_t hold_signals(void)
{
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    return before;
}

static void release_signals(const cli_folder *f, sigset_t before)
{
    if (f->shared)
        made_folders_keep();
    pthread_sigmask(SIG_SETMASK, &before, NULL);
}

/* Whether a folder is a beginning of what has the file `own`, "FOLDER/NAME": that folder alone, with nothing else. Two
 * that start at once find it so. */
static bool is_begun(cli_folder *f, const char *own)
{
    const char *slash = strchr(own, '/');
    char *inside = strndup(own, (size_t)(slash - own));
    const char *path = inside ? folder_file(f, "%s", inside) : NULL;
    bool outer = false, inner = false;
    bool begun = path && holds_nothing(f->path, inside, &outer) == 0 && outer &&
                 holds_nothing(path, slash + 1, &inner) == 0 && inner;
    free(inside);
    return begun;
}

static int check_content(cli_folder *f, bool force, const char *own)
{
    bool empty = true;
    int error = holds_nothing(f->path, NULL, &empty);
    if (error != 0)
        return refuse(f->path, "read the folder", error);
    bool mine = own && ((f->shared && is_begun(f, own)) || folder_holds(f->path, own));
    if (!empty && !force && !mine) {
        message_error(SPH2D_CODE_FILE_EXISTS, "choose another with -o, or add --force to replace the outputs in it",
                      "the folder '%s' exists and is not empty", f->path);
        return CLI_EXIT_CANTCREAT;
    }
    if (access(f->path, W_OK | X_OK) != 0)
        return refuse(f->path, "write to", errno);
    return CLI_EXIT_SUCCESS;
}

static int take(cli_folder *f, bool force, const char *own)
{
    sigset_t before = hold_signals();
    int code = make_locked(f);
    release_signals(f, before);
    if (code == CLI_EXIT_SUCCESS)
        code = check_content(f, force, own);
    if (code != CLI_EXIT_SUCCESS)
        folder_abandon(f);
    return code;
}

int folder_claim(cli_folder *f, const char *path, bool force, const char *own)
{
    *f = (cli_folder){path, -1, NULL, false};
    return take(f, force, own);
}

int folder_share(cli_folder *f, const char *path, bool force, const char *own)
{
    *f = (cli_folder){path, -1, NULL, true};
    return take(f, force, own);
}

/* ---- clearing ---------------------------------------------------------------------------------------------------- */

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
        bool leftover = is_leftover(name);
        if (!leftover && (!is_cleared(name, c->clearing) || (c->stays && c->stays(c->user, name))))
            continue;
        const char *path = folder_file(f, "%s%s", inside, name);
        if (!path)
            return refuse_memory();
        if (leftover && c->old && !is_old(path))
            continue;
        if (unlink(path) == 0)
            *leftovers += leftover;
        else if (errno != ENOENT)
            return refuse(path, "remove", errno);
    }
    return CLI_EXIT_SUCCESS;
}

static int clean(cli_folder *f, const char *inside, const cleaning *c)
{
    const char *path = folder_file(f, "%s", inside);
    if (!path)
        return refuse_memory();
    DIR *listing = opendir(path);
    if (!listing)
        return errno == ENOENT ? CLI_EXIT_SUCCESS : refuse(path, "read the folder", errno);
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

/* ---- looking ----------------------------------------------------------------------------------------------------- */

int folder_reopen(cli_folder *f, const char *path)
{
    *f = (cli_folder)FOLDER_CLOSED;
    struct stat status;
    if (stat(path, &status) != 0 || !S_ISDIR(status.st_mode)) {
        message_error(SPH2D_CODE_FILE_OPEN, "give the folder that 'sph2d run -o' wrote", "no folder '%s'", path);
        return CLI_EXIT_NOINPUT;
    }
    *f = (cli_folder){path, open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC), NULL, false};
    if (f->lock < 0)
        return refuse(path, "open the folder", errno);
    int code = lock_folder(f);
    return code == CLI_EXIT_SUCCESS ? folder_clear(f, FOLDER_KEEP) : code;
}

int folder_look(cli_folder *f, const char *path)
{
    *f = (cli_folder){.path = path, .lock = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (f->lock >= 0)
        return CLI_EXIT_SUCCESS;
    message_error(SPH2D_CODE_FILE_OPEN, NULL, "cannot read the folder '%s': %s", path, strerror(errno));
    return CLI_EXIT_NOINPUT;
}

bool folder_is_taken(const cli_folder *f)
{
    if (flock(f->lock, LOCK_SH | LOCK_NB) != 0)
        return errno == EWOULDBLOCK;
    flock(f->lock, LOCK_UN);
    return false;
}

bool folder_holds(const char *path, const char *name)
{
    size_t size = strlen(path) + strlen(name) + 2;
    char *inside = malloc(size);
    if (!inside)
        return false;
    snprintf(inside, size, "%s/%s", path, name);
    bool holds = access(inside, F_OK) == 0;
    free(inside);
    return holds;
}

int folder_make_inside(cli_folder *f, const char *name)
{
    const char *path = folder_file(f, "%s", name);
    if (!path)
        return refuse_memory();
    sigset_t before = hold_signals();
    int error = made_folders_make(path);
    release_signals(f, before);
    if (error == ENOMEM)
        return refuse_memory();
    return error != 0 ? refuse(path, "make the folder", error) : CLI_EXIT_SUCCESS;
}

void folder_close(cli_folder *f)
{
    if (f->lock >= 0)
        close(f->lock);
    free(f->file);
    *f = (cli_folder)FOLDER_CLOSED;
}

void folder_abandon(cli_folder *f)
{
    made_folders_remove();
    folder_close(f);
}
