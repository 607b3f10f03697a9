/* SPDX-License-Identifier: MIT */
/** @file place_check.c
 *  Checks of the placed particles: overlapping blocks, coincident particles, liquid in the layers of a wall. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/system.h"
#include "scene/liquid.h"
#include "scene/shape.h"
#include "start/start.h"

/* Cells use 32-bit indices. */
static const double MAX_PARTICLES = 4e9;

bool sph2d__sim_too_many(const sph2d_sim *sim, double count, const char *path, sph2d_report *report)
{
    double each = (double)sph2d__store_bytes(&sim->system.fluid) + 3 * sizeof(uint32_t); /* store and cells */
    double bytes = count * each;
    if (count < MAX_PARTICLES && bytes <= sph2d__machine_memory())
        return false;
    sph2d_diagnostic *d = sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_TOO_MANY, path,
                                           "%.4g particles need %.4g GB of memory", count, bytes / 1e9);
    if (strcmp(path, "particles") != 0)
        sph2d_diagnostic_hint(d, "use a larger spacing");
    return true;
}

bool sph2d__sim_is_too_large(const sph2d_sim *sim, sph2d_report *report)
{
    return sph2d__sim_too_many(sim, sph2d_scene_particles(&sim->world.scene), "spacing", report);
}

/* Liquid begins half a spacing in front of a wall, the layers half a spacing behind, or less in thin solids and sharp
 * corners. Liquid that is nearer to a boundary particle, or to the surface in front of it [spacings], is in the wall or
 * starts compressed against it. */
static const double MIN_DISTANCE = 0.6, MIN_GAP = 0.1;

double sph2d__sim_clear_distance(const sph2d_sim *sim, size_t wall)
{
    const double *depth = sim->system.walls.depth;
    return fmin(MIN_DISTANCE * sim->world.scene.spacing,
                MIN_GAP * sim->world.scene.spacing + (depth ? depth[wall] : INFINITY));
}

/** The first block before block `index` that contains a position; `index` for none. */
static size_t block_around(const sph2d_sim *sim, size_t index, sph2d_vec2 position)
{
    size_t other = 0;
    while (other < index && !sph2d__shape_contains(&sim->world.scene.blocks[other].shape, position))
        ++other;
    return other;
}

/** An earlier block that overlaps block `index`, whose particles start at `first`; `index` for none. */
static size_t find_overlap(const sph2d_sim *sim, size_t index, size_t first, sph2d_vec2 *position)
{
    const sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; i < f->count; ++i) {
        *position = (sph2d_vec2){f->x[i], f->y[i]};
        if (i < first && !sph2d__shape_contains(&sim->world.scene.blocks[index].shape, *position))
            continue;
        size_t other = block_around(sim, index, *position);
        if (other < index)
            return other;
    }
    return index;
}

sph2d_status sph2d__sim_check_overlap(const sph2d_sim *sim, size_t index, size_t first, sph2d_report *report)
{
    sph2d_vec2 position;
    size_t other = find_overlap(sim, index, first, &position);
    if (other == index)
        return SPH2D_OK;
    char path[64];
    snprintf(path, sizeof path, "blocks[%zu]", index);
    sph2d_diagnostic *d = sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OVERLAP, path,
                                           "overlaps blocks[%zu] near (%g, %g)", other, position.x, position.y);
    sph2d_diagnostic_hint(d, "blocks must not overlap: move or shrink one of them");
    return SPH2D_SCENE;
}

sph2d_status sph2d__sim_refuse_particle(size_t k, const char *what, sph2d_vec2 p, sph2d_report *report)
{
    char path[64];
    snprintf(path, sizeof path, "particles[%zu]", k);
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OVERLAP, path, "(%g, %g) lies %s", p.x, p.y, what);
    return SPH2D_SCENE;
}

sph2d_status sph2d__sim_check_distances(const sph2d_sim *sim, uint64_t first, sph2d_report *report)
{
    const sph2d__store *f = &sim->system.fluid;
    double tolerance = 1e-3 * sim->world.scene.spacing;
    for (size_t i = 0; i < f->count; ++i) {
        uint32_t cell = sph2d__cells_find(&sim->system.fluid_cells, f->x[i], f->y[i]);
        if (f->id[i] < first || cell == UINT32_MAX)
            continue;
        sph2d__ranges ranges;
        sph2d__cells_ranges(&sim->system.fluid_cells, cell, &ranges);
        SPH2D__FOR_NEIGHBOURS (&ranges, r, j)
            if (j != i && hypot(f->x[i] + ranges.x[r] - f->x[j], f->y[i] + ranges.y[r] - f->y[j]) < tolerance)
                return sph2d__sim_refuse_particle((size_t)(f->id[i] - first), "where another particle is",
                                                  (sph2d_vec2){f->x[i], f->y[i]}, report);
    }
    return SPH2D_OK;
}

