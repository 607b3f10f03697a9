/* SPDX-License-Identifier: MIT */
/** @file openings.c
 *  Openings: where they are, what they prescribe, and the reservoirs and solids that they add to a world. */
#include "scene/openings.h"

#include <math.h>
#include <string.h>

#include "scene/cubic.h"
#include "scene/motion.h"
#include "scene/resolve.h"
#include "scene/shape.h"

const sph2d_opening *sph2d__opening_named(const sph2d_scene *scene, const char *name)
{
    for (size_t i = 0; i < scene->opening_count; ++i)
        if (scene->openings[i].name && strcmp(scene->openings[i].name, name) == 0)
            return &scene->openings[i];
    return NULL;
}

sph2d__mouth sph2d__opening_mouth(const sph2d_scene *scene, const sph2d_opening *opening)
{
    const sph2d_box *d = &scene->domain;
    bool vertical = sph2d__side_is_vertical((int)opening->side);
    double low = vertical ? d->min.y : d->min.x, high = vertical ? d->max.y : d->max.x;
    double from = isnan(opening->from) ? low : opening->from, to = isnan(opening->to) ? high : opening->to;
    switch (opening->side) {
    case SPH2D_SIDE_NAME_LEFT:
        return (sph2d__mouth){{d->min.x, from}, {0, 1}, {1, 0}, to - from};
    case SPH2D_SIDE_NAME_RIGHT:
        return (sph2d__mouth){{d->max.x, from}, {0, 1}, {-1, 0}, to - from};
    case SPH2D_SIDE_NAME_BOTTOM:
        return (sph2d__mouth){{from, d->min.y}, {1, 0}, {0, 1}, to - from};
    case SPH2D_SIDE_NAME_TOP:
    default:
        return (sph2d__mouth){{from, d->max.y}, {1, 0}, {0, -1}, to - from};
    }
}

/* ---- profiles ---------------------------------------------------------------------------------------------------- */

/* Doubles from one point to the next. */
enum { STRIDE = sizeof(sph2d_path_point) / sizeof(double) };

size_t sph2d__profile_places(const sph2d_path *profile)
{
    size_t count = 1;
    while (count < profile->count && profile->items[count].t == profile->items[0].t)
        ++count;
    return count;
}

double sph2d__profile_velocity(const sph2d_path *profile, double place, double time)
{
    size_t places = sph2d__profile_places(profile), last = profile->count / places - 1, k = 0;
    while (k < last && profile->items[(k + 1) * places].t <= time)
        ++k;
    const sph2d_path_point *now = &profile->items[k * places], *next = k < last ? now + places : now;
    double part = k < last ? fmax((time - now->t) / (next->t - now->t), 0) : 0, velocity = 0;
    sph2d__cubic c = sph2d__cubic_at(&now->x, STRIDE, places, place);
    for (size_t i = c.first; i < c.first + c.count; ++i)
        velocity += c.weight[i - c.first] * (now[i].y + part * (next[i].y - now[i].y));
    return velocity;
}

/* Two points of Gauss in each interval are exact for cubics. */
double sph2d__profile_mean(const sph2d_path *profile, double from, double to, double time)
{
    size_t places = sph2d__profile_places(profile);
    double sum = 0, off = 0.5 / sqrt(3);
    for (size_t i = 0; i <= places; ++i) {
        double low = i > 0 ? fmin(fmax(profile->items[i - 1].x, from), to) : from;
        double high = i < places ? fmin(fmax(profile->items[i].x, from), to) : to;
        double middle = (low + high) / 2, width = high - low;
        if (width > 0)
            sum += width / 2 *
                   (sph2d__profile_velocity(profile, middle - off * width, time) +
                    sph2d__profile_velocity(profile, middle + off * width, time));
    }
    return sum / (to - from);
}

double sph2d__profile_largest(const sph2d_path *profile)
{
    double largest = 0;
    for (size_t i = 0; i < profile->count; ++i)
        largest = fmax(largest, fabs(profile->items[i].y));
    return largest;
}

/* The parabola is Poiseuille's. The turbulent one is the power law with the exponent 1/7 on both sides of the middle line
 * (Prandtl 1921; Schlichting, Boundary-Layer Theory, chapter 20), whose mean is 7/8 of its largest value. */
