/* SPDX-License-Identifier: MIT */
/** @file grid_nozzles.c
 *  Sources on the grid of method `hybrid`. The faces next behind the mouth of a source are closed, and what it emits flows
 *  from them into the squares before them; so its jet leaves it at its speed. As rows of particles alone they would take
 *  on the velocity of what falls before them: jets fell ever faster within, and came apart. What lies between a face and
 *  the mouth is hidden, as by a solid. */
#include <math.h>

#include "methods/hybrid/grid.h"

/* A mouth this near to a face lies in it [squares]. */
static const double ROUNDING = 1e-6;

/* Mouths nearer than this to an axis have no faces across it. */
static const double LEAST_SLOPE = 1e-3;

/** Whether a source emits without gaps. */
static bool is_open(const sph2d_source *s, double now)
{
    return !(s->rate > 0) && now >= s->start && !(s->stop > 0 && now >= s->stop);
}

size_t sph2d__grid_most_nozzles(const sph2d_scene *scene, const sph2d__grid *g)
{
    size_t most = 0;
    for (size_t k = 0; k < scene->source_count; ++k)
        most += (size_t)fmin(scene->sources[k].width * g->inverse_x + 3, g->nx) +
                (size_t)fmin(scene->sources[k].width * g->inverse_y + 3, g->ny);
    return most;
}

/** Adds the faces that a mouth covers across one axis: in each column of squares (x: row) the one
 *  behind it. */
static void add_mouth(const sph2d_scene *scene, sph2d__grid *g, size_t index, bool x)
{
    const sph2d_source *s = &scene->sources[index];
    const double length = hypot(s->direction.x, s->direction.y), ux = s->direction.x / length,
                 uy = s->direction.y / length, along = x ? ux : uy, slope = -(x ? uy : ux) / along;
    const double half = fmax(s->width, scene->spacing) / 2 * fabs(along); /* seen along the axis */
    const double side = (double)(x ? g->hy : g->hx), other_side = (double)(x ? g->hx : g->hy);
    const double middle = x ? s->at.y - g->low_y : s->at.x - g->low_x, at = x ? s->at.x - g->low_x : s->at.y - g->low_y;
    const int n = x ? g->ny : g->nx, most = x ? g->nx : g->ny;
    const bool wraps = x ? g->wraps_x : g->wraps_y;
    if (!(fabs(along) > LEAST_SLOPE))
        return;
    for (int i = sph2d__grid_clamp((middle - half) / side, n - 1); i < n && i * side < middle + half; ++i) {
        const double low = fmax(i * side, middle - half), high = fmin((i + 1) * side, middle + half);
        const double mouth = (at + slope * ((low + high) / 2 - middle)) / other_side;
        const double face_at = along > 0 ? floor(mouth + ROUNDING) : ceil(mouth - ROUNDING);
        const int line = (int)face_at + 1;
        const bool at_side = line == 1 || line == most + 1, inside = along > 0 ? line <= most : line > 1;
        if (!(high > low) || line < 1 || line > most + 1 || !inside || (at_side && wraps)) /* a seam has two faces */
            continue;
        const size_t face = x ? sph2d__at(g, line, i + 1) : sph2d__at(g, i + 1, line), back = x ? 1 : g->stride;
        g->nozzles[g->nozzle_count++] =
            (sph2d__nozzle){.face = (uint32_t)face,
                            .square = (uint32_t)(along > 0 ? face : face - back),
                            .source = (uint32_t)index,
                            .x = x,
                            .side = at_side,
                            .part = (float)((high - low) / side),
                            .hidden = sph2d__hidden_part((float)(0.5 - fabs(mouth - face_at))),
                            .speed = (float)(s->speed * along),
                            .flow = (float)(s->speed * fabs(along) * (high - low))};
    }
}

void sph2d__grid_place_nozzles(const sph2d_scene *scene, sph2d__grid *g)
{
    g->nozzle_count = 0;
    for (size_t k = 0; k < scene->source_count; ++k) {
        const sph2d_source *s = &scene->sources[k];
        const double length = hypot(s->direction.x, s->direction.y);
        g->jets[k] = (sph2d__jet){.x = s->at.x,
                                  .y = s->at.y,
                                  .ux = s->direction.x / length,
                                  .uy = s->direction.y / length,
                                  .half_width = fmax(s->width, scene->spacing) / 2,
                                  .speed = s->speed};
        for (int axis = 0; axis < 2; ++axis)
            add_mouth(scene, g, k, axis == 0);
    }
}

void sph2d__grid_open_nozzles(const sph2d_sim *sim, sph2d__grid *g)
{
    const double now = sim->record.time;
    for (size_t k = 0; k < g->jet_count; ++k)
        g->jets[k].open = is_open(&sim->world.scene.sources[k], now);
    for (size_t n = 0; n < g->nozzle_count && sim->moving_count == 0; ++n) {
        const sph2d__nozzle *z = &g->nozzles[n];
        (z->x ? g->open_x : g->open_y)[z->face] = (z->x ? g->still_x : g->still_y)[z->face];
        g->hidden[z->square] = g->still_hidden[z->square];
        g->cut_count = g->still_cut_count;
    }
    for (size_t n = 0; n < g->nozzle_count; ++n) {
        sph2d__nozzle *z = &g->nozzles[n];
        float *open = &(z->x ? g->open_x : g->open_y)[z->face];
        z->open = g->jets[z->source].open && (*open > 0 || z->side);
        if (!z->open)
            continue;
        *open = fmaxf(*open - z->part, 0);
        if (!(g->hidden[z->square] > 0))
            g->cut[g->cut_count++] = z->square;
        g->hidden[z->square] = fminf(g->hidden[z->square] + z->part * z->hidden, 1);
    }
}

double sph2d__grid_nozzle_work(const sph2d__grid *g, double density)
{
    double sum = 0;
    if (g->nozzle_count > 0)
        sph2d__grid_fetch(g, (void *[]){g->q, g->level->inverse}, 2);
    for (const sph2d__nozzle *z = g->nozzles, *end = z + g->nozzle_count; z < end; ++z)
        if (z->open && g->level->inverse[z->square] > 0)
            sum += (double)(g->q[z->square] * z->flow);
    return density * sum;
}
