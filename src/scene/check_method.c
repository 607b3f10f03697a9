/* SPDX-License-Identifier: MIT */
/** @file check_method.c
 *  Which method has which feature, and periodic sides. */
#include <math.h>
#include <stdio.h>

#include "kernels/kernel.h"
#include "scene/checker.h"
#include "scene/derive.h"
#include "scene/resolve.h"

/** The solvers, as bits. */
enum { MULLER = 1, SYMMETRIC = 2, FITTED = 4, PCISPH = 8, CONSTRAINT = 16, PROJECTED = PCISPH | CONSTRAINT };

static int solver_of(const sph2d_method_options *m)
{
    if (m->name == SPH2D_METHOD_MULLER)
        return MULLER;
    if (m->name == SPH2D_METHOD_PCISPH)
        return PCISPH;
    if (m->name == SPH2D_METHOD_CONSTRAINT)
        return CONSTRAINT;
    return m->operators == SPH2D_OPERATORS_FITTED ? FITTED : SYMMETRIC;
}

static const char *solver_name(int solver)
{
    return solver == MULLER       ? "method muller"
           : solver == PCISPH     ? "method pcisph"
           : solver == CONSTRAINT ? "method constraint"
           : solver == FITTED     ? "method wcsph with fitted operators"
                                  : "method wcsph";
}

/** Refuses a feature that is used and that only other solvers have. */
static void refuse(sph2d__checker *c, const char *path, bool used, int have, const char *hint)
{
    int solver = solver_of(&c->scene->method);
    if (!used || (have & solver))
        return;
    char message[160];
    snprintf(message, sizeof message, "%s does not have this", solver_name(solver));
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, path, message);
    sph2d_diagnostic_hint(d, "%s", hint);
}

/** The options with the tolerance that they have by themselves. */
static sph2d_method_options without_tolerance(sph2d_method_options m)
{
    m.tolerance = 0;
    return sph2d__method_resolve(m);
}

