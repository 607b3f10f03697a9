/* SPDX-License-Identifier: MIT */
/** @file check_method.c
 *  Checks that the method has the features in use, and checks of periodic sides. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "kernels/kernel.h"
#include "scene/checker.h"
#include "scene/liquid.h"
#include "scene/method_table.h"
#include "scene/openings.h"
#include "scene/resolve.h"
#include "scene/shape.h"
#include "sph2d/key.h"

/** Adds a hint for a feature that the scene's method does not have. */
static void hint_for_feature(const sph2d__checker *c, sph2d_diagnostic *d, sph2d_feature feature)
{
    const sph2d_method_info *other;
    for (size_t k = 0; (other = sph2d_method_row(k)) && !sph2d_method_has(other, feature);)
        ++k;
    if (!other)
        sph2d_diagnostic_hint(d, "leave it out");
    else if (other->method == c->scene->method.name)
        sph2d_diagnostic_hint(d, "leave it out, or use `operators: %s`",
                              other->operators == SPH2D_OPERATORS_FITTED ? "fitted" : "variational");
    else
        sph2d_diagnostic_hint(d, "leave it out, or use `method: {name: %s}`", other->word);
}

/** Reports a feature that is used but not available with the method; without `hint` the table gives one. */
static void require_feature(sph2d__checker *c, const char *path, bool used, sph2d_feature feature, const char *hint)
{
    const sph2d_method_info *method = sph2d_method_of(&c->scene->method);
    if (!used || sph2d_method_has(method, feature))
        return;
    char message[200];
    snprintf(message, sizeof message, "not available with method %s", method->name);
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, path, message);
    if (hint)
        sph2d_diagnostic_hint(d, "%s", hint);
    else
        hint_for_feature(c, d, feature);
}

/** Size of the value of a key that is a word or a number. */
static size_t size_of(const sph2d_key *key)
{
    return key->kind == SPH2D_KEY_WORD ? sizeof(int) : key->kind == SPH2D_KEY_COUNT ? sizeof(uint64_t) : sizeof(double);
}

/** Whether a key's value differs from its default and from the value that the method sets by itself. */
static bool is_given(const sph2d_method_options *m, const sph2d_key *key)
{
    sph2d_method_options defaults = sph2d_scene_default().method, without = *m;
    memcpy((char *)&without + key->offset, (const char *)&defaults + key->offset, size_of(key));
    without = sph2d__method_resolve(without);
    const char *value = (const char *)m + key->offset;
    return memcmp(value, (const char *)&defaults + key->offset, size_of(key)) != 0 &&
           memcmp(value, (const char *)&without + key->offset, size_of(key)) != 0;
}

static const sph2d_keys *method_keys(void)
{
    const sph2d_keys *scene = sph2d_scene_keys();
    for (size_t k = 0; k < scene->count; ++k)
        if (scene->items[k].kind == SPH2D_KEY_GROUP && scene->items[k].offset == offsetof(sph2d_scene, method))
            return scene->items[k].keys;
    return NULL;
}

static void check_keys(sph2d__checker *c)
{
    const sph2d_method_options *m = &c->given->method;
    const sph2d_keys *keys = method_keys();
    for (size_t k = 0; k < keys->count; ++k) {
        const sph2d_key *key = &keys->items[k];
        if (key->feature != SPH2D_FEATURE_NONE)
            require_feature(c, sph2d_feature_key((sph2d_feature)key->feature), is_given(m, key),
                            (sph2d_feature)key->feature, NULL);
    }
}

/** A slip that a wall has of its own, or the scene's. */
static void check_slip(sph2d__checker *c, const char *path, sph2d_slip slip)
{
    require_feature(c, path, slip != SPH2D_SLIP_FREE, SPH2D_FEATURE_WALL_SLIP, NULL);
    if (sph2d_method_has(sph2d_method_of(&c->scene->method), SPH2D_FEATURE_WALL_SLIP))
        require_feature(c, path, slip == SPH2D_SLIP_SMOOTH, SPH2D_FEATURE_SMOOTH_WALLS,
                        "use `none`, or `operators: variational`");
}

