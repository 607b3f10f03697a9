/* SPDX-License-Identifier: MIT */
/** @file packed.c
 *  Copying into floats. */
#include "methods/packed.h"

#include "methods/slabs.h"

static void pack_place(sph2d__store *t, const sph2d__cells *cells, size_t i)
{
    uint32_t cell = cells->cell[cells->order[i]];
    sph2d__floats(t, t->packed_place, 0)[i] = (float)(t->x[i] - sph2d__tile_x(cells, cell % cells->nx));
    sph2d__floats(t, t->packed_place, 1)[i] = (float)(t->y[i] - sph2d__tile_y(cells, cell / cells->nx));
}

static void pack_state(sph2d__store *t, double rest_density, const double *vx, const double *vy, const double *last,
                       size_t i)
{
    sph2d__floats(t, t->packed_velocity, 0)[i] = (float)vx[i];
    sph2d__floats(t, t->packed_velocity, 1)[i] = (float)vy[i];
    sph2d__floats(t, t->packed_state, 0)[i] = (float)(t->density[i] - rest_density);
    sph2d__floats(t, t->packed_state, 1)[i] = (float)t->pressure[i];
    sph2d__floats(t, t->packed_rest, 0)[i] = (float)t->volume[i];
    sph2d__floats(t, t->packed_rest, 1)[i] = (float)last[i];
}

static void pack_some_fluid(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        pack_place(f, &s->fluid_cells, i);
        pack_state(f, s->rest_density, f->vx, f->vy, f->fullness, i);
        sph2d__floats(f, f->packed_slope, 0)[i] = (float)f->slope_x[i];
        sph2d__floats(f, f->packed_slope, 1)[i] = (float)f->slope_y[i];
    }
}

static void pack_some_walls(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *w = &s->walls;
    for (size_t i = first; i < last; ++i) {
        pack_place(w, &s->wall_cells, i);
        pack_state(w, s->rest_density, w->image_vx, w->image_vy, w->mass, i);
    }
}

void sph2d__pack_fluid(sph2d__system *s)
{
    if (s->fluid.packed_place)
        sph2d__over_particles(s, s->fluid.count, pack_some_fluid);
}

void sph2d__pack_walls(sph2d__system *s)
{
    if (s->walls.packed_place)
        sph2d__over_particles(s, s->walls.count, pack_some_walls);
}
