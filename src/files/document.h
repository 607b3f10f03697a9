/* SPDX-License-Identifier: MIT */
/** @file document.h
 *  What scene files and study files share: a text of keys that becomes a tree, and faults that find their places. */
#ifndef SPH2D_FILES_DOCUMENT_H
#define SPH2D_FILES_DOCUMENT_H

#include "files/tree.h"

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

#endif
