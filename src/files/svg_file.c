/* SPDX-License-Identifier: MIT */
/** @file svg_file.c
 *  The only file that uses expat: finds an element of a drawing, with the transforms around it and the page. Elements are
 *  events, nothing recurses, and entities cannot expand without bound. */
#include <expat.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "files/svg.h"

/** Most nested elements, and bytes of an entity: of so few of them no text grows 100 times as long. */
enum { MOST_DEPTH = 200, MOST_ENTITY = 255 };

#define INKSCAPE "http://www.inkscape.org/namespaces/inkscape"

/** What the elements around one say. */
typedef struct level {
    sph2d__affine place;
    const char *unclear; /**< why places in it are unknown; NULL: they are known */
} level;

/** An element that may be the wanted one. */
typedef struct candidate {
    size_t count; /**< how many there were; the first is kept */
    sph2d__svg_element element;
    char name[32];
    const char *why; /**< what is wrong with it; NULL: nothing */
} candidate;

typedef struct search {
    XML_Parser parser;
    const sph2d__source *source;
    const char *id;
    sph2d__pool *pool;
    sph2d_report *report;
    level levels[MOST_DEPTH];
    size_t depth;
    sph2d_vec2 corner, size; /**< of the page; 0: unknown */
    candidate by_id, by_label;
    char others[160]; /**< names of outlines that are there */
    sph2d_status status;
} search;

/* ---- messages ---------------------------------------------------------------------------------------------------- */

sph2d_status sph2d__svg_fault(sph2d__place place, sph2d_report *report, const char *format, ...)
{
    char message[sizeof((sph2d_diagnostic *)0)->message];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    sph2d__text_clean(message);
    sph2d_diagnostic *d = sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL, "%s", message);
    if (d)
        sph2d__place_describe(place, d);
    return SPH2D_FORMAT;
}

static sph2d__place place_here(const search *s)
{
    const XML_Index at = XML_GetCurrentByteIndex(s->parser);
    return (sph2d__place){s->source, at > 0 ? (size_t)at : 0};
}

static void stop(search *s, sph2d_status status)
{
    s->status = status;
    XML_StopParser(s->parser, XML_FALSE);
}

static void refuse(search *s, const char *message)
{
    if (s->status == SPH2D_OK)
        stop(s, sph2d__svg_fault(place_here(s), s->report, "%s", message));
}

/* ---- the page ---------------------------------------------------------------------------------------------------- */

/** Reads the numbers of a viewBox. */
static bool read_view(const char *text, sph2d_vec2 *corner, sph2d_vec2 *size)
{
    double *const out[] = {&corner->x, &corner->y, &size->x, &size->y};
    for (size_t i = 0; i < 4; ++i) {
        sph2d__svg_skip(&text);
        if (!sph2d__svg_number(&text, out[i]))
            return false;
    }
    sph2d__svg_skip(&text);
    return *text == '\0' && size->x > 0 && size->y > 0;
}

static void read_page(search *s, const char *const *attributes)
{
    const char *view = sph2d__svg_attribute(attributes, "viewBox"), *wide = sph2d__svg_attribute(attributes, "width"),
               *high = sph2d__svg_attribute(attributes, "height");
    sph2d_vec2 outer = {0, 0};
    const bool has_size = wide && high && sph2d__svg_length(wide, &outer.x) && sph2d__svg_length(high, &outer.y) &&
                          outer.x > 0 && outer.y > 0;
    if (!view && !has_size)
        refuse(s, "the page has no size: give the drawing a viewBox, or a width and height");
    else if (!view)
        s->size = outer;
    else if (!read_view(view, &s->corner, &s->size))
        refuse(s, "the viewBox needs four numbers: the page's corner, width above 0, height above 0");
    else if (has_size && !(fabs(outer.x * s->size.y / (outer.y * s->size.x) - 1) < 0.01))
        refuse(s, "width and height are of another shape than the viewBox: resize the page in its editor");
}

/* ---- elements ---------------------------------------------------------------------------------------------------- */

static const char *local(const char *name)
{
    const char *bar = strrchr(name, '|');
    return bar ? bar + 1 : name;
}

/** Whether a style, "fill: red; transform: none", has a property. */
static bool has_property(const char *style, const char *name)
{
    for (const char *at = style; at; at = strchr(at, ';')) {
        at += strspn(at, "; \t\n\r");
        const size_t length = strcspn(at, ":; \t\n\r");
        if (length == strlen(name) && memcmp(at, name, length) == 0)
            return true;
    }
    return false;
}

/** Pushes what an element says of places in it. */
static level *enter(search *s, const char *name, const char *const *attributes)
{
    static const char *const frames[] = {"svg", "symbol", "marker", "pattern"};
    const level *outer = s->depth > 0 ? &s->levels[s->depth - 1] : NULL;
    level *inner = &s->levels[s->depth];
    *inner = outer ? *outer : (level){{1, 0, 0, 1, 0, 0}, NULL};
    const char *style = sph2d__svg_attribute(attributes, "style");
    const char *transform = sph2d__svg_attribute(attributes, "transform");
    sph2d__affine map;
    if (transform && sph2d__svg_transform(transform, &map))
        inner->place = sph2d__affine_of(inner->place, map);
    else if (transform)
        inner->unclear = "has a transform, or is in an element with one, that cannot be read";
    const bool has_origin =
        sph2d__svg_attribute(attributes, "transform-origin") || has_property(style, "transform-origin");
    if (has_property(style, "transform") || (transform && has_origin))
        inner->unclear =
            "has a transform by its style or an origin of it, which are not read: give a plain `transform`";
    for (size_t i = 0; outer && i < sizeof frames / sizeof frames[0]; ++i)
        if (strcmp(name, frames[i]) == 0)
            inner->unclear =
                "is in an inner svg, symbol, marker or pattern, which have pages of their own: move it out";
    return inner;
}

