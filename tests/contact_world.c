/* SPDX-License-Identifier: MIT */
#include "contact_world.h"

#include <check.h>
#include <math.h>
#include <string.h>

#include "base/pi.h"

#define DENSITY 1000.0

contact_world *world_new(void)
{
    static contact_world world;
    memset(&world, 0, sizeof world);
    world.scene = sph2d_scene_default();
    world.scene.domain = (sph2d_box){{0, 0}, {1, 1}};
    world.scene.boundary.top = SPH2D_SIDE_WALL;
    world.scene.spacing = 0.001;
    world.scene.bodies = world.bodies;
    world.scene.obstacles = world.obstacles;
    world.gravity = (sph2d_vec2){0, -9.81};
    world.dt = 5e-4;
    return &world;
}

static uint32_t add(contact_world *w, sph2d_shape outline, sph2d_vec2 center, double mass, double inertia)
{
    uint32_t i = (uint32_t)w->scene.body_count++;
    w->bodies[i] = (sph2d_body){.shape = outline, .center = center, .friction = 0.3};
    w->states[i] = (sph2d_contact_body){.inverse_mass_x = 1 / mass, .inverse_mass_y = 1 / mass};
    w->states[i].inverse_inertia = 1 / inertia;
    w->states[i].center = center;
    return i;
}

uint32_t world_disc(contact_world *w, double x, double y, double radius)
{
    double mass = DENSITY * SPH2D__PI * radius * radius;
    sph2d_shape outline = {.kind = SPH2D_SHAPE_CIRCLE, .circle = {{x, y}, radius}};
    return add(w, outline, (sph2d_vec2){x, y}, mass, mass * radius * radius / 2);
}

uint32_t world_box(contact_world *w, double x, double y, double width, double height)
{
    double mass = DENSITY * width * height;
    sph2d_shape outline = {.kind = SPH2D_SHAPE_BOX};
    outline.box = (sph2d_box){{x - width / 2, y - height / 2}, {x + width / 2, y + height / 2}};
    return add(w, outline, (sph2d_vec2){x, y}, mass, mass * (width * width + height * height) / 12);
}

uint32_t world_polygon(contact_world *w, sph2d_points corners, sph2d_vec2 center, double mass, double inertia)
{
    return add(w, (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = corners}, center, mass, inertia);
}

void world_obstacle(contact_world *w, sph2d_shape outline, sph2d_vec2 center)
{
    size_t i = w->scene.obstacle_count++;
    w->obstacles[i] = sph2d_obstacle_default();
    w->obstacles[i].shape = outline;
    w->obstacles[i].motion.center = center;
    w->walls[i].center = center;
}

double world_kinetic(const contact_world *w)
{
    double sum = 0;
    for (size_t i = 0; i < w->scene.body_count; ++i) {
        const sph2d_contact_body *b = &w->states[i];
        sum += b->inverse_mass_x > 0 ? b->velocity.x * b->velocity.x / b->inverse_mass_x / 2 : 0;
        sum += b->inverse_mass_y > 0 ? b->velocity.y * b->velocity.y / b->inverse_mass_y / 2 : 0;
        sum += b->inverse_inertia > 0 ? b->rate * b->rate / b->inverse_inertia / 2 : 0;
    }
    return sum;
}

double world_energy(const contact_world *w)
{
    double sum = world_kinetic(w);
    for (size_t i = 0; i < w->scene.body_count; ++i) {
        const sph2d_contact_body *b = &w->states[i];
        sum -= b->inverse_mass_x > 0 ? w->gravity.x * b->center.x / b->inverse_mass_x : 0;
        sum -= b->inverse_mass_y > 0 ? w->gravity.y * b->center.y / b->inverse_mass_y : 0;
    }
    return sum;
}

/** Body i where it is; its corners are valid until the next call but one. */
static sph2d__placed place(const contact_world *w, uint32_t i)
{
    enum { MOST = 16 };
    static sph2d_vec2 room[2][MOST];
    static unsigned calls;
    const sph2d_contact_body *b = &w->states[i];
    const sph2d_shape *shape = &w->bodies[i].shape;
    const sph2d_vec2 from = w->bodies[i].center, to = b->center;
    const double cosine = cos(b->angle), sine = sin(b->angle);
    sph2d_vec2 *corners = room[calls++ % 2];
    const bool circle = shape->kind == SPH2D_SHAPE_CIRCLE;
    const size_t count = circle ? 0 : sph2d_shape_corners(shape, 1, NULL);
    ck_assert_uint_le(count, MOST);
    if (circle)
        corners[0] = shape->circle.center;
    else
        sph2d_shape_corners(shape, 1, corners);
    for (size_t k = 0; k < count + circle; ++k) {
        const double x = corners[k].x - from.x, y = corners[k].y - from.y;
        corners[k] = (sph2d_vec2){to.x + cosine * x - sine * y, to.y + sine * x + cosine * y};
    }
    return (sph2d__placed){.shape = shape, .corners = corners, .corner_count = count, .center = corners[0]};
}

