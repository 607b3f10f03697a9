/* SPDX-License-Identifier: MIT */
/** @file document.c
 *  What scene files and study files share. */
#include "files/document.h"

#include <stdio.h>
#include <string.h>

#include "base/number.h"
#include "files/convert.h"

enum { MOST_BYTES = 64 << 20 };

/** Whether the text holds a mapping; a fault otherwise. */
static bool has_keys(const sph2d__document *document, const sph2d__document_kind *kind, sph2d__faults *faults)
{
    const sph2d__node *root = document->root;
    if (root && root->kind == SPH2D__NODE_MAPPING)
        return true;
    if (faults->errors > 0) /* anchors and the like say enough */
        return false;
    sph2d_diagnostic *d;
    if (!root || sph2d__node_is_null(root)) {
        sph2d__place whole = {&document->source, SPH2D__NOWHERE};
        d = sph2d__fault(faults, SPH2D_CODE_SYNTAX, whole, NULL, "there is no %s in this file: it is empty",
                         kind->name);
    } else {
        char got[80];
        d = sph2d__fault(faults, SPH2D_CODE_SYNTAX, root->place, NULL, "expected the keys of a %s, got %s", kind->name,
                         sph2d__node_describe(root, got, sizeof got));
    }
    sph2d_diagnostic_hint(d, "%s", kind->hint);
    return false;
}

sph2d_status sph2d__document_parse(sph2d__document *document, const sph2d__document_kind *kind, const char *text,
                                   size_t length, const char *name, void *owner, sph2d_report *report)
{
    document->source = (sph2d__source){.name = sph2d__pool_text(&document->pool, name, strlen(name)),
                                       .text = sph2d__pool_text(&document->pool, text, length),
                                       .length = length,
                                       .has_lines = true};
    sph2d__c_locale locale;
    if (!document->source.name || !document->source.text || !sph2d__c_locale_begin(&locale))
        return SPH2D_NOMEM;
    sph2d__faults faults = {.report = report, .pool = &document->pool};
    size_t first = report ? report->count : 0;
    sph2d_status status = sph2d__yaml_parse(&document->source, &faults, &document->root);
    if (status == SPH2D_OK)
        status = has_keys(document, kind, &faults) ? kind->read(owner, &faults) : SPH2D_SCENE;
    sph2d__faults_sort(report, first);
    sph2d__c_locale_end(&locale);
    return status;
}

sph2d_status sph2d__document_text(const char *path, char **text, size_t *length, sph2d_report *report)
{
    return sph2d__text_read(path, MOST_BYTES, text, length, report);
}

sph2d_status sph2d__document_text_open(int descriptor, const char *name, char **text, size_t *length,
                                       sph2d_report *report)
{
    return sph2d__text_read_open(descriptor, name, MOST_BYTES, text, length, report);
}

void sph2d__document_pass(const sph2d__document *document, const sph2d_report *found, sph2d__faults *faults,
                          bool (*is_consequence)(const sph2d_diagnostic *diagnostic, const sph2d__faults *faults))
{
    bool sound = faults->errors + found->errors == 0; /* warnings about what has faults may be wrong */
    size_t without_room = found->errors;
    for (size_t i = 0; i < found->count; ++i) {
        const sph2d_diagnostic *d = &found->items[i];
        bool is_error = d->severity == SPH2D_ERROR;
        without_room -= is_error;
        if (is_error ? is_consequence && is_consequence(d, faults) : !sound)
            continue;
        faults->errors += is_error;
        sph2d_diagnostic *copy = sph2d_report_add(faults->report, d->severity, d->code, NULL, "%s", d->message);
        if (copy) {
            *copy = *d;
            sph2d__node_locate(document->root, copy);
        }
    }
    faults->errors += without_room;
    if (faults->report) {
        faults->report->dropped += found->dropped;
        faults->report->errors += without_room;
    }
}

/* ---- overrides --------------------------------------------------------------------------------------------------- */

/** An override that is being applied. */
typedef struct change {
    const sph2d_override *override;
    sph2d__place place;
    sph2d__node *value;
    sph2d__faults *faults;
} change;

static sph2d_diagnostic *refuse(change *c, sph2d_code code, const char *message)
{
    return sph2d__fault(c->faults, code, c->place, c->override->path, "%s", message);
}

/** Replaces the contents of `node` by those of `with`, keeping its key and its order among siblings. */
static void replace(sph2d__node *node, const sph2d__node *with)
{
    sph2d__node *next = node->next;
    const char *key = node->key;
    *node = *with;
    node->next = next;
    node->key = key;
    node->key_place = with->place;
}