/** The own slip of one wall. Fitted operators have no free slip. */
static void check_own_slip(sph2d__checker *c, const char *path, sph2d_slip slip, bool is_wall)
{
    if (!is_wall) {
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "this side of the domain is not a wall");
        return;
    }
    check_slip(c, path, slip);
    require_feature(c, path, slip == SPH2D_SLIP_FREE, SPH2D_FEATURE_FREE_SURFACE,
                    "use `none`, or `operators: variational`");
}

/** Methods with a pressure solver let bodies slip. */
static void check_slip_of_bodies(sph2d__checker *c)
{
    const sph2d_scene *scene = c->scene;
    char path[SPH2D__PATH_SIZE];
    bool has = sph2d_method_has(sph2d_method_of(&scene->method), SPH2D_FEATURE_WALL_SLIP);
    if (!has || scene->method.name == SPH2D_METHOD_WCSPH || scene->method.name == SPH2D_METHOD_CONSTRAINT)
        return;
    for (size_t i = c->world->first_body; i < c->world->wall_count; ++i) {
        if (c->world->walls[i].slip == SPH2D_SLIP_FREE)
            continue;
        sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, sph2d__check_wall_path(c, path, i, ".slip"),
                                                 "bodies have free slip with this method");
        sph2d_diagnostic_hint(d, "give it `slip: free`, or use `method: wcsph`");
    }
}

/** The slip that the scene gives an obstacle or body. */
static sph2d_wall_slip own_slip(const sph2d_scene *scene, const sph2d__wall *wall)
{
    return wall->body ? wall->body->slip : scene->obstacles[wall->index].slip;
}

static void check_slips(sph2d__checker *c)
{
    const sph2d_scene *scene = c->scene;
    bool slides = false;
    char path[SPH2D__PATH_SIZE];
    check_slip(c, "wall_slip", scene->wall_slip);
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side) {
        snprintf(path, sizeof path, "side_slip.%s", sph2d__side_word(side));
        sph2d_slip slip = c->world->walls[side].slip;
        if (sph2d__side_own_slip(scene, side) != SPH2D_WALL_SLIP_DEFAULT)
            check_own_slip(c, path, slip, sph2d__side_of(scene, side) == SPH2D_SIDE_WALL);
        slides = slides || (sph2d__side_speed(scene, side) != 0 && slip == SPH2D_SLIP_FREE);
    }
    for (size_t i = SPH2D__WALL_OBSTACLE; i < c->world->wall_count; ++i)
        if (own_slip(scene, &c->world->walls[i]) != SPH2D_WALL_SLIP_DEFAULT)
            check_own_slip(c, sph2d__check_wall_path(c, path, i, ".slip"), c->world->walls[i].slip, true);
    check_slip_of_bodies(c);
    bool smooth = scene->wall_slip == SPH2D_SLIP_SMOOTH || (sph2d__wall_slips(c->world) >> SPH2D_SLIP_SMOOTH & 1);
    if (scene->slip_length != 0 && !smooth)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "slip_length",
                           "has an effect on smooth walls only; use wall_slip: smooth");
    if (slides)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "wall_speeds",
                           "has no effect on free-slip walls; use wall_slip: none or smooth");
}

