/* SPDX-License-Identifier: MIT */
/** @file check_liquid.c
 *  Checks how the viscosity of the liquid depends on the shear rate, that the method can have it, and its colours. */
#include <stdio.h>
#include <string.h>

#include "base/suggest.h"
#include "scene/checker.h"
#include "sph2d/method.h"

typedef sph2d__checker checker;

/** A parameter of some models. */
typedef struct parameter {
    const char *key;
    double value, otherwise; /**< and the one of a scene that does not give it */
    double brought;          /**< the one of the material, which is not given either */
    unsigned models;         /**< that have it: bits 1 << sph2d_rheology */
    bool needed;             /**< by these */
} parameter;

#define OF(model) (1u << SPH2D_RHEOLOGY_##model)

static const char *const words[] = {"newtonian", "power_law", "carreau", "herschel_bulkley"};

/** The material whose model the liquid has, if that is not newtonian; else NULL. */
static const sph2d_material_data *modelled_by(const sph2d_fluid *f)
{
    bool has = f->model != SPH2D_RHEOLOGY_NEWTONIAN && sph2d_fluid_of(f->material).model == f->model;
    return has ? &sph2d_materials(NULL)[f->material] : NULL;
}

static void check_parameter(checker *c, const parameter *p)
{
    const sph2d_material_data *material = modelled_by(&c->scene->fluid);
    int model = (int)c->scene->fluid.model;
    bool has = p->models >> model & 1;
    char path[SPH2D__PATH_SIZE], message[120];
    snprintf(path, sizeof path, "fluid.%s", p->key);
    if (has && p->needed && !(p->value > 0)) {
        snprintf(message, sizeof message, "must be given and above 0: it is a part of %s", words[model]);
        sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, path, message);
    } else if (!has && p->value != p->otherwise && p->value != p->brought) {
        snprintf(message, sizeof message, "is no part of a liquid that is %s%s%s%s", words[model],
                 material ? ", as " : "", material ? material->name : "", material ? " is" : "");
        sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_CONFLICT, path, message);
        bool single = material && p->models & OF(NEWTONIAN); /* a viscosity */
        sph2d_diagnostic_hint(d, "leave it out, or %s", single ? "add `model: newtonian`" : "give another `model`");
    }
}

static void check_parameters(checker *c)
{
    const sph2d_fluid *f = &c->scene->fluid, material = sph2d_fluid_of(f->material);
    const sph2d_fluid otherwise = sph2d_fluid_of(SPH2D_MATERIAL_NONE);
    const unsigned thick = OF(POWER_LAW) | OF(HERSCHEL_BULKLEY);
#define PARAMETER(name) #name, f->name, otherwise.name, material.name
    const parameter all[] = {
        {PARAMETER(consistency), thick, true},
        {PARAMETER(yield_stress), OF(HERSCHEL_BULKLEY), true},
        {PARAMETER(regularisation), thick, false},
        {PARAMETER(infinite_viscosity), OF(CARREAU), false},
        {PARAMETER(relaxation_time), OF(CARREAU), true},
        {PARAMETER(index), thick | OF(CARREAU), f->model == SPH2D_RHEOLOGY_CARREAU},
        {PARAMETER(dynamic_viscosity), OF(NEWTONIAN) | OF(CARREAU), false},
    };
#undef PARAMETER
    if ((size_t)f->model >= sizeof words / sizeof *words) /* no word of it: told by the checks of ranges */
        return;
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        check_parameter(c, &all[k]);
}

/** A liquid that is named blood and given another viscosity is newtonian for most who write that, and one that is
 *  thicker or thinner at rest for some: they have to say which. */
