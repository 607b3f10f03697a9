/* SPDX-License-Identifier: MIT */
/** @file wcsph_bodies.c
 *  Bodies that the liquid moves, in acoustic steps. A velocity w = (U, V, Omega) of a body changes D_i of the liquid beside
 *  it, and the force on the body is the transpose of that. With v_b = w_d u_b, u_b = (1, 0), (0, 1), (-arm_y, arm_x), and
 *  a_ib = B_i G_ib,
 *
 *      s_id = sum_b u_b . Q_i a_ib,  t_id = sum_b (u_b . a_ib) r_ib
 *      D_i -= 2 w_d s_id;  z_i -= A_i w_d t_id;  F_d = sum_i ((2 P_i + l_i) s_id - e_i . t_id)
 *
 *  where e_i = A_i sum_k (P_k - P_i) G_ik. Where liquid sticks, with K_ib and k_ib (wcsph_friction.c), these are its
 *  forces on the liquid; that on the body, minus their sum, takes the body's velocity as it is at the step's start. So a
 *  body takes part in what acoustic steps keep, with its own mass, however light it is: they are as short as D's row of a
 *  body over that mass asks for. */
#include <string.h>

#include "methods/wcsph/wcsph.h"

/** A pair of a particle with a body. */
struct sph2d__frozen_row {
    size_t particle, body;
    double press[3];    /**< s [1/m], and the moment of it */
    double pull[3][2];  /**< t, and the moment of it [m] */
    double repel[3];    /**< the part of front normals, and the moment of it [1, m] */
    double stick[3][2]; /**< sum_b u_b . K_ib [1/s] */
    double drive[3];    /**< sum_b u_b . k_ib [m/s^2] */
};

/** The body of a boundary particle; SIZE_MAX: none. */
static size_t body_of(const sph2d__system *s, size_t b)
{
    const uint64_t id = s->walls.id[b];
    for (size_t k = 0; k < s->rigid_count; ++k)
        if (id >= s->rigids[k].first_id && id < s->rigids[k].end_id)
            return k;
    return SIZE_MAX;
}

/** The row of particle i and a body, the last ones being those of particle i; NULL when memory is short. */
static sph2d__frozen_row *row_of(sph2d__system *s, size_t i, size_t body)
{
    sph2d__frozen *z = s->frozen;
    for (size_t k = z->row_count; k > 0 && z->rows[k - 1].particle == i; --k)
        if (z->rows[k - 1].body == body)
            return &z->rows[k - 1];
    if (z->row_count == z->row_capacity) {
        const size_t wanted = 2 * z->row_capacity + 64;
        void *block = z->rows;
        if (!sph2d__resize(s->memory, &block, z->row_capacity, wanted, sizeof *z->rows))
            return NULL;
        z->rows = block;
        z->row_capacity = wanted;
    }
    z->rows[z->row_count] = (sph2d__frozen_row){.particle = i, .body = body};
    return &z->rows[z->row_count++];
}

/** Adds the pair k of the lists, of particle i and boundary particle b. */
static void add_pair(const sph2d__system *s, sph2d__frozen_row *row, size_t k, size_t b)
{
    const sph2d__frozen *z = s->frozen;
    const sph2d__store *w = &s->walls;
    const sph2d__period *p = &s->wall_cells.period;
    const sph2d__rigid *r = &s->rigids[row->body];
    const size_t i = row->particle;
    const sph2d_vec2 center = sph2d__rigid_center(r, r->now);
    const double arm_x = sph2d__period_nearest(w->x[b] - center.x, p->length_x),
                 arm_y = sph2d__period_nearest(w->y[b] - center.y, p->length_y);
    const double gx = (double)z->gx[k], gy = (double)z->gy[k], rx = (double)z->rx[k], ry = (double)z->ry[k];
    const double ax = z->bxx[i] * gx + z->bxy[i] * gy, ay = z->bxy[i] * gx + z->byy[i] * gy;
    const double nx = z->wall_xx[i] * ax + z->wall_xy[i] * ay, ny = z->wall_xy[i] * ax + z->wall_yy[i] * ay;
    const double share = sph2d__front_share(s, i, b, gx, gy, rx, ry);
    const double fx = share * z->front_nx[i], fy = share * z->front_ny[i];
    const double repels[3] = {fx, fy, arm_x * fy - arm_y * fx};
    const double turned = arm_x * ay - arm_y * ax;
    const double pulls[3] = {ax, ay, turned}, presses[3] = {nx, ny, arm_x * ny - arm_y * nx};
    for (int d = 0; d < 3; ++d) {
        row->press[d] += presses[d];
        row->repel[d] += repels[d];
        row->pull[d][0] += pulls[d] * rx;
        row->pull[d][1] += pulls[d] * ry;
    }
    if (!z->sticks)
        return;
    const sph2d__frozen_stick stick = sph2d__frozen_stick_of(s, i, b, gx, gy, rx, ry);
    const double by[3][2] = {{1, 0}, {0, 1}, {-arm_y, arm_x}};
    for (int d = 0; d < 3; ++d) {
        row->stick[d][0] += by[d][0] * stick.xx + by[d][1] * stick.xy;
        row->stick[d][1] += by[d][0] * stick.xy + by[d][1] * stick.yy;
        row->drive[d] += by[d][0] * stick.x + by[d][1] * stick.y;
    }
}

