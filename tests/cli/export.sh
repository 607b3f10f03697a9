#!/bin/sh
# Snapshots as CSV and as poly data for VTK: whole, by their numbers, to the last bit; as the input of another scene, and
# as a series.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

expect 64 "$SPH2D" export && says 'a snapshot must be given'
expect 64 "$SPH2D" export a.h5 b.h5 && says 'one snapshot must be given'
expect 64 "$SPH2D" export a.h5 b.h5 -o a.vtp && says 'several become a series by -o FILE.pvd'
expect 64 "$SPH2D" export a.h5 -o a.vtk && says "'a.vtk' must end in .csv, .vtp or .pvd"
expect 64 "$SPH2D" export a.h5 -o .vtp
expect 66 "$SPH2D" export missing.h5 && empty
expect 65 "$SPH2D" export "$TINY" -o a.csv && absent a.csv
expect 0 "$SPH2D" run "$TINY" -o run --no-frames -q -s run.until=0.2
for snapshot in run/snapshot_*.h5; do :; done # the last
expect 0 "$SPH2D" export "$snapshot" && silent
head -n 1 out | grep -q '^id,x \[m\],y \[m\],vx \[m/s\],vy \[m/s\],density \[kg/m^3\],pressure \[Pa\],mass \[kg/m\],ax' ||
    fail 'the headings are others'
count=$("$SPH2D" info "$snapshot" | sed -n '/^fluid/,/^wall/s/^  Densities *f64 *\([0-9]*\) x.*/\1/p')
[ "$count" -gt 100 ] && lines $((count + 1))
awk -F, 'NR == 1 { n = NF } NF != n { exit 1 } NR > 2 && $1 <= last { exit 1 } { last = $1 }' out ||
    fail 'rows are broken, or not in the order of numbers'
mv out printed
expect 0 "$SPH2D" export "$snapshot" -o a.csv && says "wrote $count particles to 'a.csv'" && empty && same printed a.csv
expect 0 "$SPH2D" export "$snapshot" -o a.csv -q && silent && same printed a.csv

# A scene of these particles has them to the last bit.
cat >again.yaml <<'END'
domain: {min: [0, 0], max: [1, 1]}
spacing: 0.05
method: {name: wcsph, sound_speed: 40}
particles: a.csv
run: {until: 1e-9, snapshots: {every: 1}}
END
cut -d, -f2-5 a.csv | LC_ALL=C sort >before
expect 0 "$SPH2D" run again.yaml -o again -q
"$SPH2D" export again/snapshot_000000.h5 | cut -d, -f2-5 | LC_ALL=C sort | cmp before - || fail 'other particles'

# What another program changed, a folder that is missing, and a disk that is full.
cp "$snapshot" changed.h5 && printf x >>changed.h5
expect 65 "$SPH2D" export changed.h5 -o changed.csv && absent changed.csv
expect 0 "$SPH2D" export changed.h5 -o changed.csv --no-checksum && same changed.csv a.csv
expect 73 "$SPH2D" export "$snapshot" -o missing/a.csv
(trap '' XFSZ && ulimit -f 16 && expect 74 "$SPH2D" export "$snapshot" -q -o a.csv) || fail 'no room'
same printed a.csv
if [ -w /dev/full ]; then
    code=0 && "$SPH2D" export "$snapshot" >/dev/full 2>err || code=$?
    [ $code = 74 ] && says 'cannot write to standard output'
fi

# Poly data for VTK: what it is made of follows from its header, and every bit of CSV is in it.
expect 0 "$SPH2D" export "$snapshot" -o a.vtp && says "points to 'a.vtp'" && empty
if command -v python3 >/dev/null; then
    cat >read.py <<'END'
import csv, math, struct, sys, xml.etree.ElementTree as xml

data = open("a.vtp", "rb").read()
begin, end = data.index(b"_", data.index(b"<AppendedData")) + 1, data.rindex(b"</AppendedData>")
head = xml.fromstring(data[:begin - 1] + data[end:])        # the values are no XML
assert head.get("byte_order") == {"little": "LittleEndian", "big": "BigEndian"}[sys.byteorder]
assert head.get("header_type") == "UInt64"
piece, blocks, used = head.find("PolyData/Piece"), {}, 0
for section in [head.find("PolyData/FieldData"), *piece]:
    for array in section:
        size, at = struct.unpack_from("Q", data, begin + int(array.get("offset")))[0], begin + int(array.get("offset")) + 8
        letter = {"Float64": "d", "UInt64": "Q", "Int64": "q", "UInt8": "B"}[array.get("type")]
        values = struct.unpack_from(f"{size // struct.calcsize(letter)}{letter}", data, at)
        width = int(array.get("NumberOfComponents"))
        blocks[section.tag, array.get("Name")] = [values[i:i + width] for i in range(0, len(values), width)]
        assert at + size <= end
        used += 8 + size
assert data[begin + used:end] == b"\n", "gaps or values that overlap"
count = {name: int(piece.get("NumberOf" + name)) for name in ("Points", "Verts", "Lines", "Strips", "Polys")}
for (section, name), block in blocks.items():
    if section in ("PointData", "Points"):
        assert len(block) == count["Points"], name
