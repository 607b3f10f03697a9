/* SPDX-License-Identifier: MIT */
/** @file check_openings.c
 *  Checks openings: what they prescribe, where they are, and whether they can balance. */
#include <math.h>
#include <stdio.h>

#include "scene/checker.h"
#include "scene/liquid.h"
#include "scene/motion.h"
#include "scene/openings.h"

typedef sph2d__checker checker;

/* Smallest width of an opening [spacings]: less is a row or two, whose pressure and velocity cannot be measured. */
static const double MIN_WIDTH = 3;

static const char *const kind_words[] = {"velocity", "flow_rate", "pressure", "level"};

/** Checks the points of a history. */
static void check_history(checker *c, size_t i, int kind)
{
    const sph2d_history *h = sph2d__opening_history(&c->scene->openings[i], (sph2d__opening_kind)kind);
    char path[SPH2D__PATH_SIZE], key[32];
    snprintf(key, sizeof key, ".history.%s", kind_words[kind]);
    sph2d__check_times(c, h->count > 0 ? &h->items[0].x : NULL, h->count, 2,
                       sph2d__check_path(path, "openings", i, key));
}

/** Checks that an opening prescribes one thing. False otherwise. */
static bool check_one(checker *c, size_t i)
{
    const sph2d_opening *o = &c->scene->openings[i];
    char path[SPH2D__PATH_SIZE];
    int numbers = !isnan(o->velocity) + !isnan(o->flow_rate) + !isnan(o->pressure) + !isnan(o->level);
    int lists = o->history.profile.count > 0;
    for (int kind = 0; kind <= SPH2D__OPENING_LEVEL; ++kind)
        lists += sph2d__opening_history(o, (sph2d__opening_kind)kind)->count > 0;
    if (o->history.file) { /* once it is read, it is a list */
        sph2d__check_fault(c, lists > 0 ? SPH2D_CODE_CONFLICT : SPH2D_CODE_MISSING_KEY,
                           sph2d__check_path(path, "openings", i, ".history.file"),
                           lists > 0 ? "is a list, which is given, too: leave out one of the two"
                                     : "was not read: only a scene that is read from a file has files");
        return false;
    }
    int given = numbers + lists;
    if (given == 1)
        return true;
    sph2d_diagnostic *d = sph2d__check_fault(c, given == 0 ? SPH2D_CODE_MISSING_KEY : SPH2D_CODE_CONFLICT,
                                             sph2d__check_path(path, "openings", i, ""),
                                             given == 0 ? "prescribes nothing" : "prescribes more than one thing");
    sph2d_diagnostic_hint(d, "give one of velocity, flow_rate, pressure, level, or one of them in `history`");
    return false;
}

/** Checks an opening in which liquid has a surface. */
static void check_surface(checker *c, size_t i)
{
    const sph2d_scene *scene = c->scene;
    const sph2d_opening *o = &scene->openings[i];
    bool level = sph2d__opening_kind_of(o) == SPH2D__OPENING_LEVEL,
         vertical = sph2d__opening_mouth(scene, o).along.y > 0;
    const char *key = level ? ".level" : ".free_surface";
    char path[SPH2D__PATH_SIZE], message[120];
    sph2d__check_path(path, "openings", i, key);
    if (scene->gravity.x != 0 || !(scene->gravity.y < 0))
        sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, path, "needs gravity downwards, `gravity: [0, -9.81]`");
    else if (!level && !sph2d__opening_has_velocity(o))
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "belongs to velocity or flow_rate, not to pressure");
    else if (!level && !vertical)
        sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, path, "is for openings in the left and right side");
    else if (!level && (o->profile != SPH2D_OPENING_PROFILE_UNIFORM || o->history.profile.count > 0))
        sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, path, "goes with a uniform profile only");
    double low = sph2d__opening_mouth(scene, o).start.y;
    if (level && !(sph2d__opening_largest(o) > low)) {
        snprintf(message, sizeof message, "%g lies below the opening, which begins at y = %g",
                 sph2d__opening_largest(o), low);
        sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, message);
        sph2d_diagnostic_hint(d, "where liquid falls over an edge, use an open side");
    }
}

