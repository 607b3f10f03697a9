# SPDX-License-Identifier: MIT
# Completion of sph2d for bash: source this file, or install it as
# share/bash-completion/completions/sph2d.
# shellcheck shell=bash

_sph2d() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
    local commands='run resume render check study info init help'
    local options='--json --quiet --verbose --no-color --help --version'
    COMPREPLY=()

    if [ "$COMP_CWORD" -eq 1 ]; then
        mapfile -t COMPREPLY < <(compgen -W "$commands --help --version" -- "$word")
        return
    fi
    case $before in
    --isa) mapfile -t COMPREPLY < <(compgen -W 'auto baseline avx2 avx512' -- "$word") ;;
    --progress) mapfile -t COMPREPLY < <(compgen -W 'auto always never' -- "$word") ;;
    --style) mapfile -t COMPREPLY < <(compgen -W 'metaballs points' -- "$word") ;;
    --gl) mapfile -t COMPREPLY < <(compgen -W 'osmesa egl' -- "$word") ;;
    --template) mapfile -t COMPREPLY < <(compgen -W 'dam_break drop sprinkler stir' -- "$word") ;;
    --color) mapfile -t COMPREPLY < <(compgen -W 'speed Pressures Densities' -- "$word") ;;
    -o | --output | --shader-dir) mapfile -t COMPREPLY < <(compgen -d -- "$word") ;;
    --preview) mapfile -t COMPREPLY < <(compgen -f -- "$word") ;;
    -s | --set | -j | --threads | --max-wall | --size | --radius | --range) ;;
    *) false ;;
    esac && return

    local drawing='--gl --shader-dir --threads'
    case ${COMP_WORDS[1]} in
    run) options+=" $drawing --output --force --set --dry-run --isa --max-wall --no-frames --profile --progress" ;;
    resume) options+=" $drawing --set --max-wall --no-frames --no-checksum --profile --progress" ;;
    render) options+=" $drawing --output --force --no-checksum --size --style --radius --color --range --progress" ;;
    check) options+=" $drawing --set --isa --preview" ;;
    study) options+=' --output --force --set --threads --jobs --isa --repeat --target --all --progress' ;;
    info) options+=' --no-checksum' ;;
    init) options+=' --force --template' ;;
    esac
    if [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
        return
    fi
    case ${COMP_WORDS[1]} in
    run | check | study) mapfile -t COMPREPLY < <(compgen -d -- "$word" && compgen -f -X '!*.@(yaml|yml|json)' -- "$word") ;;
    render | info) mapfile -t COMPREPLY < <(compgen -d -- "$word" && compgen -f -X '!*.h5' -- "$word") ;;
    resume) mapfile -t COMPREPLY < <(compgen -d -- "$word") ;;
    help) mapfile -t COMPREPLY < <(compgen -W "$commands exit codes scene materials methods" -- "$word") ;;
    esac
}

complete -o filenames -F _sph2d sph2d
