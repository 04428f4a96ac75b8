# Values come from the program itself; what it has nothing for is completed as below.
_antrieb_values() {
    local line value
    local -a open closed open_told closed_told
    for line in "${(@f)$(_call_program values "${(q)words[1]}" complete zsh -- "${(@q)${(@Q)words[2,CURRENT-1]}}" "${(q)${(Q)PREFIX}}" 2>/dev/null)}"; do
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

