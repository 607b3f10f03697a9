#!/bin/sh
# Studies: rows with overrides, errors beside speed, bounds that fail, faults with their places, a stop in the middle.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

cp "$TINY" scene.yaml
printf '# of nobody\nt,u [m/s]\n0,0\n0.2,nan\n0.3,0.5\n9,9\n' >points.csv
printf 'along,rho\n0.2,1\n0.8,1\n' >line.csv
cat >study.yaml <<'END'
scene: scene.yaml
runs:
  - {name: coarse, set: {spacing: 0.05, "blocks[0].velocity": [0.1, 0]}}
  - set:
      spacing: 0.04
      run.until: 0.3
  - {name: "costly, \"fine\"", set: {spacing: 0.03}, skip: true}
measures:
  - {name: top, probe: energy, column: kinetic, take: max, scale: 1000, expect: 0.1, order: true}
  - {name: late, probe: corner, column: speed, from: 0.1}
  - {name: speed, probe: corner, column: speed, reference: {file: points.csv, x: t, y: u}, norm: rms, bound: 1000}
  - name: density
    profile: {line: [[0.1, 0], [0.1, 0.2]], value: density}
    reference: {file: line.csv, x: along, y: rho}
    scale: 1000
END

# The table: a row each, in bars that are Markdown; nothing is written.
expect 0 "$SPH2D" study study.yaml --progress never
prints '^| row  *| front | CPU s | *top | *error | '
prints '| speed: rms error | density: max error | wall s | particles | steps | start s | probes s | particle-steps/s |$'
prints '^|-*|-*|-*:|' && prints '^| coarse ' && prints '^| spacing=0.04, until=0.3 | '
prints '^[0-9]* threads* (.*), [a-z0-9]*$' && says 'row 2 of 3: spacing=0.04' && says '1 row left out; --all'
prints "^No row has an error of 0.01 or less (top): the smallest is .*, by '.*' in [0-9.]* CPU s.$" && prints '; sph2d [0-9.]*, commit [0-9a-z]*.*; .*-O' && lines 8
[ "$(awk -F'|' '/^\|/ { print length($0), NF }' out | sort -u | wc -l)" = 1 ] || fail 'columns do not stand below each other'
grep '^| coarse' out | awk -F'|' '{ exit !($5 > 0 && $6 > 0 && $12 > 0 && $13 > 0 && $7 ~ /^ *- $/) }' || fail 'no numbers'
expect 0 "$SPH2D" study study.yaml --quiet && empty && silent
[ "$(find . -name '*.csv' | wc -l)" = 2 ] || fail 'something was written without -o'

# The same as JSON, with every row; overrides of the command line come last.
expect 0 "$SPH2D" study study.yaml --json --all --progress never --set run.until=0.1 -j 1 --isa baseline && lines 1
for key in study scene end passed threads isa rows row name set spacing particles time steps particle_steps \
    step_cpu_seconds step_seconds start_cpu_seconds probes_cpu_seconds particle_steps_per_second front left repeats jobs \
    measures value expect relative error bound order judge target cheapest processor compiler flags commit; do
    prints "\"$key\": "
done
prints '"name": "costly, \\"fine\\""' && prints '"isa": "baseline"' && prints '"blocks\[0\].velocity": "\[0.1, 0\]"'
if command -v python3 >/dev/null; then
    python3 -c 'import json; s = json.load(open("out")); assert [r["row"] for r in s["rows"]] == [1, 2, 3]
assert all(0.1 <= r["time"] < 0.2 for r in s["rows"]) and s["passed"] and s["end"] == "finished"' || fail 'JSON'
fi

# With -o: the numbers in full, the series as `run` writes them, and a page.
expect 0 "$SPH2D" study study.yaml -q -o out.study --all && empty && silent
[ "$(wc -l <out.study/study.csv)" = 4 ] || fail 'study.csv does not have three rows and a header'
head -n 1 out.study/study.csv |
    grep -q '^row,name,end,reason,front,spacing \[m\],.*,top,top error,top order,late,speed error,density' ||
    fail 'the header of study.csv'
