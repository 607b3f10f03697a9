#!/bin/sh
# Devices: the list, what is refused, runs that stop there and go on here and back, killed ones, checks and studies.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
export POCL_CACHE_DIR="${POCL_CACHE_DIR-$PWD/pocl}"

expect 0 "$SPH2D" devices --json
device=$("$SPH2D_ROOT"/tests/device/pocl.sh "$SPH2D") || fail 'no device of pocl'
sed -n "${device}p" out >about
for key in name gpu same_bits lacks units memory_bytes largest_block_bytes platform driver; do
    grep -q "\"$key\": " about || fail "no $key"
done
name=$(sed 's/.*"name": "\([^"]*\)".*/\1/' about)
expect 0 "$SPH2D" devices && silent && prints "^$device  *$name$" && prints 'compute units, ' && prints ', driver '
prints '^ *same bits as the processor'
expect 64 "$SPH2D" devices x && says 'takes no operand'

# Without drivers, or without any OpenCL.
none() { expect "$1" env OCL_ICD_VENDORS=/nonexistent "$SPH2D" "$2" "$TINY" --device "$3"; }
expect 0 env OCL_ICD_VENDORS=/nonexistent "$SPH2D" devices && empty && says 'install .*libopencl1.*pocl-opencl-icd'
expect 0 env OCL_ICD_VENDORS=/nonexistent "$SPH2D" devices --json && empty && says '"severity": "note"'
for command in run play check; do
    none 69 $command gpu && says 'error\[D501\]: --device gpu: there is no device with OpenCL here$' && says 'hint: install'
done
none 69 resume 1 && says '--device 1: there is no device'
expect 0 env OCL_ICD_VENDORS=/nonexistent "$SPH2D" check "$TINY" --device cpu && silent

# No such device, and what is none.
expect 69 "$SPH2D" check "$TINY" --device gpu:1000 && says '--device gpu:1000: there is no such graphics card' && empty
expect 69 "$SPH2D" run "$TINY" -o out_of_range --device 1000 && says '--device 1000: there is no such device' && empty
absent out_of_range
for bad in 0 -1 gpu:0 gpu: gpu2 GPU 1x '' cpu:1; do
    expect 64 "$SPH2D" run "$TINY" -o x "--device=$bad" && says "'$bad' is not cpu, gpu, gpu:2 .*, or a number of 'sph2d devices'"
done
expect 64 "$SPH2D" run "$TINY" -o x --isa avx2 --device "$device" || : # a processor may lack it
says '--isa'
expect 64 "$SPH2D" render x -o y --device 1 && says 'not an option of this command'

# Scenes that no device takes: `check` says the same as a run, which leaves nothing.
for scene in 'method=pcisph' 'walls=reflect' 'fluid.surface_tension=0.1'; do
    for command in check 'run -o refused'; do
        # shellcheck disable=SC2086 # a command with its option
        expect 65 "$SPH2D" $command "$TINY" -s "$scene" --device "$device"
        says 'error\[S111\]: no device takes this scene: devices ' && empty && absent refused
    done
done
expect 0 "$SPH2D" check "$TINY" -s method=pcisph --device cpu

expect 0 "$SPH2D" check "$TINY" --device "$device" --same-bits && prints "^device  *$device, $name, with the bits of baseline$"
prints "^time  *about .*; by device $device ($name)$"
prints 'iB of its memory, which gives .*iB at most$'
expect 0 "$SPH2D" check "$TINY" --device "$device" --json && prints "\"device\": \"$name\", \"device_memory_bytes\": [1-9]"
expect 0 "$SPH2D" check "$TINY" --json && prints '"device": "cpu", "device_memory_bytes": 0'
# More than a block may have, pocl's a quarter of POCL_MEMORY_LIMIT [GB].
expect 69 env POCL_MEMORY_LIMIT=1 "$SPH2D" check "$TINY" --device "$device" -s method=muller -s spacing=0.0002
says 'error\[D501\]: device 1 gives 256.0 MiB at most, and the scene takes about .*iB$' && prints 'iB of its memory'
# of a scene too large for a check
expect 65 "$SPH2D" check "$TINY" --device "$device" -s spacing=0.0005 -s method=pcisph && says 'no device takes this scene'

# The same files as by the processor.
run() { # FOLDER [OPTION...]
    folder=$1
    shift
    "$SPH2D" run "$TINY" -o "$folder" -f --no-frames --progress never -s run.until=0.8 "$@"
}
expect 0 run whole --isa baseline
expect 0 run there --device "$device" --same-bits
says "^sph2d: the steps are taken by device $device ($name)$" && prints "^  *device $device ($name)$" && prints ', baseline$'
same whole there
expect 0 run there --device "$device" --json && prints "\"isa\": \"baseline\", \"device\": \"$name\"" && same whole there
expect 0 run whole --isa baseline --json && prints '"device": "cpu"'

# Stopped there, it goes on here and there; so does one that was killed.
start() {
    rm -rf stopped
    "$SPH2D" run "$TINY" -o stopped -q --no-frames -s run.until=0.8 --device "$device" &
    pid=$!
    await test -e stopped/snapshot_000003.h5
}
for ending in TERM KILL; do
    for again in cpu "$device"; do
        start
        kill -s $ending $pid
        code=0
        wait $pid || code=$?
        case $ending in TERM) wanted=143 ;; KILL) wanted=137 ;; esac
        [ $code = "$wanted" ] || fail "$ending: ended with $code, not $wanted"
        absent stopped/snapshot_000020.h5
        expect 0 "$SPH2D" resume stopped --no-frames --progress never --device "$again" && same whole stopped
    done
done

# Begun here, it goes on there.
expect 0 run here --isa baseline -s run.until=0.4
cp -r here back
expect 0 "$SPH2D" resume here --no-frames -s run.until=0.8
expect 0 "$SPH2D" resume back --no-frames -s run.until=0.8 --device "$device" && same here back
# By another instruction set it goes on as baseline, and says so.
if "$SPH2D" --version | grep -q '^instruction sets.*avx2'; then
    expect 0 run wide --isa avx2 -s run.until=0.4
    expect 0 "$SPH2D" resume wide --no-frames -s run.until=0.5 --device "$device" && says 'the run was one by avx2; '
    prints ', baseline$'
fi

# Studies: rows by the device, two at a time, are found again by it alone.
grep -v 'snapshots\|frames' "$TINY" >scene.yaml
cat >study.yaml <<'END'
scene: scene.yaml
runs: [{name: a, set: {spacing: 0.05}}, {name: b, set: {spacing: 0.045}}]
measures: [{name: kinetic, probe: energy, column: kinetic, take: last, expect: 100}]
END
kinetic() { sed -n 's/.*"value": \([^,}]*\).*"value": \([^,}]*\).*/\1 \2/p' out; }
expect 0 "$SPH2D" study study.yaml --isa baseline --json && kinetic >here_values
expect 0 "$SPH2D" study study.yaml -o study -j 1 --device "$device" --jobs 2 --json && prints "\"device\": \"$name\""
kinetic | cmp - here_values || fail 'other values by the device'
expect 0 "$SPH2D" study study.yaml -o study -j 1 --device "$device" && says '2 rows were there already'
prints ", baseline, by device $device ($name)" && grep -q -- "--device $device" study/study.html
expect 0 "$SPH2D" study study.yaml -o study -j 1 --isa baseline && ! grep -q 'there already' err
expect 69 "$SPH2D" study study.yaml --device 1000 && empty
expect 65 "$SPH2D" study study.yaml --device "$device" -s method=pcisph && says "row 'a': no device takes this scene"
