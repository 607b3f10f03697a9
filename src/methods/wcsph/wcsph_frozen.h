/* SPDX-License-Identifier: MIT */
/** @file wcsph_frozen.h
 *  What stands still over a step of method `wcsph`, in C and in OpenCL C. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_FROZEN_H
#define SPH2D_METHODS_WCSPH_WCSPH_FROZEN_H

#include <math.h>

#include "methods/common/system.h"

/** rho/rho0 of its logarithm: by its series, which has the same bits everywhere. */
static inline double sph2d__density_ratio(double theta)
{
    const double x = theta / 4;
    double sum = 1;
    for (int k = 14; k > 0; --k)
        sum = 1 + x * (1.0 / k) * sum;
    return sum * sum * (sum * sum);
}

/** The arrays of the fluid that stand still over a step, or are written by one sweep and read by the next. */
/* clang-format off */
#define SPH2D__FROZEN_ARRAYS(X)                                                                                        \
    X(bxx) X(bxy) X(byy)             /* B */                                                                           \
    X(axx) X(axy) X(ayy)             /* A */                                                                           \
    X(cxx) X(cxy) X(cyx) X(cyy)      /* C */                                                                           \
    X(nx) X(ny)                      /* N */                                                                           \
    X(sx) X(sy)                      /* S */                                                                           \
    X(wall_rate)                     /* q [1/s] */                                                                     \
    X(wall_linear)                   /* what is linear of w in l [m/s] */                                              \
    X(wall_zx) X(wall_zy)            /* the part of z by moving walls */                                               \
    X(brake)                         /* l [J/m] */                                                                     \
    X(smooth)                        /* lambda */                                                                      \
    X(weight)                        /* sum |G| [1/m] */                                                               \
    X(kx) X(ky)                      /* A s */                                                                         \
    X(shift_x) X(shift_y)            /* way by shifting over the step [m] */                                            \
    X(summed)                        /* density by summation, less density, over rest density */                       \
    X(walled)                        /* the part of C that acts, 0 where none does */                                   \
    X(work)                          /* P [J/m] */                                                                     \
    X(diffused)                      /* change of theta by diffusion over an acoustic step */                          \
    X(damping)                       /* Z m c0 H [J s/m] */                                                            \
    X(rate)                          /* D [1/s] */                                                                     \
    X(stick_xx) X(stick_xy) X(stick_yy) X(stick_x) X(stick_y) /* K, k over m [1/s, m/s^2] */                           \
    X(rub_x) X(rub_y) X(pull_x) X(pull_y) /* accelerations by smooth walls, by surface tension [m/s^2] */             \
    X(mean_vx) X(mean_vy)            /* velocities that K takes, over the step, where walls stick [m/s] */             \
    X(held)                          /* 1 in reservoirs of openings, whose velocity and theta are prescribed, else 0 */\
    X(withheld_x) X(withheld_y)      /* the acceleration that they would have [m/s^2] */                               \
    X(held_log_density)                   /* their theta before it was prescribed anew */                                   \
    X(px) X(py)                      /* where particles are now [m] */                                                 \
    X(acts)                          /* a */                                                                           \
    X(mean_work) X(mean_ex) X(mean_ey) /* over the step: 2 a P + l, and A sum (P_k - P_i) G_ik */                      \
    X(across_x) X(across_y)          /* w */                                                                           \
    X(image_nx) X(image_ny)          /* the part of N by images */                                                     \
    X(image_weight)                  /* and of sum |G| */                                                              \
    X(wall_xx) X(wall_xy) X(wall_yy) /* Q */                                                                           \
    X(front_nx) X(front_ny)          /* mean normal of walls that it is in front of */                                    \
    X(front)                         /* its distance from their surface [m] */                                         \
    X(front_weight)                  /* their sum of |G| [1/m] */                                                      \
    X(front_speed)                   /* along their normal [m/s] */                                                    \
    X(repelled) X(mean_repelled)     /* how its image in them repels it, now and over the step [N/m] */                \
    X(push_x) X(push_y)              /* over the step: the acceleration by images [m/s^2] */                           \
    X(sight) X(sight_x) X(sight_y)   /* how far before a face that hides others, and its normal (wcsph_sight.h) */     \
    X(thicker)                       /* by how much more that face presses */

/** Records of four floats, which neighbours read at once. */
#define SPH2D__FROZEN_RECORDS(X)                                                                                       \
    X(state)                         /* v, theta, at the start of the step; nothing */                                 \
    X(slope)                         /* dvx/dx; half of shear; dvy/dy; 1 where walled */                               \
    X(bend)                          /* grad theta; half of rotation; nothing */                                       \
    X(rest)                          /* lambda r over sum |G| [1/s]; A s sum |G|, both along x and y */                \
    X(press)                         /* P B by xx, xy, yy; theta */                                                    \
    X(velocity) X(next_velocity)     /* v, z [m/s] */

