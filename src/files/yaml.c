/* SPDX-License-Identifier: MIT */
/** @file yaml.c
 *  The only file that uses libfyaml. It handles the parser's events, not its documents, so that duplicate keys can be
 *  reported with all other errors, nothing recurses, and aliases cannot expand without bound. */
#include "files/document.h"
#include "files/yaml_hint.h"

#include <errno.h>
#include <libfyaml.h>
#include <string.h>

/** Maximum number of values in a text, and of characters that may start or end one. A scene has hundreds; the limits
 *  bound memory for other texts. The characters are counted before parsing, since libfyaml looks ahead to the end of
 *  brackets that open a document, with 350 bytes for each. */
enum { MAX_NODES = 1000000, MAX_MARKS = 2 * MAX_NODES };

typedef struct builder {
    const sph2d__source *source;
    sph2d__faults *faults;
    sph2d__node *root;
    sph2d__node *open[SPH2D__TREE_DEPTH]; /**< collections that are not closed yet, outermost first */
    size_t depth;
    const char *key; /**< of the value that comes next, where it has one */
    sph2d__place key_place;
    size_t last; /**< start of the last event: the place of values without text */
    size_t nodes;
    bool ended;    /**< a document is complete */
    bool finished; /**< the text has come to its end */
    sph2d_status status;
} builder;

static sph2d__place place_at(const builder *b, size_t offset)
{
    return (sph2d__place){b->source, offset};
}

/** Reports what a scene must not have, and what to do. */
static void refuse(builder *b, size_t offset, const char *message, const char *hint)
{
    sph2d_diagnostic *d = sph2d__fault(b->faults, SPH2D_CODE_SYNTAX, place_at(b, offset), NULL, "%s", message);
    sph2d_diagnostic_hint(d, hint ? "%s" : NULL, hint);
}

/** Reports an error that ends the parsing. */
static void stop(builder *b, size_t offset, const char *message)
{
    refuse(b, offset, message, NULL);
    b->status = SPH2D_SCENE;
}

static bool check_mark_count(builder *b)
{
    static const bool is_mark[256] = {['['] = true, [']'] = true, ['{'] = true, ['}'] = true, [','] = true,
                                      [':'] = true, ['&'] = true, ['*'] = true, ['!'] = true, ['%'] = true};
    size_t marks = 0;
    for (size_t i = 0; i < b->source->length; ++i) {
        marks += is_mark[(unsigned char)b->source->text[i]];
        if (marks > MAX_MARKS) {
            stop(b, i, "more than a million values");
            return false;
        }
    }
    return true;
}

static size_t token_offset(struct fy_token *token, size_t otherwise)
{
    const struct fy_mark *mark = token ? fy_token_start_mark(token) : NULL;
    return mark ? mark->input_pos : otherwise;
}

/** Reports anchors and tags; the node itself is valid. Their positions are after `&` and `!`. */
static void refuse_properties(builder *b, struct fy_token *anchor, struct fy_token *tag)
{
    if (anchor)
        refuse(b, token_offset(anchor, b->last), "anchors (&name) are not allowed",
               "write the value again where it is used; a text that begins with & belongs into quotes");
    if (tag)
        refuse(b, token_offset(tag, b->last), "tags (!name) are not allowed",
               "leave it out; a text that begins with ! belongs into quotes");
}

/** Adds a new node to the tree. NULL if the parsing must stop. */
static sph2d__node *add_node(builder *b, sph2d__node_kind kind, size_t offset)
{
    if (++b->nodes > MAX_NODES) {
        stop(b, offset, "more than a million values");
        return NULL;
    }
    sph2d__node *parent = b->depth > 0 ? b->open[b->depth - 1] : NULL;
    if (parent && parent->kind == SPH2D__NODE_MAPPING && !b->key && kind != SPH2D__NODE_SCALAR) {
        stop(b, offset, "a key must be a word");
        return NULL;
    }
    sph2d__node *node = sph2d__node_new(b->faults->pool, kind, place_at(b, offset));
    if (!node) {
        b->status = SPH2D_NOMEM;
        return NULL;
    }
    node->key = b->key;
    if (b->key)
        node->key_place = b->key_place;
    b->key = NULL;
    if (parent)
        sph2d__node_append(parent, node);
    else
        b->root = node;
    return node;
}

static void open_collection(builder *b, sph2d__node_kind kind, struct fy_token *start, size_t offset)
{
    sph2d__node *node = add_node(b, kind, offset);
    if (!node)
        return;
    enum fy_token_type type = start ? fy_token_get_type(start) : FYTT_NONE;
    node->flow = type == FYTT_FLOW_MAPPING_START || type == FYTT_FLOW_SEQUENCE_START;
    if (b->depth == SPH2D__TREE_DEPTH)
        stop(b, offset, "nested too deeply");
    else
        b->open[b->depth++] = node;
}

/** Handles a scalar: the key of the next node, or a value. */
static void handle_scalar(builder *b, struct fy_token *token, size_t offset)
{
    size_t length = 0;
    const char *text = fy_token_get_text(token, &length);
    char *copy = text ? sph2d__pool_text(b->faults->pool, text, length) : NULL;
    if (!copy) {
        b->status = SPH2D_NOMEM;
        return;
    }
    if (strlen(copy) != length) {
        stop(b, offset, "a text contains a NUL character");
        return;
    }
    enum fy_scalar_style style = fy_token_scalar_style(token);
    bool in_quotes = style == FYSS_SINGLE_QUOTED || style == FYSS_DOUBLE_QUOTED;
    if (in_quotes && offset > 0) /* the position is after the quote */
        --offset;
    const sph2d__node *parent = b->depth > 0 ? b->open[b->depth - 1] : NULL;
    if (parent && parent->kind == SPH2D__NODE_MAPPING && !b->key) {
        b->key = copy;
        b->key_place = place_at(b, offset);
        return;
    }
    sph2d__node *node = add_node(b, SPH2D__NODE_SCALAR, offset);
    if (node) {
        node->text = copy;
        node->length = length;
        node->quoted = style != FYSS_PLAIN;
    }
}

