/* SPDX-License-Identifier: MIT */
/** @file fields.c
 *  The table of fields, one row each. */
#include "run/fields.h"
#include "methods/common/on_device.h"

#include <string.h>

/** Where the data of a field comes from. */
typedef enum source {
    FROM_STORE, /**< arrays of the store at `offset` */
    MASS,       /**< one value for all fluid particles, an array for boundary particles */
    SUPPORT     /**< one value for all */
} source;

/** Bits: whose state contains a field, and whether it does so only where particles have colours. */
enum { FLUID = 1, WALL = 2, COLORED = 4 };

typedef struct row {
    const char *name, *description;
    signed char unit[3];
    sph2d_type type;
    unsigned components;
    source source;
    size_t offset[2];
    unsigned in_state;
    sph2d__set if_carried; /**< in the state only if the store carries these arrays; 0: always */
} row;

#define AT(member) offsetof(sph2d__store, member)
#define F64_1(member)                                                                                                  \
    SPH2D_F64, 1, FROM_STORE,                                                                                          \
    {                                                                                                                  \
        AT(member), 0                                                                                                  \
    }
#define F64_2(x, y)                                                                                                    \
    SPH2D_F64, 2, FROM_STORE,                                                                                          \
    {                                                                                                                  \
        AT(x), AT(y)                                                                                                   \
    }

/* The number of public fields, the first rows; walls lack the last. */
enum { FIELDS = 8 };

static const row rows[] = {
    {"Coordinates", "position", {1, 0, 0}, F64_2(x, y), FLUID | WALL, 0},
    {"Velocities", "velocity", {1, 0, -1}, F64_2(vx, vy), FLUID, 0},
    {"Masses", "mass per metre of depth", {-1, 1, 0}, SPH2D_F64, 1, MASS, {0, 0}, 0, 0},
    {"Densities", "mass density", {-3, 1, 0}, F64_1(density), FLUID | WALL, 0},
    {"Pressures", "pressure", {-1, 1, -2}, F64_1(pressure), FLUID | WALL, 0},
    {"SmoothingLengths",
     "support radius H of the kernels, which are zero beyond it",
     {1, 0, 0},
     SPH2D_F64,
     1,
     SUPPORT,
     {0, 0},
     0,
     0},
    {"ParticleIDs",
     "number of a particle, constant throughout the run",
     {0, 0, 0},
     SPH2D_U64,
     1,
     FROM_STORE,
     {AT(id), 0},
     FLUID | WALL,
     0},
    {"Accelerations", "acceleration", {1, 0, -2}, F64_2(ax, ay), FLUID, 0},
    /* Values that time schemes carry from step to step. */
    {"ActingPressures",
     "pressure by which particles act on each other, before it is averaged to be reported",
     {-1, 1, -2},
     F64_1(acting_pressure),
     FLUID | WALL,
     SPH2D__BIT(acting_pressure)},
    {"Fillings",
     "part of the support outside walls that other liquid fills, during the last step: 1 inside, 0 if isolated",
     {0, 0, 0},
     F64_1(filling),
     FLUID,
     SPH2D__BIT(filling)},
    {"StrainRates",
     "(dvx/dx - dvy/dy)/2 and (dvx/dy + dvy/dx)/2 during the last step",
     {0, 0, -1},
     F64_2(stretch, shear),
     FLUID,
     SPH2D__BIT(stretch)},
    {"Rotations", "(dvy/dx - dvx/dy)/2 during the last step", {0, 0, -1}, F64_1(rotation), FLUID, SPH2D__BIT(rotation)},
    {"DensityRates",
     "rate of density in the last step",
     {-3, 1, -1},
     F64_1(density_rate),
     FLUID,
     SPH2D__BIT(density_rate)},
    {"OldAccelerations",
     "acceleration of the previous step",
     {1, 0, -2},
     F64_2(old_ax, old_ay),
     FLUID,
     SPH2D__BIT(old_ax)},
    {"LogDensities",
     "logarithm of density over rest density",
     {0, 0, 0},
     F64_1(log_density),
     FLUID,
     SPH2D__BIT(log_density)},
    {"StoredEnergies",
     "energy by which particles closer than half a spacing repel each other, a particle's part, and by which sides do",
     {2, 0, -2},
     F64_1(stored),
     FLUID,
     SPH2D__BIT(stored)},
    {"OldDensityRates",
     "rate of density of the previous step",
     {-3, 1, -1},
     F64_1(old_density_rate),
     FLUID,
     SPH2D__BIT(old_density_rate)},
    {"Colors",
     "colour in pictures: 65536 red + 256 green + blue, 0 to 255 each",
     {0, 0, 0},
     SPH2D_U64,
     1,
     FROM_STORE,
     {AT(color), 0},
     FLUID | COLORED,
     0},
};

