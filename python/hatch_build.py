# SPDX-License-Identifier: MIT
"""What `pip install .` does beside packing the module: the libraries, which `make` builds as always, in build/.

Settings of the Makefile are taken from the environment: RENDER=0 pip install ."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from packaging.tags import platform_tags


class Libraries(BuildHookInterface):
    def initialize(self, version, build_data):
        # They suit every version of Python 3, and this kind of machine; manylinux would promise that they need nothing
        # of its libraries.
        build_data["pure_python"] = False
        tag = next((tag for tag in platform_tags() if tag.startswith("linux_")), None)
        if tag is None or shutil.which("make") is None:
            sys.exit("sph2d: the libraries are built on Linux, by make: docs/installing.md")
        build_data["tag"] = f"py3-none-{tag}"
        self.folder = tempfile.TemporaryDirectory()
        # A module that is used where it is has them beside it.
        to = pathlib.Path(self.root, "python/sph2d/lib") if version == "editable" else pathlib.Path(self.folder.name)
        jobs = f"-j{len(os.sched_getaffinity(0))}"
        made = subprocess.run(["make", jobs, "DEPS=skip", f"TO={to}", "python-libraries"], cwd=self.root)
        if made.returncode:
            sys.exit("sph2d: make, which builds the libraries, failed: what it says above tells why, "
                     "docs/installing.md what it needs")
        if version != "editable":
            for file in to.iterdir():
                build_data["force_include"][str(file)] = f"sph2d/lib/{file.name}"

    def finalize(self, version, build_data, artifact_path):
        self.folder.cleanup()
