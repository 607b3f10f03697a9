/* SPDX-License-Identifier: MIT */
/** @file templates.h
 *  The files beside this one that become a part of the program. */
#ifndef SPH2D_CLI_STUDY_TEMPLATES_H
#define SPH2D_CLI_STUDY_TEMPLATES_H

extern const char study_page_html[], study_plots_gp[];

#endif
