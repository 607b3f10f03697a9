/* SPDX-License-Identifier: MIT */
/** @file frame_paths.c
 *  The paths of tracers in a picture: places in the order of time become lines, one after the other. */
#include <math.h>
#include <stdlib.h>

#include "frame.h"

/* The places of tracers that a source has. */
static sph2d_paths paths_of(const particle_source *source)
{
    if (source->sim)
        return sph2d_sim_paths(source->sim);
    const sph2d_array *places = sph2d_snapshot_array(source->snapshot, SPH2D_GROUP_RUN, "TracerPlaces");
    const sph2d_array *probes = sph2d_snapshot_array(source->snapshot, SPH2D_GROUP_RUN, "TracerProbes");
    const bool usable = places && probes && places->type == SPH2D_F64 && probes->type == SPH2D_U64 &&
                        places->count == 2 * probes->count && places->stride == 1 && probes->stride == 1;
    return usable ? (sph2d_paths){probes->count, places->data[0], probes->data[0]} : (sph2d_paths){0};
}

static bool reserve(frame_buffers *buffers, size_t count)
{
    if (count <= buffers->places)
        return true;
    void *const arrays[] = {&buffers->path_x, &buffers->path_y, &buffers->path_id};
    _Static_assert(sizeof(double) == sizeof(uint64_t), "the arrays have one size");
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; ++k) {
        void *grown = realloc(*(void **)arrays[k], count * sizeof(double));
        if (!grown)
            return false;
        *(void **)arrays[k] = grown;
    }
    buffers->places = count;
    return true;
}

/* The smallest number of a probe from `from` on; UINT64_MAX: none. */
static uint64_t next_probe(const sph2d_paths *paths, uint64_t from)
{
    uint64_t next = UINT64_MAX;
    for (size_t k = 0; k < paths->count; ++k)
        if (paths->probes[k] >= from && paths->probes[k] < next)
            next = paths->probes[k];
    return next;
}

/* Whether a particle came back through a periodic side between two places. */
static bool wraps(const frame_style *style, double x, double y)
{
    const sph2d_box *d = &style->domain;
    const bool across = style->boundary.left == SPH2D_SIDE_PERIODIC && fabs(x) > 0.5 * (d->max.x - d->min.x);
    return across || (style->boundary.bottom == SPH2D_SIDE_PERIODIC && fabs(y) > 0.5 * (d->max.y - d->min.y));
}

bool frame_set_paths(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                     sph2d_picture *picture)
{
    sph2d_paths paths = paths_of(source);
    if (paths.count == 0)
        return true;
    if (style->recent > 0 && paths.count > style->recent) {
        const size_t old = paths.count - style->recent;
        paths = (sph2d_paths){style->recent, paths.places + 2 * old, paths.probes + old};
    }
    if (!reserve(buffers, paths.count))
        return false;
    double *x = buffers->path_x, *y = buffers->path_y;
    size_t set = 0;
    uint64_t path = 0, probe = next_probe(&paths, 0);
    for (; probe != UINT64_MAX; probe = next_probe(&paths, probe + 1)) {
        const size_t first = set;
        for (size_t k = 0; k < paths.count; ++k) {
            if (paths.probes[k] != probe)
                continue;
            x[set] = paths.places[2 * k];
            y[set] = paths.places[2 * k + 1];
            path += set > first && wraps(style, x[set] - x[set - 1], y[set] - y[set - 1]);
            buffers->path_id[set++] = path;
        }
        ++path;
    }
    picture->path_count = set;
    picture->path_x = x;
    picture->path_y = y;
    picture->path_id = buffers->path_id;
    return true;
}
