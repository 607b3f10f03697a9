/* SPDX-License-Identifier: MIT */
/** @file relax.c
 *  Velocities after contacts, group by group.
 *
 *  What a group must do is that nothing comes nearer than the clearance: in the coordinates of impulses the minimum of
 *  an energy that is 0 without impulses, so that kinetic energy does not grow, but by the work of walls. What it should
 *  do beside is to bounce and to push out what overlaps, which may take energy that is not there. Both are solved, and
 *  where the second has too much energy, velocities are taken between the two. Both are convex sets, so what lies
 *  between fulfils the first. */
#include <math.h>

#include "contacts/contacts.h"
#include "contacts/rows.h"

/* In a step what lacks of the clearance is made up by this part. */
#define PUSH 0.2
/* Slower than this part of sqrt(g size) nothing bounces; g is Earth's. */
#define SLOW 0.05
#define EARTH 9.81
/* Energy may exceed its bound by this part, which is rounding. */
#define ROUNDING 1e-13

/** Velocity and angular velocity. */
typedef struct motion {
    double vx, vy, w;
} motion;

/** A group, and all its memory. */
typedef struct group {
    sph2d__row *rows;
    double *should; /**< of each row: the speed of separation with bounces and pushes */
    double *work;   /**< of the wall of each row, by what the bodies' velocities have of its impulses [J/m] */
    size_t row_count;
    sph2d__mover *movers;        /**< of all groups */
    const sph2d__member *bodies; /**< of this one */
    size_t body_count;
    motion *start, *must; /**< of each body of the group: before contacts, and with what it must do alone */
} group;

static double over(double value, double inverse)
{
    return inverse > 0 ? value / inverse : 0;
}

static motion motion_of(const sph2d__mover *m)
{
    return (motion){m->vx, m->vy, m->w};
}

/** The products of two motions of a body with its mass and inertia. */
static double product(const sph2d__mover *m, motion a, motion b)
{
    return over(a.vx * b.vx, m->imx) + over(a.vy * b.vy, m->imy) + over(a.w * b.w, m->ii);
}

/** Work that the wall of a row did by its impulses, which are those on the wall. */
static double row_work(const sph2d__row *row)
{
    return -(row->jn * row->wall_n + row->jt * row->wall_t);
}

/** Work that walls did by the impulses of a group. */
static double work_of_walls(const group *g)
{
    double work = 0;
    for (size_t i = 0; i < g->row_count; ++i)
        work += row_work(&g->rows[i]);
    return work;
}

/** Books parts of the work so far, and of that by the present impulses: of the velocities that are taken between. */
static void book_work(const group *g, double so_far, double now)
{
    for (size_t i = 0; i < g->row_count; ++i)
        g->work[i] = so_far * g->work[i] + now * row_work(&g->rows[i]);
}

/** Takes velocities between `from` and those now, such that kinetic energy without the work of walls is no higher than
 *  that of the start. `from_work` and `work` are the work of walls for both. Returns how near to those now. */
static double limit_energy(const group *g, const motion *from, double from_work, double work)
{
    double square = 0, linear = from_work - work, constant = -from_work, energy = 0;
    for (size_t i = 0; i < g->body_count; ++i) {
        const sph2d__mover *m = &g->movers[g->bodies[i].index];
        motion d = {m->vx - from[i].vx, m->vy - from[i].vy, m->w - from[i].w};
        double start = product(m, g->start[i], g->start[i]) / 2;
        square += product(m, d, d) / 2;
        linear += product(m, from[i], d);
        constant += product(m, from[i], from[i]) / 2 - start;
        energy += start;
    }
    if (square + linear + constant <= ROUNDING * (energy + fabs(work)))
        return 1;
    double part = 0;
    if (constant < 0 || linear < 0) {
        double below = fmin(constant, 0), root = sqrt(linear * linear - 4 * square * below);
        part = linear > 0 ? -2 * below / (linear + root) : (root - linear) / (2 * square);
    }
    part = fmax(0, fmin(1, part));
    for (size_t i = 0; i < g->body_count; ++i) {
        sph2d__mover *m = &g->movers[g->bodies[i].index];
        m->vx = from[i].vx + part * (m->vx - from[i].vx);
        m->vy = from[i].vy + part * (m->vy - from[i].vy);
        m->w = from[i].w + part * (m->w - from[i].w);
    }
    return part;
}

static void prepare(sph2d__row *row, double *should, const sph2d__contacts *c, const sph2d__contact *contact,
                    const sph2d__mover *movers)
{
    double nx = contact->normal.x, ny = contact->normal.y;
    sph2d_vec2 a = contact->arm_a, b = contact->arm_b;
    *row = (sph2d__row){.a = contact->a, .b = contact->b, .nx = nx, .ny = ny, .friction = contact->friction};
    row->an = a.x * ny - a.y * nx;
    row->at = a.x * nx + a.y * ny;
    row->bn = b.x * ny - b.y * nx;
    row->bt = b.x * nx + b.y * ny;
    row->wall_n = contact->wall.x * nx + contact->wall.y * ny;
    row->wall_t = contact->wall.y * nx - contact->wall.x * ny;
    sph2d__row_weigh(row, movers);
    double spare = contact->gap - c->clearance, speed = sph2d__row_separation(row, movers);
    row->least = fmin(0, -spare / c->dt);
    *should = spare < 0 ? PUSH * -spare / c->dt : row->least;
    if (speed < -SLOW * sqrt(EARTH * contact->size) && spare + speed * c->dt < 0)
        *should = fmax(*should, -contact->restitution * speed);
}

