/* SPDX-License-Identifier: MIT */
/** @file tree_text.c
 *  Writes nodes as YAML text, so that a value of one file becomes an override of another. */
#include <stdio.h>
#include <string.h>

#include "files/tree.h"

/** An output buffer; with `out` NULL, bytes are only counted. */
typedef struct output {
    char *out;
    size_t used;
} output;

static void put(output *p, const char *text, size_t length)
{
    if (p->out)
        memcpy(p->out + p->used, text, length);
    p->used += length;
}

static void put_quoted(output *p, const char *text)
{
    put(p, "\"", 1);
    for (; *text; ++text) {
        unsigned char c = (unsigned char)*text;
        char escape[8];
        if (c == '"' || c == '\\')
            put(p, "\\", 1);
        if (c < 0x20 || c == 0x7f)
            put(p, escape, (size_t)snprintf(escape, sizeof escape, "\\x%02X", c));
        else
            put(p, text, 1);
    }
    put(p, "\"", 1);
}

/** Whether an unquoted text has the same meaning inside brackets. */
static bool is_word(const char *text)
{
    return *text && !text[strcspn(text, ",:[]{}#\"'&*!|>%@`?\\")];
}

static void put_node(output *p, const sph2d__node *node, bool inside);

static void put_children(output *p, const sph2d__node *node)
{
    bool mapping = node->kind == SPH2D__NODE_MAPPING;
    put(p, mapping ? "{" : "[", 1);
    for (const sph2d__node *child = node->first; child; child = child->next) {
        if (child != node->first)
            put(p, ", ", 2);
        if (mapping) {
            put_quoted(p, child->key);
            put(p, ": ", 2);
        }
        put_node(p, child, true);
    }
    put(p, mapping ? "}" : "]", 1);
}

static void put_node(output *p, const sph2d__node *node, bool inside)
{
    if (node->kind == SPH2D__NODE_MAPPING || node->kind == SPH2D__NODE_SEQUENCE)
        put_children(p, node);
    else if (node->kind == SPH2D__NODE_FAULTY || sph2d__node_is_null(node))
        put(p, "null", 4);
    else if (node->quoted || (inside && !is_word(node->text)))
        put_quoted(p, node->text);
    else
        put(p, node->text, node->length);
}

const char *sph2d__node_text(const sph2d__node *node, sph2d__pool *pool)
{
    output counted = {NULL, 0};
    put_node(&counted, node, false);
    output written = {sph2d__pool_alloc(pool, counted.used + 1, 1), 0};
    if (written.out)
        put_node(&written, node, false);
    return written.out;
}
