/* SPDX-License-Identifier: MIT */
/** @file series.c
 *  CSV files that grow row by row. Each row is one write, so that readers, also after a crash, find complete rows. A
 *  resumed run truncates the rows after its snapshot and continues. */
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/null.h"
#include "base/number.h"
#include "sph2d/io.h"

#define TIME_COLUMN "time [s]"
/** Bytes of one number and its separator: sign, 17 digits, point, exponent. */
enum { NUMBER_BYTES = 32 };

struct sph2d_series {
    int fd;
    char *path;
};

/** Writes all of a text; false with errno otherwise. */
static bool write_all(int fd, const char *text, size_t length)
{
    while (length > 0) {
        ssize_t put = write(fd, text, length);
        if (put < 0 && errno == EINTR)
            continue;
        if (put <= 0) {
            errno = put == 0 ? EIO : errno;
            return false;
        }
        text += put;
        length -= (size_t)put;
    }
    return true;
}

static sph2d_status failed(const char *what, const char *path, sph2d_status status, sph2d_report *report)
{
    sph2d__report_errno(report, SPH2D_CODE_FILE_WRITE, what, path, errno);
    return status;
}

static sph2d_status refuse(const char *path, const char *what, sph2d_report *report)
{
    sph2d_diagnostic *d = sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL, "%s", what);
    if (d)
        snprintf(d->file, sizeof d->file, "%s", path);
    return SPH2D_FORMAT;
}

/** Finds the end of the header and `rows` rows. *wrong is an error message, or NULL; errno is ENOMEM if memory was
 *  short. */
static off_t find_end(FILE *stream, const char *header, uint64_t rows, const char **wrong)
{
    char *line = NULL;
    size_t size = 0;
    off_t end = 0;
    *wrong = NULL;
    errno = 0;
    for (uint64_t i = 0; i <= rows && !*wrong; ++i) {
        ssize_t length = getline(&line, &size, stream);
        if (i == 0 && (length < 0 || strcmp(line, header) != 0))
            *wrong = "this is not the series of this run: the header differs";
        else if (length <= 0 || line[length - 1] != '\n')
            *wrong = "the series has fewer rows than the run had written";
        end += length;
    }
    free(line);
    return end;
}

/** Opens an existing series and truncates it to its first rows. */
static sph2d_status continue_series(sph2d_series *s, const char *header, uint64_t rows, sph2d_report *report)
{
    s->fd = open(s->path, O_RDWR | O_APPEND | O_CLOEXEC);
    if (s->fd < 0)
        return failed("open", s->path, SPH2D_CANTCREAT, report);
    int copy = dup(s->fd); /* closing the stream must not close the series */
    FILE *stream = copy >= 0 ? fdopen(copy, "r") : NULL;
    if (!stream) {
        int error = errno;
        if (copy >= 0)
            close(copy);
        errno = error;
        return failed("read", s->path, SPH2D_IO, report);
    }
    const char *wrong;
    off_t end = find_end(stream, header, rows, &wrong);
    bool unreadable = ferror(stream), short_of_memory = wrong && errno == ENOMEM;
    fclose(stream);
    if (short_of_memory)
        return SPH2D_NOMEM;
    if (unreadable)
        return failed("read", s->path, SPH2D_IO, report);
    if (wrong)
        return refuse(s->path, wrong, report);
    if (ftruncate(s->fd, end) != 0)
        return failed("truncate", s->path, SPH2D_IO, report);
    return SPH2D_OK;
}

static sph2d_status start(sph2d_series *s, const char *header, sph2d_report *report)
{
    s->fd = open(s->path, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
    if (s->fd < 0)
        return failed("create", s->path, SPH2D_CANTCREAT, report);
    if (write_all(s->fd, header, strlen(header)))
        return SPH2D_OK;
    sph2d_status status = failed("write", s->path, SPH2D_IO, report);
    if (ftruncate(s->fd, 0) == 0) /* a file, not a device */
        unlink(s->path);
    return status;
}

sph2d_status sph2d_series_open(const char *path, const char *columns, uint64_t keep_rows, sph2d_series **series,
                               sph2d_report *report)
{
    if (!series)
        return sph2d__null(report, __func__, "series");
    *series = NULL;
    if (!path)
        return sph2d__null(report, __func__, "path");
    if (!columns)
        return sph2d__null(report, __func__, "columns");
    sph2d_series *s = calloc(1, sizeof *s);
    size_t size = sizeof TIME_COLUMN ",\n" + strlen(columns);
    char *header = malloc(size);
    if (s) {
        s->fd = -1;
        s->path = strdup(path);
    }
    sph2d_status status = SPH2D_NOMEM;
    if (s && s->path && header) {
        snprintf(header, size, TIME_COLUMN ",%s\n", columns);
        status = keep_rows > 0 ? continue_series(s, header, keep_rows, report) : start(s, header, report);
    }
    free(header);
    if (status == SPH2D_OK)
        *series = s;
    else
        sph2d_series_close(s, NULL);
    return status;
}

/** Appends a number as text; NaN always without a sign. */
static size_t put_number(char *out, double value, char separator)
{
    int length = isnan(value) ? snprintf(out, NUMBER_BYTES, "nan%c", separator)
                              : snprintf(out, NUMBER_BYTES, "%.17g%c", value, separator);
    return (size_t)length;
}

sph2d_status sph2d_series_append(sph2d_series *series, double time, const double *values, size_t count,
                                 sph2d_report *report)
{
    if (!series)
        return sph2d__null(report, __func__, "series");
    if (!values && count > 0)
        return sph2d__null(report, __func__, "values");
    char *row = count < SIZE_MAX / NUMBER_BYTES - 1 ? malloc((count + 1) * NUMBER_BYTES) : NULL;
    sph2d__c_locale locale;
    if (!row || !sph2d__c_locale_begin(&locale)) {
        free(row);
        return SPH2D_NOMEM;
    }
    size_t used = put_number(row, time, count > 0 ? ',' : '\n');
    for (size_t i = 0; i < count; ++i)
        used += put_number(row + used, values[i], i + 1 < count ? ',' : '\n');
    sph2d__c_locale_end(&locale);
    off_t before = lseek(series->fd, 0, SEEK_END);
    bool ok = write_all(series->fd, row, used);
    int error = errno;
    if (!ok && before >= 0 && ftruncate(series->fd, before) != 0)
        errno = error; /* part of a row remains, which a resumed run truncates */
    free(row);
    errno = error;
    return ok ? SPH2D_OK : failed("write", series->path, SPH2D_IO, report);
}

sph2d_status sph2d_series_close(sph2d_series *series, sph2d_report *report)
{
    if (!series)
        return SPH2D_OK;
    sph2d_status status = SPH2D_OK;
    if (series->fd >= 0 && close(series->fd) != 0)
        status = failed("write", series->path, SPH2D_IO, report);
    free(series->path);
    free(series);
    return status;
}
