/* SPDX-License-Identifier: MIT */
/** @file live_bodies.c
 *  Bodies of a live simulation. */
#include "live_bodies.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- where they are ---------------------------------------------------------------------------------------------- */

static sph2d_vec2 center_of(const sph2d_body *body)
{
    const bool given = !isnan(body->center.x) && !isnan(body->center.y);
    return given ? body->center : sph2d_shape_centroid(&body->shape);
}

body_move live_body_move(const live *l, size_t body)
{
    const sph2d_body_state now = sph2d_sim_body(l->sim, body);
    return (body_move){center_of(&l->scene.bodies[body]), now.center, now.angle};
}

bool live_is_drawn(const live *l, size_t body)
{
    return body >= sph2d_scene_file_scene(l->file)->body_count;
}

sph2d_vec2 live_spring_end(const live *l, size_t body, size_t spring)
{
    const sph2d_vec2 at = l->scene.bodies[body].springs[spring].at;
    const body_move move = live_body_move(l, body);
    return isnan(at.x) || isnan(at.y) ? move.to : body_moved(&move, at);
}

bool live_find_spring(const live *l, sph2d_vec2 at, double reach, size_t *body, size_t *spring)
{
    bool found = false;
    for (size_t k = 0; k < l->scene.body_count; ++k)
        for (size_t i = 0; i < l->scene.bodies[k].spring_count; ++i) {
            const sph2d_vec2 line[2] = {live_spring_end(l, k, i), l->scene.bodies[k].springs[i].to};
            const double far = drawn_distance(line, at);
            if (!(far < reach))
                continue;
            reach = far;
            *body = k;
            *spring = i;
            found = true;
        }
    return found;
}

/* ---- changes ----------------------------------------------------------------------------------------------------- */

/** A changed list of bodies, as far as the scene has them, with room for one more. */
typedef struct change {
    sph2d_scene scene;
    sph2d_body *bodies;
    body_move *moves; /* from the scene to where they are now */
} change;

/* Where periodic sides set a place back [m]. */
static double set_back(double x, double least, double most, bool periodic)
{
    return periodic ? x - floor((x - least) / (most - least)) * (most - least) : x;
}

/* The bodies with their velocities of now. False: memory is short. */
static bool begin_change(const live *l, change *c)
{
    const size_t count = l->scene.body_count;
    *c = (change){l->scene, calloc(count + 1, sizeof *c->bodies), calloc(count + 1, sizeof *c->moves)};
    if (!c->bodies || !c->moves)
        return false;
    const sph2d_box d = l->scene.domain;
    const sph2d_boundary sides = l->scene.boundary;
    for (size_t k = 0; k < count; ++k) {
        const sph2d_body_state now = sph2d_sim_body(l->sim, k);
        c->bodies[k] = l->scene.bodies[k];
        c->bodies[k].velocity = now.velocity;
        c->bodies[k].rate = now.rate;
        c->moves[k] = live_body_move(l, k);
        sph2d_vec2 *to = &c->moves[k].to;
        to->x = set_back(to->x, d.min.x, d.max.x, sides.left == SPH2D_SIDE_PERIODIC);
        to->y = set_back(to->y, d.min.y, d.max.y, sides.bottom == SPH2D_SIDE_PERIODIC);
    }
    c->scene.bodies = c->bodies;
    return true;
}

/* Removes the liquid in the way of a body of the new simulation, and counts it. */
static sph2d_status clear_body(const live *l, sph2d_sim *sim, const void *body, size_t *removed)
{
    const double more = live_clearance(l);
    const sph2d_shape outline = sph2d_sim_scene(sim)->bodies[*(const size_t *)body].shape;
    const size_t count = sph2d_shape_corners(&outline, l->scene.spacing, NULL);
    sph2d_vec2 *corners = malloc((count + 1) * sizeof *corners);
    if (!corners)
        return SPH2D_NOMEM;
    sph2d_shape_corners(&outline, l->scene.spacing, corners);
    corners[count] = corners[0];
    sph2d_status status = sph2d_sim_remove_particles(sim, &outline, removed);
    for (size_t k = 0; k < count && status == SPH2D_OK; ++k) { /* a strip along each side */
        const drawn_line side = {.corners = corners + k, .pieces = 1, .start = {0, 1}};
        sph2d_vec2 strip[2 * DRAWN_MOST_CORNERS];
        size_t here = 0;
        const sph2d_shape shape = {.kind = SPH2D_SHAPE_POLYGON,
                                   .points = {strip, drawn_solid(&side, 0, 2 * more, more, strip)}};
        status = sph2d_sim_remove_particles(sim, &shape, &here);
        *removed += here;
    }
    free(corners);
    return status;
}

/* Whether a body is between the walls and clear of what else there is. A simulation that goes on is not asked that, for its
 * bodies may be anywhere; here all start where they are, and of the others contacts may be a little too near. */
static sph2d_status check_room(const sph2d_scene *changed, size_t body, sph2d_report *report)
{
    const size_t last = changed->body_count - 1;
    sph2d_scene scene = *changed;
    sph2d_body *bodies = malloc(changed->body_count * sizeof *bodies);
    if (!bodies)
        return SPH2D_NOMEM;
    memcpy(bodies, changed->bodies, changed->body_count * sizeof *bodies);
    bodies[last] = changed->bodies[body]; /* which is compared with those before */
    bodies[body] = changed->bodies[last];
    scene.bodies = bodies;
    sph2d_report all = {0};
    char path[48];
    snprintf(path, sizeof path, "bodies[%zu]", last);
    sph2d_scene_check(&scene, &all);
    free(bodies);
    const sph2d_diagnostic *found = NULL;
    for (size_t i = 0; i < all.count && !found; ++i)
        if (all.items[i].severity == SPH2D_ERROR && strncmp(all.items[i].path, path, strlen(path)) == 0)
            found = &all.items[i];
    if (found)
        sph2d_report_add(report, SPH2D_ERROR, found->code, path, "%s", found->message);
    sph2d_report_clear(&all);
    return found ? SPH2D_SCENE : SPH2D_OK;
}