/** The arrays of the implicit solve (implicit.c), in its method alone. */
#define SPH2D__IMPLICIT_ARRAYS(X)                                                                                      \
    X(known)                         /* 1 in reservoirs whose pressure is prescribed, else 0 */                        \
    X(taken_x) X(taken_y)            /* the part of given accelerations that has no potential [m/s^2] */                \
    X(driven_x) X(driven_y)          /* velocities by which driving forces are taken [m/s] */                          \
    X(rubbed_x) X(rubbed_y)          /* accelerations by viscosity and friction [m/s^2] */                             \
    X(thick_x) X(thick_y)            /* velocities that viscosity takes (thick.c) [m/s] */                             \
    X(rest_x) X(rest_y)              /* what is left of their equations [m/s] */                                       \
    X(way_x) X(way_y)                /* directions of their next changes [m/s] */                                      \
    X(slowed_x) X(slowed_y)          /* the matrix times these [m/s] */                                                \
    X(eased_x) X(eased_y)            /* the inverse of its diagonal */                                                 \
    X(soft)                          /* 1/(c0^2 + e) [s^2/m^2] */                                                      \
    X(solved)                        /* p [m^2/s^2] */                                                                 \
    X(residual)                     /* of its equations */                                                            \
    X(direction)                     /* of the next change of p [m^2/s^2] */                                           \
    X(product)                       /* the matrix times that */                                                       \
    X(first) X(of_first)             /* the pressures that the solve starts from, and their product */                 \
    X(pull_back_x) X(pull_back_y)    /* D^T of the pressures in `press` [m/s^2] */                                     \
    X(pushed_x) X(pushed_y)          /* by close pairs and walls (implicit_close.c) [m/s^2] */                         \
    X(stopped)                       /* the part of it by walls, along their normal [m/s^2] */                         \
    X(stop_speed)                    /* by bodies: their change of velocity along it [m/s] */                          \
    X(slope_x) X(slope_y)            /* sum (p_k - p_i) G_ik [m/s^2] */                                                \
    X(body_rate)                     /* by bodies: D of their change of velocity [1/s] */

/** The arrays of the pairs: floats. */
#define SPH2D__FROZEN_PAIRS(X)                                                                                         \
    X(gx) X(gy)                      /* G [1/m] */                                                                     \
    X(rx) X(ry)                      /* x_i - x_j [m] */                                                               \
    X(inverse)                       /* 1/|G| [m], 0 of pairs that are none */                                         \
    X(linear_w) X(linear_theta)      /* what is linear of w [m/s], and of theta_ij */
/* clang-format on */

/** The shortest way across periodic sides, of which places are at most half a period beyond; 1e30 stays far. */
static inline double sph2d__shortest_way(double d, double length)
{
    return !(length > 0) ? d : d > length / 2 ? d - length : d < -length / 2 ? d + length : d;
}

typedef struct sph2d__frozen_body sph2d__frozen_body;
typedef struct sph2d__frozen_row sph2d__frozen_row;

/** What is solved for of a close pair in an implicit step (implicit_close.c). */
typedef struct sph2d__close_row {
    size_t other;
    double x, y;              /* s e [1/m] */
    double theta;             /* the right side, but for the motion */
    double scale;             /* s, of a wall, else 0 */
    double solved, direction; /* q, and of its next change [m^2/s^2] */
    double residual, product; /* what is left of the equation; the matrix times the direction */
    double first, of_first;   /* what the solve starts from, and its product */
} sph2d__close_row;

/** Sites of a lattice on either side of a particle, in sums over a full one. */
enum { SPH2D__LATTICE_REACH = 6 };

/** Entries of s. */
enum { SPH2D__FREE_PARTS = 64 };
/* Steps of the distance from a plane, over H. */
enum { SPH2D__PLANE_PARTS = 256 };
/** The flat sides of the domain that mirror the liquid; infinite where there are none. */
typedef struct sph2d__sides {
    double low_x, high_x, low_y, high_y;
    uint64_t first; /**< id of the first boundary particle of a side: those of obstacles come before */
} sph2d__sides;

