"""Simulations on a device: the same numbers as by the processor, copies, what is refused."""
import copy
import pickle
import unittest

import numpy as np

import common
from common import raft, sph2d, tank

NUMBER = next((k for k, device in enumerate(sph2d.devices(), 1) if device.same_bits and not device.lacks), 0)


@unittest.skipUnless(NUMBER, "no device with OpenCL (Debian: pocl-opencl-icd)")
class Devices(common.InFolder):
    def setUp(self):
        super().setUp()
        common.ignore_warnings(self)
        self.scene = tank(method="muller", probes=[{"name": "energy", "kind": "energy", "every": 0.01}])

    def test_the_same_bits(self):
        there, here = (sph2d.Simulation(self.scene, device=NUMBER, same_bits=True),
                       sph2d.Simulation(self.scene, isa="baseline"))
        self.assertEqual((there.isa, here.device_memory), ("baseline", 0))
        for sim in (there, here):
            sim.run_to(0.05)
            sim.set_gravity((1, -3))
            sim.add_particles([(0.7, 0.6), (0.75, 0.6)], (0, -1))
            sim.run_to(0.1)
        self.assertGreater(there.device_memory, 0)
        self.assertEqual(len(there.fluid), 98)
        for name in ("x", "y", "vx", "vy", "density", "pressure", "id"):
            np.testing.assert_array_equal(getattr(there.fluid, name), getattr(here.fluid, name), name)
        self.assertEqual(repr(there.summary()), repr(here.summary()))
        self.assertEqual(repr(there.series("energy")), repr(here.series("energy")))

    def test_copies_and_snapshots_go_on_there_and_here(self):
        sim = sph2d.Simulation(self.scene, device=NUMBER)
        sim.run_to(0.03)
        sim.write_snapshot("a.h5")
        others = [copy.copy(sim), pickle.loads(pickle.dumps(sim)), sph2d.Snapshot("a.h5").resume(),
                  sph2d.Snapshot("a.h5").resume(device=NUMBER)]
        sim.run_to(0.06)
        for other, there in zip(others, (True, True, False, True)):
            other.run_to(0.06)
            self.assertEqual(other.device_memory > 0, there)
            np.testing.assert_array_equal(other.fluid.x, sim.fluid.x)

    def test_what_is_refused(self):
        for scene, options, status in ((raft(method="muller"), {}, "SCENE"), (tank(method="pcisph"), {}, "SCENE"),
                                       (self.scene, {"device": 900}, "INVALID"),
                                       (self.scene, {"isa": "avx2"}, "INVALID")):
            with self.assertRaises(sph2d.Error) as caught:
                sph2d.Simulation(scene, **{"device": NUMBER, **options})
            self.assertEqual(caught.exception.status, status)
            self.assertRegex(str(caught.exception), "device")

    def test_views_of_before_hold(self):
        sim = sph2d.Simulation(self.scene, device=NUMBER)
        sim.step()
        x = sim.fluid.x
        sim.close()
        self.assertEqual(len(x), 96)
        self.assertTrue(np.isfinite(x).all())


class Numbers(unittest.TestCase):
    def test_nonsense(self):
        for number, error in ((-1, ValueError), (1001, ValueError), (0.5, TypeError), ("gpu", TypeError), (None, TypeError)):
            with self.assertRaisesRegex(error, "device"):
                sph2d.Simulation(tank(), device=number)


if __name__ == "__main__":
    unittest.main()
