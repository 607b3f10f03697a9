#!/usr/bin/env bash
# Do all examples still give the same bits? golden.sh GOLDEN OUT JOBS [--renew]
#
# Runs every scene of examples, coarsely and for 200 steps, by every method and instruction set that this
# processor has, and compares hashes of all particles with tests/golden/hashes. OUT gets the new ones. --renew writes
# them there: in a commit that says why the numbers moved. Sines and powers are the C library's (here glibc 2.36).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
golden=$1 out=$2 jobs=$3 known=tests/golden/hashes
rm -rf "$out" && mkdir -p "$out/lines"
# shellcheck disable=SC2016 # the inner shell expands them
grep -lx 'blocks:\|sources:' examples/*/*.yaml | while read -r scene; do
    name=${scene#examples/} && name=${name%.yaml}
    printf '%s\0%s\0%s\0' "$scene" "$name" "$out/lines/${name/\//.}"
done | xargs -0 -n 3 -P "$jobs" sh -c '"$0" "$1" "$2" >"$3"' "$golden"
cat "$out"/lines/* | LC_ALL=C sort >"$out/hashes"
if [ "${4-}" = --renew ]; then
    cp "$out/hashes" "$known"
fi
# Lines of instruction sets that this processor lacks are known and not seen: no fault.
if ! LC_ALL=C comm -23 "$out/hashes" "$known" | tee "$out/moved" | { ! grep .; }; then
    echo "golden: $(wc -l <"$out/moved") results differ from tests/golden/hashes" >&2 && exit 1
fi
echo "golden: $(wc -l <"$out/hashes") results, all the same bits"
