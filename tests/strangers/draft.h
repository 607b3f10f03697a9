/* SPDX-License-Identifier: MIT */
/** @file draft.h
 *  A random scene that is being written: what is decided so far, and random numbers. */
#ifndef SPH2D_STRANGERS_DRAFT_H
#define SPH2D_STRANGERS_DRAFT_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/** What is decided so far. */
typedef struct draft {
    FILE *out;
    uint64_t random;
    double width, height, left, bottom, spacing;
    double gravity, fall, speed; /**< [m/s^2]; how deep liquid can fall [m]; the fastest start or source [m/s] */
    double density, viscosity, tension;
    char method[16];
    bool fitted, layered, full, free, periodic_x, periodic_y;
    bool open[4];
    double support, max_compression, cfl, area;
    bool bodied;  /**< whether it is of those that may have bodies and a tank that moves */
    bool thick;   /**< whether its liquid is thick, or not Newtonian, by a method that solves for viscosity */
    bool gridded; /**< whether it is by method hybrid */
    bool opened;  /**< whether it has openings, and may have a liquid that is not Newtonian */
} draft;

/** A place for something of so large a half size, and all that are taken. */
typedef struct place {
    double x, y, half_x, half_y;
} place;
enum { MOST_PLACES = 8 };
typedef struct places {
    place items[MOST_PLACES];
    int count;
} places;

/** The next random number, and what is made of it: evenly between two numbers, evenly over decades, a chance. */
uint64_t draft_next(draft *d);
double between(draft *d, double low, double high);
double decades(draft *d, double low, double high);
bool chance(draft *d, double p);

/** One of several words. */
const char *one_of(draft *d, const char *const *names, unsigned count);
#define ONE_OF(d, ...)                                                                                                 \
    one_of(d, (const char *const[]){__VA_ARGS__}, sizeof((const char *const[]){__VA_ARGS__}) / sizeof(char *))

/** Whether that is the scene's method. */
bool is(const draft *d, const char *method);

/** Writes the method with numbers that it has; sets what its steps depend on. */
void write_method(draft *d);
/** Writes forms of the sides' walls that the method has, and how slippery they are. */
void write_walls(draft *d);

/** Writes rigid bodies, clear of the places from `first` on: those of obstacles and sources, not of liquid. */
void write_bodies(draft *d, const places *taken, int first);
/** Writes openings. */
void write_openings(draft *d);
/** Writes the motion of the tank. */
void write_tank(draft *d);

#endif
