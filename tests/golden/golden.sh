#!/usr/bin/env bash
# Do all examples still give the same bits? golden.sh GOLDEN OUT JOBS [--own|--renew]
#
# Runs every scene of examples, coarsely and for 200 steps, by its own method (with --own by that alone), every other one
# that takes it, and every instruction set that this processor has, and compares hashes with tests/golden/hashes, a line a run: scene, method, instruction set (`=`: all
# give the same), how it ended, steps, particles, hash of what particles carry, hash of what the summary counts. OUT gets
# the new ones. --renew writes them there: in a commit that says why the numbers moved, on a processor with all sets.
# Sines and powers are the C library's (here glibc 2.36). Fitted operators alone may depend on the instruction set.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
golden=$1 out=$2 jobs=$3 mode=${4-} known=tests/golden/hashes
own='' methods=. # a pattern of those that run
[ "$mode" != --own ] || own=--own methods='^own$'
export golden own
sets='avx2 avx512 baseline'
export LC_ALL=C
rm -rf "$out" && mkdir -p "$out/lines"
# shellcheck disable=SC2016 # the inner shell expands them
grep -lx 'blocks:\|sources:' examples/*/*.yaml | while read -r scene; do
    name=${scene#examples/} && name=${name%.yaml}
    printf '%s\0%s\0%s\0' "$scene" "$name" "$out/lines/${name/\//.}"
done | xargs -0 -n 3 -P "$jobs" sh -c '"$golden" $own "$0" "$1" >"$2"'
cat "$out"/lines/* | sort >"$out/runs"

# One line where all sets say the same.
awk -v all="$(wc -w <<<"$sets")" '
    { run = $1 " " $2; set = $3; $1 = $2 = $3 = ""; said[run " =" $0]++; lines[NR] = run " " set $0; key[NR] = run " =" $0 }
    END { for (i = 1; i <= NR; ++i) if (said[key[i]] < all) print lines[i]; else if (!told[key[i]]++) print key[i] }
' "$out/runs" | tr -s ' ' | sort >"$out/hashes"
# What not all of this processor's sets give alike.
awk '{ run = $1 " " $2; $1 = $2 = $3 = ""; if (run in first && first[run] != $0) print run; first[run] = $0 }' "$out/runs" |
    sort -u | while read -r scene method; do
    [ "$method" = fitted ] || { [ "$method" = own ] && grep -q 'operators: fitted' "examples/$scene.yaml"; } ||
        echo "$scene $method: not the same on all instruction sets"
done >"$out/sets"
if grep . "$out/sets"; then
    echo "golden: $(wc -l <"$out/sets") runs depend on the instruction set" >&2 && exit 1
fi
if [ "$mode" = --renew ]; then
    cp "$out/hashes" "$known"
fi

# Lines of instruction sets that this processor lacks are known and not seen: no fault. A run that is not seen at all is.
awk -v sets="$sets" '
    $3 == "=" { n = split(sets, set); for (i = 1; i <= n; ++i) { $3 = set[i]; print } next } { print }
' "$known" | sort >"$out/known"
comm -23 "$out/runs" "$out/known" >"$out/moved"
comm -13 <(cut -d ' ' -f 1,2 "$out/runs" | sort -u) <(awk -v m="$methods" '$2 ~ m { print $1, $2 }' "$known" | sort -u) | sed 's/$/ does not run/' >>"$out/moved"
if grep . "$out/moved"; then
    echo "golden: $(wc -l <"$out/moved") results differ from tests/golden/hashes" >&2 && exit 1
fi
echo "golden: $(wc -l <"$out/runs") results, all the same bits"