static void check_options(sph2d__checker *c)
{
    const sph2d_method_options *m = &c->scene->method;
    check_keys(c);
    require_feature(c, "fluid.surface_tension", c->scene->fluid.surface_tension != 0, SPH2D_FEATURE_SURFACE_TENSION,
                    NULL);
    check_slips(c);
    require_feature(c, "bodies", c->scene->body_count > 0, SPH2D_FEATURE_BODIES, NULL);
    if (m->name == SPH2D_METHOD_HYBRID && c->scene->body_count > 0 &&
        (c->scene->boundary.left == SPH2D_SIDE_PERIODIC || c->scene->boundary.bottom == SPH2D_SIDE_PERIODIC))
        sph2d_diagnostic_hint(sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, "bodies",
                                                 "not available between periodic sides with method hybrid"),
                              "use sides that are walls or open, or `method: constraint`");
    for (size_t i = 0; i < c->scene->probe_count; ++i) {
        const sph2d_probe_kind kind = c->scene->probes[i].kind;
        char path[SPH2D__PATH_SIZE];
        require_feature(c, sph2d__check_path(path, "probes", i, ".kind"),
                        kind == SPH2D_PROBE_FORCE || kind == SPH2D_PROBE_WORK, SPH2D_FEATURE_WALL_FORCES, NULL);
    }
    if (m->stiffness > 0 && m->sound_speed > 0)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "method.sound_speed", "give stiffness or sound_speed, not both");
}

/* Maximum self-contribution of a particle to the density of a filled lattice, W(0) over the sum. A pressure solver
 * needs the contribution of neighbours: scenes with every kernel gained 0.3 to 85 % of their energy with a
 * self-contribution of three quarters or more, and none, by method constraint, with less. */
static const double MAX_SELF = 2.0 / 3;

static double self_contribution(sph2d_kernel kernel, double ratio)
{
    int reach = (int)ratio + 1;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j)
            sum += sph2d__kernel_value_at(kernel, hypot(i, j) / ratio);
    return sph2d__kernel_value_at(kernel, 0) / sum;
}

/* Fitted operators conserve energy only to the order of the scheme. Eddies 17 spacings wide with initial speed U gained
 * 20 to 46 % of it with supports of 3.25 to 4 spacings and no viscosity, until a guard ended the run; 1.5 % with 2.5,
 * and none with any support where U dx/nu was 60 or less. */
static const double MAX_FITTED_SUPPORT = 3, MAX_CELL_REYNOLDS = 100;

static void check_fitted_support(sph2d__checker *c)
{
    sph2d_method_options defaults = c->given->method;
    if (c->errors > 0) /* what is derived needs a valid scene */
        return;
    double cell = c->scene->fluid.density * c->world->derived.speed * c->scene->spacing;
    if (defaults.name != SPH2D_METHOD_WCSPH || defaults.operators != SPH2D_OPERATORS_FITTED ||
        !(defaults.support_ratio > MAX_FITTED_SUPPORT) ||
        !(cell > MAX_CELL_REYNOLDS * c->scene->fluid.dynamic_viscosity))
        return;
    defaults.support_ratio = 0;
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "method.support_ratio",
                                             "with fitted operators this support gains energy in a flow of this speed");
    sph2d_diagnostic_hint(d, "use %g or less, or leave it out for %g; or a viscosity of %.3g Pa s or more",
                          MAX_FITTED_SUPPORT, sph2d__method_resolve(defaults).support_ratio, cell / MAX_CELL_REYNOLDS);
}

/* Methods with a projection solve for the pressure of a step where the particles are at its start. A fast one moves cfl
 * H/dx spacings in it: beyond one, past those that the pressure was to keep it off. */
static void check_projected_step(sph2d__checker *c)
{
    sph2d_method_options m = c->scene->method, defaults = c->given->method;
    if (!sph2d__method_row_of(&m)->cfl_by_spacing || !(m.cfl * m.support_ratio > 1))
        return;
    char message[200];
    snprintf(message, sizeof message,
             "with this support radius fast particles move %.3g spacings in a step, past others",
             m.cfl * m.support_ratio);
    defaults.cfl = 0;
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "method.cfl", message);
    sph2d_diagnostic_hint(d, "use %.3g or less, or leave it out for %.3g", floor(1000 / m.support_ratio) / 1000,
                          sph2d__method_resolve(defaults).cfl);
}

/* With variational operators 21 of 60 random scenes get energy from nothing with 0.4, 3 with 0.25. */
static void check_acoustic_step(sph2d__checker *c)
{
    sph2d_method_options m = c->scene->method, defaults = c->given->method;
    const double most = sph2d__method_row_of(&m)->most_cfl;
    if (!(most > 0 && m.cfl > most))
        return;
    defaults.cfl = 0;
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "method.cfl",
                                             "sound passes too many particles in a step: it is unstable");
    sph2d_diagnostic_hint(d, "use %g or less, or leave it out for %.3g", most, sph2d__method_resolve(defaults).cfl);
}

