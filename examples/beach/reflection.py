#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reflection coefficients from three gauges: python3 reflection.py FOLDER [FOLDER...], folders of runs or of a study.

The incident and the reflected wave, by least squares over the gauges (Goda & Suzuki 1976 with two; Mansard & Funke 1980
with three): with the complex amplitudes A_m of the wave maker's frequency at the gauges x_m, over whole periods, and
the wave number k of linear theory,

    A_m = I exp(-i k x_m) + R exp(i k x_m)

|R|/|I| is printed beside 0.1 xi^2, xi = tan(beta)/sqrt(H/L0), of waves that break (Battjes 1974, Surf similarity), with
H = 2 |I| and L0 = g T^2/(2 pi). Needs numpy.
"""
import glob
import os
import sys

import numpy as np

DEPTH, PERIOD, FROM, PERIODS, GRAVITY = 0.2, 0.8, 8.8, 4, 9.81
GAUGES = {"one": 0.7, "two": 0.8, "three": 0.925}


def wave_number(omega):
    k = omega ** 2 / GRAVITY
    for _ in range(200):
        k = (k + omega ** 2 / GRAVITY / np.tanh(k * DEPTH)) / 2
    return k


def separate(series):
    """Amplitudes of the incident and the reflected wave, and what they leave of the gauges' amplitudes."""
    omega, amplitudes = 2 * np.pi / PERIOD, []
    for name in GAUGES:
        t, eta = series[name]
        inside = (t >= FROM) & (t < FROM + PERIODS * PERIOD)
        t, eta = t[inside], eta[inside]
        basis = [np.ones_like(t)] + [f(m * omega * t) for m in range(1, 6) for f in (np.cos, np.sin)]
        fit = np.linalg.lstsq(np.array(basis).T, eta, rcond=None)[0]
        amplitudes.append(fit[1] - 1j * fit[2])
    x, amplitudes, k = np.array(list(GAUGES.values())), np.array(amplitudes), wave_number(omega)
    matrix = np.array([np.exp(-1j * k * x), np.exp(1j * k * x)]).T
    waves = np.linalg.lstsq(matrix, amplitudes, rcond=None)[0]
    return abs(waves[0]), abs(waves[1]), np.sqrt(np.mean(abs(matrix @ waves - amplitudes) ** 2))


def read(path):
    return np.genfromtxt(path, delimiter=",", skip_header=1, usecols=(0, 1)).T


if __name__ == "__main__":
    print(f"wave length by linear theory {2 * np.pi / wave_number(2 * np.pi / PERIOD):.4f} m")
    for folder in sys.argv[1:]:
        for first in sorted(glob.glob(os.path.join(folder, "*one.csv"))):
            stem = first[:-len("one.csv")]
            incident, reflected, left = separate({name: read(stem + name + ".csv") for name in GAUGES})
            steepness = 2 * incident / (GRAVITY * PERIOD ** 2 / 2 / np.pi)
            print(f"{stem}: incident height {2 * incident:.4f} m, reflected {reflected / incident:.3f} of it, "
                  f"left over {left / incident:.3f}; "
                  f"waves that break: 1:8 {0.1 / 64 / steepness:.3f}, 1:3 {0.1 / 9 / steepness:.3f}")
