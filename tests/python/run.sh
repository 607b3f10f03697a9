#!/bin/sh
# Tests of the Python module: run.sh PYTHON LIBRARIES [TEST...]
#
# PYTHON is an interpreter with NumPy, empty where there is none; LIBRARIES the folder of the shared libraries. A test is
# the name of one: test_views, test_views.Views.test_read_only.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
if [ -z "$1" ]; then
    echo 'skip python (no python3 with NumPy: apt install python3-numpy)'
    exit 0
fi
python=$1
SPH2D_LIBRARY_DIR=$(realpath "$2")
export SPH2D_LIBRARY_DIR
# What devices compile stays in the build.
export POCL_CACHE_DIR="${POCL_CACHE_DIR-$SPH2D_LIBRARY_DIR/pocl}"
# The caches of modules do not belong into the source, and freed memory has other bytes.
export PYTHONDONTWRITEBYTECODE=1 PYTHONMALLOC=debug MALLOC_PERTURB_=165 LC_ALL=C.UTF-8 MPLBACKEND=agg
shift 2
cd "$here"
if [ $# -gt 0 ]; then exec "$python" -W error -m unittest "$@"; fi
exec "$python" -W error -m unittest discover -q -s "$here"
