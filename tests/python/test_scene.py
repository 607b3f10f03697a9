"""Scenes: dicts and files, changes on top, every fault in one Error, warnings."""
import json
import os
import pathlib
import pickle
import subprocess
import sys
import unittest
import warnings

import numpy as np

import common
from common import sph2d, tank


class Scenes(common.InFolder):
    def fault(self, *arguments, **more):
        with self.assertRaises(sph2d.Error) as caught:
            sph2d.Scene(*arguments, **more)
        return caught.exception

    def test_a_dict(self):
        scene = sph2d.Scene(tank(name="a \"tank\" é"))
        keys = scene.as_dict()
        self.assertEqual(keys["name"], 'a "tank" é')
        self.assertEqual(keys["domain"], {"min": (0, 0), "max": (1, 0.8)})
        self.assertEqual(keys["blocks"][0]["box"]["max"], (0.4, 0.6))
        self.assertNotIn("circle", keys["blocks"][0])
        self.assertEqual((keys["method"]["name"], keys["boundary"]["top"], keys["run"]["until"]), ("wcsph", "open", 1))
        self.assertEqual((keys["method"]["cfl"], keys["motion"]["center"], keys["gravity"]), (None, None, (0, -9.81)))
        self.assertEqual(scene.plan().fluid_particles, 96)
        self.assertEqual(json.loads(scene.text), tank(name="a \"tank\" é"))

    def test_values_of_other_types(self):
        class Keys(dict):
            pass

        scene = sph2d.Scene(Keys(domain={"min": (0, 0), "max": np.array([1, 0.8])}, spacing=np.float32(0.0625),
                                 fluid={"dynamic_viscosity": np.int64(1)}, run={"frames": {"size": (np.int16(64), 64), "arrows": False}},
                                 blocks=({"polygon": np.array([[0, 0], [0.5, 0], [0.5, 0.5], [0, 0.5]])},),
                                 obstacles=[{"line": [[0.7, 0], [0.7, 0.3]],
                                             "motion": {"path": [[0, 0, 0], (1, 0.1, 0, 0.2)]}}],
                                 probes=[]))
        keys = scene.as_dict()
        self.assertEqual((keys["spacing"], keys["run"]["frames"]["arrows"]), (0.0625, "off"))
        self.assertEqual(keys["obstacles"][0]["motion"]["path"], [(0, 0, 0, 0), (1, 0.1, 0, 0.2)])
        self.assertEqual(keys["blocks"][0]["polygon"][2], (0.5, 0.5))
        self.assertEqual(keys["run"]["frames"]["size"], (64, 64))

    def test_changes(self):
        changes = {"fluid.density": 900, "blocks[0].velocity": np.array([1, 0]), "method": "pcisph"}
        keys = sph2d.Scene(tank(), changes).as_dict()
        self.assertEqual((keys["fluid"]["density"], keys["blocks"][0]["velocity"]), (900, (1, 0)))
        self.assertEqual(keys["method"]["name"], "pcisph")
        error = self.fault(tank(), set={"fluid.desnity": 900})
        self.assertIn("did you mean 'density'?", str(error))
        self.assertEqual(self.fault(tank(), set={"": 1}).status, "SCENE")
        with self.assertRaises(ValueError):
            sph2d.Scene(tank(), set={"spacing\0": 0.1})
        self.assertEqual(self.fault(tank(), set={"spacing\n#": 1}).status, "SCENE")

    def test_a_file(self):
        text = "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.1\nfluid: {dynamic_viscosity: 100}\n" \
               "blocks:\n  - box: {min: [0, 0], max: [0.4, 0.8]}\n"
        with open("scene ü.yaml", "w") as file:
            file.write(text)
        for name in ("scene ü.yaml", pathlib.Path("scene ü.yaml"), b"scene \xc3\xbc.yaml"):
            self.assertEqual(sph2d.Scene(name).text, text)
        self.assertEqual(sph2d.Scene("scene ü.yaml", {"spacing": 0.05}).as_dict()["spacing"], 0.05)
        error = self.fault("missing.yaml")
        self.assertEqual(error.status, "NOINPUT")
        self.assertIn("'missing.yaml': No such file", str(error))
        self.assertEqual(self.fault(os.getcwd()).status, "NOINPUT")
        for nonsense in (None, 3, [1], object()):
            with self.assertRaises(TypeError):
                sph2d.Scene(nonsense)
        with self.assertRaises(ValueError):
            sph2d.Scene("scene ü.yaml\0.txt")

    def test_files_of_a_dict_are_beside_the_program(self):
        np.savetxt("drops.csv", [[0.3, 0.3], [0.5, 0.3]], delimiter=",", header="x,y", comments="")
        scene = tank(blocks=[], particles=pathlib.Path("drops.csv"), method={"sound_speed": 20})
        with sph2d.Simulation(scene) as sim:
            self.assertEqual(sorted(sim.fluid.x), [0.3, 0.5])
        os.mkdir("elsewhere")
        os.chdir("elsewhere")
        self.assertEqual(self.fault(scene).status, "NOINPUT")

    def test_all_faults_are_told(self):
        error = self.fault(tank(spacing=-1, colour="blue", fluid={"densty": 3}, gravity=float("nan")))
        self.assertEqual(error.status, "SCENE")
        found = {diagnostic.path: diagnostic for diagnostic in error.diagnostics}
        self.assertEqual(set(found), {"spacing", "colour", "fluid.densty", "gravity"})
        fault = found["fluid.densty"]
        self.assertEqual((fault.severity, fault.code, fault.file), ("error", "S101", "scene"))
        self.assertEqual((fault.hint, fault.excerpt.strip()), ("did you mean 'density'?", '"densty": 3'))
        for diagnostic in error.diagnostics:
            self.assertIn(diagnostic.message, str(error))
            self.assertIn(diagnostic.text, str(error))
        copy = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(copy), copy.status, copy.diagnostics), (str(error), "SCENE", error.diagnostics))

    def test_more_faults_than_a_report_has(self):
        error = self.fault({f"key{k}": 1 for k in range(50)})
        self.assertEqual(len(error.diagnostics) + error.dropped, 52)
        self.assertTrue(str(error).endswith(f"and {error.dropped} more"))

    def test_nonsense(self):
        for source in ({}, {"domain": None}, {"domain": {}}, {"": {"": []}}, {"blocks": [[[]]]}, tank(spacing="0.1"),
                       tank(spacing=float("inf")), tank(blocks=[{}]), tank(name="a\0b" * 1000), {1: 2}, {None: None},
                       tank(domain={"min": [0, 0], "max": [1, 10 ** 400]})):
            self.assertEqual(self.fault(source).status, "SCENE", source)
        deep = []
        for _ in range(150):
            deep = [deep]
        self.assertEqual(self.fault(tank(blocks=deep)).status, "SCENE")
        for source in (tank(spacing=1j), tank(spacing=object()), tank(name=b"bytes"), tank(blocks=np.array([1j]))):
            with self.assertRaises(TypeError):
                sph2d.Scene(source)

    def test_faults_found_later_have_their_place(self):
        both = [{"box": {"min": [0, 0], "max": [0.4, 0.6]}}, {"box": {"min": [0.2, 0.2], "max": [0.6, 0.4]}}]
        scene = sph2d.Scene(tank(blocks=both))
        for call in (scene.plan, lambda: sph2d.Simulation(scene)):
            with self.assertRaises(sph2d.Error) as caught:
                call()
            fault = caught.exception.diagnostics[0]
            self.assertEqual((fault.code, fault.file), ("S108", "scene"))
            self.assertGreater(fault.line, 1)

    def test_warnings(self):
        weak = tank(fluid={}, sources=[{"at": [0.5, 0.7], "speed": 1, "stop": 1e-9}], method={"sound_speed": 1})
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            sph2d.Simulation(weak)
        self.assertTrue(caught)
        self.assertEqual({warning.category for warning in caught}, {sph2d.SceneWarning})
        self.assertEqual({warning.filename for warning in caught}, {__file__})
        texts = [str(warning.message) for warning in caught]
        self.assertEqual(len(texts), len(set(texts)))
        self.assertIn("hint: ", texts[0])
        with self.assertRaises(sph2d.SceneWarning), warnings.catch_warnings():
            warnings.simplefilter("error")
            sph2d.Scene(weak)

    def test_examples_are_read(self):
        scenes = sorted((common.ROOT / "examples").glob("*/scene.yaml"))
        self.assertGreater(len(scenes), 30)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for scene in scenes:
                keys = sph2d.Scene(scene).as_dict()
                self.assertGreater(keys["spacing"], 0, scene)
                self.assertTrue(keys["blocks"] or keys["sources"] or keys["particles"] or keys["start"]["snapshot"]
                                or keys["openings"], scene)

    def test_a_program_says_what_is_wrong(self):
        code = "import sph2d; sph2d.Simulation({'domain': {'min': [0, 0], 'max': [1, 1]}, 'spacing': 0})"
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                             env={**os.environ, "PYTHONPATH": str(common.ROOT / "python")})
        self.assertEqual(run.returncode, 1)
        self.assertIn("sph2d.Error: scene:6:13: error[S104]: spacing: 0 is out of range: must be above 0\n", run.stderr)


if __name__ == "__main__":
    unittest.main()
