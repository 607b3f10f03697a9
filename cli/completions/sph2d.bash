# SPDX-License-Identifier: MIT
# Completion of sph2d for bash 4 or newer. `make install` puts it into share/bash-completion/completions, where the
# package bash-completion finds it; without that package source this file in ~/.bashrc.
#
# Commands, options and their values are asked of the command itself (`sph2d help completions`, 20 ms at each tab), so
# that no list here goes stale. Functions share the variables of _sph2d.
# shellcheck shell=bash

# The text that stands for a word with quotes and backslashes, which may be open at its end, into $value.
_sph2d_unquote() {
    local rest=$1 quote='' c
    value=''
    while [ -n "$rest" ]; do
        c=${rest:0:1} rest=${rest:1}
        case $quote$c in
        \'\' | \"\") quote='' ;;
        \' | \") quote=$c ;;
        \\ | \"\\) value+=${rest:0:1} rest=${rest:1} ;;
        *) value+=$c ;;
        esac
    done
}

# Folders that begin with $value, and files that do and match a pattern. Their names may have blanks and whatever else:
# they are never split here, and readline quotes them.
_sph2d_paths() { # PATTERN...
    local typed='' real='' path pattern strict=''
    # shellcheck disable=SC2088 # as it was typed
    [ "${value:0:2}" != '~/' ] || typed='~' real=$HOME
    compopt -o filenames
    ! shopt -q failglob || strict=yes
    shopt -u failglob
    for path in "$real${value#"$typed"}"*; do
        if [ -d "$path" ]; then
            COMPREPLY+=("$typed${path#"$real"}/")
            continue
        fi
        for pattern; do
            # shellcheck disable=SC2053 # it is a pattern
            [[ ! -e $path || $path != $pattern ]] || COMPREPLY+=("$typed${path#"$real"}")
        done
    done
    [ -z "$strict" ] || shopt -s failglob
    [[ ${#COMPREPLY[@]} != 1 || ${COMPREPLY[0]} != */ ]] || compopt -o nospace
}

_sph2d_words() { # WORD...
    local word
    for word; do
        [[ $word != "$value"* ]] || COMPREPLY+=("$word")
    done
}

# What the command tells of the scene on the line, or of any: its keys or its names.
_sph2d_scene() { # KIND
    local kind rest real=$scene
    # shellcheck disable=SC2088 # as it was typed
    [ "${real:0:2}" != '~/' ] || real=$HOME/${real:2}
    while IFS= read -r rest; do
        kind=${rest%%$'\t'*}
        [ "$kind" != "$1" ] || printf '%s\n' "${rest#*$'\t'}"
    done < <("$program" help completions "$real" 2>/dev/null || sph2d help completions "$real" 2>/dev/null)
}

# A key and its value: names up to the next point, then words.
_sph2d_setting() {
    local path listed candidate
    local -A offered=()
    [[ $value == *=* ]] || compopt -o nospace
    while IFS=$'\t' read -r path listed; do
        if [[ $value == *=* ]]; then
            [[ $path != "${value%%=*}" || $listed == - ]] || for candidate in $listed; do
                _sph2d_words "$path=$candidate"
            done
        elif [[ $path == "$value"* ]]; then
            candidate=${path#"$value"}
            case $candidate in
            *.*) candidate=$value${candidate%%.*}. ;;
            *) candidate=$path= ;;
            esac
            [ "${offered[$candidate]-}" ] || COMPREPLY+=("$candidate")
            offered[$candidate]=yes
        fi
    done < <(_sph2d_scene key)
}

# The value of an option.
_sph2d_value() { # NAME
    local -a listed
    case ${arguments[$1]}/$1 in
    DIR/*) _sph2d_paths ;;
    FILE/*) _sph2d_paths '*' ;;
    KEY=VALUE/*) _sph2d_setting ;;
    */--follow)
        mapfile -t listed < <(_sph2d_scene name)
        _sph2d_words "${listed[@]}"
        ;;
    *)
        read -ra listed <<<"${words[$1]}"
        [ "${listed[0]}" = - ] || _sph2d_words "${listed[@]}"
        ;;
    esac
}

# The series in the folder of the run.
_sph2d_probes() {
    local path
    for path in "$scene"/*.csv; do
        path=${path##*/}
        [ "$path" = '*.csv' ] || _sph2d_words "${path%.csv}"
    done
}

