/* SPDX-License-Identifier: MIT */
/** @file keys.c
 *  What keys do. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "game.h"

/* The fields that colour the liquid, in turn. */
static const char *const colors[] = {NULL, "speed", "Pressures", "vorticity"};
enum { COLORS = sizeof colors / sizeof colors[0] };

#ifdef SPH2D__SMALL /* as in src/render/lines.c */
#define STREAMLINES_HELP ""
#else
#define STREAMLINES_HELP "Z streamlines  "
#endif

const char game_help[] = "mouse: left uses the tool or holds a body, right pushes, wheel: reach\n"
                         "Ctrl and wheel: zoom  middle: move the view  Home: all\n"
                         "P pull  G push  O pour  , its colour  E wipe  W wall  D body: circle, box, outline\n"
                         "J hinge (click), spring (drag)  [ ] density of bodies\n"
                         "a click or right with W, D, J takes away\n"
                         "U or Ctrl-Z undo (ten acts)  R again\n"
                         "1 to 9, Tab, PageUp, PageDown: scenes\n"
                         "space pause  . one step  + - faster, slower\n"
                         "arrows gravity  0 no gravity\n"
                         "V B viscosity  T Y tension  K L stiffness\n"
                         "M metaballs, points  N look  C colour\n"
                         "X arrows  " STREAMLINES_HELP "I isolines of pressure\n"
                         "A as many particles as follow the clock\n"
                         "S save  F film  H this help  Q quit";

/* The first step from none [Pa s], [N/m]. */
static const double LEAST_VISCOSITY = 1e-3, LEAST_TENSION = 1;

/* A step of a factor of two, from `least` on or to 0 below it. */
static double scaled(double value, double factor, double least)
{
    if (value <= 0)
        return factor > 1 ? least : 0;
    value *= factor;
    return value < 0.99 * least ? 0 : value;
}

/* Multiplies what can be set. */
static void scale(game *g, game_quantity quantity, double factor, double least)
{
    game_set(g, quantity, scaled(game_get(g, quantity), factor, least));
}