/* Method hybrid puts the order of particles right by half a step of Jacobi. A dam break is compressed by 3.1 to 4 % (99th
 * percentile) with 2 to 2.6 spacings, 9 % with 2.8, 10 % with 3, where more neighbours make it overshoot, and 550 % with 4;
 * with 1.5 by 9 %. */
static void check_grid_support(sph2d__checker *c)
{
    const double ratio = c->given->method.support_ratio;
    if (c->scene->method.name != SPH2D_METHOD_HYBRID || !(ratio > 0) || (ratio >= 2 && ratio <= 2.6))
        return;
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "method.support_ratio",
                                             "particles would not keep their order by method hybrid");
    sph2d_diagnostic_hint(d, "use 2 to 2.6, or leave it out for 2.4");
}

/* Squares of the grid of method hybrid: some 250 bytes each, so that these have 4 GB. */
static const double MOST_SQUARES = 1.6e7;

/** The grid covers the domain, with liquid or without, and as much again beyond each open side. */
static void check_grid_size(sph2d__checker *c)
{
    const sph2d_scene *scene = c->scene;
    const double width = scene->domain.max.x - scene->domain.min.x, height = scene->domain.max.y - scene->domain.min.y;
    const sph2d_boundary *b = &scene->boundary;
    const int across = 1 + (b->left == SPH2D_SIDE_OPEN) + (b->right == SPH2D_SIDE_OPEN);
    const int along = 1 + (b->bottom == SPH2D_SIDE_OPEN) + (b->top == SPH2D_SIDE_OPEN);
    const double side = SPH2D__SQUARE * scene->spacing, squares = across * (width / side) * (along * (height / side));
    if (scene->method.name != SPH2D_METHOD_HYBRID || !(squares > MOST_SQUARES))
        return;
    char message[200];
    snprintf(
        message, sizeof message,
        "the grid of method hybrid, over all of it and beyond open sides, would have %.3g squares; it may have %.3g",
        squares, MOST_SQUARES);
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "domain", message);
    sph2d_diagnostic_hint(d, "a domain around the liquid, a larger spacing, or another method");
}

static void check_support(sph2d__checker *c)
{
    sph2d_method_options m = c->scene->method, defaults = c->given->method;
    bool in_range = m.support_ratio >= 1.2 && m.support_ratio <= 6;
    if (!sph2d__method_row_of(&m)->convergence_hint || !in_range ||
        !(self_contribution(m.kernel, m.support_ratio) > MAX_SELF))
        return;
    char message[200];
    snprintf(message, sizeof message,
             "with this kernel %.0f %% of a particle's density is its own contribution, too much for a pressure solver",
             100 * self_contribution(m.kernel, m.support_ratio));
    double smallest = m.support_ratio;
    while (self_contribution(m.kernel, smallest) > MAX_SELF)
        smallest += 0.01;
    defaults.support_ratio = 0;
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "method.support_ratio", message);
    sph2d_diagnostic_hint(d, "use %.2f or more, or leave it out for %.3g", ceil(100 * smallest) / 100,
                          sph2d__method_resolve(defaults).support_ratio);
}

/* Maximum compression or expansion of a block with its own spacing, with a stiff equation of state: the sound speed is
 * meant for liquid near rest density, and a block of 1.4 times that burst at half the speed of sound. */
static const double MAX_BLOCK_COMPRESSION = 0.1;