grep -q '^3,"costly, ""fine""",finished,,[01],0.029999999999999999,' out.study/study.csv || fail 'a quoted name'
[ "$(find out.study -name 'series_*.csv' | wc -l)" = 9 ] || fail 'not a series for each of three probes a row'
[ "$(find out.study/rows -name '*.row' | wc -l)" = 3 ] || fail 'not a row each in rows/'
grep -q '<td class="word">costly, &quot;fine&quot;</td>' out.study/study.html || fail 'the page lacks a row'
present out.study/plots.gp
{ printf '# What the rows <are>.\n'; cat study.yaml; } >told.yaml
expect 0 "$SPH2D" study told.yaml -q -o told && grep -q '^<p>What the rows &lt;are&gt;.</p>$' told/study.html
expect 0 "$SPH2D" study study.yaml -q -o "it's" --set 'blocks[0].velocity=[0, 1]' --set run.until=0.1
sed -n "s/^<p><code>sph2d \(.*\) -o DIR<\/code><\/p>/\1/p" "it's/study.html" >words
eval "expect 0 \"\$SPH2D\" $(cat words) -q"
grep -q -- "--set 'blocks\[0\].velocity=\[0, 1\]' --set run.until=0.1" words || fail "the page's command: $(cat words)"
pictures() { # FOLDER NAME...
    folder=$1 && shift
    command -v gnuplot >/dev/null || return 0
    for plot; do
        head -c 200 "$folder/$plot.svg" | grep -q '<svg' || fail "$plot.svg is no picture"
        head -c 4 "$folder/$plot.png" | grep -q PNG || fail "$plot.png is no picture"
    done
}
pictures out.study error_time && absent out.study/error_along.svg # these rows differ in more than one key
expect 0 "$SPH2D" run scene.yaml -q --no-frames -o plain -s 'blocks[0].velocity=[0.1, 0]'
same plain/energy.csv out.study/series_1_energy.csv && same plain/corner.csv out.study/series_1_corner.csv

