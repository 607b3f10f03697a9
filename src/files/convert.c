/* SPDX-License-Identifier: MIT */
/** @file convert.c
 *  Conversion of mappings to structs: known, missing, unknown and duplicate keys. */
#include "files/convert.h"

#include <stdio.h>
#include <string.h>

#include "base/suggest.h"
#include "files/foreign.h"
#include "files/yaml_hint.h"

/** Maximum number of keys of a struct; a test checks the table. */
enum { MAX_KEYS = 64 };
/** Maximum number of keys of a list that is written as a mapping; the search for duplicates is quadratic. */
enum { MAX_PAIRS = 1000 };

/** A mapping that is being converted. */
typedef struct level {
    const sph2d_keys *keys;
    const sph2d__node *node;
    const char *path;
    const sph2d__node *given[MAX_KEYS]; /**< by index of the key: its value */
} level;

static void join(char path[SPH2D__PATH_SIZE], const char *above, const char *name)
{
    snprintf(path, SPH2D__PATH_SIZE, "%s%s%s", above, above[0] ? "." : "", name);
}

static size_t key_count(const sph2d_keys *keys)
{
    return keys->count < MAX_KEYS ? keys->count : MAX_KEYS;
}

/** The index of a key; the count when there is none of that name. */
static size_t key_index(const sph2d_keys *keys, const char *name)
{
    size_t i = 0;
    while (i < key_count(keys) && strcmp(keys->items[i].name, name) != 0 &&
           !(keys->items[i].also && strcmp(keys->items[i].also, name) == 0))
        ++i;
    return i;
}

/** " on line 3", or "" for a place without a line. */
static const char *on_line(const sph2d__node *node, char out[32])
{
    int line = sph2d__place_line(node->key_place);
    out[0] = '\0';
    if (line > 0)
        snprintf(out, 32, " on line %d", line);
    return out;
}

static void report_unknown(sph2d__converter *c, const level *m, const sph2d__node *child, const char *path)
{
    if (child->kind == SPH2D__NODE_FAULTY) { /* `<<: *other`: told, and the keys that it would bring are missing */
        sph2d__faults_mark_invalid(c->faults, m->path);
        return;
    }
    sph2d_diagnostic *d =
        sph2d__fault(c->faults, SPH2D_CODE_UNKNOWN_KEY, child->key_place, path, "unknown key '%.60s'", child->key);
    if (!d || sph2d__yaml_hint_word(d, child->key))
        return;
    const sph2d_key *key = NULL;
    const char *known = c->keys == sph2d_scene_keys() ? sph2d__foreign_path(child->key, m->keys, &key) : NULL;
    char elsewhere[160] = "";
    if (known)
        snprintf(elsewhere, sizeof elsewhere, "did you mean '%s'%s%s?", known, key->unit[0] ? ", in " : "", key->unit);
    if (known && key_index(m->keys, known) < key_count(m->keys))
        sph2d_diagnostic_hint(d, "%s", elsewhere);
    else
        sph2d__suggest_key(d, child->key, m->keys, c->keys, elsewhere);
}

static void report_duplicate(sph2d__converter *c, const sph2d__node *child, const sph2d__node *first, const char *path)
{
    char where[32];
    sph2d_diagnostic *d =
        sph2d__fault(c->faults, SPH2D_CODE_DUPLICATE_KEY, child->key_place, path, "'%s' is given twice", child->key);
    sph2d_diagnostic_hint(d, "first%s; keep one of them", on_line(first, where));
}

/** Reports a key of the same choice that was given before; whether there is one. */
static bool excluded(sph2d__converter *c, const level *m, size_t index, const sph2d__node *child, const char *path)
{
    const sph2d_key *key = &m->keys->items[index];
    const sph2d__node *other_choice = NULL;
    char list[160] = "";
    for (size_t i = 0; i < key_count(m->keys); ++i) {
        const sph2d_key *other = &m->keys->items[i];
        if (!other->choice || other->choice_offset != key->choice_offset)
            continue;
        size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s", used > 0 ? ", " : "", other->name);
        if (m->given[i])
            other_choice = m->given[i];
    }
    if (!key->choice || !other_choice)
        return false;
    char where[32];
    sph2d_diagnostic *d = sph2d__fault(c->faults, SPH2D_CODE_CONFLICT, child->key_place, path, "'%s' excludes '%s'%s",
                                       child->key, other_choice->key, on_line(other_choice, where));
    sph2d_diagnostic_hint(d, "give one of %s", list);
    return true;
}

