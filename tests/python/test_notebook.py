"""Pictures of notebooks, plots, series and tables: what the command writes of the same scene."""
import copy
import csv
import io
import json
import math
import pickle
import subprocess
import sys
import unittest
from unittest import mock

import numpy as np

import common
from common import raft, sph2d, tank

COMMAND = common.LIBRARIES / "sph2d"
GAUGES = [{"name": "gauge", "kind": "pressure", "at": [0.1, 0.1], "every": 0.01},
          {"name": "push", "kind": "force", "on": "left", "per_second": 25}]
# Names of --json that are not those of Summary and Densities, and what stands for them.
OTHER_NAMES = {"energy_kinetic": "kinetic", "energy_potential": "potential", "energy_elastic": "elastic",
               "energy_bodies": "bodies", "volume_covered": "covered", "density_reported": "reported",
               "density_counted": "counted"}


def gauged(**more):
    return tank(probes=GAUGES, run={"until": 0.2, "frames": {"per_second": 10, "size": [320, 240], **more}})


def read_series(path):
    """The columns of a CSV file by their names."""
    with open(path) as file:
        names, *rows = csv.reader(file)
    return {name: np.array([float(row[k]) for row in rows]) for k, name in enumerate(names)}


class Beside(common.InFolder):
    """The module beside the command."""

    def setUp(self):
        super().setUp()
        common.ignore_warnings(self)

    def run_command(self, scene, *options):
        """Runs a scene, and returns what --json says."""
        if not COMMAND.exists():
            self.skipTest("the command is not built")
        with open("scene.yaml", "w") as file:
            json.dump(scene, file)
        run = subprocess.run([COMMAND, "run", "scene.yaml", "-o", "out", "--json", "--threads", "1", *options],
                             capture_output=True, text=True, check=True)
        return json.loads(run.stdout.splitlines()[-1])

    def assert_same(self, series, other):
        self.assertEqual(list(series), list(other))
        for name in series:
            np.testing.assert_allclose(series[name], other[name], rtol=1e-8, atol=1e-12, err_msg=name)

    def test_series_are_the_files_of_the_command(self):
        self.run_command(gauged(), "--no-frames")
        sim = sph2d.Simulation(gauged(), threads=1)
        sim.run_to(0.2)
        for name in ("gauge", "push"):
            self.assert_same(sim.series(name), read_series(f"out/{name}.csv"))
        self.assertEqual(len(sim.series(0)["time [s]"]), 21)
        self.assertRaises(KeyError, sim.series, "none")
        sim.series("gauge")["time [s]"][0] = 7  # a copy
        self.assertEqual(sim.series("gauge")["time [s]"][0], 0)

    def test_series_of_copies_go_on(self):
        sim = sph2d.Simulation(gauged())
        sim.run_to(0.1)
        sim.write_snapshot("a.h5")
        copies = [copy.copy(sim), pickle.loads(pickle.dumps(sim))]
        resumed = sph2d.Snapshot("a.h5").resume()
        sim.run_to(0.2)
        whole = sim.series("push")
        for made in copies:
            made.run_to(0.2)
            self.assert_same(made.series("push"), whole)
        resumed.run_to(0.2)
        later = whole["time [s]"] > 0.101
        self.assertEqual((later.sum(), len(later)), (3, 6))
        self.assert_same(resumed.series("push"), {name: column[later] for name, column in whole.items()})

    def test_the_summary_has_the_names_and_values_of_json(self):
        scene = raft(run={"until": 0.1})
        told = self.run_command(scene)
        sim = sph2d.Simulation(scene, threads=1)
        sim.run_to(0.1)
        known = {**sim.summary()._asdict(), **sim.densities()._asdict()}
        numbers = {**told["error"], **told["particles"], "steps": told["steps"], "time": told["time"]}
        compared = 0
        for name, value in numbers.items():
            own = known.get(OTHER_NAMES.get(name, name))
            if name in ("now", "left", "energy_change", "density_apart"):  # other names, and what is made of others
                continue
            self.assertIsNotNone(own, name)
            if value is None:
                self.assertTrue(np.isnan(own).all(), name)
            else:
                np.testing.assert_allclose(own, value, rtol=1e-5, atol=1e-12, err_msg=name)
                compared += 1
        self.assertGreater(compared, 30)
        self.assertEqual(told["particles"]["now"], known["particles"])

    @unittest.skipUnless(common.CAN_DRAW and COMMAND.exists(), "without libsph2d-render or the command")
    def test_notebooks_show_the_frame(self):
        for more in ({}, {"style": "points", "color": "speed"},
                     {"color": "vorticity", "view": {"min": [0, 0], "max": [1, 0.5]}},
                     {"style": "points", "color": "Pressures", "color_range": [0, 3000], "isolines": "Densities",
                      "radius": 0.04, "caption": "off", "background": "transparent", "streamlines": "on",
                      "arrows": "on"}):
            sim = sph2d.Simulation(gauged(**more), threads=1)
            sim.run_to(0.15)
            sim.write_snapshot("a.h5")
            subprocess.run([COMMAND, "render", "a.h5", "-o", "drawn", "-q", "-f"], check=True)
            with open("drawn/frame_000000.png", "rb") as file:
                frame = file.read()
            self.assertEqual(sim._repr_png_(), frame, more)
            self.assertEqual(sph2d.Snapshot("a.h5")._repr_png_(), frame, more)

    @unittest.skipUnless(common.CAN_DRAW and COMMAND.exists(), "without libsph2d-render or the command")
    def test_notebooks_show_colours_and_paths(self):
        scene = gauged()
        scene["probes"] = [{"name": "a", "kind": "tracer", "at": [0.3, 0.2], "every": 0.01},
                           {"name": "b", "kind": "tracer", "at": [0.1, 0.1], "every": 0.02}]
        scene.update(boundary={"left": "periodic", "right": "periodic"}, gravity=[30, -9.81])  # some go round
        for fluid in ({"color": "teal"}, {"material": "honey"}):
            scene["fluid"] = fluid
            sim = sph2d.Simulation(scene, threads=1)
            sim.run_to(0.1)
            sim.add_particles([[0.5, 0.75]], color="red")
            sim.run_to(0.35)
            colors = sim.fluid.color
            self.assertEqual(colors is None, "material" in fluid)
            if colors is not None:
                self.assertEqual((set(colors.tolist()), (colors == 0xff0000).sum()), ({0x008080, 0xff0000}, 1))
            sim.write_snapshot("a.h5")
            subprocess.run([COMMAND, "render", "a.h5", "-o", "drawn", "-q", "-f"], check=True)
            with open("drawn/frame_000000.png", "rb") as file:
                frame = file.read()
            snapshot = sph2d.Snapshot("a.h5")
            self.assertEqual((sim._repr_png_(), snapshot._repr_png_()), (frame, frame), fluid)
            self.assertEqual(snapshot.fluid.color is None, colors is None)
            series = sim.series("a")
            self.assertGreater(np.ptp(series["x [m]"]), 0.9)
            self.assertEqual(len(set(series["particle"])), 1)
        self.assertRaisesRegex(ValueError, "'reddish' is no colour", sim.add_particles, [[0.5, 0.95]], color="reddish")
        with self.assertRaises(sph2d.Error):
            sim.add_particles([[0.5, 0.95]], color=-1)

    def test_no_picture_where_none_can_be_drawn(self):
        sim = sph2d.Simulation(tank())
        self.assertIs(common.CAN_DRAW, sim._repr_png_() is not None)
        with mock.patch.object(sph2d, "Renderer", side_effect=sph2d.Error("RENDER")):
            self.assertIsNone(sim._repr_png_())
        with mock.patch.object(sph2d, "Renderer", side_effect=sph2d.Error("NOMEM")):
            self.assertRaises(sph2d.Error, sim._repr_png_)
        sim.close()
        self.assertIsNone(sim._repr_png_())

    def test_what_is_not_installed_is_told(self):
        sim = sph2d.Simulation(gauged())
        hidden = {"matplotlib": None, "matplotlib.pyplot": None, "pandas": None}
        with mock.patch.dict(sys.modules, hidden):
            self.assertRaisesRegex(ImportError, r"plot\(\) needs Matplotlib, which is not installed: `pip", sim.plot)
            self.assertRaisesRegex(ImportError, r"frame\(\) needs pandas, .*series\(\) does without", sim.frame, 0)
        self.assertRaises(KeyError, sim.frame, "none")

    @unittest.skipUnless(common.has("pandas"), "without pandas")
    def test_tables(self):
        sim = sph2d.Simulation(gauged())
        sim.run_to(0.05)
        table = sim.frame("gauge")
        self.assertEqual(list(table.columns)[:2], ["time [s]", "pressure [Pa]"])
        np.testing.assert_array_equal(table["time [s]"], sim.series("gauge")["time [s]"])

    @unittest.skipUnless(common.has("matplotlib"), "without Matplotlib")
    def test_plots(self):
        sim = sph2d.Simulation(raft())
        sim.run_to(0.1)
        sim.write_snapshot("a.h5")
        for source in (sim, sph2d.Snapshot("a.h5")):
            axes = source.plot("Pressures", cmap="magma", clim=(0, 500))
            discs, lines = axes.collections
            np.testing.assert_array_equal(discs.get_offsets()[:, 0], source.fluid.x)
            np.testing.assert_array_equal(discs.get_array(), source.fluid.pressure)
            self.assertEqual((discs.get_clim(), discs.get_cmap().name), ((0, 500), "magma"))
            self.assertEqual(axes.figure.axes[1].get_ylabel(), "Pressures [Pa]")
            self.assertEqual(axes.get_title(), f"scene   t = {sim.time:.2f} s")
            body = lines.get_segments()[-1]
            np.testing.assert_array_equal(body[0], body[-1])
            self.assertAlmostEqual(body[:, 0].max() - body[:, 0].min(), 0.3, 2)
            png = io.BytesIO()
            axes.figure.savefig(png)
        again = sim.plot("vorticity", axes)
        self.assertIs(again, axes)
        low, high = axes.collections[-2].get_clim()
        self.assertEqual((low, high > 0), (-high, True))
        self.assertIsNone(sim.plot(None).collections[0].get_array())
        honey = sph2d.Simulation(tank(fluid={"material": "honey"})).plot(None).collections[0].get_facecolors()
        np.testing.assert_allclose(honey, [[0xe0 / 255, 0x93 / 255, 0x0f / 255, 1]])
        red = sph2d.Simulation(tank(fluid={"color": "red"})).plot(None).collections[0].get_facecolors()
        np.testing.assert_allclose(red, np.tile([1.0, 0, 0, 1], (96, 1)))
        self.assertRaisesRegex(ValueError, "color is one of speed, vorticity, Masses", sim.plot, "heat")
        empty = sph2d.Simulation(tank(blocks=[], sources=[{"at": [0.5, 0.7], "speed": 3, "width": 0.3}]))
        empty.plot().figure.savefig(png)

    def test_units_and_limits(self):
        units = {(-1, 1, -2): "Pa", (-3, 1, 0): "kg/m^3", (1, 0, -2): "m/s^2", (0, 0, -1): "1/s", (0, 0, 0): "",
                 (1, 1, -3): "kg m/s^3", (0, -1, -1): "1/(kg s)"}
        for powers, text in units.items():
            self.assertEqual(sph2d._unit_text(powers), text)
        self.assertEqual(sph2d._limits(np.arange(101.0), False), [1, 99])
        self.assertEqual(sph2d._limits(np.arange(-100.0, 1), True), [-99, 99])
        self.assertEqual(sph2d._limits(np.array([math.nan, 2, 2]), False), [2, 2])
        self.assertIsNone(sph2d._limits(np.array([math.nan]), False))


if __name__ == "__main__":
    unittest.main()
