"""Simulations: steps, what they tell, steering, bodies, probes, errors, signals."""
import math
import os
import pickle
import signal
import subprocess
import tempfile
import time
import unittest

import numpy as np

import common
from common import jet, raft, sph2d, tank


class Steps(unittest.TestCase):
    def test_time(self):
        sim = sph2d.Simulation(tank(), threads=1, isa="baseline")
        self.assertEqual((sim.time, sim.steps, sim.threads, sim.isa), (0, 0, 1, "baseline"))
        first = sim.time_step
        sim.step()
        self.assertEqual((sim.time, sim.steps), (first, 1))
        sim.run_to(0.1)
        self.assertTrue(0.1 <= sim.time < 0.1 + 2 * first)
        steps = sim.steps
        sim.run_to(0.05)
        sim.advance(0)
        self.assertEqual(sim.steps, steps)
        sim.advance(0.05)
        self.assertTrue(0.15 <= sim.time < 0.15 + 3 * first)
        for nonsense in (math.nan, math.inf):
            self.assertRaises(ValueError, sim.run_to, nonsense)
        self.assertRaises(TypeError, sim.run_to, "soon")
        self.assertRegex(repr(sim), r"'scene': 96 particles, t = 0\.1\d+ s")
        self.assertGreater(sim.memory, 96 * 8 * 10)
        self.assertEqual(sim.plan.fluid_particles, 96)
        self.assertAlmostEqual(sim.plan.particle_mass, 2.5)
        self.assertEqual(sim.scene.as_dict()["spacing"], 0.05)

    def test_options(self):
        for options in ({"threads": -1}, {"threads": 1025}, {"threads": 2 ** 40}, {"isa": "mmx"}, {"isa": None}):
            with self.assertRaises(ValueError):
                sph2d.Simulation(tank(), **options)
        with self.assertRaises(TypeError):
            sph2d.Simulation(tank(), threads=1.5)
        with self.assertRaises(TypeError):
            sph2d.Simulation(sph2d.Scene(tank()), {"spacing": 0.1})
        self.assertEqual(len(sph2d.Simulation(tank(), {"spacing": 0.1}).fluid), 24)

    def test_summary_has_every_field(self):
        sim = sph2d.Simulation(jet())
        sim.run_to(0.2)
        summary = sim.summary()
        with open(common.ROOT / "include/sph2d/sim.h") as file:
            text = file.read()
        struct = text[text.index("typedef struct sph2d_summary {"):text.index("} sph2d_summary;")]
        code = "".join(part.split("*/")[-1] for part in struct.split("/**"))
        names = [name.split("[")[0] for line in code.split("\n") if line.endswith(";")
                 for name in line.strip("; ").split(" ", 1)[1].split(", ")]
        self.assertEqual(list(summary._fields), names)
        self.assertEqual((summary.time, summary.steps, summary.particles), (sim.time, sim.steps, len(sim.fluid)))
        self.assertEqual(summary.fed, len(sim.fluid))
        self.assertEqual(summary.left_open, (0, 0, 0, 0))
        self.assertEqual(pickle.loads(pickle.dumps(summary)), summary)
        self.assertAlmostEqual(summary.kinetic, 1.25 * float(np.sum(sim.fluid.vx ** 2 + sim.fluid.vy ** 2)), 9)
        self.assertAlmostEqual(summary.momentum[1], 2.5 * sim.fluid.vy.sum(), 9)

    def test_densities(self):
        sim = sph2d.Simulation(tank(), {"spacing": 0.02})
        densities = sim.densities()
        self.assertTrue(0.95 < densities.reported < 1.05 and 0.9 < densities.counted < 1.1, densities)
        self.assertTrue(math.isnan(sph2d.Simulation(jet()).densities().reported))

    def test_sample(self):
        sim = sph2d.Simulation(tank(gravity=[0, 0]), {"blocks[0].velocity": [1, 2]})
        sample = sim.sample((0.2, 0.3))
        np.testing.assert_allclose(sample.velocity, (1, 2), rtol=1e-12)
        self.assertIsInstance(sample.pressure, float)
        self.assertAlmostEqual(sample.density, 1000, 0)
        grid = np.moveaxis(np.mgrid[0.1:0.3:3j, 0.1:0.5:5j], 0, -1)
        samples = sim.sample(grid)
        self.assertEqual((samples.velocity.shape, samples.pressure.shape), ((3, 5, 2), (3, 5)))
        np.testing.assert_allclose(samples.velocity[..., 1], 2, rtol=1e-12)
        self.assertTrue((samples.neighbours > 10).all())
        outside = sim.sample([(0.9, 0.7), (math.nan, 0), (math.inf, 1e300)])
        self.assertTrue(np.isnan(outside.velocity).all() and np.isnan(outside.density).all())
        self.assertEqual(sim.sample(np.empty((0, 2))).velocity.shape, (0, 2))
        for shape in ((3,), (2, 3), ()):
            self.assertRaises(ValueError, sim.sample, np.zeros(shape))

    def test_a_guard(self):
        sim = sph2d.Simulation(tank(method={"name": "muller", "time_step": 0.02, "sound_speed": 40}))
        with self.assertRaises(sph2d.Error) as caught:
            sim.run_to(5)
        self.assertEqual(caught.exception.status, "GUARD")
        self.assertRegex(caught.exception.diagnostics[0].code, "R30.")
        time, count = sim.time, len(sim.fluid)
        for _ in range(2):
            with self.assertRaises(sph2d.Error) as caught:
                sim.step()
            self.assertEqual(caught.exception.status, "GUARD")
        self.assertEqual((sim.time, len(sim.fluid)), (time, count))

    def test_closed(self):
        with sph2d.Simulation(tank()) as sim:
            sim.step()
        sim.close()
        self.assertEqual(repr(sim), "<sph2d.Simulation, closed>")
        for call in (sim.step, sim.summary, sim.densities, lambda: sim.fluid, lambda: sim.time, lambda: sim.plan,
                     lambda: sim.sample((0, 0)), lambda: sim.field("Masses"), lambda: sim.set_gravity((0, 0)),
                     lambda: sim.write_snapshot("/nowhere/x.h5"), lambda: sim.run_to(1)):
            with self.assertRaisesRegex(ValueError, "the simulation is closed"):
                call()

    def test_the_command_gives_the_same_bits(self):
        command = os.environ.get("SPH2D")
        if not command:
            self.skipTest("SPH2D does not name the command")
        scene = common.ROOT / "tests/cli/tiny.scene"
        changes = {"run.until": 0.05, "run.snapshots": {"every": 0.05}}
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([command, "run", scene, "-o", folder + "/out", "--no-frames", "--quiet",
                            "-s", "run.until=0.05", "-s", "run.snapshots={every: 0.05}"], check=True)
            theirs = sph2d.Snapshot(folder + "/out/snapshot_000001.h5")
        sim = sph2d.Simulation(scene, changes, threads=2)
        sim.run_to(0.05)
        self.assertEqual((sim.time, sim.steps), (theirs.info.time, theirs.info.steps))
        for name in sph2d.Particles.__slots__:
            np.testing.assert_array_equal(getattr(sim.fluid, name), getattr(theirs.fluid, name), name)


