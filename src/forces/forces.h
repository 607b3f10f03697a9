/* SPDX-License-Identifier: MIT */
/** @file forces.h
 *  The forces on a particle that its place and velocity alone determine, one file each, and the table of them: a row
 *  makes a force act in every method, and books its energy. A force NAME has
 *
 *      sph2d__NAME                what it is, a struct
 *      NAME_set(f, scene, c0)     sets it for the start of a scene, with the speed of sound [m/s]
 *      NAME_acts(f)               whether it does anything
 *      NAME_add(f, at, ax, ay)    adds its acceleration [m/s^2]
 *      NAME_potential(f, x, y)    the potential of what of it has one [J/kg]
 *      NAME_drives(f)             whether something of it has none
 *      NAME_drive(f, at, ax, ay)  adds the acceleration of that: add = drive - grad potential
 *
 *  and a word in the table for where the work of `drive` goes: WORK, external work, or LOSS, heat. */
#ifndef SPH2D_FORCES_FORCES_H
#define SPH2D_FORCES_FORCES_H

#include "forces/central.h"
#include "forces/frame.h"
#include "forces/gravity.h"
#include "forces/points.h"
#include "forces/springs.h"

/** In the order in which they are added. */
#define SPH2D__FORCES(X)                                                                                               \
    X(gravity, WORK)                                                                                                   \
    X(central, WORK)                                                                                                   \
    X(frame, WORK)                                                                                                     \
    X(springs, LOSS)                                                                                                   \
    X(points, WORK)

/** What the work of a force without a potential is. */
typedef enum sph2d__work_kind { SPH2D__WORK, SPH2D__LOSS } sph2d__work_kind;

typedef struct sph2d__forces {
#define SPH2D__FORCE_MEMBER(name, kind) sph2d__##name name;
    SPH2D__FORCES(SPH2D__FORCE_MEMBER)
#undef SPH2D__FORCE_MEMBER
} sph2d__forces;

/** Sets all for the start of a scene. */
static inline void sph2d__forces_set(sph2d__forces *forces, const sph2d_scene *scene, double sound_speed)
{
#define SPH2D__FORCE_SET(name, kind) sph2d__##name##_set(&forces->name, scene, sound_speed);
    SPH2D__FORCES(SPH2D__FORCE_SET)
#undef SPH2D__FORCE_SET
}

/** Adds the accelerations by all [m/s^2]. */
static inline void sph2d__forces_add(const sph2d__forces *forces, sph2d__place at, double *ax, double *ay)
{
#define SPH2D__FORCE_ADD(name, kind)                                                                                   \
    if (sph2d__##name##_acts(&forces->name))                                                                           \
        sph2d__##name##_add(&forces->name, at, ax, ay);
    SPH2D__FORCES(SPH2D__FORCE_ADD)
#undef SPH2D__FORCE_ADD
}

/** Sum of the potentials [J/kg]. */
static inline double sph2d__forces_potential(const sph2d__forces *forces, double x, double y)
{
    double sum = 0;
#define SPH2D__FORCE_POTENTIAL(name, kind)                                                                             \
    if (sph2d__##name##_acts(&forces->name))                                                                           \
        sum += sph2d__##name##_potential(&forces->name, x, y);
    SPH2D__FORCES(SPH2D__FORCE_POTENTIAL)
#undef SPH2D__FORCE_POTENTIAL
    return sum;
}

/** Whether some force whose work is of a kind has no potential. */
static inline bool sph2d__forces_drive_at_all(const sph2d__forces *forces, sph2d__work_kind of)
{
    bool drive = false;
#define SPH2D__FORCE_DRIVES(name, kind) drive = drive || (SPH2D__##kind == of && sph2d__##name##_drives(&forces->name));
    SPH2D__FORCES(SPH2D__FORCE_DRIVES)
#undef SPH2D__FORCE_DRIVES
    return drive;
}

/** Adds the accelerations by forces without a potential whose work is of a kind [m/s^2]. */
static inline void sph2d__forces_drive(const sph2d__forces *forces, sph2d__work_kind of, sph2d__place at, double *ax,
                                       double *ay)
{
#define SPH2D__FORCE_DRIVE(name, kind)                                                                                 \
    if (SPH2D__##kind == of && sph2d__##name##_drives(&forces->name))                                                  \
        sph2d__##name##_drive(&forces->name, at, ax, ay);
    SPH2D__FORCES(SPH2D__FORCE_DRIVE)
#undef SPH2D__FORCE_DRIVE
}

/** Whether forces differ from place to place, or with velocity: all but gravity. */
static inline bool sph2d__forces_vary(const sph2d__forces *forces)
{
    sph2d__forces others = *forces;
    others.gravity.x = others.gravity.y = 0;
    bool vary = false;
#define SPH2D__FORCE_ACTS(name, kind) vary = vary || sph2d__##name##_acts(&others.name);
    SPH2D__FORCES(SPH2D__FORCE_ACTS)
#undef SPH2D__FORCE_ACTS
    return vary;
}

#endif
