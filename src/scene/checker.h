/* SPDX-License-Identifier: MIT */
/** @file checker.h
 *  Functions that the parts of the scene checker share. */
#ifndef SPH2D_SCENE_CHECKER_H
#define SPH2D_SCENE_CHECKER_H

#include "scene/motion.h"
#include "scene/world.h"

typedef struct sph2d__checker {
    const sph2d_scene *given; /**< as the caller gave it: for what is about keys that are left out */
    const sph2d_scene *scene; /**< that of the world; the given one until there is a world */
    const sph2d__world *world;
    sph2d_report *report;
    size_t errors; /**< counted here too, since the report may be NULL */
    bool broken;   /**< a list that cannot be read */
    bool started;  /**< the scene goes on from a state: where bodies start is past */
} sph2d__checker;

/** Size of a key path. */
enum { SPH2D__PATH_SIZE = 256 };

/** Counts and reports an error. Returns its diagnostic, for a hint; NULL without a report. */
sph2d_diagnostic *sph2d__check_fault(sph2d__checker *c, sph2d_code code, const char *path, const char *message);

/** "blocks[2].box" from "blocks", 2, ".box". */
const char *sph2d__check_path(char path[SPH2D__PATH_SIZE], const char *list, size_t index, const char *rest);

/** "obstacles[2].line", or "bodies[0].circle", of wall `index` of the checker's world. */
const char *sph2d__check_wall_path(const sph2d__checker *c, char path[SPH2D__PATH_SIZE], size_t index,
                                   const char *rest);

/** Hints at what to do about a wall that is in the way: `otherwise`, and that a line is thick by now. */
void sph2d__check_hint_wall(const sph2d__checker *c, sph2d_diagnostic *d, size_t index, const char *otherwise);

/** Whether a position is in the domain, up to round-off. */
bool sph2d__check_in_domain(const sph2d_scene *scene, sph2d_vec2 p);

/** Counts and reports a position outside the domain. */
void sph2d__check_outside(sph2d__checker *c, const char *path, sph2d_vec2 p);

/** Whether a rectangle is valid; counts and reports an error otherwise. */
bool sph2d__check_box(sph2d__checker *c, sph2d_box box, const char *path);

/** Checks the number of points of an outline. */
bool sph2d__check_count(sph2d__checker *c, sph2d_points points, const char *path);
/** Whether a polygon is valid; counts and reports an error otherwise. */
bool sph2d__check_polygon(sph2d__checker *c, sph2d_points corners, const char *path);

/** Reports a shape in a drawing, which is none until it is read. */
void sph2d__check_unread(sph2d__checker *c, const char *path);

/** Checks that the times of a path increase: `count` of them, `stride` numbers apart. */
void sph2d__check_times(sph2d__checker *c, const double *times, size_t count, size_t stride, const char *path);

/** Checks that an output's rate is given once, if at all. */
void sph2d__check_rate(sph2d__checker *c, sph2d_rate rate, const char *prefix);

/** Checks probe `index` of the scene. */
void sph2d__check_probe(sph2d__checker *c, size_t index);
void sph2d__check_frames(sph2d__checker *c);

/** Whether a name is one: 1 to 64 letters, digits, _ or -. */
bool sph2d__check_name(const char *name);

/** Checks every obstacle and body as the scene draws it, and the side of its liquid. */
void sph2d__check_obstacles(sph2d__checker *c);

/** Checks the keys of every obstacle's motion. */
void sph2d__check_motion_keys(sph2d__checker *c);
/** Checks that motions start in place, stay within walls and clear of obstacles, and warns of jumps of velocity. */
void sph2d__check_motions(sph2d__checker *c);

/** Follows the motion of wall `index` along its course; `hits` has room for a byte of each wall. */
void sph2d__check_way(sph2d__checker *c, size_t index, const sph2d__course *course, unsigned char *hits);

/** Checks every opening; obstacles are valid. */
void sph2d__check_openings(sph2d__checker *c);
/** Warns of an opening whose inflow does not go with the liquid before it; `filled`: liquid fills the domain. */
void sph2d__check_inflow(sph2d__checker *c, size_t i, bool filled);
/** Warns of openings and drains that no liquid can get to. */
void sph2d__check_reach(sph2d__checker *c);
void sph2d__check_liquid(sph2d__checker *checker);

/** Checks what the keys of every body say of its mass and freedoms. */
void sph2d__check_body_keys(sph2d__checker *c);
/** Checks the size, mass, springs and place of every body. */
void sph2d__check_bodies(sph2d__checker *c);

/** Warns of obstacles so thin that liquids on their two sides interact through them. */
void sph2d__check_thin(sph2d__checker *c);

/** Warns of channels that are too narrow for method `hybrid` (check_narrow.c). */
void sph2d__check_narrow(sph2d__checker *c);

/** Checks ranges, words and lists by the key table. */
void sph2d__check_ranges(sph2d__checker *c);

/** Checks the features of the method, and periodic sides. */
void sph2d__check_method(sph2d__checker *c);

/** Warns of scenes that their method is known to compute badly. */
void sph2d__check_weak(sph2d__checker *c);

/** Checks what the liquid of blocks and the scene starts with. */
void sph2d__check_starts(sph2d__checker *c);

/** Checks single particles, up to the first error. */
void sph2d__check_particles(sph2d__checker *c);

#endif
