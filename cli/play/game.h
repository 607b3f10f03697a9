/* SPDX-License-Identifier: MIT */
/** @file game.h
 *  What is played: a live simulation, the hand, and how both are shown; and the scenes of its own. */
#ifndef SPH2D_CLI_PLAY_GAME_H
#define SPH2D_CLI_PLAY_GAME_H

#include <stddef.h>

#include "../film.h"
#include "../frame.h"
#include "../options.h"
#include "hand.h"
#include "window.h"

typedef struct game {
    const cli_options *options;
    sph2d_sim_options sim_options;
    live live;
    hand hand;
    frame_style style;
    frame_buffers buffers;
    sph2d_picture picture; /**< the next, of `buffers`, caption and notes */
    double picture_time;   /**< simulated [s] */
    bool prepared;         /**< there is one */
    char caption[240], notes[1200];
    sph2d_vec2 color_range; /**< of all that was shown of this field */
    sph2d_vec2 mouse;       /**< where it was [pixels] ... */
    bool pans;              /**< ... and whether it moved the view */
    double rate;            /**< simulated seconds for one of the clock */
    bool paused, help, quits;
    size_t number;                    /**< of the last of play_scenes that was opened; SIZE_MAX for none */
    int fits_in;                      /**< pictures until game_fit(); 0: never */
    bool leaks;                       /**< that liquid left was told */
    bool told_elsewhere;              /**< messages are not for the picture */
    char message[400];                /**< the last thing to tell ... */
    double told;                      /**< ... and when, on the clock [s] */
    bool films;                       /**< the next picture begins a film */
    char recording[32];               /**< the name of a film, or of the folder of its frames; empty for none */
    film film;                        /**< open where ffmpeg makes it */
    unsigned film_width, film_height; /**< [pixels] */
    unsigned recorded;                /**< frames */
    double next_frame;                /**< simulated time of the next one [s] */
} game;

/** Without a scene yet. */
game game_new(const cli_options *options, const sph2d_sim_options *sim_options);
void game_close(game *g);

/** Shows a message for some seconds; a failure's first diagnostic, and drops the report. */
__attribute__((format(printf, 2, 3))) void game_tell(game *g, const char *format, ...);
void game_tell_report(game *g, sph2d_status status, sph2d_report *report);

/** Starts a scene, and takes the file also after a failure. Errors: as sph2d_sim_create; the game goes on as it was. */
sph2d_status game_open_file(game *g, sph2d_scene_file *file, sph2d_report *report);

/** Starts the scene of a text under a name. Errors: as sph2d_scene_file_parse and game_open_file. */
sph2d_status game_open_text(game *g, const char *text, size_t length, const char *name, sph2d_report *report);

/** Starts one of play_scenes, to be fitted after some pictures unless `-s spacing` is given. Errors: as game_open_text. */
sph2d_status game_open_number(game *g, size_t number, sph2d_report *report);

/** Starts again with as many particles as step in this part of the time of the clock, 16,384 at most. */
void game_fit(game *g, double part);

/** Sets what follows from a new scene: style, reach of the hand. */
void game_take_scene(game *g);

/** What mouse and keys do, some lines. */
extern const char game_help[];

/** Frames of a film for each second of it. */
enum { GAME_FILM_RATE = 30 };

/** Keeps the scene with its liquid, and begins or ends a film: files here, downloads on a page. */
void game_save(game *g);
void game_film(game *g);
void game_film_end(game *g);
/** Adds the prepared picture to the film when its time has come; a film ends where the window gets another size. */
void game_film_frame(game *g, sph2d_renderer *renderer, unsigned width, unsigned height);

/** What can be set while it runs: the size of gravity [m/s^2], viscosity [Pa s], surface tension [N/m], the largest
 *  compression (a part of the density), the rate, simulated seconds for one of the clock, and the density of bodies that
 *  are drawn, over the liquid's. */
typedef enum game_quantity {
    GAME_GRAVITY,
    GAME_VISCOSITY,
    GAME_TENSION,
    GAME_COMPRESSION,
    GAME_RATE,
    GAME_DENSITY
} game_quantity;
double game_get(const game *g, game_quantity quantity);
void game_set(game *g, game_quantity quantity, double value);

/** Sets gravity [m/s^2]; and its size in the scene's file, or on Earth where that has none. */
void game_pull(game *g, double x, double y);
double game_usual_gravity(const game *g);

/** Goes back to before the last act. */
void game_undo(game *g);

/** Takes a tool, and tells which. */
void game_pick(game *g, hand_tool tool);

/** Does what a key says. */
void game_key(game *g, int key);

/** Moves and scales the view as the mouse says; and goes back to the scene's own. */
void game_look(game *g, const sph2d_renderer *renderer, const play_input *input);
void game_look_home(game *g);

/** Moves the hand to where the mouse is in the last picture. */
void game_hand(game *g, const sph2d_renderer *renderer, const play_input *input);

/** Tells what came of steps: their status, and whether liquid leaves. */
void game_tell_steps(game *g, sph2d_status status, sph2d_report *report);

/** Prepares a picture of the game as it is, with the number of pictures a second. */
void game_prepare(game *g, double pictures);

/** Draws it into the window's framebuffer, of this size [pixels], also while a thread steps the simulation; a film
 *  that is recorded gets its frame. */
void game_draw(game *g, sph2d_renderer *renderer, unsigned width, unsigned height);

/* ---- the scenes of its own, generated from cli/play/scenes: the keys 1 to 9, and more ---------------------------- */

typedef struct play_scene {
    const char *name, *text; /* "dam_break", and its YAML */
} play_scene;

extern const play_scene play_scenes[];
extern const size_t play_scene_count;

#endif
