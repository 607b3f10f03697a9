#!/bin/bash
# Long: a study whose rows are run by several processes on one folder: together they come to what one process does, whoever of
# them is killed, comes twice or comes last.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

cp "$TINY" scene.yaml
# Twelve rows, of which the seventh takes about a second: shard 3 of 4 has the rows 3, 7 and 11.
{
    printf 'scene: scene.yaml\nruns:\n'
    for row in 1 2 3 4 5 6 7 8 9 10 11 12; do
        until=0.2
        [ $row != 7 ] || until=4
        printf '  - {name: row %s, set: {spacing: %s, run.until: %s}}\n' $row "$(awk "BEGIN { print 0.052 - 0.002 * $row }")" $until
    done
    cat <<'YAML'
measures:
  - {name: top, probe: energy, column: kinetic, take: max, scale: 1000, expect: 0.1, order: true}
  - {name: curve, probe: energy, column: potential, finest: true, norm: mean, relative: true, order: true}
YAML
} >study.yaml
expect 0 "$SPH2D" study study.yaml -q -j 1 -o one

# On machines of their own processes have the same id: so they do here, in name spaces of their own.
machine=() apart=()
! unshare --pid --fork true 2>/dev/null || apart=(unshare --pid --fork)
# start NAME ARGUMENTS...: a study in the background, as $pid, with what it prints in NAME.out and NAME.err.
start() {
    name=$1
    shift
    "${machine[@]}" env --default-signal=INT,TERM "$SPH2D" study "$@" --progress never >"$name.out" 2>"$name.err" </dev/null &
    pid=$!
}
# end CODE NAME PID: it ends so; what it printed is the files out and err.
end() {
    code=0
    wait "$3" || code=$?
    cp "$2.out" out && cp "$2.err" err
    [ $code = "$1" ] || fail "$2 ended with $code, not $1"
}

# alike A B: the same rows, numbers and series; times alone may differ.
alike() {
    for folder in "$1" "$2"; do
        awk -f "$SPH2D_ROOT/tests/cli/without_times.awk" "$folder/study.csv" >"rows_of_$folder"
        find "$folder" -maxdepth 1 -type f -name 'series_*' -printf '%f\n' | sort >"series_of_$folder"
    done
    same "rows_of_$1" "rows_of_$2" && same "series_of_$1" "series_of_$2"
    while read -r file; do same "$1/$file" "$2/$file"; done <"series_of_$1"
    for file in study.html plots.gp plots.dat; do [ ! -e "$1/$file" ] || present "$2/$file"; done
}
# How many rows the last command ran.
ran() { [ "$(grep -c '^sph2d: row [0-9]* of [0-9]*: ' err)" = "$1" ] || fail "not $1 rows ran"; }

# Four at once, on a folder that none of them finds there. One is killed in its second row; the others end well, and say
# what is missing.
for shard in 1 2 3 4; do
    start "shard$shard" study.yaml -o many --shard $shard/4
    pids[shard]=$pid
done
await grep -qs '^sph2d: row 7 of 12: ' shard3.err
kill -KILL "${pids[3]}"
for shard in 1 2 4; do
    end 0 "shard$shard" "${pids[shard]}" && empty && ran 3
    says '^sph2d: no table yet: rows [0-9,-]* of shards\? [0-9,-]* are missing$'
done
cat shard[124].err >err && says 'yet: rows \(3,\)\?7,11 of shard 3 are missing$'
end 137 shard3 "${pids[3]}" && empty
absent many/study.csv
# The table comes with the last of them. What was done already, the killed one's first row too, is not run again.
expect 0 "$SPH2D" study study.yaml -o many --shard 3/4 --progress never
says '^sph2d: 1 row was there already' && ran 2 && prints '^| row 12 '
prints "^each shard's own threads, [a-z0-9]*, 12 rows by shards, perhaps on other processors: CPU seconds alone$"
alike one many
[ "$(find many/rows -name '*.row' | wc -l)" = 12 ] || fail 'not a file for each row'
[ "$(cut -d, -f1,14 many/study.csv | sed -n 2p)" = 1,nan ] || fail 'wall seconds of rows that ran beside others'
# And any other call makes it again, with any number of threads, without a run.
cp many/study.csv before.csv
for option in '-j 1' '-j 2' '-J 2' '--shard 2/4' '--shard 5/7 -J 2'; do
    rm many/study.csv
    # shellcheck disable=SC2086 # options and their values are words
    expect 0 "$SPH2D" study study.yaml -o many --progress never $option && prints '^| row 12 ' && ran 0
    same before.csv many/study.csv
