/* SPDX-License-Identifier: MIT */
/** @file text.c
 *  Places in a text, with line, column and excerpt for messages; and the errors found there. */
#include "files/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/** Maximum number of recorded paths of invalid values; with more, all values count as invalid. */
enum { MAX_PATHS = 1000 };

struct sph2d__fault_path {
    struct sph2d__fault_path *next;
    char path[];
};

/** Bytes of the UTF-8 character at `text`; 0 if it is invalid, or a character that text must not have. */
static size_t character_length(const unsigned char *text, size_t size)
{
    unsigned c = text[0];
    if (c < 0x80)
        return (c >= 0x20 && c != 0x7f) || c == '\t' || c == '\n' || c == '\r';
    size_t length = c >= 0xc2 && c <= 0xdf ? 2 : c >= 0xe0 && c <= 0xef ? 3 : c >= 0xf0 && c <= 0xf4 ? 4 : 0;
    if (length == 0 || length > size)
        return 0;
    unsigned long code = c & (0xffu >> (length + 1));
    for (size_t i = 1; i < length; ++i) {
        if ((text[i] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (text[i] & 0x3f);
    }
    bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    bool surrogate = code >= 0xd800 && code <= 0xdfff;
    bool control = code < 0xa0 && code != 0x85;
    return overlong || surrogate || control || code > 0x10ffff || (code & 0xfffe) == 0xfffe ? 0 : length;
}

bool sph2d__text_check(const sph2d__source *source, sph2d__faults *faults)
{
    const unsigned char *text = (const unsigned char *)source->text;
    for (size_t i = 0; i < source->length;) {
        size_t length = character_length(text + i, source->length - i);
        if (length == 0) {
            sph2d__fault(faults, SPH2D_CODE_SYNTAX, (sph2d__place){source, i}, NULL,
                         "this is not text: byte 0x%02x is not UTF-8 or a control character", text[i]);
            return false;
        }
        i += length;
    }
    return true;
}

void sph2d__text_clean(char *text)
{
    size_t size = strlen(text);
    for (size_t i = 0; i < size;) {
        size_t length = character_length((const unsigned char *)text + i, size - i);
        if (length == 0 || (length == 1 && (unsigned char)text[i] < 0x20))
            text[i] = '?';
        i += length > 0 ? length : 1;
    }
}

/** The start of the line of `offset`, and its number from 1. A line ends with LF, CR or both. */
static size_t line_start(const sph2d__source *source, size_t offset, int *number)
{
    size_t start = 0;
    *number = 1;
    for (size_t i = 0; i < offset; ++i) {
        char c = source->text[i];
        bool pair = c == '\r' && i + 1 < source->length && source->text[i + 1] == '\n';
        if ((c == '\n' || c == '\r') && !pair) {
            start = i + 1;
            ++*number;
        }
    }
    return start;
}

/** Skips a byte order mark, which editors do not count as a column. */
static size_t skip_mark(const sph2d__source *source, size_t start)
{
    return start == 0 && source->length >= 3 && memcmp(source->text, "\xef\xbb\xbf", 3) == 0 ? 3 : start;
}

/** Copies a line, truncated to the size; tabs as blanks, to align the caret, and invalid bytes as '?'. */
static void copy_line(char *out, size_t size, const sph2d__source *source, size_t start)
{
    const unsigned char *text = (const unsigned char *)source->text;
    size_t used = 0;
    for (size_t i = start; i < source->length && text[i] != '\n' && text[i] != '\r';) {
        size_t length = character_length(text + i, source->length - i);
        size_t bytes = length > 0 ? length : 1;
        if (used + bytes >= size)
            break;
        if (length == 0 || text[i] == '\t')
            out[used] = length == 0 ? '?' : ' ';
        else
            memcpy(out + used, text + i, length);
        used += bytes;
        i += bytes;
    }
    out[used] = '\0';
}

int sph2d__place_line(sph2d__place place)
{
    int line = 0;
    if (place.source->has_lines && place.offset <= place.source->length)
        line_start(place.source, place.offset, &line);
    return line;
}

void sph2d__place_describe(sph2d__place place, sph2d_diagnostic *diagnostic)
{
    const sph2d__source *source = place.source;
    if (!diagnostic || !source)
        return;
    snprintf(diagnostic->file, sizeof diagnostic->file, "%s", source->name);
    sph2d__text_clean(diagnostic->file);
    diagnostic->line = diagnostic->column = 0;
    diagnostic->excerpt[0] = '\0';
    if (!source->has_lines || place.offset == SPH2D__NOWHERE)
        return;
    size_t offset = place.offset < source->length ? place.offset : source->length;
    size_t start = skip_mark(source, line_start(source, offset, &diagnostic->line));
    diagnostic->column = 1;
    for (size_t i = start; i < offset; ++i)
        diagnostic->column += ((unsigned char)source->text[i] & 0xc0) != 0x80;
    copy_line(diagnostic->excerpt, sizeof diagnostic->excerpt, source, start);
}

/** Takes the last diagnostic back if the one before says the same of the same place: overrides have no columns that
 *  would tell the items of a list apart. */
static bool is_repeated(sph2d_report *report)
{
    if (report->count < 2)
        return false;
    const sph2d_diagnostic *last = &report->items[report->count - 1], *before = last - 1;
    if (before->line != last->line || before->column != last->column || strcmp(before->file, last->file) != 0 ||
        strcmp(before->path, last->path) != 0 || strcmp(before->message, last->message) != 0)
        return false;
    --report->count;
    --report->errors;
    return true;
}

sph2d_diagnostic *sph2d__fault(sph2d__faults *faults, sph2d_code code, sph2d__place place, const char *path,
                               const char *format, ...)
{
    ++faults->errors;
    char message[sizeof((sph2d_diagnostic *)0)->message];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    sph2d_diagnostic *diagnostic = sph2d_report_add(faults->report, SPH2D_ERROR, code, path, "%s", message);
    if (diagnostic) {
        sph2d__text_clean(diagnostic->message);
        sph2d__text_clean(diagnostic->path);
        sph2d__place_describe(place, diagnostic);
        if (is_repeated(faults->report))
            return NULL;
    }
    return diagnostic;
}

void sph2d__faults_mark_invalid(sph2d__faults *faults, const char *path)
{
    if (++faults->invalid > MAX_PATHS)
        return;
    size_t size = strlen(path) + 1;
    struct sph2d__fault_path *fault = sph2d__pool_alloc(faults->pool, 1, sizeof *fault + size);
    if (!fault) {
        faults->short_of_memory = true;
        return;
    }
    memcpy(fault->path, path, size);
    fault->next = faults->paths;
    faults->paths = fault;
}

/** Whether `path` is `above` or below it. The empty path is above all. */
static bool is_below(const char *path, const char *above)
{
    size_t length = strlen(above);
    char next = strncmp(path, above, length) == 0 ? path[length] : 'x';
    return length == 0 || next == '\0' || next == '.' || next == '[';
}

bool sph2d__faults_affect(const sph2d__faults *faults, const char *path)
{
    if (faults->invalid > MAX_PATHS)
        return true;
    for (const struct sph2d__fault_path *fault = faults->paths; fault; fault = fault->next)
        if (is_below(fault->path, path) || is_below(path, fault->path))
            return true;
    return false;
}

void sph2d__faults_sort(sph2d_report *report, size_t first)
{
    for (size_t i = first + 1; report && i < report->count; ++i) {
        sph2d_diagnostic moved = report->items[i];
        size_t k = i;
        for (; k > first; --k) {
            const sph2d_diagnostic *before = &report->items[k - 1];
            if (before->line < moved.line || (before->line == moved.line && before->column <= moved.column))
                break;
            report->items[k] = *before;
        }
        report->items[k] = moved;
    }
}

void sph2d__report_key(sph2d_report *report, size_t first, const char *key)
{
    for (size_t k = first; report && k < report->count; ++k)
        if (report->items[k].file[0] == '\0')
            snprintf(report->items[k].path, sizeof report->items[k].path, "%s", key);
}
