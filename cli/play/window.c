/* SPDX-License-Identifier: MIT */
/** @file window.c
 *  The window by GLFW 3. */
#include "window.h"

#include <stdlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

struct play_window {
    GLFWwindow *handle;
    play_input input;
};

/* A key as play_input has it; 0 for others. */
static int key_of(int key)
{
    switch (key) {
    case GLFW_KEY_LEFT:
        return PLAY_KEY_LEFT;
    case GLFW_KEY_RIGHT:
        return PLAY_KEY_RIGHT;
    case GLFW_KEY_DOWN:
        return PLAY_KEY_DOWN;
    case GLFW_KEY_UP:
        return PLAY_KEY_UP;
    case GLFW_KEY_ESCAPE:
        return PLAY_KEY_ESCAPE;
    case GLFW_KEY_HOME:
        return PLAY_KEY_HOME;
    case GLFW_KEY_PAGE_UP:
        return PLAY_KEY_PAGE_UP;
    case GLFW_KEY_PAGE_DOWN:
    case GLFW_KEY_TAB:
        return PLAY_KEY_PAGE_DOWN;
    case GLFW_KEY_KP_ADD:
        return '+';
    case GLFW_KEY_KP_SUBTRACT:
        return '-';
    default:
        return key >= ' ' && key < 127 ? key : 0; /* GLFW names these by their characters */
    }
}

static void on_key(GLFWwindow *handle, int key, int scancode, int action, int modifiers)
{
    (void)scancode;
    play_window *w = glfwGetWindowUserPointer(handle);
    const bool undo = key == GLFW_KEY_Z && (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER));
    const int pressed = action != GLFW_PRESS ? 0 : undo ? 'U' : key_of(key);
    if (pressed != 0 && w->input.key_count < PLAY_MOST_KEYS)
        w->input.keys[w->input.key_count++] = pressed;
}

static void on_scroll(GLFWwindow *handle, double x, double y)
{
    (void)x;
    play_window *w = glfwGetWindowUserPointer(handle);
    const bool control = glfwGetKey(handle, GLFW_KEY_LEFT_CONTROL) == GLFW_PRESS ||
                         glfwGetKey(handle, GLFW_KEY_RIGHT_CONTROL) == GLFW_PRESS;
    *(control ? &w->input.zoom : &w->input.scroll) += y;
}

static sph2d_status refuse(sph2d_report *report, const char *what)
{
    const char *why = NULL;
    glfwGetError(&why);
    sph2d_diagnostic_hint(
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GL_FAILED, NULL, "%s: %s", what, why ? why : "unknown reason"),
        "it needs a display with OpenGL 3.3; 'sph2d run' draws frames without one");
    return SPH2D_RENDER;
}

sph2d_status play_window_open(unsigned width, unsigned height, const char *title, play_window **window,
                              sph2d_report *report)
{
    *window = NULL;
    play_window *w = calloc(1, sizeof *w);
    if (!w)
        return SPH2D_NOMEM;
    if (!glfwInit()) {
        free(w);
        return refuse(report, "no window can be opened");
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    w->handle = glfwCreateWindow((int)width, (int)height, title, NULL, NULL);
    if (!w->handle) {
        const sph2d_status status = refuse(report, "no window can be opened");
        glfwTerminate();
        free(w);
        return status;
    }
    glfwMakeContextCurrent(w->handle);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(w->handle, w);
    glfwSetInputMode(w->handle, GLFW_STICKY_MOUSE_BUTTONS, GLFW_TRUE); /* clicks shorter than a turn */
    glfwSetKeyCallback(w->handle, on_key);
    glfwSetScrollCallback(w->handle, on_scroll);
    *window = w;
    return SPH2D_OK;
}

void play_window_close(play_window *window)
{
    if (!window)
        return;
    glfwDestroyWindow(window->handle);
    glfwTerminate();
    free(window);
}

play_input play_window_poll(play_window *w, double patience)
{
    w->input = (play_input){0};
    /* A moving mouse wakes it many times. */
    const double end = glfwGetTime() + patience;
    for (double left = patience; left > 0; left = end - glfwGetTime())
        glfwWaitEventsTimeout(left);
    glfwPollEvents();
    int width = 0, height = 0, screen_width = 0, screen_height = 0;
    glfwGetFramebufferSize(w->handle, &width, &height);
    glfwGetWindowSize(w->handle, &screen_width, &screen_height);
    glfwGetCursorPos(w->handle, &w->input.x, &w->input.y);
    if (screen_width > 0 && screen_height > 0) { /* on fine screens a unit of the mouse has several pixels */
        w->input.x *= (double)width / screen_width;
        w->input.y *= (double)height / screen_height;
    }
    w->input.width = (unsigned)width;
    w->input.height = (unsigned)height;
    w->input.left = glfwGetMouseButton(w->handle, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
    w->input.middle = glfwGetMouseButton(w->handle, GLFW_MOUSE_BUTTON_MIDDLE) == GLFW_PRESS;
    w->input.right = glfwGetMouseButton(w->handle, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
    w->input.close = glfwWindowShouldClose(w->handle);
    return w->input;
}

void play_window_show(play_window *window)
{
    glfwSwapBuffers(window->handle);
}

sph2d_gl_loader play_window_loader(void)
{
    return glfwGetProcAddress;
}
