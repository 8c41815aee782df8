# bash completion for filum and its stages; made from what the commands say about themselves.

# A line per command: its name, then --flag, --option=UNIT, --file=FILE or --choice={a,b}.
_filum_options() {
    cat << 'END'
@OPTIONS@
END
}

_filum_files() { mapfile -t COMPREPLY < <(compgen -f -- "$1"); }

# _filum_complete COMMAND WORD PREVIOUS
_filum_complete() {
    local line option kind
    line=$(_filum_options | grep "^$1 ") || return
    for option in $line; do
        [[ $option == "$3="* ]] || continue
        kind=${option#*=}
        case $kind in
            '{'*)
                kind=${kind#'{'}
                mapfile -t COMPREPLY < <(compgen -W "$(tr ',' ' ' <<< "${kind%'}'}")" -- "$2")
                ;;
            FILE) _filum_files "$2" ;;
        esac
        return
    done
    if [[ $2 == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(tr ' ' '\n' <<< "$line" | sed -n 's/^\(--[^=]*\).*/\1/p')" -- "$2")
    else
        _filum_files "$2"
    fi
}

_filum() {
    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command stage
    COMPREPLY=()
    command=${COMP_WORDS[0]##*/}
    # bash takes '=' for a word of its own
    [[ $previous == = ]] && previous=${COMP_WORDS[COMP_CWORD - 2]}
    [[ $word == = ]] && word=
    if [[ $command != filum ]]; then
        _filum_complete "$command" "$word" "$previous"
    elif [[ $COMP_CWORD -eq 1 || ${COMP_WORDS[1]} == help ]]; then
        mapfile -t COMPREPLY < <(compgen -W "print list env machines printers patterns settings check help $(_filum_options | cut -d ' ' -f 1)" -- "$word")
    elif [[ ${COMP_WORDS[1]} == print && $previous == --printer ]]; then
        mapfile -t COMPREPLY < <(filum printers --names 2> /dev/null | grep -i -F -- "$word" | sed 's/[^A-Za-z0-9_.+-]/\\&/g')
    elif [[ ${COMP_WORDS[1]} == print && $previous == --filament ]]; then
        mapfile -t COMPREPLY < <(compgen -W "pla petg abs tpu" -- "$word")
    elif [[ ${COMP_WORDS[1]} == print ]]; then
        for stage in slice regions sequence fill link3d postproc; do
            local so_far=("${COMPREPLY[@]}")
            _filum_complete "$stage" "$word" "$previous"
            COMPREPLY=("${so_far[@]}" "${COMPREPLY[@]}")
        done
        mapfile -t COMPREPLY < <(printf '%s\n' "${COMPREPLY[@]}" | sort -u)
    else
        _filum_complete "${COMP_WORDS[1]}" "$word" "$previous"
    fi
}

complete -o filenames -F _filum filum
for _filum_stage in $(_filum_options | cut -d ' ' -f 1); do
    [[ $_filum_stage == filum ]] || complete -o filenames -F _filum "$_filum_stage"
done
unset _filum_stage
