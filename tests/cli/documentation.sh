#!/bin/sh
# The man page and the completions know every option, exit code and message code that the command itself tells.
# shellcheck disable=SC1091
. "$SPH2D_ROOT/tests/cli/common"
page=$SPH2D_ROOT/cli/sph2d.1
bash=$SPH2D_ROOT/cli/completions/sph2d.bash
zsh=$SPH2D_ROOT/cli/completions/_sph2d

for command in run resume render check study info init help; do
    grep -q "^\.It Cm $command$" "$page" || fail "the man page has no '$command'"
    grep -q "'$command:" "$zsh" || fail "zsh has no '$command'"
    grep -q "commands='.*$command" "$bash" || fail "bash has no '$command'"
    "$SPH2D" $command --help | sed -n 's/^  .*--\([a-z-]*\).*/\1/p' >>options
done
sort -u options | while read -r option; do
    grep -q "Fl -$option\>" "$page" || fail "the man page has no --$option"
    grep -q -- "--$option\>" "$bash" || fail "bash has no --$option"
    grep -q -- "--$option\>" "$zsh" || fail "zsh has no --$option"
done
"$SPH2D" help exit | while read -r code rest; do
    grep -q "^\.It $code$" "$page" || fail "the man page has no exit code $code ($rest)"
done
"$SPH2D" help codes | while read -r code text; do
    grep -A1 "^\.It $code$" "$page" | grep -qi "^${text}.$" || fail "the man page has another $code: $text"
done
"$SPH2D" help init | sed -n '/^templates:/,/^$/s/^  \([a-z_]*\) .*/\1/p' >templates
[ "$(wc -l <templates)" -gt 2 ] || fail 'no templates'
while read -r template; do
    for file in "$page" "$bash" "$zsh"; do
        grep -q "\<$template\>" "$file" || fail "$file has no template $template"
    done
done <templates
if command -v mandoc >/dev/null; then
    mandoc -Tlint "$page" >lint || fail "mandoc: $(cat lint)"
    mandoc -Tascii "$page" >/dev/null
fi
bash -n "$bash"
