"""Where the libraries are looked for, and what is said where they are missing or of another version."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import common
from common import sph2d

STEP = "import sph2d; sim = sph2d.Simulation({'domain': {'min': [0, 0], 'max': [1, 1]}, 'spacing': 0.1, " \
       "'fluid': {'dynamic_viscosity': 100}, 'blocks': [{'box': {'min': [0, 0], 'max': [0.4, 1]}}]}); sim.step(); " \
       "print(sph2d._FOLDER)"
BODY = STEP.replace("'spacing'", "'bodies': [{'circle': {'center': [0.7, 0.5], 'radius': 0.1}, 'density': 500}], "
                                 "'spacing'")
# What `pip install -e .` has put beside the module.
IGNORED = shutil.ignore_patterns("lib")
DRAW = STEP + "; sph2d.Renderer(100, 100)"


class Libraries(common.InFolder):
    def run_python(self, code, **env):
        """(exit code, output, what the last line of errors says) of a program."""
        clean = {key: value for key, value in os.environ.items() if key not in ("SPH2D_LIBRARY_DIR", "LD_LIBRARY_PATH")}
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                             env={**clean, "PYTHONPATH": str(common.ROOT / "python"), **env})
        return run.returncode, run.stdout.strip(), run.stderr.strip().split("\n")[-1]

    def folder_with(self, folder, *names):
        os.makedirs(folder, exist_ok=True)
        for name in names:
            os.symlink(common.LIBRARIES / f"lib{name}.so.0", f"{folder}/lib{name}.so.0")
        return str(pathlib.Path(folder).absolute())

    def test_the_environment_names_them(self):
        folder = self.folder_with("some where", "sph2d", "sph2d-io")
        self.assertEqual(self.run_python(STEP, SPH2D_LIBRARY_DIR=folder), (0, folder, ""))
        self.assertEqual(self.run_python(STEP, SPH2D_LIBRARY_DIR="some where"), (0, folder, ""))

    def test_beside_the_module(self):
        for below, lib in (("usr/lib/python3/dist-packages", "usr/lib"),
                           ("opt/lib64/python3.9/site-packages", "opt/lib64"),
                           ("home/env/lib/python3/site-packages", "home/env/lib"), ("here", "here")):
            shutil.copytree(common.ROOT / "python", below, ignore=IGNORED)
            folder = self.folder_with(lib, "sph2d", "sph2d-io")
            code, out, error = self.run_python(STEP, PYTHONPATH=below)
            self.assertEqual((code, os.path.realpath(out), error), (0, os.path.realpath(folder), ""))

    def test_by_the_loader(self):
        shutil.copytree(common.ROOT / "python", "alone", ignore=IGNORED)
        folder = self.folder_with("libraries", "sph2d", "sph2d-io")
        self.assertEqual(self.run_python(STEP, PYTHONPATH="alone", LD_LIBRARY_PATH=folder), (0, "None", ""))
        code, _, error = self.run_python(STEP, PYTHONPATH="alone")
        if code:  # they are not installed on this machine
            self.assertRegex(error, "^ImportError: no libsph2d and libsph2d-io in the folders of the system's loader: "
                                    ".*libsph2d.*; install them with `make install`, or set SPH2D_LIBRARY_DIR")

    def test_missing(self):
        for names in ((), ("sph2d",), ("sph2d-io",)):
            folder = self.folder_with("with" + "".join(names), *names)
            code, _, error = self.run_python(STEP, SPH2D_LIBRARY_DIR=folder)
            self.assertEqual(code, 1)
            self.assertRegex(error, f"^ImportError: no libsph2d and libsph2d-io in {folder}: .*No such file")

    def test_missing_where_it_is_needed(self):
        folder = self.folder_with("few", "sph2d", "sph2d-io")
        self.assertEqual(self.run_python(STEP, SPH2D_LIBRARY_DIR=folder)[0], 0)
        code, _, error = self.run_python(BODY, SPH2D_LIBRARY_DIR=folder)
        self.assertEqual(code, 1)
        self.assertRegex(error, rf"^sph2d.Error: no libsph2d-contacts in {folder}, which is needed for contacts of "
                                r"bodies \(contacts=False does without\): ")
        without = BODY.replace("}); sim", "}, contacts=False); sim")
        self.assertEqual(self.run_python(without, SPH2D_LIBRARY_DIR=folder)[0], 0)
        code, out, error = self.run_python(DRAW, SPH2D_LIBRARY_DIR=folder)
        self.assertEqual((code, out), (1, folder))
        self.assertRegex(error, f"^sph2d.Error: no libsph2d-render in {folder}, which is needed for pictures: ")

    def compile(self, folder, code):
        os.makedirs(folder)
        with open("library.c", "w") as file:
            file.write(code)
        subprocess.run([*common.COMPILER, "-shared", "-fPIC", "library.c", "-o", f"{folder}/libsph2d.so.0"], check=True)
        os.symlink(common.LIBRARIES / "libsph2d-io.so.0", f"{folder}/libsph2d-io.so.0")
        return str(pathlib.Path(folder).absolute())

    def test_other_versions(self):
        version = 'const char *sph2d_version(void) { return "%s"; }'
        for other in ("0.2.0", "1.1.0", "9.9.9-dev"):
            folder = self.compile("v" + other, version % other)
            code, _, error = self.run_python(STEP, SPH2D_LIBRARY_DIR=folder)
            self.assertEqual(code, 1)
            self.assertRegex(error, "^ImportError: the Python module .*/sph2d is of sph2d 0.1.0, libsph2d in "
                                    f"{folder} of {other}: install both from the same source, or set SPH2D_LIBRARY_DIR")
        folder = self.compile("older", version % "0.1.0")
        code, _, error = self.run_python(STEP, SPH2D_LIBRARY_DIR=folder)
        self.assertEqual(code, 1)
        self.assertRegex(error, "^ImportError: libsph2d or libsph2d-io in .* is older than the Python module "
                                ".*/sph2d: .*sph2d_")
        folder = self.compile("foreign", "int nothing;")
        error = self.run_python(STEP, SPH2D_LIBRARY_DIR=folder)[2]
        self.assertRegex(error, "^ImportError: .*undefined symbol: sph2d_version")

    def test_other_structs(self):
        functions = "".join(f"int {name}() {{ return 0; }}\n"
                            for name in set(re.findall(r"(sph2d_\w+)\(", sph2d._FUNCTIONS_TEXT["sph2d"]))
                            - {"sph2d_sim_options_default", "sph2d_version"})
        folder = self.compile("structs", functions + """
#include <stddef.h>
const char *sph2d_version(void) { return "0.1.99"; }
struct options { size_t size; char rest[88]; };
struct options sph2d_sim_options_default(void) { struct options o = {96}; return o; }
""")
        os.remove("structs/libsph2d-io.so.0")
        names = re.findall(r"(sph2d_\w+)\(", sph2d._FUNCTIONS_TEXT["sph2d-io"])
        with open("io.c", "w") as file:
            file.write("".join(f"int {name}() {{ return 0; }}\n" for name in names))
        subprocess.run([*common.COMPILER, "-shared", "-fPIC", "io.c", "-o", "structs/libsph2d-io.so.0"], check=True)
        code, _, error = self.run_python(STEP, SPH2D_LIBRARY_DIR=folder)
        self.assertEqual(code, 1)
        self.assertRegex(error, "^ImportError: libsph2d in .* has structs other than those of the Python module")

    def test_the_version_is_that_of_the_source(self):
        with open(common.ROOT / "include/sph2d/version.h") as file:
            self.assertIn(f'#define SPH2D_VERSION "{sph2d.__version__}"\n', file.read())
        self.assertEqual(sph2d._CORE.sph2d_version().decode(), sph2d.__version__)


if __name__ == "__main__":
    unittest.main()