static void take(search *s, candidate *c, const char *name, const char *const *attributes, const level *inner)
{
    if (c->count++ > 0)
        return;
    c->element = (sph2d__svg_element){.place = inner->place, .at = place_here(s)};
    snprintf(c->name, sizeof c->name, "%s", name);
    if (!sph2d__svg_is_outline(name))
        return;
    c->why = inner->unclear;
    if (!c->why) {
        c->element.path = sph2d__svg_path_of(name, attributes, s->pool, &c->why);
        if (!c->element.path && !c->why)
            stop(s, SPH2D_NOMEM);
    }
}

static void note_other(search *s, const char *id)
{
    const size_t used = strlen(s->others);
    if (used < sizeof s->others - 4)
        snprintf(s->others + used, sizeof s->others - used, "%s%s", used > 0 ? ", " : "", id);
}

static void XMLCALL begin(void *data, const XML_Char *whole_name, const XML_Char **given)
{
    search *s = data;
    const char *const *attributes = (const char *const *)given;
    const char *name = local(whole_name);
    if (s->status != SPH2D_OK)
        return;
    if (s->depth == 0 && strcmp(name, "svg") != 0)
        refuse(s, "this is XML, but no drawing: its first element is not svg");
    else if (s->depth == 0)
        read_page(s, attributes);
    if (s->depth == MOST_DEPTH)
        refuse(s, "elements are nested too deeply");
    if (s->status != SPH2D_OK)
        return;
    const level *inner = enter(s, name, attributes);
    ++s->depth;
    const char *id = sph2d__svg_attribute(attributes, "id"),
               *label = sph2d__svg_attribute(attributes, INKSCAPE "|label");
    if (id && strcmp(id, s->id) == 0)
        take(s, &s->by_id, name, attributes, inner);
    else if (label && strcmp(label, s->id) == 0)
        take(s, &s->by_label, name, attributes, inner);
    else if ((label || id) && sph2d__svg_is_outline(name))
        note_other(s, label ? label : id);
}

static void XMLCALL end(void *data, const XML_Char *name)
{
    (void)name;
    search *s = data;
    s->depth -= s->status == SPH2D_OK; /* the end of an element that was refused comes, too */
}

/** Entities of entities, and long ones, are how a short file becomes an endless one. */
static void XMLCALL declare(void *data, const XML_Char *name, int is_parameter, const XML_Char *value, int length,
                            const XML_Char *base, const XML_Char *system, const XML_Char *public_id,
                            const XML_Char *notation)
{
    (void)name, (void)is_parameter, (void)base, (void)system, (void)public_id, (void)notation;
    if (value && (length > MOST_ENTITY || memchr(value, '&', (size_t)length)))
        refuse(data, "an entity is long or made of others: save the drawing as plain SVG");
}

/* ---- the search -------------------------------------------------------------------------------------------------- */

static sph2d_status parse(search *s)
{
    s->parser = XML_ParserCreateNS(NULL, '|');
    if (!s->parser)
        return SPH2D_NOMEM;
    XML_SetUserData(s->parser, s);
    XML_SetElementHandler(s->parser, begin, end);
    XML_SetEntityDeclHandler(s->parser, declare);
    const bool ok = XML_Parse(s->parser, s->source->text, (int)s->source->length, 1) == XML_STATUS_OK;
    const enum XML_Error error = XML_GetErrorCode(s->parser);
    if (!ok && s->status == SPH2D_OK)
        s->status = error == XML_ERROR_NO_MEMORY
                        ? SPH2D_NOMEM
                        : sph2d__svg_fault(place_here(s), s->report, "this is no XML, as a drawing is: %s",
                                           XML_ErrorString(error));
    XML_ParserFree(s->parser);
    return s->status;
}

static sph2d_status choose(const search *s, sph2d__svg_element *element)
{
    const candidate *c = s->by_id.count > 0 ? &s->by_id : &s->by_label;
    const sph2d__place whole = {s->source, SPH2D__NOWHERE};
    if (s->id[0] == '\0')
        return sph2d__svg_fault(whole, s->report, "name an outline in it, FILE.svg#ID%s%s",
                                s->others[0] ? "; there are " : ": there is none with an id", s->others);
    if (c->count == 0)
        return sph2d__svg_fault(whole, s->report, "there is no '%.60s'%s%s", s->id,
                                s->others[0] ? "; there are " : ", nor another outline with an id", s->others);
    if (c->count > 1)
        return sph2d__svg_fault(c->element.at, s->report, "'%.60s' is there %zu times: give each its own id", s->id,
                                c->count);
    if (!sph2d__svg_is_outline(c->name))
        return sph2d__svg_fault(
            c->element.at, s->report,
            "'%.60s' is no outline, but <%s>: name a path, rect, circle, ellipse, line, polyline or "
            "polygon%s%s",
            s->id, c->name, s->others[0] ? "; there are " : "", s->others);
    if (c->why)
        return sph2d__svg_fault(c->element.at, s->report, "'%.60s' %s", s->id, c->why);
    *element = c->element;
    element->corner = s->corner;
    element->size = s->size;
    return SPH2D_OK;
}

sph2d_status sph2d__svg_find(const sph2d__source *source, const char *id, sph2d__pool *pool,
                             sph2d__svg_element *element, sph2d_report *report)
{
    search s = {.source = source, .id = id, .pool = pool, .report = report};
    sph2d_status status = parse(&s);
    return status == SPH2D_OK ? choose(&s, element) : status;
}
