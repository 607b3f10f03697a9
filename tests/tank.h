/* SPDX-License-Identifier: MIT */
/** @file tank.h
 *  A tank of liquid for methods `pcisph` and `constraint`, one at a time, and what tests ask of it. */
#ifndef SPH2D_TESTS_TANK_H
#define SPH2D_TESTS_TANK_H

#include "common.h"

/** Most particles that a tank takes from a list. */
enum { TANK_MOST = 2000 };

/** The two methods; the spacing of most tanks [m]; gravity [m/s^2]. */
static const sph2d_method both[] = {SPH2D_METHOD_PCISPH, SPH2D_METHOD_CONSTRAINT};
static const double DX = 0.02, G = 9.81;

/** The scene and what it points to, and its simulation once it started. */
typedef struct test_tank {
    sph2d_scene scene;
    sph2d_block blocks[3];
    sph2d_obstacle obstacle;
    sph2d_particle particles[TANK_MOST];
    sph2d_sim *sim;
} test_tank;

extern test_tank tank;

/** Lays out a tank open at the top, with gravity, of water with a dynamic viscosity [Pa s], without liquid. */
void tank_empty(sph2d_method method, double dx, double width, double height, double viscosity);
/** Adds a block (x0, y0) to (x1, y1). */
void tank_add(double x0, double y0, double x1, double y1);
void tank_start(void);
/** Ends the simulation; for the end of every test. */
void tank_finish(void);

/** Viscosity with sqrt(g H) H/nu = 100 [Pa s], for a settled state of depth H within some 20 sqrt(H/g). */
double tank_settling(double depth);

/** Height of the middle of all liquid, the largest speed, whether every number is one. */
double tank_middle(void);
double tank_fastest(void);
bool tank_is_finite(void);

/** What a run of some time had. */
typedef struct tank_span {
    double fastest; /**< largest speed of all steps */
    double middle;  /**< mean over the steps of the middle's height */
} tank_span;

/** Takes steps up to a time. */
tank_span tank_run_until(double time);

#endif