done
expect 0 "$SPH2D" study study.yaml -o many -q --json && prints '"rows_by_shards": 12'
# A row whose file is damaged is missing, until its shard has run it again.
for file in many/rows/*.row; do break; done
head -c 2000 "$file" >damaged && cp damaged "$file"
for shard in 1 2 3 4; do
    expect 0 "$SPH2D" study study.yaml -o many --shard $shard/4 --progress never && cat err >&3
done 3>all.err
cp all.err err && ran 1
alike one many
# --force is for a shard's own rows.
expect 0 "$SPH2D" study study.yaml -o many --shard 4/4 --force --progress never && ran 3
alike one many

# Short rows: all shards end at the same time, so that several may make the table, and two have the same rows. Five
# times, from a folder that is not there.
cat >short.yaml <<'YAML'
scene: scene.yaml
vary: {spacing: [0.05, 0.04], fluid.dynamic_viscosity: [12, 13]}
measures: [{name: top, probe: energy, column: kinetic, take: max, scale: 1000, expect: 0.1, order: true}]
YAML
expect 0 "$SPH2D" study short.yaml -q -j 1 -o short_one
for round in 1 2 3 4 5; do
    folder=deep/$round/short
    [ $((round % 2)) = 1 ] || machine=("${apart[@]}")
    for shard in 1 2 3 4 5; do # the fifth is the fourth once more
        start "shard$shard" short.yaml -o $folder --shard $((shard < 5 ? shard : 4))/4
        pids[shard]=$pid
    done
    machine=()
    for shard in 1 2 3 4 5; do end 0 "shard$shard" "${pids[shard]}"; done
    cat shard?.out >out && prints '^| spacing=0.04, dynamic_viscosity=13 '
    mv $folder "short_$round" && alike short_one "short_$round"
    [ "$(find "short_$round" -name '.*' | wc -l)" = 0 ] || fail 'temporary files are left'
done
# More shards than rows, and a study of one row.
expect 0 "$SPH2D" study short.yaml -o few --shard 1000000/1000000 --progress never && empty
says 'shard 1000000 of 1000000 has no row of 4' && says 'yet: rows 1-4 of shards 1-4 are missing$'
printf 'scene: scene.yaml\nmeasures: [{name: top, probe: energy, column: kinetic, take: max}]\n' >single.yaml
expect 0 "$SPH2D" study single.yaml -o single --shard 2/2 --progress never && empty && says 'yet: row 1 of shard 1 is missing$'
expect 0 "$SPH2D" study single.yaml -o single --shard 1/2 && prints '^| scene '
expect 0 "$SPH2D" study single.yaml -o single --shard 2/2 && prints '^| scene '
expect 0 "$SPH2D" study single.yaml -o single_one --shard 1/1 && prints '^| scene ' && alike single single_one
# Rows of each side run beside each other.
expect 0 "$SPH2D" study short.yaml -o beside --shard 1/2 -J 2 --progress never && ran 2 && says 'row [13] of 4 done'
expect 0 "$SPH2D" study short.yaml -o beside --shard 2/2 -J 2 --progress never && ran 2 && alike short_one beside

# A list of missing rows that is too long is cut.
{
    printf 'scene: scene.yaml\nruns:\n'
    for _ in $(seq 100); do printf '  - {}\n  - {skip: true}\n'; done
} >many.yaml
expect 0 "$SPH2D" study many.yaml -o cut --shard 201/201 --progress never
says 'yet: rows 1,3,5,[0-9,]*,\.\.\. of shards 1,3,5,[0-9,]*,\.\.\. are missing$'

# As JSON: what is missing, then all.
expect 0 "$SPH2D" study short.yaml -o told --shard 2/2 -q --json && lines 1
prints '"end": "finished", "passed": true, "shard": 2, "shards": 2, "missing": \[1, 3\]}$'
expect 0 "$SPH2D" study short.yaml -o told --shard 1/2 -q --json && lines 1 && prints '"rows_by_shards": 4, .*"rows": \[{'

# What one process has done counts for the shards that go on.
cp -r one mixed && rm mixed/study.csv
for shard in 1 2; do
    expect 0 "$SPH2D" study study.yaml -o mixed --shard $shard/2 -j 1 --progress never && ran 0
done
alike one mixed

# Refinements follow from the rows before: the shards come once more for them.
cat >refine.yaml <<'YAML'
scene: scene.yaml
vary: {spacing: [0.05, 0.04], fluid.dynamic_viscosity: [12, 14]}
refine: [{set: {spacing: 0.035}}, {set: {spacing: 0.03}}]
measures: [{name: energy, probe: energy, column: kinetic, finest: true, norm: mean, relative: true, bound: 1}]
YAML
rounds=0
until [ -e refine/study.csv ]; do
    rounds=$((rounds + 1))
    [ $rounds -le 4 ] || fail 'shards do not come to the end of the refinements'
    for shard in 1 2 3; do
        expect 0 "$SPH2D" study refine.yaml -o refine --shard $shard/3 --progress never
        [ -e refine/study.csv ] || says 'no table yet'
    done
done
[ "$(wc -l <refine/study.csv)" -gt 6 ] || fail 'no row of a refinement'
cp refine/study.csv before.csv
expect 0 "$SPH2D" study refine.yaml -o refine --progress never && ran 0
same before.csv refine/study.csv
# So do those of a study that is made for a scene.
for round in 1 2; do
    for shard in 1 2; do
        expect 0 "$SPH2D" study scene.yaml -o made --shard $shard/2 --progress never -s run.until=0.05 -s spacing=0.04
    done
done
expect 0 "$SPH2D" study scene.yaml -o made --progress never -s run.until=0.05 -s spacing=0.04 && present made/study.yaml

# A shard answers for its own rows: a bound that is missed, a guard, a process that dies.
cat >bad.yaml <<'YAML'
scene: scene.yaml
runs: [{name: fine, set: {}}, {name: missed, set: {spacing: 0.03}}, {name: wild, set: {method.time_step: 0.2, run.until: 5}}]
measures: [{name: top, probe: energy, column: kinetic, take: max, expect: 210, relative: true, bound: 0.1}]
YAML
expect 1 "$SPH2D" study bad.yaml -o bad --shard 2/3 --progress never && empty
says "row 'missed': 'top' is .* exceeds the bound 0.1" && says 'yet: rows 1,3 of shards 1,3 are missing$'
expect 1 "$SPH2D" study bad.yaml -o bad --shard 3/3 --progress never && empty && says "error\[R30[1-4]\].*row 'wild': "
says 'yet: row 1 of shard 1 is missing$'
expect 0 "$SPH2D" study bad.yaml -o bad --shard 1/3 --progress never && prints '^| wild *| guard '
! grep -q 'wild\|missed' err || fail 'a shard answers for the rows of others'
expect 1 "$SPH2D" study bad.yaml -o bad --progress never && ran 0 && says "'wild', run earlier" && says 'exceeds the bound'
sed 's/^runs: .*/runs: [{name: endless, set: {run.until: 1e5}}, {name: fine, set: {}}]/' bad.yaml >die.yaml
start dying die.yaml -o dying --shard 1/2
await grep -qs 'row 1 of 2' dying.err
child=
until [ -n "$child" ]; do
    child=$(grep -l "^PPid:[[:space:]]*$pid\$" /proc/[0-9]*/status 2>/dev/null | sed -n '1s|/proc/\(.*\)/status|\1|p')
