/* SPDX-License-Identifier: MIT */
/** @file check_inflow.c
 *  Warns of what openings let in where it does not go with the liquid before them. */
#include <math.h>

#include "scene/checker.h"
#include "scene/liquid.h"
#include "scene/openings.h"
#include "scene/shape.h"

typedef sph2d__checker checker;

/* Spacings of dry opening above liquid that are worth a warning, and the part of it that liquid covers from which on
 * that is a level, not a puddle. */
static const double DRY_WIDTH = 3, COVERED = 0.1;

/** Warns of an inflow that liquid covers up to a level at the start: what comes in above it falls as a jet. */
static void check_cover(checker *c, size_t i)
{
    const sph2d_scene *scene = c->scene;
    const sph2d_opening *o = &scene->openings[i];
    sph2d__mouth m = sph2d__opening_mouth(scene, o);
    double dx = scene->spacing, steps = floor(m.width / dx), covered = 0;
    if (!(scene->gravity.y < 0) || !(m.along.y > 0) || sph2d__opening_has_surface(o) ||
        !sph2d__opening_has_velocity(o) || !(sph2d__opening_velocity(scene, o, INFINITY) > 0))
        return;
    for (double step = 0; step < steps; ++step) {
        sph2d_vec2 p = {m.start.x + dx / 2 * m.inward.x, m.start.y + (step + 0.5) / steps * m.width};
        bool wet = false;
        for (size_t k = 0; k < scene->block_count && !wet; ++k)
            wet = sph2d__shape_contains(&scene->blocks[k].shape, p);
        if (!wet)
            break; /* liquid lies below */
        covered = step + 1;
    }
    if (covered < COVERED * steps || steps - covered < DRY_WIDTH)
        return;
    char path[SPH2D__PATH_SIZE];
    double level = m.start.y + covered / steps * m.width;
    sph2d_diagnostic *d = sph2d_report_add(
        c->report, SPH2D_WARNING, SPH2D_CODE_CONFLICT, sph2d__check_path(path, "openings", i, ""),
        "lets liquid in up to y = %g, above the liquid behind it, which stands up to %.3g: it falls from there",
        m.start.y + m.width, level);
    sph2d_diagnostic_hint(d,
                          "`free_surface: on` lets in what lies below the surface there; or end it at the level, "
                          "`to: %.3g`",
                          level);
}

/* The part of a velocity that may be new to the liquid: its pressure, rho c0 dU, is that times 10 rho U^2. */
static const double SUDDEN = 0.3;

/** The velocity into the domain of blocks before an opening, in the mean over its width; NAN where none is known [m/s]. */
static double velocity_before(const sph2d_scene *scene, const sph2d_opening *o)
{
    sph2d__mouth m = sph2d__opening_mouth(scene, o);
    double steps = floor(m.width / scene->spacing), sum = 0, count = 0;
    for (double step = 0; step < steps; ++step) {
        double t = (step + 0.5) / steps * m.width, inside = scene->spacing / 2;
        sph2d_vec2 p = {m.start.x + t * m.along.x + inside * m.inward.x,
                        m.start.y + t * m.along.y + inside * m.inward.y};
        for (size_t k = 0; k < scene->block_count; ++k) {
            const sph2d_block *b = &scene->blocks[k];
            if (!sph2d__shape_contains(&b->shape, p))
                continue;
            if (sph2d__start_speed(&b->start) > 0)
                return NAN;
            sum += b->velocity.x * m.inward.x + b->velocity.y * m.inward.y;
            ++count;
            break;
        }
    }
    return count > 0 && !(sph2d__start_speed(&scene->start) > 0) ? sum / count : NAN;
}

/** Warns of a velocity that comes at once to liquid that fills the domain and has another. */
static void check_jump(checker *c, size_t i)
{
    const sph2d_scene *scene = c->scene;
    const sph2d_opening *o = &scene->openings[i];
    const sph2d_box *d = &scene->domain;
    if (!sph2d__opening_has_velocity(o) || sph2d__opening_has_surface(o) || o->ramp > 0 ||
        o->history.profile.count > 0 || sph2d__opening_history(o, sph2d__opening_kind_of(o))->count > 0)
        return;
    double velocity = sph2d__opening_velocity(scene, o, 0), jump = fabs(velocity - velocity_before(scene, o));
    if (!(jump > SUDDEN * fabs(velocity)))
        return;
    double length = fmax(d->max.x - d->min.x, d->max.y - d->min.y);
    char path[SPH2D__PATH_SIZE];
    sph2d_diagnostic *w = sph2d_report_add(
        c->report, SPH2D_WARNING, SPH2D_CODE_CONFLICT, sph2d__check_path(path, "openings", i, ""),
        "changes the velocity of the liquid before it by %.3g m/s at once: a blow that may tear it apart", jump);
    sph2d_diagnostic_hint(w,
                          "`ramp: %.2g` starts it in the time in which it crosses the domain; or give the blocks "
                          "a velocity",
                          length / fabs(velocity));
}

void sph2d__check_inflow(checker *c, size_t i, bool filled)
{
    check_cover(c, i);
    if (filled)
        check_jump(c, i);
}
