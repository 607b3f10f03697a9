/* SPDX-License-Identifier: MIT */
/** @file touch.c
 *  Where bodies are near each other, obstacles and the sides of the domain. */
#include <chipmunk/chipmunk.h>
#include <math.h>

#include "contacts/contacts.h"

/** Adds a contact at a point in the middle of a gap. */
static sph2d_status add(sph2d__contacts *c, const sph2d__placed *a, const sph2d__placed *b, sph2d_vec2 normal,
                        sph2d_vec2 at, double gap)
{
    if (!sph2d__room_for_one(&c->memory, &c->contacts, c->contact_count, &c->contact_room, sizeof *c->contacts))
        return SPH2D_NOMEM;
    sph2d__contact *contact = &c->contacts[c->contact_count++];
    const sph2d_body *first = &c->scene->bodies[a->number];
    *contact = (sph2d__contact){.a = a->number, .b = b->number, .normal = normal, .gap = gap};
    contact->arm_a = (sph2d_vec2){at.x - a->to.x, at.y - a->to.y};
    contact->arm_b = (sph2d_vec2){at.x - b->to.x, at.y - b->to.y};
    contact->size = fmin(a->box.max.x - a->box.min.x, a->box.max.y - a->box.min.y) - 2 * c->margin;
    if (b->number == c->body_count) {
        contact->wall = sph2d__wall_velocity(b, at);
        contact->wall_number = b->wall;
        contact->friction = first->friction;
        contact->restitution = first->restitution;
    } else {
        const sph2d_body *second = &c->scene->bodies[b->number];
        contact->friction = sqrt(first->friction * second->friction);
        contact->restitution = fmax(first->restitution, second->restitution);
        double size = fmin(b->box.max.x - b->box.min.x, b->box.max.y - b->box.min.y) - 2 * c->margin;
        contact->size = fmin(contact->size, size);
    }
    return SPH2D_OK;
}

/** Adds the contact of a circle with a polygon, of which one is a piece of `a`. Not by cpShapesCollide(), which adds
 *  the radius of the polygon with the wrong sign (7.0.3). */
static sph2d_status collide_circle(sph2d__contacts *c, const sph2d__placed *a, const sph2d__placed *b,
                                   const cpShape *polygon)
{
    const sph2d__placed *circle = a->shape->kind == SPH2D_SHAPE_CIRCLE ? a : b;
    sph2d_vec2 center = circle->center;
    cpPointQueryInfo nearest;
    double distance = cpShapePointQuery(polygon, cpv(center.x, center.y), &nearest) + c->margin;
    double gap = distance - circle->shape->circle.radius;
    if (gap > 2 * c->margin)
        return SPH2D_OK;
    /* The gradient leads from the polygon to the centre. */
    cpVect g = nearest.gradient;
    double middle = distance - gap / 2;
    sph2d_vec2 normal = circle == a ? (sph2d_vec2){-g.x, -g.y} : (sph2d_vec2){g.x, g.y};
    return add(c, a, b, normal, (sph2d_vec2){center.x - middle * g.x, center.y - middle * g.y}, gap);
}

/** Whether the outline of `a` is a circle, and `b` is a polygon. */
static bool circle_and_polygon(const sph2d__placed *a, const sph2d__placed *b)
{
    return a->shape->kind == SPH2D_SHAPE_CIRCLE && b->shape->kind != SPH2D_SHAPE_CIRCLE && b->piece_count > 0;
}

/** Adds the contacts of two shapes. */
static sph2d_status collide(sph2d__contacts *c, const sph2d__placed *a, const sph2d__placed *b, const cpShape *first,
                            const cpShape *second)
{
    if (!cpBBIntersects(cpShapeGetBB(first), cpShapeGetBB(second)))
        return SPH2D_OK;
    if (circle_and_polygon(a, b) || circle_and_polygon(b, a))
        return collide_circle(c, a, b, circle_and_polygon(a, b) ? second : first);
    cpContactPointSet set = cpShapesCollide(first, second);
    sph2d_status status = SPH2D_OK;
    for (int i = 0; i < set.count && status == SPH2D_OK; ++i) {
        cpVect p = set.points[i].pointA, q = set.points[i].pointB, at = cpvlerp(p, q, 0.5);
        /* Not the distance of the set, which has the wrong sign for a polygon and a segment in this order (7.0.3). */
        double gap = cpvdot(cpvsub(q, p), set.normal) + 2 * c->margin;
        status = add(c, a, b, (sph2d_vec2){set.normal.x, set.normal.y}, (sph2d_vec2){at.x, at.y}, gap);
    }
    return status;
}

/** Contacts of a shape with all of `b`. */
static sph2d_status collide_with_all(sph2d__contacts *c, const sph2d__placed *a, const sph2d__placed *b,
                                     const cpShape *first)
{
    sph2d_status status = SPH2D_OK;
    for (size_t i = 0; i < b->piece_count && status == SPH2D_OK; ++i)
        status = collide(c, a, b, first, b->pieces[i]);
    cpBB bb = cpShapeGetBB(first);
    sph2d_box box = {{bb.l, bb.b}, {bb.r, bb.t}};
    size_t edges = b->piece_count > 0 ? 0 : sph2d__edge_count(b);
    for (size_t i = 0; i < edges && status == SPH2D_OK; ++i) {
        cpShape *edge = sph2d__edge(c, b, i, &box);
        if (!edge)
            continue;
        status = collide(c, a, b, first, edge);
        cpShapeFree(edge);
    }
    return status;
}