double sph2d__profile_shape(sph2d_opening_profile profile, double z)
{
    z = fmin(fmax(z, 0), 1);
    switch (profile) {
    case SPH2D_OPENING_PROFILE_PARABOLA:
        return 6 * z * (1 - z);
    case SPH2D_OPENING_PROFILE_TURBULENT:
        return 8.0 / 7 * pow(1 - fabs(2 * z - 1), 1.0 / 7);
    case SPH2D_OPENING_PROFILE_UNIFORM:
        break;
    }
    return 1;
}

double sph2d__profile_peak(sph2d_opening_profile profile)
{
    return sph2d__profile_shape(profile, 0.5);
}

/* ---- what is prescribed ------------------------------------------------------------------------------------------ */

const sph2d_history *sph2d__opening_history(const sph2d_opening *opening, sph2d__opening_kind kind)
{
    const sph2d_history *of[] = {&opening->history.velocity, &opening->history.flow_rate, &opening->history.pressure,
                                 &opening->history.level};
    return of[kind];
}

sph2d__opening_kind sph2d__opening_kind_of(const sph2d_opening *opening)
{
    const double values[] = {opening->velocity, opening->flow_rate, opening->pressure, opening->level};
    int kind = SPH2D__OPENING_VELOCITY;
    while (opening->history.profile.count == 0 && kind < SPH2D__OPENING_LEVEL && isnan(values[kind]) &&
           sph2d__opening_history(opening, (sph2d__opening_kind)kind)->count == 0)
        ++kind;
    return (sph2d__opening_kind)kind;
}

bool sph2d__opening_has_velocity(const sph2d_opening *opening)
{
    sph2d__opening_kind kind = sph2d__opening_kind_of(opening);
    return kind == SPH2D__OPENING_VELOCITY || kind == SPH2D__OPENING_FLOW_RATE;
}

bool sph2d__opening_has_surface(const sph2d_opening *opening)
{
    return sph2d__opening_kind_of(opening) == SPH2D__OPENING_LEVEL || opening->free_surface == SPH2D_SWITCH_ON;
}

static double history_at(const sph2d_history *history, double time)
{
    const sph2d_vec2 *p = history->items, *last = &p[history->count - 1];
    if (time <= p->x)
        return p->y;
    while (p < last && time >= p[1].x)
        ++p;
    return p == last ? p->y : p->y + (time - p->x) / (p[1].x - p->x) * (p[1].y - p->y);
}

/** Grows from 0 to 1 over a ramp, with a continuous acceleration. */
static double ramp_at(double ramp, double time)
{
    double z = ramp > 0 ? fmin(time / ramp, 1) : 1;
    return z * z * z * (10 - 15 * z + 6 * z * z);
}

double sph2d__opening_value(const sph2d_scene *scene, const sph2d_opening *opening, double time)
{
    sph2d__opening_kind kind = sph2d__opening_kind_of(opening);
    const sph2d_history *history = sph2d__opening_history(opening, kind);
    const double values[] = {opening->velocity, opening->flow_rate, opening->pressure, opening->level};
    double value = history->count > 0 ? history_at(history, time) : values[kind];
    if (opening->history.profile.count > 0) {
        sph2d__mouth m = sph2d__opening_mouth(scene, opening);
        double from = m.along.y > 0 ? m.start.y : m.start.x;
        value = sph2d__profile_mean(&opening->history.profile, from, from + m.width, time);
    }
    return sph2d__opening_has_velocity(opening) ? value * ramp_at(opening->ramp, time) : value;
}

double sph2d__opening_velocity_at(const sph2d__mouth *mouth, const sph2d_opening *opening, double mean, double along,
                                  double time)
{
    const sph2d_path *profile = &opening->history.profile;
    along = fmin(fmax(along, 0), mouth->width);
    if (profile->count == 0)
        return mean * sph2d__profile_shape(opening->profile, along / mouth->width);
    double place = along + (mouth->along.y > 0 ? mouth->start.y : mouth->start.x);
    return sph2d__profile_velocity(profile, place, time) * ramp_at(opening->ramp, time);
}

double sph2d__opening_largest(const sph2d_opening *opening)
{
    sph2d__opening_kind kind = sph2d__opening_kind_of(opening);
    const sph2d_history *history = sph2d__opening_history(opening, kind);
    const double values[] = {opening->velocity, opening->flow_rate, opening->pressure, opening->level};
    if (opening->history.profile.count > 0)
        return sph2d__profile_largest(&opening->history.profile);
    if (history->count == 0)
        return kind == SPH2D__OPENING_LEVEL ? opening->level : fabs(values[kind]);
    double largest = -INFINITY;
    for (size_t i = 0; i < history->count; ++i)
        largest = fmax(largest, kind == SPH2D__OPENING_LEVEL ? history->items[i].y : fabs(history->items[i].y));
    return largest;
}

