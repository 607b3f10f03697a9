/* SPDX-License-Identifier: MIT */
/** @file schema.c
 *  The table of keys as a JSON schema. Draft 7, since the language servers that editors use for YAML and JSON know it
 *  wholly, of later drafts parts. */
#include "schema.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "json.h"
#include "keys.h"

static void put_object(cli_json *line, const sph2d_keys *keys);

/* ---- values ------------------------------------------------------------------------------------------------------ */

static void put_range(cli_json *line, const sph2d_key *key)
{
    if (isfinite(key->min))
        json_number(line, key->min_excluded ? "exclusiveMinimum" : "minimum", key->min);
    if (isfinite(key->max))
        json_number(line, "maximum", key->max);
    else if (key->kind == SPH2D_KEY_COUNT)
        json_count(line, "maximum", UINT64_MAX);
}

static void put_number(cli_json *line, const sph2d_key *key)
{
    const bool whole = key->kind == SPH2D_KEY_COUNT || key->kind == SPH2D_KEY_COUNTS2;
    json_text(line, "type", whole ? "integer" : "number");
    if (!key->zero_is_unset) {
        put_range(line, key);
        return;
    }
    json_open_array(line, "anyOf"); /* editors tell what the first of several asks for */
    json_open_object(line, NULL);
    put_range(line, key);
    json_close_object(line);
    json_open_object(line, NULL);
    json_count(line, "const", 0);
    json_close_object(line);
    json_close_array(line);
}

/* A list of `least` to `most` items, SIZE_MAX for any, of which `inner` tells what they are. */
static void put_list(cli_json *line, const sph2d_key *key, size_t least, size_t most,
                     void (*inner)(cli_json *line, const sph2d_key *key))
{
    json_text(line, "type", "array");
    json_open_object(line, "items");
    inner(line, key);
    json_close_object(line);
    if (most == SIZE_MAX)
        return;
    json_count(line, "minItems", least);
    json_count(line, "maxItems", most);
}

static void put_tuple(cli_json *line, const sph2d_key *key)
{
    const size_t most = key->kind == SPH2D_KEY_POSES ? 4 : key->kind == SPH2D_KEY_PATH ? 3 : 2;
    put_list(line, key, most < 3 ? most : 3, most, put_number);
}

static void put_item(cli_json *line, const sph2d_key *key)
{
    put_object(line, key->keys);
}

/* A file may have true and false in place of the texts of that name. */
static void put_words(cli_json *line, const char *const *words)
{
    json_open_array(line, "enum");
    for (size_t i = 0; words[i]; ++i) {
        json_text(line, NULL, words[i]);
        if (strcmp(words[i], "true") == 0 || strcmp(words[i], "false") == 0)
            json_flag(line, NULL, words[i][0] == 't');
    }
    json_close_array(line);
}

/* Numbers and the like are texts, too, where one is asked for. */
static void put_text(cli_json *line)
{
    json_open_array(line, "type");
    json_text(line, NULL, "string");
    json_text(line, NULL, "number");
    json_text(line, NULL, "boolean");
    json_close_array(line);
}

/* A group, or the word that is short for it. */
static void put_group(cli_json *line, const sph2d_keys *keys)
{
    size_t i = 0;
    while (i < keys->count && !keys->items[i].stands_alone)
        ++i;
    if (i == keys->count) {
        put_object(line, keys);
        return;
    }
    json_open_array(line, "anyOf");
    json_open_object(line, NULL);
    json_text(line, "type", "string");
    put_words(line, keys->items[i].words);
    json_close_object(line);
    json_open_object(line, NULL);
    put_object(line, keys);
    json_close_object(line);
    json_close_array(line);
}

static void put_value(cli_json *line, const sph2d_key *key)
{
    switch (key->kind) {
    case SPH2D_KEY_NUMBER:
    case SPH2D_KEY_COUNT:
        put_number(line, key);
        break;
    case SPH2D_KEY_COUNTS2:
    case SPH2D_KEY_POINT:
        put_tuple(line, key);
        break;
    case SPH2D_KEY_POINTS:
    case SPH2D_KEY_PATH:
    case SPH2D_KEY_POSES:
        put_list(line, key, 0, SIZE_MAX, put_tuple);
        break;
    case SPH2D_KEY_NUMBERS:
        put_list(line, key, 0, SIZE_MAX, put_number);
        break;
    case SPH2D_KEY_TEXT:
        put_text(line);
        break;
    case SPH2D_KEY_WORD:
        put_words(line, key->words);
        break;
    case SPH2D_KEY_GROUP:
        put_group(line, key->keys);
        break;
    case SPH2D_KEY_LIST:
        if (key->as_mapping)
            json_text(line, "type", "object");
        else
            put_list(line, key, 0, SIZE_MAX, put_item);
        break;
    }
}

/* ---- keys -------------------------------------------------------------------------------------------------------- */

static void put_property(cli_json *line, const sph2d_key *key, const char *name)
{
    char description[1000];
    json_open_object(line, name);
    json_text(line, "description", keys_describe(key, description, sizeof description));
    put_value(line, key);
    json_close_object(line);
}

/* Under `name`, the keys that exclude it: each of them is refused where it stands. */
static void put_excluded(cli_json *line, const sph2d_keys *keys, const sph2d_key *key, const char *name)
{
    json_open_object(line, name);
    json_open_object(line, "properties");
    for (size_t i = 0; i < keys->count; ++i) {
        const sph2d_key *other = &keys->items[i];
        if (!other->choice || other->choice_offset != key->choice_offset)
            continue;
        if (strcmp(other->name, name) != 0)
            json_flag(line, other->name, false);
        if (other->also && strcmp(other->also, name) != 0)
            json_flag(line, other->also, false);
    }
    json_close_object(line);
    json_close_object(line);
}

/* What a mapping of keys is, into an object that is open. */
static void put_object(cli_json *line, const sph2d_keys *keys)
{
    json_text(line, "type", "object");
    json_open_object(line, "properties");
    for (size_t i = 0; i < keys->count; ++i) {
        put_property(line, &keys->items[i], keys->items[i].name);
        if (keys->items[i].also)
            put_property(line, &keys->items[i], keys->items[i].also);
    }
    json_close_object(line);
    json_flag(line, "additionalProperties", false);
    json_open_array(line, "required");
    for (size_t i = 0; i < keys->count; ++i)
        if (keys->items[i].required)
            json_text(line, NULL, keys->items[i].name);
    json_close_array(line);
    json_open_object(line, "dependencies");
    for (size_t i = 0; i < keys->count; ++i) {
        if (keys->items[i].choice)
            put_excluded(line, keys, &keys->items[i], keys->items[i].name);
        if (keys->items[i].choice && keys->items[i].also)
            put_excluded(line, keys, &keys->items[i], keys->items[i].also);
    }
    json_close_object(line);
}

void schema_print(const sph2d_keys *keys, const char *title)
{
    cli_json line = json_begin(stdout);
    json_text(&line, "$schema", "http://json-schema.org/draft-07/schema#");
    json_text(&line, "title", title);
    put_object(&line, keys);
    json_end(&line);
}
