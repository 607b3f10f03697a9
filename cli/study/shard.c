/* SPDX-License-Identifier: MIT */
/** @file shard.c
 *  A part of the rows of a study, run beside other processes that run the other parts in the same folder. */
#include "parts.h"

#include <inttypes.h>
#include <string.h>

#include "../exit.h"
#include "../json.h"
#include "../message.h"
#include "../text.h"

/* Whether a row that is wanted is none that others find: of its own only those that ended well are kept. */
static bool is_missing(const sph2d_study_row *row)
{
    return row->wanted && !(row->there && row->record.end <= SPH2D_STUDY_GUARD);
}

int study_gather(cli_study *s, size_t first)
{
    int code = CLI_EXIT_SUCCESS;
    if (s->options->shards == 0)
        return code;
    s->missing = s->by_shards = 0;
    for (size_t r = 0; r < s->results->row_count; ++r) {
        sph2d_study_row *row = &s->results->rows[r];
        if (r >= first && row->wanted && !row->there && !study_owns(s, row))
            code = study_first(code, study_find(s, row));
        s->missing += is_missing(row);
        s->by_shards += row->there;
    }
    return code;
}

/* A list of ascending numbers, "1-3,7", as an array job takes it. */
typedef struct list {
    char text[128];
    uint64_t first, last; /* the range at its end, which may grow; 0: none */
} list;

static void end_range(list *l)
{
    static const char more[] = ",...";
    if (l->first > 0)
        text_append(l->text, sizeof l->text, "%s%" PRIu64, l->text[0] != '\0' ? "," : "", l->first);
    if (l->last > l->first)
        text_append(l->text, sizeof l->text, "-%" PRIu64, l->last);
    if (strlen(l->text) == sizeof l->text - 1)
        memcpy(l->text + sizeof l->text - sizeof more, more, sizeof more);
}

static void add_number(list *l, uint64_t number)
{
    if (l->first == 0 || number != l->last + 1) {
        end_range(l);
        l->first = number;
    }
    l->last = number;
}

void study_missing_tell(const cli_study *s)
{
    list rows = {.first = 0}, shards = {.first = 0};
    size_t count = s->results->row_count, step = (size_t)s->options->shards, missing_shards = 0;
    for (size_t r = 0; r < count; ++r)
        if (is_missing(&s->results->rows[r]))
            add_number(&rows, r + 1);
    for (size_t shard = 0; shard < step && shard < count; ++shard) {
        bool missing = false;
        for (size_t r = shard; r < count && !missing; r += step)
            missing = is_missing(&s->results->rows[r]);
        if (missing) {
            add_number(&shards, shard + 1);
            ++missing_shards;
        }
    }
    end_range(&rows);
    end_range(&shards);
    message_note("no table yet: row%s %s of shard%s %s %s missing", s->missing == 1 ? "" : "s", rows.text,
                 missing_shards == 1 ? "" : "s", shards.text, s->missing == 1 ? "is" : "are");
}

void study_missing_json(const cli_study *s, const char *end, bool passed)
{
    cli_json line = json_begin(stdout);
    json_text(&line, "study", s->path);
    json_text(&line, "scene", s->study->scene);
    json_text(&line, "end", end);
    json_flag(&line, "passed", passed);
    json_count(&line, "shard", (uint64_t)s->options->shard);
    json_count(&line, "shards", (uint64_t)s->options->shards);
    json_open_array(&line, "missing");
    for (size_t r = 0; r < s->results->row_count; ++r)
        if (is_missing(&s->results->rows[r]))
            json_count(&line, NULL, s->results->rows[r].number);
    json_close_array(&line);
    json_end(&line);
}
