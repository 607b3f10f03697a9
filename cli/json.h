/* SPDX-License-Identifier: MIT */
/** @file json.h
 *  Writes one JSON object on one line, so that a stream of them is JSON Lines.
 *
 *      cli_json line = json_begin(stdout);
 *      json_text(&line, "name", name);
 *      json_end(&line);
 *
 *  Inside an array the key is NULL. */
#ifndef SPH2D_CLI_JSON_H
#define SPH2D_CLI_JSON_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct cli_json {
    FILE *out;
    bool comma; /**< the next item needs a comma */
} cli_json;

cli_json json_begin(FILE *out);
void json_end(cli_json *line);

/** NULL becomes null; bytes that are not UTF-8 become U+FFFD. */
void json_text(cli_json *line, const char *key, const char *value);
/** The shortest digits that read back as the same double; NaN and infinity become null. */
void json_number(cli_json *line, const char *key, double value);
void json_count(cli_json *line, const char *key, uint64_t value);
void json_flag(cli_json *line, const char *key, bool value);
void json_pair(cli_json *line, const char *key, double first, double second); /**< [first, second] */

void json_open_object(cli_json *line, const char *key);
void json_close_object(cli_json *line);
void json_open_array(cli_json *line, const char *key);
void json_close_array(cli_json *line);

#endif
