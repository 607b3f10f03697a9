/* SPDX-License-Identifier: MIT */
/** @file materials.c
 *  Named liquids, at 20 C and atmospheric pressure.
 *
 *  water      density IAPWS R6-95(2018), 998.207; viscosity IAPWS R12-08, 1.00160 mPa s; surface tension IAPWS
 *             R1-76(2014), 72.736 mN/m
 *  oil        olive oil: density the middle of Codex Stan 33-1981, 0.910 to 0.916 of water's; viscosity Viswanath &
 *             Natarajan, Data Book on the Viscosity of Liquids (1989), lg(mu/mPa s) = -1.911 + 699.7/(T/K - 110.3);
 *             surface tension from tables, 32 to 34 mN/m for vegetable oils
 *  glycerine  without water: density Bosart & Snoddy, Ind. Eng. Chem. 19 (1927) 506, 1.26108; viscosity Segur &
 *             Oberstar, Ind. Eng. Chem. 43 (1951) 2117, 1410 mPa s (Cheng, Ind. Eng. Chem. Res. 47 (2008) 3285: 1414);
 *             surface tension CRC Handbook of Chemistry and Physics (VDI Heat Atlas: 64.1 mN/m)
 *  honey      of clover with 16 % water: density 1.4225 (15 % water) to 1.4171 (18 %) of water's and viscosity 189.6 P
 *             at 20.6 C (Munro 1943), both in Krell, Value-Added Products from Beekeeping, FAO Bulletin 124 (1996);
 *             2 % more water, or 5 C, halves it. No reliable surface tension is known
 *  mercury    density Bigg, Brit. J. Appl. Phys. 15 (1964) 1111, 13545.9; viscosity Viswanath & Natarajan (1989),
 *             lg(mu/mPa s) = -0.1105 + 51.209/(T/K - 124.04) (1.526 at 25 C, as in the CRC Handbook); surface tension
 *             Jasper, J. Phys. Chem. Ref. Data 1 (1972) 841, 490.6 - 0.2049 t/C mN/m */
#include "sph2d/scene.h"

static const sph2d_material_data materials[] = {
    {"none", 0, 0, 0, "a liquid given by its properties"},
    {"water", 998.2, 1.0016e-3, 0.07274, "IAPWS R6-95, R12-08, R1-76"},
    {"oil", 911, 0.0823, 0.033, "olive oil; Codex Stan 33, Viswanath & Natarajan 1989"},
    {"glycerine", 1261, 1.41, 0.0634, "Bosart & Snoddy 1927, Segur & Oberstar 1951, CRC Handbook"},
    {"honey", 1420, 19, 0, "clover, 16 % water, at 20.6 C; Krell 1996 after Munro 1943"},
    {"mercury", 13546, 1.557e-3, 0.4865, "Bigg 1964, Viswanath & Natarajan 1989, Jasper 1972"},
};

const sph2d_material_data *sph2d_materials(size_t *count)
{
    if (count)
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
