/* SPDX-License-Identifier: MIT */
/** @file series.c
 *  CSV files that grow row by row. A row is one write, so that whoever looks, or a crash, finds whole rows; a resumed
 *  run cuts what came after its snapshot and goes on. */
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
#include "base/c_locale.h"
#include "sph2d/io.h"

#define TIME_COLUMN "time [s]"
/** Room for one number and its separator: sign, 17 digits, point, exponent. */
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

/** Finds where the header and `rows` rows end. *wrong says what is wrong with them, NULL for nothing. */
static off_t find_end(FILE *stream, const char *header, uint64_t rows, const char **wrong)
{
    char *line = NULL;
    size_t room = 0;
    off_t end = 0;
    *wrong = NULL;
    for (uint64_t i = 0; i <= rows && !*wrong; ++i) {
        ssize_t length = getline(&line, &room, stream);
        if (i == 0 && (length < 0 || strcmp(line, header) != 0))
            *wrong = "this is not the series that the run wrote: its header is another";
        else if (length <= 0 || line[length - 1] != '\n')
            *wrong = "the series has fewer rows than the run wrote";
        end += length;
    }
    free(line);
    return end;
}

/** Opens an existing series and cuts it to its first rows. */
static sph2d_status go_on(sph2d_series *s, const char *header, uint64_t rows, sph2d_report *report)
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
    bool unreadable = ferror(stream);
    fclose(stream);
    if (unreadable)
        return failed("read", s->path, SPH2D_IO, report);
    if (wrong)
        return refuse(s->path, wrong, report);
    if (ftruncate(s->fd, end) != 0)
        return failed("cut", s->path, SPH2D_IO, report);
    return SPH2D_OK;
}

static sph2d_status start(sph2d_series *s, const char *header, sph2d_report *report)
{
    s->fd = open(s->path, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
    if (s->fd < 0)
        return failed("create", s->path, SPH2D_CANTCREAT, report);
    if (!write_all(s->fd, header, strlen(header)))
        return failed("write", s->path, SPH2D_IO, report);
    return SPH2D_OK;
}

sph2d_status sph2d_series_open(const char *path, const char *columns, uint64_t keep_rows, sph2d_series **series,
                               sph2d_report *report)
{
    if (!series)
        return SPH2D_INVALID;
    *series = NULL;
    if (!path || !columns)
        return SPH2D_INVALID;
    sph2d_series *s = calloc(1, sizeof *s);
    size_t room = sizeof TIME_COLUMN ",\n" + strlen(columns);
    char *header = malloc(room);
    if (s) {
        s->fd = -1;
        s->path = strdup(path);
    }
    sph2d_status status = SPH2D_NOMEM;
    if (s && s->path && header) {
        snprintf(header, room, TIME_COLUMN ",%s\n", columns);
        status = keep_rows > 0 ? go_on(s, header, keep_rows, report) : start(s, header, report);
    }
    free(header);
    if (status == SPH2D_OK)
        *series = s;
    else
        sph2d_series_close(s, NULL);
    return status;
}

/** Appends a number as text. NaN has no sign, whatever its bits say. */
static size_t put_number(char *out, double value, char separator)
{
    int length = isnan(value) ? snprintf(out, NUMBER_BYTES, "nan%c", separator)
                              : snprintf(out, NUMBER_BYTES, "%.17g%c", value, separator);
    return (size_t)length;
}

sph2d_status sph2d_series_append(sph2d_series *series, double time, const double *values, size_t count,
                                 sph2d_report *report)
{
    if (!series || (!values && count > 0))
        return SPH2D_INVALID;
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
    bool fine = write_all(series->fd, row, used);
    int error = errno;
    if (!fine && before >= 0 && ftruncate(series->fd, before) != 0)
        errno = error; /* half a row stays, which a resumed run cuts */
    free(row);
    errno = error;
    return fine ? SPH2D_OK : failed("write", series->path, SPH2D_IO, report);
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