# Once more: nothing runs again, and the table is the same to the last digit. What is damaged or changed runs again, and
# only that.
cp out.study/study.csv before.csv
expect 0 "$SPH2D" study study.yaml --progress never -o out.study --all && says '3 rows were there already'
grep -q '^sph2d: row' err && fail 'a row ran again'
same before.csv out.study/study.csv
expect 0 "$SPH2D" study study.yaml -q -o out.study && [ "$(wc -l <out.study/study.csv)" = 3 ]
absent out.study/series_3_energy.csv
for row in out.study/rows/*.row; do break; done
head -c 2000 "$row" >damaged && cp damaged "$row"
expect 0 "$SPH2D" study study.yaml --progress never -o out.study --all && says '2 rows were there already'
[ "$(grep -c '^sph2d: row . of 3: ' err)" = 1 ] || fail 'a damaged row did not run again alone'
sed 's/spacing: 0.04$/spacing: 0.041/' study.yaml >changed.yaml
expect 0 "$SPH2D" study changed.yaml --progress never -o out.study --all
says 'row 2 of 3: spacing=0.041' && says '2 rows were there already'
expect 0 "$SPH2D" study study.yaml --progress never -o out.study -f && says 'row 1 of 3: coarse'
mkdir -p foreign/rows && : >foreign/series_1_mine.csv
expect 73 "$SPH2D" study study.yaml -o foreign && says 'F207' && present foreign/series_1_mine.csv

# Everything that a row depends on makes it run again: threads, instruction set, repeats, particles from a file.
sed 's/^blocks:/particles: many.csv\nblocks:/' scene.yaml >with.yaml
printf 'x,y\n0.2,0.8\n' >many.csv
printf 'scene: with.yaml\nmeasures: [{name: top, probe: energy, column: kinetic, take: max}]\n' >key.yaml
again() { expect 0 "$SPH2D" study key.yaml -o key -s method.sound_speed=20 --progress never "$@" && says 'row 1 of 1'; }
again -j 1 --isa baseline
"$SPH2D" --version | grep -q '^OpenMP *yes' && again -j 2 --isa baseline # else there is one thread
again -j 1 --isa baseline --repeat 2
printf 'x,y\n0.2,0.81\n' >many.csv
again -j 1 --isa baseline
expect 0 "$SPH2D" study key.yaml -o key -s method.sound_speed=20 -j 1 --isa baseline && says '1 row was there already'
printf 'x,y\n0.2,0.8\n' >many.csv
expect 0 "$SPH2D" study key.yaml -o key -s method.sound_speed=20 -j 1 --isa baseline && says '1 row was there already'

# Combinations, in processes beside each other; the best again with a finer spacing; the finest run as the reference.
cat >vary.yaml <<'END'
scene: scene.yaml
vary: {spacing: [0.05, 0.04], "blocks[0].velocity": [[0.1, 0], [0, 0]]}
refine: [{set: {spacing: 0.03}}, {set: {spacing: 0.02}, skip: true}]
measures:
  - {name: energy, probe: energy, column: kinetic, finest: true, norm: mean, relative: true, order: true}
  - {name: top, probe: energy, column: kinetic, take: max, finest: true, relative: true}
  - {name: line, profile: {line: [[0.1, 0.05], [0.1, 0.15]], value: speed}, finest: true}
target: 0.5
repeat: 2
END
expect 0 "$SPH2D" study vary.yaml --progress never -J 2 -o vary
says "row 4 of 4: spacing=0.04, velocity=\[0, 0\]" && says "row 5 of [5-6]: spacing=0.03, velocity=\[0"
says "stops before 'spacing=0.02'" && prints 'one a row, with --jobs' && prints 'least of 2 runs'
prints '2 rows at a time'
grep -q 'wall s' out && fail 'wall seconds of rows that ran beside each other'
prints '^For an error of 50 % (energy, against the finest row) the cheapest is ' && prints '^| spacing=0.03, velocity=.*|  *- |'
# What the front, the cheapest row and the order are, from the numbers themselves.
cat >judge.awk <<'AWK'
NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
{
    gsub(/"[^"]*"/, "name") # a name has commas
    name[NR] = $at["row"]; front[NR] = $at["front"]; dx[NR] = $at["spacing [m]"]; cpu[NR] = $at["cpu [s]"]
    error[NR] = $at["energy error"]; order[NR] = $at["energy order"]; last = NR
}
function is_number(x) { return x != "nan" }
END {
    for (i = 2; i <= last; i++) {
        on = is_number(error[i])
        for (k = 2; k <= last; k++)
            if (k != i && is_number(error[k]) && error[k] <= error[i] && cpu[k] <= cpu[i]) on = 0
        if (on != front[i]) { print "row " name[i] " is not rightly on or off the front"; bad = 1 }
        if (is_number(error[i]) && error[i] <= wanted && (best == "" || cpu[i] < cpu[best])) best = i
    }
    slope = log(error[2] / error[4]) / log(dx[2] / dx[4])
    if (sqrt((order[4] - slope) ^ 2) > 1e-9) { print "the order is not " slope; bad = 1 }
    print "cheapest " name[best]
    exit bad
}
AWK
awk -F, -v wanted=0.5 -f judge.awk vary/study.csv >judged || fail "$(cat judged)"
row=$(sed -n 's/^cheapest //p' judged)
name=$(grep "^$row," vary/study.csv | sed 's/^[0-9]*,"\([^"]*\)".*/\1/')
prints "the cheapest is '$(printf '%s' "$name" | sed 's/\[/\\[/g')'"
pictures vary error_time error_along
grep -q '^# .*scene.yaml with spacing=' vary/cheapest.yaml || fail 'no scene for the wanted error'
expect 0 "$SPH2D" check vary/cheapest.yaml
expect 0 "$SPH2D" study vary.yaml --progress never -J 2 -o vary --target 0.0001%
prints '^No row has an error of 0.0001 % or less (energy, against the finest row): the smallest is '
absent vary/cheapest.yaml
expect 64 "$SPH2D" study vary.yaml --set spacing=0.1 && says 'the study varies that key'
for target in 0 -1% x 1%% ''; do expect 64 "$SPH2D" study vary.yaml --target "$target" && says 'is not an error'; done
# Of a relative error 5 would be 500 %. An absolute one has the unit of its column.
expect 64 "$SPH2D" study scene.yaml --target 5 && says '500 %: write 5% or 0.05$'
expect 64 "$SPH2D" study scene.yaml --target 1 && says '100 %: write 1% or 0.01$'
expect 0 "$SPH2D" study study.yaml --repeat 3 --json -q && prints '"repeats": 3'
expect 64 "$SPH2D" study vary.yaml --repeat 0 && says 'from 1 to 100'
expect 64 "$SPH2D" study vary.yaml -J 0 && says 'from 1 to 1024'

# A scene instead of a study: its spacing and stiffness are varied, and the study is there to be changed.
expect 0 "$SPH2D" study scene.yaml --progress never -o made --target 90% --set run.until=0.05 --set spacing=0.04
present made/study.yaml && says 'row 7 of ' && prints '^For an error of 90 % (kinetic energy, against the finest row)' && present made/cheapest.yaml
expect 0 "$SPH2D" study made/study.yaml -q -s run.until=0.02
printf 'domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.1\nblocks: [{box: {min: [0, 0], max: [0.5, 0.5]}}]\n' >bare.yaml
expect 0 "$SPH2D" study bare.yaml -q -o bare --set run.until=0.02
grep -q 'kind: energy' bare/study.yaml || fail 'no probe'
cut -d, -f2 bare/study.csv | grep -q 'probes' && fail 'a name that tells what all rows have'
printf 'domain: {min: [0, 0], max: [1, 1]}\nspacign: 0.1\n' >wrong.yaml
expect 65 "$SPH2D" study wrong.yaml && says "^wrong.yaml:2:1: error\[S101\].*spacign"