static void check_viscosity(checker *c)
{
    const sph2d_fluid *f = &c->scene->fluid, material = sph2d_fluid_of(f->material);
    const char *name = sph2d_materials(NULL)[material.material].name, *law = words[material.model];
    bool own = f->dynamic_viscosity != material.dynamic_viscosity;
    char message[120];
    if (modelled_by(f) && f->model == SPH2D_RHEOLOGY_CARREAU && own) {
        snprintf(message, sizeof message, "%s has no single viscosity: it is %s", name, law);
        sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "fluid.dynamic_viscosity", message);
        sph2d_diagnostic_hint(d, "add `model: newtonian`, or give a liquid that is %s without `material`", law);
    } else if (f->model == SPH2D_RHEOLOGY_CARREAU && !(f->infinite_viscosity < f->dynamic_viscosity)) {
        sph2d__check_fault(c, SPH2D_CODE_CONFLICT, "fluid.infinite_viscosity",
                           "must be less than dynamic_viscosity, which is that at rest");
    } else if (f->model == SPH2D_RHEOLOGY_NEWTONIAN && material.model != f->model && !own) {
        snprintf(message, sizeof message, "must be given: %s is %s and has no single viscosity", name, law);
        sph2d__check_fault(c, SPH2D_CODE_MISSING_KEY, "fluid.dynamic_viscosity", message);
    }
}

static void check_method(checker *c)
{
    const sph2d_material_data *material = modelled_by(&c->scene->fluid);
    char message[120] = "this method knows no shear rate: it has newtonian liquids only";
    if (material)
        snprintf(message, sizeof message,
                 "%s is %s, and this method knows no shear rate: it has newtonian liquids only", material->name,
                 words[material->model]);
    sph2d_diagnostic *d =
        sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, material ? "fluid.material" : "fluid.model", message);
    sph2d_diagnostic_hint(d, "use `method: wcsph` with variational operators or constraint%s",
                          material ? ", or add `model: newtonian` with a `dynamic_viscosity`" : "");
}

/* ---- colours ----------------------------------------------------------------------------------------------------- */

static void check_color(checker *c, const char *color, const char *path)
{
    enum { MOST_COLORS = 200 };
    uint32_t ignored;
    if (!color || sph2d_color_parse(color, &ignored))
        return;
    char message[SPH2D__PATH_SIZE];
    snprintf(message, sizeof message, "'%.64s' is no colour", color);
    sph2d_diagnostic *d = sph2d__check_fault(c, SPH2D_CODE_OUT_OF_RANGE, path, message);
    const char *names[MOST_COLORS + 1] = {NULL};
    for (size_t k = 0; k < MOST_COLORS && sph2d_color_name(k); ++k)
        names[k] = sph2d_color_name(k);
    sph2d__suggest_word(d, color, names, "");
    if (d && strncmp(d->hint, "did", 3) != 0) /* all of them are too many */
        sph2d_diagnostic_hint(d, "write a name of CSS, as orange, or \"#ff8000\" in quotation marks");
}

static void check_colors(checker *c)
{
    const sph2d_scene *s = c->scene;
    char path[SPH2D__PATH_SIZE];
    check_color(c, s->fluid.color, "fluid.color");
    for (size_t i = 0; i < s->block_count; ++i)
        check_color(c, s->blocks[i].color, sph2d__check_path(path, "blocks", i, ".color"));
    for (size_t i = 0; i < s->source_count; ++i)
        check_color(c, s->sources[i].color, sph2d__check_path(path, "sources", i, ".color"));
    for (size_t i = 0; i < s->opening_count; ++i)
        check_color(c, s->openings[i].color, sph2d__check_path(path, "openings", i, ".color"));
}

void sph2d__check_liquid(checker *c)
{
    check_colors(c);
    const sph2d_method_options *m = &c->scene->method;
    check_parameters(c);
    check_viscosity(c);
    if (c->scene->fluid.model == SPH2D_RHEOLOGY_NEWTONIAN)
        return;
    if (!sph2d_method_has(sph2d_method_of(m), SPH2D_FEATURE_RHEOLOGY)) {
        check_method(c);
        return;
    }
    if (c->scene->wall_slip == SPH2D_SLIP_SMOOTH || sph2d__wall_slips(c->world) >> SPH2D_SLIP_SMOOTH & 1)
        sph2d__check_fault(c, SPH2D_CODE_UNSUPPORTED, "wall_slip",
                           "smooth walls have the friction of newtonian liquids: use none or free");
}
