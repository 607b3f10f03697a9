/* SPDX-License-Identifier: MIT */
/** @file known_flows.h
 *  Known flows that tests look at, their values at a point, and differences of these. Nothing has the size 1, so that
 *  no factor can be lost. */
#ifndef SPH2D_TESTS_KNOWN_FLOWS_H
#define SPH2D_TESTS_KNOWN_FLOWS_H

#include "common.h"
#include "sph2d/flow.h"

typedef struct value {
    double vx, vy, p;
} value;

/** A flow with all that belongs to it. */
typedef struct known {
    sph2d_flow flow;
    sph2d_flow_context context;
} known;

/** Values at time t and point (x, y), which must not be refused. */
value at(const known *k, double t, double x, double y);

#define same(is, should_be, tolerance) ck_assert_double_eq_tol(is, should_be, tolerance)

/** L = 0.7 m, density 870 kg/m^3, centre (0.31, -0.17) m. Points are taken from a box around the centre, at times
 *  on both sides of every switch of formulas. */
struct example {
    sph2d_flow_kind kind;
    double speed, depth, viscosity, gx, gy, central, time, box[4];
};
enum { EXAMPLES = 22 };
extern const struct example examples[EXAMPLES];

known known_of(const struct example *e);
/** The first example of a kind. */
known example(sph2d_flow_kind kind);
/** The same with centre (0, 0). */
known centred(sph2d_flow_kind kind);

/** Derivatives along one direction: x, y or t. */
typedef struct change {
    value first, second;
} change;

/** The direction is that of the step above 0; differences are of fourth order. */
change along(const known *k, double t, double x, double y, double ht, double hx, double hy);

#endif
