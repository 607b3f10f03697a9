"""The programs of the pages run, and the page of the module names all of it."""
import contextlib
import inspect
import io
import os
import re
import subprocess
import sys
import unittest

import common
from common import sph2d

PAGES = {"docs/python.md": 10, "README.md": 1}


def programs_of(page):
    with open(common.ROOT / page) as file:
        return re.findall(r"^```python\n(.*?)^```$", file.read(), re.DOTALL | re.MULTILINE)


class Documentation(common.InFolder):
    def test_programs_run(self):
        common.ignore_warnings(self)
        for page, count in PAGES.items():
            programs, names = programs_of(page), {}
            self.assertGreaterEqual(len(programs), count, page)
            self.assertLessEqual(len(programs[0].strip().split("\n")), 12, page)
            for k, program in enumerate(programs):
                if "libsph2d-render" in program and not common.CAN_DRAW:
                    continue
                out = io.StringIO()
                with contextlib.redirect_stdout(out):
                    exec(compile(program, f"{page}, program {k + 1}", "exec"), names)
                self.assertTrue("print" not in program or out.getvalue().strip(), (page, k))
            if page == "docs/python.md":
                self.assertGreater(names["sim"].body("raft").center[1], 0.68)  # the winch holds
                self.assertGreater(names["again"].time, names["snapshot"].info.time)

    def test_the_example_says_what_the_program_in_c_says(self):
        run = subprocess.run([sys.executable, common.ROOT / "examples/embed.py"], capture_output=True, text=True,
                             check=True, env={**os.environ, "PYTHONPATH": str(common.ROOT / "python")})
        self.assertRegex(run.stdout, r"^600 particles, front at 0\.\d{3} m, compression 0\.\d %\n$")
        program = common.LIBRARIES / "examples/embed"
        if not program.exists():
            self.skipTest("examples/embed is not built")
        self.assertEqual(run.stdout, subprocess.run([program], capture_output=True, text=True, check=True).stdout)

    def test_everything_is_named(self):
        with open(common.ROOT / "docs/python.md") as file:
            table = file.read().split("## What there is")[1]
        for name in sph2d.__all__:
            thing = getattr(sph2d, name)
            self.assertIn(f"`{name}", table)
            if not hasattr(thing, "_fields"):
                self.assertTrue(thing.__doc__, name)
            for member, value in vars(thing).items():
                if member.startswith("_") or not (callable(value) or isinstance(value, (property, staticmethod))):
                    continue
                self.assertTrue(inspect.getdoc(value), (name, member))
                self.assertIn(f"`{member}{'' if isinstance(value, property) else '()'}`", table)
        for name in ("Scene", "Simulation", "Snapshot", "Renderer"):
            given = re.search(rf"`{name}\((.*?)\)`", table).group(1).split(", ")
            self.assertEqual(given, list(inspect.signature(getattr(sph2d, name)).parameters), name)
        for name in (*sph2d.Particles.__slots__, *sph2d.Sample._fields):
            self.assertIn(f"`{name}`", table)


if __name__ == "__main__":
    unittest.main()
