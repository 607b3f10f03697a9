#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Contraction beneath a vertical sharp gate by potential flow with gravity: Cc over a/E. Needs numpy.

The complex potential maps the flow to the upper half-plane t = exp(pi w/q), with bed t > 0, surface before the gate, a
level lid, -c < t < 0, gate -1 < t < -c, and the jet's surface t < -1. There ln(V exp(-i theta)) is analytic, so that the
speed V at the boundary follows from the direction theta: 0, -pi/2 at the gate, unknown at the jet's surface. Bernoulli's
law on the jet, and far before the gate, gives it and c by Newton's method (Benjamin 1956, J. Fluid Mech. 1: 227; with a
surface in place of the lid: Vanden-Broeck 1997, J. Fluid Mech. 330: 339). Depth, velocity and discharge of the jet are 1.
"""
import numpy as np


def contraction(froude, pieces=100):
    """a/E and Cc for a Froude number of the jet."""
    g = 1 / froude**2
    logs = 14 * np.linspace(0, 1, pieces + 1)**2.5      # ln -t at the ends of pieces, close together at the lip
    u, middle = np.exp(logs), np.exp((logs[1:] + logs[:-1]) / 2)

    def log_speed(theta, c, s):                         # theta is linear between the ends
        low, high = u[:-1], u[1:]
        slope = np.diff(theta) / (high - low)
        s = s[:, None]
        jet = (theta[:-1] + slope * (s - low)) * np.log(np.abs((high - s) / (low - s))) + slope * (high - low)
        return np.log(np.abs((s[:, 0] - c) / (s[:, 0] - 1))) / 2 + jet.sum(1) / np.pi

    def residual(z):
        theta, c = np.concatenate([[-np.pi / 2], z[:-1], [0]]), 1 / (1 + np.exp(-z[-1]))
        v = np.exp(log_speed(theta, c, middle))
        rise = np.sin((theta[1:] + theta[:-1]) / 2) / v * np.diff(logs) / np.pi
        heights = 1 - np.cumsum(rise[::-1])[::-1]
        v0 = np.exp(log_speed(theta, c, np.array([1e-12])))[0]
        return np.append(v**2 / 2 + g * (heights + rise / 2), v0**2 / 2 + g / v0) - 0.5 - g, heights[0]

    z = np.append(-np.pi / 2 * np.exp(-1.5 * logs[1:-1]**0.5), -4)
    for _ in range(60):
        r, opening = residual(z)
        jacobian = np.array([(residual(z + d)[0] - r) / 1e-6 for d in 1e-6 * np.eye(len(z))]).T
        step = np.linalg.lstsq(jacobian, -r, rcond=None)[0]
        z += np.clip(step, -0.3, 0.3)
        if np.abs(step).max() < 1e-9:
            break
    return opening / (1 + 0.5 / g), 1 / opening


for f in (6, 4.5, 3.5, 3, 2.5, 2.18, 2):
    print("Froude number %.2f  a/E %.3f  Cc %.4f" % ((f,) + contraction(f)))
