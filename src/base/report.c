/* SPDX-License-Identifier: MIT */
/** @file report.c
 *  Statuses, codes and the report that collects diagnostics. Nothing here allocates, so it works when memory is
 *  short. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "sph2d/status.h"

const char *sph2d_status_name(sph2d_status status)
{
    switch (status) {
#define NAME(name, value, text)                                                                                        \
    case SPH2D_##name:                                                                                                 \
        return #name;
        SPH2D_STATUS_MAP(NAME)
#undef NAME
    }
    return "UNKNOWN";
}

const char *sph2d_status_text(sph2d_status status)
{
    switch (status) {
#define TEXT(name, value, text)                                                                                        \
    case SPH2D_##name:                                                                                                 \
        return text;
        SPH2D_STATUS_MAP(TEXT)
#undef TEXT
    }
    return "unknown status";
}

const char *sph2d_code_text(sph2d_code code)
{
    static const char *const texts[SPH2D_CODE_COUNT] = {
#define TEXT(name, text, meaning) [SPH2D_CODE_##name] = text,
        SPH2D_CODE_MAP(TEXT)
#undef TEXT
    };
    return (unsigned)code < SPH2D_CODE_COUNT ? texts[code] : texts[SPH2D_CODE_GENERAL];
}

void sph2d_report_clear(sph2d_report *report)
{
    if (report) {
        report->count = 0;
        report->dropped = 0;
        report->errors = 0;
    }
}

sph2d_diagnostic *sph2d_report_add(sph2d_report *report, sph2d_severity severity, sph2d_code code, const char *path,
                                   const char *format, ...)
{
    if (!report || !format)
        return NULL;
    report->errors += severity == SPH2D_ERROR;
    if (report->count >= SPH2D_REPORT_CAPACITY) {
        ++report->dropped;
        return NULL;
    }
    sph2d_diagnostic *diagnostic = &report->items[report->count++];
    memset(diagnostic, 0, sizeof *diagnostic);
    diagnostic->severity = severity;
    diagnostic->code = code;
    if (path)
        snprintf(diagnostic->path, sizeof diagnostic->path, "%s", path);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(diagnostic->message, sizeof diagnostic->message, format, arguments);
    va_end(arguments);
    return diagnostic;
}

void sph2d_diagnostic_hint(sph2d_diagnostic *diagnostic, const char *format, ...)
{
    if (!diagnostic || !format)
        return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(diagnostic->hint, sizeof diagnostic->hint, format, arguments);
    va_end(arguments);
}

/** snprintf at `*used`, which keeps counting when the buffer is full. */
static void append(char *buffer, size_t size, size_t *used, const char *format, ...)
{
    size_t left = *used < size ? size - *used : 0;
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(left ? buffer + *used : NULL, left, format, arguments);
    va_end(arguments);
    if (length > 0)
        *used += (size_t)length;
}

size_t sph2d_diagnostic_format(const sph2d_diagnostic *diagnostic, char *buffer, size_t size)
{
    if (!buffer)
        size = 0;
    if (size)
        buffer[0] = '\0';
    if (!diagnostic)
        return 0;
    const sph2d_diagnostic *d = diagnostic;
    size_t used = 0;
    if (d->file[0]) {
        append(buffer, size, &used, "%s:", d->file);
        if (d->line > 0)
            append(buffer, size, &used, "%d:%d:", d->line, d->column);
        append(buffer, size, &used, " ");
    }
    append(buffer, size, &used, "%s[%s]: ", d->severity == SPH2D_WARNING ? "warning" : "error",
           sph2d_code_text(d->code));
    if (d->path[0])
        append(buffer, size, &used, "%s: ", d->path);
    append(buffer, size, &used, "%s", d->message);
    if (d->excerpt[0]) {
        append(buffer, size, &used, "\n    %s", d->excerpt);
        if (d->column > 0 && (size_t)d->column <= strlen(d->excerpt) + 1)
            append(buffer, size, &used, "\n    %*s", d->column, "^");
    }
    if (d->hint[0])
        append(buffer, size, &used, "\n    hint: %s", d->hint);
    return used;
}
