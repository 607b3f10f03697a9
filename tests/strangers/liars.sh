#!/usr/bin/env bash
# The judge itself: a command that lies is found out, each lie by the invariant that it breaks, and an honest one is
# not accused. liars.sh SPH2D STRANGERS DIR
set -euo pipefail
SPH2D=$(realpath -e "$1")
strangers=$(realpath -e "$2")
rm -rf "$3"
mkdir -p "$3"
cd "$3"
export SPH2D

# A drop that flies: by every method it keeps every invariant.
cat >sound.yaml <<'EOF'
domain: {min: [0, 0], max: [1, 2]}
spacing: 0.05
blocks: [{disc: {center: [0.5, 1.5], radius: 0.2}}]
run: {until: 0.2}
EOF
sed 's/spacing: 0.05/spacing: -1/' sound.yaml >faulty.yaml

cat >liar <<'EOF'
#!/bin/sh
# Does what sph2d does, and then lies as $LIE says about the command that $LIE_ABOUT names.
case "$LIE $LIE_ABOUT" in
"bits $1") case " $* " in *' -j 2 '*) set -- "$@" -s 'gravity=[0, -5]' ;; esac ;;
"folder $1") mkdir -p "$4" ;;
esac
code=0
"$SPH2D" "$@" >answer.$$ || code=$?
if [ "$LIE_ABOUT" = "$1" ]; then
    case $LIE in
    lost) sed -i 's/"particles": {"now": [0-9]*/"particles": {"now": 1/' answer.$$ ;;
    maximum) sed -i 's/"compression_max": [0-9.e-]*/"compression_max": 0.5/' answer.$$ ;;
    nan) sed -i 's/"energy_kinetic": [0-9.e+-]*/"energy_kinetic": nan/' answer.$$ ;;
    early) sed -i 's/"end": "finished"/"end": "SIGINT"/' answer.$$ ;;
    steps) sed -i 's/"steps": [0-9.]*/"steps": 1/' answer.$$ ;;
    accepts) code=0 ;;
    killed) kill -SEGV $$ ;;
    [0-9]*) code=$LIE ;;
    esac
fi
cat answer.$$
rm answer.$$
exit $code
EOF
chmod +x liar

# expect SCENE LIE COMMAND INVARIANT...: that lie about that command breaks these and no other.
expect() {
    local scene=$1 lie=$2 about=$3 found
    shift 3
    LIE=$lie LIE_ABOUT=$about "$strangers" --command "$PWD/liar" --scene "$scene" --dir judged >told || true
    grep -q '^strangers: 1 scenes' told || { echo "liars: no verdict on $scene" >&2 && exit 1; }
    found=$(sed -n 's/^FAIL [a-z]*\t\([a-z]*\)\t.*/\1/p' told | sort | tr '\n' ' ')
    [ "$found" = "${*:+$* }" ] || {
        echo "liars: '$lie' about $about: found '$found', not '$*'; see $PWD/judged" >&2
        exit 1
    }
}
expect sound.yaml nothing run
expect faulty.yaml nothing run
expect sound.yaml 70 check status
expect sound.yaml 65 check status
expect sound.yaml 70 run status
expect sound.yaml 1 run status
expect sound.yaml killed check crash
expect sound.yaml killed run crash
expect sound.yaml lost run particles
expect sound.yaml maximum run compression
expect sound.yaml nan run finite
expect sound.yaml early run status
expect sound.yaml steps check plan
expect sound.yaml 75 resume status
expect sound.yaml bits run bits
expect faulty.yaml accepts check status
expect faulty.yaml 66 run agree
expect faulty.yaml folder run agree
echo 'strangers: the judge finds every lie'