static void turn_gravity(game *g, double x, double y)
{
    const double size = game_usual_gravity(g);
    game_pull(g, size * x, size * y);
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

/* Of what is poured, in turn, from that of the scene on. */
static void next_dye(game *g)
{
    static const char *const dyes[] = {"crimson", "orange", "gold", "green", "turquoise", "purple", "white"};
    enum { DYES = sizeof dyes / sizeof dyes[0] };
    const double before = g->live.nozzle.color;
    uint32_t rgb = 0;
    size_t k = 0;
    while (before > 0 && k < DYES && sph2d_color_parse(dyes[k++], &rgb) && rgb != before)
        ;
    g->live.nozzle.color = k < DYES && sph2d_color_parse(dyes[k], &rgb) ? rgb : 0;
    game_tell(g, "pours %s", k < DYES ? dyes[k] : "the colour of the scene");
}

static void next_look(game *g)
{
    enum { LOOKS = SPH2D_LOOK_INK + 1 };
    static const char *const names[LOOKS] = {"water", "flat", "glass", "ink"};
    sph2d_frames *frames = &g->style.frames;
    frames->look = (sph2d_look)((frames->look + 1) % LOOKS);
    frames->style = SPH2D_STYLE_METABALLS; /* points have none */
    game_tell(g, "look: %s", names[frames->look]);
}

/* Arrows or streamlines. */
static void switch_lines(game *g, sph2d_switch *lines)
{
    sph2d_frames *frames = &g->style.frames;
    *lines = *lines == SPH2D_SWITCH_ON ? SPH2D_SWITCH_OFF : SPH2D_SWITCH_ON;
    if (frames->arrow_speed == 0) /* the same in all pictures */
        frames->arrow_speed = sqrt(2 * sph2d_sim_plan(g->live.sim)->head);
}

static void switch_isolines(game *g)
{
    sph2d_frames *frames = &g->style.frames;
    const double tenth = g->live.scene.fluid.density * sph2d_sim_plan(g->live.sim)->head / 10;
    const double power = tenth > 0 ? pow(10, floor(log10(tenth))) : 1;
    frames->isolines = frames->isolines ? NULL : "Pressures";
    frames->isoline_step = power * round(tenth / power); /* the same in all pictures */
}

static void restart(game *g)
{
    sph2d_report report = {0};
    live_remember(&g->live, "again");
    const sph2d_status status = live_restart(&g->live, 0, &report);
    game_tell_report(g, status, &report);
    if (status != SPH2D_OK)
        past_drop(&g->live.past);
}

/* Starts again at the spacing at which this machine follows the clock. */
static void fit(game *g)
{
    static const double part = 0.7, most = 4; /* of the clock for steps; of change at once */
    if (!(g->live.pace > 0)) {
        game_tell(g, "let it run for a moment first");
        return;
    }
    sph2d_report report = {0};
    const double now = g->live.scene.spacing;
    const double spacing = fmin(fmax(live_fitting_spacing(&g->live, part / g->rate), now / most), now * most);
    live_remember(&g->live, "fit");
    const sph2d_status status = live_restart(&g->live, spacing, &report);
    game_tell_report(g, status, &report);
    if (status != SPH2D_OK)
        past_drop(&g->live.past);
    else {
        game_take_scene(g);
        game_tell(g, "spacing %.3g m: %zu particles", spacing, sph2d_sim_count(g->live.sim));
    }
}

static void open_number(game *g, size_t number)
{
    sph2d_report report = {0};
    if (number >= play_scene_count)
        return;
    const sph2d_status status = game_open_number(g, number, &report);
    game_tell_report(g, status, &report);
    if (status == SPH2D_OK)
        game_tell(g, "scene %zu of %zu: %s", number + 1, play_scene_count, g->live.scene.name);
}

static void one_step(game *g)
{
    sph2d_report report = {0};
    g->paused = true;
    game_tell_report(g, live_step(&g->live, &report), &report);
}

void game_pick(game *g, hand_tool tool)
{
    if (tool != g->hand.tool)
        game_tell(g, "tool: %s", hand_name(tool));
    hand_take(&g->hand, tool);
}

static bool tool_key(game *g, int key)
{
    const hand_tool tool = g->hand.tool;
    switch (key) {
    case 'P':
        game_pick(g, HAND_PULL);
        return true;
    case 'G':
        game_pick(g, HAND_PUSH);
        return true;
    case 'O':
        game_pick(g, HAND_POUR);
        return true;
    case 'E':
        game_pick(g, HAND_WIPE);
        return true;
    case 'W':
        game_pick(g, HAND_WALL);
        return true;
    case 'D': /* in turn */
        game_pick(g, tool < HAND_CIRCLE || tool >= HAND_OUTLINE ? HAND_CIRCLE : tool + 1);
        return true;
    case 'J':
        game_pick(g, HAND_HOLD);
        return true;
    case '[':
        game_set(g, GAME_DENSITY, game_get(g, GAME_DENSITY) / 1.25);
        return true;
    case ']':
        game_set(g, GAME_DENSITY, game_get(g, GAME_DENSITY) * 1.25);
        return true;
    default:
        return false;
    }
}

/* What the liquid is and what pulls it. */
static bool liquid_key(game *g, int key)
{
    switch (key) {
    case PLAY_KEY_LEFT:
        turn_gravity(g, -1, 0);
        return true;
    case PLAY_KEY_RIGHT:
        turn_gravity(g, 1, 0);
        return true;
    case PLAY_KEY_UP:
        turn_gravity(g, 0, 1);
        return true;
    case PLAY_KEY_DOWN:
        turn_gravity(g, 0, -1);
        return true;
    case '0':
        turn_gravity(g, 0, 0);
        return true;
    case 'V':
        scale(g, GAME_VISCOSITY, 2, LEAST_VISCOSITY);
        return true;
    case 'B':
        scale(g, GAME_VISCOSITY, 0.5, LEAST_VISCOSITY);
        return true;
    case 'T':
        scale(g, GAME_TENSION, 2, LEAST_TENSION);
        return true;
    case 'Y':
        scale(g, GAME_TENSION, 0.5, LEAST_TENSION);
        return true;
    case 'K':
        scale(g, GAME_COMPRESSION, 0.5, 0);
        return true;
    case 'L':
        scale(g, GAME_COMPRESSION, 2, 0);
        return true;
    default:
        return false;
    }
}

static bool look_key(game *g, int key)
{
    sph2d_frames *frames = &g->style.frames;
    switch (key) {
    case 'M':
        frames->style = frames->style == SPH2D_STYLE_POINTS ? SPH2D_STYLE_METABALLS : SPH2D_STYLE_POINTS;
        return true;
    case 'N':
        next_look(g);
        return true;
    case 'X':
        switch_lines(g, &frames->arrows);
        return true;
#ifndef SPH2D__SMALL
    case 'Z':
        switch_lines(g, &frames->streamlines);
        return true;
#endif
    case 'I':
        switch_isolines(g);
        return true;
    case 'C':
        next_color(g);
        return true;
    case ',':
        next_dye(g);
        return true;
    case PLAY_KEY_HOME:
        game_look_home(g);
        return true;
    case 'H':
        g->help = !g->help;
        return true;
    default:
        return false;
    }
}

/* The clock, and what is kept. */
static void run_key(game *g, int key)
{
    switch (key) {
    case ' ':
        g->paused = !g->paused;
        break;
    case '.':
        one_step(g);
        break;
    case '+':
    case '=':
        scale(g, GAME_RATE, 2, 0);
        break;
    case '-':
        scale(g, GAME_RATE, 0.5, 0);
        break;
    case 'U':
        game_undo(g);
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
    case PLAY_KEY_PAGE_DOWN: /* SIZE_MAX + 1 is 0 */
        open_number(g, (g->number + 1) % play_scene_count);
        break;
    case PLAY_KEY_PAGE_UP:
        open_number(g, (g->number < play_scene_count && g->number > 0 ? g->number : play_scene_count) - 1);
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

void game_key(game *g, int key)
{
    if (!tool_key(g, key) && !liquid_key(g, key) && !look_key(g, key))
        run_key(g, key);
}
