/* SPDX-License-Identifier: MIT */
/** @file array.h
 *  A borrowed, typed array: how fields of particles and states of runs are passed out of the library and back.
 *
 *      sph2d_array a = sph2d_field(sim, SPH2D_GROUP_FLUID, 0);
 *      const double *x = a.data[0], *y = a.data[1];
 *      for (size_t i = 0; i < a.count; ++i)
 *          printf("%s %g %g\n", a.name, x[i * a.stride], y[i * a.stride]); */
#ifndef SPH2D_ARRAY_H
#define SPH2D_ARRAY_H

#include <stddef.h>
#include <stdint.h>

/** Type of the numbers of an array. */
typedef enum sph2d_type {
    /** double */
    SPH2D_F64 = 0,

    /** uint64_t */
    SPH2D_U64 = 1
} sph2d_type;

/** What an array belongs to. */
typedef enum sph2d_group {
    /** One value per fluid particle. */
    SPH2D_GROUP_FLUID = 0,

    /** One value per boundary particle. */
    SPH2D_GROUP_WALL = 1,

    /** The run itself: clock, counters, sources. */
    SPH2D_GROUP_RUN = 2,

    /** One value per corner of the outlines of walls and bodies. */
    SPH2D_GROUP_OUTLINE = 3
} sph2d_group;

/** `count` values of `components` numbers each, one pointer per component (struct of arrays). The strings have static
 *  storage; the data is borrowed from the object that returned the array. */
typedef struct sph2d_array {
    /** What it belongs to. */
    sph2d_group group;

    /** Name, "Coordinates"; unique inside its group. */
    const char *name;

    /** Its meaning, in one sentence. */
    const char *description;

    /** Unit, as exponents of metre, kilogram and second: {1, 0, -1} is m/s. */
    signed char unit[3];

    /** Type of its numbers. */
    sph2d_type type;

    /** Numbers of a value: 1, or 2 for points. */
    unsigned components;

    /** Number of values; 1 for a scalar of the run. */
    size_t count;

    /** Distance from a value to the next one in `data`: 1, or 0 if all values are the same. */
    size_t stride;

    /** One pointer per component, to double or uint64_t according to `type`; data[1] is NULL for one component. */
    const void *data[2];
} sph2d_array;

#endif