done
kill -KILL "$child"
end 70 dying $pid && empty && says "row 'endless': its process was ended by signal 9"
says 'yet: rows 1-2 of shards 1-2 are missing$'

# While a shard runs the folder is for shards alone. A signal stops it.
start shared die.yaml -o shared --shard 1/2
await grep -qs 'row 1 of 2' shared.err
if grep -qs FLOCK /proc/$pid/fdinfo/*; then # some file systems have no locks
    expect 73 "$SPH2D" study die.yaml -q -o shared && says "another sph2d is writing to 'shared'"
    expect 73 "$SPH2D" study die.yaml -q -o shared --force && says "another sph2d is writing to 'shared'"
    expect 73 "$SPH2D" run scene.yaml -q -o shared --force && says "another sph2d is writing to 'shared'"
fi
expect 0 "$SPH2D" study die.yaml -q -o shared --shard 2/2
kill -INT $pid
end 130 shared $pid && empty && says "stopped in row 'endless'" && says '1 row is missing; the same command goes on'
start whole die.yaml -o whole -j 1
await grep -qs 'row 1 of 2' whole.err
if grep -qs FLOCK /proc/$pid/fdinfo/*; then
    expect 73 "$SPH2D" study die.yaml -q -o whole --shard 1/2 && says "another sph2d is writing to 'whole'"
fi
kill -TERM $pid
end 143 whole $pid

# The folder: temporary files may be another's, unless they are old; one of nobody's is not taken.
mkdir -p left/rows
touch left/rows/.README.tmp.12
expect 0 "$SPH2D" study single.yaml -q -o left --shard 1/1
touch -d '2 days ago' left/rows/.0.row.tmp.12 left/.study.csv.tmp.12
expect 0 "$SPH2D" study single.yaml -o left --shard 1/1 --progress never && present left/rows/.README.tmp.12
says "removed 1 unfinished file of an earlier run from 'left/rows/'"
absent left/rows/.0.row.tmp.12 && absent left/.study.csv.tmp.12
mkdir -p foreign/rows foreign2/rows && : >foreign/rows/mine && : >foreign2/mine
for folder in foreign foreign2; do
    expect 73 "$SPH2D" study single.yaml -q -o $folder --shard 1/1 && says 'F207'
done

# Nonsense.
for shard in 0/4 5/4 1/0 a/b 1/4/2 1 / 1/ /4 '' -1/4 1/-4 1.5/4 ' 1/4' '1/ 4' 1/1000001 1/99999999999999999999; do
    expect 64 "$SPH2D" study single.yaml -o nonsense --shard "$shard"
    says "shard: '$shard' is not I/N, with I from 1 to N" && absent nonsense
done
expect 64 "$SPH2D" study single.yaml --shard 1/2 && says 'shard needs -o DIR'
expect 64 "$SPH2D" run scene.yaml -o nonsense --shard 1/2 && says 'not an option of this command'
expect 64 "$SPH2D" study single.yaml --shard && says 'needs an argument'
