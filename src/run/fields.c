/* SPDX-License-Identifier: MIT */
/** @file fields.c
 *  The field table: one row a field. */
#include "sph2d/field.h"

#include <string.h>

#include "sim/simulation.h"

/** Where a field's data is. */
typedef enum source {
    FROM_STORE, /**< arrays of the store at `offset` */
    MASS,       /**< one for all fluid particles, an array for walls */
    SUPPORT     /**< one for all */
} source;

typedef struct row {
    const char *name, *description;
    signed char unit[3];
    sph2d_type type;
    unsigned components;
    source source;
    size_t offset[2];
} row;

#define IN_STORE(member) offsetof(sph2d__store, member)

static const row rows[] = {
    {"Coordinates", "position", {1, 0, 0}, SPH2D_F64, 2, FROM_STORE, {IN_STORE(x), IN_STORE(y)}},
    {"Velocities", "velocity", {1, 0, -1}, SPH2D_F64, 2, FROM_STORE, {IN_STORE(vx), IN_STORE(vy)}},
    {"Masses", "mass per metre of depth", {-1, 1, 0}, SPH2D_F64, 1, MASS, {0, 0}},
    {"Densities", "mass density", {-3, 1, 0}, SPH2D_F64, 1, FROM_STORE, {IN_STORE(density), 0}},
    {"Pressures", "pressure", {-1, 1, -2}, SPH2D_F64, 1, FROM_STORE, {IN_STORE(pressure), 0}},
    {"SmoothingLengths",
     "support radius H of the kernels, which are zero beyond it",
     {1, 0, 0},
     SPH2D_F64,
     1,
     SUPPORT,
     {0, 0}},
    {"ParticleIDs", "a particle's number, for ever", {0, 0, 0}, SPH2D_U64, 1, FROM_STORE, {IN_STORE(id), 0}},
    {"Accelerations", "acceleration", {1, 0, -2}, SPH2D_F64, 2, FROM_STORE, {IN_STORE(ax), IN_STORE(ay)}},
};

enum { ROWS = sizeof rows / sizeof rows[0], WALL_ROWS = ROWS - 1 /* walls do not accelerate */ };

size_t sph2d_field_count(sph2d_group group)
{
    return group == SPH2D_GROUP_FLUID ? ROWS : group == SPH2D_GROUP_WALL ? WALL_ROWS : 0;
}

static const void *store_array(const sph2d__store *store, size_t offset)
{
    const void *array;
    memcpy(&array, (const char *)store + offset, sizeof array);
    return array;
}

sph2d_array sph2d_field(const sph2d_sim *sim, sph2d_group group, size_t index)
{
    sph2d_array field = {.group = group};
    if (index >= sph2d_field_count(group))
        return field;
    const row *r = &rows[index];
    field.name = r->name;
    field.description = r->description;
    memcpy(field.unit, r->unit, sizeof field.unit);
    field.type = r->type;
    field.components = r->components;
    field.stride = 1;
    if (!sim)
        return field;
    const sph2d__system *s = &sim->system;
    const sph2d__store *store = group == SPH2D_GROUP_FLUID ? &s->fluid : &s->walls;
    field.count = store->count;
    switch (r->source) {
    case FROM_STORE:
        for (unsigned c = 0; c < r->components; ++c)
            field.data[c] = store_array(store, r->offset[c]);
        break;
    case MASS:
        field.stride = group == SPH2D_GROUP_WALL;
        field.data[0] = group == SPH2D_GROUP_WALL ? s->walls.mass : &s->mass;
        break;
    case SUPPORT:
        field.stride = 0;
        field.data[0] = &s->support;
        break;
    }
    return field;
}