kinds = [kind for kind, in blocks["PointData", "Kinds"]]
liquid, walls, corners = (kinds.count(kind) for kind in range(3))
assert kinds == liquid * [0] + walls * [1] + corners * [2] and walls > 0 and corners > 0

# The cells: each particle; each outline, whose corners follow each other.
seen = []
for name in ("Verts", "Lines", "Polys"):
    ends = [end for end, in blocks[name, "offsets"]]
    numbers = [number for number, in blocks[name, "connectivity"]]
    assert len(ends) == count[name] and ends == sorted(ends) and (ends or [0])[-1] == len(numbers)
    seen += numbers
assert sorted(seen) == list(range(count["Points"])), "a point is in no cell, or in two"
assert count["Verts"] == liquid + walls and count["Polys"] + count["Lines"] > 0
assert count["Polys"] + count["Lines"] == len({i for i, in blocks["PointData", "OutlineIDs"][-corners:]})

# The liquid, to the last bit, and NaN where a kind of points has no such field.
names = {"id": ("ParticleIDs", 0), "vx": ("Velocities", 0), "vy": ("Velocities", 1), "density": ("Densities", 0),
         "pressure": ("Pressures", 0), "mass": ("Masses", 0), "ax": ("Accelerations", 0), "ay": ("Accelerations", 1)}
rows = list(csv.reader(open("a.csv")))
heads = [head.split(" ")[0] for head in rows[0]]
assert len(rows) == liquid + 1
for i, row in enumerate(rows[1:]):
    values = dict(zip(heads, row))
    assert tuple(map(float, (values.pop("x"), values.pop("y"), 0))) == blocks["Points", "Coordinates"][i]
    values.pop("support_radius")
    for name, value in values.items():
        array, component = names.get(name) or (name[:-2] if name[-2:] in ("_x", "_y") else name, int(name.endswith("_y")))
        assert float(value) == blocks["PointData", array][i][component], name
assert all(math.isnan(x) for x, _, _ in blocks["PointData", "Velocities"][liquid + walls:])
assert all(i == 2**64 - 1 for i, in blocks["PointData", "WallIDs"][:liquid + walls])
print(repr(blocks["FieldData", "TimeValue"][0][0]))
END
    python3 read.py >moment || fail "a.vtp: $(cat moment)"
fi

# A run as a series: files of its snapshots, and their times, which begin with 0; the same from its files one by one.
expect 0 "$SPH2D" export run -o 'b&"c.pvd' && empty
count=0
for file in run/snapshot_*.h5; do
    "$SPH2D" export "$file" -q -o one.vtp
    same one.vtp "$(printf 'b&"c_%06d.vtp' $count)"
    count=$((count + 1))
done
[ $count -gt 2 ] || fail 'too few snapshots for a series'
[ "$(grep -c '<DataSet ' 'b&"c.pvd')" = $count ] || fail 'not all snapshots'
grep -q 'timestep="0" part="0" file="b&amp;&quot;c_000000.vtp"/>' 'b&"c.pvd' || fail 'no first time'
[ ! -s moment ] || grep -q "timestep=\"$(cat moment)\"" 'b&"c.pvd' || fail 'another time than that of the last file'
if command -v python3 >/dev/null; then
    python3 - <<'END' || fail 'no XML, or times that do not rise'
import os, xml.etree.ElementTree as xml
sets = list(xml.parse('b&"c.pvd').getroot().iter("DataSet"))
times = [float(s.get("timestep")) for s in sets]
assert times == sorted(set(times)) and all(os.path.exists(s.get("file")) for s in sets)
END
fi
expect 0 "$SPH2D" export run/snapshot_*.h5 -o sub.pvd && says "wrote $count snapshots to 'sub_\*.vtp'"
mkdir inner && expect 0 "$SPH2D" export run -q -o inner/sub.pvd && silent && same inner/sub.pvd sub.pvd

# Without snapshots, room or a folder, or with one that is broken: no series, and nothing in part.
mkdir bare && expect 66 "$SPH2D" export bare -o none.pvd && absent none.pvd && absent none_000000.vtp
expect 73 "$SPH2D" export run -o missing/a.pvd
cp sub.pvd kept.pvd
(trap '' XFSZ && ulimit -f 16 && expect 74 "$SPH2D" export run -q -o sub.pvd) || fail 'no room'
same sub.pvd kept.pvd
expect 65 "$SPH2D" export run changed.h5 -o broken.pvd && absent broken.pvd && present broken_000000.vtp
[ -z "$(find . -name '.*.tmp.*')" ] || fail 'temporary files are left'

# A signal ends a series after the file at work.
set --
while [ $# -lt 100 ]; do set -- "$@" run; done
"$SPH2D" export "$@" -o long.pvd 2>err &
await test -e long_000003.vtp
kill -TERM $!
code=0 && wait $! || code=$?
[ $code = 143 ] || fail "a signal ended it with $code"
says 'stopped by SIGTERM after' && absent long.pvd
[ -z "$(find . -name '.*.tmp.*')" ] || fail 'temporary files are left'
