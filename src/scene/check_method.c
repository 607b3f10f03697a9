/* SPDX-License-Identifier: MIT */
/** @file check_method.c
 *  Which method has which feature, and periodic sides. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "kernels/kernel.h"
#include "scene/checker.h"
#include "scene/derive.h"
#include "scene/method_table.h"
#include "scene/resolve.h"
#include "sph2d/key.h"

/** What to do about a feature that the scene's method does not have. */
static void hint_at(const sph2d__checker *c, sph2d_diagnostic *d, sph2d_feature feature)
{
    const sph2d_method_info *other;
    for (size_t k = 0; (other = sph2d_method_row(k)) && !sph2d_method_has(other, feature);)
        ++k;
    if (!other)
        sph2d_diagnostic_hint(d, "leave it out");
    else if (other->method == c->scene->method.name)
        sph2d_diagnostic_hint(d, "leave it out, or take `operators: %s`",
                              other->operators == SPH2D_OPERATORS_FITTED ? "fitted" : "symmetric");
    else
        sph2d_diagnostic_hint(d, "leave it out, or take `method: {name: %s}`", other->word);
}

/** Refuses what is used and what only other methods have; without a hint of its own the table gives one. */
static void refuse(sph2d__checker *c, const char *path, bool used, sph2d_feature feature, const char *hint)
{
    const sph2d_method_info *method = sph2d_method_of(&c->scene->method);
    if (!used || sph2d_method_has(method, feature))
        return;
    char message[160];
    snprintf(message, sizeof message, "method %s does not have this", method->name);
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, path, message);
    if (hint)
        sph2d_diagnostic_hint(d, "%s", hint);
    else
        hint_at(c, d, feature);
}

/** Bytes of a key that is a word or a number. */
static size_t size_of(const sph2d_key *key)
{
    return key->kind == SPH2D_KEY_WORD ? sizeof(int) : key->kind == SPH2D_KEY_COUNT ? sizeof(uint64_t) : sizeof(double);
}

/** Whether the options have another value of a key than by default, or than the method sets by itself. */
static bool is_given(const sph2d_method_options *m, const sph2d_key *key)
{
    sph2d_method_options standard = sph2d_scene_default().method, without = *m;
    memcpy((char *)&without + key->offset, (const char *)&standard + key->offset, size_of(key));
    without = sph2d__method_resolve(without);
    const char *value = (const char *)m + key->offset;
    return memcmp(value, (const char *)&standard + key->offset, size_of(key)) != 0 &&
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
    const sph2d_method_options *m = &c->scene->method;
    const sph2d_keys *keys = method_keys();
    for (size_t k = 0; k < keys->count; ++k) {
        const sph2d_key *key = &keys->items[k];
        if (key->feature != SPH2D_FEATURE_NONE)
            refuse(c, sph2d_feature_key(key->feature), is_given(m, key), key->feature, NULL);
    }
}

static void check_options(sph2d__checker *c)
{
    const sph2d_method_options *m = &c->scene->method;
    check_keys(c);
    refuse(c, "fluid.surface_tension", c->scene->fluid.surface_tension != 0, SPH2D_FEATURE_SURFACE_TENSION, NULL);
    refuse(c, "wall_slip", c->scene->wall_slip != SPH2D_SLIP_FREE, SPH2D_FEATURE_WALL_SLIP, NULL);
    bool smooth = c->scene->wall_slip == SPH2D_SLIP_SMOOTH;
    if (sph2d_method_has(sph2d_method_of(m), SPH2D_FEATURE_WALL_SLIP))
        refuse(c, "wall_slip", smooth, SPH2D_FEATURE_SMOOTH_WALLS, "take `wall_slip: none`, or `operators: symmetric`");
    if (c->scene->slip_length != 0 && !smooth)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "slip_length",
                           "has an effect on smooth walls alone; take wall_slip: smooth");
    const sph2d_side_speeds *v = &c->scene->wall_speeds;
    bool belts = v->left != 0 || v->right != 0 || v->bottom != 0 || v->top != 0;
    if (belts && c->scene->wall_slip == SPH2D_SLIP_FREE)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "wall_speeds",
                           "has no effect on free-slip walls; take wall_slip: none or smooth");
    bool eddies = m->turbulence == SPH2D_TURBULENCE_SMAGORINSKY;
    if (m->diffusion_form == SPH2D_DIFFUSION_FOURTAKAS &&
        sph2d_method_has(sph2d_method_of(m), SPH2D_FEATURE_DIFFUSION_FORM) &&
        (m->shifting > 0 || m->tensile_control == SPH2D_SWITCH_ON || eddies)) {
        sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "method.diffusion_form",
                                                 "shifting, tensile control and eddies need the gradients of antuono");
        sph2d_diagnostic_hint(d, "leave it out, or take `shifting: 0, tensile_control: off, turbulence: none`");
    }
    if (m->stiffness > 0 && m->sound_speed > 0)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "method.sound_speed", "give stiffness or sound_speed, not both");
}

