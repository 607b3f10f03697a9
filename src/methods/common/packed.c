/* SPDX-License-Identifier: MIT */
/** @file packed.c
 *  Copies particle data into floats. */
#include "methods/common/packed.h"

#include "methods/common/slabs.h"

/** Copies values `first` to `last` - 1, minus their reference value. */
static void pack(float *restrict to, const double *restrict from, double relative_to, size_t first, size_t last)
{
    if (to && from)
        for (size_t i = first; i < last; ++i)
            to[i] = (float)(from[i] - relative_to);
}

/** Copies positions, tile by tile. */
static void pack_positions(const sph2d__store *t, const sph2d__cells *cells, size_t first, size_t last)
{
    while (first < last) {
        uint32_t cell = cells->cell[cells->order[first]], row = cell / cells->nx, column = cell - row * cells->nx;
        uint32_t next = (column / SPH2D__TILE + 1) * SPH2D__TILE;
        size_t end = cells->start[(size_t)row * cells->nx + (next < cells->nx ? next : cells->nx)];
        end = end < last ? end : last;
        pack(sph2d__floats(t, t->packed_place, 0), t->x, sph2d__tile_x(cells, column), first, end);
        pack(sph2d__floats(t, t->packed_place, 1), t->y, sph2d__tile_y(cells, row), first, end);
        first = end;
    }
}

/** Copies what all pair loops read. */
static void pack_common(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    pack_positions(f, &s->fluid_cells, first, last);
    pack(sph2d__floats(f, f->packed_velocity, 0), f->vx, 0, first, last);
    pack(sph2d__floats(f, f->packed_velocity, 1), f->vy, 0, first, last);
    pack(sph2d__floats(f, f->packed_density, 0), f->density, s->rest_density, first, last);
    pack(sph2d__floats(f, f->packed_density, 1), f->min_eigenvalue, 0, first, last);
    pack(sph2d__floats(f, f->packed_gradient, 0), f->density_grad_x, 0, first, last);
    pack(sph2d__floats(f, f->packed_gradient, 1), f->density_grad_y, 0, first, last);
}

static void pack_some_fluid(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    pack_common(s, first, last);
    pack(sph2d__floats(f, f->packed_strain, 0), s->viscosities ? s->viscosities : f->stretch, 0, first, last);
    pack(sph2d__floats(f, f->packed_strain, 1), f->shear, 0, first, last);
}

static void pack_some_fluid_rates(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    pack_common(s, first, last);
    pack(sph2d__floats(f, f->packed_strain, 0), f->grad_c_x, 0, first, last);
    pack(sph2d__floats(f, f->packed_strain, 1), f->grad_c_y, 0, first, last);
}

static void pack_some_wall_rates(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *w = &s->walls;
    pack_positions(w, &s->wall_cells, first, last);
    pack(sph2d__floats(w, w->packed_velocity, 0), w->image_vx, 0, first, last);
    pack(sph2d__floats(w, w->packed_velocity, 1), w->image_vy, 0, first, last);
    pack(sph2d__floats(w, w->packed_density, 1), w->mass, 0, first, last);
    pack(sph2d__packed_excess(w), w->wall_rate, 0, first, last);
}

static void pack_some_walls(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *w = &s->walls;
    pack_some_wall_rates(s, first, last);
    pack(sph2d__packed_volume(w), w->volume, 0, first, last);
    pack(sph2d__packed_pressure(w), w->pressure, 0, first, last);
    pack(sph2d__floats(w, w->packed_density, 0), w->slide, 0, first, last);
    pack(sph2d__floats(w, w->packed_gradient, 0), w->along_x, 0, first, last);
    pack(sph2d__floats(w, w->packed_gradient, 1), w->along_y, 0, first, last);
}

void sph2d__pack_fluid(sph2d__system *s)
{
    if (s->fluid.packed_place)
        sph2d__over_particles(s, s->fluid.count, pack_some_fluid);
}

void sph2d__pack_fluid_rates(sph2d__system *s)
{
    if (s->fluid.packed_place)
        sph2d__over_particles(s, s->fluid.count, pack_some_fluid_rates);
}

void sph2d__pack_walls(sph2d__system *s)
{
    if (s->walls.packed_place)
        sph2d__over_particles(s, s->walls.count, pack_some_walls);
}

void sph2d__pack_wall_rates(sph2d__system *s)
{
    if (s->walls.packed_place)
        sph2d__over_particles(s, s->walls.count, pack_some_wall_rates);
}
