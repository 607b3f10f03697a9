"""Views of the library's arrays: no copies, nothing to write to, and never dangling; memory that comes back."""
import gc
import os
import resource
import subprocess
import sys
import unittest

import numpy as np

from common import jet, sph2d, tank


def memory_in_use():
    """Pages of the process [bytes]."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


def arrays_of(sim):
    for particles in (sim.fluid, sim.walls):
        for name in sph2d.Particles.__slots__:
            array = getattr(particles, name)
            if array is not None:
                yield name, array
    for name in ("Coordinates", "Velocities", "Masses", "ParticleIDs", "SmoothingLengths"):
        field = sim.field(name)
        for array in field if isinstance(field, tuple) else (field,):
            yield name, array


class Views(unittest.TestCase):
    def test_nothing_is_copied(self):
        sim = sph2d.Simulation(tank(fluid={"color": "teal"}))
        view = sph2d._CORE.sph2d_sim_fluid(sim._sim)
        for name in sph2d.Particles.__slots__:
            array = getattr(sim.fluid, name)
            address = sph2d._CORE.sph2d_sim_colors(sim._sim) if name == "color" else getattr(view, name)
            self.assertEqual(array.ctypes.data, address, name)
            self.assertEqual((array.shape, array.dtype), ((96,), np.uint64 if name in ("id", "color") else np.float64))
        self.assertTrue(np.shares_memory(sim.fluid.x, sim.field("Coordinates")[0]))
        self.assertTrue(np.shares_memory(sim.walls.y, sim.field("Coordinates", "wall")[1]))
        self.assertEqual(len(sim.fluid), 96)
        self.assertIsNone(sim.walls.ax)
        self.assertEqual(sorted(sim.fluid.id), list(range(96)))

    def test_fields(self):
        sim = sph2d.Simulation(tank())
        sim.step()
        np.testing.assert_array_equal(sim.field("Pressures"), sim.fluid.pressure)
        np.testing.assert_array_equal(sim.field("Accelerations")[1], sim.fluid.ay)
        np.testing.assert_array_equal(sim.field("Masses"), np.full(96, 2.5))
        np.testing.assert_allclose(sim.field("SmoothingLengths"), sim.plan.support_radius)
        self.assertEqual(sim.field("Masses", "wall").shape, (len(sim.walls),))
        for name, group in (("Pressure", "fluid"), ("Accelerations", "wall"), ("", "fluid")):
            with self.assertRaisesRegex(KeyError, "Coordinates, Velocities"):
                sim.field(name, group)
        self.assertRaises(ValueError, sim.field, "Masses", "air")
        x, y = sim.field("Coordinates", "outline")
        ids, sides = sim.field("OutlineIDs", "outline"), sim.field("LiquidSides", "outline")
        self.assertEqual({len(array) for array in (x, y, ids, sides)}, {len(x)})
        self.assertEqual((x.min(), x.max(), y.min(), ids.dtype), (0, 1, 0, np.uint64))
        self.assertFalse(x.flags.writeable)

    def test_read_only(self):
        sim = sph2d.Simulation(tank())
        for name, array in arrays_of(sim):
            with self.assertRaises(ValueError, msg=name):
                array[0] = 0
            with self.assertRaises(ValueError, msg=name):
                array.flags.writeable = True

    def test_none_and_empty(self):
        sim = sph2d.Simulation(jet())
        for name, array in arrays_of(sim):
            self.assertFalse(array.flags.writeable, name)
        self.assertEqual((len(sim.fluid), sim.fluid.x.shape, sim.field("Coordinates")[1].shape), (0, (0,), (0,)))
        self.assertEqual(sim.sample((0.5, 0.5)).neighbours, 0)

    def test_they_show_the_moment(self):
        sim = sph2d.Simulation(tank())
        by_id = [sim.fluid.x[np.argsort(sim.fluid.id)]]
        for _ in range(50):
            sim.step()
            by_id.append(sim.fluid.x[np.argsort(sim.fluid.id)])
        moved = np.abs(np.diff(by_id, axis=0)).max(axis=1)
        self.assertTrue((moved > 0).all() and moved.max() < 0.03, moved)

    def test_after_memory_has_grown(self):
        sim = sph2d.Simulation(jet())
        while len(sim.fluid) < 10:
            sim.step()
        old, memory = [array for _, array in arrays_of(sim) if len(array) == len(sim.fluid)], sim.memory
        while sim.memory < memory + 10000:
            sim.step()
        values = [array.copy() for array in old]  # what the simulation has freed does not change any more
        for name, array in arrays_of(sim):
            self.assertFalse(any(np.shares_memory(array, other) for other in old), name)
        for other in [sph2d.Simulation(jet()) for _ in range(20)] + [sim]:
            other.advance(0.05)
        for array, value in zip(old, values):
            np.testing.assert_array_equal(array, value)

    def test_after_close(self):
        sim = sph2d.Simulation(tank(fluid={"color": "teal"}))
        sim.run_to(0.05)
        views, field = sim.fluid, sim.field("Masses")
        copies = {name: getattr(views, name).copy() for name in sph2d.Particles.__slots__}
        sim.close()
        sim.close()
        others = [sph2d.Simulation(tank()) for _ in range(20)]
        for other in others:
            other.step()
        for name, copy in copies.items():
            np.testing.assert_array_equal(getattr(views, name), copy, name)
        np.testing.assert_array_equal(field, np.full(96, 2.5))

    def test_without_its_simulation(self):
        x = sph2d.Simulation(tank()).fluid.x
        gc.collect()
        others = [sph2d.Simulation(jet()) for _ in range(20)]
        self.assertEqual(len(others), 20)
        np.testing.assert_allclose(np.unique(np.round(x, 9)), np.arange(8) * 0.05 + 0.025)


@unittest.skipIf("libasan" in os.environ.get("LD_PRELOAD", ""), "sanitizers keep memory that is freed")
class Memory(unittest.TestCase):
    def cycle(self, count):
        for k in range(count):
            sim = sph2d.Simulation(self.scene, threads=1)
            sim.step()
            self.kept = sim.fluid.x, sim.summary()
            if k % 2:
                sim.close()

    def test_a_thousand_simulations(self):
        self.scene = sph2d.Scene(tank(spacing=0.1, method="muller"))
        gc.disable()  # counts of references alone free everything
        self.addCleanup(gc.enable)
        self.cycle(200)
        before = memory_in_use()
        self.cycle(1000)
        grown = memory_in_use() - before
        self.assertLess(grown, 4 << 20)  # a thousand of 100 kB

    def test_a_thousand_scenes_and_errors(self):
        def cycle(count):
            for _ in range(count):
                sph2d.Scene(tank())
                try:
                    sph2d.Scene(tank(spacing=-1))
                except sph2d.Error as error:
                    str(error)

        cycle(200)
        before = memory_in_use()
        cycle(1000)
        self.assertLess(memory_in_use() - before, 4 << 20)

    def test_no_memory(self):
        code = """
import resource
from common import sph2d, tank
scene = sph2d.Scene(tank(), {"spacing": 0.001})
sph2d.Simulation(tank()).step()
with open("/proc/self/statm") as file:
    used = int(file.read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + (20 << 20), resource.RLIM_INFINITY))
try:
    sph2d.Simulation(scene)
except sph2d.Error as error:
    print(error.status, error)
resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
sph2d.Simulation(tank()).step()
"""
        run = subprocess.run([sys.executable, "-W", "ignore", "-c", code], capture_output=True, text=True,
                             env={**os.environ, "PYTHONPATH": os.path.dirname(__file__)})
        self.assertRegex(run.stdout, "(?s)^NOMEM .*error.*out of memory while making the simulation\n$")
        self.assertEqual((run.returncode, run.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
