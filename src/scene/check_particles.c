/* SPDX-License-Identifier: MIT */
/** @file check_particles.c
 *  Checks of single particles. */
#include <math.h>

#include "scene/checker.h"

/** Checks a particle. */
static void check_particle(sph2d__checker *c, size_t i)
{
    const sph2d_particle *p = &c->scene->particles.items[i];
    char path[SPH2D__PATH_SIZE];
    sph2d__check_path(path, "particles", i, "");
    if (!isfinite(p->x) || !isfinite(p->y) || !isfinite(p->vx) || !isfinite(p->vy) || !isfinite(p->density))
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, "has a number that is missing or not finite");
    else if (!(p->density >= 0) && c->scene->fluid.density > 0)
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, "has a density below 0");
    else if (!sph2d__check_in_domain(c->scene, (sph2d_vec2){p->x, p->y}))
        sph2d__check_outside(c, path, (sph2d_vec2){p->x, p->y});
}

/** Stops at the first error, as a wrong file may have one in every row. */
void sph2d__check_particles(sph2d__checker *c)
{
    const sph2d_particles *p = &c->scene->particles;
    if (!p->file && p->count == 0)
        return;
    const sph2d_method_options *m = &c->scene->method;
    if (!(m->sound_speed > 0) && !(m->stiffness > 0)) {
        sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, "particles",
                                                 "a list of particles does not determine the sound speed");
        sph2d_diagnostic_hint(d, "give method.sound_speed, ten times the largest speed that you expect [m/s]");
    }
    if (!p->items && p->count > 0)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "particles", "a count above 0 with a NULL list");
    for (size_t before = c->errors, i = 0; p->items && i < p->count && c->errors == before; ++i)
        check_particle(c, i);
}
