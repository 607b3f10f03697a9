/* SPDX-License-Identifier: MIT */
/** @file page.c
 *  Play in a browser: what the page's script calls. There is one game and one canvas, "#canvas". */
#define GL_GLEXT_PROTOTYPES
#include <emscripten.h>
#include <emscripten/html5.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../json.h"
#include "../play/turn.h"
#include "render/gl_loader.h"

static game the_game;
static turning the_turning;
static play_input input;
static bool open_once;
static char *answer; /* the last text that was returned */

/* Keeps a text until the next one is returned. */
static const char *answer_with(char *text)
{
    free(answer);
    answer = text;
    return answer ? answer : "";
}

/* What a scene's text gives: {"ok": true, "messages": [{"line": 3, ...}]}. */
static const char *answer_report(sph2d_status status, sph2d_report *report)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        return "";
    cli_json line = json_begin(out);
    json_flag(&line, "ok", status == SPH2D_OK);
    json_open_array(&line, "messages");
    if (status != SPH2D_OK && report->errors == 0)
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "%s", sph2d_status_text(status));
    for (size_t i = 0; i < report->count; ++i) {
        const sph2d_diagnostic *d = &report->items[i];
        json_open_object(&line, NULL);
        json_text(&line, "severity", d->severity == SPH2D_ERROR ? "error" : "warning");
        json_count(&line, "line", (uint64_t)d->line);
        json_count(&line, "column", (uint64_t)d->column);
        json_text(&line, "path", d->path);
        json_text(&line, "message", d->message);
        json_text(&line, "hint", d->hint);
        json_close_object(&line);
    }
    json_close_array(&line);
    json_end(&line);
    sph2d_report_clear(report);
    fclose(out);
    return answer_with(text);
}

/* ---- the functions of OpenGL by their names ---------------------------------------------------------------------- */

static bool asks = true;

/* Whether glGetError asks the browser, or says that there is no error; true at first. */
static void ask_for_errors(bool ask)
{
    asks = ask;
}

/* Asking for errors waits until the picture is drawn, in another process. */
static GLenum get_error(void)
{
    return asks ? glGetError() : GL_NO_ERROR;
}

/* An sph2d_gl_loader. The list is the renderer's own, since Emscripten's holds all there are, 50 kB of script. */
static sph2d_gl_function find_function(const char *name)
{
    static const struct row {
        const char *name;
        sph2d_gl_function function;
    } rows[] = {
#define ROW(function, type) {"gl" #function, (sph2d_gl_function)gl##function},
        SPH2D__GL_MAP(ROW)
#undef ROW
    };
    if (strcmp(name, "glGetError") == 0)
        return (sph2d_gl_function)get_error;
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; ++k)
        if (strcmp(rows[k].name, name) == 0)
            return rows[k].function;
    return NULL;
}

/* ---- the canvas -------------------------------------------------------------------------------------------------- */

/** Makes the canvas ready. False where the browser has no WebGL 2. */
EMSCRIPTEN_KEEPALIVE int page_start(void)
{
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.majorVersion = 2;
    wanted.antialias = wanted.depth = wanted.alpha = EM_FALSE;
    wanted.preserveDrawingBuffer = EM_TRUE; /* for pictures that are saved */
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_create_context("#canvas", &wanted);
    if (context <= 0 || emscripten_webgl_make_context_current(context) != EMSCRIPTEN_RESULT_SUCCESS)
        return false;
    static cli_options options;
    sph2d_sim_options sim_options = sph2d_sim_options_default();
    sim_options.threads = 1;
    the_game = game_new(&options, &sim_options);
    the_game.help = false;
    the_game.told_elsewhere = true;
    return true;
}

/* ---- scenes ------------------------------------------------------------------------------------------------------ */

EMSCRIPTEN_KEEPALIVE int page_scene_count(void)
{
    return (int)play_scene_count;
}

EMSCRIPTEN_KEEPALIVE const char *page_scene_name(int index)
{
    return play_scenes[index].name;
}

EMSCRIPTEN_KEEPALIVE const char *page_scene_text(int index)
{
    return play_scenes[index].text;
}

/** Opens the scene of a text, and tells what is wrong with it; the game goes on as it was then. */
EMSCRIPTEN_KEEPALIVE const char *page_open(const char *text, const char *name)
{
    static sph2d_report report;
    const sph2d_status status = game_open_text(&the_game, text, strlen(text), name, &report);
    open_once = open_once || status == SPH2D_OK;
    return answer_report(status, &report);
}

/** What is wrong with the scene of a text, without opening it. */
EMSCRIPTEN_KEEPALIVE const char *page_check(const char *text, const char *name)
{
    static sph2d_report report;
    sph2d_scene_file *file = NULL;
    sph2d_status status = sph2d_scene_file_parse(text, strlen(text), name, NULL, 0, &file, &report);
    if (status == SPH2D_OK) {
        sph2d_report_clear(&report); /* the check of the whole scene repeats warnings */
        status = sph2d_scene_check(sph2d_scene_file_scene(file), &report);
        for (size_t i = 0; i < report.count; ++i)
            sph2d_scene_file_locate(file, &report.items[i]);
    }
    sph2d_scene_file_destroy(file);
    return answer_report(status, &report);
}