static sph2d_status collide_all(sph2d__contacts *c, const sph2d__placed *a, const sph2d__placed *b)
{
    sph2d_status status = SPH2D_OK;
    for (size_t i = 0; i < a->piece_count && status == SPH2D_OK; ++i)
        status = collide_with_all(c, a, b, a->pieces[i]);
    size_t edges = a->piece_count > 0 ? 0 : sph2d__edge_count(a);
    for (size_t i = 0; i < edges && status == SPH2D_OK; ++i) {
        cpShape *edge = sph2d__edge(c, a, i, &b->box);
        if (!edge)
            continue;
        status = collide_with_all(c, a, b, edge);
        cpShapeFree(edge);
    }
    return status;
}

/** What a body has to keep on one side of a wall: its corners, or a circle. */
typedef struct points {
    size_t count;
    double radius; /**< of a circle, of which the only point is the centre */
} points;

static points points_of(const sph2d__placed *placed)
{
    if (placed->shape->kind == SPH2D_SHAPE_CIRCLE)
        return (points){1, placed->shape->circle.radius};
    return (points){placed->corner_count, 0};
}

static sph2d_vec2 point(const sph2d__placed *placed, size_t index)
{
    return placed->shape->kind == SPH2D_SHAPE_CIRCLE ? placed->center : placed->corners[index];
}

/** Adds the contact of a point of a body with a wall, if it is near. */
static sph2d_status stop(sph2d__contacts *c, const sph2d__placed *body, const sph2d__placed *wall, sph2d_vec2 p,
                         sph2d_vec2 normal, double gap, double radius)
{
    if (gap > 2 * c->margin)
        return SPH2D_OK;
    double middle = radius + gap / 2;
    return add(c, body, wall, normal, (sph2d_vec2){p.x + middle * normal.x, p.y + middle * normal.y}, gap);
}

/** Contacts of a body with the side of a circle that it is in. */
static sph2d_status inside_circle(sph2d__contacts *c, const sph2d__placed *body, const sph2d__placed *circle)
{
    points all = points_of(body);
    sph2d_vec2 center = circle->center;
    sph2d_status status = SPH2D_OK;
    for (size_t i = 0; i < all.count && status == SPH2D_OK; ++i) {
        sph2d_vec2 p = point(body, i);
        double distance = hypot(p.x - center.x, p.y - center.y);
        if (distance > 0) {
            sph2d_vec2 normal = {(p.x - center.x) / distance, (p.y - center.y) / distance};
            double gap = circle->shape->circle.radius - distance - all.radius;
            status = stop(c, body, circle, p, normal, gap, all.radius);
        }
    }
    return status;
}

/** Whether `b` is a hollow circle with the body in it. */
static bool is_inside(const sph2d__placed *body, const sph2d__placed *b)
{
    if (!b->hollow || b->shape->kind != SPH2D_SHAPE_CIRCLE)
        return false;
    sph2d_vec2 center = b->center;
    return hypot(body->to.x - center.x, body->to.y - center.y) < b->shape->circle.radius;
}

static sph2d_status with_side(sph2d__contacts *c, const sph2d__placed *body, uint32_t number, double at, double speed)
{
    static const sph2d_vec2 outward[SPH2D__SIDES] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    sph2d_vec2 normal = outward[number];
    sph2d__placed side = {.number = c->body_count, .wall = number};
    side.velocity = (sph2d_vec2){normal.y != 0 ? speed : 0, normal.x != 0 ? speed : 0};
    points all = points_of(body);
    sph2d_status status = SPH2D_OK;
    for (size_t i = 0; i < all.count && status == SPH2D_OK; ++i) {
        sph2d_vec2 p = point(body, i);
        double gap = at - (normal.x * p.x + normal.y * p.y) - all.radius;
        status = stop(c, body, &side, p, normal, gap, all.radius);
    }
    return status;
}

/** Contacts of a body with the sides of the domain that are walls. */
static sph2d_status with_sides(sph2d__contacts *c, const sph2d__placed *body)
{
    const sph2d_boundary *sides = &c->scene->boundary;
    const sph2d_side_speeds *speeds = &c->scene->wall_speeds;
    sph2d_box in = c->scene->domain;
    double m = c->margin;
    sph2d_status status = SPH2D_OK;
    if (sides->left == SPH2D_SIDE_WALL && body->box.min.x < in.min.x + m)
        status = with_side(c, body, SPH2D__SIDE_LEFT, -in.min.x, speeds->left);
    if (status == SPH2D_OK && sides->right == SPH2D_SIDE_WALL && body->box.max.x > in.max.x - m)
        status = with_side(c, body, SPH2D__SIDE_RIGHT, in.max.x, speeds->right);
    if (status == SPH2D_OK && sides->bottom == SPH2D_SIDE_WALL && body->box.min.y < in.min.y + m)
        status = with_side(c, body, SPH2D__SIDE_BOTTOM, -in.min.y, speeds->bottom);
    if (status == SPH2D_OK && sides->top == SPH2D_SIDE_WALL && body->box.max.y > in.max.y - m)
        status = with_side(c, body, SPH2D__SIDE_TOP, in.max.y, speeds->top);
    return status;
}

sph2d_status sph2d__find_contacts(sph2d__contacts *c)
{
    sph2d_status status = SPH2D_OK;
    for (uint32_t i = 0; i < c->body_count && status == SPH2D_OK; ++i)
        status = sph2d__moves(c, i) ? with_sides(c, &c->placed[i]) : SPH2D_OK;
    for (size_t i = 0; i < c->pair_count && status == SPH2D_OK; ++i) {
        sph2d__placed *a = &c->placed[c->pairs[i].a], *b = &c->placed[c->pairs[i].b];
        status = sph2d__cut(c, a);
        if (status == SPH2D_OK)
            status = sph2d__cut(c, b);
        if (status != SPH2D_OK)
            break;
        status = is_inside(a, b) ? inside_circle(c, a, b) : collide_all(c, a, b);
    }
    return status;
}
