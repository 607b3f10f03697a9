/* SPDX-License-Identifier: MIT */
/** @file keys.h
 *  The keys of scenes and studies in words, for `sph2d help` and the comments of `sph2d init`; and the templates of `init`:
 *  path and value of each key that is set. */
#ifndef SPH2D_CLI_KEYS_H
#define SPH2D_CLI_KEYS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <sph2d/key.h>
#include <sph2d/method.h>

/** "between particles [m]; above 0; must be given". Returns `out`. */
char *keys_describe(const sph2d_key *key, char *out, size_t size);

/** Appends the methods that have a feature, "wcsph, muller". */
void keys_append_methods(sph2d_feature feature, char *out, size_t size);

/** Appends the range of a number, "0 to 1" or "above 0"; nothing for other kinds. */
void keys_append_range(const sph2d_key *key, char *out, size_t size);

/** Appends the forms of wall that a method has, "heavy, reflect", from their bits. */
void keys_append_wall_forms(uint32_t forms, char *out, size_t size);

/** The law of a material that is not newtonian, "carreau, dynamic_viscosity 0.056, ..."; of others nothing. Returns
 *  `out`. */
char *keys_law(const sph2d_material_data *material, char *out, size_t size);

/** Prints every key of a scene, indented as in a file, to stdout. */
void keys_print_all(void);

/** Prints one of those at the top, with the keys in it. False if there is none of that name. */
bool keys_print_one(const char *name);

/** The same for any table of keys. */
void keys_print(const sph2d_keys *keys);

/* ---- templates --------------------------------------------------------------------------------------------------- */

typedef struct template_value {
    const char *path, *value; /* "blocks[0].box.min", "[0, 0]" */
} template_value;

typedef struct scene_template {
    const char *name, *text;
    const template_value *values;
    size_t count;
} scene_template;

/** All templates, the default first. */
extern const scene_template scene_templates[];
extern const size_t scene_template_count;

/** The commented scene of a template under a name; the caller frees it, and gets its length. NULL when memory is short. */
char *scene_template_text(const scene_template *from, const char *name, size_t *length);

#endif
