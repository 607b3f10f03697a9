"""Whatever is handed to the module is taken, or refused by a sentence of the module's own that names it."""
import datetime
import decimal
import enum
import fractions
import inspect
import linecache
import math
import pathlib
import re
import traceback
import unittest

import numpy as np

import common
from common import raft, sph2d, tank


class Unshowable:
    def __repr__(self):
        raise ValueError


class Pathless:
    def __fspath__(self):
        return 3


class One(enum.IntEnum):
    ONE = 1


def within_itself():
    made = []
    made.append(made)
    return made


# What no parameter takes: functions that make it.
NONSENSE = {
    "object": object, "class": lambda: dict, "function": lambda: max, "ellipsis": lambda: ..., "exception": ValueError,
    "unshowable": Unshowable, "pathless": Pathless, "date": lambda: datetime.date(2026, 1, 1),
    "bytes": lambda: bytearray(b"123"), "view": lambda: memoryview(b"123"),
    "complex": lambda: 1j, "complex of NumPy": lambda: np.complex64(1), "complexes": lambda: np.array([1j, 2]),
    "set": lambda: {1, 2}, "set of points": lambda: {(0, 0), (1, 1)}, "items": {1: 2}.items,
    "ragged": lambda: [[1, 2], [3]], "within itself": within_itself, "deep": lambda: [[[[[[1]]]]]],
    "texts": lambda: ["1", "2"], "texts of NumPy": lambda: np.array(["1", "2"]), "none inside": lambda: [None, 1],
    "objects": lambda: np.array([None, object()]), "dicts": lambda: [{}, {}],
    "time of NumPy": lambda: np.datetime64(1, "ns"), "span of NumPy": lambda: np.timedelta64(1, "ns"),
    "times": lambda: np.array([1, 2], "M8[ns]"), "records": lambda: np.zeros(2, [("x", float), ("y", float)]),
    "signalling": lambda: decimal.Decimal("sNaN"), "raw": lambda: np.void(b"12"), "cube": lambda: np.zeros((3, 3, 3)),
    "three": lambda: [0.5, 0.5, 0.5], "range": lambda: range(3), "generator": lambda: (k for k in (1, 2, 3)),
}
# What some take, and others refuse in the same way.
OTHERS = {
    "none": lambda: None, "text": lambda: "soon", "empty text": str, "digits": lambda: "1.5", "name": lambda: b"1",
    "zero byte": lambda: "a\0b", "surrogate": lambda: "\ud800", "long": lambda: "x" * 100000,
    "path": lambda: pathlib.Path("missing/a"), "nan": lambda: math.nan, "inf": lambda: math.inf,
    "huge": lambda: 10 ** 400, "endless": lambda: -10 ** 5000, "huge fraction": lambda: fractions.Fraction(10 ** 400),
    "negative": lambda: -7, "half": lambda: 0.5, "true": lambda: True, "tiny": lambda: np.longdouble("1e-4000"),
    "empty": list, "empty array": lambda: np.array([]), "one": lambda: [0.5], "row": lambda: [0.5, 0.5],
    "object array": lambda: np.array(None), "empty dict": dict, "dict": lambda: {"a": 1},
    "keys that are no text": lambda: {1: 2, None: 3, (1, 2): 4},
}
SOME_NUMBERS = {"nan", "inf", "huge", "endless", "huge fraction", "negative", "half", "true", "tiny"}
SOME_TEXTS = {"text", "empty text", "digits", "long", "surrogate"}
SOME_DICTS = {"empty dict", "dict", "keys that are no text"}
# Kind of parameter to what it may take of OTHERS.
MAY_TAKE = {
    "number": SOME_NUMBERS, "optional": SOME_NUMBERS | {"none"}, "pair": {"row"}, "flag": {"true"}, "word": set(),
    "points": {"row", "empty", "empty array"}, "view": {"none"}, "each": {"none"}, "which": {"true", "tiny"},
    "whole": {"true", "tiny"}, "text": SOME_TEXTS | {"none"}, "path": SOME_TEXTS | {"path", "name"} | SOME_DICTS,
    "changes": SOME_DICTS | {"none"},
    "source": set(), "shape": set(), "word or none": {"none"},
}
NUMBERS = [lambda kind=kind: kind(1) for kind in (
    int, float, bool, np.float32, np.float16, np.longdouble, np.int8, np.uint64, np.bool_, decimal.Decimal, np.array,
    fractions.Fraction, One, lambda one: np.array(decimal.Decimal(one)), lambda one: np.array(one, ">f4"))]