/** Reports what is no list, or no mapping, and says how one is written. */
static void report_kind(sph2d__converter *c, const sph2d_key *key, const sph2d__node *node, const char *path, bool list)
{
    sph2d_diagnostic *d = sph2d__convert_wrong_type(c, key, node, path, list ? "a list" : "a mapping");
    const bool item = !list && key->kind == SPH2D_KEY_LIST;
    const char *first = node->first && node->first->key ? node->first->key : key->keys->items[0].name;
    if (!d || sph2d__yaml_hint_word(d, node->kind == SPH2D__NODE_SCALAR ? node->text : first))
        return;
    if (list && node->kind == SPH2D__NODE_MAPPING && node->count > 0 && !node->flow)
        sph2d_diagnostic_hint(d, "begin each item of a list by a dash and a blank: - %.60s: ...", first);
    else if (list)
        sph2d_diagnostic_hint(d, "a list has items: %s: [{%.60s: ...}]", key->name, first);
    else if (node->kind == SPH2D__NODE_SEQUENCE && !node->flow)
        sph2d_diagnostic_hint(d, "leave the dashes out: %s%s has keys, not items", item ? "an item of " : "",
                              key->name);
    else if (sph2d__node_is_null(node) && !item)
        sph2d_diagnostic_hint(d, "indent its keys below it, by two blanks more");
    else
        sph2d_diagnostic_hint(d, "%s%s has keys: {%s: ...}", item ? "an item of " : "", key->name, first);
}

static void store_list(const sph2d_key *key, const void *items, size_t count, void *out)
{
    memcpy((char *)out + key->offset, &items, sizeof items);
    memcpy((char *)out + key->count_offset, &count, sizeof count);
}

/** A list that is written as a mapping: the keys are the first text of its items, the values, of any kind, the second.
 */
static void convert_pairs(sph2d__converter *c, const sph2d_key *key, const sph2d__node *node, const char *path,
                          void *out)
{
    if (node->kind != SPH2D__NODE_MAPPING || node->count > MAX_PAIRS) {
        sph2d__convert_wrong_type(c, key, node, path, node->count > MAX_PAIRS ? "at most 1000 keys" : "a mapping");
        return;
    }
    size_t size = key->keys->size, count = 0;
    char *items = sph2d__pool_alloc(c->pool, node->count, size);
    c->faults->short_of_memory |= !items;
    for (const sph2d__node *child = node->first; child && items; child = child->next) {
        const sph2d__node *first = sph2d__node_find(node, child->key, strlen(child->key));
        const char *text = sph2d__node_text(child, c->pool);
        c->faults->short_of_memory |= !text;
        if (first != child)
            report_duplicate(c, child, first, path);
        char *item = items + count++ * size;
        memcpy(item + key->keys->items[0].offset, &child->key, sizeof child->key);
        memcpy(item + key->keys->items[1].offset, &text, sizeof text);
    }
    store_list(key, items, count, out);
}

static void convert_list(sph2d__converter *c, const sph2d_key *key, const sph2d__node *node, const char *path,
                         void *out)
{
    if (key->as_mapping) {
        convert_pairs(c, key, node, path, out);
        return;
    }
    if (node->kind != SPH2D__NODE_SEQUENCE) {
        report_kind(c, key, node, path, true);
        return;
    }
    size_t size = key->keys->size;
    char *items = sph2d__pool_alloc(c->pool, node->count, size);
    if (!items) {
        c->faults->short_of_memory = true;
        return;
    }
    size_t index = 0;
    for (const sph2d__node *child = node->first; child; child = child->next, ++index) {
        char item_path[SPH2D__PATH_SIZE];
        snprintf(item_path, sizeof item_path, "%.200s[%zu]", path, index);
        void *item = items + index * size;
        if (key->keys->set_default)
            key->keys->set_default(item);
        if (child->kind == SPH2D__NODE_MAPPING)
            sph2d__convert_mapping(c, key->keys, child, item_path, item);
        else
            report_kind(c, key, child, item_path, false);
    }
    store_list(key, items, index, out);
}

/** The index of the key that presets others of its group; the count if there is none. */
static size_t preset_index(const sph2d_keys *keys)
{
    size_t i = 0;
    while (i < key_count(keys) && !keys->items[i].preset)
        ++i;
    return i;
}

/** The key whose word is the short form of a group; NULL if there is none. */
static const sph2d_key *short_form_of(const sph2d_key *group)
{
    const sph2d_keys *inner = group && group->kind == SPH2D_KEY_GROUP ? group->keys : NULL;
    for (size_t i = 0; inner && i < key_count(inner); ++i)
        if (inner->items[i].stands_alone)
            return &inner->items[i];
    return NULL;
}

