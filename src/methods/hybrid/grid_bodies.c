/* SPDX-License-Identifier: MIT */
/** @file grid_bodies.c
 *  Bodies among the equations of the grid of method `hybrid`. With velocities V of bodies, G V is what flows into squares by
 *  their closed faces, and pressure gives them the impulses -rho0 G' q, the transpose. So
 *
 *      (L + rho0 G M^-1 G') q = flow by V without pressure
 *
 *  with a symmetric matrix without negative eigenvalues for bodies of any mass (Batty, Bertails & Bridson 2007). A body
 *  adds three directions to those that the preconditioner knows, and as many iterations. */
#include "methods/hybrid/grid.h"
#include "sim/bodies.h"

void sph2d__grid_wet_parts(sph2d__grid *g)
{
    for (size_t n = 0; n < g->part_count; ++n) {
        sph2d__part *p = &g->parts[n];
        p->wet_before = g->level->inverse[p->before] > 0 ? 1 : 0;
        p->wet_after = g->level->inverse[p->after] > 0 ? 1 : 0;
    }
}

/** What is pressed against a part, from `before` to `after`. */
static float difference(const sph2d__part *part, const float *p)
{
    return part->wet_after * p[part->after] - part->wet_before * p[part->before];
}

/** G' p, into push. */
static void sum_pushes(const sph2d__grid *g, const float *p)
{
    for (size_t n = 0; n < 3 * g->body_count; ++n)
        g->push[n] = 0;
    for (const sph2d__part *part = g->parts, *end = part + g->part_count; part < end; ++part)
        for (int c = 0; c < 3 && part->body > 0; ++c)
            g->push[3 * (part->body - 1) + (uint32_t)c] += (double)(part->by[c] * difference(part, p));
}

void sph2d__grid_add_bodies(const sph2d__grid *g, const float *p, float *out)
{
    if (g->body_count == 0)
        return;
    sum_pushes(g, p);
    for (size_t n = 0; n < 3 * g->body_count; ++n)
        g->push[n] *= g->inverse[n / 3][n % 3];
    for (const sph2d__part *part = g->parts, *end = part + g->part_count; part < end; ++part) {
        double sum = 0;
        for (int c = 0; c < 3 && part->body > 0; ++c)
            sum += (double)part->by[c] * g->push[3 * (part->body - 1) + (uint32_t)c];
        out[part->after] += part->wet_after * (float)sum;
        out[part->before] -= part->wet_before * (float)sum;
    }
}

void sph2d__grid_impulses(const sph2d__grid *g, double density, sph2d__twist *impulses)
{
    sum_pushes(g, g->q);
    for (size_t k = 0; k < g->body_count; ++k)
        impulses[k] =
            (sph2d__twist){-density * g->push[3 * k], -density * g->push[3 * k + 1], -density * g->push[3 * k + 2]};
}

double sph2d__grid_wall_work(const sph2d__grid *g, double density)
{
    double sum = 0;
    for (const sph2d__part *part = g->parts, *end = part + g->part_count; part < end; ++part)
        if (part->body == 0) /* bodies have an energy of their own */
            sum += (double)((part->by[0] + part->by[1]) * part->speed * difference(part, g->q));
    return density * sum;
}
