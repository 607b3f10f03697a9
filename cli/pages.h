/* SPDX-License-Identifier: MIT */
/** @file pages.h
 *  The keys of a scene as the part of docs/scenes.md and of the manual page sph2d-scene(5) that is not written by hand. */
#ifndef SPH2D_CLI_PAGES_H
#define SPH2D_CLI_PAGES_H

/** Every key with type, unit, values, default, methods and meaning, as Markdown, to stdout. */
void pages_print_markdown(void);

/** The same in mdoc, the language of manual pages. */
void pages_print_manual(void);

#endif
