/* SPDX-License-Identifier: MIT */
/** @file pages.c
 *  The keys of a scene as pages. One walk over the tables of keys, methods and materials; a form writes what it meets,
 *  as Markdown or in mdoc. */
#include "pages.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include <sph2d/sim.h>

#include "keys.h"
#include "parse.h"
#include "text.h"

enum { NAME_SIZE = 80, VALUES_SIZE = 320, LINE_SIZE = 2000, MAN_WIDTH = 78 };

/* A key in words. */
typedef struct entry {
    char name[NAME_SIZE]; /* seen from its section: "box.min" */
    const char *type;
    const char *unit;
    char values[VALUES_SIZE]; /* range, or words between `marks` */
    bool one_of;              /* the values are words */
    bool required;
    const char *fallback; /* its default; NULL for none */
    bool literal;         /* the default could stand in a file as it is */
    char methods[VALUES_SIZE];
    const char *text;
    const char *section; /* that the key has of its own; NULL for none */
} entry;

/* A form that the page comes in. */
typedef struct form {
    const char *marks[2]; /* around a word of a scene file */
    void (*section)(const char *name, const char *title);
    void (*paragraph)(const char *text);
    void (*begin_keys)(void);
    void (*key)(const entry *e);
    void (*end_keys)(void);
    void (*begin_table)(const char *intro, const char *const *heads, size_t count);
    void (*row)(const char *const *cells, size_t count);
    void (*end_table)(void);
} form;

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
    char sentence[LINE_SIZE];
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

static void markdown_key(const entry *e)
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

static const form markdown = {{"`", "`"},   markdown_section,     markdown_paragraph, markdown_begin_keys, markdown_key,
                              markdown_end, markdown_begin_table, markdown_row,       markdown_end};

/* ---- mdoc -------------------------------------------------------------------------------------------------------- */

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
    char sentence[LINE_SIZE];
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

static void manual_key(const entry *e)
{
    char line[LINE_SIZE];
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
        char line[LINE_SIZE];
        snprintf(line, sizeof line, "%s: %s", manual_heads[i], cells[i]);
        manual_sentence(line);
    }
}

static const form manual = {{"", ""},   manual_section,     manual_paragraph, manual_begin, manual_key,
                            manual_end, manual_begin_table, manual_row,       manual_end};

/* ---- keys -------------------------------------------------------------------------------------------------------- */

static const char *type_of(const sph2d_key *key)
{
    switch (key->kind) {
    case SPH2D_KEY_NUMBER:
        return "number";
    case SPH2D_KEY_COUNT:
        return "whole number";
    case SPH2D_KEY_COUNTS2:
        return "two whole numbers";
    case SPH2D_KEY_TEXT:
        return "text";
    case SPH2D_KEY_WORD:
        return "word";
    case SPH2D_KEY_POINT:
        return "[x, y]";
    case SPH2D_KEY_POINTS:
        return "[[x, y], ...]";
    case SPH2D_KEY_PATH:
        return "[[t, x, y], ...]";
    case SPH2D_KEY_POSES:
        return "[[t, x, y, angle], ...]";
    case SPH2D_KEY_NUMBERS:
        return "list of numbers";
    case SPH2D_KEY_GROUP:
        return "group";
    case SPH2D_KEY_LIST:
        return "list";
    }
    return "";
}

static bool is_nested(const sph2d_key *key)
{
    return key->kind == SPH2D_KEY_GROUP || key->kind == SPH2D_KEY_LIST;
}

static void describe_values(const form *f, const sph2d_key *key, char *out, size_t size)
{
    out[0] = '\0';
    if (key->kind == SPH2D_KEY_WORD) {
        for (size_t i = 0; key->words[i]; ++i)
            text_append(out, size, "%s%s%s%s", i > 0 ? ", " : "", f->marks[0], key->words[i], f->marks[1]);
        return;
    }
    keys_append_range(key, out, size);
    if (out[0] != '\0' && key->zero_is_unset)
        text_append(out, size, "; 0: the default");
}

/* Whether a default could stand in a file as it is; some are words about it. */
static bool is_literal(const sph2d_key *key)
{
    double number;
    for (size_t i = 0; key->kind == SPH2D_KEY_WORD && key->words[i]; ++i)
        if (strcmp(key->words[i], key->default_text) == 0)
            return true;
    return key->default_text[0] == '[' || parse_number(key->default_text, &number);
}

static entry describe(const form *f, const sph2d_key *key, const char *prefix)
{
    entry e = {.type = type_of(key), .unit = key->unit, .required = key->required, .text = key->text};
    snprintf(e.name, sizeof e.name, "%s%s%s", prefix, prefix[0] != '\0' ? "." : "", key->name);
    e.one_of = key->kind == SPH2D_KEY_WORD;
    describe_values(f, key, e.values, sizeof e.values);
    e.fallback = key->default_text;
    e.literal = key->default_text && is_literal(key);
    if (key->feature != SPH2D_FEATURE_NONE) {
        char having[VALUES_SIZE] = "";
        keys_append_methods((sph2d_feature)key->feature, having, sizeof having);
        bool but_one = strncmp(having, "not ", 4) == 0;
        snprintf(e.methods, sizeof e.methods, "%s%.200s", but_one ? "all but " : "", having + (but_one ? 4 : 0));
    }
    return e;
}