/* Of the density of a filled lattice so much may be a particle's own, W(0) over the sum. Pressures that keep a density
 * have to see neighbours: scenes with every kernel gained 0.3 to 85 % of their energy where three quarters or more were
 * the particle's own, by method constraint none where it was less. */
static const double MOST_OWN = 2.0 / 3;

static double own_part(sph2d_kernel kernel, double ratio)
{
    int reach = (int)ratio + 1;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j)
            sum += sph2d__kernel_value_at(kernel, hypot(i, j) / ratio);
    return sph2d__kernel_value_at(kernel, 0) / sum;
}

/* Fitted operators keep energy to the order of the scheme. Eddies 17 spacings wide that start at speed U gained 20 to
 * 46 % of it with supports of 3.25 to 4 spacings and no viscosity, until a guard ended the run; 1.5 % with 2.5, and
 * none with any of them where U dx/nu was 60 or less. */
static const double MOST_FITTED = 3, MOST_CELL_REYNOLDS = 100;

static void check_fitted_support(sph2d__checker *c)
{
    sph2d_method_options standard = c->scene->method;
    double cell = c->scene->fluid.density * sph2d__scene_derive(c->scene).speed * c->scene->spacing;
    if (standard.name != SPH2D_METHOD_WCSPH || standard.operators != SPH2D_OPERATORS_FITTED ||
        !(standard.support_ratio > MOST_FITTED) || !(cell > MOST_CELL_REYNOLDS * c->scene->fluid.dynamic_viscosity))
        return;
    standard.support_ratio = 0;
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "method.support_ratio",
                                             "with fitted operators so wide a support makes energy in a flow so fast");
    sph2d_diagnostic_hint(d, "take %g or less, or leave it out for %g; viscosity would be enough from %.3g Pa s on",
                          MOST_FITTED, sph2d__method_resolve(standard).support_ratio, cell / MOST_CELL_REYNOLDS);
}

static void check_support(sph2d__checker *c)
{
    sph2d_method_options m = sph2d__method_resolve(c->scene->method), standard = c->scene->method;
    bool in_range = m.support_ratio >= 1.2 && m.support_ratio <= 6;
    if (!sph2d__method_row_of(&m)->ended_by || !in_range || !(own_part(m.kernel, m.support_ratio) > MOST_OWN))
        return;
    char message[160];
    snprintf(message, sizeof message,
             "with this kernel %.0f %% of a particle's density are its own, and its pressure hardly sees neighbours",
             100 * own_part(m.kernel, m.support_ratio));
    double least = m.support_ratio;
    while (own_part(m.kernel, least) > MOST_OWN)
        least += 0.01;
    standard.support_ratio = 0;
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, "method.support_ratio", message);
    sph2d_diagnostic_hint(d, "take %.2f or more, or leave it out for %.3g", ceil(100 * least) / 100,
                          sph2d__method_resolve(standard).support_ratio);
}

/* By so much may a block of its own spacing be compressed or drawn apart, where pressure is stiff: the sound speed is
 * that of liquid near its rest density, and a block of 1.4 times that flew apart at half the speed of sound. */
static const double MOST_COMPRESSED = 0.1;