/** Adds a mapping under a step's name. */
static sph2d__node *add_child(change *c, sph2d__node *parent, const sph2d__step *step)
{
    sph2d__node *child = sph2d__node_new(c->faults->pool, SPH2D__NODE_MAPPING, c->place);
    char *key = child ? sph2d__pool_text(c->faults->pool, step->name, step->length) : NULL;
    if (!key) {
        c->faults->short_of_memory = true;
        return NULL;
    }
    child->key = key;
    parent->kind = SPH2D__NODE_MAPPING; /* it may have been a key without a value */
    sph2d__node_append(parent, child);
    return child;
}

/** Whether the rest of a path, from `step` on, can be created under `node`: keys can, list items cannot. */
static bool can_create(change *c, const sph2d__node *node, sph2d__step step, const char *rest)
{
    char message[96] = "";
    if (!step.name && node->kind == SPH2D__NODE_SEQUENCE)
        snprintf(message, sizeof message, "there is no item [%zu]: the list has %zu", step.index, node->count);
    else if (step.name && node->kind != SPH2D__NODE_MAPPING && !sph2d__node_is_null(node))
        snprintf(message, sizeof message, "there is no mapping for the key '%.*s'",
                 step.length < 40 ? (int)step.length : 40, step.name);
    while (!message[0]) {
        if (!step.name)
            snprintf(message, sizeof message, "there is no list for the item [%zu]", step.index);
        else if (!sph2d__path_step(&rest, &step))
            return true;
    }
    refuse(c, SPH2D_CODE_UNKNOWN_KEY, message);
    return false;
}

/** Checks the syntax and the depth of a path. */
static bool is_path(change *c)
{
    const char *rest = c->override->path;
    sph2d__step step;
    size_t depth = 0;
    while (depth < SPH2D__TREE_DEPTH && sph2d__path_step(&rest, &step))
        ++depth;
    if (depth > 0 && !*rest)
        return true;
    sph2d_diagnostic *d = refuse(c, SPH2D_CODE_SYNTAX, "this is not a key path");
    sph2d_diagnostic_hint(d, "write keys with points between them and list items as [0]: blocks[0].box.max");
    return false;
}

static void put(change *c, sph2d__node *root)
{
    if (!is_path(c))
        return;
    const char *rest = c->override->path;
    sph2d__node *node = root;
    bool creating = false;
    for (sph2d__step step; node && sph2d__path_step(&rest, &step);) {
        sph2d__node *child = creating ? NULL : sph2d__node_step(node, &step);
        if (!child && !creating && !can_create(c, node, step, rest))
            return;
        creating = !child;
        node = child ? child : add_child(c, node, &step);
    }
    if (node)
        replace(node, c->value);
}

static sph2d_status apply(const sph2d_override *override, sph2d__node *root, sph2d__faults *faults)
{
    const char *value = override->value;
    size_t size = strlen(override->path) + strlen(value) + sizeof "--set =";
    char *name = sph2d__pool_alloc(faults->pool, size, 1);
    sph2d__source *source = sph2d__pool_alloc(faults->pool, 1, sizeof *source);
    if (!name || !source)
        return SPH2D_NOMEM;
    snprintf(name, size, "--set %s=%s", override->path, value);
    *source = (sph2d__source){.name = name, .text = value, .length = strlen(value)};
    change c = {.override = override, .place = {source, SPH2D__NOWHERE}, .faults = faults};
    sph2d_status status = sph2d__yaml_parse(source, faults, &c.value);
    if (status != SPH2D_OK)
        return status == SPH2D_NOMEM ? status : SPH2D_OK; /* reported; check the next override, too */
    if (!c.value)
        c.value = sph2d__node_new(faults->pool, SPH2D__NODE_SCALAR, c.place);
    if (!c.value)
        return SPH2D_NOMEM;
    put(&c, root);
    return SPH2D_OK;
}

bool sph2d__overrides_given(const sph2d_override *overrides, size_t count)
{
    for (size_t i = 0; overrides && i < count; ++i)
        if (!overrides[i].path || !overrides[i].value)
            return false;
    return overrides || count == 0;
}

sph2d_status sph2d__overrides_apply(const sph2d_override *overrides, size_t count, sph2d__node *root,
                                    sph2d__faults *faults)
{
    for (size_t i = 0; i < count; ++i) {
        sph2d_status status = apply(&overrides[i], root, faults);
        if (status != SPH2D_OK)
            return status;
        sph2d__convert_words(root, sph2d_scene_keys(), faults);
    }
    return SPH2D_OK;
}
