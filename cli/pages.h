/* SPDX-License-Identifier: MIT */
/** @file pages.h
 *  The keys of a scene as the part of docs/scenes.md and of the manual page sph2d-scene(5) that is not written by hand.
 *  pages.c walks over the keys and tells a form what it meets; the form, Markdown or mdoc (page_forms.c), prints it to
 *  stdout. */
#ifndef SPH2D_CLI_PAGES_H
#define SPH2D_CLI_PAGES_H

#include <stdbool.h>
#include <stddef.h>

enum { PAGE_NAME_SIZE = 80, PAGE_VALUES_SIZE = 320, PAGE_LINE_SIZE = 2000 };

/** A key in words. */
typedef struct page_entry {
    char name[PAGE_NAME_SIZE]; /**< seen from its section: "box.min" */
    const char *type;
    const char *unit;
    char values[PAGE_VALUES_SIZE]; /**< range, or words between `marks` */
    bool one_of;                   /* the values are words */
    bool required;
    const char *fallback; /**< its default; NULL for none */
    bool literal;         /* the default could stand in a file as it is */
    char methods[PAGE_VALUES_SIZE];
    const char *text;
    const char *section; /**< that the key has of its own; NULL for none */
} page_entry;

/** A form that the pages come in. */
typedef struct page_form {
    const char *marks[2]; /**< around a word of a scene file */
    void (*section)(const char *name, const char *title);
    void (*paragraph)(const char *text);
    void (*begin_keys)(void);
    void (*key)(const page_entry *e);
    void (*end_keys)(void);
    void (*begin_table)(const char *intro, const char *const *heads, size_t count);
    void (*row)(const char *const *cells, size_t count);
    void (*end_table)(void);
} page_form;

extern const page_form page_markdown, page_manual;

/* ---- the pages --------------------------------------------------------------------------------------------------- */

/** Every key with type, unit, values, default, methods and meaning, as Markdown, to stdout. */
void pages_print_markdown(void);

/** The same in mdoc, the language of manual pages. */
void pages_print_manual(void);

#endif