double sph2d__opening_velocity(const sph2d_scene *scene, const sph2d_opening *opening, double time)
{
    double value = sph2d__opening_value(scene, opening, time);
    bool rate = sph2d__opening_kind_of(opening) == SPH2D__OPENING_FLOW_RATE;
    return rate ? value / sph2d__opening_mouth(scene, opening).width : value;
}

/** The depth at which a velocity or flow rate is critical: u^2 = g h (Chow 1959, Open-Channel Hydraulics, eq. 3-10). */
static double critical_depth(const sph2d_scene *scene, sph2d__opening_kind kind, double value)
{
    double g = hypot(scene->gravity.x, scene->gravity.y);
    return kind == SPH2D__OPENING_FLOW_RATE ? cbrt(value * value / g) : value * value / g;
}

double sph2d__opening_critical_depth(const sph2d_scene *scene, const sph2d_opening *opening, double time)
{
    double depth = critical_depth(scene, sph2d__opening_kind_of(opening), sph2d__opening_value(scene, opening, time));
    return fmin(depth, sph2d__opening_mouth(scene, opening).width / 2);
}

double sph2d__opening_highest(const sph2d_scene *scene, const sph2d_opening *opening)
{
    sph2d__mouth m = sph2d__opening_mouth(scene, opening);
    sph2d__opening_kind kind = sph2d__opening_kind_of(opening);
    double most = sph2d__opening_largest(opening);
    if (kind == SPH2D__OPENING_LEVEL)
        return most - m.start.y;
    /* behind a weir or a jump liquid stands some critical depths high; what it holds at the start counts by itself */
    return fmin(3 * critical_depth(scene, kind, most), m.width);
}

double sph2d__opening_speed(const sph2d_scene *scene, const sph2d_opening *opening)
{
    if (!sph2d__opening_has_velocity(opening))
        return 0;
    double largest = sph2d__opening_largest(opening);
    if (sph2d__opening_kind_of(opening) == SPH2D__OPENING_FLOW_RATE)
        largest /= sph2d__opening_has_surface(opening) ? critical_depth(scene, SPH2D__OPENING_FLOW_RATE, largest)
                                                       : sph2d__opening_mouth(scene, opening).width;
    return largest > 0 ? largest * sph2d__profile_peak(opening->profile) : 0;
}

/* ---- reservoirs -------------------------------------------------------------------------------------------------- */

/* Particles in the domain feel a reservoir as far as the support reaches, and what these know of their own neighbours
 * reaches as far again. */
static const double SUPPORTS = 2;

size_t sph2d__reservoir_rows(const sph2d_scene *scene)
{
    return (size_t)ceil(SUPPORTS * sph2d__scene_reach(scene) / scene->spacing) + 1;
}

double sph2d__reservoir_length(const sph2d_scene *scene)
{
    double room = ceil(sph2d__scene_reach(scene) / scene->spacing) + 1;
    return (SPH2D__DUCT + (double)sph2d__reservoir_rows(scene) + room) * scene->spacing;
}

/* ---- the larger domain ------------------------------------------------------------------------------------------- */

/** A solid box beyond a side, over [low, high] along it. */
static sph2d__wall solid_beside(const sph2d__world *world, sph2d_side_name side, double low, double high)
{
    const sph2d_box *d = &world->scene.domain, *all = &world->box;
    const sph2d_obstacle plain = sph2d_obstacle_default();
    sph2d__wall solid = {.kind = SPH2D__WALL_IS_BESIDE_OPENING,
                         .index = (size_t)side,
                         .name = sph2d__side_word((int)side),
                         .shape_key = sph2d__shape_key(SPH2D_SHAPE_BOX),
                         .form = sph2d__obstacle_form(&world->scene.method, plain.form),
                         .slip = world->walls[side].slip,
                         .restitution = plain.restitution,
                         .motion = plain.motion};
    sph2d_box *b = &solid.shape.box;
    *b = sph2d__side_is_vertical((int)side) ? (sph2d_box){{0, low}, {0, high}} : (sph2d_box){{low, 0}, {high, 0}};
    switch (side) {
    case SPH2D_SIDE_NAME_LEFT:
        b->min.x = all->min.x, b->max.x = d->min.x;
        break;
    case SPH2D_SIDE_NAME_RIGHT:
        b->min.x = d->max.x, b->max.x = all->max.x;
        break;
    case SPH2D_SIDE_NAME_BOTTOM:
        b->min.y = all->min.y, b->max.y = d->min.y;
        break;
    case SPH2D_SIDE_NAME_TOP:
        b->min.y = d->max.y, b->max.y = all->max.y;
        break;
    }
    solid.shape.kind = SPH2D_SHAPE_BOX;
    return solid;
}

