/* SPDX-License-Identifier: MIT */
/** @file tree.h
 *  A scene file as a tree of mappings, sequences and scalars with their places in the text. Only yaml.c uses the YAML
 *  library; all other files work on this tree. */
#ifndef SPH2D_FILES_TREE_H
#define SPH2D_FILES_TREE_H

#include "files/text.h"

typedef enum sph2d__node_kind {
    SPH2D__NODE_SCALAR,
    SPH2D__NODE_MAPPING,
    SPH2D__NODE_SEQUENCE,
    SPH2D__NODE_FAULTY /**< invalid, and already reported */
} sph2d__node_kind;

typedef struct sph2d__node {
    sph2d__node_kind kind;
    bool quoted;            /**< a scalar in quotes or a text block: never a number or null */
    bool flow;              /**< a mapping or sequence in brackets */
    const char *text;       /**< of a scalar; NUL-terminated */
    size_t length;          /**< of that text */
    const char *key;        /**< in its mapping; NULL in a sequence and for the root */
    const char *also;       /**< another word for it (sph2d_key); NULL for none */
    sph2d__place place;     /**< where it starts */
    sph2d__place key_place; /**< where its key starts */
    size_t count;           /**< children of a mapping or sequence */
    struct sph2d__node *first, *last, *next;
} sph2d__node;

/** Maximum nesting depth; functions that walk a tree recurse. */
enum { SPH2D__TREE_DEPTH = 32 };

/** A node of a kind at a place; NULL when memory is short. */
sph2d__node *sph2d__node_new(sph2d__pool *pool, sph2d__node_kind kind, sph2d__place place);
/** Makes `child` the last child of `parent`. */
void sph2d__node_append(sph2d__node *parent, sph2d__node *child);

/** The first child of a mapping with the key `key` (of `length` bytes); NULL when there is none. */
sph2d__node *sph2d__node_find(const sph2d__node *mapping, const char *key, size_t length);
/** Child `index` of a sequence; NULL when there is none. */
sph2d__node *sph2d__node_item(const sph2d__node *sequence, size_t index);

/** Whether it is a null scalar: empty, `~` or `null`. */
bool sph2d__node_is_null(const sph2d__node *node);

/** The place for a message about a node: its value, or its key if the value starts on a later line. */
sph2d__place sph2d__node_place(const sph2d__node *node);

/** Describes a node for "expected ..., got ...". Writes to `out` and returns it. */
const char *sph2d__node_describe(const sph2d__node *node, char *out, size_t size);

/** One step of a key path. */
typedef struct sph2d__step {
    const char *name; /**< NULL: an index */
    size_t length;    /**< of the name */
    size_t index;
} sph2d__step;

/** Parses the next step of `*path`, such as `blocks`, `[0]`, `.box`. False at its end, and where the path is malformed,
 *  which leaves *path at the error. */
bool sph2d__path_step(const char **path, sph2d__step *step);

/** The child that a step leads to; NULL when there is none. */
sph2d__node *sph2d__node_step(const sph2d__node *node, const sph2d__step *step);

/** The node at a path, or the last existing one along it. Below the root an index counts a
 *  mapping's children too. */
const sph2d__node *sph2d__node_at(const sph2d__node *root, const char *path);

/** Adds the place of its key path to a diagnostic; the root has no line. */
void sph2d__node_locate(const sph2d__node *root, sph2d_diagnostic *diagnostic);

/** A node as YAML text on one line that reads back as the same value; NULL when memory is short (tree_text.c). */
const char *sph2d__node_text(const sph2d__node *node, sph2d__pool *pool);

#endif
