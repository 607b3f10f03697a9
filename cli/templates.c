/* SPDX-License-Identifier: MIT */
/** @file templates.c
 *  The templates of `sph2d init`: small scenes that run in seconds. */
#include "templates.h"

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
