/* SPDX-License-Identifier: MIT */
/** @file pages_markdown.c
 *  The pages of keys as Markdown. */
#include <stdio.h>

#include "page_form.h"

/* A vertical bar would end the cell of a table. */
static void markdown_text(const char *text)
{
    for (const char *c = text; *c != '\0'; ++c) {
        if (*c == '|')
            putchar('\\');
        putchar(*c);
    }
}

static void markdown_section(const char *name, const char *title)
{
    char sentence[PAGE_LINE_SIZE];
    snprintf(sentence, sizeof sentence, "%s.", title);
    page_capitalise(sentence);
    printf("\n### %s\n\n", name);
    markdown_text(sentence);
    putchar('\n');
}

static void markdown_paragraph(const char *text)
{
    putchar('\n');
    markdown_text(text);
    putchar('\n');
}

static void markdown_begin_keys(void)
{
    printf("\n| key | type | unit | values | default | meaning |\n|---|---|---|---|---|---|\n");
}

static void markdown_key(const page_entry *e)
{
    if (e->section)
        printf("| [`%s`](#%s) |", e->name, e->section);
    else
        printf("| `%s` |", e->name);
    printf(" %s | %s | ", e->type, e->unit);
    markdown_text(e->values);
    printf(" | ");
    if (e->required)
        printf("must be given");
    else if (e->fallback)
        printf("%s%s%s", e->literal ? "`" : "", e->fallback, e->literal ? "`" : "");
    printf(" | ");
    markdown_text(e->text);
    if (e->methods[0] != '\0')
        printf(" (methods: %s)", e->methods);
    printf(" |\n");
}

static void markdown_end(void)
{
}

static void markdown_row(const char *const *cells, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        printf("| ");
        markdown_text(cells[i]);
        putchar(' ');
    }
    printf("|\n");
}

static void markdown_begin_table(const char *intro, const char *const *heads, size_t count)
{
    markdown_paragraph(intro);
    putchar('\n');
    markdown_row(heads, count);
    for (size_t i = 0; i < count; ++i)
        printf("|---");
    printf("|\n");
}

const page_form page_markdown = {{"`", "`"},           markdown_section, markdown_paragraph,
                                 markdown_begin_keys,  markdown_key,     markdown_end,
                                 markdown_begin_table, markdown_row,     markdown_end};
