/* SPDX-License-Identifier: MIT */
/** @file text_file.c
 *  Whole files: reads one of any kind into memory, up to a limit, and writes a text to one atomically. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/null.h"
#include "files/text.h"
#include "sph2d/io.h"

/* ---- reading ----------------------------------------------------------------------------------------------------- */

static sph2d_status too_long(const char *path, size_t limit, sph2d_report *report)
{
    sph2d_diagnostic *diagnostic =
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_KIND, NULL, "'%s' is too long for a scene", path);
    sph2d_diagnostic_hint(diagnostic, "at most %zu MiB are read", limit >> 20);
    return SPH2D_SCENE;
}

static sph2d_status fail(const char *what, const char *path, sph2d_report *report)
{
    sph2d__report_errno(report, SPH2D_CODE_FILE_OPEN, what, path, errno);
    return SPH2D_NOINPUT;
}

/** Reads to the end, at most one byte more than `limit`, into a growing buffer: the size of a pipe is unknown. */
static sph2d_status read_all(int fd, const char *path, size_t limit, char **text, size_t *length, sph2d_report *report)
{
    size_t size = 0;
    for (*length = 0;;) {
        if (*length > limit)
            return too_long(path, limit, report);
        if (size - *length < 2) {
            size = size > 0 ? 2 * size : 64 * 1024;
            char *larger = realloc(*text, size);
            if (!larger)
                return SPH2D_NOMEM;
            *text = larger;
        }
        ssize_t got = read(fd, *text + *length, size - *length - 1);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return fail("read", path, report);
        if (got == 0)
            break;
        *length += (size_t)got;
    }
    (*text)[*length] = '\0';
    return SPH2D_OK;
}

sph2d_status sph2d__text_read_open(int descriptor, const char *name, size_t limit, char **text, size_t *length,
                                   sph2d_report *report)
{
    *text = NULL;
    *length = 0;
    struct stat info;
    sph2d_status status = SPH2D_OK;
    if (fstat(descriptor, &info) != 0)
        status = fail("read", name, report);
    else if (S_ISREG(info.st_mode) && info.st_size > (off_t)limit)
        status = too_long(name, limit, report);
    else
        status = read_all(descriptor, name, limit, text, length, report);
    if (status != SPH2D_OK) {
        free(*text);
        *text = NULL;
        *length = 0;
    }
    return status;
}

sph2d_status sph2d__text_read(const char *path, size_t limit, char **text, size_t *length, sph2d_report *report)
{
    *text = NULL;
    *length = 0;
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0)
        return fail("open", path, report);
    sph2d_status status = sph2d__text_read_open(fd, path, limit, text, length, report);
    close(fd);
    return status;
}

/* ---- writing ----------------------------------------------------------------------------------------------------- */

sph2d_status sph2d_text_write(const char *path, const char *text, size_t length, sph2d_report *report)
{
    if (!path)
        return sph2d__null(report, __func__, "path");
    if (!text && length > 0)
        return sph2d__null(report, __func__, "text");
    sph2d__atomic_file file;
    sph2d_status status = sph2d__atomic_begin(&file, path, report);
    if (status != SPH2D_OK)
        return status;
    FILE *out = fopen(file.temp_path, "wb");
    if (!out) {
        sph2d__report_errno(report, SPH2D_CODE_FILE_WRITE, "create", path, errno);
        sph2d__atomic_abort(&file);
        return SPH2D_CANTCREAT;
    }
    errno = 0;
    bool ok = length == 0 || fwrite(text, 1, length, out) == length;
    int error = errno;
    if (fclose(out) != 0 && ok) {
        ok = false;
        error = errno;
    }
    if (ok)
        return sph2d__atomic_commit(&file, report);
    sph2d__report_errno(report, SPH2D_CODE_FILE_WRITE, "write", path, error);
    sph2d__atomic_abort(&file);
    return SPH2D_IO;
}
