#!/bin/sh
# command.sh SPH2D [beside] [pairs=N] [seconds=S] [particles=N,...] [SCENE.yaml...]
# Times the command as people start it, with its own choice of threads, against one thread: seconds of stepping by the
# clock and of all processors. Each pair of runs takes the same steps, one after the other, so that other jobs disturb
# both; a row is the least time of each, and the median of the ratios of pairs. `beside`: beside a busy loop.
set -eu
sph2d=$(realpath "$1")
shift
pairs=5 seconds=1 sizes=1000,4000,16000,100000 beside='' scenes=''
examples=$(realpath "$(dirname "$0")/../../examples")
for word; do
    case $word in
    beside) beside=1 ;;
    pairs=*) pairs=${word#*=} ;;
    seconds=*) seconds=${word#*=} ;;
    particles=*) sizes=${word#*=} ;;
    *) scenes="$scenes $(realpath "$word")" ;;
    esac
done

folder=$(mktemp -d)
busy=
trap '[ -z "$busy" ] || kill $busy; rm -rf "$folder"' EXIT
trap 'exit 130' INT TERM
if [ -n "$beside" ]; then
    sh -c 'while :; do :; done' &
    busy=$!
fi
cd "$folder"

# number KEY: what the last run says of it
number() { sed -n "s/.*\"$1\": \([-+0-9.e]*\).*/\1/p" out; }

# go ARGUMENT...: a run; its times are put behind $folder/times
go() {
    code=0
    "$sph2d" run "$@" -o run -f --no-frames -s run.snapshots.per_second=0 --progress never -q --json >out 2>err || code=$?
    [ $code = 0 ] || [ $code = 75 ] || { cat err >&2 && exit 1; }
}

# row NAME ARGUMENT...: of as many steps as one thread takes in some seconds
row() {
    name=$1
    shift
    go "$@" -j 1 --max-wall "$seconds"
    until=$(number time) particles=$(number now)
    : >times.txt
    pair=0
    while [ $pair -lt "$pairs" ]; do
        pair=$((pair + 1))
        go "$@" -s "run.until=$until" -j 1
        printf '%s %s ' "$(number step_seconds)" "$(number step_cpu_seconds)" >>times.txt
        go "$@" -s "run.until=$until"
        printf '%s %s\n' "$(number step_seconds)" "$(number step_cpu_seconds)" >>times.txt
    done
    awk '{ print $1 / $3, $0 }' times.txt | sort -n | awk -v name="$name" -v particles="$particles" '
        { ratio[NR] = $1 }
        NR == 1 || $2 < one { one = $2; one_cpu = $3 }
        NR == 1 || $4 < own { own = $4; own_cpu = $5 }
        END {
            median = NR % 2 ? ratio[(NR + 1) / 2] : (ratio[NR / 2] + ratio[NR / 2 + 1]) / 2
            printf "%-24s %9d %9.3f %9.3f %9.3f %9.3f %9.2f %9.2f\n", name, particles, one, one_cpu, own, own_cpu,
                one / own, median
        }'
}

printf '%s processors, %s; load %s\n' "$(nproc)" "${beside:+beside a busy loop}${beside:-nothing started beside}" \
    "$(cut -d ' ' -f 1-3 /proc/loadavg)" | sed 's/loop1/loop/'
printf '%-24s %9s %9s %9s %9s %9s %9s %9s\n' scene particles '1: wall' CPU 'own: wall' CPU faster median
if [ -n "$scenes" ]; then
    for scene in $scenes; do
        row "$(basename "$(dirname "$scene")")" "$scene"
    done
    exit
fi
for size in $(echo "$sizes" | tr ',' ' '); do
    # the area of the liquid over the particles
    spacing=$(awk "BEGIN { print sqrt(0.2366 / $size) }")
    for method in muller wcsph pcisph constraint; do
        row $method "$examples/dam_break/scene.yaml" -s "spacing=$spacing" -s "method={name: $method}" \
            -s fluid.dynamic_viscosity=3
    done
    row fitted "$examples/taylor_green/scene.yaml" -s "spacing=$(awk "BEGIN { print 1 / int(sqrt($size)) }")"
done
