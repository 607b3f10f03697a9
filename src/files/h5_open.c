/* SPDX-License-Identifier: MIT */
/** @file h5_open.c
 *  Opens an untrusted file as HDF5, with specific error messages. */
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "files/h5_file.h"
#include "files/h5_read.h"
#include "files/text.h"

sph2d_diagnostic *sph2d__h5_refuse(sph2d__h5_reader *r, sph2d_code code, const char *format, ...)
{
    bool short_of_memory = errno == ENOMEM;
    errno = 0;
    if (short_of_memory && r->status != SPH2D_NOMEM) {
        sph2d_report_add(r->report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory while reading '%s'", r->path);
        r->status = SPH2D_NOMEM;
    }
    if (r->status == SPH2D_NOMEM) /* what seems wrong with the file may follow from that */
        return NULL;
    if (r->status == SPH2D_OK)
        r->status = SPH2D_FORMAT;
    char message[sizeof((sph2d_diagnostic *)0)->message];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    sph2d_diagnostic *d = sph2d_report_add(r->report, SPH2D_ERROR, code, NULL, "%s", message);
    if (d) {
        sph2d__text_clean(d->message);
        snprintf(d->file, sizeof d->file, "%s", r->path);
    }
    return d;
}

static void fail(sph2d__h5_reader *r, const char *what, int error)
{
    sph2d__report_errno(r->report, SPH2D_CODE_FILE_OPEN, what, r->path, error);
    r->status = SPH2D_NOINPUT;
}

static void check_trailer(sph2d__h5_reader *r, int fd)
{
    sph2d__trailer trailer = sph2d__trailer_check(fd);
    if (trailer == SPH2D__TRAILER_UNREADABLE)
        fail(r, "read", errno);
    else if (trailer == SPH2D__TRAILER_INVALID)
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_INCOMPLETE, "the file is damaged: its checksum does not match");
    else if (trailer == SPH2D__TRAILER_NONE)
        sph2d_diagnostic_hint(
            sph2d__h5_refuse(r, SPH2D_CODE_FILE_INCOMPLETE,
                             "the checksum at the end of the file is missing: it is cut short, or another program has "
                             "changed it, or it is no snapshot of sph2d"),
            "if it was changed on purpose, give it a new checksum, or read it with --no-checksum "
            "(sph2d_snapshot_read_unchecked)");
}

/** Checks an open file before HDF5 reads it: type, size, HDF5 signature, checksum trailer. */
static void check_file(sph2d__h5_reader *r, int fd, bool checked)
{
    static const unsigned char signature[8] = {0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
    struct stat info;
    if (fstat(fd, &info) != 0) {
        fail(r, "read", errno);
        return;
    }
    if (S_ISDIR(info.st_mode)) {
        fail(r, "read", EISDIR);
        return;
    }
    if (!S_ISREG(info.st_mode)) {
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_KIND, "this is a device or pipe, not a snapshot");
        return;
    }
    unsigned char start[sizeof signature];
    ssize_t got = pread(fd, start, sizeof start, 0);
    if (got < 0)
        fail(r, "read", errno);
    else if (got != (ssize_t)sizeof start || memcmp(start, signature, sizeof start) != 0)
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_KIND, "this is not an HDF5 file%s", got == 0 ? ": it is empty" : "");
    else if (checked)
        check_trailer(r, fd);
    r->file_bytes = (uint64_t)info.st_size;
}

void sph2d__h5_reader_open(sph2d__h5_reader *r, const char *path, bool checked, sph2d__pool *pool, sph2d_report *report)
{
    *r = (sph2d__h5_reader){
        .path = path, .report = report, .pool = pool, .file = H5I_INVALID_HID, .driver = H5I_INVALID_HID};
    errno = 0; /* HDF5 has no status for a lack of memory, but leaves malloc's errno */
    r->fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK); /* do not block on a pipe without a writer */
    if (r->fd < 0) {
        fail(r, "open", errno);
        return;
    }
    check_file(r, r->fd, checked);
    if (r->status != SPH2D_OK)
        return;
    hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    bool ok = access >= 0 && H5Pset_fclose_degree(access, H5F_CLOSE_STRONG) >= 0 &&
              (r->driver = sph2d__h5_source_driver(access, r->fd, r->file_bytes)) >= 0;
    r->file = ok ? H5Fopen(path, H5F_ACC_RDONLY, access) : H5I_INVALID_HID;
    if (r->file < 0) {
        char cause[160];
        sph2d__h5_cause(cause, sizeof cause);
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_INCOMPLETE, "the file is damaged or cut short: %s", cause);
    }
    if (access >= 0)
        H5Pclose(access);
}

void sph2d__h5_reader_close(sph2d__h5_reader *r)
{
    if (r->file >= 0)
        H5Fclose(r->file);
    if (r->driver >= 0)
        H5FDunregister(r->driver);
    if (r->fd >= 0)
        close(r->fd);
    r->file = r->driver = H5I_INVALID_HID;
    r->fd = -1;
}