/* The keys of one struct and of the groups in it; those with sections of their own at the top. */
static void write_keys(const form *f, const sph2d_keys *keys, const char *prefix, bool top)
{
    for (size_t i = 0; i < keys->count; ++i) {
        entry e = describe(f, &keys->items[i], prefix);
        if (top && is_nested(&keys->items[i]))
            e.section = keys->items[i].name;
        f->key(&e);
        if (is_nested(&keys->items[i]) && !top)
            write_keys(f, keys->items[i].keys, e.name, false);
    }
}

/* "Exactly one of `box`, `disc`, `polygon` must be given." */
static void write_choice(const form *f, const sph2d_keys *keys)
{
    char line[VALUES_SIZE] = "";
    for (size_t i = 0; i < keys->count; ++i)
        if (keys->items[i].choice != 0)
            text_append(line, sizeof line, "%s%s%s%s",
                        line[0] != '\0' ? ", " : "Exactly one of these must be given: ", f->marks[0],
                        keys->items[i].name, f->marks[1]);
    if (line[0] == '\0')
        return;
    text_append(line, sizeof line, ".");
    f->paragraph(line);
}

/* ---- tables beside the keys -------------------------------------------------------------------------------------- */

static void write_materials(const form *f)
{
    static const char *const heads[] = {"material", "density [kg/m^3]", "dynamic_viscosity [Pa s]",
                                        "surface tension against air [N/m]", "source"};
    size_t count;
    const sph2d_material_data *materials = sph2d_materials(&count);
    f->begin_table(
        "Materials, at the pressure of the air and 20 C, unless the source says otherwise; those with a model "
        "for wcsph. The surface tension of a scene is 0 unless surface_tension is given.",
        heads, 5);
    for (size_t i = 1; i < count; ++i) {
        char density[24], viscosity[200], tension[24] = "not known";
        snprintf(density, sizeof density, "%g", materials[i].density);
        if (keys_law(&materials[i], viscosity, sizeof viscosity)[0] == '\0')
            snprintf(viscosity, sizeof viscosity, "%g", materials[i].dynamic_viscosity);
        if (materials[i].surface_tension > 0)
            snprintf(tension, sizeof tension, "%g", materials[i].surface_tension);
        const char *cells[] = {materials[i].name, density, viscosity, tension, materials[i].source};
        f->row(cells, 5);
    }
    f->end_table();
}

static void write_methods(const form *f)
{
    static const char *const heads[] = {
        "method", "for", "scheme", "default support_ratio", "default max_compression", "forms of wall", "source"};
    f->begin_table("Methods, those to take first in front. Keys for which no methods are named above are known to all.",
                   heads, 7);
    const sph2d_method_info *method;
    for (size_t k = 0; (method = sph2d_method_row(k)); ++k) {
        char support[24], compression[24], forms[VALUES_SIZE] = "";
        snprintf(support, sizeof support, "%g", method->support_ratio);
        snprintf(compression, sizeof compression, "%g", method->max_compression);
        keys_append_wall_forms(method->wall_forms, forms, sizeof forms);
        const char *cells[] = {method->name, method->use, method->scheme, support, compression, forms, method->source};
        f->row(cells, 7);
    }
    f->end_table();
}

static void write_probes(const form *f, const sph2d_key *kinds)
{
    static const char *const heads[] = {"kind", "columns"};
    f->begin_table(
        "What the kinds write, behind the time [s]. A value without meaning, as where there is no liquid, is nan.",
        heads, 2);
    for (int kind = 0; kinds->words[kind]; ++kind) {
        char columns[VALUES_SIZE] = "";
        for (const char *c = sph2d_probe_columns((sph2d_probe_kind)kind); *c != '\0'; ++c)
            text_append(columns, sizeof columns, *c == ',' ? ", " : "%c", *c);
        const char *cells[] = {kinds->words[kind], columns};
        f->row(cells, 2);
    }
    f->end_table();
    f->paragraph(
        "Forces are those of the liquid; contact is particles that a wall or its spring stops, not bodies that "
        "touch it. Work is what a wall does on the liquid and, by contact, on bodies; power is that on the "
        "liquid alone, by pressure and friction.");
}

static const sph2d_key *find_key(const sph2d_keys *keys, const char *name)
{
    for (size_t i = 0; i < keys->count; ++i)
        if (strcmp(keys->items[i].name, name) == 0)
            return &keys->items[i];
    return NULL;
}

/* ---- the page ---------------------------------------------------------------------------------------------------- */

static void write_section(const form *f, const sph2d_key *key)
{
    f->section(key->name, key->text);
    if (key->kind == SPH2D_KEY_LIST)
        f->paragraph("A list; each item is a group of these keys.");
    write_choice(f, key->keys);
    f->begin_keys();
    write_keys(f, key->keys, "", false);
    f->end_keys();
    if (strcmp(key->name, "fluid") == 0)
        write_materials(f);
    else if (strcmp(key->name, "method") == 0)
        write_methods(f);
    else if (strcmp(key->name, "probes") == 0)
        write_probes(f, find_key(key->keys, "kind"));
}

static void write_page(const form *f)
{
    const sph2d_keys *scene = sph2d_scene_keys();
    f->section("The whole scene", "keys at the top of the file; groups and lists have sections of their own");
    f->begin_keys();
    write_keys(f, scene, "", true);
    f->end_keys();
    for (size_t i = 0; i < scene->count; ++i)
        if (is_nested(&scene->items[i]))
            write_section(f, &scene->items[i]);
}

void pages_print_markdown(void)
{
    write_page(&markdown);
}

void pages_print_manual(void)
{
    write_page(&manual);
}
