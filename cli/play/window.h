/* SPDX-License-Identifier: MIT */
/** @file window.h
 *  A window with an OpenGL 3.3 context, its mouse and its keys. All of GLFW is behind this header. */
#ifndef SPH2D_CLI_PLAY_WINDOW_H
#define SPH2D_CLI_PLAY_WINDOW_H

#include <stdbool.h>

#include <sph2d/render.h>

typedef struct play_window play_window;

/** Keys that are no letters, digits or signs; the others are themselves, letters in upper case. */
enum {
    PLAY_KEY_LEFT = 256,
    PLAY_KEY_RIGHT,
    PLAY_KEY_DOWN,
    PLAY_KEY_UP,
    PLAY_KEY_ESCAPE,
    PLAY_KEY_HOME,
    PLAY_KEY_PAGE_UP,
    PLAY_KEY_PAGE_DOWN
};
enum { PLAY_MOST_KEYS = 16 };

/** What happened since the last call, and what is held down now. */
typedef struct play_input {
    bool close;
    unsigned width, height;   /**< of what is drawn [pixels]; 0 while the window is hidden */
    double x, y;              /**< the mouse, from the upper left corner [pixels] */
    bool left, middle, right; /**< its buttons */
    double scroll, zoom;      /**< turns of its wheel, positive away from the user; with Ctrl */
    int keys[PLAY_MOST_KEYS];
    int key_count;
} play_input;

/** Opens a window; its context is current. Errors: SPH2D_RENDER, with the reason: no display, for example. */
sph2d_status play_window_open(unsigned width, unsigned height, const char *title, play_window **window,
                              sph2d_report *report);
void play_window_close(play_window *window);

/** Waits for `patience` seconds, and tells what came. */
play_input play_window_poll(play_window *window, double patience);

/** Shows what was drawn into framebuffer 0. */
void play_window_show(play_window *window);

/** Finds OpenGL's functions for the renderer. */
sph2d_gl_loader play_window_loader(void);

#endif
