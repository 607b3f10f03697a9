/* SPDX-License-Identifier: MIT */
/** @file materials.c
 *  Liquids by their names.
 *
 *  water      IAPWS-95 (density), IAPWS R12-08 (viscosity), IAPWS R1-76(2014) (surface tension)
 *  oil        olive oil: Codex Stan 33-1981 (density 0.910 to 0.916), Kaye & Laby, Tables of Physical and Chemical
 *             Constants, 16th ed. (viscosity, surface tension)
 *  glycerine  Bosart & Snoddy 1927 (density), Segur & Oberstar 1951 (viscosity), CRC Handbook of Chemistry and Physics
 *             (surface tension)
 *  honey      clover honey with 16 % water: White in Beekeeping in the United States, USDA Handbook 335 (density,
 *             viscosity at 20.6 C); half as thick with one part of water more in fifty
 *  mercury    CRC Handbook of Chemistry and Physics (density), Kaye & Laby (viscosity), Jasper 1972 (surface
 *             tension) */
#include "sph2d/scene.h"

static const sph2d_material_data materials[] = {
    {"none", 0, 0, 0, "a liquid by its numbers"},
    {"water", 998.2, 1.0016e-3, 0.07275, "IAPWS-95, R12-08, R1-76"},
    {"oil", 911, 0.084, 0.032, "olive oil; Codex Stan 33, Kaye & Laby"},
    {"glycerine", 1261, 1.41, 0.0634, "Bosart & Snoddy 1927, Segur & Oberstar 1951, CRC Handbook"},
    {"honey", 1420, 19, 0, "clover, 16 % water; White, USDA Handbook 335"},
    {"mercury", 13546, 1.554e-3, 0.4865, "CRC Handbook, Kaye & Laby, Jasper 1972"},
};

const sph2d_material_data *sph2d_materials(size_t *count)
{
    *count = sizeof materials / sizeof *materials;
    return materials;
}

sph2d_fluid sph2d_fluid_of(sph2d_material material)
{
    sph2d_fluid fluid = sph2d_scene_default().fluid;
    if ((int)material <= 0 || (size_t)material >= sizeof materials / sizeof *materials)
        return fluid;
    fluid.material = material;
    fluid.density = materials[material].density;
    fluid.dynamic_viscosity = materials[material].dynamic_viscosity;
    return fluid;
}