/** Makes a mapping of a scalar: {word: scalar}. */
static void expand(sph2d__node *child, const char *word, sph2d__faults *faults)
{
    sph2d__node *inner = sph2d__node_new(faults->pool, SPH2D__NODE_SCALAR, child->place);
    faults->short_of_memory |= !inner;
    if (!inner)
        return;
    *inner = *child;
    inner->next = NULL;
    inner->key = word;
    *child = (sph2d__node){.kind = SPH2D__NODE_MAPPING,
                           .key = child->key,
                           .place = child->place,
                           .key_place = child->key_place,
                           .next = child->next};
    sph2d__node_append(child, inner);
}

void sph2d__convert_words(sph2d__node *mapping, const sph2d_keys *keys, sph2d__faults *faults)
{
    for (sph2d__node *child = mapping->kind == SPH2D__NODE_MAPPING ? mapping->first : NULL; child;
         child = child->next) {
        const size_t index = key_index(keys, child->key);
        const sph2d_key *key = index < key_count(keys) ? &keys->items[index] : NULL, *word = short_form_of(key);
        if (!key || !key->keys || key->as_mapping)
            continue;
        if (word && child->kind == SPH2D__NODE_SCALAR && !sph2d__node_is_null(child))
            expand(child, word->name, faults);
        child->also = strcmp(child->key, key->name) == 0 ? key->also : key->name;
        if (key->kind == SPH2D_KEY_GROUP)
            sph2d__convert_words(child, key->keys, faults);
        for (sph2d__node *item = child->kind == SPH2D__NODE_SEQUENCE ? child->first : NULL; item; item = item->next)
            sph2d__convert_words(item, key->keys, faults);
    }
}

static void convert_key(sph2d__converter *c, const sph2d_key *key, const sph2d__node *node, const char *path, void *out)
{
    if (key->choice)
        memcpy((char *)out + key->choice_offset, &key->choice, sizeof key->choice);
    if (key->kind == SPH2D_KEY_LIST)
        convert_list(c, key, node, path, out);
    else if (key->kind != SPH2D_KEY_GROUP)
        sph2d__convert_value(c, key, node, path, out);
    else if (node->kind == SPH2D__NODE_MAPPING)
        sph2d__convert_mapping(c, key->keys, node, path, (char *)out + key->offset);
    else
        report_kind(c, key, node, path, false);
}

static void report_missing(sph2d__converter *c, const level *m)
{
    for (size_t i = 0; i < key_count(m->keys); ++i) {
        const sph2d_key *key = &m->keys->items[i];
        if (!key->required || m->given[i])
            continue;
        char path[SPH2D__PATH_SIZE];
        join(path, m->path, key->name);
        /* the scene as a whole has no line */
        sph2d__place place =
            m->path[0] ? sph2d__node_place(m->node) : (sph2d__place){m->node->place.source, SPH2D__NOWHERE};
        sph2d_diagnostic *d =
            sph2d__fault(c->faults, SPH2D_CODE_MISSING_KEY, place, path, "'%s' must be given", key->name);
        sph2d_diagnostic_hint(d, "%s: %s%s%s", key->name, key->text, key->unit[0] ? ", in " : "", key->unit);
        sph2d__faults_mark_invalid(c->faults, path);
    }
}

void sph2d__convert_mapping(sph2d__converter *converter, const sph2d_keys *keys, const sph2d__node *mapping,
                            const char *path, void *out)
{
    level m = {.keys = keys, .node = mapping, .path = path};
    size_t preset = preset_index(keys); /* first, since the others replace what it sets */
    const char *word = preset < key_count(keys) ? keys->items[preset].name : NULL;
    const sph2d__node *chosen = word ? sph2d__node_find(mapping, word, strlen(word)) : NULL;
    if (chosen) {
        char child_path[SPH2D__PATH_SIZE];
        join(child_path, path, word);
        convert_key(converter, &keys->items[preset], chosen, child_path, out);
        keys->items[preset].preset(out);
        m.given[preset] = chosen;
    }
    for (const sph2d__node *child = mapping->first; child; child = child->next) {
        char child_path[SPH2D__PATH_SIZE];
        size_t index = key_index(keys, child->key);
        join(child_path, path, index < key_count(keys) ? keys->items[index].name : child->key);
        if (index == key_count(keys)) {
            report_unknown(converter, &m, child, child_path);
        } else if (m.given[index] == child) {
            continue;
        } else if (m.given[index]) {
            report_duplicate(converter, child, m.given[index], child_path);
        } else if (!excluded(converter, &m, index, child, child_path)) {
            m.given[index] = child;
            convert_key(converter, &keys->items[index], child, child_path, out);
        }
    }
    report_missing(converter, &m);
}
