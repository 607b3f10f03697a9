/* SPDX-License-Identifier: MIT */
/** @file json.c
 *  Writes one JSON object on one line. */
#include "json.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "text.h"

static void write_string(FILE *out, const char *value)
{
    putc('"', out);
    for (const unsigned char *s = (const unsigned char *)value; *s != '\0'; ++s) {
        if (*s == '"' || *s == '\\') {
            fprintf(out, "\\%c", *s);
        } else if (*s == '\n') {
            fputs("\\n", out);
        } else if (*s < 0x20 || *s == 0x7F) {
            fprintf(out, "\\u%04x", *s);
        } else if (*s < 0x80) {
            putc(*s, out);
        } else {
            size_t length = text_utf8_length((const char *)s);
            if (length == 0) {
                fputs("\\ufffd", out);
                continue;
            }
            fwrite(s, 1, length, out);
            s += length - 1;
        }
    }
    putc('"', out);
}

static void start_item(cli_json *line, const char *key)
{
    if (line->comma)
        fputs(", ", line->out);
    line->comma = true;
    if (key) {
        write_string(line->out, key);
        fputs(": ", line->out);
    }
}

static void write_number(FILE *out, double value)
{
    if (!isfinite(value)) {
        fputs("null", out);
        return;
    }
    char digits[40];
    for (int precision = 15; precision <= 17; ++precision) {
        snprintf(digits, sizeof digits, "%.*g", precision, value);
        if (strtod(digits, NULL) == value)
            break;
    }
    fputs(digits, out);
}

cli_json json_begin(FILE *out)
{
    putc('{', out);
    return (cli_json){out, false};
}

void json_end(cli_json *line)
{
    fputs("}\n", line->out);
}

void json_text(cli_json *line, const char *key, const char *value)
{
    start_item(line, key);
    if (!value)
        fputs("null", line->out);
    else
        write_string(line->out, value);
}

void json_number(cli_json *line, const char *key, double value)
{
    start_item(line, key);
    write_number(line->out, value);
}

void json_count(cli_json *line, const char *key, uint64_t value)
{
    start_item(line, key);
    fprintf(line->out, "%" PRIu64, value);
}

void json_flag(cli_json *line, const char *key, bool value)
{
    start_item(line, key);
    fputs(value ? "true" : "false", line->out);
}

void json_pair(cli_json *line, const char *key, double first, double second)
{
    json_open_array(line, key);
    json_number(line, NULL, first);
    json_number(line, NULL, second);
    json_close_array(line);
}

static void open_bracket(cli_json *line, const char *key, char bracket)
{
    start_item(line, key);
    putc(bracket, line->out);
    line->comma = false;
}

static void close_bracket(cli_json *line, char bracket)
{
    putc(bracket, line->out);
    line->comma = true;
}

void json_open_object(cli_json *line, const char *key)
{
    open_bracket(line, key, '{');
}

void json_close_object(cli_json *line)
{
    close_bracket(line, '}');
}

void json_open_array(cli_json *line, const char *key)
{
    open_bracket(line, key, '[');
}

void json_close_array(cli_json *line)
{
    close_bracket(line, ']');
}
