"""Pictures, where libsph2d-render is there."""
import math
import unittest

import numpy as np

import common
from common import sph2d, tank


@unittest.skipUnless(common.CAN_DRAW, "without libsph2d-render")
class Pictures(common.InFolder):
    def setUp(self):
        super().setUp()
        self.sim = sph2d.Simulation(tank())
        self.sim.run_to(0.1)

    def test_a_surface(self):
        with sph2d.Renderer(200, 160) as renderer:
            picture = renderer.draw(self.sim)
            self.assertEqual((picture.shape, picture.dtype), ((160, 200, 4), np.uint8))
            self.assertTrue((picture[..., 3] == 255).all())
            left, right = picture[100:130, 20:60, :3], picture[20:40, 120:170, :3]  # water, air
            self.assertTrue((np.ptp(right, axis=(0, 1)) < 3).all())
            self.assertGreater(np.abs(left.mean(axis=(0, 1)) - right.mean(axis=(0, 1))).max(), 30)
            renderer.write_png("a.png")
            with open("a.png", "rb") as file:
                self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")
            np.testing.assert_array_equal(renderer.draw(self.sim), picture)
            self.sim.run_to(0.2)
            self.assertTrue((renderer.draw(self.sim) != picture).any())

    def test_points(self):
        fluid = self.sim.fluid
        speed = np.hypot(fluid.vx, fluid.vy)
        with sph2d.Renderer(200, 160, "points") as renderer:
            plain = renderer.draw(self.sim)
            colours = renderer.draw(self.sim, values=speed, label="speed [m/s]", value_range=(0, 2))
            number, few = (len(np.unique(picture.reshape(-1, 4), axis=0)) for picture in (colours, plain))
            self.assertGreater(number, few)
            self.assertTrue((renderer.draw(self.sim, values=np.full(96, math.nan)) != colours).any())
            self.assertTrue((renderer.draw(self.sim, radius=0.1) != plain).any())
            self.assertTrue((renderer.draw(self.sim, view=((0, 0), (0.5, 0.4))) != plain).any())
            self.sim.write_snapshot("a.h5")
            np.testing.assert_array_equal(renderer.draw(sph2d.Snapshot("a.h5"), speed, "speed [m/s]", (0, 2)), colours)
            for values in (speed[1:], speed[:, None], 3):
                self.assertRaises(ValueError, renderer.draw, self.sim, values)

    def test_reservoirs_are_not_drawn(self):
        channel = sph2d.Simulation({
            "domain": {"min": [0, 0], "max": [1, 0.5]}, "spacing": 0.05, "fluid": {"dynamic_viscosity": 10},
            "boundary": {"top": "wall"}, "blocks": [{"box": {"min": [0, 0], "max": [1, 0.5]}, "velocity": [1, 0]}],
            "openings": [{"side": "left", "velocity": 1}, {"side": "right", "pressure": 0}], "gravity": [0, 0]})
        self.assertLess(channel.fluid.x.min(), -0.3)
        with sph2d.Renderer(200, 100, "points") as renderer:
            picture = renderer.draw(channel, view=((-1, -0.25), (1, 0.75)))
        colours = np.abs(picture.astype(int) - picture[1, 1]).max(axis=2) > 10
        self.assertTrue(colours[:, 81:].any())
        self.assertFalse(colours[:, :78].any())

    def test_texts(self):
        with sph2d.Renderer(200, 160) as renderer:
            plain = renderer.draw(self.sim)
            for texts in ({"caption": "t = 0.1 s"}, {"notes": "two\nlines"}, {"caption": "\N{WATER WAVE}"}):
                self.assertTrue((renderer.draw(self.sim, **texts) != plain).any(), texts)

    def test_looks(self):
        pictures = []
        for look in ("water", "flat", "glass", "ink"):
            with sph2d.Renderer(200, 100, look=look) as renderer:
                pictures.append(renderer.draw(self.sim).tobytes())
        self.assertEqual(len(set(pictures)), 4)

    def test_background(self):
        with sph2d.Renderer(200, 100, background="transparent") as renderer:
            alpha = renderer.draw(self.sim)[..., 3]
        self.assertEqual((alpha.min(), alpha.max()), (0, 255))

    def test_lines(self):
        fluid = self.sim.fluid
        with sph2d.Renderer(400, 300) as renderer:
            plain = renderer.draw(self.sim, caption="")
            for lines in ({"levels": fluid.x}, {"levels": fluid.y, "level_step": 0.1}, {"arrows": True},
                          {"streamlines": True}, {"streamlines": True, "streamline_spacing": 0.02},
                          {"levels": fluid.x, "level_label": "x [m]"}):
                self.assertEqual((renderer.draw(self.sim, caption="", **lines) != plain).any(),
                                 not {"arrows", "streamlines"} & lines.keys() or np.hypot(fluid.vx, fluid.vy).max() > 0, lines)
            with self.assertRaises(ValueError):
                renderer.draw(self.sim, levels=fluid.x[1:])
            with self.assertRaises(sph2d.Error):
                renderer.draw(self.sim, levels=fluid.x, level_step=-1)
            with self.assertRaises(sph2d.Error):
                renderer.draw(self.sim, streamlines=True, streamline_spacing=-1)

    def test_vorticity(self):
        values = sph2d.vorticity(self.sim)
        self.assertEqual(values.shape, (len(self.sim.fluid),))
        with sph2d.Renderer(400, 300) as renderer:
            pictures = [renderer.draw(self.sim, self.sim.fluid.x - 0.5, diverging=diverging).tobytes()
                        for diverging in (False, True)]
            self.assertNotEqual(*pictures)

    def test_nonsense(self):
        for arguments in ((8, 100), (100, 20000), (-1, 100), (2 ** 32 + 100, 100), (100, 100, "dots"),
                          (100, 100, "metaballs", "wax"),
                          (100, 100, "metaballs", "ink", "blue")):
            with self.assertRaises(ValueError):
                sph2d.Renderer(*arguments)
        with self.assertRaises(sph2d.Error) as caught:
            sph2d.Renderer(100, 100, gl="paper")
        self.assertIn("paper", str(caught.exception))
        renderer = sph2d.Renderer(100, 100)
        with self.assertRaises(sph2d.Error) as caught:
            renderer.write_png("a.png")
        self.assertEqual(caught.exception.status, "INVALID")
        with self.assertRaises(sph2d.Error):
            renderer.draw(self.sim, radius=-1)
        with self.assertRaises(sph2d.Error):
            renderer.draw(self.sim, view=((0, 0), (math.nan, 1)))
        renderer.draw(self.sim)
        with self.assertRaises(sph2d.Error) as caught:
            renderer.write_png("missing/a.png")
        self.assertEqual(caught.exception.status, "CANTCREAT")
        renderer.close()
        renderer.close()
        with self.assertRaisesRegex(ValueError, "the renderer is closed"):
            renderer.draw(self.sim)
        self.sim.close()
        with sph2d.Renderer(100, 100) as renderer, self.assertRaisesRegex(ValueError, "the simulation is closed"):
            renderer.draw(self.sim)


if __name__ == "__main__":
    unittest.main()
