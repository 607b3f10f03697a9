/* SPDX-License-Identifier: MIT */
/** @file atomic_file.c
 *  Files written atomically. The order is write, sync, rename, sync the folder: without the first sync a
 *  crash may leave the new name on an empty file, without the second it may bring the old file back. */
#include "base/atomic_file.h"

#include <errno.h>
#include <fcntl.h>
#include <locale.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/** What to do about an error; NULL if that is not known. */
static const char *hint_of(int error)
{
    switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
        return "make room there, or choose another folder; a file that is complete is replaced only by a complete one";
    case EACCES:
    case EPERM:
    case EROFS:
        return "choose a folder and files that you may use";
    case ENOENT:
        return "its folder may have been removed or renamed";
    default:
        return NULL;
    }
}

void sph2d__report_errno(sph2d_report *report, sph2d_code code, const char *what, const char *path, int error)
{
    /* strerror_l is the one form that is safe in threads and has a single signature */
    locale_t locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    sph2d_diagnostic *d;
    if (locale == (locale_t)0) {
        d = sph2d_report_add(report, SPH2D_ERROR, code, NULL, "cannot %s '%s': error %d", what, path, error);
    } else {
        d = sph2d_report_add(report, SPH2D_ERROR, code, NULL, "cannot %s '%s': %s", what, path,
                             strerror_l(error, locale));
        freelocale(locale);
    }
    const char *hint = code == SPH2D_CODE_FILE_WRITE ? hint_of(error) : NULL;
    if (hint)
        sph2d_diagnostic_hint(d, "%s", hint);
}

/** The length of the folder part of a path with its slash; 0 when there is none. */
static size_t folder_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash - path) + 1 : 0;
}

/** Whether a regular file can have this name: renaming onto a device would replace the device by a file. */
static bool name_is_free(const char *path, sph2d_report *report)
{
    if (path[folder_length(path)] == '\0') {
        sph2d__report_errno(report, SPH2D_CODE_FILE_WRITE, "write", path, path[0] ? EISDIR : ENOENT);
        return false;
    }
    struct stat info;
    if (stat(path, &info) != 0 || S_ISREG(info.st_mode))
        return true;
    if (S_ISDIR(info.st_mode))
        sph2d__report_errno(report, SPH2D_CODE_FILE_WRITE, "write", path, EISDIR);
    else
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_WRITE, NULL,
                         "cannot write '%s': it is a device or pipe, not a regular file", path);
    return false;
}

sph2d_status sph2d__atomic_begin(sph2d__atomic_file *file, const char *path, sph2d_report *report)
{
    *file = (sph2d__atomic_file){NULL, NULL};
    if (!name_is_free(path, report))
        return SPH2D_CANTCREAT;
    size_t folder = folder_length(path);
    size_t size = strlen(path) + 48; /* ".", ".tmp.", a process id and nanoseconds */
    /* Processes of several machines that share the folder may have the same id: then the clock tells them apart. */
    struct timespec now = {0};
    clock_gettime(CLOCK_REALTIME, &now);
    file->final_path = malloc(size);
    file->temp_path = malloc(size);
    if (!file->final_path || !file->temp_path) {
        sph2d__atomic_abort(file);
        return SPH2D_NOMEM;
    }
    snprintf(file->final_path, size, "%s", path);
    snprintf(file->temp_path, size, "%.*s.%s.tmp.%ld%09ld", (int)folder, path, path + folder, (long)getpid(),
             now.tv_nsec);
    return SPH2D_OK;
}

static bool sync_file(const char *path)
{
    int fd = open(path, O_WRONLY | O_CLOEXEC);
    if (fd < 0)
        return false;
    bool ok = fsync(fd) == 0;
    int error = errno;
    if (close(fd) != 0 && ok) {
        ok = false;
        error = errno;
    }
    errno = error;
    return ok;
}

/** Syncs the folder of a file. Folders that cannot be opened for reading, and file systems that cannot sync one
 *  (EINVAL, ENOTSUP), are not an error. */
static bool sync_folder(const char *path)
{
    size_t length = folder_length(path);
    char *folder = malloc(length + 2);
    if (!folder) {
        errno = ENOMEM;
        return false;
    }
    snprintf(folder, length + 2, "%.*s", length ? (int)length : 1, length ? path : ".");
    int fd = open(folder, O_RDONLY | O_CLOEXEC);
    free(folder);
    if (fd < 0)
        return true;
    bool ok = fsync(fd) == 0 || errno == EINVAL || errno == ENOTSUP;
    int error = errno;
    close(fd);
    errno = error;
    return ok;
}

sph2d_status sph2d__atomic_commit(sph2d__atomic_file *file, sph2d_report *report)
{
    const char *failed = NULL; /* the operation that failed */
    if (!sync_file(file->temp_path))
        failed = "write";
    else if (rename(file->temp_path, file->final_path) != 0)
        failed = "rename to";
    else if (!sync_folder(file->final_path))
        failed = "sync the folder of";
    if (failed)
        sph2d__report_errno(report, SPH2D_CODE_FILE_WRITE, failed, file->final_path, errno);
    sph2d__atomic_abort(file); /* after the rename there is no temporary file to remove */
    return failed ? SPH2D_IO : SPH2D_OK;
}

void sph2d__atomic_abort(sph2d__atomic_file *file)
{
    int error = errno;
    if (file->temp_path)
        unlink(file->temp_path);
    free(file->temp_path);
    free(file->final_path);
    *file = (sph2d__atomic_file){NULL, NULL};
    errno = error;
}
