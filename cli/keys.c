/* SPDX-License-Identifier: MIT */
/** @file keys.c
 *  Descriptions of the keys of scenes and studies, and templates that set them. */
#include "keys.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "text.h"

static bool is_number(sph2d_key_kind kind)
{
    return kind == SPH2D_KEY_NUMBER || kind == SPH2D_KEY_COUNT || kind == SPH2D_KEY_COUNTS2 ||
           kind == SPH2D_KEY_NUMBERS;
}

void keys_append_range(const sph2d_key *key, char *out, size_t size)
{
    if (!is_number(key->kind))
        return;
    /* The limits of all numbers are told once. */
    bool positive = key->min_excluded || (key->min == SPH2D_SMALLEST && key->max == SPH2D_LARGEST);
    const char *from = positive ? "above" : "at least";
    double least = positive ? 0 : key->min;
    bool below = isfinite(key->min) && key->min > -SPH2D_LARGEST,
         above = isfinite(key->max) && key->max < SPH2D_LARGEST;
    if (below && above && !positive)
        text_append(out, size, "%g to %g", key->min, key->max);
    else if (below && above)
        text_append(out, size, "above %g, at most %g", least, key->max);
    else if (below)
        text_append(out, size, "%s %g", from, least);
    else if (above)
        text_append(out, size, "at most %g", key->max);
}

/* Whether a method has a feature with all its operators. */
static bool all_operators_have(const sph2d_method_info *method, sph2d_feature feature)
{
    const sph2d_method_info *other;
    for (size_t k = 0; (other = sph2d_method_row(k)); ++k)
        if (other->method == method->method && !sph2d_method_has(other, feature))
            return false;
    return true;
}

void keys_append_methods(sph2d_feature feature, char *out, size_t size)
{
    const sph2d_method_info *method, *last = NULL, *lacks = NULL;
    size_t lacking = 0;
    for (size_t k = 0; (method = sph2d_method_row(k)); ++k)
        if (!sph2d_method_has(method, feature)) {
            lacks = method;
            ++lacking;
        }
    if (lacking == 1) {
        text_append(out, size, "not %s", lacks->name);
        return;
    }
    for (size_t k = 0; (method = sph2d_method_row(k)); ++k) {
        bool all = all_operators_have(method, feature);
        if (!sph2d_method_has(method, feature) || (all && last && last->method == method->method))
            continue;
        text_append(out, size, "%s%s", !last ? "" : ", ", all ? method->word : method->name);
        last = method;
    }
}

void keys_append_wall_forms(uint32_t forms, char *out, size_t size)
{
    static const char *const words[] = {"default", "spring", "heavy", "reflect", "generalised"};
    const char *between = "";
    for (unsigned k = 1; k < sizeof words / sizeof *words; ++k)
        if (forms >> k & 1) {
            text_append(out, size, "%s%s", between, words[k]);
            between = ", ";
        }
}

char *keys_law(const sph2d_material_data *material, char *out, size_t size)
{
    static const char *const words[] = {"newtonian", "power_law", "carreau", "herschel_bulkley"};
    const struct {
        const char *key;
        double value;
    } numbers[] = {
        {"yield_stress", material->yield_stress},           {"consistency", material->consistency},
        {"dynamic_viscosity", material->dynamic_viscosity}, {"infinite_viscosity", material->infinite_viscosity},
        {"relaxation_time", material->relaxation_time},     {"index", material->index > 0 ? material->index : 1}};
    out[0] = '\0';
    if (material->model == SPH2D_RHEOLOGY_NEWTONIAN)
        return out;
    text_append(out, size, "%s", words[material->model]);
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; ++k)
        if (numbers[k].value > 0)
            text_append(out, size, ", %s %g", numbers[k].key, numbers[k].value);
    return out;
}

char *keys_describe(const sph2d_key *key, char *out, size_t size)
{
    out[0] = '\0';
    if (key->feature != SPH2D_FEATURE_NONE) {
        keys_append_methods((sph2d_feature)key->feature, out, size);
        text_append(out, size, ": ");
    }
    text_append(out, size, "%s", key->text);
    if (key->unit[0] != '\0')
        text_append(out, size, " [%s]", key->unit);
    char range[64] = "";
    keys_append_range(key, range, sizeof range);
    if (range[0] != '\0')
        text_append(out, size, "; %s", range);
    for (size_t i = 0; key->kind == SPH2D_KEY_WORD && key->words[i]; ++i)
        text_append(out, size, "%s%s", i == 0 ? "; one of " : ", ", key->words[i]);
    if (key->required)
        text_append(out, size, "; must be given");
    else if (key->default_text && key->kind != SPH2D_KEY_LIST && key->kind != SPH2D_KEY_GROUP)
        text_append(out, size, "; default %s", key->default_text);
    return out;
}

