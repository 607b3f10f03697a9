/* SPDX-License-Identifier: MIT */
/** @file springs.h
 *  Spring walls at straight sides: a penalty force proportional to penetration, as in the report.
 *  Only the normal component changes.
 *
 *  a_n = max(k d - 2 zeta sqrt(k) v_n, 0), d = range - distance > 0, range = half a spacing, so that a lattice that
 *  starts half a spacing from the wall starts at rest. With k = (c0/dx)^2 a liquid whose pressure compresses it by a
 *  fraction e goes e spacings in: p/(rho dx) = k d and p = c0^2 rho e. The clamp at 0 keeps damping from pulling. Its
 *  potential is k d^2/2; what it does beyond that is dissipation. */
#ifndef SPH2D_FORCES_SPRINGS_H
#define SPH2D_FORCES_SPRINGS_H

#include <math.h>

#include "forces/place.h"
#include "sph2d/scene.h"

/** The sides; an absent one lies at infinity. */
typedef struct sph2d__springs {
    double left, right, bottom, top; /**< where the sides are [m]; -+INFINITY for none */
    double range;                    /**< [m] */
    double stiffness;                /**< k [1/s^2] */
    double damping;                  /**< 2 zeta sqrt(k) [1/s] */
} sph2d__springs;

static inline void sph2d__springs_set(sph2d__springs *w, const sph2d_scene *scene, double sound_speed)
{
    const bool spring = scene->walls == SPH2D_WALL_SPRING;
    const double dx = scene->spacing, k = spring ? sound_speed * sound_speed / (dx * dx) : 0;
    const sph2d_boundary *b = &scene->boundary;
    *w = (sph2d__springs){
        .left = spring && b->left == SPH2D_SIDE_WALL ? scene->domain.min.x : -INFINITY,
        .right = spring && b->right == SPH2D_SIDE_WALL ? scene->domain.max.x : INFINITY,
        .bottom = spring && b->bottom == SPH2D_SIDE_WALL ? scene->domain.min.y : -INFINITY,
        .top = spring && b->top == SPH2D_SIDE_WALL ? scene->domain.max.y : INFINITY,
        .range = dx / 2,
        .stiffness = k,
        .damping = 2 * scene->wall_damping * sqrt(k),
    };
}

static inline bool sph2d__springs_acts(const sph2d__springs *w)
{
    return w->stiffness > 0;
}

/** Push [m/s^2] away from a side at `distance` for a velocity `v_out` away from it. */
static inline double sph2d__spring_force(const sph2d__springs *w, double distance, double v_out)
{
    double depth = w->range - distance;
    if (!(depth > 0))
        return 0;
    double push = w->stiffness * depth - w->damping * v_out;
    return push > 0 ? push : 0;
}

static inline void sph2d__springs_add(const sph2d__springs *w, sph2d__place at, double *ax, double *ay)
{
    *ax += sph2d__spring_force(w, at.x - w->left, at.vx) - sph2d__spring_force(w, w->right - at.x, -at.vx);
    *ay += sph2d__spring_force(w, at.y - w->bottom, at.vy) - sph2d__spring_force(w, w->top - at.y, -at.vy);
}

/** Potential of one side. */
static inline double sph2d__springs_energy(const sph2d__springs *w, double distance)
{
    double depth = w->range - distance;
    return depth > 0 ? w->stiffness * depth * depth / 2 : 0;
}

static inline double sph2d__springs_potential(const sph2d__springs *w, double x, double y)
{
    return sph2d__springs_energy(w, x - w->left) + sph2d__springs_energy(w, w->right - x) +
           sph2d__springs_energy(w, y - w->bottom) + sph2d__springs_energy(w, w->top - y);
}

static inline bool sph2d__springs_drives(const sph2d__springs *w)
{
    return w->stiffness > 0;
}

/** The dampers: the force less that at rest. */
static inline void sph2d__springs_drive(const sph2d__springs *w, sph2d__place at, double *ax, double *ay)
{
    double rest_x = 0, rest_y = 0;
    sph2d__springs_add(w, at, ax, ay);
    sph2d__springs_add(w, (sph2d__place){at.x, at.y, 0, 0}, &rest_x, &rest_y);
    *ax -= rest_x;
    *ay -= rest_y;
}

#endif
