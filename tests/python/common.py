"""What the tests of the Python module share."""
import importlib.util
import os
import pathlib
import sys
import tempfile
import unittest
import warnings

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The module of the source with the libraries that are named, else the one that is installed.
if "SPH2D_LIBRARY_DIR" in os.environ:
    sys.path.insert(0, str(ROOT / "python"))

import sph2d  # noqa: E402

LIBRARIES = sph2d._FOLDER
COMPILER = os.environ.get("CC", "cc").split()
CAN_DRAW = (LIBRARIES / "libsph2d-render.so.0").exists()


def has(*modules):
    """Whether these are installed."""
    return all(importlib.util.find_spec(module) for module in modules)


def tank(**more):
    """A column of 96 particles that falls over."""
    return {"domain": {"min": [0, 0], "max": [1, 0.8]}, "spacing": 0.05, "fluid": {"dynamic_viscosity": 1},
            "blocks": [{"box": {"min": [0, 0], "max": [0.4, 0.6]}}], **more}


def jet():
    """A jet into an empty tank: the number of particles grows."""
    return tank(blocks=[], sources=[{"at": [0.5, 0.7], "speed": 3, "width": 0.3}])


def raft(**more):
    """A body over a pool, which falls on it."""
    return tank(blocks=[{"box": {"min": [0, 0], "max": [1, 0.2]}}],
                bodies=[{"name": "raft", "box": {"min": [0.3, 0.5], "max": [0.6, 0.6]}, "density": 400}], **more)


def ignore_warnings(test):
    """For scenes that are coarse, so that tests are fast."""
    ignored = warnings.catch_warnings()
    ignored.__enter__()
    test.addCleanup(ignored.__exit__, None, None, None)
    warnings.simplefilter("ignore", sph2d.SceneWarning)


class InFolder(unittest.TestCase):
    """Tests in an empty folder, which goes away."""

    def setUp(self):
        before, folder = os.getcwd(), tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, before)
        os.chdir(folder.name)