static void check_block_spacings(sph2d__checker *c)
{
    for (size_t i = 0; i < c->scene->block_count; ++i) {
        double spacing = c->scene->blocks[i].spacing;
        double density = spacing > 0 ? pow(c->scene->spacing / spacing, 2) : 1;
        const sph2d__method_row *row = sph2d__method_row_of(&c->scene->method);
        if ((row->summed_density && !row->keeps_volume) || fabs(density - 1) <= MAX_BLOCK_COMPRESSION)
            continue;
        char message[160], path[SPH2D__PATH_SIZE];
        snprintf(message, sizeof message,
                 "starts at %.3g times the rest density, as particles have the scene's mass; %s allows 0.9 to 1.1",
                 density, row->info.word);
        sph2d_diagnostic *d =
            sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, sph2d__check_path(path, "blocks", i, ".spacing"), message);
        sph2d_diagnostic_hint(d, "leave it out, or use `method: {name: muller}`, whose blocks may start compressed");
    }
}

/* Compression at rest beyond which a sound speed that is given is hardly meant, twice that of muller by default. With
 * the sound speed for a depth of 0.1 m a column of 10 m was compressed by 57 % (wcsph) and 490 % (muller) at its foot,
 * without a word. */
static const double MAX_HEAD_COMPRESSION = 0.1;

/** Whether gravity is along periodic sides only, where it drives a flow and nothing rests on anything. */
static bool drives_only(const sph2d_scene *scene)
{
    return (scene->gravity.x == 0 || sph2d__period_x(scene) > 0) &&
           (scene->gravity.y == 0 || sph2d__period_y(scene) > 0);
}

/** Pressure over density of single particles that a file has given: nothing else is derived from them. */
static double head_of_file(const sph2d__world *world)
{
    const sph2d_particles *p = &world->scene.particles;
    const sph2d_vec2 up = world->gravity.up;
    const sph2d_box *d = &world->scene.domain;
    const double low = up.x * (up.x > 0 ? d->min.x : d->max.x) + up.y * (up.y > 0 ? d->min.y : d->max.y);
    double head = 0;
    for (size_t i = 0; p->file && p->items && i < p->count; ++i) {
        const sph2d_particle *at = &p->items[i];
        head = fmax(head, world->gravity.size * (at->x * up.x + at->y * up.y - low) +
                              (at->vx * at->vx + at->vy * at->vy) / 2);
    }
    return head;
}

/** Warns of a sound speed that is too low for the depth and speed of the liquid. */
static void check_sound_speed(sph2d__checker *c)
{
    const sph2d_method_options *m = &c->scene->method;
    if (c->errors > 0 || !(m->sound_speed > 0 || m->stiffness > 0)) /* what is derived needs a valid scene */
        return;
    const sph2d__derived derived = c->world->derived;
    double head =
        derived.head + derived.capillary_head - (drives_only(c->scene) ? derived.gravity * derived.height : 0);
    head = fmax(head, head_of_file(c->world));
    double compression = head / (derived.sound_speed * derived.sound_speed);
    if (!(compression > MAX_HEAD_COMPRESSION))
        return;
    const char *key = m->sound_speed > 0 ? "method.sound_speed" : "method.stiffness";
    sph2d_diagnostic *d = sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_OUT_OF_RANGE, key,
                                           "this liquid can compress itself by %.0f %%, at a sound speed of %.3g m/s",
                                           100 * compression, derived.sound_speed);
    sph2d_diagnostic_hint(d, "leave it out: c0 is then %.3g m/s; methods constraint and pcisph keep to max_compression",
                          derived.natural_speed);
}

/** Warns of surface tension that compresses drops and films beyond max_compression, for which the sound speed is not
 *  chosen: a drop of 22 particles across was compressed by 1.8 %, one of 11 by 2.7 %. */
static void check_capillarity(sph2d__checker *c)
{
    const sph2d_method_options m = c->scene->method;
    if (c->errors > 0 || m.sound_speed > 0 || m.stiffness > 0 || !sph2d__method_row_of(&m)->has_sound)
        return;
    const sph2d__derived derived = c->world->derived;
    double compression = derived.capillary_head / (derived.sound_speed * derived.sound_speed);
    if (!(compression > m.max_compression))
        return;
    sph2d_diagnostic *d = sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_OUT_OF_RANGE, "fluid.surface_tension",
                                           "it compresses the thinnest block by %.2g %%, more than "
                                           "method.max_compression, %.3g %%, at a sound speed of %.3g m/s",
                                           100 * compression, 100 * m.max_compression, derived.sound_speed);
    sph2d_diagnostic_hint(
        d, "a smaller spacing, `method: {sound_speed: %.2g}`, or methods constraint and pcisph keep to it",
        sqrt(2 * derived.capillary_head / m.max_compression));
}

