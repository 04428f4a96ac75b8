
# Values come from the program itself, and nothing is added to them by anybody else.
function __fish_antrieb_asked
    # In the middle of a word nobody knows what the rest of it shall be.
    test (commandline -t | string collect -N) = (commandline -ct | string collect -N); or return
    set -l typed (commandline -opc)
    set -l program $typed[1]
    set -e typed[1]
    $program complete fish -- $typed (commandline -ct) 2>/dev/null
end
function __fish_antrieb_values
    set -l asked (__fish_antrieb_asked)
    # Behind `--option=` fish has no files of its own.
    if string match -q \tfiles -- $asked; and set -l value (string replace -rf '^--[^=]*=' '' -- (commandline -ct))
        set -l kind (string match -r '^(?:sim|tape):' -- $value)
        for path in (__fish_complete_path (string replace -r '^(?:sim|tape):' '' -- $value))
            echo "$kind$path"
        end
        return
    end
    string match -rv '^\t' -- $asked
end
function __fish_antrieb_files
    __fish_antrieb_asked | string match -q \tfiles
end
complete -c antrieb -f -a "(__fish_antrieb_values)"
complete -c antrieb -n __fish_antrieb_files -F