static void check_block_spacings(sph2d__checker *c)
{
    for (size_t i = 0; i < c->scene->block_count; ++i) {
        double spacing = c->scene->blocks[i].spacing;
        double density = spacing > 0 ? pow(c->scene->spacing / spacing, 2) : 1;
        if (sph2d__method_row_of(&c->scene->method)->summed_density || fabs(density - 1) <= MOST_COMPRESSED)
            continue;
        char message[160], path[SPH2D__PATH_SIZE];
        snprintf(message, sizeof message,
                 "starts at %.3g times the rest density, since mass is the scene's; method wcsph is stiff: 0.9 to 1.1",
                 density);
        sph2d_diagnostic *d =
            sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, sph2d__check_path(path, "blocks", i, ".spacing"), message);
        sph2d_diagnostic_hint(d, "leave it out, or take `method: {name: muller}`, whose blocks may start compressed");
    }
}

/** Refuses a form of walls that the method does not have. */
static void check_form(sph2d__checker *c, const char *path, sph2d_wall_form form)
{
    const sph2d_method_info *method = sph2d_method_of(&c->scene->method);
    bool known = form > SPH2D_WALL_DEFAULT && form <= SPH2D_WALL_GENERALISED; /* others are out of range by the keys */
    if (!known || (method->wall_forms >> form & 1))
        return;
    char message[160];
    snprintf(message, sizeof message, "method %s does not have this", method->name);
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, path, message);
    sph2d_diagnostic_hint(d, "leave it out for the method's own form");
}

static void check_walls(sph2d__checker *c)
{
    check_form(c, "walls", c->scene->walls);
    for (size_t i = 0; i < c->scene->obstacle_count; ++i) {
        char path[SPH2D__PATH_SIZE];
        check_form(c, sph2d__check_path(path, "obstacles", i, ".form"), c->scene->obstacles[i].form);
    }
}

/** Fits have no free surface: liquid must fill its room, and stick to its walls. */
static void check_room(sph2d__checker *c)
{
    const sph2d_scene *scene = c->scene;
    const sph2d_side sides[4] = {scene->boundary.left, scene->boundary.right, scene->boundary.bottom,
                                 scene->boundary.top};
    static const char *const paths[4] = {"boundary.left", "boundary.right", "boundary.bottom", "boundary.top"};
    bool walled = scene->obstacle_count > 0;
    for (int k = 0; k < 4; ++k) {
        refuse(c, paths[k], sides[k] == SPH2D_SIDE_OPEN, SPH2D_FEATURE_FREE_SURFACE,
               "liquid must fill its room: make the side a wall or periodic, or take `operators: symmetric`");
        walled |= sides[k] == SPH2D_SIDE_WALL;
    }
    refuse(c, "wall_slip", walled && scene->wall_slip == SPH2D_SLIP_FREE, SPH2D_FEATURE_FREE_SURFACE,
           "take `wall_slip: none`, or `operators: symmetric`");
    refuse(c, "sources", scene->source_count > 0, SPH2D_FEATURE_FREE_SURFACE, "take `operators: symmetric`");
    refuse(c, "drains", scene->drain_count > 0, SPH2D_FEATURE_FREE_SURFACE, "take `operators: symmetric`");
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
        reach += c->scene->spacing; /* as far as boundary particles are looked for */
    if (!periodic || length >= 3.001 * reach)
        return;
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path,
                                             "the period does not hold three times the reach of a particle");
    sph2d_diagnostic_hint(d, "make the domain at least %g m long here, or the spacing smaller", 3.001 * reach);
}

void sph2d__check_method(sph2d__checker *c)
{
    check_options(c);
    check_support(c);
    check_fitted_support(c);
    check_block_spacings(c);
    check_walls(c);
    check_room(c);
    sph2d_boundary b = c->scene->boundary;
    sph2d_box d = c->scene->domain;
    check_pair(c, b.left, b.right, "boundary.right", d.max.x - d.min.x);
    check_pair(c, b.bottom, b.top, "boundary.top", d.max.y - d.min.y);
}
