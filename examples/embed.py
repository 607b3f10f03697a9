#!/usr/bin/env python3
"""What embed.c does, in Python: python3 examples/embed.py, with the module installed (docs/python.md)"""
import sph2d

sim = sph2d.Simulation({"domain": {"min": [0, 0], "max": [1, 1]}, "spacing": 0.02,
                        "blocks": [{"box": {"min": [0, 0], "max": [0.4, 0.6]}}]})
sim.run_to(0.5)
fluid, summary = sim.fluid, sim.summary()
print(f"{len(fluid)} particles, front at {fluid.x.max():.3f} m, compression {100 * summary.compression_p99:.1f} %")
