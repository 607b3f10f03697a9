#!/bin/sh
# Puts what the recipes of docs/recipes.md need beside this machine's own packages into a Python of their own:
# packages.sh PYTHON FOLDER. Later calls find it there; a folder that was left half done is done again.
set -eu
python=$1 folder=$2
[ ! -e "$folder/whole" ] || exit 0
rm -rf "$folder"
"$python" -m venv "$folder" || {
    echo "recipes: $python makes no virtual environment (Debian: apt install python3-venv)" >&2
    exit 2
}
"$folder/bin/pip" -q install h5py matplotlib pandas swiftsimio
# By itself vtk asks for packages that its readers do not use.
"$folder/bin/pip" -q install --no-deps vtk
: >"$folder/whole"