class Steering(unittest.TestCase):
    def test_gravity(self):
        sim = sph2d.Simulation(tank())
        sim.set_gravity((3, 0))
        sim.run_to(0.1)
        self.assertGreater(sim.fluid.vx.mean(), 0.1)
        for nonsense in ((math.nan, 0), (0, math.inf)):
            with self.assertRaises(sph2d.Error) as caught:
                sim.set_gravity(nonsense)
            self.assertEqual((caught.exception.status, str(caught.exception)), ("INVALID", "gravity must be finite"))
        for nonsense in (3, (1,), (1, 2, 3), "xy", None):
            self.assertRaises((TypeError, ValueError), sim.set_gravity, nonsense)

    def test_pointer(self):
        pulled, free = sph2d.Simulation(tank()), sph2d.Simulation(tank())
        for sim in (pulled, free):
            sim.run_to(0.05)
        pulled.set_pointer(np.array([0.6, 0.3]), radius=0.5, acceleration=50)
        for sim in (pulled, free):
            sim.run_to(0.15)
        self.assertGreater(pulled.fluid.x.mean(), free.fluid.x.mean() + 0.01)
        pulled.set_pointer((0, 0), 0, 0)
        for nonsense in ((math.nan, 0), 1, 1), ((0, 0), -1, 1), ((0, 0), 1, math.inf):
            with self.assertRaises(sph2d.Error) as caught:
                pulled.set_pointer(*nonsense)
            self.assertEqual(caught.exception.status, "INVALID")


