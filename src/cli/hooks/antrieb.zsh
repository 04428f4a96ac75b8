# Values come from the program itself, and nothing is added to them by anybody else; options and verbs are completed as below.
_antrieb_values() {
    local line value
    local -a open closed open_told closed_told
    # In the middle of a word nobody knows what the rest of it shall be.
    [[ -n $SUFFIX ]] && return 0
    for line in "${(@f)$(_call_program values "${(q)words[1]}" complete zsh -- "${(@q)${(@Q)words[2,CURRENT-1]}}" "${(q)${(Q)PREFIX}}" 2>/dev/null)}"; do
        case $line in
            ($'\tfiles') compset -P '--*='; compset -P '(sim|tape):'; _files; return 0 ;;
            ($'\t'*) return 0 ;;
        esac
        value=${line%%$'\t'*}
        [[ -n $value ]] || continue
        if [[ $value == *= ]]; then
            open+=("$value"); open_told+=("${line//$'\t'/  }")
        else
            closed+=("$value"); closed_told+=("${line//$'\t'/  }")
        fi
    done
    (( $#open + $#closed )) || return 1
    (( $#open )) && compadd -S '' -l -d open_told -a open
    (( $#closed )) && compadd -l -d closed_told -a closed
    return 0
}