/** Whether a group has anything beside what it must do; then that becomes what it does. */
static bool ask_for_more(group *g)
{
    bool more = false;
    for (size_t i = 0; i < g->row_count; ++i)
        more = more || g->should[i] > g->rows[i].least;
    for (size_t i = 0; i < g->row_count && more; ++i) {
        double must = g->rows[i].least;
        g->rows[i].least = g->should[i];
        g->should[i] = must;
    }
    return more;
}

/** Begins anew with what the group must do. Velocities so far are kept in `must`. */
static void begin_anew(group *g)
{
    for (size_t i = 0; i < g->body_count; ++i) {
        sph2d__mover *m = &g->movers[g->bodies[i].index];
        g->must[i] = motion_of(m);
        m->vx = g->start[i].vx;
        m->vy = g->start[i].vy;
        m->w = g->start[i].w;
    }
    for (size_t i = 0; i < g->row_count; ++i) {
        sph2d__row *row = &g->rows[i];
        row->least = g->should[i];
        row->jn = row->jt = row->pn = row->pt = 0;
    }
}

/** Exchanges the velocities of the bodies with those in `must`. */
static void exchange(group *g)
{
    for (size_t i = 0; i < g->body_count; ++i) {
        sph2d__mover *m = &g->movers[g->bodies[i].index];
        motion other = g->must[i];
        g->must[i] = motion_of(m);
        m->vx = other.vx;
        m->vy = other.vy;
        m->w = other.w;
    }
}

/** Whether kinetic energy without the work of walls has not grown. */
static bool affordable(const group *g)
{
    double rise = -work_of_walls(g), energy = 0;
    for (size_t i = 0; i < g->body_count; ++i) {
        const sph2d__mover *m = &g->movers[g->bodies[i].index];
        double start = product(m, g->start[i], g->start[i]) / 2;
        rise += product(m, motion_of(m), motion_of(m)) / 2 - start;
        energy += start;
    }
    return rise <= ROUNDING * energy;
}

static void relax_group(group *g)
{
    for (size_t i = 0; i < g->body_count; ++i)
        g->start[i] = motion_of(&g->movers[g->bodies[i].index]);
    bool more = ask_for_more(g);
    sph2d__rows_solve(g->rows, g->row_count, g->movers);
    book_work(g, 0, 1);
    if (more && affordable(g))
        return;
    double work = work_of_walls(g);
    if (more) {
        begin_anew(g);
        sph2d__rows_solve(g->rows, g->row_count, g->movers);
    }
    double must_work = work_of_walls(g);
    double part = limit_energy(g, g->start, 0, must_work), rest = 0;
    if (more) {
        exchange(g);
        rest = limit_energy(g, g->must, part * must_work, work);
    }
    book_work(g, rest, (1 - rest) * part);
}

/** Adds the work of a group's walls to that of all. */
static void tell_work(sph2d__contacts *c, const group *g, const sph2d__member *contacts)
{
    for (size_t k = 0; k < g->row_count; ++k) {
        const sph2d__contact *contact = &c->contacts[contacts[k].index];
        if (contact->b == c->body_count)
            c->wall_work[contact->wall_number] += g->work[k];
    }
}

/** Memory for movers and for the largest group. */
static bool make_room(sph2d__contacts *c, group *g, size_t rows, size_t bodies)
{
    g->movers = sph2d__arena_alloc(&c->arena, &c->memory, c->body_count + (size_t)1, sizeof *g->movers);
    g->rows = sph2d__arena_alloc(&c->arena, &c->memory, rows, sizeof *g->rows);
    g->should = sph2d__arena_alloc(&c->arena, &c->memory, rows, sizeof *g->should);
    g->work = sph2d__arena_alloc(&c->arena, &c->memory, rows, sizeof *g->work);
    g->start = sph2d__arena_alloc(&c->arena, &c->memory, bodies, sizeof *g->start);
    g->must = sph2d__arena_alloc(&c->arena, &c->memory, bodies, sizeof *g->must);
    return g->movers && g->rows && g->should && g->work && g->start && g->must;
}

/** How many of the members from the first one on are of its group. */
static size_t count_group(const sph2d__member *members, size_t most)
{
    size_t count = 0;
    while (count < most && members[count].group == members[0].group)
        ++count;
    return count;
}

sph2d_status sph2d__relax(sph2d__contacts *c, const sph2d__groups *groups)
{
    group g = {0};
    if (!make_room(c, &g, c->contact_count, c->body_count))
        return SPH2D_NOMEM;
    for (uint32_t i = 0; i < c->body_count; ++i) {
        const sph2d_contact_body *b = &c->bodies[i];
        g.movers[i] = (sph2d__mover){b->velocity.x,     b->velocity.y,     b->rate,
                                     b->inverse_mass_x, b->inverse_mass_y, b->inverse_inertia};
    }
    size_t body = 0;
    for (size_t first = 0; first < c->contact_count; first += g.row_count) {
        const sph2d__member *contacts = groups->contacts + first;
        g.bodies = groups->bodies + body;
        g.body_count = count_group(g.bodies, groups->body_count - body);
        g.row_count = count_group(contacts, c->contact_count - first);
        for (size_t k = 0; k < g.row_count; ++k)
            prepare(&g.rows[k], &g.should[k], c, &c->contacts[contacts[k].index], g.movers);
        relax_group(&g);
        tell_work(c, &g, contacts);
        body += g.body_count;
    }
    for (uint32_t i = 0; i < c->body_count; ++i) {
        c->bodies[i].velocity = (sph2d_vec2){g.movers[i].vx, g.movers[i].vy};
        c->bodies[i].rate = g.movers[i].w;
    }
    return SPH2D_OK;
}