/* Prints a key, and those in it. In a list the first of an item is preceded by a dash, as in a file. */
static void print_key(const sph2d_key *key, int depth, const char *dash)
{
    char left[48], description[400];
    bool list = key->kind == SPH2D_KEY_LIST, nested = key->kind == SPH2D_KEY_GROUP || (list && !key->as_mapping);
    snprintf(left, sizeof left, "%*s%s%s%s", 2 * depth, "", dash, key->name, nested ? ":" : "");
    printf("%-28s %s\n", left, keys_describe(key, description, sizeof description));
    for (size_t i = 0; nested && i < key->keys->count; ++i)
        print_key(&key->keys->items[i], depth + 1 + (dash[0] != '\0'), list ? (i == 0 ? "- " : "  ") : "");
}

void keys_print(const sph2d_keys *keys)
{
    for (size_t i = 0; i < keys->count; ++i)
        print_key(&keys->items[i], 0, "");
}

bool keys_print_one(const char *name)
{
    const sph2d_keys *keys = sph2d_scene_keys();
    for (size_t i = 0; i < keys->count; ++i)
        if (strcmp(keys->items[i].name, name) == 0) {
            print_key(&keys->items[i], 0, "");
            return true;
        }
    return false;
}

void keys_print_all(void)
{
    keys_print(sph2d_scene_keys());
}

/* ---- templates: small scenes that run in seconds ----------------------------------------------------------------- */

/* The outputs of all templates. */
#define OUTPUTS                                                                                                        \
    {"run.snapshots.per_second", "60"}, {"run.frames.per_second", "60"}, {"run.frames.size", "[1280, 720]"},           \
    {                                                                                                                  \
        "run.frames.style", "metaballs"                                                                                \
    }

static const template_value dam_break[] = {
    {"domain.min", "[0, 0]"},
    {"domain.max", "[1.6, 0.9]"},
    {"spacing", "0.01"},
    {"gravity", "[0, -9.81]"},
    {"blocks[0].box.min", "[0, 0]"},
    {"blocks[0].box.max", "[0.4, 0.8]"},
    {"run.until", "2"},
    OUTPUTS,
};

static const template_value drop[] = {
    {"domain.min", "[0, 0]"},
    {"domain.max", "[1.6, 0.9]"},
    {"spacing", "0.01"},
    {"gravity", "[0, -9.81]"},
    {"blocks[0].box.min", "[0, 0]"},
    {"blocks[0].box.max", "[1.6, 0.2]"},
    {"blocks[1].circle.center", "[0.8, 0.6]"},
    {"blocks[1].circle.radius", "0.1"},
    {"blocks[1].velocity", "[0, -1]"},
    {"run.until", "1"},
    OUTPUTS,
};

static const template_value sprinkler[] = {
    {"domain.min", "[0, 0]"},
    {"domain.max", "[1.6, 0.9]"},
    {"spacing", "0.01"},
    {"gravity", "[0, -9.81]"},
    {"sources[0].at", "[0.8, 0.8]"},
    {"sources[0].direction", "[0, -1]"},
    {"sources[0].width", "0.1"},
    {"sources[0].speed", "1"},
    {"sources[0].spread", "0.1"},
    {"sources[0].stop", "2"},
    {"drains[0].box.min", "[0, 0]"},
    {"drains[0].box.max", "[0.1, 0.02]"},
    {"obstacles[0].circle.center", "[0.8, 0.45]"},
    {"obstacles[0].circle.radius", "0.1"},
    {"run.until", "3"},
    OUTPUTS,
};

static const template_value stir[] = {
    {"domain.min", "[0, 0]"},
    {"domain.max", "[1.6, 0.9]"},
    {"spacing", "0.01"},
    {"gravity", "[0, -9.81]"},
    {"blocks[0].box.min", "[0, 0]"},
    {"blocks[0].box.max", "[1.6, 0.4]"},
    {"interactions[0].path", "[[0.2, 0.3, 0.3], [1, 1.3, 0.5], [1.8, 0.3, 0.3]]"},
    {"interactions[0].radius", "0.25"},
    {"interactions[0].acceleration", "40"},
    {"probes[0].name", "energy"},
    {"probes[0].kind", "energy"},
    {"probes[0].per_second", "100"},
    {"run.until", "2"},
    OUTPUTS,
};

#define TEMPLATE(name, text)                                                                                           \
    {                                                                                                                  \
#name, text, name, sizeof name / sizeof *name                                                                  \
    }

const scene_template scene_templates[] = {
    TEMPLATE(dam_break, "a column of liquid falls, hits the far wall and comes back"),
    TEMPLATE(drop, "a drop falls into a basin"),
    TEMPLATE(sprinkler, "a source over a round obstacle, with a drain"),
    TEMPLATE(stir, "a moving point pulls liquid through a basin, with a probe"),
};
const size_t scene_template_count = sizeof scene_templates / sizeof *scene_templates;