/** Checks that an opening prescribes one thing, and no more than belongs to it. */
static void check_prescribed(checker *c, size_t i)
{
    const sph2d_opening *o = &c->scene->openings[i];
    char path[SPH2D__PATH_SIZE], message[80];
    if (!check_one(c, i))
        return;
    sph2d__opening_kind kind = sph2d__opening_kind_of(o);
    check_history(c, i, (int)kind);
    bool shaped = o->profile != SPH2D_OPENING_PROFILE_UNIFORM;
    if (!sph2d__opening_has_velocity(o) && (shaped || o->ramp > 0)) {
        snprintf(message, sizeof message, "belongs to velocity or flow_rate, not to %s", kind_words[kind]);
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT,
                           sph2d__check_path(path, "openings", i, shaped ? ".profile" : ".ramp"), message);
    }
    if (sph2d__opening_has_surface(o))
        check_surface(c, i);
}

/** Checks the ends of an opening. False if they are not valid. */
static bool check_ends(checker *c, size_t i)
{
    const sph2d_opening *o = &c->scene->openings[i];
    const sph2d_box *d = &c->scene->domain;
    bool vertical = sph2d__side_is_vertical((int)o->side);
    double low = vertical ? d->min.y : d->min.x, high = vertical ? d->max.y : d->max.x, dx = c->scene->spacing;
    const struct {
        const char *key;
        double value;
    } ends[] = {{".from", o->from}, {".to", o->to}};
    char path[SPH2D__PATH_SIZE], message[120];
    for (int k = 0; k < 2; ++k)
        if (ends[k].value < low - 1e-9 * dx || ends[k].value > high + 1e-9 * dx) {
            snprintf(message, sizeof message, "%g lies outside the %s side", ends[k].value,
                     sph2d__side_word((int)o->side));
            sph2d_diagnostic *e =
                sph2d__check_fault(c, SPH2D_CODE_OUTSIDE, sph2d__check_path(path, "openings", i, ends[k].key), message);
            sph2d_diagnostic_hint(e, "the side reaches from %g to %g", low, high);
            return false;
        }
    double width = sph2d__opening_mouth(c->scene, o).width;
    if (width >= MIN_WIDTH * dx * (1 - 1e-9))
        return true;
    snprintf(message, sizeof message, "is %.3g m wide, less than %g spacings", width, MIN_WIDTH);
    sph2d_diagnostic *e = sph2d__check_fault(
        c, SPH2D_CODE_OUT_OF_RANGE, sph2d__check_path(path, "openings", i, isnan(o->to) ? "" : ".to"), message);
    sph2d_diagnostic_hint(e, "`to` must be above `from` by %.3g m or more; a thin jet is a source", MIN_WIDTH * dx);
    return false;
}

/** The first point that does not go on as the points before it: the same increasing places at each of increasing times;
 *  the count if all do. */
static size_t first_wrong(const sph2d_path *p)
{
    size_t places = sph2d__profile_places(p);
    for (size_t k = 1; k < p->count; ++k) {
        const sph2d_path_point *before = &p->items[k - 1], *here = &p->items[k];
        bool row = k % places > 0;
        bool goes_on = row ? here->t == before->t && here->x > before->x : here->t > before->t;
        bool same = k < places || here->x == p->items[k % places].x;
        if (!goes_on || !same)
            return k;
    }
    return p->count % places > 0 ? p->count - 1 : p->count;
}

/** Checks the velocity over place and time that an opening has; its ends are valid. */
static void check_profile(checker *c, size_t i)
{
    const sph2d_opening *o = &c->scene->openings[i];
    const sph2d_path *p = &o->history.profile;
    char path[SPH2D__PATH_SIZE], message[200];
    sph2d__check_path(path, "openings", i, ".history.profile");
    size_t wrong = first_wrong(p), places = sph2d__profile_places(p);
    if (wrong < p->count) {
        const sph2d_path_point *at = &p->items[wrong];
        snprintf(message, sizeof message, "point %zu, [%g, %g, %g], does not go on as those before it", wrong, at->t,
                 at->x, at->y);
        sph2d_diagnostic_hint(sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, message),
                              "give the same places, increasing, at each of increasing times: %zu at a time here",
                              places);
        return;
    }
    if (o->profile != SPH2D_OPENING_PROFILE_UNIFORM)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, sph2d__check_path(path, "openings", i, ".profile"),
                           "is that of history.profile: leave out one of the two");
    sph2d__mouth m = sph2d__opening_mouth(c->scene, o);
    double low = m.along.y > 0 ? m.start.y : m.start.x, high = low + m.width, slack = 1e-6 * c->scene->spacing;
    double first = p->items[0].x, last = p->items[places - 1].x;
    if (first <= low + slack && last >= high - slack)
        return;
    snprintf(message, sizeof message, "has places from %g to %g, but the opening reaches from %g to %g", first, last,
             low, high);
    sph2d_diagnostic_hint(sph2d__check_fault(c, SPH2D_CODE_OUTSIDE, path, message),
                          "add points at its ends: at a wall without slip the velocity is 0");
}