static const sph2d_array outline_fields[] = {
    {.group = SPH2D_GROUP_OUTLINE,
     .name = "Coordinates",
     .description = "corners of the outlines of sides, obstacles and bodies",
     .unit = {1, 0, 0},
     .type = SPH2D_F64,
     .components = 2,
     .stride = 1},
    {.group = SPH2D_GROUP_OUTLINE,
     .name = "OutlineIDs",
     .description = "number of the outline that a corner belongs to",
     .type = SPH2D_U64,
     .components = 1,
     .stride = 1},
    {.group = SPH2D_GROUP_OUTLINE,
     .name = "LiquidSides",
     .description = "where liquid is: 0 on both sides of a line, 1 on the left, 2 outside of a solid",
     .type = SPH2D_U64,
     .components = 1,
     .stride = 1},
    {.group = SPH2D_GROUP_OUTLINE,
     .name = "WallIDs",
     .description = "number of its obstacle, or of its body behind all obstacles; 2^64 - 1 for a side",
     .type = SPH2D_U64,
     .components = 1,
     .stride = 1},
};

enum { OUTLINE_FIELDS = sizeof outline_fields / sizeof outline_fields[0] };
enum { ROWS = sizeof rows / sizeof rows[0] };
_Static_assert(ROWS + 5 <= SPH2D__FIELDS_OF_STATE, "all fields of the fluid, and five of the walls");

size_t sph2d_field_count(sph2d_group group)
{
    switch (group) {
    case SPH2D_GROUP_FLUID:
        return FIELDS;
    case SPH2D_GROUP_WALL:
        return FIELDS - 1;
    case SPH2D_GROUP_OUTLINE:
        return OUTLINE_FIELDS;
    default:
        return 0;
    }
}

/** A field of the outlines; with `sim` NULL only its description. */
static sph2d_array outline_field(const sph2d_sim *sim, size_t index)
{
    sph2d_array field = outline_fields[index];
    if (!sim)
        return field;
    const sph2d__outlines *all = &sim->outlines;
    const void *const data[OUTLINE_FIELDS][2] = {
        {all->x, all->y}, {all->id, NULL}, {all->liquid, NULL}, {all->wall, NULL}};
    field.count = all->count;
    memcpy(field.data, data[index], sizeof field.data);
    return field;
}

static sph2d_array describe(const row *r, sph2d_group group)
{
    sph2d_array array = {.group = group,
                         .name = r->name,
                         .description = r->description,
                         .type = r->type,
                         .components = r->components,
                         .stride = 1};
    memcpy(array.unit, r->unit, sizeof array.unit);
    return array;
}

static void *store_array(const sph2d__store *store, size_t offset)
{
    void *array;
    memcpy(&array, (const char *)store + offset, sizeof array);
    return array;
}

static const void *fetched_array(const sph2d_sim *sim, const sph2d__store *store, size_t offset)
{
    void *array = store_array(store, offset);
    sph2d__host_reads_block(&sim->system, array);
    return array;
}

static const sph2d__store *store_of(const sph2d_sim *sim, sph2d_group group)
{
    return group == SPH2D_GROUP_FLUID ? &sim->system.fluid : &sim->system.walls;
}

sph2d_array sph2d_field(const sph2d_sim *sim, sph2d_group group, size_t index)
{
    if (index >= sph2d_field_count(group))
        return (sph2d_array){.group = group};
    if (group == SPH2D_GROUP_OUTLINE)
        return outline_field(sim, index);
    const row *r = &rows[index];
    sph2d_array field = describe(r, group);
    if (!sim)
        return field;
    const sph2d__system *s = &sim->system;
    field.count = store_of(sim, group)->count;
    switch (r->source) {
    case FROM_STORE:
        for (unsigned c = 0; c < r->components; ++c)
            field.data[c] = fetched_array(sim, store_of(sim, group), r->offset[c]);
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

const uint64_t *sph2d_sim_colors(const sph2d_sim *sim)
{
    if (sim)
        sph2d__host_reads(&sim->system, SPH2D__COLORS);
    return sim ? sim->system.fluid.color : NULL;
}

size_t sph2d__fields_of_state(sph2d_sim *sim, sph2d__lent out[SPH2D__FIELDS_OF_STATE])
{
    const struct {
        sph2d_group group;
        unsigned bit;
    } groups[] = {{SPH2D_GROUP_FLUID, FLUID}, {SPH2D_GROUP_WALL, WALL}};
    size_t n = 0;
    for (size_t g = 0; g < 2; ++g) {
        const sph2d__store *store = store_of(sim, groups[g].group);
        for (const row *r = rows; r < rows + ROWS; ++r) {
            if (!(r->in_state & groups[g].bit) || (store->carried & r->if_carried) != r->if_carried ||
                (r->in_state & COLORED && !store->colored))
                continue;
            sph2d__lent *lent = &out[n++];
            *lent = (sph2d__lent){.array = describe(r, groups[g].group)};
            lent->array.count = store->count;
            for (unsigned c = 0; c < r->components; ++c)
                lent->array.data[c] = lent->data[c] = store_array(store, r->offset[c]);
        }
    }
    return n;
}