PAIRS = [lambda make=make: make([1, 2]) for make in (
    list, tuple, np.array, np.float32, iter, lambda pair: (k for k in pair), lambda pair: map(fractions.Fraction, pair),
    lambda pair: range(1, 3), lambda pair: [decimal.Decimal(1), np.float32(2)], lambda pair: {"a": 1, "b": 2}.values(),
    lambda pair: np.array([1, 9, 2])[::2], lambda pair: np.array([pair, pair], order="F")[0],
    lambda pair: np.array(pair, ">f4"), lambda pair: np.array(pair, object), lambda pair: [np.array(1), One.ONE + 1])]


def said_by_the_module(error):
    """Whether the sentence is the module's own: an Error, or raised by a line of it, not in ctypes or NumPy."""
    last = traceback.extract_tb(error.__traceback__)[-1]
    return isinstance(error, sph2d.Error) or last.filename == sph2d.__file__ and (
        linecache.getline(last.filename, last.lineno).strip().startswith("raise "))


class Nonsense(common.InFolder):
    def setUp(self):
        super().setUp()
        common.ignore_warnings(self)
        self.sim = sph2d.Simulation(raft(probes=[{"name": "all", "kind": "energy", "every": 1}],
                                         obstacles=[{"circle": {"center": [0.9, 0.5], "radius": 0.05}}]), threads=1)
        self.coarse = sph2d.Simulation(tank(), {"spacing": 0.2}, threads=1)  # for times
        self.sim.write_snapshot("state.h5")
        self.snapshot = sph2d.Snapshot("state.h5")

    def calls(self):
        """(kind of parameter, what its sentence names, what gives it a value)."""
        sim, snapshot = self.sim, self.snapshot
        yield from (("number", "time", self.coarse.run_to), ("number", "duration", self.coarse.advance),
                    ("number", "pointer|radius", lambda v: sim.set_pointer((0, 0), v, 0)),
                    ("number", "pointer|acceleration", lambda v: sim.set_pointer((0, 0), 1, v)),
                    ("number", "rate", lambda v: sim.set_body_velocity(0, (0, 0), v)),
                    ("number", "density|densities", lambda v: sim.add_particles([(9, 9)] * 4, (0, 0), v)))
        yield from (("pair", "gravity", sim.set_gravity), ("pair", "at", lambda v: sim.set_pointer(v, 1, 0)),
                    ("pair", "velocity", lambda v: sim.set_body_velocity("raft", v)),
                    ("pair", "velocity", lambda v: sim.add_particles([(9, 9)], v)),
                    ("points", "points", sim.sample), ("points", "points", sim.add_particles))
        for member, kind, shape in (
                ("", "shape", lambda v: v), (".box", "shape", lambda v: {"box": v}),
                (".circle", "shape", lambda v: {"circle": v}), (".polygon", "points", lambda v: {"polygon": v}),
                (".box.max", "pair", lambda v: {"box": {"min": [0.9, 1], "max": v}}),
                (".circle.center", "pair", lambda v: {"circle": {"center": v, "radius": 0.01}}),
                (".circle.radius", "number", lambda v: {"circle": {"center": [9, 9], "radius": v}})):
            yield kind, f"shape{member}|a shape", lambda v, shape=shape: sim.remove_particles(shape(v))
        yield from (("flag", "contacts", lambda v: sph2d.Simulation(tank(), contacts=v)),
                    ("flag", "contacts", lambda v: snapshot.resume(contacts=v)),
                    ("flag", "same_bits", lambda v: sph2d.Simulation(tank(), same_bits=v)),
                    ("flag", "same_bits", lambda v: snapshot.resume(same_bits=v)),
                    ("flag", "checked", lambda v: sph2d.Snapshot("state.h5", v)),
                    ("whole", "threads", lambda v: sph2d.Simulation(tank(), threads=v)),
                    ("whole", "threads", lambda v: snapshot.resume(threads=v)),
                    ("whole", "device", lambda v: sph2d.Simulation(tank(), device=v)),
                    ("whole", "device", lambda v: snapshot.resume(device=v)),
                    ("whole", "compress", lambda v: sim.write_snapshot("a.h5", v)),
                    ("word", "isa", lambda v: sph2d.Simulation(tank(), isa=v)),
                    ("word", "Masses", sim.field), ("word", "Masses", snapshot.field),
                    ("word", "group", lambda v: sim.field("Masses", v)), ("word", "group", snapshot.names),
                    ("word", "group", lambda v: snapshot.field("Masses", v)))
        for what, function in (("bodies", sim.body), ("obstacles", sim.obstacle), ("probes", sim.probe),
                               ("probes", sim.series), ("probes", sim.frame),
                               ("bodies", lambda v: sim.set_body_velocity(v, (0, 0)))):
            yield "which", f"which|{what}", function
        yield from (("path", "path|cannot", sph2d.Snapshot), ("path", "path|cannot", sim.write_snapshot),
                    ("path", "source|cannot|domain|text", sph2d.Scene),
                    ("path", "source|cannot|domain|text", sph2d.Simulation),
                    ("changes", "set", lambda v: sph2d.Scene(tank(), v)), ("changes", "set", snapshot.scene),
                    ("changes", "set", lambda v: sph2d.Simulation(sim.scene, v)), ("source", "source", sph2d.vorticity),
                    ("word or none", "color", lambda v: v is None or sim.plot(v)),
                    ("word or none", "axes", lambda v: v is None or snapshot.plot(axes=v)))
        if common.CAN_DRAW:
            yield from self.drawings()

    def drawings(self):
        renderer, kinds = sph2d.Renderer(32, 32), {
            "flag": ["arrows", "diverging", "streamlines"], "pair": ["value_range"], "view": ["view"],
            "each": ["values", "levels"], "text": ["label", "caption", "notes", "level_label"],
            "number": ["level_step", "streamline_spacing", "arrow_spacing", "arrow_speed"],
            "optional": ["radius"], "source": ["source"]}
        self.assertEqual(sorted(sum(kinds.values(), [])), sorted(inspect.signature(renderer.draw).parameters))
        for kind, names in kinds.items():
            for name in names:
                yield kind, name, lambda v, name=name: renderer.draw(**{"source": self.sim, name: v})
        size = {"width": 32, "height": 32}
        for kind, name in (("whole", "width"), ("whole", "height"), ("word", "style"), ("word", "look"),
                           ("word", "background")):
            yield kind, name, lambda v, name=name: sph2d.Renderer(**{**size, name: v})
        yield "text", "gl|OpenGL", lambda v: sph2d.Renderer(**size, gl=v)
        yield "path", "path|cannot", renderer.write_png

    @unittest.skipUnless(common.CAN_DRAW, "without libsph2d-render")
    def test_no_parameter_is_left_out(self):
        tried = "|".join(names for _, names, _ in self.calls())
        for kind in (sph2d.Scene, sph2d.Simulation, sph2d.Snapshot, sph2d.Renderer):
            members = {name: getattr(kind, name) for name in dir(kind) if name[0] != "_"}
            functions = {kind.__name__: kind, **members}
            for name, function in {**functions, "vorticity": sph2d.vorticity}.items():
                for parameter in inspect.signature(function).parameters if callable(function) else ():
                    if (parameter, name) != ("name", "field"):  # whose sentence has the names that there are
                        self.assertIn(parameter, tried + "|self|options", name)

    def test_it_is_refused_by_a_sentence(self):
        for kind, names, call in self.calls():
            for what, make in {**NONSENSE, **OTHERS}.items():
                with self.subTest(kind=kind, names=names, what=what):
                    try:
                        call(make())
                    except Exception as error:
                        self.assertTrue(said_by_the_module(error), repr(error)[:500])
                        self.assertRegex(str(error), names)
                        self.assertLess(len(str(error)), 2000 if what != "long" else 500000)
                    else:
                        self.assertIn(what, MAY_TAKE[kind])

    def test_what_is_natural_is_taken(self):
        sim = self.sim
        for make in NUMBERS:
            with self.subTest(repr(make())):
                for kind, _, call in self.calls():
                    if kind in ("number", "optional"):
                        call(make())
                sim.set_body_velocity(0, (0, 0), make())
                self.assertEqual(sim.body(0).rate, 1)
                self.assertEqual(sph2d.Simulation(tank(), threads=make()).threads, 1)
                if not isinstance(make(), (bool, np.bool_)):  # which are on and off
                    self.assertEqual(sph2d.Scene(tank(), {"fluid.density": make()}).as_dict()["fluid"]["density"], 1)
        for make in PAIRS:
            with self.subTest(repr(make())):
                for kind, _, call in self.calls():
                    if kind == "pair":
                        call(make())
                sim.set_body_velocity(0, make())
                self.assertEqual(sim.body(0).velocity, (1, 2))
                self.assertEqual(sim.add_particles([make(), make()], make()), 0)
                self.assertEqual(sph2d.Scene(tank(), {"gravity": make()}).as_dict()["gravity"], (1, 2))
                if common.CAN_DRAW:
                    sph2d.Renderer(32, 32).draw(sim, view=[(0, 0), make()], values=map(float, sim.fluid.x))

    def test_values_of_scenes(self):
        """The path of the key is in the sentence."""
        places = {"spacing": lambda v: {"spacing": v}, "fluid.density": lambda v: {"fluid": {"density": v}},
                  "domain.min": lambda v: {"domain": {"min": [v, 0], "max": [1, 1]}},
                  "domain.max": lambda v: {"domain": {"min": [0, 0], "max": v}}, "blocks": lambda v: {"blocks": v},
                  "blocks[0].polygon": lambda v: {"blocks": [{"polygon": [[0, 0], [1, 0], [0, v]]}]},
                  "run.frames.size": lambda v: {"run": {"frames": {"size": np.array([64, v], object)}}},
                  "probes[1].name": lambda v: {"probes": [{"name": "all", "kind": "energy", "every": 1}, {
                      "kind": "energy", "every": 1, "name": v}]},
                  "boundary.top": lambda v: {"boundary": {"top": v}}, "run.parts": lambda v: {"run": {"parts": v}},
                  "method.shifting": lambda v: {"method": {"shifting": v}}}
        for path, place in places.items():
            for what, make in {**NONSENSE, **OTHERS}.items():
                with self.subTest(path=path, what=what):
                    for scene, changes in ((tank(**place(make())), None), (tank(), place(make())), (
                            tank(), {path: make()})):
                        try:
                            sph2d.Scene(scene, changes)
                        except Exception as error:
                            self.assertTrue(said_by_the_module(error), repr(error)[:500])
                            named = re.split(r"[.\[]", path) if isinstance(error, sph2d.Error) else [re.escape(path)]
                            self.assertRegex(str(error), f"{named[0]}|{named[-1]}|nested too deeply")


if __name__ == "__main__":
    unittest.main()
