/* SPDX-License-Identifier: MIT */
/** @file game.c
 *  What is played: scenes, keys, and the picture. */
#include "game.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "../clock.h"
#include "../exit.h"
#include "../message.h"
#include "../scene_input.h"
#include "../templates.h"

/* How long a message is shown [s]; frames of a film for each of its seconds. */
static const double MESSAGE_TIME = 4, FILM_RATE = 30;

static const char *const colors[] = {NULL, "speed", "Pressures"};
enum { COLORS = sizeof colors / sizeof colors[0] };

__attribute__((format(printf, 2, 3))) static void tell(game *g, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(g->message, sizeof g->message, format, arguments);
    va_end(arguments);
    g->told = clock_wall();
}

/* Tells the first diagnostic of a failure, and drops the report. */
static void tell_report(game *g, sph2d_status status, sph2d_report *report)
{
    if (status != SPH2D_OK && report->count > 0)
        tell(g, "%s", report->items[0].message);
    else if (status != SPH2D_OK)
        tell(g, "%s", sph2d_status_text(status));
    sph2d_report_clear(report);
}

/* ---- scenes ------------------------------------------------------------------------------------------------------ */

/* Sets what follows from a new scene. */
static void take_scene(game *g)
{
    frame_style style = frame_style_of_scene(sph2d_sim_scene(g->live.sim));
    style.name = g->live.scene.name; /* the file's: simulations come and go */
    style.frames.caption = SPH2D_SWITCH_ON;
    style.frames.style = g->options->style_given ? g->options->style : style.frames.style;
    style.frames.color = g->options->color ? g->options->color : style.frames.color;
    g->style = style;
    g->color_range = (sph2d_vec2){INFINITY, -INFINITY};
    g->hand = hand_for(&g->live.scene);
}

static sph2d_status open_file(game *g, sph2d_scene_file *file, sph2d_report *report)
{
    live next;
    const sph2d_status status = live_open(&next, file, &g->sim_options, report);
    if (status != SPH2D_OK) {
        live_close(&next);
        return status;
    }
    live_close(&g->live);
    g->live = next;
    take_scene(g);
    return SPH2D_OK;
}

/* Templates are played by the method that takes the longest steps, 2 % compressible, but for what --set says. */
static const sph2d_override PLAYED[] = {{"method.name", "constraint"}, {"method.max_compression", "0.02"}};
enum { PLAYED_COUNT = sizeof PLAYED / sizeof PLAYED[0] };

static sph2d_status open_template(game *g, size_t index, sph2d_report *report)
{
    const scene_template *from = &scene_templates[index];
    size_t length = 0, count = g->options->override_count;
    sph2d_scene_file *file = NULL;
    char *text = scene_template_text(from, from->name, &length);
    sph2d_override *overrides = malloc((PLAYED_COUNT + count) * sizeof *overrides);
    sph2d_status status = SPH2D_NOMEM;
    if (text && overrides) {
        memcpy(overrides, PLAYED, sizeof PLAYED);
        if (count > 0)
            memcpy(overrides + PLAYED_COUNT, g->options->overrides, count * sizeof *overrides);
        status = sph2d_scene_file_parse(text, length, from->name, overrides, PLAYED_COUNT + count, &file, report);
    }
    free(overrides);
    free(text);
    return status == SPH2D_OK ? open_file(g, file, report) : status;
}

int game_open(game *g, const cli_options *options, const sph2d_sim_options *sim_options)
{
    *g = (game){.options = options, .sim_options = *sim_options, .rate = 1, .help = true};
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    sph2d_status status;
    if (options->operand_count == 0)
        status = open_template(g, 0, &report);
    else {
        status = scene_input_read(options, &file, &report);
        if (status == SPH2D_OK) {
            sph2d_report_clear(&report); /* creating the simulation repeats warnings */
            status = open_file(g, file, &report);
        }
    }
    message_report(status, &report, g->live.file);
    return exit_of_status(status);
}

void game_close(game *g)
{
    live_close(&g->live);
    frame_free(&g->buffers);
    free(g->corners);
    free(g->marks);
}

/* ---- keys -------------------------------------------------------------------------------------------------------- */

static const char help[] = "mouse: left uses the tool, right pushes, wheel: its reach\n"
                           "P pull  O pour  E wipe  W wall   1 to 4 scenes  R again\n"
                           "space pause  . one step  + - faster, slower\n"
                           "arrows gravity  0 no gravity\n"
                           "V B viscosity  T Y tension  K L stiffness\n"
                           "M metaballs, points  C colour\n"
                           "A as many particles as follow the clock\n"
                           "S save  F film  H this help  Q quit";