class Editing(unittest.TestCase):
    def test_particles_come_and_go(self):
        sim = sph2d.Simulation(tank())
        points = np.array([(0.7, 0.5), (0.8, 0.5), (0.2, 0.2), (0.8, 0.505), (9, 9)])
        self.assertEqual(sim.add_particles(points, velocity=(1, -1)), 2)  # in the column, on another, outside: no room
        self.assertEqual((len(sim.fluid), sim.summary().fed), (98, 2))
        fresh = sim.fluid.x > 0.65
        np.testing.assert_array_equal(np.sort(sim.fluid.x[fresh]), (0.7, 0.8))
        np.testing.assert_array_equal(sim.fluid.vx[fresh], (1, 1))
        self.assertEqual(sim.add_particles([(0.6, 0.7), (0.9, 0.7)], [(0, 0), (0, 1)], [0, 1001]), 2)
        self.assertEqual(sorted(sim.fluid.density)[-1], 1001)
        self.assertEqual(sim.add_particles(np.empty((0, 2))), 0)
        sim.advance(0.01)
        self.assertEqual(sim.remove_particles({"disc": {"center": [0.75, 0.5], "radius": 0.12}}), 2)
        self.assertEqual(sim.remove_particles({"polygon": [(0.55, 0.6), (1, 0.6), (1, 0.8), (0.55, 0.8)]}), 2)
        self.assertEqual(sim.remove_particles({"box": {"min": (0, 0), "max": (0.5, 0.1)}}), 16)
        self.assertEqual((len(sim.fluid), sim.summary().drained), (80, 20))
        sim.step()

    def test_nonsense(self):
        sim = sph2d.Simulation(tank())
        for arguments in (([0.5, 0.5],), (np.zeros((2, 3)),), ([(0.7, 0.5)], (1, 2, 3)), ([(0.7, 0.5)], (0, 0), [1, 2]),
                          ("xy",)):
            with self.assertRaises(ValueError):
                sim.add_particles(*arguments)
        for arguments in (([(math.nan, 0.5)],), ([(0.7, 0.5)], (math.inf, 0)), ([(0.7, 0.5)], (0, 0), -1)):
            with self.assertRaises(sph2d.Error) as caught:
                sim.add_particles(*arguments)
            self.assertEqual(caught.exception.status, "INVALID")
        for shape in (None, {}, {"cone": 1}, {"box": {}}, {"box": {"min": 1, "max": 2}}, {"circle": {"center": [0, 0]}},
                      {"polygon": [1, 2, 3]}, {"none": None}, {"box": {}, "disc": {}}, {1: 2}):
            with self.assertRaises(ValueError):
                sim.remove_particles(shape)
        for shape in ({"circle": {"center": [0, 0], "radius": -1}}, {"box": {"min": [0, 0], "max": [math.nan, 1]}},
                      {"polygon": [[0, 0], [1, 0]]}):
            with self.assertRaises(sph2d.Error) as caught:
                sim.remove_particles(shape)
            self.assertEqual(caught.exception.status, "INVALID")
        self.assertEqual(len(sim.fluid), 96)


