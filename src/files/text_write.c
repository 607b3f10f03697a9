/* SPDX-License-Identifier: MIT */
/** @file text_write.c
 *  Writes a text to a file atomically. */
#include <errno.h>
#include <stdio.h>

#include "base/atomic_file.h"
#include "base/null.h"
#include "sph2d/io.h"

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