/** Warns of gravity along a period, which friction alone stops: by the end it makes the liquid faster than what the sound
 *  speed is chosen for. */
static void check_endless_fall(sph2d__checker *c)
{
    const sph2d_scene *s = c->scene;
    const sph2d_method_options m = s->method;
    if (c->errors > 0 || m.sound_speed > 0 || m.stiffness > 0 || !sph2d__method_row_of(&m)->has_sound)
        return;
    const double width = s->domain.max.x - s->domain.min.x, height = s->domain.max.y - s->domain.min.y;
    const double gx = sph2d__period_x(s) > 0 ? fabs(s->gravity.x) : 0,
                 gy = sph2d__period_y(s) > 0 ? fabs(s->gravity.y) : 0, g = hypot(gx, gy);
    const double across = gx > gy ? height : width, nu = s->fluid.dynamic_viscosity / s->fluid.density;
    const double speed = fmin(g * s->run.until, nu > 0 ? g * across * across / (8 * nu) : INFINITY);
    const sph2d__derived d = c->world->derived;
    const double made_for = sqrt(2 * (d.head + d.capillary_head));
    if (!(speed > made_for))
        return;
    sph2d_diagnostic *of =
        sph2d_report_add(c->report, SPH2D_WARNING, SPH2D_CODE_OUT_OF_RANGE, "gravity",
                         "along a period nothing but friction stops the liquid: it may reach %.3g m/s, and "
                         "the sound speed, %.3g m/s, is for %.3g m/s",
                         speed, d.sound_speed, made_for);
    sph2d_diagnostic_hint(of, "`gravity: [%g, %g]`, a shorter run, or `method: {sound_speed: %.2g}`",
                          gx > 0 ? 0 : s->gravity.x, gy > 0 ? 0 : s->gravity.y, d.sound_speed * speed / made_for);
}

/** Reports a wall form that the method does not have. */
static void check_form(sph2d__checker *c, const char *path, sph2d_wall_form form)
{
    const sph2d_method_info *method = sph2d_method_of(&c->scene->method);
    bool known =
        form > SPH2D_WALL_DEFAULT && form <= SPH2D_WALL_GENERALISED; /* others were reported by the range checks */
    if (!known || (method->wall_forms >> form & 1))
        return;
    char message[200];
    snprintf(message, sizeof message, "not available with method %s", method->name);
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, path, message);
    sph2d_diagnostic_hint(d, "leave it out for the method's own form");
}

static void check_walls(sph2d__checker *c)
{
    char path[SPH2D__PATH_SIZE];
    check_form(c, "walls", c->given->walls);
    for (size_t i = 0; i < c->given->obstacle_count; ++i)
        check_form(c, sph2d__check_path(path, "obstacles", i, ".form"), c->given->obstacles[i].form);
}

/** Whether liquid of blocks leaves room for a surface. Where layers lie beside an open line is not known here, nor what
 *  particles or a snapshot will fill. */
static bool has_voids(const sph2d__world *world)
{
    const sph2d_scene *scene = &world->scene;
    for (size_t i = SPH2D__WALL_OBSTACLE; i < world->wall_count; ++i)
        if (sph2d__shape_is_open(&world->walls[i].shape))
            return false;
    bool particles = scene->particles.file || scene->particles.count > 0;
    return scene->block_count > 0 && !particles && !sph2d__liquid_fills(world);
}

