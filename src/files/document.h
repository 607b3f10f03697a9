/* SPDX-License-Identifier: MIT */
/** @file document.h
 *  What scene files and study files share: their text as a tree, and the overrides of single keys of it. */
#ifndef SPH2D_FILES_DOCUMENT_H
#define SPH2D_FILES_DOCUMENT_H

#include "files/tree.h"
#include "sph2d/io.h"

/** A file of keys, and the memory of all that is read from it. Start it with {0}. */
typedef struct sph2d__document {
    sph2d__pool pool;
    sph2d__source source;
    sph2d__node *root; /**< a mapping */
} sph2d__document;

/** What kind of file it is, and who makes structs of the tree. */
typedef struct sph2d__document_kind {
    const char *name; /**< "scene" */
    const char *hint; /**< what such a file looks like */
    sph2d_status (*read)(void *owner, sph2d__faults *faults);
} sph2d__document_kind;

/** Copies the text, makes a tree of it and lets the kind read that into `owner`, in the C locale. Faults are reported
 *  in the order of the file. Errors: SPH2D_SCENE, SPH2D_NOMEM, and what `read` returns. */
sph2d_status sph2d__document_parse(sph2d__document *document, const sph2d__document_kind *kind, const char *text,
                                   size_t length, const char *name, void *owner, sph2d_report *report);

/** Reads the text of a file of keys. The caller frees *text. Errors: as sph2d__text_read(). */
sph2d_status sph2d__document_text(const char *path, char **text, size_t *length, sph2d_report *report);
/** The same of a file that is open. */
sph2d_status sph2d__document_text_open(int descriptor, const char *name, char **text, size_t *length,
                                       sph2d_report *report);

/** Passes on what a checker found, with places in the tree: errors but for those that `is_consequence` (NULL: none) of
 *  faults that were reported before, and warnings when there is no error at all. */
void sph2d__document_pass(const sph2d__document *document, const sph2d_report *found, sph2d__faults *faults,
                          bool (*is_consequence)(const sph2d_diagnostic *diagnostic, const sph2d__faults *faults));

/* ---- overrides of single keys ------------------------------------------------------------------------------------ */

/** Whether a list of overrides has all its pointers. */
bool sph2d__overrides_given(const sph2d_override *overrides, size_t count);

/** Parses the value of each override and puts it into the tree under `root`, replacing any old value. Missing mappings
 *  of its path are created, missing list items are errors, which are counted in `faults`. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__overrides_apply(const sph2d_override *overrides, size_t count, sph2d__node *root,
                                    sph2d__faults *faults);

/* ---- the text (yaml.c) ------------------------------------------------------------------------------------------- */

/** Parses one document. Anchors, aliases, tags and keys that are not words are errors. Returns SPH2D_OK (also with
 *  errors that leave the rest of the tree valid; `faults` counts them), SPH2D_SCENE if the text is not well-formed, or
 *  SPH2D_NOMEM. *root is NULL for an empty text. */
sph2d_status sph2d__yaml_parse(const sph2d__source *source, sph2d__faults *faults, sph2d__node **root);

#endif