static bool add_slice(sph2d__system *s, size_t first)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__slice *at = &n->slices[first / n->lanes];
    const size_t begin = at->begin + (size_t)at->fluid * n->lanes;
    for (size_t l = 0; l < n->lanes && first + l < s->fluid.count; ++l)
        for (size_t slot = 0, k = begin + l; slot < at->walls; ++slot, k += n->lanes) {
            const size_t b = n->index[k], body = b < s->walls.count ? body_of(s, b) : SIZE_MAX;
            if (body == SIZE_MAX)
                continue;
            sph2d__frozen_row *row = row_of(s, first + l, body);
            if (!row)
                return false;
            add_pair(s, row, k, b);
        }
    return true;
}

bool sph2d__frozen_bodies_gather(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    z->row_count = 0;
    if (s->rigid_count == 0)
        return true;
    if (!z->bodies)
        z->bodies = sph2d__alloc(s->memory, s->rigid_count, sizeof *z->bodies);
    if (!z->bodies)
        return false;
    for (size_t i = 0; i < s->fluid.count; i += s->neighbours.lanes)
        if (!add_slice(s, i))
            return false;
    for (size_t k = 0; k < s->rigid_count; ++k)
        z->bodies[k] = (sph2d__frozen_body){.velocity = s->rigids[k].state->velocity};
    return true;
}

double sph2d__frozen_bodies_rate(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    const double c = s->sound_speed;
    double most = 0;
    for (size_t k = 0; k < s->rigid_count; ++k)
        z->bodies[k].rate2 = z->bodies[k].brake = 0;
    for (size_t k = 0; k < z->row_count; ++k) {
        const sph2d__frozen_row *row = &z->rows[k];
        const sph2d__rigid *r = &s->rigids[row->body];
        const double *p = row->press, size = hypot(p[0], p[1]);
        const double light =
            (r->free.x * p[0] * p[0] + r->free.y * p[1] * p[1]) / r->mass + r->free.turn * p[2] * p[2] / r->inertia;
        z->bodies[row->body].rate2 += 4 * s->mass * c * c * light;
        z->bodies[row->body].brake += size > 0 ? 2 * s->mass * c * light / size : 0;
    }
    for (size_t k = 0; k < s->rigid_count; ++k)
        most = fmax(most, fmax(sqrt(z->bodies[k].rate2), z->bodies[k].brake));
    return most;
}

/** The change of a velocity, times a row. */
static double times(const double row[3], sph2d__twist w)
{
    return row[0] * w.x + row[1] * w.y + row[2] * w.turn;
}

/** The friction so far where liquid sticks, `done` the part of the step. */
static void sum_friction(sph2d__system *s, double done)
{
    sph2d__frozen *z = s->frozen;
    for (size_t k = 0; k < z->row_count; ++k) {
        const sph2d__frozen_row *row = &z->rows[k];
        const size_t i = row->particle;
        double force[3];
        for (int d = 0; d < 3; ++d)
            force[d] =
                s->mass * (row->stick[d][0] * z->mean_vx[i] + row->stick[d][1] * z->mean_vy[i] - done * row->drive[d]);
        z->bodies[row->body].rubbed =
            sph2d__twist_add(z->bodies[row->body].rubbed, 1, (sph2d__twist){force[0], force[1], force[2]});
    }
}

