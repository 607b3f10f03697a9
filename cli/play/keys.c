/* SPDX-License-Identifier: MIT */
/** @file keys.c
 *  What keys do. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../templates.h"
#include "game.h"

/* The fields that colour the liquid, in turn. */
static const char *const colors[] = {NULL, "speed", "Pressures"};
enum { COLORS = sizeof colors / sizeof colors[0] };

const char game_help[] = "mouse: left uses the tool, right pushes, wheel: its reach\n"
                         "P pull  O pour  E wipe  W wall   1 to 4 scenes  R again\n"
                         "space pause  . one step  + - faster, slower\n"
                         "arrows gravity  0 no gravity\n"
                         "V B viscosity  T Y tension  K L stiffness\n"
                         "M metaballs, points  C colour\n"
                         "A as many particles as follow the clock\n"
                         "S save  F film  H this help  Q quit";

static void change_fluid(game *g, const sph2d_scene *scene, const char *name, double value, const char *unit)
{
    sph2d_report report = {0};
    const sph2d_status status = live_change(&g->live, scene, &report);
    game_tell_report(g, status, &report);
    if (status == SPH2D_OK)
        game_tell(g, "%s %.3g %s", name, value, unit);
}

/* A step of a factor of two, from `least` on or to 0 below it. */
static double scaled(double value, double factor, double least)
{
    if (value <= 0)
        return factor > 1 ? least : 0;
    value *= factor;
    return value < 0.99 * least ? 0 : value;
}

static void scale_viscosity(game *g, double factor)
{
    sph2d_scene scene = g->live.scene;
    scene.fluid.dynamic_viscosity = scaled(scene.fluid.dynamic_viscosity, factor, 1e-3);
    change_fluid(g, &scene, "viscosity", scene.fluid.dynamic_viscosity, "Pa s");
}

static void scale_tension(game *g, double factor)
{
    sph2d_scene scene = g->live.scene;
    scene.fluid.surface_tension = scaled(scene.fluid.surface_tension, factor, 1);
    change_fluid(g, &scene, "surface tension", scene.fluid.surface_tension, "N/m");
}

static void scale_stiffness(game *g, double factor)
{
    sph2d_scene scene = g->live.scene;
    const double now = scene.method.max_compression > 0 ? scene.method.max_compression : 0.01;
    scene.method.max_compression = fmin(fmax(now / factor, 1e-4), 0.2);
    change_fluid(g, &scene, "compression of at most", 100 * scene.method.max_compression, "%");
}

static void turn_gravity(game *g, double x, double y)
{
    const sph2d_vec2 own = sph2d_scene_file_scene(g->live.file)->gravity;
    const double size = hypot(own.x, own.y) > 0 ? hypot(own.x, own.y) : 9.81;
    g->live.scene.gravity = (sph2d_vec2){size * x, size * y};
    sph2d_sim_set_gravity(g->live.sim, g->live.scene.gravity);
}

static void next_color(game *g)
{
    size_t k = 0;
    while (k < COLORS && !(g->style.frames.color == colors[k] ||
                           (g->style.frames.color && colors[k] && strcmp(g->style.frames.color, colors[k]) == 0)))
        ++k;
    g->style.frames.color = colors[(k + 1) % COLORS];
    g->style.frames.color_range = (sph2d_vec2){0, 0};
    g->color_range = (sph2d_vec2){INFINITY, -INFINITY};
    game_tell(g, "colour: %s", g->style.frames.color ? g->style.frames.color : "one");
}

static void restart(game *g)
{
    sph2d_report report = {0};
    game_tell_report(g, live_restart(&g->live, 0, &report), &report);
}

/* Starts again at the spacing at which this machine follows the clock: in two dimensions the cost of simulated time goes
 * with the third power of the number of particles along a side. */
static void fit(game *g)
{
    static const double part = 0.7, most = 4; /* of the clock for steps; of change at once */
    if (!(g->live.pace > 0)) {
        game_tell(g, "let it run for a moment first");
        return;
    }
    sph2d_report report = {0};
    const double factor = cbrt(g->rate / (part * g->live.pace));
    const double spacing = g->live.scene.spacing * fmin(fmax(factor, 1 / most), most);
    const sph2d_status status = live_restart(&g->live, spacing, &report);
    game_tell_report(g, status, &report);
    if (status == SPH2D_OK) {
        game_take_scene(g);
        game_tell(g, "spacing %.3g m: %zu particles", spacing, sph2d_sim_fluid(g->live.sim).count);
    }
}

static void open_number(game *g, size_t number)
{
    sph2d_report report = {0};
    if (number < scene_template_count)
        game_tell_report(g, game_open_template(g, number, &report), &report);
}

static void one_step(game *g)
{
    sph2d_report report = {0};
    g->paused = true;
    game_tell_report(g, live_step(&g->live, &report), &report);
}

static void pick(game *g, hand_tool tool)
{
    g->hand.tool = tool;
    g->hand.corner_count = 0;
    game_tell(g, "tool: %s", hand_name(tool));
}

void game_key(game *g, int key)
{
    switch (key) {
    case 'P':
        pick(g, HAND_PULL);
        break;
    case 'O':
        pick(g, HAND_POUR);
        break;
    case 'E':
        pick(g, HAND_WIPE);
        break;
    case 'W':
        pick(g, HAND_WALL);
        break;
    case ' ':
        g->paused = !g->paused;
        break;
    case '.':
        one_step(g);
        break;
    case '+':
    case '=':
        g->rate = fmin(2 * g->rate, 64);
        break;
    case '-':
        g->rate = fmax(g->rate / 2, 1.0 / 1024);
        break;
    case PLAY_KEY_LEFT:
        turn_gravity(g, -1, 0);
        break;
    case PLAY_KEY_RIGHT:
        turn_gravity(g, 1, 0);
        break;
    case PLAY_KEY_UP:
        turn_gravity(g, 0, 1);
        break;
    case PLAY_KEY_DOWN:
        turn_gravity(g, 0, -1);
        break;
    case '0':
        turn_gravity(g, 0, 0);
        break;
    case 'V':
        scale_viscosity(g, 2);
        break;
    case 'B':
        scale_viscosity(g, 0.5);
        break;
    case 'T':
        scale_tension(g, 2);
        break;
    case 'Y':
        scale_tension(g, 0.5);
        break;
    case 'K':
        scale_stiffness(g, 2);
        break;
    case 'L':
        scale_stiffness(g, 0.5);
        break;
    case 'M':
        g->style.frames.style =
            g->style.frames.style == SPH2D_STYLE_POINTS ? SPH2D_STYLE_METABALLS : SPH2D_STYLE_POINTS;
        break;
    case 'C':
        next_color(g);
        break;
    case 'R':
        restart(g);
        break;
    case 'A':
        fit(g);
        break;
    case 'S':
        game_save(g);
        break;
    case 'F':
        game_film(g);
        break;
    case 'H':
        g->help = !g->help;
        break;
    case 'Q':
    case PLAY_KEY_ESCAPE:
        g->quits = true;
        break;
    default:
        if (key >= '1' && key <= '9')
            open_number(g, (size_t)(key - '1'));
        break;
    }
}