static bool is_disc(const sph2d__placed *p)
{
    return p->shape->kind == SPH2D_SHAPE_CIRCLE;
}

/** How far a body reaches along a direction. */
static double reach(const sph2d__placed *p, sph2d_vec2 d)
{
    if (is_disc(p)) {
        sph2d_vec2 c = p->center;
        return c.x * d.x + c.y * d.y + p->shape->circle.radius;
    }
    double most = -INFINITY;
    for (size_t i = 0; i < p->corner_count; ++i) {
        sph2d_vec2 q = p->corners[i];
        most = fmax(most, q.x * d.x + q.y * d.y);
    }
    return most;
}

/** Overlap of the shadows of two bodies along a direction. */
static double shadow(const sph2d__placed *a, const sph2d__placed *b, double x, double y)
{
    double length = hypot(x, y);
    sph2d_vec2 d = {x / length, y / length}, back = {-d.x, -d.y};
    return length > 0 ? fmin(reach(a, d) + reach(b, back), reach(b, d) + reach(a, back)) : INFINITY;
}

/** The least overlap of shadows along the normals of a's sides, and from its corners to the centre of a disc. */
static double least_shadow(const sph2d__placed *a, const sph2d__placed *b)
{
    double least = INFINITY;
    size_t count = a->corner_count;
    for (size_t i = 0; i < count; ++i) {
        sph2d_vec2 p = a->corners[i], q = a->corners[(i + 1) % count];
        least = fmin(least, shadow(a, b, q.y - p.y, p.x - q.x));
        if (is_disc(b)) {
            sph2d_vec2 c = b->center;
            least = fmin(least, shadow(a, b, c.x - p.x, c.y - p.y));
        }
    }
    return least;
}

double world_overlap(const contact_world *w, uint32_t i, uint32_t j)
{
    sph2d__placed a = place(w, i), b = place(w, j);
    if (is_disc(&a) && is_disc(&b)) {
        sph2d_vec2 p = a.center, q = b.center;
        return a.shape->circle.radius + b.shape->circle.radius - hypot(p.x - q.x, p.y - q.y);
    }
    return fmin(least_shadow(&a, &b), least_shadow(&b, &a));
}

static void measure(contact_world *w)
{
    sph2d_box in = w->scene.domain;
    for (uint32_t i = 0; i < w->scene.body_count; ++i) {
        sph2d__placed a = place(w, i);
        if (w->scene.boundary.left == SPH2D_SIDE_WALL)
            w->overlap = fmax(
                w->overlap, fmax(in.min.x + reach(&a, (sph2d_vec2){-1, 0}), reach(&a, (sph2d_vec2){1, 0}) - in.max.x));
        w->overlap = fmax(w->overlap, in.min.y + reach(&a, (sph2d_vec2){0, -1}));
        for (uint32_t j = 0; j < i; ++j) {
            sph2d_vec2 p = w->states[i].center, q = w->states[j].center;
            if (hypot(p.x - q.x, p.y - q.y) < 0.3)
                w->overlap = fmax(w->overlap, world_overlap(w, i, j));
        }
    }
}

static double work_of_walls(const contact_world *w)
{
    double sum = 0;
    for (size_t i = 0; i < SPH2D__SIDES + w->scene.obstacle_count; ++i)
        sum += w->work[i];
    return sum;
}

void world_step(contact_world *w, bool wanted)
{
    for (size_t i = 0; i < w->scene.body_count; ++i) {
        sph2d_contact_body *b = &w->states[i];
        b->velocity.x += b->inverse_mass_x > 0 ? w->dt * w->gravity.x : 0;
        b->velocity.y += b->inverse_mass_y > 0 ? w->dt * w->gravity.y : 0;
    }
    double before = world_kinetic(w), done = -work_of_walls(w);
    sph2d_status status = sph2d__contacts_solve(&w->scene, w->walls, w->dt, w->states, w->scene.body_count, w->work);
    ck_assert_int_eq(status, SPH2D_OK);
    done += work_of_walls(w);
    double left = world_kinetic(w) - done;
    w->gain = fmax(w->gain, before > 0 ? left / before - 1 : left);
    for (size_t i = 0; i < w->scene.body_count; ++i) {
        sph2d_contact_body *b = &w->states[i];
        b->center = (sph2d_vec2){b->center.x + w->dt * b->velocity.x, b->center.y + w->dt * b->velocity.y};
        b->angle += w->dt * b->rate;
    }
    for (size_t i = 0; i < w->scene.obstacle_count; ++i) {
        sph2d_body_state *s = &w->walls[i];
        s->center = (sph2d_vec2){s->center.x + w->dt * s->velocity.x, s->center.y + w->dt * s->velocity.y};
        s->angle += w->dt * s->rate;
    }
    if (wanted)
        measure(w);
}

void world_run(contact_world *w, int steps)
{
    for (int i = 0; i < steps; ++i)
        world_step(w, true);
}