# An error above its bound, and one that cannot be told: 1, with a sentence that names all.
cat >miss.yaml <<'END'
scene: scene.yaml
runs: [{set: {}}, {name: second, set: {spacing: 0.04}}]
measures:
  - {name: top, probe: energy, column: kinetic, take: max, expect: 1, relative: true, bound: 0.25}
  - {name: never, probe: energy, column: kinetic, take: crossing, level: -1, expect: 1, bound: 2}
  - {name: speed, probe: corner, column: speed, reference: {file: points.csv, x: t, y: u}, bound: 1e-9}
END
expect 1 "$SPH2D" study miss.yaml --progress never
says "row 'scene': 'top' is [0-9.]*, so its relative error [0-9.]* exceeds the bound 0.25" && prints '| relative error |'
says "row 'second': 'never' has no value" && says "no value of 'never': the series does not come to its level"
says "row 'second': the error [0-9.]* of 'speed' exceeds the bound 1e-09"
expect 1 "$SPH2D" study miss.yaml --json -q && prints '"passed": false' && prints '"value": null'

# A guard stops its row alone.
cat >guard.yaml <<'END'
scene: scene.yaml
runs: [{name: bad, set: {method.time_step: 0.2, run.until: 5}}, {name: good, set: {}}]
measures: [{name: top, probe: energy, column: kinetic, take: max}]
END
expect 1 "$SPH2D" study guard.yaml --progress never -o stopped
says "error\[R30[1-4]\].*row 'bad': " && prints '^| bad  *| guard  *|' && prints '^| good | finished | *[0-9.]* |'
present stopped/series_1_energy.csv && grep -q '^1,bad,guard,.*,0,[0-9.]*,.*,nan$' stopped/study.csv

# bad CODE PATTERN: the study on stdin is refused before anything runs.
bad() {
    cat >bad.yaml
    expect "$1" "$SPH2D" study bad.yaml -o refused && says "$2" && empty
    absent refused
}
runs='scene: scene.yaml
runs: [{set: {}}]
measures:
'
printf '%s  - {name: a, probe: enrgy, column: kinetic}\n' "$runs" |
    bad 65 "^bad.yaml:4:22: error\[S103\]: measures\[0\].probe: the scene has no probe 'enrgy'" && says "mean 'energy'"
printf '%s  - {name: a, probe: energy, column: mass}\n' "$runs" | bad 65 "^bad.yaml:4:38: .*no column 'mass'"
says 'its columns: kinetic, potential'
printf '%s  - {name: a, probe: energy, column: kinetic, take: value, at: 3}\n' "$runs" | bad 65 '4:64: .*after the end'
printf '%s  - {name: a, profile: {line: [[0, 0], [0, 3]], value: vx}, reference: {file: line.csv, x: along, y: rho}}\n' \
    "$runs" | bad 65 '^bad.yaml:4:31: error\[S107\]'
printf '%s  - {nme: a, probe: energy, column: kinetic}\n' "$runs" | bad 65 "^bad.yaml:4:6: error\[S101\]" && says S105
printf 'scene: scene.yaml\nruns: [{set: {spacign: 1}}]\n' | bad 65 '^bad.yaml:2:24: error\[S101\].*spacign'
says "did you mean 'spacing'"
printf 'scene: scene.yaml\nruns:\n  - {}\n  - set:\n      blocks[7].velocity: [0, 1]\n' | bad 65 '^bad.yaml:5:27: '
printf 'scene: nothing.yaml\nruns: [{set: {}}]\n' | bad 66 "F201.*nothing.yaml"
printf '%s  - {name: a, probe: energy, column: kinetic, reference: {file: nothing.csv, x: t, y: u}}\n' "$runs" |
    bad 66 'F201.*nothing.csv'
printf '%s  - {name: a, probe: energy, column: kinetic, reference: {file: points.csv, x: t, y: w}}\n' "$runs" |
    bad 65 "^points.csv:2:1: error\[F204\]: there is no column 'w'"