# What a command takes beside options, which it may have had already.
_sph2d_operand() { # ALREADY
    [[ $1 = 0 || $operands == *...* ]] || return
    case $operands in
    SCENE* | '[SCENE]'* | STUDY*) _sph2d_paths '*.yaml' '*.yml' '*.json' ;;
    SNAPSHOT* | PATH*) _sph2d_paths '*.h5' ;;
    DIR*PROBE*)
        if [ "$1" = 0 ]; then _sph2d_paths; else _sph2d_probes; fi
        ;;
    DIR*) _sph2d_paths ;;
    '[TOPIC]') _sph2d_words "${commands[@]}" "${topics[@]}" ;;
    esac
}

# Fills commands, topics, and of the command that is being written operands, options, and arguments and words of each.
_sph2d_ask() { # PROGRAM COMMAND
    local kind name letter long argument listed
    while IFS=$'\t' read -r kind name letter long argument listed _; do
        case $kind/$name in
        command/*)
            commands+=("$name")
            [ "$name" != "$2" ] || operands=$letter
            ;;
        topic/*) topics+=("$name") ;;
        option/"$2")
            options+=("$long")
            arguments[$long]=$argument arguments[$letter]=$argument
            words[$long]=$listed words[$letter]=$listed
            ;;
        esac
    done < <("$1" help completions 2>/dev/null || sph2d help completions 2>/dev/null)
}

# Completes the last word of a command: $value, after the words from the third to $last.
_sph2d_after_command() {
    local k already=0 only_operands='' joins='' unquoted before=${COMP_WORDS[last]}
    for ((k = 2; k <= last; ++k)); do
        case ${COMP_WORDS[k]} in
        --) only_operands=yes ;;
        [=:]*) # the rest of the word before
            [ -z "$joins" ] || scene+=${COMP_WORDS[k]}${COMP_WORDS[k + 1]}
            k=$((k + 1))
            ;;
        -*)
            joins=''
            # its value, unless that comes behind a sign of equality
            [[ ${arguments[${COMP_WORDS[k]}]:--} = - || ${COMP_WORDS[k + 1]} == =* ]] || k=$((k + 1))
            ;;
        *)
            already=$((already + 1)) joins=''
            [ "$already" != 1 ] || scene=${COMP_WORDS[k]} joins=yes
            ;;
        esac
    done
    # It may come after the cursor.
    for ((k = COMP_CWORD + 1; k < ${#COMP_WORDS[@]}; ++k)); do
        [[ $scene || ${COMP_WORDS[k]} == [-=:]* || ${arguments[${COMP_WORDS[k - 1]}]:--} != - ]] || scene=${COMP_WORDS[k]}
    done
    unquoted=$value
    _sph2d_unquote "$scene"
    scene=$value value=$unquoted
    if [[ $value == --*=* && ! $only_operands ]]; then
        option=${value%%=*} value=${value#*=}
        _sph2d_value "$option"
        COMPREPLY=("${COMPREPLY[@]/#/"$option="}")
    elif [[ $last -ge 2 && ${arguments[$before]:--} != - && ! $only_operands ]]; then
        _sph2d_value "$before"
    elif [[ $value == -* && ! $only_operands ]]; then
        _sph2d_words "${options[@]}"
    else
        _sph2d_operand "$already"
    fi
}

_sph2d() {
    local program=$1 word=${COMP_WORDS[COMP_CWORD]} part=${COMP_WORDS[COMP_CWORD]} last=$COMP_CWORD
    local value operands='' option beginning scene=''
    local -a commands=() topics=() options=()
    local -A arguments=() words=()
    COMPREPLY=()
    # shellcheck disable=SC2088 # as it was typed
    [ "${program:0:2}" != '~/' ] || program=$HOME/${program:2}
    _sph2d_ask "$program" "${COMP_WORDS[1]}"

    # Readline splits words at = and :, unless told otherwise, and replaces only the last part of what it split.
    [[ $part != [=:]* ]] || part=''
    while ((last > 2)) && [[ ${COMP_WORDS[last]} == [=:]* || ${COMP_WORDS[last - 1]} == [=:]* ]]; do
        last=$((last - 1))
        word=${COMP_WORDS[last]}$word
    done
    last=$((last - 1))
    _sph2d_unquote "${word%"$part"}"
    beginning=$value
    _sph2d_unquote "$word"

    if [ "$COMP_CWORD" = 1 ]; then
        _sph2d_words "${commands[@]}" --help --version
    else
        _sph2d_after_command
    fi
    COMPREPLY=("${COMPREPLY[@]#"$beginning"}")
}

complete -F _sph2d sph2d