/** The rectangle of a reservoir, without its lines. */
static sph2d_box reservoir_of(const sph2d_scene *scene, const sph2d_opening *o, double shrink)
{
    sph2d__mouth m = sph2d__opening_mouth(scene, o);
    double depth = sph2d__reservoir_length(scene);
    sph2d_vec2 a = {m.start.x + shrink * m.along.x, m.start.y + shrink * m.along.y};
    sph2d_vec2 b = {m.start.x + (m.width - shrink) * m.along.x - depth * m.inward.x,
                    m.start.y + (m.width - shrink) * m.along.y - depth * m.inward.y};
    return (sph2d_box){{fmin(a.x, b.x), fmin(a.y, b.y)}, {fmax(a.x, b.x), fmax(a.y, b.y)}};
}

/** Checks that two openings do not overlap, and do not meet in a corner, where their reservoirs would. */
static void check_pair(checker *c, size_t i, size_t k)
{
    const sph2d_opening *a = &c->scene->openings[i], *b = &c->scene->openings[k];
    double dx = c->scene->spacing;
    char path[SPH2D__PATH_SIZE], message[120];
    bool meet;
    if (a->side == b->side) {
        sph2d_box p = reservoir_of(c->scene, a, 1e-9 * dx), q = reservoir_of(c->scene, b, 1e-9 * dx);
        meet = p.min.x < q.max.x && q.min.x < p.max.x && p.min.y < q.max.y && q.min.y < p.max.y;
    } else {
        double room = (double)sph2d__reservoir_rows(c->scene) * dx / 2; /* a support radius, and a little */
        sph2d__mouth m = sph2d__opening_mouth(c->scene, a), n = sph2d__opening_mouth(c->scene, b);
        const double ends[4] = {0, m.width, 0, n.width};
        meet = false;
        for (int e = 0; e < 4; ++e) {
            sph2d_vec2 p = {m.start.x + ends[e % 2] * m.along.x, m.start.y + ends[e % 2] * m.along.y};
            sph2d_vec2 q = {n.start.x + ends[2 + e / 2] * n.along.x, n.start.y + ends[2 + e / 2] * n.along.y};
            meet = meet || hypot(p.x - q.x, p.y - q.y) < room;
        }
        bool opposite = m.along.x == n.along.x;
        meet = meet && !opposite;
    }
    if (!meet)
        return;
    snprintf(message, sizeof message, a->side == b->side ? "overlaps openings[%zu]" : "meets openings[%zu] in a corner",
             i);
    sph2d_diagnostic *d =
        sph2d__check_fault(c, SPH2D_CODE_OVERLAP, sph2d__check_path(path, "openings", k, ""), message);
    sph2d_diagnostic_hint(d,
                          a->side == b->side ? "end one where the other begins"
                                             : "leave a wall of %.2g m or more between each of them and the corner",
                          (double)sph2d__reservoir_rows(c->scene) * dx / 2);
}

/** Checks that no solid at rest lies before an opening. */
static void check_before(checker *c, size_t i)
{
    const sph2d_scene *scene = c->scene;
    sph2d__mouth m = sph2d__opening_mouth(scene, &scene->openings[i]);
    double dx = scene->spacing, steps = ceil(m.width / dx);
    for (size_t k = SPH2D__WALL_OBSTACLE; k < c->world->wall_count; ++k)
        for (double step = 0; step < steps; ++step) {
            double t = (step + 0.5) / steps * m.width;
            sph2d_vec2 p = {m.start.x + t * m.along.x + dx / 2 * m.inward.x,
                            m.start.y + t * m.along.y + dx / 2 * m.inward.y};
            if (!sph2d__wall_fills(scene, &c->world->walls[k], p))
                continue;
            char path[SPH2D__PATH_SIZE], other[64], message[160];
            snprintf(message, sizeof message, "%s lies before it, at (%g, %g)",
                     sph2d__wall_path(other, sizeof other, &c->world->walls[k], ""), p.x, p.y);
            sph2d_diagnostic *d =
                sph2d__check_fault(c, SPH2D_CODE_OVERLAP, sph2d__check_path(path, "openings", i, ""), message);
            sph2d__check_hint_wall(c, d, k, "let `from` and `to` leave out what is solid, or move the obstacle away");
            return;
        }
}

