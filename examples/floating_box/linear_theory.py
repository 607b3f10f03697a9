#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Linear theory of a box that floats in a tank and is let go: heave.csv, roll.csv. Needs numpy and scipy.

Potential flow with the linear conditions at the mean surface and at the box's place at rest, d eta/dt = phi_y, d phi/dt
= -g eta (Newman 1977, Marine Hydrodynamics, ch. 6), coupled with the box: the pressure's part that is proportional to
its acceleration is the added mass at infinite frequency, all else the memory of Cummins 1962. Finite volumes in half the
tank, Runge-Kutta steps. Heave alone; roll and sway together. Corners of the box make errors of the order d^(4/3), which
two cell sizes d show and remove.
"""
import numpy as np
from scipy.sparse import lil_matrix
from scipy.sparse.linalg import splu

G, RHO, BREADTH, HEIGHT, DRAUGHT, WIDTH, DEPTH = 9.81, 1000, 0.2, 0.1, 0.05, 2, 0.3


def release(odd, first, until, per_draught):
    """Displacements in time: [heave], or [sway, roll] where odd, from those at the start."""
    d = DRAUGHT / per_draught
    nx, ny = round(WIDTH / 2 / d), round(DEPTH / d)
    bx, by = round(BREADTH / 2 / d), per_draught
    number = -np.ones((nx, ny), int)                    # row 0 is below the surface
    wet = np.ones((nx, ny), bool)
    wet[:bx, :by] = False
    number[wet] = np.arange(wet.sum())
    a = lil_matrix((wet.sum(), wet.sum()))
    for i, j in zip(*np.nonzero(wet)):
        n = number[i, j]
        for k, m in ((i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)):
            if 0 <= k < nx and 0 <= m < ny:
                if wet[k, m]:
                    a[n, n] += 1
                    a[n, number[k, m]] -= 1
            elif m < 0 or (odd and k < 0):              # phi is given half a cell away: the surface; 0 in the middle
                a[n, n] += 2
    solve = splu(a.tocsc()).solve
    top = number[bx:, 0]
    x, y = (np.arange(bx) + 0.5) * d, -(np.arange(by) + 0.5) * d
    bottom, side = number[:bx, by], number[bx, :by]
    # Generalised normals, out of the box, at its wet cells.
    if odd:
        normals = [(bottom * 0.0, side * 0.0 + 1), (-x, -y)]
        mass = np.diag([RHO * BREADTH * DRAUGHT, RHO * BREADTH * DRAUGHT * (BREADTH ** 2 + HEIGHT ** 2) / 12])
        metacentre = BREADTH ** 3 / 12 - BREADTH * DRAUGHT * (HEIGHT / 2 - DRAUGHT / 2)
        spring = np.diag([0, RHO * G * metacentre])
    else:
        normals = [(bottom * 0.0 - 1, side * 0.0)]
        mass, spring = np.diag([RHO * BREADTH * DRAUGHT]), np.diag([RHO * G * BREADTH])
    count = len(normals)

    def potential(surface, speeds):
        b = np.zeros(wet.sum())
        b[top] += 2 * surface
        for speed, (nb, ns) in zip(speeds, normals):
            b[bottom] -= d * speed * nb                 # flux out of the box into the liquid: -n is its gradient's
            b[side] -= d * speed * ns
        return solve(b)

    def on_box(phi):                                    # 2 rho times the integral of phi n
        return np.array([2 * RHO * d * (phi[bottom] @ nb + phi[side] @ ns) for nb, ns in normals])

    unit = np.eye(count)
    added = -np.array([on_box(potential(0, unit[k])) for k in range(count)]).T

    def rate(state):
        eta, phi, z, v = state
        flow = potential(phi, v)
        force = on_box(potential(-G * eta, 0 * v)) - spring @ z
        return [2 * (phi - flow[top]) / d, -G * eta, v, np.linalg.solve(mass + added, force)]

    state = [np.zeros(nx - bx), np.zeros(nx - bx), np.array(first, float), np.zeros(count)]
    dt, series = 0.005, [np.array(first, float)]
    for _ in range(round(until / dt)):
        k1 = rate(state)
        k2 = rate([s + dt / 2 * k for s, k in zip(state, k1)])
        k3 = rate([s + dt / 2 * k for s, k in zip(state, k2)])
        k4 = rate([s + dt * k for s, k in zip(state, k3)])
        state = [s + dt / 6 * (p + 2 * q + 2 * r + w) for s, p, q, r, w in zip(state, k1, k2, k3, k4)]
        series.append(state[2])
    return added, np.array(series)


def crossings(z):
    """Times of zero crossings."""
    k = np.nonzero(z[1:] * z[:-1] < 0)[0]
    return 0.005 * (k + z[k] / (z[k] - z[k + 1]))


if __name__ == "__main__":
    for name, odd, first in (("heave", False, [1]), ("roll", True, [0, 1])):
        coarse, rough = release(odd, first, 2, 10)
        fine, z = release(odd, first, 2, 20)
        part = 1 / (2 ** (4 / 3) - 1)
        fine, z = fine + part * (fine - coarse), (z + part * (z - rough))[:, -1]
        print(name, "added mass at infinite frequency", fine.round(4).tolist(), "zeros", crossings(z).round(4).tolist())
        with open(name + ".csv", "w", encoding="ascii") as out:
            out.write("t,over_start,turn\n")
            for k in range(0, len(z), 2):
                out.write(f"{0.005 * k:.2f},{z[k]:.5f},{z[k] - 1:.5f}\n")