/* A folder that does not exist yet, NAME_000 and on; false with a message where none can be made. */
static bool make_folder(game *g, const char *name, char out[32])
{
    for (int k = 0; k < 1000; ++k) {
        snprintf(out, 32, "%.20s_%03d", name, k);
        if (mkdir(out, 0777) == 0)
            return true;
        struct stat there;
        if (stat(out, &there) != 0)
            break;
    }
    tell(g, "cannot make a folder '%.20s_000' here", name);
    return false;
}

static void save(game *g)
{
    char folder[32];
    sph2d_report report = {0};
    if (!make_folder(g, "played", folder))
        return;
    const sph2d_status status = live_save(&g->live, folder, &report);
    tell_report(g, status, &report);
    if (status == SPH2D_OK)
        tell(g, "saved in '%s': scene.yaml, and a snapshot that 'sph2d resume %s' goes on from", folder, folder);
}

static void film(game *g)
{
    if (g->recording[0] != '\0') {
        tell(g, "%u frames in '%s': ffmpeg -framerate %g -i %s/frame_%%06d.png film.mp4", g->recorded, g->recording,
             FILM_RATE, g->recording);
        g->recording[0] = '\0';
    } else if (make_folder(g, "film", g->recording)) {
        g->recorded = 0;
        g->next_frame = sph2d_sim_time(g->live.sim);
        tell(g, "filming into '%s'; F ends it", g->recording);
    } else {
        g->recording[0] = '\0';
    }
}

static void change_fluid(game *g, const sph2d_scene *scene, const char *name, double value, const char *unit)
{
    sph2d_report report = {0};
    const sph2d_status status = live_change(&g->live, scene, &report);
    tell_report(g, status, &report);
    if (status == SPH2D_OK)
        tell(g, "%s %.3g %s", name, value, unit);
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
    tell(g, "colour: %s", g->style.frames.color ? g->style.frames.color : "one");
}

static void restart(game *g)
{
    sph2d_report report = {0};
    tell_report(g, live_restart(&g->live, 0, &report), &report);
}

/* Starts again at the spacing at which this machine follows the clock: in two dimensions the cost of simulated time goes
 * with the third power of the number of particles along a side. */
static void fit(game *g)
{
    static const double part = 0.7, most = 4; /* of the clock for steps; of change at once */
    if (!(g->live.pace > 0)) {
        tell(g, "let it run for a moment first");
        return;
    }
    sph2d_report report = {0};
    const double factor = cbrt(g->rate / (part * g->live.pace));
    const double spacing = g->live.scene.spacing * fmin(fmax(factor, 1 / most), most);
    const sph2d_status status = live_restart(&g->live, spacing, &report);
    tell_report(g, status, &report);
    if (status == SPH2D_OK) {
        take_scene(g);
        tell(g, "spacing %.3g m: %zu particles", spacing, sph2d_sim_fluid(g->live.sim).count);
    }
}

static void open_number(game *g, size_t number)
{
    sph2d_report report = {0};
    if (number < scene_template_count)
        tell_report(g, open_template(g, number, &report), &report);
}

static void one_step(game *g)
{
    sph2d_report report = {0};
    g->paused = true;
    tell_report(g, live_step(&g->live, &report), &report);
}

