/* SPDX-License-Identifier: MIT */
/** @file page_forms.c
 *  The pages of keys as Markdown, and in mdoc, the language of manual pages. */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "pages.h"
#include "text.h"

/* Starts a sentence with a capital letter, unless with a symbol or a word of scene files. */
static void capitalise(char *text)
{
    size_t length = strcspn(text, " ,;:.");
    for (size_t i = 0; i < length; ++i)
        if ((length == 1 && text[0] != 'a') || !isalpha((unsigned char)text[i]))
            return;
    text[0] = (char)toupper((unsigned char)text[0]);
}

/* ---- Markdown ---------------------------------------------------------------------------------------------------- */

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
    capitalise(sentence);
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

/* ---- mdoc -------------------------------------------------------------------------------------------------------- */

enum { MAN_WIDTH = 78 };

/* Writes a word so that roff prints it as it is: accents, minus signs and backslashes have meanings of their own. */
static void manual_word(const char *word, size_t length)
{
    if (word[0] == '.' || word[0] == '\'')
        fputs("\\&", stdout);
    for (size_t i = 0; i < length; ++i) {
        bool inside = i > 0 && isalnum((unsigned char)word[i - 1]) && isalpha((unsigned char)word[i + 1]);
        if (word[i] == '\\')
            fputs("\\e", stdout);
        else if (word[i] == '^')
            fputs("\\(ha", stdout);
        else if (word[i] == '-' && !inside)
            fputs("\\-", stdout);
        else if (word[i] != '`')
            putchar(word[i]);
    }
}

/* A paragraph in lines; what ends a sentence ends a line, as manual pages have it, and no other full stop does. */
static void manual_text(const char *text)
{
    size_t column = 0;
    bool full_stop = false; /* before the word */
    while (*text != '\0') {
        size_t length = strcspn(text, " ");
        bool sentence_ended = full_stop && isupper((unsigned char)*text);
        if (column > 0 && (sentence_ended || column + 1 + length > MAN_WIDTH - 8)) {
            fputs(full_stop && !sentence_ended ? "\\&\n" : "\n", stdout);
            column = 0;
        }
        if (column > 0)
            putchar(' ');
        manual_word(text, length);
        column += length + (column > 0);
        full_stop = text[length - 1] == '.';
        text += length;
        text += strspn(text, " ");
    }
    putchar('\n');
}

static void manual_sentence(const char *text)
{
    char sentence[PAGE_LINE_SIZE];
    snprintf(sentence, sizeof sentence, "%s.", text);
    capitalise(sentence);
    manual_text(sentence);
}

static void manual_section(const char *name, const char *title)
{
    printf(".Ss %s\n", name);
    manual_sentence(title);
}

static void manual_paragraph(const char *text)
{
    manual_text(text);
}

static void manual_begin(void)
{
    printf(".Bl -tag -width Ds\n");
}

static void manual_key(const page_entry *e)
{
    char line[PAGE_LINE_SIZE];
    printf(".It Cm %s\n", e->name);
    manual_sentence(e->text);
    snprintf(line, sizeof line, "%s", e->type);
    if (e->unit[0] != '\0')
        text_append(line, sizeof line, " in %s", e->unit);
    if (e->values[0] != '\0')
        text_append(line, sizeof line, "%s %s", e->one_of ? ", one of" : ",", e->values);
    if (e->required)
        text_append(line, sizeof line, "; must be given");
    else if (e->fallback)
        text_append(line, sizeof line, "; default %s", e->fallback);
    manual_sentence(line);
    if (e->methods[0] != '\0') {
        snprintf(line, sizeof line, "methods: %s", e->methods);
        manual_sentence(line);
    }
}

static void manual_end(void)
{
    printf(".El\n");
}

static const char *const *manual_heads;

static void manual_begin_table(const char *intro, const char *const *heads, size_t count)
{
    (void)count;
    printf(".Pp\n");
    manual_text(intro);
    manual_heads = heads;
    manual_begin();
}

/* The first cell is the tag, each of the others a sentence with its head. */
static void manual_row(const char *const *cells, size_t count)
{
    printf(".It Cm %s\n", cells[0]);
    for (size_t i = 1; i < count; ++i) {
        char line[PAGE_LINE_SIZE];
        snprintf(line, sizeof line, "%s: %s", manual_heads[i], cells[i]);
        manual_sentence(line);
    }
}

const page_form page_manual = {{"", ""},   manual_section,     manual_paragraph, manual_begin, manual_key,
                               manual_end, manual_begin_table, manual_row,       manual_end};
