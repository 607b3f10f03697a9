/* SPDX-License-Identifier: MIT */
/** @file wcsph_friction.c
 *  Forces on the liquid that stand still over a step, or are linear in its velocity, and its viscosity: friction of walls,
 *  surface tension, rheology.
 *
 *  Liquid sticks to walls without slip as if the walls went on with its own velocity, so that it is theirs at the surface
 *  (terms/stick.h): the viscous forces of wcsph.h with w times 1 + d_b/d_i, in all -K_i v_i + k_i. An acoustic step
 *  takes K_i of the velocity at its end, so that it is stable however near the liquid is. */
#include <string.h>

#include "methods/terms/friction.h"
#include "methods/terms/rheology.h"
#include "methods/terms/stick.h"
#include "methods/terms/tension.h"
#include "methods/wcsph/wcsph.h"
#include "methods/wcsph/wcsph_stick.h"

sph2d__frozen_stick sph2d__frozen_stick_of(const sph2d__system *s, size_t i, size_t b, double gx, double gy, double x,
                                           double y)
{
    return stick_of(s, i, b, gx, gy, x, y);
}

static void clear_some(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i)
        s->fluid.ax[i] = s->fluid.ay[i] = 0;
}

static void take_rubbed(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t i = first; i < last; ++i) {
        z->rub_x[i] = s->fluid.ax[i];
        z->rub_y[i] = s->fluid.ay[i];
    }
    clear_some(s, first, last);
}

static void take_pulled(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    for (size_t i = first; i < last; ++i) {
        z->pull_x[i] = s->fluid.ax[i];
        z->pull_y[i] = s->fluid.ay[i];
    }
}

/** Slopes of velocity: of vx along x and y, then of vy. */
typedef struct slopes {
    double xx, xy, yx, yy;
} slopes;

static slopes slopes_of(const sph2d__frozen *z, size_t i)
{
    const float *l = z->slope + 4 * i;
    const double shear = (double)l[1], turn = (double)z->bend[4 * i + 2];
    return (slopes){(double)l[0], shear + turn, shear - turn, (double)l[2]};
}

/** The same by the liquid and the walls that it sticks to, which have the velocities of stick.h: L M of the liquid alone, and
 *  what walls add to it, times the inverse of M with theirs. */
static slopes slopes_at_walls(const sph2d__system *s, size_t i)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__store *w = &s->walls, *f = &s->fluid;
    const sph2d__frozen *z = s->frozen;
    const slopes alone = slopes_of(z, i);
    const double det = z->axx[i] * z->ayy[i] - z->axy[i] * z->axy[i];
    double xx = z->ayy[i] / det, xy = -z->axy[i] / det, yy = z->axx[i] / det; /* M */
    slopes sum = {alone.xx * xx + alone.xy * xy, alone.xx * xy + alone.xy * yy, alone.yx * xx + alone.yy * xy,
                  alone.yx * xy + alone.yy * yy};
    const sph2d__slice *at = &n->slices[i / n->lanes];
    size_t k = at->begin + (size_t)at->fluid * n->stride + i % n->lanes;
    bool sticks = false;
    for (uint32_t slot = 0; slot < at->walls; ++slot, k += n->stride) {
        const size_t b = n->index[k];
        const double gx = (double)z->gx[k], gy = (double)z->gy[k], x = (double)z->rx[k], y = (double)z->ry[k];
        const double stick = b < w->count && (gx != 0 || gy != 0) ? sph2d__stick(s, b, x, y) : 0;
        if (!(stick > 0))
            continue;
        sticks = true;
        const sph2d_vec2 jump = sph2d__stick_jump(s, b, stick, x, y, f->vx[i] - w->vx[b], f->vy[i] - w->vy[b]);
        xx -= x * gx; /* G points to b, which is at -(x, y) */
        xy -= (x * gy + y * gx) / 2;
        yy -= y * gy;
        sum = (slopes){sum.xx - jump.x * gx, sum.xy - jump.x * gy, sum.yx - jump.y * gx, sum.yy - jump.y * gy};
    }
    if (!sticks) /* lists are as long as those of other particles in the slice, which depends on the lanes */
        return alone;
    const double all = xx * yy - xy * xy;
    return (slopes){(sum.xx * yy - sum.xy * xy) / all, (sum.xy * xx - sum.xx * xy) / all,
                    (sum.yx * yy - sum.yy * xy) / all, (sum.yy * xx - sum.yx * xy) / all};
}

/** Strains by the slopes of velocity. */
static void strain_some(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__neighbours *n = &s->neighbours;
    const bool sticks = s->walls_rough && s->walls_press;
    for (size_t i = first; i < last; ++i) {
        const bool walled = sticks && n->slices[i / n->lanes].walls > 0;
        const slopes l = walled ? slopes_at_walls(s, i) : slopes_of(s->frozen, i);
        s->fluid.stretch[i] = (l.xx - l.yy) / 2;
        s->fluid.shear[i] = (l.xy + l.yx) / 2;
    }
}

bool sph2d__frozen_rub(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    const size_t count = s->fluid.count;
    if (s->liquid->model != SPH2D_RHEOLOGY_NEWTONIAN)
        sph2d__over_particles(s, count, strain_some, NULL);
    if (!sph2d__rheology_set(s))
        return false;
    for (size_t k = 0; s->viscosities && k < s->frozen->images.count; ++k)
        s->viscosities[s->frozen->first_image + k] = s->viscosities[sph2d__image_of(s->frozen, k)];
    for (size_t i = count; s->viscosities && i < count + SPH2D__WIDEST; ++i)
        s->viscosities[i] = s->viscosity; /* what lists end with */
    if (s->viscosity > 0)
        sph2d__over_particles(s, count, spare_some, "spare_pass");
    z->sticks = s->walls_rough && s->walls_press && s->viscosity > 0;
    z->rubs = sph2d__has_friction(s);
    z->pulls = s->surface_tension > 0;
    if (z->sticks)
        sph2d__over_particles(s, count, stick_some, "stick_pass");
    if (!z->rubs && !z->pulls)
        return true;
    sph2d__over_particles(s, count, clear_some, NULL);
    sph2d__friction_set(s);
    sph2d__friction_add(s);
    sph2d__over_particles(s, count, take_rubbed, NULL);
    sph2d__tension_add(s);
    sph2d__over_particles(s, count, take_pulled, NULL);
    return true;
}
