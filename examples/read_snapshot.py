#!/usr/bin/env python3
"""Read a snapshot with h5py: python3 examples/read_snapshot.py out/snapshot_000042.h5"""
import sys

import h5py
import numpy as np

with h5py.File(sys.argv[1]) as file:
    fluid = file["PartType0"]
    position = fluid["Coordinates"][:, :2]
    speed = np.linalg.norm(fluid["Velocities"][:], axis=1)
    for name, data in fluid.items():
        print(f"{name:18} {data.shape} {data.attrs['Description']!r}")
    print(f"{len(position)} particles, front at {position[:, 0].max():.3f} m, fastest {speed.max():.3f} m/s")
