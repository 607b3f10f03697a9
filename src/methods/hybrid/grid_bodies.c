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

/** Adds what flows into square k, if it is liquid, by a corner of a body. */
static void add_element(sph2d__grid *g, size_t k, uint32_t owner, float x, float y, double turn)
{
    if (owner > 0 && g->level->inverse[k] > 0)
        g->elements[g->element_count++] = (sph2d__element){(uint32_t)k, owner - 1, {x, y, (float)turn}};
}

/** Adds a face that a thin body closes, at (x, y) from its centre. */
static void add_thin(sph2d__grid *g, size_t before, size_t after, uint32_t owner, double x, double y, bool along_x)
{
    const float flow = along_x ? g->hy : g->hx;
    const double turn = along_x ? -y * (double)flow : x * (double)flow;
    add_element(g, after, owner, along_x ? flow : 0, along_x ? 0 : flow, turn);
    add_element(g, before, owner, along_x ? -flow : 0, along_x ? 0 : -flow, -turn);
}

/** Adds a face from square `before` to square `after` that is closed by so much, along x or y; its ends are corners. */
static void add_face(sph2d__grid *g, size_t before, size_t after, size_t one, size_t other, float closed, bool along_x)
{
    const size_t corners[2] = {one, other};
    for (int n = 0; n < 2; ++n) {
        const size_t c = corners[n];
        const uint32_t owner = g->owner[c];
        if (owner == 0)
            continue;
        const sph2d__grid_body *b = &g->bodies[owner - 1];
        const double x = g->low_x + ((double)(c % g->stride) - 1) * (double)g->hx - b->x;
        const double y = g->low_y + ((double)(c / g->stride) - 1) * (double)g->hy - b->y;
        const float flow = (along_x ? g->hy : g->hx) * closed / 2;
        const double turn = along_x ? -y * (double)flow : x * (double)flow;
        add_element(g, after, owner, along_x ? flow : 0, along_x ? 0 : flow, turn);
        add_element(g, before, owner, along_x ? -flow : 0, along_x ? 0 : -flow, -turn);
    }
}

void sph2d__grid_list_bodies(sph2d__grid *g)
{
    const size_t up = g->stride;
    g->element_count = 0;
    for (int j = 1; g->body_count > 0 && j <= g->ny; ++j)
        SPH2D__FOR_SPAN(g, j, k)
        {
            if (k < sph2d__at(g, 1, j) || k > sph2d__at(g, g->nx, j))
                continue;
            const double x = g->low_x + ((double)(k % up) - 1) * (double)g->hx, y = g->low_y + (j - 1) * (double)g->hy;
            const uint32_t across = g->thin_x[k], along = g->thin_y[k];
            if (across > 0)
                add_thin(g, k - 1, k, across, x - g->bodies[across - 1].x,
                         y + (double)g->hy / 2 - g->bodies[across - 1].y, true);
            else if (k > sph2d__at(g, 1, j) && g->open_x[k] < 1)
                add_face(g, k - 1, k, k, k + up, 1 - g->open_x[k], true);
            if (along > 0)
                add_thin(g, k - up, k, along, x + (double)g->hx / 2 - g->bodies[along - 1].x,
                         y - g->bodies[along - 1].y, false);
            else if (j > 1 && g->open_y[k] < 1)
                add_face(g, k - up, k, k, k + 1, 1 - g->open_y[k], false);
        }
}

/** G' p, into push. */
static void sum_pushes(const sph2d__grid *g, const float *p)
{
    for (size_t n = 0; n < 3 * g->body_count; ++n)
        g->push[n] = 0;
    for (size_t n = 0; n < g->element_count; ++n) {
        const sph2d__element *e = &g->elements[n];
        for (int c = 0; c < 3; ++c)
            g->push[3 * e->body + (uint32_t)c] += (double)(e->by[c] * p[e->square]);
    }
}

void sph2d__grid_add_bodies(const sph2d__grid *g, const float *p, float *out)
{
    if (g->element_count == 0)
        return;
    sum_pushes(g, p);
    for (size_t n = 0; n < 3 * g->body_count; ++n)
        g->push[n] *= g->bodies[n / 3].inverse[n % 3];
    for (size_t n = 0; n < g->element_count; ++n) {
        const sph2d__element *e = &g->elements[n];
        double sum = 0;
        for (int c = 0; c < 3; ++c)
            sum += (double)e->by[c] * g->push[3 * e->body + (uint32_t)c];
        out[e->square] += (float)sum;
    }
}

void sph2d__grid_impulses(const sph2d__grid *g, double density, sph2d__twist *impulses)
{
    sum_pushes(g, g->q);
    for (size_t k = 0; k < g->body_count; ++k)
        impulses[k] =
            (sph2d__twist){-density * g->push[3 * k], -density * g->push[3 * k + 1], -density * g->push[3 * k + 2]};
}

/** What flows into the liquid beside face k by its closed part, times its q. Bodies have an energy of their own. */
static double pushed(const sph2d__grid *g, size_t before, size_t k, float flow, size_t one, size_t other)
{
    const sph2d__level *l = g->level;
    if (flow == 0 || (g->owner && (g->owner[one] > 0 || g->owner[other] > 0)))
        return 0;
    return (double)flow *
           ((l->inverse[k] > 0 ? (double)g->q[k] : 0) - (l->inverse[before] > 0 ? (double)g->q[before] : 0));
}

double sph2d__grid_wall_work(const sph2d__grid *g, double density)
{
    const size_t up = g->stride;
    double sum = 0;
    for (int j = 1; j <= g->ny; ++j)
        SPH2D__FOR_SPAN(g, j, k)
        {
            if (k < sph2d__at(g, 1, j) || k > sph2d__at(g, g->nx, j))
                continue;
            if (!(g->body_count > 0 && g->thin_x[k] > 0))
                sum += pushed(g, k - 1, k, g->hy * (1 - g->open_x[k]) * g->wall_x[k], k, k + up);
            if (!(g->body_count > 0 && g->thin_y[k] > 0))
                sum += pushed(g, k - up, k, g->hx * (1 - g->open_y[k]) * g->wall_y[k], k, k + 1);
        }
    return density * sum;
}
