#!/bin/sh
# Reads what users read: the sentences in string literals of files of C. Their words are in a dictionary of British English,
# or in tests/words (of the field, of formats, of keys; sorted, one in a line); and no phrase is one that renaming by a
# script makes, as it once made "at smallest" of "at least". words.sh FILE...
#
# Hunspell rather than Aspell: its dictionaries are those that LibreOffice uses.
set -eu
export LC_ALL=C.UTF-8
here=$(dirname "$0")
command -v hunspell >/dev/null || {
    echo 'words: hunspell is not installed: left out'
    exit 0
}
list=$(mktemp)
trap 'rm -f "$list"' EXIT INT TERM

# Keys, formats, escapes, and what is quoted or a part of a command line are no words.
awk -f "$here/words.awk" "$@" | sed "s/\`[^\`]*\`/ /g; s/'[^']*'/ /g" |
    sed 's/%[-+0#]*[0-9*]*\(\.[0-9*]*\)\{0,1\}[hlz]*[a-zA-Z]/ /g; s/\\./ /g' |
    grep '[a-z][a-z] [a-z]* *[a-z][a-z]* ' >"$list"
status=0
unknown=$(tr -s ' ()[]{},;:"!?/=+*<>|' '\n' <"$list" | sed 's/[-.]*$//' | grep '^[A-Za-z]\{0,1\}[a-z][a-z]*\(-[a-z]*\)*$' |
    sort -u | hunspell -d en_GB -l | sort -u | comm -23 - "$here/words")
[ -z "$unknown" ] || {
    printf 'words: neither in the dictionary nor in tests/words:\n%s\n' "$unknown" >&2
    status=1
}
wrong='\bat (smallest|largest|biggest|longest|shortest|fewest|less|more)\b|\b(smaller|larger|more|less|fewer) as\b'
wrong="$wrong|\\b(a the|the a|the the|of of|in in|to to|is is|and and|or or|a a|are is|is are|an [bcdfgjkpqtvwyz])\\b"
if grep -nE "$wrong" "$list" >&2; then
    echo 'words: these phrases are no English' >&2
    status=1
fi
exit $status
