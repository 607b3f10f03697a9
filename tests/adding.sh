#!/usr/bin/env bash
# Are the diffs of docs/adding.md still true? Applies each to a copy of the tree, builds it without optimisation, and
# runs the indented line behind it: adding.sh FOLDER
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
mkdir -p "$1" && folder=$(cd "$1" && pwd)
rm -rf "${folder:?}"/*
awk -v folder="$folder" '
    /^```diff$/ { ++n; in_diff = 1; next }
    /^```$/ { if (in_diff) wait = 1; in_diff = 0; next }
    in_diff { print >(folder "/" n ".diff") }
    wait && /^    / { print substr($0, 5) >(folder "/" n ".run"); wait = 0 }' "$root/docs/adding.md"
ls "$folder"/*.diff >/dev/null
mkdir "$folder/tree"
(cd "$root" && git ls-files -z | xargs -0 tar cf -) | tar xf - -C "$folder/tree"
cd "$folder/tree"
git init -q . && git add -A
for diff in "$folder"/*.diff; do
    git apply "$diff"
    make -s -j"$(nproc)" DEPS=skip RENDER=0 X86= CFLAGS=-O1 V=0 build/sph2d build/tests/check_all >"${diff%.diff}.log" 2>&1 ||
        { tail -n 30 "${diff%.diff}.log" >&2 && exit 1; }
    ! grep 'warning:' "${diff%.diff}.log" || exit 1
    bash -euo pipefail -c "$(cat "${diff%.diff}.run")" >>"${diff%.diff}.log" 2>&1 ||
        { tail -n 30 "${diff%.diff}.log" >&2 && exit 1; }
    echo "adding: $(grep -c '^+++ ' "$diff") files, $(grep -c '^+[^+]' "$diff") lines: $(tail -n 1 "${diff%.diff}.log")"
    git checkout -q . && git clean -fdq -e build
done
