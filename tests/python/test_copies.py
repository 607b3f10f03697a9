"""Copies of what owns memory of the library: independent, or refused by a sentence; never a second owner of it."""
import copy
import gc
import inspect
import pickle
import unittest

import numpy as np

import common
from common import raft, sph2d, tank

WAYS = {"copy": copy.copy, "deepcopy": copy.deepcopy, "pickle": lambda thing: pickle.loads(pickle.dumps(thing))}


def owners():
    """Name to a class of each one that owns something, as its source says, itself or by another."""
    classes = {name: kind for name, kind in vars(sph2d).items() if inspect.isclass(kind) and kind.__module__ == "sph2d"}
    return {name for name, kind in classes.items() if issubclass(kind, sph2d._Owner)}, {
        name for name, kind in classes.items() if not issubclass(kind, tuple)
        and any(mark in inspect.getsource(kind) for mark in ("_own(", "__del__", "_SnapshotMemory(made", "_destroy"))}


def addresses(thing):
    """What an object has of the library."""
    names = ("_sim", "_file", "_renderer", "address")
    return {getattr(thing, name) for name in names if hasattr(thing, name)} | (
        addresses(thing._memory) if hasattr(thing, "_memory") else set())


def as_one(sim):
    """What a simulation is: its bits."""
    arrays = (getattr(sim.fluid, name) for name in sph2d.Particles.__slots__)
    return [None if array is None else array.tobytes() for array in arrays] + [sim.summary(), sim.time_step]


def often():
    """A tank with a probe that is due more often than there are steps."""
    return {**tank(), "probes": [{"name": "often", "kind": "energy", "every": 1e-5}]}


class Labelled(sph2d.Simulation):
    """A class of a program."""


class Copies(common.InFolder):
    def setUp(self):
        super().setUp()
        common.ignore_warnings(self)

    def test_copies_take_no_row_twice(self):
        sim = sph2d.Simulation(often(), threads=1)
        for _ in range(3):
            sim.step()
        sim.write_snapshot("a.h5")
        others = [function(sim) for function in WAYS.values()] + [sph2d.Snapshot("a.h5").resume()]
        for other in (sim, *others):
            other.step()
            other.write_snapshot("b.h5")
            counts = sph2d.Snapshot("b.h5").field("OutputCounts", "run")
            self.assertEqual(counts.tolist(), [0, 0, 5])
        self.assertEqual([len(other.series("often")["time [s]"]) for other in (sim, *others)], [5, 5, 5, 5, 1])

    def test_copies_after_a_cut_go_on_the_same(self):
        sim = sph2d.Simulation({**tank(), "method": "muller"}, threads=1)
        sim.remove_particles({"box": {"min": [0, 0], "max": [0.1, 1]}})
        sim.write_snapshot("a.h5")
        others = [function(sim) for function in WAYS.values()] + [sph2d.Snapshot("a.h5").resume(threads=1)]
        for other in (sim, *others):
            for _ in range(10):
                other.step()
            self.assertEqual(as_one(other), as_one(sim))

    def test_walls_without_particles(self):
        scene = {**tank(), "method": "muller"}
        self.assertEqual(len(sph2d.Simulation(scene, threads=1).walls), 0)

    def make(self, name):
        sim = sph2d.Simulation(tank(), threads=1)
        sim.write_snapshot("a.h5")
        snapshot = sph2d.Snapshot("a.h5")
        return {"Simulation": lambda: sim, "Scene": lambda: sim.scene, "Snapshot": lambda: snapshot,
                "_SnapshotMemory": lambda: snapshot._memory, "_Block": lambda: sim.fluid.x.base.owner,
                "Renderer": lambda: sph2d.Renderer(64, 64)}[name]()

    def use(self, thing):
        """Calls of what a copy may be, which read the library's memory."""
        if isinstance(thing, sph2d.Scene):
            return thing.plan().fluid_particles, thing.text, len(thing.as_dict())
        if isinstance(thing, sph2d.Snapshot):
            return thing.info, thing.fluid.x.sum(), thing.scene().text
        return as_one(thing)

    def test_every_owner(self):
        declared, found = owners()
        self.assertEqual(declared - {"_Owner", "_Unchanging"}, found)
        for name in sorted(found):
            if name == "Renderer" and not common.CAN_DRAW:
                continue
            for way, function in WAYS.items():
                with self.subTest(name, way=way):
                    thing = self.make(name)
                    before, what = addresses(thing), self.use(thing) if name[0] == "S" else None
                    self.assertTrue(before)
                    try:
                        other = function(thing)
                    except TypeError as error:
                        self.assertRegex(str(error), r"^(a|the) .* cannot be (copied|pickled).*: (make|pickle|copy\()")
                        self.assertFalse(isinstance(thing, sph2d.Simulation))
                        continue
                    self.assertTrue(other is thing or not before & addresses(other))
                    self.assertEqual(self.use(other), what)
                    del thing
                    gc.collect()
                    again = [self.make(name) for _ in range(5)]  # takes the memory that the first has freed
                    self.assertEqual(self.use(other), what)
                    self.assertEqual(len(again), 5)

    def test_a_simulation_and_its_copy(self):
        for scene in (tank(), raft(), tank(blocks=[], sources=[{"at": [0.5, 0.7], "speed": 3, "width": 0.3}])):
            for way, function in WAYS.items():
                with self.subTest(way):
                    sim = sph2d.Simulation(scene, threads=1)
                    sim.run_to(0.05)
                    other, before = function(sim), as_one(sim)
                    self.assertEqual((other.threads, other.isa, as_one(other)), (1, sim.isa, before))
                    sim.advance(0.05)
                    self.assertEqual(as_one(other), before)
                    third, ended = function(other), as_one(sim)
                    sim.close()
                    with self.assertRaisesRegex(ValueError, "the simulation is closed"):
                        function(sim)
                    for copied in (other, third):
                        while copied.time < ended[-2].time:
                            copied.step()
                        self.assertEqual(as_one(copied), ended)

    def test_options_and_classes_are_kept(self):
        scene = {**raft(), "blocks": [{"box": {"min": [0.8, 0], "max": [1, 0.1]}}]}
        for way, function in WAYS.items():
            sim = Labelled(scene, threads=1, contacts=False)
            other = function(sim)
            self.assertIs(type(other), Labelled)
            other.run_to(0.45)
            self.assertLess(other.body(0).center[1], 0, way)  # through the floor
        sim.label = "first"
        self.assertEqual((copy.copy(sim).label, copy.deepcopy(sim).label), ("first", "first"))

    def test_values(self):
        """What is handed out of the library is copied like other values."""
        sim = sph2d.Simulation(raft())
        for value in (sim.summary(), sim.plan, sim.body(0), sim.densities(), sim.sample([(0.2, 0.1)])):
            for function in WAYS.values():
                np.testing.assert_equal(tuple(function(value)), tuple(value))
        fluid = sim.fluid
        others = [function(fluid) for function in WAYS.values()] + [WAYS["deepcopy"](fluid.x), WAYS["pickle"](fluid.x)]
        sim.close()
        for other in others:
            np.testing.assert_array_equal(getattr(other, "x", other), fluid.x)
        self.assertFalse(np.shares_memory(others[1].x, fluid.x))


if __name__ == "__main__":
    unittest.main()
