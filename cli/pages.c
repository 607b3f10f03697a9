/* SPDX-License-Identifier: MIT */
/** @file pages.c
 *  The keys of a scene as pages. One walk over the tables of keys, methods and materials; a form writes what it meets,
 *  as Markdown or in mdoc. */
#include "pages.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include <sph2d/sim.h>

#include "keys.h"
#include "text.h"

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

static void describe_values(const page_form *f, const sph2d_key *key, char *out, size_t size)
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

static page_entry describe(const page_form *f, const sph2d_key *key, const char *prefix)
{
    page_entry e = {.type = type_of(key), .unit = key->unit, .required = key->required, .text = key->text};
    snprintf(e.name, sizeof e.name, "%s%s%s", prefix, prefix[0] != '\0' ? "." : "", key->name);
    e.one_of = key->kind == SPH2D_KEY_WORD;
    describe_values(f, key, e.values, sizeof e.values);
    e.fallback = key->default_text;
    e.literal = key->default_text && is_literal(key);
    if (key->feature != SPH2D_FEATURE_NONE) {
        char having[PAGE_VALUES_SIZE] = "";
        keys_append_methods((sph2d_feature)key->feature, having, sizeof having);
        bool but_one = strncmp(having, "not ", 4) == 0;
        snprintf(e.methods, sizeof e.methods, "%s%.200s", but_one ? "all but " : "", having + (but_one ? 4 : 0));
    }
    return e;
}

/* The keys of one struct and of the groups in it; those with sections of their own at the top. */
static void write_keys(const page_form *f, const sph2d_keys *keys, const char *prefix, bool top)
{
    for (size_t i = 0; i < keys->count; ++i) {
        page_entry e = describe(f, &keys->items[i], prefix);
        if (top && is_nested(&keys->items[i]))
            e.section = keys->items[i].name;
        f->key(&e);
        if (is_nested(&keys->items[i]) && !top)
            write_keys(f, keys->items[i].keys, e.name, false);
    }
}

/* "Exactly one of `box`, `circle`, `polygon` must be given." */
static void write_choice(const page_form *f, const sph2d_keys *keys)
{
    char line[PAGE_VALUES_SIZE] = "";
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

static void write_materials(const page_form *f)
{
    static const char *const heads[] = {"material", "density [kg/m^3]", "dynamic_viscosity [Pa s]",
                                        "surface tension against air [N/m]", "source"};
    size_t count;
    const sph2d_material_data *materials = sph2d_materials(&count);
    f->begin_table(
        "Materials, at the pressure of the air and 20 C, unless the source says otherwise; those with a model "
        "for the methods that `model` names. The surface tension of a scene is 0 unless surface_tension is given.",
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

static void write_methods(const page_form *f)
{
    static const char *const heads[] = {
        "method", "for", "scheme", "default support_ratio", "default max_compression", "forms of wall", "source"};
    f->begin_table("Methods, those to take first in front. Keys for which no methods are named above are known to all.",
                   heads, 7);
    const sph2d_method_info *method;
    for (size_t k = 0; (method = sph2d_method_row(k)); ++k) {
        char support[24], compression[24], forms[PAGE_VALUES_SIZE] = "";
        snprintf(support, sizeof support, "%g", method->support_ratio);
        snprintf(compression, sizeof compression, "%g", method->max_compression);
        keys_append_wall_forms(method->wall_forms, forms, sizeof forms);
        const char *cells[] = {method->name, method->use, method->scheme, support, compression, forms, method->source};
        f->row(cells, 7);
    }
    f->end_table();
}

static void write_probes(const page_form *f, const sph2d_key *kinds)
{
    static const char *const heads[] = {"kind", "columns"};
    f->begin_table(
        "What the kinds write, behind the time [s]. A value without meaning, as where there is no liquid, is nan.",
        heads, 2);
    for (int kind = 0; kinds->words[kind]; ++kind) {
        char columns[PAGE_VALUES_SIZE] = "";
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

static void write_section(const page_form *f, const sph2d_key *key)
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

static void write_page(const page_form *f)
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
    write_page(&page_markdown);
}

void pages_print_manual(void)
{
    write_page(&page_manual);
}