/** What openings let in more than out at a time [m^2/s], nothing if that is rounding; NAN where one has a pressure or
 *  level, which balances the others. */
static double excess_at(const sph2d_scene *scene, double time)
{
    double sum = 0, all = 0;
    for (size_t i = 0; i < scene->opening_count; ++i) {
        const sph2d_opening *o = &scene->openings[i];
        if (!sph2d__opening_has_velocity(o))
            return NAN;
        double rate = sph2d__opening_velocity(scene, o, time) * sph2d__opening_mouth(scene, o).width;
        sum += rate;
        all += fabs(rate);
    }
    return fabs(sum) > 1e-9 * all ? sum : 0;
}

/** Checks that liquid which fills its domain can flow out as it flows in: in the end, and whenever a history bends. */
static void check_balance(checker *c)
{
    const sph2d_scene *scene = c->scene;
    double excess = excess_at(scene, INFINITY);
    for (size_t i = 0; i < scene->opening_count; ++i) {
        const sph2d_opening *o = &scene->openings[i];
        const sph2d_history *h = sph2d__opening_history(o, sph2d__opening_kind_of(o));
        for (size_t k = 0; excess == 0 && k < h->count; ++k)
            excess = excess_at(scene, h->items[k].x);
        for (size_t k = 0; excess == 0 && k < o->history.profile.count; ++k)
            excess = excess_at(scene, o->history.profile.items[k].t);
    }
    if (!(excess != 0) || isnan(excess))
        return;
    char message[120];
    snprintf(message, sizeof message, "let in %g m^2/s more than out, and liquid fills the domain", excess);
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "openings", message);
    sph2d_diagnostic_hint(d, "give one of them a pressure in place of a velocity or flow_rate");
}

static void check_opening(checker *c, size_t i)
{
    const sph2d_scene *scene = c->scene;
    const sph2d_opening *o = &scene->openings[i];
    int side = (int)o->side;
    char path[SPH2D__PATH_SIZE];
    sph2d_diagnostic *d;
    if (sph2d__side_of(scene, side) != SPH2D_SIDE_WALL) {
        d = sph2d__check_fault(c, SPH2D_CODE_CONFLICT, sph2d__check_path(path, "openings", i, ".side"),
                               "is not a wall: an opening is a part of one");
        sph2d_diagnostic_hint(d, "use `boundary: {%s: wall}`", sph2d__side_word(side));
    }
    if (sph2d__side_speed(scene, side) != 0)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, sph2d__check_path(path, "openings", i, ".side"),
                           "moves along itself (wall_speeds): there is no opening in a belt");
    if (o->name && !sph2d__check_name(o->name))
        sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, sph2d__check_path(path, "openings", i, ".name"),
                           "must be 1 to 64 letters, digits, _ or -");
    else if (o->name && sph2d__opening_named(scene, o->name) != o)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, sph2d__check_path(path, "openings", i, ".name"),
                           "another opening has this name");
    check_prescribed(c, i);
    if (check_ends(c, i) && o->history.profile.count > 0)
        check_profile(c, i);
}

void sph2d__check_openings(checker *c)
{
    const sph2d_scene *scene = c->scene;
    size_t before = c->errors;
    for (size_t i = 0; i < scene->opening_count; ++i)
        check_opening(c, i);
    if (scene->opening_count > 0 && sph2d__motion_moves(&scene->motion))
        sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, "motion", "a tank with openings cannot move");
    if (c->errors > before || scene->opening_count == 0)
        return;
    bool filled = sph2d__liquid_fills(c->world);
    for (size_t i = 0; i < scene->opening_count; ++i) {
        for (size_t k = i + 1; k < scene->opening_count; ++k)
            check_pair(c, i, k);
        check_before(c, i);
        sph2d__check_inflow(c, i, filled);
    }
    if (filled)
        check_balance(c);
}