/** The scene that is played, as text, with the changes since. */
EMSCRIPTEN_KEEPALIVE const char *page_text(void)
{
    const sph2d_scene scene = live_scene(&the_game.live);
    const size_t size = sph2d_scene_text(&scene, NULL, 0) + 1;
    char *text = malloc(size);
    if (text)
        sph2d_scene_text(&scene, text, size);
    return answer_with(text);
}

/** The name of the scene that is played; empty for none. */
EMSCRIPTEN_KEEPALIVE const char *page_name(void)
{
    return the_game.live.scene.name ? the_game.live.scene.name : "";
}

/* ---- turns ------------------------------------------------------------------------------------------------------- */

EMSCRIPTEN_KEEPALIVE void page_key(int key)
{
    if (input.key_count < PLAY_MOST_KEYS)
        input.keys[input.key_count++] = key;
}

/** Takes a hand_tool. */
EMSCRIPTEN_KEEPALIVE void page_pick(int tool)
{
    if (open_once)
        game_pick(&the_game, (hand_tool)tool);
}

/** Lets `seconds` pass, with the pointer at (x, y) [pixels of the canvas], its buttons: 1 left, 2 right, 4 middle, and
 *  turns of its wheel, without and with Ctrl. Returns false where drawing failed; page_told() says why. */
EMSCRIPTEN_KEEPALIVE int page_turn(double seconds, int width, int height, double x, double y, int buttons,
                                   double scroll, double zoom)
{
    static sph2d_report report;
    if (!open_once)
        return true;
    input.width = (unsigned)width;
    input.height = (unsigned)height;
    input.x = x;
    input.y = y;
    input.left = buttons & 1;
    input.right = buttons & 2;
    input.middle = buttons & 4;
    input.scroll = scroll;
    input.zoom = zoom;
    ask_for_errors(the_turning.shown ==
                   0); /* what can fail fails in the first picture, or the browser tells the page */
    const sph2d_status status = turn_take(&the_turning, &the_game, &input, find_function, seconds, &report);
    game_tell_report(&the_game, status, &report);
    turn_shown(&the_turning, &the_game);
    input.key_count = 0;
    return status == SPH2D_OK;
}

/** The message to the user that came since the last call; empty for none. */
EMSCRIPTEN_KEEPALIVE const char *page_told(void)
{
    static char told[sizeof the_game.message];
    memcpy(told, the_game.message, sizeof told);
    the_game.message[0] = '\0';
    return told;
}

/** Sets a game_quantity. */
EMSCRIPTEN_KEEPALIVE void page_set(int quantity, double value)
{
    if (open_once)
        game_set(&the_game, (game_quantity)quantity, value);
}

/** Numbers that tell how play goes: simulated time [s], particles, pictures a second, the pace against the clock, the time
 *  of a turn's steps and of its picture [s], steps so far, whether it is paused and whether it stopped; gravity,
 *  viscosity, surface tension, compression, rate and density as game_get() has them, the tool, and the
 *  particles that left through open sides. */
EMSCRIPTEN_KEEPALIVE const double *page_numbers(void)
{
    enum { NUMBERS = 17 };
    static double numbers[NUMBERS];
    if (!open_once)
        return numbers;
    const live *l = &the_game.live;
    const double all[NUMBERS] = {sph2d_sim_time(l->sim),
                                 (double)sph2d_sim_count(l->sim),
                                 the_turning.pictures,
                                 the_game.rate * l->ratio,
                                 the_turning.stepping,
                                 the_turning.drawing,
                                 (double)sph2d_sim_summary(l->sim).steps,
                                 the_game.paused,
                                 l->stopped != SPH2D_OK,
                                 game_get(&the_game, GAME_GRAVITY),
                                 game_get(&the_game, GAME_VISCOSITY),
                                 game_get(&the_game, GAME_TENSION),
                                 game_get(&the_game, GAME_COMPRESSION),
                                 game_get(&the_game, GAME_RATE),
                                 game_get(&the_game, GAME_DENSITY),
                                 the_game.hand.tool,
                                 (double)live_left(l)};
    memcpy(numbers, all, sizeof numbers);
    return numbers;
}

/** A number of the liquid's particles: x and y [m], then the velocity [m/s], for `index` 0 to 3. As many as page_numbers()
 *  tells, until the next turn. */
EMSCRIPTEN_KEEPALIVE const double *page_particles(int index)
{
    const sph2d_view fluid = sph2d_sim_fluid(the_game.live.sim);
    const double *const all[] = {fluid.x, fluid.y, fluid.vx, fluid.vy};
    return all[index & 3];
}

/** Where a body of the scene is: its centre of mass [m] and the angle by which it has turned [rad]; NaN for none. */
EMSCRIPTEN_KEEPALIVE const double *page_body(int index)
{
    static double place[3];
    const sph2d_body_state body = sph2d_sim_body(the_game.live.sim, (size_t)index);
    place[0] = body.center.x;
    place[1] = body.center.y;
    place[2] = body.angle;
    return place;
}
