/* SPDX-License-Identifier: MIT */
/** @file cubic.c */
#include "scene/cubic.h"

/* Nodes of the polynomial that gives a slope. */
enum { SLOPE_NODES = 5 };

typedef struct nodes {
    const double *items;
    size_t stride, count;
} nodes;

static double node(const nodes *n, size_t i)
{
    return n->items[i * n->stride];
}

/** The first node of the polynomial at node i, and their number. */
static size_t first_of(const nodes *n, size_t i, size_t *count)
{
    *count = n->count < SLOPE_NODES ? n->count : SLOPE_NODES;
    size_t before = i < SLOPE_NODES / 2 ? i : SLOPE_NODES / 2, last = n->count - *count;
    return i - before < last ? i - before : last;
}

/** Adds `factor` times the slope at node i: the derivative of Lagrange's polynomial. */
static void add_slope(const nodes *n, size_t i, double factor, sph2d__cubic *c)
{
    size_t count, first = first_of(n, i, &count);
    for (size_t j = first; j < first + count; ++j) {
        double weight = 0;
        if (j == i) {
            for (size_t k = first; k < first + count; ++k)
                weight += k != i ? 1 / (node(n, i) - node(n, k)) : 0;
        } else {
            weight = 1 / (node(n, j) - node(n, i));
            for (size_t k = first; k < first + count; ++k)
                weight *= k != i && k != j ? (node(n, i) - node(n, k)) / (node(n, j) - node(n, k)) : 1;
        }
        c->weight[j - c->first] += factor * weight;
    }
}

sph2d__cubic sph2d__cubic_at(const double *items, size_t stride, size_t count, double place)
{
    nodes n = {items, stride, count};
    size_t low = 0, high = count - 1;
    if (!(place > node(&n, low)))
        return (sph2d__cubic){low, 1, {1}};
    if (!(place < node(&n, high)))
        return (sph2d__cubic){high, 1, {1}};
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (node(&n, middle) <= place)
            low = middle;
        else
            high = middle;
    }
    size_t last_count, last = first_of(&n, high, &last_count), some;
    sph2d__cubic c = {.first = first_of(&n, low, &some)};
    c.count = last + last_count - c.first;
    double width = node(&n, high) - node(&n, low), z = (place - node(&n, low)) / width;
    c.weight[low - c.first] += (1 + 2 * z) * (1 - z) * (1 - z);
    c.weight[high - c.first] += z * z * (3 - 2 * z);
    add_slope(&n, low, width * z * (1 - z) * (1 - z), &c);
    add_slope(&n, high, -width * z * z * (1 - z), &c);
    return c;
}