printf '' | bad 65 'S100'
expect 65 "$SPH2D" study study.yaml --set spacign=1 && says '^--set spacign=1: error\[S101\]'
expect 66 "$SPH2D" study nothing.yaml && says 'F201'
expect 64 "$SPH2D" study && says 'a study file must be given'
expect 64 "$SPH2D" study a b
expect 64 "$SPH2D" run "$TINY" --all && says 'not an option of this command'

# Liquid that is worth two threads: those of the study itself must not be missing in the rows.
cat >threads.yaml <<'END'
scene: scene.yaml
runs: [{set: {spacing: 0.003, run.until: 0.001}}, {set: {spacing: 0.0029, run.until: 0.001}}]
END
expect 0 "$SPH2D_ROOT/tests/limit.sh" 60 "$SPH2D" study threads.yaml -q --threads 2
expect 0 "$SPH2D_ROOT/tests/limit.sh" 60 env OMP_NUM_THREADS=2 "$SPH2D" study threads.yaml -q

# A signal in the second row: the first is in the table, and on disk.
cat >long.yaml <<'END'
scene: scene.yaml
runs: [{name: short, set: {}}, {name: long, set: {run.until: 1e5}}, {name: later, set: {}}]
measures: [{name: top, probe: energy, column: kinetic, take: max}]
END
env --default-signal=INT,TERM "$SPH2D" study long.yaml -o long -j 1 --progress never >out 2>err &
pid=$!
await grep -q 'row 2 of 3' err
sleep 0.2
kill -INT $pid
code=0
wait $pid || code=$?
[ $code = 130 ] || fail "SIGINT: ended with $code"
says "stopped in row 'long' at t = " && says '2 rows are missing; the same command goes on' && prints '^| short ' && lines 6
[ "$(wc -l <long/study.csv)" = 2 ] && present long/series_1_energy.csv && absent long/series_2_energy.csv
[ "$(find long -name '.*.tmp.*' | wc -l)" = 0 ] || fail 'temporary files are left'

# The first process that another one started.
child_of() {
    grep -l "^PPid:[[:space:]]*$1\$" /proc/[0-9]*/status 2>/dev/null | sed -n '1s|/proc/\(.*\)/status|\1|p'
}

# The same command goes on; so it does when the study was killed, and then its rows do not run on without it.
sed 's/run.until: 1e5/run.until: 0.1/' long.yaml >shorter.yaml
expect 0 "$SPH2D" study shorter.yaml -o long -j 1 --progress never && says 'row 2 of 3'
says '2 rows were there already' && [ "$(wc -l <long/study.csv)" = 4 ] # the third is the first once more
: >err
"$SPH2D" study long.yaml -o killed -j 1 --progress never >out 2>err &
pid=$!
await grep -q 'row 2 of 3' err
child=$(child_of $pid)
kill -KILL $pid
wait $pid || true
[ -n "$child" ] || fail 'the row has no process of its own'
has_ended() { ! grep -q '^State:[[:space:]]*[RSD]' "/proc/$1/status" 2>/dev/null; }
await has_ended "$child"
expect 0 "$SPH2D" study shorter.yaml -o killed -j 1 --progress never
says '2 rows were there already' && [ "$(wc -l <killed/study.csv)" = 4 ]

# A row whose process dies is a row that says so, and the others go on.
cat >die.yaml <<'END'
scene: scene.yaml
runs: [{name: endless, set: {run.until: 1e5}}, {name: fine, set: {}}]
measures: [{name: top, probe: energy, column: kinetic, take: max}]
END
for signal in KILL TERM; do
    : >err
    "$SPH2D" study die.yaml -j 1 --progress never >out 2>err &
    pid=$!
    await grep -q 'row 1 of 2' err
    has_child() { child=$(child_of $pid) && [ -n "$child" ]; }
    await has_child
    sleep 0.1
    kill -$signal "$child"
    code=0
    wait $pid || code=$?
    [ $code = 70 ] || fail "a row that died: ended with $code"
    says "row 'endless': .*its process" && prints '^| endless | died ' && prints '^| fine  *| finished '
done

# Nowhere to write.
code=0
"$SPH2D" study study.yaml -q --json >/dev/full 2>err || code=$?
[ $code = 74 ] || fail "a full stdout ended with $code"
printf '%s  - {name: a, probe: energy, column: kinetic}\n' "$runs" >one.yaml
(ulimit -f 1 && exec "$SPH2D" study one.yaml -q -o full) 2>err && fail 'a full disk is no success'
says 'F206.*full/'
[ "$(find full -type f -name '.*' | wc -l)" = 0 ] || fail 'temporary files are left'
