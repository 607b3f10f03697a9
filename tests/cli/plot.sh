#!/bin/sh
# Plots of the series of a run: what is drawn, what cannot be, and that a picture is there whole or not at all.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"

expect 64 "$SPH2D" plot && says 'the folder of a run must be given'
expect 66 "$SPH2D" plot missing && says "cannot read the folder 'missing'"
mkdir empty && expect 66 "$SPH2D" plot empty && says "'empty' has no series of probes" && says 'hint: .*kind: energy'
expect 64 "$SPH2D" plot empty -o picture.pdf && says "'picture.pdf' must end in .svg or .png"
mkdir odd
printf 'time [s],a [m],b [m],c\n' >odd/none.csv
expect 65 "$SPH2D" plot odd && says "none: 'a \[m\]' has no value yet" && says 'have no values yet'
printf 'x,y\n1,2\n' >odd/other.csv
expect 65 "$SPH2D" plot odd other && says "'odd/other.csv': it is no series"
expect 66 "$SPH2D" plot odd othre && says "no series 'othre.csv'; did you mean 'other'"
expect 66 "$SPH2D" plot empty x && says "no series 'x.csv'"
printf 'time [s],a [m]\n0,1\n1,two\n' >odd/none.csv
expect 65 "$SPH2D" plot odd && says 'odd/none.csv:3:'

# Without gnuplot there is a word, and no picture.
mkdir one tools
printf 'time [s],a [m],b [m],c\n0.5,1,nan,3\n' >one/first.csv
expect 69 env PATH="$PWD/tools" "$SPH2D" plot one && says 'gnuplot is not installed' && says 'apt install gnuplot-nox'
absent one/plot.svg
# One that fails: its last words, and the old picture stays.
printf '#!/bin/sh\ncat >/dev/null\necho half a picture\necho "line 7: no such colour" >&2\nexit 1\n' >tools/gnuplot
chmod +x tools/gnuplot
echo old >one/plot.svg
expect 70 env PATH="$PWD/tools:$PATH" "$SPH2D" plot one && says 'gnuplot failed: line 7: no such colour'
[ "$(cat one/plot.svg)" = old ] || fail 'a failed plot changed the picture'

command -v gnuplot >/dev/null || { echo 'no gnuplot: the rest is left out' && exit 0; }
# A series that has just begun, with a column that has no number.
expect 0 "$SPH2D" plot one && says "wrote 'one/plot.svg'" && says "first: 'b \[m\]' has no value yet"
grep -q '</svg>' one/plot.svg || fail 'the picture ends early'
expect 0 "$SPH2D" run "$TINY" -o run --no-frames -q -s run.until=0.2
expect 0 "$SPH2D" plot run --json && lines 1
prints '^{"file": "run/plot.svg", "series": \[.*\], "panels": [0-9]*}$'
for probe in run/*.csv; do
    probe=${probe#run/} probe=${probe%.csv}
    prints "\"$probe\""
    grep -q ">$probe<" run/plot.svg || fail "no $probe"
done
# One panel for a unit or a number without one; the energies are together.
cat >three.csv <<'END'
time [s],kinetic [J/m],potential [J/m],speed [m/s],count,neighbours,never [m]
0,1,5,0,3,4,nan
0.1,2,nan,1,3,4,nan
0.2,3,3,2,3,5,nan
END
mkdir three && mv three.csv three/a-probe.csv
expect 0 "$SPH2D" plot three -o three.png --json && prints '"panels": 4}' && absent three/plot.svg
[ "$(od -An -tx1 -N8 three.png | tr -d ' ')" = 89504e470d0a1a0a ] || fail 'no PNG'
expect 0 "$SPH2D" plot three -q && silent && empty
for word in kinetic potential '\[J/m\]' 'speed \[m/s\]' count neighbours 'time \[s\]'; do
    grep -q ">$word<" three/plot.svg || fail "the picture has no $word"
done
! grep -q never three/plot.svg || fail 'a column without numbers is drawn'
# the same bytes again
cp three/plot.svg first.svg && expect 0 "$SPH2D" plot three && same first.svg three/plot.svg

# Names of a few, in the order given; what a series is called does not matter to gnuplot.
cp three/a-probe.csv "three/it's \`a\` \"\$(touch x)\\ %d.csv"
expect 0 "$SPH2D" plot three "it's \`a\` \"\$(touch x)\\ %d" a-probe --json && prints '"panels": 8}' && absent x
expect 0 "$SPH2D" plot three a-probe --json && prints '"series": \["a-probe"\], "panels": 4}'

# A hundred thousand rows make no larger picture than a few thousand, and keep the one row that stands out.
mkdir long
awk 'BEGIN { print "time [s],p [Pa]"; for (i = 0; i < 100000; ++i) print i / 1000 "," (i == 54321 ? 777 : i % 7) }' \
    >long/gauge.csv
expect 0 "$SPH2D" plot long
[ "$(wc -c <long/plot.svg)" -lt 150000 ] || fail 'the picture is large'
grep -q '>800<' long/plot.svg || fail 'the peak is lost'

# A folder that cannot take it, a full disk, and a run that begins anew.
expect 73 "$SPH2D" plot three -o missing/three.svg && says "'missing/three.svg'"
# The script does not fit, the picture does not, then all does.
for blocks in 2 60; do
    (trap '' XFSZ && ulimit -f $blocks && expect 74 "$SPH2D" plot run -q -o limited.svg) || fail "with $blocks blocks"
    absent limited.svg
    [ -z "$(find . -name '.limited*')" ] || fail 'something is left'
done
expect 0 "$SPH2D" plot run -q -o limited.svg
expect 0 "$SPH2D" run "$TINY" -o run --force --no-frames -q -s run.until=0.01 && absent run/plot.svg