static void handle_event(builder *b, struct fy_event *event)
{
    const struct fy_mark *mark = fy_event_start_mark(event);
    size_t offset = b->last = mark ? mark->input_pos : b->last;
    switch (event->type) {
    case FYET_DOCUMENT_START:
        if (b->ended) {
            refuse(b, offset, "a second document: a scene must be one document", "put it into a file of its own");
            b->status = SPH2D_SCENE;
        }
        break;
    case FYET_DOCUMENT_END:
        b->ended = true;
        break;
    case FYET_STREAM_END:
        b->finished = true;
        break;
    case FYET_MAPPING_START:
        refuse_properties(b, event->mapping_start.anchor, event->mapping_start.tag);
        open_collection(b, SPH2D__NODE_MAPPING, event->mapping_start.mapping_start, offset);
        break;
    case FYET_SEQUENCE_START:
        refuse_properties(b, event->sequence_start.anchor, event->sequence_start.tag);
        open_collection(b, SPH2D__NODE_SEQUENCE, event->sequence_start.sequence_start, offset);
        break;
    case FYET_MAPPING_END:
    case FYET_SEQUENCE_END:
        --b->depth;
        break;
    case FYET_SCALAR:
        refuse_properties(b, event->scalar.anchor, event->scalar.tag);
        handle_scalar(b, event->scalar.value, offset);
        break;
    case FYET_ALIAS:
        refuse(b, offset, "aliases (*name) are not allowed", "write the value itself here");
        add_node(b, SPH2D__NODE_FAULTY, offset);
        break;
    default:
        break;
    }
}

/** Reports libfyaml's errors. An unclosed bracket is reported where it opens, not at the end of the file. */
static void report_syntax(builder *b, struct fy_diag *diag)
{
    void *position = NULL;
    size_t before = b->faults->errors;
    for (struct fy_diag_error *e; (e = fy_diag_errors_iterate(diag, &position));) {
        if (e->type != FYET_ERROR)
            continue;
        size_t offset = token_offset(e->fyt, b->last);
        sph2d__node *innermost = b->depth > 0 ? b->open[b->depth - 1] : NULL;
        const bool open = offset >= b->source->length && innermost && innermost->flow;
        const char *message = open     ? "the bracket that opens here is not closed"
                              : e->msg ? e->msg
                                       : "not well-formed YAML";
        if (open)
            offset = innermost->place.offset;
        sph2d_diagnostic *d = sph2d__fault(b->faults, SPH2D_CODE_SYNTAX, place_at(b, offset), NULL, "%s", message);
        if (open)
            sph2d__yaml_hint_open(d, b->source, offset);
        else
            sph2d__yaml_hint(d, b->source, offset, message);
        b->status = SPH2D_SCENE;
    }
    if (b->faults->errors == before)
        stop(b, b->last, "not well-formed YAML");
}

/** Parses to the end. Where memory is short libfyaml gives an empty text, or calls it a fault of the file; but malloc's
 *  errno tells. */
static void run_parser(builder *b, struct fy_parser *parser, struct fy_diag *diag)
{
    struct fy_event *event;
    while (b->status == SPH2D_OK && (event = fy_parser_parse(parser))) {
        handle_event(b, event);
        fy_parser_event_free(parser, event);
        if (errno == ENOMEM)
            b->status = SPH2D_NOMEM;
    }
    if (b->status != SPH2D_OK || (b->finished && !fy_parser_get_stream_error(parser)))
        return;
    if (errno == ENOMEM || !fy_parser_get_stream_error(parser))
        b->status = SPH2D_NOMEM;
    else
        report_syntax(b, diag);
}

sph2d_status sph2d__yaml_parse(const sph2d__source *source, sph2d__faults *faults, sph2d__node **root)
{
    *root = NULL;
    builder b = {.source = source, .faults = faults};
    if (!sph2d__text_check(source, faults) || !check_mark_count(&b))
        return SPH2D_SCENE;
    b.status = SPH2D_NOMEM;
    errno = 0;
    struct fy_diag_cfg diag_config;
    fy_diag_cfg_default(&diag_config);
    diag_config.fp = NULL;
    diag_config.level = FYET_ERROR;
    struct fy_diag *diag = fy_diag_create(&diag_config);
    if (diag)
        fy_diag_set_collect_errors(diag, true);
    struct fy_parse_cfg config = {.flags = FYPCF_COLLECT_DIAG | FYPCF_DEFAULT_VERSION_1_2 | FYPCF_JSON_NONE,
                                  .diag = diag};
    struct fy_parser *parser = diag ? fy_parser_create(&config) : NULL;
    if (parser && fy_parser_set_string(parser, source->text, source->length) == 0) {
        b.status = SPH2D_OK;
        run_parser(&b, parser, diag);
    }
    if (parser)
        fy_parser_destroy(parser);
    if (diag)
        fy_diag_destroy(diag);
    *root = b.root;
    return b.status;
}
