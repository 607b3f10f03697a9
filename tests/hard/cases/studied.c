/* SPDX-License-Identifier: MIT */
/** @file studied.c
 *  Hard cases that studies judge: those of tests/hard by `make test-hard`, those of examples/ by `make report`. They are
 *  not run again here. */
#include "cases.h"

const studied_case studied_cases[] = {
    {"C1", "a disc that rotates, under tension everywhere", "study `disc`"},
    {"C2", "a square patch that rotates", "study `patch`"},
    {"C3", "a drop that stretches; one that swings for 15 periods", "studies `elongating_drop`, `oscillating_drop`"},
    {"C7", "a wake, where pressure is below 0", "study `stream`"},
    {"D1", "a tank at rest", "studies `rest`, `hydrostatic`, `hydrostatic_methods`"},
    {"D2", "corners: 45, 10 and 160 degrees, a slope, a tilted box",
     "studies `wedge`, `wedge_narrow`, `wedge_flat`, `narrow`, `slope`, `tilted`"},
    {"D3", "connected columns", "studies `u_tube`, `tube`"},
    {"D8", "a lid that drags the liquid of a box along", "studies `cavity`, `cavity_re400`, `cavity_re1000`"},
    {"E4", "vortices with little viscosity", "studies `taylor_green`, `taylor_green_re1000`, `gresho`"},
    {"E5", "particles of two masses", "not supported: a scene has one liquid, and all particles the same mass"},
    {"F1", "a dam break until it rests",
     "studies `dam_break`, `settled`, `dam_break_front`, `dam_break_front_methods`, `dam_break_pressure`"},
    {"F2", "sloshing", "studies `sloshing`, `shaken_tank`"},
    {"F3", "a standing wave", "studies `standing_wave`, `viscous_wave`, `viscous_wave_re20`"},
    {"F4", "a tank at rest for 136,000 steps", "study `rest`"},
    {"F6", "Taylor-Green vortices", "studies `taylor_green`, `taylor_green_re1000`"},
    {"F7", "a cavity at Re 1000", "study `cavity_re1000`"},
    {"F8", "Gresho's vortex", "study `gresho`"},
};
const size_t studied_case_count = sizeof studied_cases / sizeof *studied_cases;