/** The first end at or after `at` along a side of an opening that begins there; NULL if none does. */
static const sph2d_opening *next_opening(const sph2d_scene *scene, sph2d_side_name side, double at)
{
    const sph2d_opening *next = NULL;
    double least = INFINITY;
    for (size_t i = 0; i < scene->opening_count; ++i) {
        const sph2d_opening *o = &scene->openings[i];
        sph2d__mouth m = sph2d__opening_mouth(scene, o);
        double from = sph2d__side_is_vertical((int)side) ? m.start.y : m.start.x;
        if (o->side == side && from >= at && from < least) {
            least = from;
            next = o;
        }
    }
    return next;
}

/** Adds the solids beyond a side that has openings, and returns their number. The outer ones go on to the corners of
 *  the larger domain. */
static size_t fill_side(const sph2d__world *world, sph2d_side_name side, sph2d__wall *solids)
{
    const sph2d_scene *scene = &world->scene;
    const sph2d_box *all = &world->box;
    const sph2d_boundary *sides = &scene->boundary;
    bool vertical = sph2d__side_is_vertical((int)side);
    const sph2d_box *d = &scene->domain;
    double low = vertical ? d->min.y : d->min.x, high = vertical ? d->max.y : d->max.x;
    double first = vertical ? all->min.y : all->min.x, last = vertical ? all->max.y : all->max.x;
    double beyond = last - first; /* as far as walls go on beyond open sides */
    first -= (vertical ? sides->bottom : sides->left) == SPH2D_SIDE_OPEN ? beyond : 0;
    last += (vertical ? sides->top : sides->right) == SPH2D_SIDE_OPEN ? beyond : 0;
    double slack = 1e-9 * scene->spacing, at = low - slack;
    size_t count = 0;
    for (const sph2d_opening *o; (o = next_opening(scene, side, at)) != NULL;) {
        sph2d__mouth m = sph2d__opening_mouth(scene, o);
        double from = vertical ? m.start.y : m.start.x;
        double begin = at < low ? (from > low + slack ? first : from) : at;
        if (from > begin + slack)
            solids[count++] = solid_beside(world, side, begin, from);
        at = from + m.width;
    }
    if (high > at + slack)
        solids[count++] = solid_beside(world, side, at, last);
    return count;
}

bool sph2d__side_has_opening(const sph2d_scene *scene, int side)
{
    for (size_t i = 0; i < scene->opening_count; ++i)
        if ((int)scene->openings[i].side == side)
            return true;
    return false;
}

void sph2d__add_reservoirs(sph2d__world *world)
{
    const sph2d_scene *scene = &world->scene;
    if (scene->opening_count == 0)
        return;
    double depth = sph2d__reservoir_length(scene);
    world->box.min.x -= sph2d__side_has_opening(scene, SPH2D__WALL_LEFT) ? depth : 0;
    world->box.max.x += sph2d__side_has_opening(scene, SPH2D__WALL_RIGHT) ? depth : 0;
    world->box.min.y -= sph2d__side_has_opening(scene, SPH2D__WALL_BOTTOM) ? depth : 0;
    world->box.max.y += sph2d__side_has_opening(scene, SPH2D__WALL_TOP) ? depth : 0;
    const size_t bodies = world->wall_count - world->first_body; /* the list has room for all: world.c */
    sph2d__wall *beside = world->walls + world->first_body, *end = world->walls + world->wall_room;
    memmove(end - bodies, beside, bodies * sizeof *beside);
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        if (sph2d__side_has_opening(scene, side))
            world->first_body += fill_side(world, (sph2d_side_name)side, world->walls + world->first_body);
    memmove(world->walls + world->first_body, end - bodies, bodies * sizeof *beside);
    world->wall_count = world->first_body + bodies;
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        if (sph2d__side_has_opening(scene, side))
            world->walls[side].slip = SPH2D_SLIP_FREE; /* the end of a reservoir does not brake what flows */
}
