/* SPDX-License-Identifier: MIT */
/** @file colors.c
 *  Colours of liquid: names and values of CSS Color Module Level 4 (W3C), section 6.1, and that of water. */
#include "scene/colors.h"

#include <stddef.h>
#include <string.h>

static const struct {
    const char *name;
    uint32_t rgb;
} colors[] = {{"black", 0x000000},     {"gray", 0x808080},    {"grey", 0x808080},    {"silver", 0xc0c0c0},
              {"white", 0xffffff},     {"ivory", 0xfffff0},   {"beige", 0xf5f5dc},   {"tan", 0xd2b48c},
              {"brown", 0xa52a2a},     {"sienna", 0xa0522d},  {"maroon", 0x800000},  {"red", 0xff0000},
              {"crimson", 0xdc143c},   {"tomato", 0xff6347},  {"coral", 0xff7f50},   {"salmon", 0xfa8072},
              {"orange", 0xffa500},    {"gold", 0xffd700},    {"yellow", 0xffff00},  {"olive", 0x808000},
              {"lime", 0x00ff00},      {"green", 0x008000},   {"teal", 0x008080},    {"cyan", 0x00ffff},
              {"turquoise", 0x40e0d0}, {"skyblue", 0x87ceeb}, {"blue", 0x0000ff},    {"royalblue", 0x4169e1},
              {"navy", 0x000080},      {"indigo", 0x4b0082},  {"purple", 0x800080},  {"violet", 0xee82ee},
              {"magenta", 0xff00ff},   {"orchid", 0xda70d6},  {"hotpink", 0xff69b4}, {"pink", 0xffc0cb},
              {"lavender", 0xe6e6fa},  {"water", 0x2b82cf}};

enum { COLORS = sizeof colors / sizeof colors[0] };

const char *sph2d_color_name(size_t index)
{
    return index < COLORS ? colors[index].name : NULL;
}

/** The value of a hexadecimal digit; 16 for any other character. */
static uint32_t digit_of(char c)
{
    static const char digits[] = "0123456789abcdefABCDEF";
    const char *at = c != '\0' ? strchr(digits, c) : NULL;
    const uint32_t value = at ? (uint32_t)(at - digits) : 16;
    return at && value > 15 ? value - 6 : value;
}

bool sph2d_color_parse(const char *text, uint32_t *rgb)
{
    if (!rgb)
        return false;
    for (size_t k = 0; text && k < COLORS; ++k)
        if (strcmp(text, colors[k].name) == 0) {
            *rgb = colors[k].rgb;
            return true;
        }
    if (!text || text[0] != '#' || strlen(text) != 7)
        return false;
    uint32_t value = 0;
    for (int k = 1; k < 7; ++k) {
        if (digit_of(text[k]) > 15)
            return false;
        value = 16 * value + digit_of(text[k]);
    }
    *rgb = value;
    return true;
}

/* ---- colours of a scene ------------------------------------------------------------------------------------------ */

bool sph2d__has_colors(const sph2d_scene *scene)
{
    bool has = scene->fluid.color != NULL;
    for (size_t k = 0; k < scene->block_count; ++k)
        has = has || scene->blocks[k].color;
    for (size_t k = 0; k < scene->source_count; ++k)
        has = has || scene->sources[k].color;
    for (size_t k = 0; k < scene->opening_count; ++k)
        has = has || scene->openings[k].color;
    for (size_t k = 0; k < scene->particles.count; ++k)
        has = has || scene->particles.items[k].color > 0;
    return has;
}

bool sph2d_fluid_color(const sph2d_fluid *fluid, uint32_t *rgb)
{
    size_t count;
    const sph2d_material_data *materials = sph2d_materials(&count);
    if (!fluid || !rgb || (size_t)fluid->material >= count)
        return false;
    return sph2d_color_parse(fluid->color ? fluid->color : materials[fluid->material].color, rgb);
}

uint32_t sph2d__color_of(const sph2d_scene *scene, const char *own)
{
    uint32_t rgb = 0;
    if (!sph2d_color_parse(own, &rgb) && !sph2d_fluid_color(&scene->fluid, &rgb))
        sph2d_color_parse("water", &rgb); /* as looks have it, where others have one */
    return rgb;
}