/** Forces in the mean over the step, so far: `done` is the part of it. */
static void sum_forces(sph2d__system *s, double done)
{
    sph2d__frozen *z = s->frozen;
    for (size_t k = 0; k < s->rigid_count; ++k)
        z->bodies[k].mean = z->bodies[k].rubbed = (sph2d__twist){0, 0, 0};
    for (size_t k = 0; k < z->row_count; ++k) {
        const sph2d__frozen_row *row = &z->rows[k];
        const size_t i = row->particle;
        double force[3];
        for (int d = 0; d < 3; ++d)
            force[d] = z->mean_work[i] * row->press[d] - z->mean_ex[i] * row->pull[d][0] -
                       z->mean_ey[i] * row->pull[d][1] - z->mean_repelled[i] * row->repel[d];
        z->bodies[row->body].mean =
            sph2d__twist_add(z->bodies[row->body].mean, 1, (sph2d__twist){force[0], force[1], force[2]});
    }
    if (z->sticks)
        sum_friction(s, done);
}

double sph2d__frozen_bodies_kick(sph2d__system *s, double done, double *friction)
{
    sph2d__frozen *z = s->frozen;
    double work = 0;
    sum_forces(s, done);
    *friction = 0;
    for (size_t k = 0; k < s->rigid_count; ++k) {
        sph2d__frozen_body *b = &z->bodies[k];
        const sph2d__twist rubbed = sph2d__twist_add(b->rubbed, -1, b->rubbed_before);
        const sph2d__twist force = sph2d__twist_add(sph2d__twist_add(b->mean, -1, b->before), 1, rubbed);
        b->change = sph2d__rigid_accelerate(
            &s->rigids[k], sph2d__twist_add(sph2d__twist_add((sph2d__twist){0, 0, 0}, z->dt / z->share, force), z->dt,
                                            s->rigids[k].other));
        b->before = b->mean;
        b->rubbed_before = b->rubbed;
        *friction += z->dt / z->share * sph2d__twist_dot(rubbed, sph2d__twist_add(b->velocity, 0.5, b->change));
        b->way = sph2d__twist_add(b->way, z->share, sph2d__twist_add(b->velocity, 0.5, b->change));
        b->velocity = sph2d__twist_add(b->velocity, 1, b->change);
    }
    for (size_t k = 0; k < z->row_count; ++k) {
        const sph2d__frozen_row *row = &z->rows[k];
        const sph2d__frozen_body *b = &z->bodies[row->body];
        const sph2d__twist w = b->change;
        const size_t i = row->particle;
        const double flux = 2 * times(row->press, w);
        double tx = 0, ty = 0;
        const double by[3] = {w.x, w.y, w.turn};
        for (int d = 0; d < 3; ++d) {
            tx += by[d] * row->pull[d][0];
            ty += by[d] * row->pull[d][1];
        }
        const double part = -z->walled[i]; /* which e has, too */
        const double dx = part * (z->axx[i] * tx + z->axy[i] * ty), dy = part * (z->axy[i] * tx + z->ayy[i] * ty);
        z->wall_rate[i] += flux;
        z->wall_zx[i] += dx;
        z->wall_zy[i] += dy;
        z->next_velocity[4 * i + 2] += (float)dx;
        z->next_velocity[4 * i + 3] += (float)dy;
        const sph2d__twist middle = sph2d__twist_add(b->velocity, -0.5, w),
                           placed = s->rigids[row->body].state->velocity;
        work += z->dt / 4 * z->brake[i] * flux -
                z->dt * z->repelled[i] * times(row->repel, sph2d__twist_add(middle, -1, placed));
    }
    return work;
}

/* ---- in an implicit step ----------------------------------------------------------------------------------------- */

static double product_of(const sph2d__rigid *r, sph2d__twist a, sph2d__twist b)
{
    return r->mass * (a.x * b.x + a.y * b.y) + r->inertia * a.turn * b.turn;
}

/** The acceleration by which contacts are expected to hold a body: what they did for some steps, as far as it is against
 *  the last one's by all else. They act once the liquid has, and where it is not told of them it sees a body that rests
 *  on a floor sink by it in each step, and strikes it. */
