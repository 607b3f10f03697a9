/* SPDX-License-Identifier: MIT */
#include "contacts/convex.h"

#include <math.h>
#include <stdbool.h>

double sph2d__turn(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/** Twice the area of a triangle that is nothing but rounding. */
static double nothing(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c)
{
    return 1e-12 * ((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y) + (c.x - b.x) * (c.x - b.x) +
                    (c.y - b.y) * (c.y - b.y));
}

/** Whether the triangle at place `i` of what is left can be cut off: it turns left, and no corner is in it or on a
 *  side, so that what is left does not touch itself. */
static bool is_ear(const sph2d_vec2 *corners, const int *left, int count, int i)
{
    int before = left[(i + count - 1) % count], after = left[(i + 1) % count];
    sph2d_vec2 a = corners[before], b = corners[left[i]], c = corners[after];
    double turn = sph2d__turn(a, b, c), zero = nothing(a, b, c);
    if (turn <= zero)
        return false;
    for (int k = 0; k < count; ++k) {
        sph2d_vec2 p = corners[left[k]];
        bool own = left[k] == before || left[k] == left[i] || left[k] == after;
        if (!own && sph2d__turn(a, b, p) >= -zero && sph2d__turn(b, c, p) >= -zero && sph2d__turn(c, a, p) >= -zero)
            return false;
    }
    return true;
}

/** The place of an ear; where rounding leaves none, that of the corner that turns left most. */
static int find_ear(const sph2d_vec2 *corners, const int *left, int count)
{
    int best = 0;
    double most = -INFINITY;
    for (int i = 0; i < count; ++i) {
        if (is_ear(corners, left, count, i))
            return i;
        double turn =
            sph2d__turn(corners[left[(i + count - 1) % count]], corners[left[i]], corners[left[(i + 1) % count]]);
        best = turn > most ? i : best;
        most = turn > most ? turn : most;
    }
    return best;
}

static int cut_ears(const sph2d_vec2 *corners, int count, int *left, sph2d__piece *pieces)
{
    int found = 0;
    for (int i = 0; i < count; ++i)
        left[i] = i;
    for (; count >= 3; --count) {
        int ear = count == 3 ? 1 : find_ear(corners, left, count);
        int a = left[(ear + count - 1) % count], b = left[ear], c = left[(ear + 1) % count];
        if (sph2d__turn(corners[a], corners[b], corners[c]) > nothing(corners[a], corners[b], corners[c])) {
            sph2d__piece *piece = &pieces[found++];
            piece->count = 3;
            piece->corners[0] = a;
            piece->corners[1] = b;
            piece->corners[2] = c;
        }
        for (int k = ear; k + 1 < count; ++k)
            left[k] = left[k + 1];
    }
    return found;
}

static int corner(const sph2d__piece *piece, int place)
{
    return piece->corners[(place % piece->count + piece->count) % piece->count];
}

/** Joins b to a, of which the side after place i of a is that after place j of b, backwards, if all stays convex. */
static bool join_at(const sph2d_vec2 *corners, sph2d__piece *a, const sph2d__piece *b, int i, int j)
{
    int u = corner(a, i), v = corner(a, i + 1);
    if (sph2d__turn(corners[corner(a, i - 1)], corners[u], corners[corner(b, j + 2)]) < 0 ||
        sph2d__turn(corners[corner(b, j - 1)], corners[v], corners[corner(a, i + 2)]) < 0)
        return false;
    int more = b->count - 2;
    for (int k = a->count - 1; k > i; --k)
        a->corners[k + more] = a->corners[k];
    for (int k = 0; k < more; ++k)
        a->corners[i + 1 + k] = corner(b, j + 2 + k);
    a->count += more;
    return true;
}

static bool join(const sph2d_vec2 *corners, sph2d__piece *a, const sph2d__piece *b)
{
    for (int i = 0; i < a->count; ++i)
        for (int j = 0; j < b->count; ++j)
            if (corner(a, i) == corner(b, j + 1) && corner(a, i + 1) == corner(b, j))
                return join_at(corners, a, b, i, j);
    return false;
}

int sph2d__convex_pieces(const sph2d_vec2 *corners, int count, int *left, sph2d__piece *pieces)
{
    int found = cut_ears(corners, count, left, pieces);
    for (int i = 0; i < found; ++i) {
        for (int j = i + 1; j < found; ++j) {
            if (!join(corners, &pieces[i], &pieces[j]))
                continue;
            sph2d__piece joined = pieces[j];
            pieces[j] = pieces[--found];
            pieces[found] = joined;
            j = i; /* what did not fit may fit now */
        }
    }
    return found;
}
