# Print an optspec for argparse to handle cmd's options that are independent of any subcommand.
function __fish_antrieb_global_optspecs
    string join \n p/port= a/address= b/baud= parity= stop-bits= data-bits= protocol= drive= timeout= retries= format= json lang= q/quiet v/verbose trace= color= no-progress catalogue= config= no-config dry-run yes h/help V/version
end

function __fish_antrieb_needs_command
    # Figure out if the current invocation already has a command.
    set -l cmd (commandline -opc)
    set -e cmd[1]
    argparse -s (__fish_antrieb_global_optspecs) -- $cmd 2>/dev/null
    or return
    if set -q argv[1]
        # Also print the command, so this can be used to figure out what it is.
        echo $argv[1]
        return 1
    end
    return 0
end

function __fish_antrieb_using_subcommand
    set -l cmd (__fish_antrieb_needs_command)
    test -z "$cmd"
    and return 1
    contains -- $cmd[1] $argv
end

complete -c antrieb -n "__fish_antrieb_needs_command" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_needs_command" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_needs_command" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_needs_command" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_needs_command" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_needs_command" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_needs_command" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_needs_command" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_needs_command" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_needs_command" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_needs_command" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_needs_command" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_needs_command" -s V -l version -d 'Print version'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "scan" -d 'Finds every drive on a line with a known setting'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "identify" -d 'Tells what a drive is, and how it is set up for talking to it'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "read" -d 'Reads parameters'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "write" -d 'Writes parameters'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "dataset" -d 'Shows, selects, copies and compares the four data sets of a drive'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "diag" -d 'Diagnoses a drive and the line to it'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "statemachine" -d 'Shows the state of the drive\'s state machine. Reading only'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "state" -d 'Shows the state of the drive\'s state machine. Reading only'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "sollwert" -d 'Shows setpoints and actual values side by side. Reading only'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "setpoint" -d 'Shows setpoints and actual values side by side. Reading only'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "params" -d 'Browses the parameter catalogue. No drive is needed'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "decode" -d 'Explains telegrams, words and codes. No drive is needed'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "simulate" -d 'Serves simulated drives in real time on a pseudo terminal or a TCP port'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "schema" -d 'Prints the JSON Schema of a verb\'s output, or of every verb\'s'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "completions" -d 'Prints a completion script'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "man" -d 'Prints a man page: of the program, or of a verb'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l type -d 'Read with this type, whatever the catalogue says: uint, int, word, long' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l decimals -d 'Show this many decimals, whatever the catalogue says' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l type -d 'Write with this type, whatever the catalogue says: uint, int, word, long' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l decimals -d 'Take the value with this many decimals, whatever the catalogue says' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l force -d 'Send also what the catalogue forbids or what would change nothing, and let the drive judge'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -f -a "show" -d 'Show parameters in all four data sets side by side'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -f -a "active" -d 'Show which data set the drive works with (P.249) and what selects it (P.414)'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -f -a "select" -d 'Select a data set (P.414): 1-4, or 0 for the digital inputs'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -f -a "copy" -d 'Copy the values of one data set into another'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -f -a "diff" -d 'Compare two data sets; exits with 1 if they differ'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l ram -d 'Select in RAM only, until power-off'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l ram -d 'Copy into RAM only, until power-off'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l link-test -d 'Ask N harmless questions and show error rate and reply times' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l clear -d 'Set the diagnostic counters to zero after showing them'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l check -d 'For scripts: exit with 1 if a fault is present'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show" -f -a "show" -d 'Show state, words and control mode (the default)'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show" -f -a "show" -d 'Show state, words and control mode (the default)'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "telegram" -d 'A Modbus telegram: hex bytes, or an ASCII telegram from its colon on'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "trace" -d 'A recording made with --trace'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "status" -d 'A status word (P.411), such as 0x0237'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "control" -d 'A control word (P.410), such as 0x000F'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "warnings" -d 'A warning word (P.270), such as 0x008B'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "fault" -d 'A fault code (P.260), such as F0500, 0x0500 or 1280'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "error" -d 'A code of the error register (P.11), such as 11'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l mode -d 'Control mode (P.412) that decides what the bits mean: 0 contacts, 1 state machine, 2 remote contacts' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l link -d 'Name the pseudo terminal with this symbolic link' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l tcp -d 'Serve on this loopback address instead of a pseudo terminal, such as 127.0.0.1:5020' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l for -d 'End after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), or `sim` / `sim:FILE.toml`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s b -l baud -d 'Speed in baud [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l parity -d 'Parity: even, odd, none [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l protocol -d 'Protocol on the line: rtu, ascii [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l drive -d 'What the drives are: auto, act, acu [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l retries -d 'How often to repeat a question that got no valid reply [default: 2]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l trace -d 'Record the line to a file that `decode trace` reads' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s v -l verbose -d 'Show every telegram on stderr, decoded, with its time'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s h -l help -d 'Print help (see more with \'--help\')'