/** The wall that a boundary particle belongs to; the number of walls for a side of the domain. */
static size_t wall_of(const sph2d_sim *sim, uint64_t wall_id)
{
    size_t i = SPH2D__WALL_OBSTACLE;
    while (i < sim->world.wall_count && (wall_id < sim->wall_ids[i].first || wall_id >= sim->wall_ids[i].end))
        ++i;
    return i;
}

/** The wall in whose layers, or within MIN_DISTANCE spacings of them, a position lies; the count for none. */
static size_t layers_around(const sph2d_sim *sim, sph2d_vec2 at)
{
    const sph2d__store *w = &sim->system.walls;
    size_t count = sim->world.wall_count, found = count;
    uint32_t cell = w->count > 0 ? sph2d__cells_find(&sim->system.wall_cells, at.x, at.y) : UINT32_MAX;
    if (cell == UINT32_MAX)
        return count;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&sim->system.wall_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
        double x = at.x + ranges.x[r] - w->x[j], y = at.y + ranges.y[r] - w->y[j];
        size_t k = hypot(x, y) < sph2d__sim_clear_distance(sim, j) ? wall_of(sim, w->id[j]) : count;
        if (k < found && sim->world.walls[k].form == SPH2D_WALL_GENERALISED)
            found = k;
    }
    return found;
}

bool sph2d__sim_is_in_layers(const sph2d_sim *sim, sph2d_vec2 at)
{
    return layers_around(sim, at) < sim->world.wall_count;
}

/** "obstacles[2].line" */
static void name_outline(const sph2d_sim *sim, size_t k, char path[64])
{
    sph2d__wall_path(path, 64, &sim->world.walls[k], sim->world.walls[k].shape_key);
}

static sph2d_status refuse_wall(const sph2d_sim *sim, size_t k, sph2d_vec2 at, size_t count, sph2d_report *report)
{
    const sph2d__wall *wall = &sim->world.walls[k];
    bool right = wall->liquid == SPH2D_LIQUID_RIGHT;
    const char *wet = right ? "right" : "left", *dry = right ? "left" : "right";
    char path[64];
    name_outline(sim, k, path);
    sph2d_diagnostic *d = sph2d_report_add(
        report, SPH2D_ERROR, SPH2D_CODE_OVERLAP, path,
        "%zu particles of the liquid lie in its layers of boundary particles, or less than %g spacings from them, near "
        "(%g, %g)",
        count, MIN_DISTANCE, at.x, at.y);
    if (!sph2d__shape_is_open(&wall->shape))
        sph2d_diagnostic_hint(d, "move the liquid or the obstacle; a solid with liquid around it must be %.3g m thick",
                              sph2d__layer_thickness(&sim->world.scene));
    else
        sph2d_diagnostic_hint(
            d,
            "its layers, %.3g m thick, are on the %s, seen from its first point towards its last: keep the liquid on "
            "the %s, try `liquid: %s` or `both`, or join lines that meet into one polyline or polygon",
            sph2d__layer_thickness(&sim->world.scene), dry, wet, dry);
    return SPH2D_SCENE;
}

sph2d_status sph2d__sim_check_layers(const sph2d_sim *sim, sph2d_report *report)
{
    const sph2d__store *f = &sim->system.fluid;
    const size_t walls = sim->world.wall_count;
    size_t first = walls, count = 0;
    sph2d_vec2 at = {0, 0};
    for (size_t i = 0; i < f->count; ++i) {
        size_t k = layers_around(sim, (sph2d_vec2){f->x[i], f->y[i]});
        if (k < first) {
            first = k;
            count = 0;
            at = (sph2d_vec2){f->x[i], f->y[i]};
        }
        count += k < walls && k == first;
    }
    return first < walls ? refuse_wall(sim, first, at, count, report) : SPH2D_OK;
}