/* Goes on with the change, and frees it; `clears` is a body for which there must be room, NULL for none. */
static sph2d_status end_change(live *l, change *c, const size_t *clears, size_t *removed, sph2d_report *report)
{
    sph2d_scene scene = c->scene;
    void *lists = c->bodies && c->moves ? lists_copy(&scene, c->moves) : NULL;
    free(c->bodies);
    free(c->moves);
    const sph2d_status status = lists && clears ? check_room(&scene, *clears, report) : SPH2D_OK;
    if (status != SPH2D_OK) {
        free(lists);
        return status;
    }
    return live_rebuild(l, &scene, lists, true, clears ? clear_body : NULL, clears, removed, report);
}

sph2d_status live_add_body(live *l, const sph2d_shape *shape, double density, size_t *removed, sph2d_report *report)
{
    change c;
    const size_t added = l->scene.body_count;
    if (begin_change(l, &c)) {
        c.bodies[added] = sph2d_body_default();
        c.bodies[added].shape = *shape;
        c.bodies[added].density = density;
        ++c.scene.body_count;
    }
    return end_change(l, &c, &added, removed, report);
}

sph2d_status live_remove_body(live *l, size_t body, sph2d_report *report)
{
    change c;
    if (begin_change(l, &c)) {
        const size_t after = --c.scene.body_count - body;
        memmove(c.bodies + body, c.bodies + body + 1, after * sizeof *c.bodies);
        memmove(c.moves + body, c.moves + body + 1, after * sizeof *c.moves);
    }
    return end_change(l, &c, NULL, NULL, report);
}

sph2d_status live_put_body(live *l, size_t body, const body_move *shift, size_t *removed, sph2d_report *report)
{
    change c;
    if (begin_change(l, &c)) {
        c.moves[body].to = body_moved(shift, c.moves[body].to);
        c.moves[body].angle += shift->angle;
    }
    return end_change(l, &c, &body, removed, report);
}

/* ---- springs ----------------------------------------------------------------------------------------------------- */

/* The weight of a body [N/m], or of the liquid in its place where that is more. */
static double weight_of(const live *l, const sph2d_body *body)
{
    const size_t count = sph2d_shape_corners(&body->shape, l->scene.spacing, NULL);
    sph2d_vec2 *corners = malloc((count + 1) * sizeof *corners);
    if (!corners)
        return 0;
    sph2d_shape_corners(&body->shape, l->scene.spacing, corners);
    double area = 0;
    for (size_t k = 0, j = count - 1; k < count; j = k++)
        area += (corners[j].x * corners[k].y - corners[k].x * corners[j].y) / 2;
    free(corners);
    const double own = body->mass > 0 ? body->mass : body->density * fabs(area);
    const sph2d_vec2 g = nozzle_gravity(&l->scene);
    return fmax(own, l->scene.fluid.density * fabs(area)) * hypot(g.x, g.y);
}

/* Under that weight a hinge gives way by a spacing, as fine as anything is here, and a spring by a quarter of its length:
 * what is stiffer needs steps that do not follow the clock. */
static sph2d_spring spring_of(const live *l, const sph2d_body *body, double length)
{
    const double weight = weight_of(l, body);
    const sph2d_vec2 g = nozzle_gravity(&l->scene);
    sph2d_spring spring = sph2d_spring_default();
    spring.length = length;
    spring.stiffness = weight / (length > 0 ? length / 4 : l->scene.spacing);
    if (length == 0) /* half of the critical damping of that mass */
        spring.damping = sqrt(spring.stiffness * weight / hypot(g.x, g.y));
    return spring;
}

/* Goes on with springs of a body's own, which are freed; NULL: memory was short. */
static sph2d_status end_springs(live *l, change *c, sph2d_spring *springs, sph2d_report *report)
{
    if (!springs) {
        free(c->moves);
        c->moves = NULL;
    }
    const sph2d_status status = end_change(l, c, NULL, NULL, report);
    free(springs);
    return status;
}

sph2d_status live_hold(live *l, size_t body, sph2d_vec2 at, sph2d_vec2 to, sph2d_report *report)
{
    change c;
    sph2d_spring *springs = NULL;
    if (begin_change(l, &c)) {
        sph2d_body *b = &c.bodies[body];
        springs = malloc((b->spring_count + 1) * sizeof *springs);
        if (springs) {
            if (b->spring_count > 0)
                memcpy(springs, b->springs, b->spring_count * sizeof *springs);
            const body_move now = live_body_move(l, body);
            sph2d_spring *s = &springs[b->spring_count++];
            *s = spring_of(l, b, hypot(to.x - at.x, to.y - at.y));
            s->at = body_moved_back(&now, at);
            s->to = to;
            b->springs = springs;
        }
    }
    return end_springs(l, &c, springs, report);
}

sph2d_status live_release(live *l, size_t body, size_t spring, sph2d_report *report)
{
    change c;
    sph2d_spring *springs = NULL;
    if (begin_change(l, &c)) {
        sph2d_body *b = &c.bodies[body];
        const size_t after = --b->spring_count - spring;
        springs = malloc((spring + after + 1) * sizeof *springs);
        if (springs) {
            memcpy(springs, b->springs, spring * sizeof *springs);
            memcpy(springs + spring, b->springs + spring + 1, after * sizeof *springs);
            b->springs = springs;
        }
    }
    return end_springs(l, &c, springs, report);
}