/** Fitted operators have no free surface: liquid must fill the domain, and walls must be no-slip. */
static void check_filled_domain(sph2d__checker *c)
{
    const sph2d_scene *scene = c->scene;
    char path[SPH2D__PATH_SIZE];
    bool walled = false; /* by walls without a slip of their own */
    for (size_t i = SPH2D__WALL_OBSTACLE; i < c->world->wall_count; ++i)
        walled |= own_slip(scene, &c->world->walls[i]) == SPH2D_WALL_SLIP_DEFAULT;
    for (int k = 0; k < SPH2D__WALL_OBSTACLE; ++k) {
        require_feature(
            c, sph2d__check_wall_path(c, path, (size_t)k, ""), sph2d__side_of(scene, k) == SPH2D_SIDE_OPEN,
            SPH2D_FEATURE_FREE_SURFACE,
            "liquid must fill the domain: make the side a wall or periodic, or use `operators: variational`");
        walled |=
            sph2d__side_of(scene, k) == SPH2D_SIDE_WALL && sph2d__side_own_slip(scene, k) == SPH2D_WALL_SLIP_DEFAULT;
    }
    require_feature(c, "wall_slip", walled && scene->wall_slip == SPH2D_SLIP_FREE, SPH2D_FEATURE_FREE_SURFACE,
                    "use `wall_slip: none`, or `operators: variational`");
    require_feature(c, "sources", scene->source_count > 0, SPH2D_FEATURE_FREE_SURFACE, "use `operators: variational`");
    require_feature(c, "openings", scene->opening_count > 0, SPH2D_FEATURE_OPENINGS, NULL);
    for (size_t i = 0; i < scene->opening_count; ++i) {
        require_feature(c, sph2d__check_path(path, "openings", i, ""), sph2d__opening_has_surface(&scene->openings[i]),
                        SPH2D_FEATURE_FREE_SURFACE,
                        "use a velocity, a flow rate or a pressure, or `operators: variational`");
    }
    if (c->errors == 0 && !sph2d_method_has(sph2d_method_of(&scene->method), SPH2D_FEATURE_FREE_SURFACE) &&
        has_voids(c->world))
        sph2d_diagnostic_hint(sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, "blocks",
                                                 "leave room for a free surface, which fitted operators do not have"),
                              "make them fill the domain, or use `operators: variational`");
    require_feature(c, "drains", scene->drain_count > 0, SPH2D_FEATURE_FREE_SURFACE, "use `operators: variational`");
}

static void check_pair(sph2d__checker *c, sph2d_side a, sph2d_side b, const char *path, double length)
{
    bool periodic = a == SPH2D_SIDE_PERIODIC;
    if (periodic != (b == SPH2D_SIDE_PERIODIC)) {
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "a periodic side needs a periodic side opposite");
        return;
    }
    double reach = sph2d__scene_reach(c->scene);
    const sph2d_method_options *m = &c->scene->method;
    if (m->name == SPH2D_METHOD_WCSPH && m->operators == SPH2D_OPERATORS_FITTED)
        reach += c->scene->spacing; /* search radius for boundary particles */
    if (!periodic || length >= 3.001 * reach)
        return;
    sph2d_diagnostic *d = sph2d__check_fault(
        c, SPH2D_CODE_OUT_OF_RANGE, path, "the period is shorter than three times the interaction range of particles");
    sph2d_diagnostic_hint(d, "make the domain at least %g m long here, or the spacing smaller", 3.001 * reach);
}

void sph2d__check_method(sph2d__checker *c)
{
    check_options(c);
    check_support(c);
    check_grid_support(c);
    check_grid_size(c);
    check_fitted_support(c);
    check_projected_step(c);
    check_acoustic_step(c);
    check_block_spacings(c);
    check_sound_speed(c);
    check_capillarity(c);
    check_endless_fall(c);
    check_walls(c);
    check_filled_domain(c);
    sph2d_boundary b = c->scene->boundary;
    sph2d_box d = c->scene->domain;
    check_pair(c, b.left, b.right, "boundary.right", d.max.x - d.min.x);
    check_pair(c, b.bottom, b.top, "boundary.top", d.max.y - d.min.y);
}