/** What stands still over a step. */
typedef struct sph2d__frozen {
    sph2d__sides sides;
    sph2d__store images; /**< of the liquid in the sides; id: IMAGE_SIDES times the particle, and the sides */
    sph2d__cells image_cells;
    SPH2D__ARRAY uint32_t *image_starts; /**< on a device: of each slab of particles, its first image ... */
    size_t image_slabs;                  /**< ... for so many */
    size_t first_image;                  /**< where images stand behind the particles in all arrays */
    SPH2D__ARRAY uint32_t *imaged;       /**< of each slice: slots of pairs with images, the last of the fluid's */
#define SPH2D__FROZEN_MEMBER(name) SPH2D__ARRAY double *name;
    SPH2D__FROZEN_ARRAYS(SPH2D__FROZEN_MEMBER)
    SPH2D__IMPLICIT_ARRAYS(SPH2D__FROZEN_MEMBER)
#undef SPH2D__FROZEN_MEMBER
#define SPH2D__FROZEN_RECORD(name) SPH2D__ARRAY float *name;
    SPH2D__FROZEN_RECORDS(SPH2D__FROZEN_RECORD)
    SPH2D__FROZEN_PAIRS(SPH2D__FROZEN_RECORD)
#undef SPH2D__FROZEN_RECORD
    SPH2D__ARRAY double *part;         /**< of boundary particles: how much of them acts */
    size_t walls;                      /**< boundary particles */
    size_t capacity;                   /**< particles */
    size_t implicit;                   /**< particles for which there is room in the arrays of the implicit solve */
    SPH2D__ARRAY unsigned char *flags; /**< of each slice: SPH2D__FROZEN_WALLED, _BESIDE */
    SPH2D__ARRAY uint32_t *close; /**< of each slice: slots of pairs that may come close, behind those with walls */
    size_t pairs, slices;
    double dt;                  /**< of an acoustic step [s] */
    double ahead;               /**< w of an implicit step [s] */
    double most_brake;          /**< the most that b is */
    double repulsion;           /**< R over rho0 c0^2 dx */
    double apart;               /**< how far two particles of a close pair may be in the middle of the step [m] */
    double share;               /**< of an acoustic step in means over the step */
    double past;                /**< the part of the step that is over, in means */
    bool sticks, rubs, pulls;   /**< some walls have no slip, are smooth; there is surface tension */
    bool thin;                  /**< walls may be between particles */
    bool holds;                 /**< there are openings */
    bool thick;                 /**< viscosity is stable in acoustic steps, not in a whole step at once */
    bool varies, driven;        /**< external forces are not the same everywhere; or not one with a potential */
    sph2d__frozen_body *bodies; /**< of the scene; NULL: none */
    sph2d__frozen_row *rows;    /**< pairs of particles with bodies, by particles */
    size_t row_count, row_capacity;
    SPH2D__ARRAY sph2d__close_row *close_rows;    /**< of close pairs in an implicit step, by particles ... */
    SPH2D__ARRAY size_t *first_close, *end_close; /**< ... where those of each begin and end ... */
    SPH2D__ARRAY size_t *close_starts;            /**< ... and those of each slab */
    size_t close_capacity;
    SPH2D__ARRAY double *left;   /**< s, by equal steps of K/Sigma from 0 on */
    SPH2D__ARRAY double *beyond; /**< the kernel's part beyond a plane, by the distance from it */
    SPH2D__ARRAY double *lift;   /**< its integral from there to H [m] */
    double nearness;             /**< the last K/Sigma there: that of a place on a surface */
    double uneven; /**< the difference of B's eigenvalues there over their sum: no particle has a larger one */
} sph2d__frozen;

/* r0 over dx: nearer pairs repel each other. R over rho0 c0^2 dx: two particles that meet at 0.18 c0 come to a stop. */
SPH2D__FIXED double SPH2D__CLOSE = 0.5, SPH2D__REPULSION = 0.2;
/** The most that Z is. */
SPH2D__FIXED double SPH2D__DAMPING = 0.1;
/* The least determinant of M of which B is the inverse: below it there are too few neighbours. */
SPH2D__FIXED double SPH2D__LEAST = 0.5;
/* Rate at which what is not linear in velocities fades, over c0/dx. */
SPH2D__FIXED double SPH2D__SMOOTHING = 0.1;

/** What boundary particle b adds to K and k over m of particle i, with the gradient and the distance of their pair. */
typedef struct sph2d__frozen_stick {
    double xx, xy, yy, x, y;
} sph2d__frozen_stick;

/** Of a slice: one of its particles has walls' pressures by a gradient, or a neighbour that has. */
enum { SPH2D__FROZEN_WALLED = 1, SPH2D__FROZEN_BESIDE = 2 };

/** Whether boundary particle b is between the domain's sides. */
static inline bool sph2d__within_sides(const sph2d__system *s, size_t b)
{
    const sph2d__store *w = &s->walls;
    const sph2d__sides *d = &s->frozen->sides;
    return w->x[b] > d->low_x && w->x[b] < d->high_x && w->y[b] > d->low_y && w->y[b] < d->high_y;
}

/** By how much more boundary particle b, at -r of particle i, presses on it, as part of a face that is thin: wcsph_sight.h. r is
 *  as rounded as in the lists. */
static inline double sph2d__thickness(const sph2d__system *s, size_t i, size_t b, float rx, float ry)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__store *w = &s->walls;
    const bool on_face = z->sight_x[i] * w->normal_x[b] + z->sight_y[i] * w->normal_y[b] > 0 &&
                         (double)rx * z->sight_x[i] + (double)ry * z->sight_y[i] > 0;
    return on_face && sph2d__within_sides(s, b) ? z->thicker[i] : 0;
}

/** The part of boundary particle b, at -r of particle i, in the walls that this is in front of: wcsph_front.h. */
static inline double sph2d__front_share(const sph2d__system *s, size_t i, size_t b, double gx, double gy, double rx,
                                        double ry)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__store *w = &s->walls;
    const bool before = rx * w->normal_x[b] + ry * w->normal_y[b] > w->depth[b];
    const double along = rx * w->normal_y[b] - ry * w->normal_x[b];
    return sph2d__within_sides(s, b) && before && along * along < s->spacing * s->spacing && z->front_weight[i] > 0
               ? sqrt(gx * gx + gy * gy) / z->front_weight[i]
               : 0;
}

#endif
