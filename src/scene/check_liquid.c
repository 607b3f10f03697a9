/* SPDX-License-Identifier: MIT */
/** @file check_liquid.c
 *  Checks how the viscosity of the liquid depends on the shear rate, and that the method can have it. */
#include <stdio.h>

#include "scene/checker.h"
#include "scene/resolve.h"
#include "sph2d/method.h"

typedef sph2d__checker checker;

/** A parameter of some models. */
typedef struct parameter {
    const char *key;
    double value, otherwise; /**< and the one of a scene that does not give it */
    unsigned models;         /**< that have it: bits 1 << sph2d_rheology */
    bool needed;             /**< by these */
} parameter;

#define OF(model) (1u << SPH2D_RHEOLOGY_##model)

static void check_parameter(checker *c, const parameter *p)
{
    static const char *const words[] = {"newtonian", "power_law", "carreau", "herschel_bulkley"};
    int model = (int)c->scene->fluid.model;
    bool has = p->models >> model & 1;
    char path[SPH2D__PATH_SIZE], message[80];
    snprintf(path, sizeof path, "fluid.%s", p->key);
    if (has && p->needed && !(p->value > 0)) {
        snprintf(message, sizeof message, "must be given and above 0: it is a part of %s", words[model]);
        sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, path, message);
    } else if (!has && p->value != p->otherwise) {
        snprintf(message, sizeof message, "is no part of a liquid that is %s", words[model]);
        sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, message);
        sph2d_diagnostic_hint(d, "leave it out, or give another `model`");
    }
}

static void check_parameters(checker *c)
{
    const sph2d_fluid *f = &c->scene->fluid;
    const unsigned thick = OF(POWER_LAW) | OF(HERSCHEL_BULKLEY);
    double viscosity = sph2d_fluid_of(f->material).dynamic_viscosity; /* one that a material brings is not given */
    const parameter all[] = {
        {"consistency", f->consistency, 0, thick, true},
        {"yield_stress", f->yield_stress, 0, OF(HERSCHEL_BULKLEY), true},
        {"regularisation", f->regularisation, 0, thick, false},
        {"infinite_viscosity", f->infinite_viscosity, 0, OF(CARREAU), false},
        {"relaxation_time", f->relaxation_time, 0, OF(CARREAU), true},
        {"index", f->index, 0, thick | OF(CARREAU), f->model == SPH2D_RHEOLOGY_CARREAU},
        {"dynamic_viscosity", f->dynamic_viscosity, viscosity, OF(NEWTONIAN) | OF(CARREAU), false},
    };
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        check_parameter(c, &all[k]);
    if (f->model == SPH2D_RHEOLOGY_CARREAU && !(f->infinite_viscosity < f->dynamic_viscosity))
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "fluid.infinite_viscosity",
                           "must be less than dynamic_viscosity, which is that at rest");
}

void sph2d__check_liquid(checker *c)
{
    const sph2d_method_options *m = &c->scene->method;
    check_parameters(c);
    if (c->scene->fluid.model == SPH2D_RHEOLOGY_NEWTONIAN)
        return;
    if (!sph2d_method_has(sph2d_method_of(m), SPH2D_FEATURE_RHEOLOGY)) {
        sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, "fluid.model",
                                                 "this method knows no shear rate: it has newtonian liquids only");
        sph2d_diagnostic_hint(d, "use `method: wcsph` with symmetric operators, constraint or pcisph");
        return;
    }
    if (m->name == SPH2D_METHOD_WCSPH && !(m->shifting > 0))
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "method.shifting",
                           "must be above 0: the shear rate is known with shifting only");
    if (m->turbulence == SPH2D_TURBULENCE_SMAGORINSKY)
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "method.turbulence", "is for newtonian liquids: use none");
    if (c->scene->wall_slip == SPH2D_SLIP_SMOOTH || sph2d__slips(c->scene) >> SPH2D_SLIP_SMOOTH & 1)
        sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, "wall_slip",
                           "smooth walls have the friction of newtonian liquids: use none or free");
}