class Bodies(unittest.TestCase):
    def setUp(self):
        common.ignore_warnings(self)

    def test_a_body(self):
        sim = sph2d.Simulation(raft())
        start = sim.body("raft")
        np.testing.assert_allclose(start.center, (0.45, 0.55))
        self.assertEqual(sim.body(0), start)
        sim.set_body_velocity("raft", (0.5, 0), rate=1)
        self.assertEqual((sim.body("raft").velocity, sim.body(0).rate), ((0.5, 0), 1))
        sim.run_to(0.4)
        self.assertGreater(sim.body("raft").center[0], 0.5)
        self.assertGreater(sim.body("raft").force[1], 10)
        for nonsense in (-1, 1, 10 ** 30):
            self.assertRaises(IndexError, sim.body, nonsense)
        self.assertRaises(TypeError, sim.body, 0.5)
        with self.assertRaisesRegex(KeyError, "no name 'boat'; names: raft"):
            sim.set_body_velocity("boat", (0, 0))
        with self.assertRaises(sph2d.Error):
            sim.set_body_velocity(0, (math.nan, 0))

    def test_obstacles(self):
        sim = sph2d.Simulation(raft(obstacles=[{"name": "gate", "box": {"min": [0.8, 0.4], "max": [0.9, 0.5]},
                                                "motion": {"amplitude": [0.05, 0], "frequency": 1}}]))
        sim.run_to(0.2)
        velocity = 0.05 * 2 * math.pi * math.cos(2 * math.pi * sim.time)
        self.assertAlmostEqual(sim.obstacle("gate").velocity[0], velocity, 3)
        self.assertRaises(KeyError, sim.obstacle, "raft")

    def test_contacts(self):
        scene = {**raft(), "blocks": [{"box": {"min": [0.8, 0], "max": [1, 0.1]}}]}
        with_contacts, without = sph2d.Simulation(scene), sph2d.Simulation(scene, contacts=False)
        for sim in (with_contacts, without):
            sim.run_to(0.45)
        self.assertGreater(with_contacts.body(0).center[1], 0.049)
        self.assertLess(without.body(0).center[1], 0)


class Probes(unittest.TestCase):
    def test_probes(self):
        probes = [{"name": "all", "kind": "energy", "every": 1},
                  {"name": "gauge", "kind": "pressure", "at": [0.2, 0], "every": 1},
                  {"name": "dry", "kind": "speed", "at": [0.9, 0.7], "every": 1}]
        sim = sph2d.Simulation(tank(probes=probes))
        sim.run_to(0.05)
        energy = sim.probe("all")
        self.assertEqual(list(energy)[:2], ["kinetic [J/m]", "potential [J/m]"])
        self.assertAlmostEqual(energy["kinetic [J/m]"], sim.summary().kinetic, 6)
        self.assertEqual(list(sim.probe(1)), ["pressure [Pa]", "density [kg/m^3]", "neighbours"])
        self.assertTrue(1000 < sim.probe("gauge")["pressure [Pa]"] < 9000)
        self.assertTrue(all(math.isnan(sim.probe("dry")[name]) for name in ("vx [m/s]", "vy [m/s]")))
        self.assertRaises(KeyError, sim.probe, "none")
        self.assertRaises(IndexError, sim.probe, 3)


class Signals(unittest.TestCase):
    """A handler that raises at random moments, as that of Ctrl-C does: the step ends, and the simulation can go on."""

    def setUp(self):
        def handler(*_):
            raise TimeoutError

        self.addCleanup(signal.signal, signal.SIGALRM, signal.signal(signal.SIGALRM, handler))

    def interrupted(self, seconds, function, *arguments):
        """Calls a function, and whether a handler raised after some seconds, or as the timer was stopped."""
        try:
            try:
                signal.setitimer(signal.ITIMER_REAL, seconds)
                function(*arguments)
            finally:
                signal.setitimer(signal.ITIMER_REAL, 0)
        except TimeoutError:
            return True
        return False

    def test_steps(self):
        whole, parts, interrupts = sph2d.Simulation(jet()), sph2d.Simulation(jet()), 0
        whole.run_to(0.3)
        while parts.time < 0.3:
            interrupts += self.interrupted(0.002 + 0.001 * interrupts, parts.run_to, 0.3)
        self.assertGreater(interrupts, 0)
        self.assertEqual(parts.steps, whole.steps)
        np.testing.assert_array_equal(parts.fluid.x, whole.fluid.x)

    def test_creation(self):
        scene, raised = sph2d.Scene(tank(), {"spacing": 0.01}), 0
        start = time.perf_counter()
        sph2d.Simulation(scene).close()
        taken = time.perf_counter() - start
        for k in range(20):
            raised += self.interrupted(max(1e-6, taken * k / 20), lambda: sph2d.Simulation(scene).close())
        self.assertGreater(raised, 3)


if __name__ == "__main__":
    unittest.main()