static void check_options(sph2d__checker *c)
{
    const sph2d_method_options *m = &c->scene->method, standard = sph2d_scene_default().method;
    const char *wcsph = "take `method: {name: wcsph}`", *symmetric = "leave it out, or take `operators: symmetric`";
    bool other = m->name != SPH2D_METHOD_WCSPH;
    const char *hint = other ? wcsph : symmetric;
    refuse(c, "method.operators", other && m->operators != standard.operators, 0, wcsph);
    refuse(c, "method.precision", m->precision != standard.precision, SYMMETRIC | FITTED, wcsph);
    refuse(c, "method.kernel", m->kernel != standard.kernel, SYMMETRIC | PROJECTED, hint);
    refuse(c, "method.state_equation", m->state_equation != standard.state_equation, SYMMETRIC | FITTED, wcsph);
    refuse(c, "method.viscosity_form", m->viscosity_form != standard.viscosity_form, SYMMETRIC, hint);
    refuse(c, "method.turbulence", m->turbulence != standard.turbulence, SYMMETRIC, hint);
    refuse(c, "method.artificial_viscosity", m->artificial_viscosity != standard.artificial_viscosity,
           MULLER | SYMMETRIC, hint);
    refuse(c, "method.density_diffusion", m->density_diffusion != standard.density_diffusion, SYMMETRIC | FITTED,
           wcsph);
    refuse(c, "method.diffusion_form", m->diffusion_form != standard.diffusion_form, SYMMETRIC, hint);
    refuse(c, "method.shifting", m->shifting != standard.shifting, SYMMETRIC | FITTED, wcsph);
    refuse(c, "method.tensile_control", m->tensile_control != standard.tensile_control, SYMMETRIC, hint);
    const char *projected = "leave it out, or take `method: {name: constraint}`";
    const char *pcisph = "leave it out, or take `method: {name: pcisph}`";
    refuse(c, "method.damping", m->damping != standard.damping, CONSTRAINT, projected);
    bool named = m->tolerance != standard.tolerance && m->tolerance != without_tolerance(*m).tolerance;
    refuse(c, "method.tolerance", named, CONSTRAINT, projected);
    refuse(c, "method.criterion", m->criterion != standard.criterion, PCISPH, pcisph);
    refuse(c, "method.min_iterations", m->min_iterations != standard.min_iterations, PCISPH, pcisph);
    refuse(c, "method.max_iterations", m->max_iterations != standard.max_iterations, PROJECTED, projected);
    refuse(c, "fluid.surface_tension", c->scene->fluid.surface_tension != 0, MULLER | SYMMETRIC | PROJECTED, hint);
    refuse(c, "wall_slip", c->scene->wall_slip != SPH2D_SLIP_FREE, SYMMETRIC | FITTED, wcsph);
    bool smooth = c->scene->wall_slip == SPH2D_SLIP_SMOOTH;
    refuse(c, "wall_slip", smooth && !other, SYMMETRIC, "take `wall_slip: none`, or `operators: symmetric`");
    if (c->scene->slip_length != 0 && !smooth)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "slip_length",
                           "has an effect on smooth walls alone; take wall_slip: smooth");
    const sph2d_side_speeds *v = &c->scene->wall_speeds;
    bool belts = v->left != 0 || v->right != 0 || v->bottom != 0 || v->top != 0;
    if (belts && c->scene->wall_slip == SPH2D_SLIP_FREE)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "wall_speeds",
                           "has no effect on free-slip walls; take wall_slip: none or smooth");
    bool eddies = m->turbulence == SPH2D_TURBULENCE_SMAGORINSKY;
    if (m->diffusion_form == SPH2D_DIFFUSION_FOURTAKAS && solver_of(m) == SYMMETRIC &&
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
    if (solver_of(&standard) != FITTED || !(standard.support_ratio > MOST_FITTED) ||
        !(cell > MOST_CELL_REYNOLDS * c->scene->fluid.dynamic_viscosity))
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
    if (!(solver_of(&m) & PROJECTED) || !in_range || !(own_part(m.kernel, m.support_ratio) > MOST_OWN))
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
        if (!(solver_of(&c->scene->method) & (SYMMETRIC | FITTED)) || fabs(density - 1) <= MOST_COMPRESSED)
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

/** The walls' forms that a solver has. */
static int solvers_with(sph2d_wall_form form)
{
    switch (form) {
    case SPH2D_WALL_SPRING:
        return MULLER;
    case SPH2D_WALL_HEAVY:
        return MULLER | PROJECTED;
    case SPH2D_WALL_GENERALISED:
        return SYMMETRIC | FITTED | PROJECTED;
    case SPH2D_WALL_REFLECT:
    case SPH2D_WALL_DEFAULT:
        break;
    }
    return MULLER | SYMMETRIC | FITTED | PROJECTED;
}

static void check_walls(sph2d__checker *c)
{
    const char *hint = "leave it out for the method's own form";
    refuse(c, "walls", true, solvers_with(c->scene->walls), hint);
    for (size_t i = 0; i < c->scene->obstacle_count; ++i) {
        char path[SPH2D__PATH_SIZE];
        refuse(c, sph2d__check_path(path, "obstacles", i, ".form"), true, solvers_with(c->scene->obstacles[i].form),
               hint);
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
        refuse(c, paths[k], sides[k] == SPH2D_SIDE_OPEN, MULLER | SYMMETRIC | PROJECTED,
               "liquid must fill its room: make the side a wall or periodic, or take `operators: symmetric`");
        walled |= sides[k] == SPH2D_SIDE_WALL;
    }
    refuse(c, "wall_slip", walled && scene->wall_slip == SPH2D_SLIP_FREE, MULLER | SYMMETRIC | PROJECTED,
           "take `wall_slip: none`, or `operators: symmetric`");
    refuse(c, "sources", scene->source_count > 0, MULLER | SYMMETRIC | PROJECTED, "take `operators: symmetric`");
    refuse(c, "drains", scene->drain_count > 0, MULLER | SYMMETRIC | PROJECTED, "take `operators: symmetric`");
}

static void check_pair(sph2d__checker *c, sph2d_side a, sph2d_side b, const char *path, double length)
{
    bool periodic = a == SPH2D_SIDE_PERIODIC;
    if (periodic != (b == SPH2D_SIDE_PERIODIC)) {
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, "a periodic side needs a periodic side opposite");
        return;
    }
    double reach = sph2d__scene_reach(c->scene);
    if (solver_of(&c->scene->method) == FITTED)
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
