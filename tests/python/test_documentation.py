"""The programs of the pages run, and the page of the module names all of it."""
import contextlib
import io
import os
import re
import subprocess
import sys
import unittest

import api
import common
from common import sph2d

PAGE = "docs/python.md"


def programs():
    with open(common.ROOT / PAGE) as file:
        return re.findall(r"^```python\n(.*?)^```$", file.read(), re.DOTALL | re.MULTILINE)


class Documentation(common.InFolder):
    def test_programs_run(self):
        common.ignore_warnings(self)
        found, names = programs(), {}
        self.assertGreaterEqual(len(found), 10)
        self.assertLessEqual(len(found[0].strip().split("\n")), 12)
        for k, program in enumerate(found):
            needs = {"libsph2d-render": common.CAN_DRAW, "Matplotlib and pandas": common.has("matplotlib", "pandas")}
            if any(f"# needs {what}" in program and not there for what, there in needs.items()):
                continue
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                exec(compile(program, f"{PAGE}, program {k + 1}", "exec"), names)
            self.assertTrue("print" not in program or out.getvalue().strip(), k)
            if "a winch lowers it" in program:
                self.assertGreater(names["sim"].body("raft").center[1], 0.68)
        self.assertGreater(names["again"].time, names["snapshot"].info.time)

    def test_the_example_says_what_the_program_in_c_says(self):
        run = subprocess.run([sys.executable, common.ROOT / "examples/embed.py"], capture_output=True, text=True,
                             check=True, env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
        self.assertRegex(run.stdout, r"^600 particles, front at 0\.\d{3} m, compression 0\.\d %\n$")
        program = common.LIBRARIES / "examples/embed"
        if not program.exists():
            self.skipTest("examples/embed is not built")
        self.assertEqual(run.stdout, subprocess.run([program], capture_output=True, text=True, check=True).stdout)

    def test_the_reference_is_that_of_the_module(self):
        with open(common.ROOT / PAGE) as file:
            page = file.read().split("<!-- api -->\n")[1].split("<!-- end of api -->")[0]
        self.assertEqual(page, api.page(), "make python-docs renews it")
        for name in sph2d.__all__:
            self.assertIn(f"`{name}", page)

    def test_all_has_a_sentence(self):
        for name, thing in api.public():
            self.assertRegex(api.sentence(thing), r"^[A-Z].*\.$", name)


if __name__ == "__main__":
    unittest.main()
