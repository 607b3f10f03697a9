#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Steady flow of power-law liquids in the lid-driven cavity: reference_power_law_u.csv, _v.csv. Needs numpy and scipy.

Finite differences of second order on a staggered grid (Harlow & Welch 1965), N x N cells that are narrower at the
walls, with a stream function: u = psi_y, v = -psi_x are free of divergence in each cell, and with velocities of that
kind as test functions the momentum equation, integrated by parts, has no pressure:

    sum (2 mu D - u u) : D' = 0,   mu = K max(g, 1/m)^(n-1) for n < 1, K g^(n-1) else,   g = sqrt(2 D:D),   K = 1/Re

Density, side and lid speed are 1. Each iteration solves for psi with the viscosity and the convecting velocity of the
last (Picard). N, 2 N and 4 N cells show the order, and the last two are extrapolated (Richardson). With n = 1 they are
compared with reference_u.csv, reference_v.csv, and with Ghia, Ghia & Shin 1982 (J. Comput. Phys. 48, 387).
"""
import csv
import sys
import numpy as np
from scipy.interpolate import CubicSpline
from scipy.sparse import bmat, diags, eye, hstack, kron
from scipy.sparse.linalg import spsolve

PLACES = np.arange(2, 63) / 64                          # not nearer to walls than a spacing of 32 across
GHIA_U = {0.0547: -0.03717, 0.0625: -0.04192, 0.0703: -0.04775, 0.1016: -0.06434, 0.1719: -0.10150, 0.2813: -0.15662,
          0.4531: -0.21090, 0.5: -0.20581, 0.6172: -0.13641, 0.7344: 0.00332, 0.8516: 0.23151, 0.9531: 0.68717,
          0.9609: 0.73722, 0.9688: 0.78871, 0.9766: 0.84123}


def solve(n, N, reynolds=100, m=100, tolerance=1e-7):
    """Velocities u and v on the centrelines at PLACES."""
    s = np.arange(N + 1) / N
    node = s - 0.8 * np.sin(2 * np.pi * s) / (2 * np.pi)
    width, centre = np.diff(node), (node[1:] + node[:-1]) / 2
    apart = np.diff(np.concatenate(([0], centre, [1])))                       # half a cell at the walls
    inside = eye(N + 1, format="csr")[:, 1:N]                                 # of the inner nodes, 0 at the walls
    cells, nodes = eye(N, format="csr"), eye(N - 1, format="csr")
    slope = diags(1 / width) @ diags([-1.0, 1.0], [0, 1], shape=(N, N + 1)) @ inside      # nodes to cells
    mean = diags([0.5, 0.5], [0, 1], shape=(N, N + 1)) @ inside
    across = diags(1 / apart) @ diags([1.0, -1.0], [0, -1], shape=(N + 1, N))             # cells to nodes; 0 at the walls
    share = width[:-1] / (width[:-1] + width[1:])
    to_nodes = inside @ diags([1 - share, share], [0, 1], shape=(N - 1, N))           # 0 at the walls

    def both(a, b):                                                           # a along x, b along y
        return kron(a, b, format="csr")

    curl = bmat([[both(nodes, slope)], [-both(slope, nodes)]], format="csr")  # psi to u in (N-1) N faces, v in N (N-1)
    count = (N - 1) * N
    normal = hstack([both(slope, cells), 0 * both(cells, slope)], format="csr")       # D_xx in cells, D_yy = -D_xx
    shear = 0.5 * hstack([both(inside, across), both(across, inside)], format="csr")  # D_xy in nodes, without the lid
    lid = np.zeros((N + 1, N + 1))
    lid[1:N, N] = 0.5 / apart[N]
    lid = lid.ravel()
    u_cells, v_cells = both(mean, cells), both(cells, mean)
    u_nodes, v_nodes = both(inside, to_nodes), both(to_nodes, inside)
    half = diags([0.5, 0.5], [0, 1], shape=(N, N + 1))
    nodes_to_cells = both(half, half)
    cells_to_nodes = both(to_nodes, to_nodes)                                 # D_xx is 0 at the walls
    in_cells, in_nodes = np.outer(width, width).ravel(), np.outer(apart, apart).ravel()

    def viscosity(g):
        return (np.maximum(g, 1 / m) if n < 1 else g) ** (n - 1) / reynolds

    psi, change, steps = np.zeros((N - 1) ** 2), 1, 0
    while change > tolerance and steps < 200:
        w = curl @ psi
        u, v = w[:count], w[count:]
        xx, xy = normal @ w, shear @ w + lid
        mu_cells = viscosity(2 * np.sqrt(xx ** 2 + nodes_to_cells @ xy ** 2))
        mu_nodes = viscosity(2 * np.sqrt(xy ** 2 + cells_to_nodes @ xx ** 2))
        if steps == 0:
            mu_cells, mu_nodes = 0 * mu_cells + 1 / reynolds, 0 * mu_nodes + 1 / reynolds
        flux_cells = hstack([diags(u_cells @ u) @ u_cells, -diags(v_cells @ v) @ v_cells])        # u u - v v
        flux_nodes = 0.5 * hstack([diags(v_nodes @ v) @ u_nodes, diags(u_nodes @ u) @ v_nodes])   # u v
        stress_cells = diags(in_cells) @ (diags(4 * mu_cells) @ normal - flux_cells)
        stress_nodes = 2 * diags(in_nodes) @ (diags(2 * mu_nodes) @ shear - flux_nodes)
        matrix = curl.T @ (normal.T @ stress_cells + shear.T @ stress_nodes) @ curl
        new = spsolve(matrix.tocsc(), -curl.T @ (shear.T @ (in_nodes * 4 * mu_nodes * lid)))
        change = abs(curl @ (new - psi)).max()
        psi, steps = psi + (1 if n <= 1 else 0.7) * (new - psi), steps + 1
    w = curl @ psi
    u, v = w[:count].reshape(N - 1, N)[N // 2 - 1], w[count:].reshape(N, N - 1)[:, N // 2 - 1]
    print(f"n = {n}, {N} x {N}: {steps} iterations, last change {change:.0e}, u from {u.min():.6f}, "
          f"v from {v.min():.6f} to {v.max():.6f}", flush=True)
    at = np.concatenate(([0], centre, [1]))
    return np.array([CubicSpline(at, np.concatenate(([0], u, [1])))(PLACES),
                     CubicSpline(at, np.concatenate(([0], v, [0])))(PLACES)])


def known(name):
    with open(f"reference_{name}.csv", encoding="ascii") as file:
        return np.array(list(csv.reader(line for line in file if line[0] != "#"))[1:], float)[:, :2]


if __name__ == "__main__":
    first = int(sys.argv[1]) if len(sys.argv) > 1 else 64
    lines = {}
    for index in (1, 0.5, 1.5):
        rough, middle, fine = (solve(index, k * first) for k in (1, 2, 4))
        a, b = abs(middle - rough).max(), abs(fine - middle).max()
        lines[index] = fine + (fine - middle) / 3
        print(f"n = {index}: largest differences {a:.1e}, {b:.1e}: order {np.log2(a / b):.2f}; "
              f"extrapolated by {b / 3:.1e}")
        if index == 1:
            for line, name in zip(lines[1], "uv"):
                places, values = known(name).T
                values, places = values[(places > 0.03) & (places < 0.97)], places[(places > 0.03) & (places < 0.97)]
                print(f"{name} from reference_{name}.csv: {abs(CubicSpline(PLACES, line)(places) - values).max():.1e}")
            at, u = np.array(list(GHIA_U.items())).T
            print(f"u from Ghia et al.: {abs(CubicSpline(PLACES, lines[1][0])(at) - u).max():.4f}")
    for (name, axis), k in ((("u", "y"), 0), (("v", "x"), 1)):
        with open(f"reference_power_law_{name}.csv", "w", encoding="ascii") as out:
            out.write("# Velocity on a centreline of the cavity for n = 0.5 and 1.5 at Re 100, m = 100: power_law_reference.py, "
                      "accurate to 1e-4.\n")
            out.write(f"{axis},n05,n15\n")
            for place, thin, thick in zip(PLACES, lines[0.5][k], lines[1.5][k]):
                out.write(f"{place:.6f},{thin:.6f},{thick:.6f}\n")
