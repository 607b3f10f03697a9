"""Snapshots: written whole, read without copies, resumed bit for bit, refused where they are damaged."""
import gc
import os
import signal
import subprocess
import sys
import time
import unittest

import numpy as np

import common
from common import raft, sph2d, tank


class Snapshots(common.InFolder):
    def setUp(self):
        super().setUp()
        common.ignore_warnings(self)
        self.sim = sph2d.Simulation(raft(), {"fluid.dynamic_viscosity": 2})
        self.sim.run_to(0.1)

    def refused(self, status, path, *arguments):
        with self.assertRaises(sph2d.Error) as caught:
            sph2d.Snapshot(path, *arguments)
        self.assertEqual(caught.exception.status, status)
        return str(caught.exception)

    def test_what_is_in_it(self):
        self.sim.write_snapshot("a ü.h5")
        self.sim.write_snapshot("b.h5", compress=9)
        self.assertNotEqual(os.path.getsize("b.h5"), os.path.getsize("a ü.h5"))
        for path in ("a ü.h5", "b.h5"):
            snapshot = sph2d.Snapshot(path)
            info = snapshot.info
            self.assertEqual((info.time, info.steps, info.method), (self.sim.time, self.sim.steps, "wcsph"))
            self.assertEqual((info.domain, info.boundary.left, info.boundary.top), (((0, 0), (1, 0.8)), "wall", "open"))
            self.assertEqual((info.spacing, info.scene_name, info.code_version), (0.05, "scene", sph2d.__version__))
            for name in sph2d.Particles.__slots__:
                np.testing.assert_array_equal(getattr(snapshot.fluid, name), getattr(self.sim.fluid, name), name)
            np.testing.assert_array_equal(snapshot.walls.x, self.sim.walls.x)
            self.assertIsNone(snapshot.walls.ax)
            self.assertEqual(snapshot.field("Time", "run")[0], self.sim.time)
            np.testing.assert_array_equal(snapshot.field("Masses"), self.sim.field("Masses"))
            self.assertEqual(snapshot.scene().as_dict()["fluid"]["dynamic_viscosity"], 2)
            self.assertEqual(snapshot.scene({"run.until": 7}).as_dict()["run"]["until"], 7)
        for name, group in (("Nothing", "fluid"), ("Time", "wall"), ("Masses", "run")):
            with self.assertRaises(KeyError):
                snapshot.field(name, group)
        with self.assertRaisesRegex(KeyError, "Coordinates, "):
            snapshot.field("Nothing")
        with self.assertRaises(ValueError):
            snapshot.field("Masses", "air")

    def test_arrays_live_on(self):
        self.sim.write_snapshot("a.h5")
        snapshot = sph2d.Snapshot("a.h5")
        x = snapshot.fluid.x
        self.assertTrue(np.shares_memory(x, snapshot.field("Coordinates")[0]))
        with self.assertRaises(ValueError):
            x.flags.writeable = True
        del snapshot
        gc.collect()
        others = [sph2d.Snapshot("a.h5") for _ in range(20)]
        np.testing.assert_array_equal(x, self.sim.fluid.x)
        self.assertEqual(len(others), 20)

    def test_it_goes_on(self):
        self.sim.write_snapshot("a.h5")
        resumed = [sph2d.Snapshot("a.h5").resume(threads=threads) for threads in (1, 2)]
        for sim in [self.sim, *resumed]:
            for _ in range(50):
                sim.step()
        for sim in resumed:
            self.assertEqual(sim.summary(), self.sim.summary())
            self.assertEqual(sim.body("raft"), self.sim.body("raft"))
            np.testing.assert_array_equal(sim.fluid.x, self.sim.fluid.x)
        resumed[0].write_snapshot("b.h5")
        self.sim.write_snapshot("c.h5")
        with open("b.h5", "rb") as one, open("c.h5", "rb") as other:
            self.assertEqual(one.read(), other.read())

    def test_damaged(self):
        self.sim.write_snapshot("a.h5")
        with open("a.h5", "rb") as file:
            whole = file.read()
        for name, content in (("empty.h5", b""), ("text.h5", b"no snapshot\n" * 100),
                              ("half.h5", whole[:len(whole) // 2])):
            with open(name, "wb") as file:
                file.write(content)
            self.assertIn(name, self.refused("FORMAT", name))
        with open("bit.h5", "wb") as file:
            file.write(whole[:5000] + bytes([whole[5000] ^ 1]) + whole[5001:])
        self.assertIn("checksum", self.refused("FORMAT", "bit.h5"))
        with open("bare.h5", "wb") as file:
            file.write(whole[:-16])
        self.refused("FORMAT", "bare.h5")
        self.refused("NOINPUT", "missing.h5")
        self.refused("NOINPUT", ".")

    def test_where_it_cannot_be_written(self):
        for path, status in (("missing/a.h5", "CANTCREAT"), (".", "CANTCREAT"), ("/dev/full/a.h5", "CANTCREAT")):
            with self.assertRaises(sph2d.Error) as caught:
                self.sim.write_snapshot(path)
            self.assertEqual(caught.exception.status, status)
        for level in (-1, 10, 2 ** 32):
            with self.assertRaises(ValueError):
                self.sim.write_snapshot("a.h5", level)
        with self.assertRaises(ValueError):
            self.sim.write_snapshot("a\0.h5")
        self.assertEqual(os.listdir(), [])

    def test_killed(self):
        code = """
from common import sph2d, tank
sim = sph2d.Simulation(tank())
sim.write_snapshot("a.h5")
print(flush=True)
while True:
    sim.step()
    sim.write_snapshot("a.h5")
"""
        env = {**os.environ, "PYTHONPATH": os.path.dirname(__file__)}
        for k in range(5):
            with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, env=env) as process:
                process.stdout.readline()
                time.sleep(0.02 * k)
                process.send_signal(signal.SIGKILL)
            sph2d.Snapshot("a.h5").resume().step()


class WithoutAScene(common.InFolder):
    def test_the_scene_is_told_to_be_missing(self):
        sim = sph2d.Simulation(tank())  # as of a program in C that makes its scene of structs
        self.assertEqual(sph2d._IO.sph2d_snapshot_write(sim._sim, None, 0, b"a.h5", None), 0)
        snapshot = sph2d.Snapshot("a.h5")
        self.assertEqual(len(snapshot.fluid), 96)
        for call in (snapshot.scene, snapshot.resume):
            with self.assertRaises(sph2d.Error) as caught:
                call()
            self.assertEqual(caught.exception.status, "FORMAT")


if __name__ == "__main__":
    unittest.main()