static sph2d__twist support_of(const sph2d__rigid *r)
{
    const sph2d__twist none = {0, 0, 0}, held = r->state->held_up;
    const double all = product_of(r, held, held), against = -product_of(r, held, r->state->acceleration);
    return all > 0 ? sph2d__twist_add(none, fmin(fmax(against / all, 0), 1), held) : none;
}

void sph2d__frozen_bodies_expect(sph2d__system *s, double half)
{
    sph2d__frozen *z = s->frozen;
    sum_forces(s, 1);
    for (size_t k = 0; k < s->rigid_count; ++k) {
        sph2d__frozen_body *b = &z->bodies[k];
        const sph2d__twist force = sph2d__twist_add(sph2d__twist_add(b->mean, 1, b->rubbed), 1, s->rigids[k].other);
        b->trial = sph2d__twist_add((sph2d__twist){0, 0, 0}, half, sph2d__rigid_accelerate(&s->rigids[k], force));
        b->trial = sph2d__twist_add(b->trial, z->dt, support_of(&s->rigids[k]));
    }
}

void sph2d__frozen_bodies_pull(sph2d__system *s, double part)
{
    sph2d__frozen *z = s->frozen;
    for (size_t k = 0; k < z->row_count; ++k) {
        const sph2d__frozen_row *row = &z->rows[k];
        const size_t i = row->particle;
        const double p = 2 * z->acts[i] * (double)z->press[4 * i + 3], x = z->walled[i] * z->slope_x[i],
                     y = z->walled[i] * z->slope_y[i];
        const double ex = z->axx[i] * x + z->axy[i] * y, ey = z->axy[i] * x + z->ayy[i] * y;
        double force[3];
        for (int d = 0; d < 3; ++d)
            force[d] =
                part * s->mass *
                (p * row->press[d] - ex * row->pull[d][0] - ey * row->pull[d][1] - z->stopped[i] * row->repel[d]);
        sph2d__frozen_body *b = &z->bodies[row->body];
        b->trial = sph2d__twist_add(
            b->trial, 1, sph2d__rigid_accelerate(&s->rigids[row->body], (sph2d__twist){force[0], force[1], force[2]}));
    }
}

void sph2d__frozen_bodies_feed(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    for (size_t k = 0; k < z->row_count; ++k)
        z->body_rate[z->rows[k].particle] = z->stop_speed[z->rows[k].particle] = 0;
    for (size_t k = 0; k < z->row_count; ++k) {
        const sph2d__frozen_row *row = &z->rows[k];
        const size_t i = row->particle;
        const sph2d__twist w = z->bodies[row->body].trial;
        const double by[3] = {w.x, w.y, w.turn}, part = -z->walled[i];
        double tx = 0, ty = 0;
        for (int d = 0; d < 3; ++d) {
            tx += by[d] * row->pull[d][0];
            ty += by[d] * row->pull[d][1];
        }
        z->stop_speed[i] += times(row->repel, w);
        z->body_rate[i] -= 2 * z->acts[i] * times(row->press, w);
        z->velocity[4 * i + 2] += (float)(part * (z->axx[i] * tx + z->axy[i] * ty));
        z->velocity[4 * i + 3] += (float)(part * (z->axy[i] * tx + z->ayy[i] * ty));
    }
}

double sph2d__frozen_bodies_late(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    double work = 0;
    for (size_t k = 0; k < s->rigid_count; ++k)
        z->bodies[k].trial = (sph2d__twist){0, 0, 0};
    memset(z->stopped, 0, s->fluid.count * sizeof *z->stopped);
    sph2d__frozen_bodies_pull(s, 1);
    for (size_t k = 0; k < s->rigid_count; ++k) {
        const sph2d__rigid *r = &s->rigids[k];
        const sph2d__twist by = z->bodies[k].trial;
        work += (z->dt / 2 - z->ahead) * product_of(r, by, z->bodies[k].change) -
                z->dt * z->dt * product_of(r, by, support_of(r));
    }
    return work;
}

void sph2d__frozen_bodies_free(sph2d__system *s)
{
    void *rows = s->frozen->rows, *bodies = s->frozen->bodies;
    sph2d__release(s->memory, &rows, s->frozen->row_capacity, sizeof(sph2d__frozen_row));
    sph2d__release(s->memory, &bodies, s->rigid_count, sizeof(sph2d__frozen_body));
}
