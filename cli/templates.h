/* SPDX-License-Identifier: MIT */
/** @file templates.h
 *  The templates of `sph2d init`: path and value of each key that is set. */
#ifndef SPH2D_CLI_TEMPLATES_H
#define SPH2D_CLI_TEMPLATES_H

#include <stddef.h>

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
