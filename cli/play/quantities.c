/* SPDX-License-Identifier: MIT */
/** @file quantities.c
 *  What keys and sliders set while a scene runs. */
#include <math.h>

#include "game.h"

/* The acceleration of Earth, where a scene has none [m/s^2]. */
static const double EARTH = 9.81;

/* The compression that a scene without one has. */
static const double USUAL_COMPRESSION = 0.01;

double game_get(const game *g, game_quantity quantity)
{
    const sph2d_scene *scene = &g->live.scene;
    switch (quantity) {
    case GAME_GRAVITY:
        return hypot(scene->gravity.x, scene->gravity.y);
    case GAME_VISCOSITY:
        return scene->fluid.dynamic_viscosity;
    case GAME_TENSION:
        return scene->fluid.surface_tension;
    case GAME_COMPRESSION:
        return scene->method.max_compression > 0 ? scene->method.max_compression : USUAL_COMPRESSION;
    case GAME_RATE:
        return g->rate;
    case GAME_DENSITY:
        return g->hand.density;
    }
    return 0;
}

void game_pull(game *g, double x, double y)
{
    const sph2d_vec2 now = g->live.scene.gravity;
    if (x == now.x && y == now.y) /* as by a key that is held */
        return;
    live_remember(&g->live, "gravity");
    g->live.scene.gravity = (sph2d_vec2){x, y};
    sph2d_sim_set_gravity(g->live.sim, g->live.scene.gravity);
}

double game_usual_gravity(const game *g)
{
    const sph2d_vec2 own = sph2d_scene_file_scene(g->live.file)->gravity;
    const double size = hypot(own.x, own.y);
    return size > 0 ? size : EARTH;
}

/* The same direction with another size; downwards where there was none. */
static void scale_gravity(game *g, double value)
{
    const sph2d_vec2 now = g->live.scene.gravity;
    const double size = hypot(now.x, now.y);
    if (size > 0)
        game_pull(g, now.x / size * value, now.y / size * value);
    else
        game_pull(g, 0, -value);
}

static void change_fluid(game *g, const sph2d_scene *scene, const char *name, double value, const char *unit)
{
    sph2d_report report = {0};
    live_remember(&g->live, name);
    const sph2d_status status = live_change(&g->live, scene, &report);
    game_tell_report(g, status, &report);
    if (status == SPH2D_OK)
        game_tell(g, "%s %.3g %s", name, value, unit);
    else
        past_drop(&g->live.past);
}

void game_set(game *g, game_quantity quantity, double value)
{
    sph2d_scene scene = g->live.scene;
    switch (quantity) {
    case GAME_GRAVITY:
        scale_gravity(g, value);
        break;
    case GAME_VISCOSITY:
        scene.fluid.dynamic_viscosity = value;
        change_fluid(g, &scene, "viscosity", value, "Pa s");
        break;
    case GAME_TENSION:
        scene.fluid.surface_tension = value;
        change_fluid(g, &scene, "surface tension", value, "N/m");
        break;
    case GAME_COMPRESSION:
        scene.method.max_compression = fmin(fmax(value, 1e-4), 0.2);
        change_fluid(g, &scene, "compression at most", 100 * scene.method.max_compression, "%");
        break;
    case GAME_RATE:
        g->rate = fmin(fmax(value, 1.0 / 1024), 64);
        break;
    case GAME_DENSITY: /* within what is tested */
        g->hand.density = fmin(fmax(value, 0.05), 20);
        game_tell(g, "bodies of %.3g kg/m^3", g->hand.density * scene.fluid.density);
        break;
    }
}
