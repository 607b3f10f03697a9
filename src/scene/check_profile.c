/* SPDX-License-Identifier: MIT */
/** @file check_profile.c
 *  Checks the velocity of an opening over place and time. */
#include <math.h>
#include <stdio.h>

#include "scene/checker.h"
#include "scene/openings.h"

/** The first point that does not go on as the points before it: the same increasing places at each of increasing times;
 *  the count if all do. */
static size_t first_wrong(const sph2d_path *p)
{
    size_t places = sph2d__profile_places(p);
    for (size_t k = 1; k < p->count; ++k) {
        const sph2d_path_point *before = &p->items[k - 1], *here = &p->items[k];
        bool row = k % places > 0;
        bool goes_on = row ? here->t == before->t && here->x > before->x : here->t > before->t;
        bool same = k < places || here->x == p->items[k % places].x;
        if (!goes_on || !same)
            return k;
    }
    return p->count % places > 0 ? p->count - 1 : p->count;
}

void sph2d__check_profile(sph2d__checker *c, size_t i)
{
    const sph2d_opening *o = &c->scene->openings[i];
    const sph2d_path *p = &o->history.profile;
    char path[SPH2D__PATH_SIZE], message[200];
    sph2d__check_path(path, "openings", i, ".history.profile");
    size_t wrong = first_wrong(p), places = sph2d__profile_places(p);
    if (wrong < p->count) {
        const sph2d_path_point *at = &p->items[wrong];
        snprintf(message, sizeof message, "point %zu, [%g, %g, %g], does not go on as those before it", wrong, at->t,
                 at->x, at->y);
        sph2d_diagnostic_hint(sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, message),
                              "give the same places, increasing, at each of increasing times: %zu at a time here",
                              places);
        return;
    }
    if (o->profile != SPH2D_OPENING_PROFILE_UNIFORM)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, sph2d__check_path(path, "openings", i, ".profile"),
                           "is that of history.profile: leave out one of the two");
    sph2d__mouth m = sph2d__opening_mouth(c->scene, o);
    double low = m.along.y > 0 ? m.start.y : m.start.x, high = low + m.width, slack = 1e-6 * c->scene->spacing;
    double first = p->items[0].x, last = p->items[places - 1].x;
    if (first <= low + slack && last >= high - slack)
        return;
    snprintf(message, sizeof message, "has places from %g to %g, but the opening reaches from %g to %g", first, last,
             low, high);
    sph2d_diagnostic_hint(sph2d__check_fault(c, SPH2D_CODE_OUTSIDE, path, message),
                          "add points at its ends: at a wall without slip the velocity is 0");
}
