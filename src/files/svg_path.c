/* SPDX-License-Identifier: MIT */
/** @file svg_path.c
 *  Path data of SVG: https://www.w3.org/TR/SVG2/paths.html, all commands, as straight pieces. */
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/pi.h"
#include "files/svg.h"

enum { MOST_POINTS = 10000, SHOWN = 24 };

/** A path that is being drawn. Places are in its own coordinates, points are mapped. */
typedef struct pen {
    const char *start, *at;
    sph2d__affine map;
    double tolerance;
    sph2d__svg_points *out;
    sph2d_vec2 here, begin;
    sph2d_vec2 control; /**< the last one of the curve before ... */
    char before;        /**< ... and its command, in upper case */
    bool drawn, ended;  /**< whether there is a piece; whether the subpath of these is over */
    sph2d_status status;
} pen;

static bool fault(pen *p, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Notes what is wrong, and where. Always false. */
static bool fault(pen *p, const char *format, ...)
{
    if (p->status != SPH2D_OK)
        return false;
    char what[100];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    size_t before = (size_t)(p->at - p->start), shown = before < SHOWN ? before : SHOWN;
    snprintf(p->out->why, sizeof p->out->why, shown > 0 ? "%s after '%.*s'" : "%s", what, (int)shown, p->at - shown);
    sph2d__text_clean(p->out->why);
    p->status = SPH2D_FORMAT;
    return false;
}

/* ---- text -------------------------------------------------------------------------------------------------------- */

static bool is_space(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

void sph2d__svg_skip(const char **text)
{
    while (is_space(**text))
        ++*text;
    *text += **text == ',';
    while (is_space(**text))
        ++*text;
}

static size_t digits(const char *text)
{
    return strspn(text, "0123456789");
}

bool sph2d__svg_number(const char **text, double *value)
{
    const char *end = *text + (**text == '+' || **text == '-');
    size_t whole = digits(end), part = 0;
    end += whole;
    if (*end == '.') {
        part = digits(end + 1);
        end += part > 0 || whole > 0 ? part + 1 : 0;
    }
    if (whole + part == 0)
        return false;
    if (*end == 'e' || *end == 'E') {
        size_t sign = end[1] == '+' || end[1] == '-', power = digits(end + 1 + sign);
        end += power > 0 ? 1 + sign + power : 0;
    }
    char copy[64]; /* strtod reads more than SVG: 0x10 */
    size_t length = (size_t)(end - *text);
    if (length >= sizeof copy)
        return false;
    memcpy(copy, *text, length);
    copy[length] = '\0';
    *value = strtod(copy, NULL);
    *text = end;
    return isfinite(*value);
}

static bool number(pen *p, double *value)
{
    sph2d__svg_skip(&p->at);
    return sph2d__svg_number(&p->at, value) || fault(p, "a number is missing or too large");
}

/** A point, relative to the place where the pen is if the command is in lower case. */
static bool point(pen *p, bool relative, sph2d_vec2 *to)
{
    if (!number(p, &to->x) || !number(p, &to->y))
        return false;
    to->x += relative ? p->here.x : 0;
    to->y += relative ? p->here.y : 0;
    return true;
}

/** A flag of an arc: a single digit, which needs no space behind it. */
static bool flag(pen *p, bool *value)
{
    sph2d__svg_skip(&p->at);
    if (*p->at != '0' && *p->at != '1')
        return fault(p, "a flag of an arc must be 0 or 1");
    *value = *p->at++ == '1';
    return true;
}

/* ---- points ------------------------------------------------------------------------------------------------------ */

static sph2d_vec2 mapped(const pen *p, sph2d_vec2 v)
{
    const sph2d__affine *m = &p->map;
    return (sph2d_vec2){m->a * v.x + m->c * v.y + m->e, m->b * v.x + m->d * v.y + m->f};
}

static bool are_near(const pen *p, sph2d_vec2 a, sph2d_vec2 b)
{
    return hypot(a.x - b.x, a.y - b.y) <= p->tolerance;
}

static bool put(pen *p, sph2d_vec2 at)
{
    sph2d__svg_points *out = p->out;
    if (!isfinite(at.x) || !isfinite(at.y))
        return fault(p, "a point is too far away");
    if (out->count > 0 && are_near(p, at, out->items[out->count - 1]))
        return true;
    if (out->count == MOST_POINTS)
        return fault(p, "there are more than %d points at this spacing", MOST_POINTS);
    if (out->count == out->capacity) {
        size_t capacity = out->capacity > 0 ? 2 * out->capacity : 64;
        sph2d_vec2 *larger = realloc(out->items, capacity * sizeof *larger);
        if (!larger) {
            p->status = SPH2D_NOMEM;
            return false;
        }
        out->items = larger;
        out->capacity = capacity;
    }
    out->items[out->count++] = at;
    return true;
}

/** Begins a piece. */
static bool draw(pen *p)
{
    if (p->ended)
        return fault(p, "a second part begins (a hole, or a part of its own: give each as a path)");
    if (p->drawn)
        return true;
    p->drawn = true;
    return put(p, mapped(p, p->here));
}

static bool line_to(pen *p, sph2d_vec2 to)
{
    bool ok = draw(p) && put(p, mapped(p, to));
    p->here = to;
    return ok;
}

static sph2d_vec2 mix(sph2d_vec2 a, sph2d_vec2 b, double part)
{
    return (sph2d_vec2){(1 - part) * a.x + part * b.x, (1 - part) * a.y + part * b.y};
}

/** How many of a curve's pieces, at most so many that there are too many. */
static size_t count_of(double pieces)
{
    return pieces > 1 ? (pieces < MOST_POINTS ? (size_t)ceil(pieces) : MOST_POINTS + 1) : 1;
}

/** Bezier's cubic. A chord over 1/n of the parameter is at most |B''| / (8 n^2) from it, and |B''| is at most 6 times the
 *  larger second difference of the control points. */
static bool cubic_to(pen *p, sph2d_vec2 one, sph2d_vec2 two, sph2d_vec2 to)
{
    const sph2d_vec2 a = mapped(p, p->here), b = mapped(p, one), c = mapped(p, two), d = mapped(p, to);
    const double bend =
        fmax(hypot(a.x - 2 * b.x + c.x, a.y - 2 * b.y + c.y), hypot(b.x - 2 * c.x + d.x, b.y - 2 * c.y + d.y));
    const size_t pieces = count_of(sqrt(6 * bend / (8 * p->tolerance)));
    bool ok = draw(p);
    for (size_t k = 1; ok && k < pieces; ++k) {
        const double t = (double)k / (double)pieces;
        const sph2d_vec2 ab = mix(a, b, t), bc = mix(b, c, t), cd = mix(c, d, t);
        ok = put(p, mix(mix(ab, bc, t), mix(bc, cd, t), t));
    }
    p->here = to;
    return ok && put(p, d);
}

/** A parabola is a cubic. */
static bool quadratic_to(pen *p, sph2d_vec2 control, sph2d_vec2 to)
{
    return cubic_to(p, mix(p->here, control, 2.0 / 3), mix(to, control, 2.0 / 3), to);
}

/** An ellipse: center + u cos(angle) + v sin(angle). */
typedef struct ellipse {
    sph2d_vec2 center, u, v;
} ellipse;

/** Its larger half axis when it is mapped: the larger singular value of the map's linear part. */
static double largest_radius(const sph2d__affine *m, const ellipse *e)
{
    double ux = m->a * e->u.x + m->c * e->u.y, uy = m->b * e->u.x + m->d * e->u.y;
    double vx = m->a * e->v.x + m->c * e->v.y, vy = m->b * e->v.x + m->d * e->v.y;
    double squares = ux * ux + uy * uy + vx * vx + vy * vy, area = ux * vy - uy * vx;
    return sqrt((squares + sqrt(fmax(squares * squares - 4 * area * area, 0))) / 2);
}

/** An arc from one end to the other, as appendix B.2 of SVG 2 has it: radii that are too small for these ends grow. A chord
 *  over an angle 2 h is at most r (1 - cos h) from a circle. */
static bool arc_to(pen *p, double rx, double ry, double turn, bool large, bool positive, sph2d_vec2 to)
{
    const sph2d_vec2 from = p->here;
    rx = fabs(rx);
    ry = fabs(ry);
    if (rx == 0 || ry == 0 || (from.x == to.x && from.y == to.y))
        return line_to(p, to);
    const double c = cos(turn * SPH2D__PI / 180), s = sin(turn * SPH2D__PI / 180);
    const double hx = (from.x - to.x) / 2, hy = (from.y - to.y) / 2;
    double x = (c * hx + s * hy) / rx, y = (c * hy - s * hx) / ry; /* of `from`, where the ellipse is a unit circle */
    const double grow = fmax(hypot(x, y), 1);
    rx *= grow;
    ry *= grow;
    x /= grow;
    y /= grow;
    const double far = sqrt(fmax(1 / (x * x + y * y) - 1, 0)) * (large == positive ? -1 : 1);
    const double mx = far * y, my = -far * x; /* the centre, from the middle of both ends */
    const double first = atan2(y - my, x - mx), last = atan2(-y - my, -x - mx);
    double angle = last - first;
    angle += positive && angle < 0 ? 2 * SPH2D__PI : !positive && angle > 0 ? -2 * SPH2D__PI : 0;
    const ellipse e = {
        {(from.x + to.x) / 2 + c * rx * mx - s * ry * my, (from.y + to.y) / 2 + s * rx * mx + c * ry * my},
        {c * rx, s * rx},
        {-s * ry, c * ry}};
    const double most = 2 * acos(fmax(1 - p->tolerance / largest_radius(&p->map, &e), 0));
    const size_t pieces = count_of(fabs(angle) / most);
    bool ok = draw(p);
    for (size_t k = 1; ok && k < pieces; ++k) {
        const double at = first + angle * (double)k / (double)pieces;
        ok = put(p, mapped(p, (sph2d_vec2){e.center.x + e.u.x * cos(at) + e.v.x * sin(at),
                                           e.center.y + e.u.y * cos(at) + e.v.y * sin(at)}));
    }
    return ok && line_to(p, to);
}

/* ---- commands ---------------------------------------------------------------------------------------------------- */

/** The control point that continues a curve smoothly, after another of the same kind. */
static sph2d_vec2 reflected(const pen *p, const char *kind)
{
    if (!strchr(kind, p->before))
        return p->here;
    return (sph2d_vec2){2 * p->here.x - p->control.x, 2 * p->here.y - p->control.y};
}

static bool move_to(pen *p, bool relative)
{
    sph2d_vec2 to;
    if (!point(p, relative, &to))
        return false;
    p->ended = p->drawn;
    p->here = p->begin = to;
    return true;
}

static bool close_path(pen *p)
{
    p->out->closed = p->out->closed || (p->drawn && !p->ended);
    p->ended = p->drawn;
    p->here = p->begin;
    return true;
}

static bool cubic_command(pen *p, bool relative, bool smooth)
{
    sph2d_vec2 one = reflected(p, "CS"), two, to;
    if ((!smooth && !point(p, relative, &one)) || !point(p, relative, &two) || !point(p, relative, &to))
        return false;
    p->control = two;
    return cubic_to(p, one, two, to);
}

static bool quadratic_command(pen *p, bool relative, bool smooth)
{
    sph2d_vec2 control = reflected(p, "QT"), to;
    if ((!smooth && !point(p, relative, &control)) || !point(p, relative, &to))
        return false;
    p->control = control;
    return quadratic_to(p, control, to);
}

static bool arc_command(pen *p, bool relative)
{
    double rx, ry, turn;
    bool large = false, positive = false;
    sph2d_vec2 to;
    return number(p, &rx) && number(p, &ry) && number(p, &turn) && flag(p, &large) && flag(p, &positive) &&
           point(p, relative, &to) && arc_to(p, rx, ry, turn, large, positive, to);
}

/** One set of numbers of a command. */
static bool obey(pen *p, char command)
{
    const bool relative = islower((unsigned char)command) != 0;
    sph2d_vec2 to = p->here;
    double value = 0;
    switch (toupper((unsigned char)command)) {
    case 'M':
        return move_to(p, relative);
    case 'Z':
        return close_path(p);
    case 'L':
        return point(p, relative, &to) && line_to(p, to);
    case 'H':
        return number(p, &value) && line_to(p, (sph2d_vec2){value + (relative ? to.x : 0), to.y});
    case 'V':
        return number(p, &value) && line_to(p, (sph2d_vec2){to.x, value + (relative ? to.y : 0)});
    case 'C':
    case 'S':
        return cubic_command(p, relative, toupper((unsigned char)command) == 'S');
    case 'Q':
    case 'T':
        return quadratic_command(p, relative, toupper((unsigned char)command) == 'T');
    case 'A':
        return arc_command(p, relative);
    default:
        return fault(p, "'%c' is no command", isprint((unsigned char)command) ? command : '?');
    }
}

/** Draws all of a path. A command may have several sets of numbers; those after the first of M are lines. */
static void follow(pen *p)
{
    char command = '\0';
    while (sph2d__svg_skip(&p->at), *p->at != '\0') {
        const bool is_new = isalpha((unsigned char)*p->at) != 0;
        if (!is_new && (command == '\0' || toupper((unsigned char)command) == 'Z')) {
            fault(p, "a command is missing");
            return;
        }
        if (command == '\0' && *p->at != 'M' && *p->at != 'm') {
            fault(p, "a path must begin with M");
            return;
        }
        command = is_new ? *p->at++ : command == 'M' ? 'L' : command == 'm' ? 'l' : command;
        if (!obey(p, command))
            return;
        p->before = (char)toupper((unsigned char)command);
    }
}

sph2d_status sph2d__svg_flatten(const char *path, sph2d__affine map, double tolerance, sph2d__svg_points *points)
{
    *points = (sph2d__svg_points){0};
    pen p = {.start = path, .at = path, .map = map, .tolerance = tolerance, .out = points, .before = 'M'};
    follow(&p);
    if (p.status == SPH2D_OK && points->count == 0)
        fault(&p, "there is nothing to draw");
    while (points->count > 1 && are_near(&p, points->items[0], points->items[points->count - 1])) {
        points->closed = true;
        --points->count;
    }
    return p.status;
}
