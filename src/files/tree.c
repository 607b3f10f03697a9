/* SPDX-License-Identifier: MIT */
/** @file tree.c
 *  Nodes of a scene file: creation, search, description. */
#include "files/tree.h"

#include <stdio.h>
#include <string.h>

sph2d__node *sph2d__node_new(sph2d__pool *pool, sph2d__node_kind kind, sph2d__place place)
{
    sph2d__node *node = sph2d__pool_alloc(pool, 1, sizeof *node);
    if (node) {
        node->kind = kind;
        node->text = "";
        node->place = place;
        node->key_place = place;
    }
    return node;
}

void sph2d__node_append(sph2d__node *parent, sph2d__node *child)
{
    if (parent->last)
        parent->last->next = child;
    else
        parent->first = child;
    parent->last = child;
    ++parent->count;
}

static bool is_word(const char *word, const char *key, size_t length)
{
    return strlen(word) == length && memcmp(word, key, length) == 0;
}

sph2d__node *sph2d__node_find(const sph2d__node *mapping, const char *key, size_t length)
{
    if (mapping->kind != SPH2D__NODE_MAPPING)
        return NULL;
    for (sph2d__node *child = mapping->first; child; child = child->next)
        if (is_word(child->key, key, length) || (child->also && is_word(child->also, key, length)))
            return child;
    return NULL;
}

static sph2d__node *child_at(const sph2d__node *node, size_t index)
{
    sph2d__node *child = index < node->count ? node->first : NULL;
    while (child && index-- > 0)
        child = child->next;
    return child;
}

sph2d__node *sph2d__node_item(const sph2d__node *sequence, size_t index)
{
    return sequence->kind == SPH2D__NODE_SEQUENCE ? child_at(sequence, index) : NULL;
}

bool sph2d__node_is_null(const sph2d__node *node)
{
    static const char *const nothing[] = {"", "~", "null", "Null", "NULL"};
    if (node->kind != SPH2D__NODE_SCALAR || node->quoted)
        return false;
    for (size_t i = 0; i < sizeof nothing / sizeof nothing[0]; ++i)
        if (strcmp(node->text, nothing[i]) == 0)
            return true;
    return false;
}

sph2d__place sph2d__node_place(const sph2d__node *node)
{
    bool block = (node->kind == SPH2D__NODE_MAPPING || node->kind == SPH2D__NODE_SEQUENCE) && !node->flow;
    return node->key && (block || sph2d__node_is_null(node)) ? node->key_place : node->place;
}

/** The number of leading bytes of a text, at most `limit`, on its first line, without a partial UTF-8 character. */
static size_t truncate_text(const char *text, size_t limit)
{
    size_t line = strcspn(text, "\n\r");
    if (line <= limit)
        return line;
    while (limit > 0 && ((unsigned char)text[limit] & 0xc0) == 0x80)
        --limit;
    return limit;
}

const char *sph2d__node_describe(const sph2d__node *node, char *out, size_t size)
{
    enum { MAX_BYTES = 40 };
    if (node->kind == SPH2D__NODE_MAPPING) {
        snprintf(out, size, "a mapping");
    } else if (node->kind == SPH2D__NODE_SEQUENCE) {
        snprintf(out, size, "a list of %zu", node->count);
    } else if (sph2d__node_is_null(node)) {
        snprintf(out, size, "nothing");
    } else {
        size_t length = truncate_text(node->text, MAX_BYTES);
        snprintf(out, size, "%s'%.*s'%s", node->quoted ? "the text " : "", (int)length, node->text,
                 node->length > length ? "..." : "");
    }
    return out;
}

/** Reads `[12]`. */
static bool index_step(const char **path, sph2d__step *step)
{
    const char *p = *path + 1;
    size_t index = 0;
    if (*p < '0' || *p > '9')
        return false;
    for (; *p >= '0' && *p <= '9'; ++p) {
        if (index > (SIZE_MAX - 9) / 10)
            return false;
        index = 10 * index + (size_t)(*p - '0');
    }
    if (*p != ']')
        return false;
    *step = (sph2d__step){.index = index};
    *path = p + 1;
    return true;
}

bool sph2d__path_step(const char **path, sph2d__step *step)
{
    const char *p = *path;
    if (*p == '[')
        return index_step(path, step);
    p += *p == '.';
    size_t length = strcspn(p, ".[]");
    if (length == 0 || p[length] == ']')
        return false;
    *step = (sph2d__step){.name = p, .length = length};
    *path = p + length;
    return true;
}

sph2d__node *sph2d__node_step(const sph2d__node *node, const sph2d__step *step)
{
    return step->name ? sph2d__node_find(node, step->name, step->length) : sph2d__node_item(node, step->index);
}

const sph2d__node *sph2d__node_at(const sph2d__node *root, const char *path)
{
    const sph2d__node *node = root;
    sph2d__step step;
    while (*path && sph2d__path_step(&path, &step)) {
        const sph2d__node *child = sph2d__node_step(node, &step);
        if (!child && !step.name && node != root)
            child = child_at(node, step.index);
        if (!child)
            break;
        node = child;
    }
    return node;
}

void sph2d__node_locate(const sph2d__node *root, sph2d_diagnostic *diagnostic)
{
    const sph2d__node *node = sph2d__node_at(root, diagnostic->path);
    sph2d__place file = {root->place.source, SPH2D__NOWHERE};
    sph2d__place_describe(node == root ? file : sph2d__node_place(node), diagnostic);
}
