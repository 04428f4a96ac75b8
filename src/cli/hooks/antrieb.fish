
# Values come from the program itself.
function __fish_antrieb_values
    set -l typed (commandline -opc)
    set -l program $typed[1]
    set -e typed[1]
    $program complete fish -- $typed (commandline -ct) 2>/dev/null
end
complete -c antrieb -n "string length -q -- (__fish_antrieb_values)" -f -a "(__fish_antrieb_values)"
