#!/bin/sh
# The wheel of the Python module, as pip builds and installs it: wheel.sh [--pypi] PYTHONS FOLDER
#
# It is installed into a new virtual environment and used from another folder, without variables that say where anything
# is: all programs of docs/python.md run, and tests of the module. By itself with Debian's packages, of the first of PYTHONS
# that has them, and what `make` has built. With --pypi from the source archive, which is compiled anew, and with packages of
# PyPI: Matplotlib and pandas are there, too, and mypy checks the programs of docs/python.md.
set -eu
pypi=
[ "$1" != --pypi ] || { pypi=1 && shift; }
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
pythons=$1 folder=$(realpath -m "$2")
unset SPH2D_LIBRARY_DIR PYTHONPATH PYTHONHOME LD_LIBRARY_PATH
export PYTHONDONTWRITEBYTECODE=1 PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_NO_INPUT=1 LC_ALL=C.UTF-8 MPLBACKEND=agg
rm -rf "$folder" && mkdir -p "$folder/elsewhere" && cd "$folder/elsewhere"

skip() {
    echo "skip python/wheel${pypi:+ --pypi} ($1)"
    exit 0
}
fail() {
    echo "FAIL python/wheel${pypi:+ --pypi}: $1" >&2
    exit 1
}
# quietly COMMAND...: its output only if it fails.
quietly() {
    "$@" >"$folder/log" 2>&1 </dev/null || { cat "$folder/log" >&2 && fail "$*"; }
}
# first MODULES: the first interpreter that has them.
first() {
    for p in $pythons; do
        ! "$p" -c "import $1" 2>/dev/null || { echo "$p" && return; }
    done
}

# ---- built and installed ---------------------------------------------------------------------------------------------
if [ -n "$pypi" ]; then
    unset MAKEFLAGS MFLAGS BUILD # of the folder that is tested
    made=$(first ensurepip)
    [ -n "$made" ] || skip 'no python3 makes virtual environments: apt install python3-venv'
    quietly "$made" -m venv "$folder/env"
    "$folder/env/bin/pip" -q --retries 1 install build mypy >"$folder/log" 2>&1 || skip 'PyPI cannot be reached'
    quietly "$folder/env/bin/python" -m build --sdist -o "$folder" "$root"
    quietly "$folder/env/bin/pip" wheel --no-deps -w "$folder" "$folder"/sph2d-*.tar.gz
else
    made=$(first 'ensurepip, hatchling, numpy')
    [ -n "$made" ] || skip 'no python3 has all it needs: apt install python3-hatchling python3-numpy python3-venv'
    quietly "$made" -m venv --system-site-packages "$folder/env"
    quietly "$folder/env/bin/pip" wheel --no-index --no-build-isolation --no-deps -w "$folder" "$root"
fi
version=$(sed -n 's/^#define SPH2D_VERSION "\(.*\)"/\1/p' "$root/include/sph2d/version.h")
wheel=$folder/sph2d-$version-py3-none-linux_$(uname -m).whl
[ -e "$wheel" ] || fail "no $wheel but $(echo "$folder"/*.whl)"
if [ -n "$pypi" ]; then
    quietly "$folder/env/bin/pip" install "${wheel}[plots]"
else
    quietly "$folder/env/bin/pip" install --no-index --no-deps "$wheel"
fi

# ---- used ------------------------------------------------------------------------------------------------------------
python=$folder/env/bin/python
cat >where.py <<'END'
import importlib.metadata, pathlib, sys
import sph2d
sim = sph2d.Simulation({"domain": {"min": [0, 0], "max": [1, 1]}, "spacing": 0.1, "fluid": {"dynamic_viscosity": 100},
                        "blocks": [{"box": {"min": [0, 0], "max": [0.4, 1]}}],
                        "bodies": [{"circle": {"center": [0.7, 0.5], "radius": 0.1}, "density": 500}]})
sim.step()
sim._repr_png_()
env = pathlib.Path(sys.argv[1]).resolve()
with open("/proc/self/maps") as maps:
    used = {pathlib.Path(line.split(maxsplit=5)[5].strip()).resolve() for line in maps if "/libsph2d" in line}
carried = set(pathlib.Path(sph2d.__file__).resolve().parent.glob("lib/*.so.0"))
assert used == carried and len(used) >= 3 and all(env in library.parents for library in used), (used, carried)
assert importlib.metadata.version("sph2d") == sys.argv[2] == sph2d.__version__
assert "numpy" in importlib.metadata.requires("sph2d")
END
quietly "$python" where.py "$folder/env" "$version"
for test in documentation notebook types simulation renderer; do
    quietly "$python" "$here/test_$test.py"
done
[ -n "$pypi" ] || { echo 'ok   python/wheel' && exit 0; }

# Each line of wrong.py is an error to mypy, and none of the page.
"$python" -c "import sys; sys.path.insert(0, '$here'); import test_documentation as t; print(*t.programs(), sep='\\n')" >page.py
cat >wrong.py <<'END'
import sph2d
sph2d.Simulation(3)
sph2d.Simulation("scene.yaml").run_to("1")
sph2d.Simulation("scene.yaml").summary().nothing
sph2d.Snapshot("a.h5").info.time.upper()
sph2d.Snapshot("a.h5").field("Velocities").mean()
sph2d.Renderer(style=1)
END
quietly "$folder/env/bin/mypy" --disable-error-code import-untyped "$root/python/sph2d"
quietly "$folder/env/bin/mypy" --strict page.py
! "$folder/env/bin/mypy" --strict wrong.py >"$folder/log" || fail 'mypy takes all'
[ "$(grep -c 'wrong.py:[2-7]: error' "$folder/log")" = 6 ] || { cat "$folder/log" >&2 && fail 'mypy finds other errors'; }
echo 'ok   python/wheel --pypi'
