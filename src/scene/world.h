/* SPDX-License-Identifier: MIT */
/** @file world.h
 *  A scene, resolved: a copy in which every default has its value, all that bounds the liquid as one list of walls, and
 *  what follows from both. It is made once, by sph2d__world_make(), which checks the scene on the way; plans, simulations,
 *  probes and pictures read it. */
#ifndef SPH2D_SCENE_WORLD_H
#define SPH2D_SCENE_WORLD_H

#include "base/memory.h"
#include "sph2d/scene.h"

/** Numbers of walls: the sides of the domain, then from SPH2D__WALL_OBSTACLE on all others. */
enum {
    SPH2D__WALL_LEFT,
    SPH2D__WALL_RIGHT,
    SPH2D__WALL_BOTTOM,
    SPH2D__WALL_TOP,
    SPH2D__WALL_OBSTACLE,
    SPH2D__WALL_ALL = -1 /**< in place of one: all of them */
};

/** What a wall is. */
typedef enum sph2d__wall_kind {
    SPH2D__WALL_IS_SIDE,
    SPH2D__WALL_IS_OBSTACLE,
    SPH2D__WALL_IS_BESIDE_OPENING, /**< solid beside openings of a side, as far as their reservoirs reach */
    SPH2D__WALL_IS_BODY,
} sph2d__wall_kind;

/** A wall. Sides have no shape: they are lines of the domain, and need not be walls (sph2d__side_of). */
typedef struct sph2d__wall {
    sph2d__wall_kind kind;
    size_t index;          /**< in the scene's list of obstacles or bodies; of a side, and beside one, its number */
    const char *name;      /**< NULL: none; of a side, and beside one, its word */
    const char *shape_key; /**< ".line": of its shape in the scene, even where a line has become a polygon */
    sph2d_shape shape;
    sph2d_liquid_side liquid;
    sph2d_wall_form form;
    sph2d_slip slip;
    double restitution;
    sph2d_motion motion;    /**< at rest, but for obstacles */
    const sph2d_body *body; /**< NULL, but for bodies */
} sph2d__wall;

/** Gravity of a scene without what a tank adds: its size [m/s^2], and the unit vector against it, 0 without any. */
typedef struct sph2d__gravity_direction {
    double size;
    sph2d_vec2 up;
} sph2d__gravity_direction;

/** What follows from a scene (derive.h). */
typedef struct sph2d__derived {
    double support_radius; /**< H = support_ratio * spacing [m] */
    double reach;          /**< search radius: H, with surface tension at least two outer radii of its band [m] */
    double mass;           /**< of a particle, density * spacing^2 [kg/m] */
    double gravity;        /**< largest gravity, with the acceleration of a tank that moves [m/s^2] */
    double height;         /**< largest height of liquid above the lowest point that it can reach, along gravity [m] */
    double speed;          /**< largest speed at the start, of a source, of a wall, or by springs of a body [m/s] */
    double pull; /**< depth of attractive potentials [m^2/s^2]: acceleration * radius / 2 of the strongest interaction,
                    and that of the central force at the farthest liquid */
    double head; /**< |g| height + speed^2 / 2 + pull: pressure over density that the liquid can build up [m^2/s^2] */
    double spring_head;      /**< the part of that by what only springs of bodies make fast [m^2/s^2] */
    double spring_energy;    /**< of springs of bodies at the start [J/m] */
    double capillary_head;   /**< pressure of surface tension in the thinnest block, over density [m^2/s^2] */
    double ripple_speed;     /**< minimum c0 for surface tension, sqrt(8 sigma/(rho0 dx)) [m/s] */
    double soft_compression; /**< compression for which c0 is chosen: max_compression, for pcisph a tenth of it */
    double stiffness_part;   /**< c0^2 over the stiffness k: 1, for muller the factor of its pair force */
    double natural_speed;    /**< c0 by the head and surface tension alone [m/s] */
    double sound_speed;      /**< c0 [m/s]: by the scene, or that; 0 when neither gives one */
} sph2d__derived;

typedef struct sph2d__world {
    sph2d_scene scene; /**< a deep copy; lines that liquid wets on both sides are polygons */
    sph2d__wall *walls;
    size_t wall_count, first_body; /**< bodies are the last ones, in their order */
    size_t wall_room;              /**< for how many there is room, solids beside openings among them */
    sph2d_box box;                 /**< the domain with the reservoirs of openings */
    sph2d__gravity_direction gravity;
    sph2d__derived derived;
} sph2d__world;

/** Checks a scene and resolves it into `world`, whose lists are in `arena`. `started`: the scene goes on from a state, so
 *  that where bodies start is past. Errors: SPH2D_SCENE, SPH2D_NOMEM; then only the arena is to be freed. */
sph2d_status sph2d__world_make(sph2d__world *world, const sph2d_scene *scene, bool started, sph2d__arena *arena,
                               sph2d__memory *memory, sph2d_report *report);

/** First part of it: copies the scene, with the method's defaults, and lists its walls as it draws them. Errors:
 *  SPH2D_NOMEM. */
sph2d_status sph2d__world_copy(sph2d__world *world, const sph2d_scene *scene, sph2d__arena *arena,
                               sph2d__memory *memory);
/** Copies `from` with all its lists and strings into `arena` (copy.c). False when memory is short. */
bool sph2d__scene_copy(const sph2d_scene *from, sph2d__arena *arena, sph2d__memory *memory, sph2d_scene *to);

/** The word of a side, 0 to 3: "left". */
const char *sph2d__side_word(int side);
/** What a side is. */
sph2d_side sph2d__side_of(const sph2d_scene *scene, int side);
/** Whether any side is of a kind. */
bool sph2d__has_side(const sph2d_scene *scene, sph2d_side kind);
/** Whether a side, by its number or its name, is left or right. */
static inline bool sph2d__side_is_vertical(int side)
{
    return side == SPH2D__WALL_LEFT || side == SPH2D__WALL_RIGHT;
}
/** The slip that the scene gives a side, and its speed along itself [m/s]. */
sph2d_wall_slip sph2d__side_own_slip(const sph2d_scene *scene, int side);
double sph2d__side_speed(const sph2d_scene *scene, int side);
/** How far a point is within a side of a rectangle, negative beyond it [m]. */
double sph2d__side_distance(const sph2d_box *box, int side, sph2d_vec2 point);

/** The same for the nearest side that is a wall; INFINITY without one [m]. */
double sph2d__walled_distance(const sph2d_scene *scene, const sph2d_box *box, sph2d_vec2 point);

/** The wall of a name: a side's word, or that of an obstacle or body; SPH2D__WALL_ALL if there is none. */
int sph2d__wall_named(const sph2d__world *world, const char *name);

/** "obstacles[2].line", "bodies[0].circle", "boundary.left": the key of a wall and `rest`, which sides and what lies beside
 *  openings do without; at most `size` bytes. */
const char *sph2d__wall_path(char *path, size_t size, const sph2d__wall *wall, const char *rest);

/** Whether a wall ever moves: by its motion, or as a body; and whether it ever turns. */
bool sph2d__wall_moves(const sph2d__wall *wall);
bool sph2d__wall_turns(const sph2d__wall *wall);

/** The form of a scene's sides, and of an obstacle that has `form`; bodies have the default one. */
sph2d_wall_form sph2d__side_form(const sph2d_scene *scene);
sph2d_wall_form sph2d__obstacle_form(const sph2d_method_options *method, sph2d_wall_form form);

/** Which slips the generalised walls of the world have, a bit for each sph2d_slip; without such walls wall_slip. */
unsigned sph2d__wall_slips(const sph2d__world *world);

#endif
