
# Values come from the program itself; what it has nothing for is completed as above.
_antrieb_values() {
    local line=${COMP_LINE:0:COMP_POINT} word=${COMP_WORDS[COMP_CWORD]} found=() typed=() candidate current
    read -r -a typed <<< "$line"
    if [[ $line == *[[:space:]] ]]; then typed+=(""); fi
    current=${typed[${#typed[@]}-1]}
    while IFS= read -r candidate; do found+=("$candidate"); done \
        < <("$1" complete bash -- "${typed[@]:1}" 2>/dev/null)
    if [[ ${#found[@]} -eq 0 ]]; then
        _antrieb "$@"
        return
    fi
    # readline replaces only what follows the last of its word breaks (= @ :).
    if [[ $word == [=:@] ]]; then word=; fi
    COMPREPLY=("${found[@]#"${current%"$word"}"}")
    if [[ ${#found[@]} -eq 1 && ${found[0]} == *= ]]; then compopt -o nospace 2>/dev/null; fi
}

if [[ "${BASH_VERSINFO[0]}" -eq 4 && "${BASH_VERSINFO[1]}" -ge 4 || "${BASH_VERSINFO[0]}" -gt 4 ]]; then
    complete -F _antrieb_values -o nosort -o bashdefault -o default antrieb
else
    complete -F _antrieb_values -o bashdefault -o default antrieb
fi
