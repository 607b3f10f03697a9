/* SPDX-License-Identifier: MIT */
/** @file spring_wall.h
 *  Spring walls at straight sides: a penalty force proportional to penetration, as in the report.
 *  Only the normal component changes.
 *
 *  a_n = max(k d - 2 zeta sqrt(k) v_n, 0), d = range - distance > 0, range = half a spacing, so that a lattice that
 *  starts half a spacing from the wall starts at rest. With k = (c0/dx)^2 a liquid whose pressure compresses it by a
 *  fraction e goes e spacings in: p/(rho dx) = k d and p = c0^2 rho e. The clamp at 0 keeps damping from pulling. */
#ifndef SPH2D_BOUNDARY_SPRING_WALL_H
#define SPH2D_BOUNDARY_SPRING_WALL_H

/** The sides; an absent one lies at infinity. */
typedef struct sph2d__spring_walls {
    double left, right, bottom, top; /**< where the sides are [m]; -+INFINITY for none */
    double range;                    /**< [m] */
    double stiffness;                /**< k [1/s^2] */
    double damping;                  /**< 2 zeta sqrt(k) [1/s] */
} sph2d__spring_walls;

/** Push [m/s^2] away from a side at `distance` for a velocity `v_out` away from it. */
static inline double sph2d__spring_force(const sph2d__spring_walls *w, double distance, double v_out)
{
    double depth = w->range - distance;
    if (!(depth > 0))
        return 0;
    double push = w->stiffness * depth - w->damping * v_out;
    return push > 0 ? push : 0;
}

static inline void sph2d__spring_walls_add(const sph2d__spring_walls *w, double x, double y, double vx, double vy,
                                           double *ax, double *ay)
{
    *ax += sph2d__spring_force(w, x - w->left, vx) - sph2d__spring_force(w, w->right - x, -vx);
    *ay += sph2d__spring_force(w, y - w->bottom, vy) - sph2d__spring_force(w, w->top - y, -vy);
}

#endif
