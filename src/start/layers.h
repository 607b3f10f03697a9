/* SPDX-License-Identifier: MIT */
/** @file layers.h
 *  Layers of boundary particles of generalised walls: what outlines and sides of the domain share. */
#ifndef SPH2D_START_LAYERS_H
#define SPH2D_START_LAYERS_H

#include "sim/simulation.h"
#include "start/near.h"

/** A boundary particle: position, area, and unit normal to and depth below the surface. */
typedef struct sph2d__boundary_particle {
    sph2d_vec2 at;
    double area;
    sph2d_vec2 normal;
    double depth;
    double skin; /**< length of surface that it represents, in the first layer */
} sph2d__boundary_particle;

/** The number of layers over a support radius. */
int sph2d__layer_count(const sph2d_sim *sim);

/** The boundary particles placed so far, for the distance from them within which new ones are left out; without slivers
 *  of sharp corners, which are less than half of what they would replace. The caller frees them. False when memory is
 *  short. */
bool sph2d__layers_find_earlier(sph2d_sim *sim, sph2d__near *earlier);

/** Adds a boundary particle. Errors: SPH2D_SCENE (too many), SPH2D_NOMEM. */
sph2d_status sph2d__layers_add(sph2d_sim *sim, const sph2d__boundary_particle *p, sph2d_report *report);

#endif
