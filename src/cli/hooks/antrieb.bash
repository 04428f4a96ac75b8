
# Values come from the program itself, and nothing is added to them by anybody else: a character more is another value.
_antrieb_values() {
    local rest=${COMP_LINE:0:COMP_POINT} typed=() found=() at=-1 word current candidate
    COMPREPLY=()
    # In the middle of a word nobody knows what the rest of it shall be.
    if [[ ${COMP_LINE:COMP_POINT:1} == [![:space:]] ]]; then return; fi
    if [[ ${COMP_WORDS[COMP_CWORD]}${COMP_WORDS[COMP_CWORD-1]} == *[\<\>]* ]]; then
        compopt -o bashdefault -o default 2>/dev/null
        return
    fi
    # What readline has broken at = @ : is one word again.
    for word in "${COMP_WORDS[@]:0:COMP_CWORD+1}"; do
        if [[ $at -lt 0 || $rest == [[:space:]]* ]]; then
            rest=${rest#"${rest%%[![:space:]]*}"}
            at=$((at + 1))
        fi
        rest=${rest#"$word"}
        typed[at]+=${word//[\"\'\\]/}
    done
    current=${typed[at]}
    while IFS= read -r candidate; do
        case $candidate in
            $'\tfiles')
                compopt -o bashdefault -o default 2>/dev/null
                return
                ;;
            $'\t'*) return ;;
            *) found+=("$candidate") ;;
        esac
    done < <("$1" complete bash -- "${typed[@]:1}" 2>/dev/null)
    if [[ ${#found[@]} -eq 0 ]]; then
        if [[ $current == "$2" ]]; then _antrieb "$@"; fi
        return
    fi
    # readline replaces $2, which begins at or behind the last of its word breaks.
    if [[ $current != *"$2" ]]; then return; fi
    for candidate in "${found[@]}"; do COMPREPLY+=("${candidate:${#current}-${#2}}"); done
    if [[ ${#found[@]} -eq 1 && ${found[0]} == *= ]]; then compopt -o nospace 2>/dev/null; fi
}

if [[ "${BASH_VERSINFO[0]}" -eq 4 && "${BASH_VERSINFO[1]}" -ge 4 || "${BASH_VERSINFO[0]}" -gt 4 ]]; then
    complete -F _antrieb_values -o nosort antrieb
else
    complete -F _antrieb_values antrieb
fi
