#!/bin/sh
# docs/snapshots.md names every group, dataset and attribute that snapshots of all methods have, none that they do not,
# and its program runs.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
page=$SPH2D_ROOT/docs/snapshots.md

run() { # NAME SCENE OPTIONS...
    name=$1 scene=$2
    shift 2
    expect 0 "$SPH2D" run "$scene" -o "$name" --no-frames --quiet -s 'run={until: 0.02, snapshots: {every: 0.01}}' "$@"
}
for method in muller wcsph pcisph constraint; do
    run $method "$TINY" -s "method=$method" -s 'obstacles=[]' \
        -s 'probes=[{name: push, kind: force, on: bottom, every: 0.01}]'
done
run hybrid "$TINY" -s method=hybrid -s 'obstacles=[]'
cat >filled.yaml <<'END'
domain: {min: [0, 0], max: [0.4, 0.4]}
boundary: {top: wall}
wall_slip: none
spacing: 0.02
method: {operators: fitted}
blocks:
  - box: {min: [0, 0], max: [0.4, 0.4]}
sources: []
probes:
  - {name: gauge, kind: pressure, at: [0, 0.1], size: 0.05, rise_time: 0.01, every: 0.01}
END
run fitted filled.yaml
cat >channel.yaml <<'END'
domain: {min: [0, 0], max: [0.6, 0.4]}
spacing: 0.02
blocks:
  - {box: {min: [0, 0], max: [0.6, 0.2]}, color: teal}
probes:
  - {name: leaf, kind: tracer, at: [0.1, 0.1], every: 0.01}
openings:
  - {name: inlet, side: left, from: 0, to: 0.3, flow_rate: 0.02, free_surface: on}
  - {name: outlet, side: right, from: 0, to: 0.3, level: 0.2}
bodies:
  - {box: {min: [0.2, 0.15], max: [0.4, 0.25]}, density: 500}
END
run channel channel.yaml

# What the command itself tells, which needs no other tool.
for file in */snapshot_000001.h5; do
    "$SPH2D" info "$file" | sed -n 's/^  \([A-Z][A-Za-z0-9]*\)  .*/\1/p' >>names
done
sort -u names >unique
[ "$(wc -l <unique)" -gt 60 ] || fail 'info lists few names'
while read -r name; do
    grep -q "\`$name\`" "$page" || fail "docs/snapshots.md has no $name"
done <unique

python=
for candidate in python3 /usr/bin/python3; do
    ! "$candidate" -c 'import h5py, numpy' 2>/dev/null || python=$candidate
done
[ -n "$python" ] || { echo 'no h5py: the rest is left out' && exit 0; }
"$python" - "$page" ./*/snapshot_000001.h5 >&2 <<'END' || fail 'the page and the snapshots differ'
import re
import sys

import h5py
import numpy

page = open(sys.argv[1]).read()
prose = re.sub(r"^```.*?^```$", "", page, flags=re.M | re.S)
named = set(re.findall(r"`([^`]+)`", prose.replace("\n", " ")))
found = set()
for path in sys.argv[2:]:
    with h5py.File(path) as file:
        found |= set(file.attrs)

        def visit(name, item):
            group = item.parent.name
            found.add("/" + name if group == "/" else name.split("/")[-1])
            if name != "Parameters":
                found.update(item.attrs)

        file.visititems(visit)
        points = [file[g + "/Coordinates"] for g in ("PartType0", "PartType1", "Outlines")]
        assert (file["VTKHDF/Points"][:] == numpy.concatenate(points)).all()
        assert set(file["VTKHDF/PointData"]) <= set(file["PartType0"]) | {"Kinds"}
        # every array of the state has its unit in the table
        for name, unit in zip(file["State/Arrays"][:], file["State/ArrayUnits"][:]):
            name = name.decode().split("/")[-1]
            row = re.search(r"^\| `%s` \| ([^|]*)\|" % name, page, re.M)
            exponents = {"": (0, 0, 0), "m": (1, 0, 0), "s": (0, 0, 1), "m/s": (1, 0, -1), "m/s^2": (1, 0, -2),
                         "kg/m^3": (-3, 1, 0), "J/m": (1, 1, -2), "J/kg": (2, 0, -2), "kg/s": (0, 1, -1), "N/m": (0, 1, -2), "W/m": (1, 1, -3), "Pa": (-1, 1, -2),
                         "1/s": (0, 0, -1), "kg/(m^3 s)": (-3, 1, -1)}
            if not row or exponents[row.group(1).strip()] != tuple(unit):
                print(f"{name}: its row is missing or has another unit")
                sys.exit(1)
tables = set()
for line in page.splitlines():
    if line.startswith("| `"):
        tables |= set(re.findall(r"`([^`]+)`", line.split("|")[1]))
tables -= {"/"}
for name in sorted(found - named):
    print(f"not on the page: {name}")
for name in sorted(tables - found):
    print(f"in no snapshot: {name}")
sys.exit(bool(found - named or tables - found))
END
# shellcheck disable=SC2016 # the backquotes are those of the page
sed -n '/^```python$/,/^```$/{//!p; /^```$/q}' "$page" >program.py # the first
expect 0 "$python" "$SPH2D_ROOT/examples/read_snapshot.py" fitted/snapshot_000001.h5 && prints '^Coordinates '
rm out && mv fitted out && "$python" program.py >printed
grep -q 's, 400 particles, front at 0\.' printed || fail 'the program of the page prints something else'
