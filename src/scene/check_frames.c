/* SPDX-License-Identifier: MIT */
/** @file check_frames.c
 *  Checks what frames show. */
#include <stdio.h>
#include <string.h>

#include "base/suggest.h"
#include "scene/checker.h"

/** Reports a name to follow that no obstacle or body has. */
static void check_follow(sph2d__checker *c, const char *name)
{
    enum { MOST = 20 };
    const char *names[MOST + 1] = {NULL};
    size_t count = 0;
    for (size_t k = SPH2D__WALL_OBSTACLE; k < c->world->wall_count; ++k) {
        const char *other = c->world->walls[k].name;
        if (other && strcmp(other, name) == 0)
            return;
        if (other && count < MOST)
            names[count++] = other;
    }
    char message[160];
    snprintf(message, sizeof message, "no obstacle or body has the name '%.64s'", name);
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "run.frames.follow", message);
    if (count == 0)
        sph2d_diagnostic_hint(d, "give an obstacle or body a `name`");
    else
        sph2d__suggest_word(d, name, names, "one of");
}

void sph2d__check_frames(sph2d__checker *c)
{
    const sph2d_frames *frames = &c->scene->run.frames;
    const sph2d_box *v = &frames->view;
    if (v->min.x != 0 || v->min.y != 0 || v->max.x != 0 || v->max.y != 0)
        sph2d__check_box(c, *v, "run.frames.view");
    if (frames->follow)
        check_follow(c, frames->follow);
}