static void pick(game *g, hand_tool tool)
{
    g->hand.tool = tool;
    g->hand.corner_count = 0;
    tell(g, "tool: %s", hand_name(tool));
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
        save(g);
        break;
    case 'F':
        film(g);
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

/* ---- the loop's turns -------------------------------------------------------------------------------------------- */

void game_hand(game *g, const sph2d_renderer *renderer, const play_input *input)
{
    sph2d_report report = {0};
    hand_scale(&g->hand, input->scroll);
    sph2d_vec2 at;
    if (!sph2d_renderer_locate(renderer, input->x, input->y, &at))
        return;
    tell_report(g, hand_move(&g->hand, &g->live, at, input->left, input->right, &report), &report);
}

void game_advance(game *g, double seconds, double budget)
{
    sph2d_report report = {0};
    if (!g->paused)
        tell_report(g, live_advance(&g->live, seconds * g->rate, budget, &report), &report);
}

/* The line below the picture. */
static void write_caption(const game *g, double pictures, char *out, size_t size)
{
    const live *l = &g->live;
    char pace[64];
    if (l->stopped != SPH2D_OK)
        snprintf(pace, sizeof pace, "stopped; R starts again");
    else if (g->paused)
        snprintf(pace, sizeof pace, "paused");
    else
        snprintf(pace, sizeof pace, "%.2f x the clock", g->rate * l->ratio);
    snprintf(out, size, "%.40s   t = %.2f s   %s   %zu particles   %.0f pictures/s   %s%s",
             g->style.name ? g->style.name : "", sph2d_sim_time(l->sim), pace, sph2d_sim_fluid(l->sim).count, pictures,
             hand_name(g->hand.tool), g->recording[0] ? "   filming" : "");
}

/* Makes the picture, with a range of colours that only widens. */
static sph2d_status make_picture(game *g, sph2d_picture *picture, sph2d_report *report)
{
    const particle_source source = {.sim = g->live.sim};
    frame_style style = g->style;
    if (style.frames.color && style.frames.color_range.x == 0 && style.frames.color_range.y == 0) {
        sph2d_status status = frame_widen_range(&source, &style, &g->buffers, &g->color_range, report);
        if (status != SPH2D_OK)
            return status;
        if (g->color_range.x < g->color_range.y)
            style.frames.color_range = g->color_range;
    }
    return frame_make(&source, &style, &g->buffers, picture, report);
}

/* Adds the reach of the hand while it acts, and the wall that it draws, as lines. */
static sph2d_status add_hand(game *g, sph2d_picture *picture)
{
    enum { CIRCLE = 49 };
    const hand *h = &g->hand;
    const size_t own = picture->outline_count, most = own + CIRCLE + HAND_MOST_CORNERS;
    if (most > g->corner_capacity) {
        double *corners = realloc(g->corners, 2 * most * sizeof *corners);
        g->corners = corners ? corners : g->corners;
        uint64_t *marks = realloc(g->marks, 2 * most * sizeof *marks);
        g->marks = marks ? marks : g->marks;
        if (!corners || !marks)
            return SPH2D_NOMEM;
        g->corner_capacity = most;
    }
    double *x = g->corners, *y = x + most;
    uint64_t *id = g->marks, *liquid = id + most, next = own > 0 ? picture->outline_id[own - 1] + 1 : 0;
    size_t count = own;
    memcpy(x, picture->outline_x, own * sizeof *x);
    memcpy(y, picture->outline_y, own * sizeof *y);
    memcpy(id, picture->outline_id, own * sizeof *id);
    memcpy(liquid, picture->outline_liquid, own * sizeof *liquid);
    for (size_t k = 0; k < CIRCLE && (h->down || h->pushes) && h->tool != HAND_WALL; ++k, ++count) {
        const double angle = 6.283185307179586 * (double)(k % (CIRCLE - 1)) / (CIRCLE - 1);
        x[count] = h->at.x + h->radius * cos(angle);
        y[count] = h->at.y + h->radius * sin(angle);
        id[count] = next;
        liquid[count] = SPH2D_OUTLINE_LIQUID_BOTH;
    }
    for (size_t k = 0; k < h->corner_count; ++k, ++count) {
        x[count] = h->corners[k].x;
        y[count] = h->corners[k].y;
        id[count] = next + 1;
        liquid[count] = SPH2D_OUTLINE_LIQUID_BOTH;
    }
    picture->outline_count = count;
    picture->outline_x = x;
    picture->outline_y = y;
    picture->outline_id = id;
    picture->outline_liquid = liquid;
    return SPH2D_OK;
}

/* Writes a frame of the film when its time has come. */
static void record(game *g, sph2d_renderer *renderer, const sph2d_picture *picture)
{
    if (g->recording[0] == '\0' || sph2d_sim_time(g->live.sim) < g->next_frame)
        return;
    sph2d_report report = {0};
    char path[64];
    snprintf(path, sizeof path, "%s/frame_%06u.png", g->recording, g->recorded);
    sph2d_picture frame = *picture;
    frame.notes = NULL;
    sph2d_status status = sph2d_renderer_draw(renderer, &frame, &report);
    if (status == SPH2D_OK)
        status = sph2d_renderer_write_png(renderer, path, &report);
    g->recorded += status == SPH2D_OK;
    g->next_frame += g->rate / FILM_RATE;
    if (status != SPH2D_OK)
        g->recording[0] = '\0';
    tell_report(g, status, &report);
}

void game_show(game *g, sph2d_renderer *renderer, double pictures)
{
    sph2d_report report = {0};
    sph2d_picture picture;
    char caption[240], notes[sizeof help + sizeof g->message];
    sph2d_status status = make_picture(g, &picture, &report);
    write_caption(g, pictures, caption, sizeof caption);
    const bool news = g->message[0] != '\0' && clock_wall() - g->told < MESSAGE_TIME;
    snprintf(notes, sizeof notes, "%s%s%s", news ? g->message : "", news && g->help ? "\n" : "", g->help ? help : "");
    if (status == SPH2D_OK)
        status = add_hand(g, &picture);
    picture.caption = caption;
    picture.notes = notes[0] != '\0' ? notes : NULL;
    if (status == SPH2D_OK)
        record(g, renderer, &picture);
    if (status == SPH2D_OK)
        status = sph2d_renderer_draw_to(renderer, 0, 0, 0, &picture, &report);
    tell_report(g, status, &report);
}
