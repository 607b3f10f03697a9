/* SPDX-License-Identifier: MIT */
/** @file materials.c
 *  Named liquids, at 20 C unless another temperature is named, and atmospheric pressure.
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
 *             Jasper, J. Phys. Chem. Ref. Data 1 (1972) 841, 490.6 - 0.2049 t/C mN/m
 *  seawater   of practical salinity 35, 35.165 g/kg: density EOS-80, Fofonoff & Millard, UNESCO Tech. Pap. Mar. Sci. 44
 *             (1983), 1024.763 (IAPWS R13-08: 1024.766); viscosity Sharqawy, Lienhard & Zubair, Desalin. Water Treat.
 *             16 (2010) 354, eq. 22, 1.0770 mPa s; surface tension IAPWS G14-19, 73.82 mN/m
 *  ethanol    density and viscosity Munson, Young & Okiishi, Fundamentals of Fluid Mechanics, table 1.6, 789 and
 *             1.19 mPa s (Perry's Handbook, 8th ed., table 2-313: 1.186); surface tension Jasper 1972, 24.05 - 0.0832
 *             t/C mN/m
 *  gasoline   at 15.6 C, Munson et al., table 1.6: typical values, which vary
 *  milk       of cows, with 3.6 % fat: density 1.029 g/cm3, Goff, Dairy Science and Technology, University of Guelph;
 *             viscosity Bakshi & Smith, J. Dairy Sci. 67 (1984) 1157, ln(mu/mPa s) = -8.9 + 0.1 F/% + 2721.5/(T/K);
 *             surface tension Bertsch, J. Dairy Res. 50 (1983) 259, 1.8e-4 (t/C)^2 - 0.163 t/C + 55.6 mN/m
 *  engine_oil SAE 30, at 15.6 C, Munson et al., table 1.6: typical values, which vary
 *  lava       Hawaiian basalt as it comes to the surface, at 1050 to 1200 C: Macdonald, Geol. Soc. Am. Bull. 74 (1963)
 *             1071, specific gravity 2.73 without bubbles, viscosity 2000 to 4000 P, of which the middle. It gets
 *             thicker by orders of magnitude as it cools, and stiff. No surface tension is known
 *  blood      human, at 37 C: law Cho & Kensey, Biorheology 28 (1991) 241; density Trudnowski & Rico, Clin. Chem. 20
 *             (1974) 615, 1.0506; surface tension Rosina et al., Physiol. Res. 56 S1 (2007) S93, 70.105 - 0.473 t/C
 *             mN/m
 *  chocolate  milk chocolate with 30 % fat, molten and tempered: law Bergemann, Heil, Smith & Juel, J. Rheol. 62 (2018)
 *             1187, yield stress 36.1 Pa, viscosity 8.7 Pa s; density Beckett, Industrial Chocolate Manufacture and
 *             Use, 3rd ed. (1999), 1.2 g/cm3 at 40 C. No surface tension is known
 *  mud        silt and clay of a natural mudflow in Colorado, 34.2 % by volume: law O'Brien & Julien, J. Hydraul. Eng.
 *             114 (1988) 877, table 2, Aspen natural soil, 0.152 exp(18.7 C) dyn/cm2 and 1.36e-3 exp(28.4 C) P for the
 *             volume fraction C of their fig. 1; density with solids of 2650 kg/m3. Of 38 % solids it has twice
 *             the yield stress and three times the viscosity. No surface tension is known
 *
 *  Colours are those that people know them by; what is clear has that of the look, as water. */
#include "sph2d/scene.h"

#define NEWTONIAN .model = SPH2D_RHEOLOGY_NEWTONIAN

static const sph2d_material_data materials[] = {
    {"none", 0, 0, 0, "a liquid given by its properties", NEWTONIAN},
    {"water", 998.2, 1.0016e-3, 0.07274, "IAPWS R6-95, R12-08, R1-76", NEWTONIAN},
    {"oil", 911, 0.0823, 0.033, "olive oil; Codex Stan 33, Viswanath & Natarajan 1989", NEWTONIAN, .color = "#c9b037"},
    {"glycerine", 1261, 1.41, 0.0634, "Bosart & Snoddy 1927, Segur & Oberstar 1951, CRC Handbook", NEWTONIAN},
    {"honey", 1420, 19, 0, "clover, 16 % water, at 20.6 C; Krell 1996 after Munro 1943", NEWTONIAN, .color = "#e0930f"},
    {"mercury", 13546, 1.557e-3, 0.4865, "Bigg 1964, Viswanath & Natarajan 1989, Jasper 1972", NEWTONIAN,
     .color = "silver"},
    {"seawater", 1024.8, 1.077e-3, 0.07382, "salinity 35; UNESCO EOS-80, Sharqawy et al. 2010, IAPWS G14-19",
     NEWTONIAN},
    {"ethanol", 789, 1.19e-3, 0.02239, "Munson et al., table 1.6; Jasper 1972", NEWTONIAN},
    {"gasoline", 680, 3.1e-4, 0.022, "typical, at 15.6 C; Munson et al., table 1.6", NEWTONIAN, .color = "#e8d26a"},
    {"milk", 1029, 2.1e-3, 0.0524, "whole, 3.6 % fat; Goff (Guelph), Bakshi & Smith 1984, Bertsch 1983", NEWTONIAN,
     .color = "#fbf8ef"},
    {"engine_oil", 912, 0.38, 0.036, "typical SAE 30, at 15.6 C; Munson et al., table 1.6", NEWTONIAN,
     .color = "#8a5a1e"},
    {"lava", 2730, 300, 0, "Hawaiian basalt at its vent, at 1050 to 1200 C; Macdonald 1963", NEWTONIAN,
     .color = "#e4461b"},
    {"blood", 1051, 0.056, 0.0526, "human, at 37 C; Cho & Kensey 1991, Trudnowski & Rico 1974, Rosina et al. 2007",
     .model = SPH2D_RHEOLOGY_CARREAU, .infinite_viscosity = 0.00345, .relaxation_time = 3.313, .index = 0.3568,
     .color = "#8c0f16"},
    {"chocolate", 1200, 0, 0, "milk chocolate, molten; Bergemann et al. 2018, density at 40 C Beckett 1999",
     .model = SPH2D_RHEOLOGY_HERSCHEL_BULKLEY, .yield_stress = 36.1, .consistency = 8.7, .color = "#5b3220"},
    {"mud", 1563, 0, 0, "silt and clay, 34.2 % by volume; O'Brien & Julien 1988, table 2, Aspen natural soil",
     .model = SPH2D_RHEOLOGY_HERSCHEL_BULKLEY, .yield_stress = 9.11, .consistency = 2.25, .color = "#7a5c3d"},
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
    const sph2d_material_data *m = &materials[material];
    fluid.material = material;
    fluid.density = m->density;
    if (m->dynamic_viscosity > 0) /* else the default, which the model does not use */
        fluid.dynamic_viscosity = m->dynamic_viscosity;
    fluid.model = m->model;
    fluid.consistency = m->consistency;
    fluid.index = m->index;
    fluid.yield_stress = m->yield_stress;
    fluid.infinite_viscosity = m->infinite_viscosity;
    fluid.relaxation_time = m->relaxation_time;
    return fluid;
}
