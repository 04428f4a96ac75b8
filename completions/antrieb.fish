# Print an optspec for argparse to handle cmd's options that are independent of any subcommand.
function __fish_antrieb_global_optspecs
    string join \n p/port= a/address= b/baud= parity= stop-bits= data-bits= rs485= rs485-before= rs485-after= protocol= drive= word-order= timeout= retries= format= json lang= q/quiet v/verbose trace= color= no-progress catalogue= config= no-config dry-run force yes h/help
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

complete -c antrieb -n "__fish_antrieb_needs_command" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_needs_command" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_needs_command" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_needs_command" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_needs_command" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_needs_command" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_needs_command" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_needs_command" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_needs_command" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_needs_command" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_needs_command" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_needs_command" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_needs_command" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_needs_command" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_needs_command" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "scan" -d 'Finds every drive on a line, whatever its setting'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "identify" -d 'Tells what a drive is, and how it is set up for talking to it'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "read" -d 'Reads parameters'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "write" -d 'Writes parameters'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "dataset" -d 'Shows, selects, copies a drive\'s data sets; saves and compares its settings'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "init" -d 'Writes antrieb.toml from a scan: ports, drives and their names'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "plan" -d 'Shows what `apply` would write; 1 if something would change'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "apply" -d 'Writes what antrieb.toml says into its drives, with one question'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "check" -d 'Holds the drives of antrieb.toml against their files; 1 if one differs'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "diag" -d 'Diagnoses a drive and the line to it'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "statemachine" -d 'Shows a drive\'s state, and walks it to another'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "state" -d 'Shows a drive\'s state, and walks it to another'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "sollwert" -d 'Shows setpoint and actual value, or gives one'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "setpoint" -d 'Shows setpoint and actual value, or gives one'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "monitor" -d 'Watches drives: state, setpoint, actual value, current, fault'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "plot" -d 'Draws a record of `monitor` over time, or the characteristic of an analog input'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "report" -d 'Writes down a drive and its line for who takes them over'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "procedure" -d 'Guided work, step by step'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "protocol" -d 'Shows or changes what a drive speaks: RTU, ASCII, VABus'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "line" -d 'Changes speed, parity or address of a drive, and follows it'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "params" -d 'Browses the parameter catalogue. No drive is needed'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "systembus" -d 'Plans the system bus (CAN) of ACTIVE Cube drives, and sets drives to it'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "decode" -d 'Explains telegrams, words and codes. No drive is needed'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "profibus" -d 'Looks at a PROFIBUS line without a controller; bytes for a Hitachi SJ2-PB'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "sniff" -d 'Listens on a line and tells every telegram. Never sends'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "simulate" -d 'Serves simulated drives on a pseudo terminal or a TCP port'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "schema" -d 'Prints the JSON Schema of a verb\'s output, or of every verb\'s'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "completions" -d 'Prints a completion script: bash, zsh, fish, powershell'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "man" -d 'Prints a man page: of the program, or of a verb'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l within -d 'End after this time, whatever is left: `90s`, `2m`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l resume -d 'Go on where this result of `scan --json` ends' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l thorough -d 'By the book: every address gets its full time'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l fast -d 'One time around, nothing is asked again'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l until-first -d 'The first drive ends the search'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l gsd -d 'The GSD of the slave' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l user-prm -d 'User parameters of Set_Prm (hex), if the GSD wants any' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l cfg -d 'Its configuration: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l slot-time -d 'How soon an answer begins [default: 30ms or 8ms]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l type -d 'uint, int, word or long, whatever the catalogue says' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l decimals -d 'Decimals, whatever the catalogue says' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l gsd -d 'The GSD of the slave' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l user-prm -d 'User parameters of Set_Prm (hex), if the GSD wants any' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l cfg -d 'Its configuration: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l slot-time -d 'How soon an answer begins [default: 30ms or 8ms]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l type -d 'uint, int, word or long, whatever the catalogue says' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l decimals -d 'Decimals, whatever the catalogue says' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l gsd -d 'The GSD of the slave' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l user-prm -d 'User parameters of Set_Prm (hex), if the GSD wants any' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l cfg -d 'Its configuration: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l slot-time -d 'How soon an answer begins [default: 30ms or 8ms]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l force -d 'Send also what is forbidden or changes nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l gsd -d 'The GSD of the slave' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l user-prm -d 'User parameters of Set_Prm (hex), if the GSD wants any' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l cfg -d 'Its configuration: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l slot-time -d 'How soon an answer begins [default: 30ms or 8ms]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -f -a "show" -d 'Show parameters in all four data sets side by side'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -f -a "active" -d 'Show the data set in use (P.249), and what selects it (P.414)'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -f -a "select" -d 'Select a data set (P.414): 1-4, or 0 for the digital inputs'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -f -a "copy" -d 'Copy the values of one data set into another'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -f -a "diff" -d 'Compare data sets, files, drives, factory settings; 1 if they differ'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -f -a "save" -d 'Save a drive\'s settings into a file'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -f -a "check" -d 'Check a drive against a file; exits with 1 if they differ'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -f -a "load" -d 'Write parameter files into a drive: all of it, or nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff save check load undo" -f -a "undo" -d 'Take a `dataset load` back, by the undo file that it left'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l ram -d 'Select in RAM only, until power-off'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l ram -d 'Copy into RAM only, until power-off'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l unified -d 'Show the differences as lines of both files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l changed -d 'Only what differs from the factory settings that are known'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l discover -d 'All numbers 0-1599, also those that no catalogue knows'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l resume -d 'Go on with a save that was interrupted'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from save" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l only -d 'Only these groups and parameters: motor,ramps,480-483' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l except -d 'Without these groups and parameters' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l sets -d 'Only these data sets, 0 for what exists once: 1-3' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l unified -d 'Show the differences as lines of both files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from check" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l only -d 'Only these groups and parameters: motor,ramps,480-483' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l except -d 'Without these groups and parameters' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l sets -d 'Only these data sets, 0 for what exists once: 1-3' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l undo-file -d 'Where the undo file goes [default: beside FILE]' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l ram -d 'Write to RAM only, until power-off'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from load" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from undo" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l within -d 'End after this time, whatever is left: `90s`, `2m`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l resume -d 'Go on where this result of `scan --json` ends' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l thorough -d 'By the book: every address gets its full time'
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l fast -d 'One time around, nothing is asked again'
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l until-first -d 'The first drive ends the search'
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l all-ports -d 'Search every USB adapter that is plugged in'
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand init" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l only -d 'Only these groups and parameters: motor,ramps,480-483' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l except -d 'Without these groups and parameters' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l sets -d 'Only these data sets, 0 for what exists once: 1-3' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l ram -d 'Write to RAM only, until power-off'
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand plan" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l only -d 'Only these groups and parameters: motor,ramps,480-483' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l except -d 'Without these groups and parameters' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l sets -d 'Only these data sets, 0 for what exists once: 1-3' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l ram -d 'Write to RAM only, until power-off'
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l atomic -d 'All drives or none: if one fails, all go back'
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand apply" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l only -d 'Only these groups and parameters: motor,ramps,480-483' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l except -d 'Without these groups and parameters' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l sets -d 'Only these data sets, 0 for what exists once: 1-3' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand check" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l link-test -d 'Ask N harmless questions: error rate, reply times' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l gsd -d 'The GSD of the slave' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l user-prm -d 'User parameters of Set_Prm (hex), if the GSD wants any' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l cfg -d 'Its configuration: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l slot-time -d 'How soon an answer begins [default: 30ms or 8ms]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l mode -d 'basic or profidrive [default: as Get_Cfg tells]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l clear -d 'Set the diagnostic counters to zero after showing them'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l check -d 'For scripts: exit with 1 if a fault is present'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -f -a "line" -d 'The line itself'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l count -d 'How many questions to ask each drive' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l gsd -d 'The GSD of the slave' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l user-prm -d 'User parameters of Set_Prm (hex), if the GSD wants any' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l cfg -d 'Its configuration: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l slot-time -d 'How soon an answer begins [default: 30ms or 8ms]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l mode -d 'basic or profidrive [default: as Get_Cfg tells]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "show" -d 'Show state, words, what is missing (the default)'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "shutdown" -d 'Shut down: to "ready to switch on"'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "switch-on" -d 'Walk to "switched on"; the shaft does not turn yet'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "enable" -d 'Walk to "operation enabled": the motor follows its setpoint'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "disable" -d 'Disable operation: coasts, brakes or ramps as P.392 says'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "disable-voltage" -d 'Disable voltage: the shaft coasts'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "quick-stop" -d 'Quick stop: by the emergency ramps P.424 and P.425'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "reset" -d 'Reset a fault: once, when the drive\'s 15 s lock has passed'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "goto" -d 'Walk to a state, the shortest way'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "contacts" -d 'Set virtual contacts through the control word (P.412 = 2)'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l gsd -d 'The GSD of the slave' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l user-prm -d 'User parameters of Set_Prm (hex), if the GSD wants any' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l cfg -d 'Its configuration: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l slot-time -d 'How soon an answer begins [default: 30ms or 8ms]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l mode -d 'basic or profidrive [default: as Get_Cfg tells]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "show" -d 'Show state, words, what is missing (the default)'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "shutdown" -d 'Shut down: to "ready to switch on"'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "switch-on" -d 'Walk to "switched on"; the shaft does not turn yet'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "enable" -d 'Walk to "operation enabled": the motor follows its setpoint'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "disable" -d 'Disable operation: coasts, brakes or ramps as P.392 says'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "disable-voltage" -d 'Disable voltage: the shaft coasts'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "quick-stop" -d 'Quick stop: by the emergency ramps P.424 and P.425'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "reset" -d 'Reset a fault: once, when the drive\'s 15 s lock has passed'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "goto" -d 'Walk to a state, the shortest way'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "contacts" -d 'Set virtual contacts through the control word (P.412 = 2)'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l mode -d 'What is set, where the unit does not tell' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l set -d 'Set a parameter first, such as RAMPacc=2000' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l start -d 'absolute (default) or relative' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l until -d 'Wait until the setpoint is `reached`' -r -f -a "reached\t'The drive reports the setpoint as reached'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l source -d 'ACTIVE: line or sum forms the setpoint' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l ramp -d 'Lead the setpoint, such as 0Hz:50Hz:20s' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l profile -d 'Lead the setpoint by lines such as `5s, 25Hz`' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l jog -d 'Enable, run for this time, stop' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l step -d 'With --view: the arrows change the setpoint by this' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l min -d 'With --step: no lower than this' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l max -d 'With --step: no higher than this' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l gsd -d 'The GSD of the slave' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l user-prm -d 'User parameters of Set_Prm (hex), if the GSD wants any' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l cfg -d 'Its configuration: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l slot-time -d 'How soon an answer begins [default: 30ms or 8ms]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l enable -d 'Walk to "operation enabled" first'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l force -d 'Give also a setpoint beyond its limit'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l mode -d 'What is set, where the unit does not tell' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l set -d 'Set a parameter first, such as RAMPacc=2000' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l start -d 'absolute (default) or relative' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l until -d 'Wait until the setpoint is `reached`' -r -f -a "reached\t'The drive reports the setpoint as reached'"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l source -d 'ACTIVE: line or sum forms the setpoint' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l ramp -d 'Lead the setpoint, such as 0Hz:50Hz:20s' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l profile -d 'Lead the setpoint by lines such as `5s, 25Hz`' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l jog -d 'Enable, run for this time, stop' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l duration -l for -d 'With --hold: end after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l on-exit -d 'Then ramp (default), quick-stop, coast or keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l watchdog -d 'Set the drive\'s own watchdog for the run' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l wait -d 'How long to wait for a state [default: 3s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l step -d 'With --view: the arrows change the setpoint by this' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l min -d 'With --step: no lower than this' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l max -d 'With --step: no higher than this' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l gsd -d 'The GSD of the slave' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l user-prm -d 'User parameters of Set_Prm (hex), if the GSD wants any' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l cfg -d 'Its configuration: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l slot-time -d 'How soon an answer begins [default: 30ms or 8ms]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l enable -d 'Walk to "operation enabled" first'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l force -d 'Give also a setpoint beyond its limit'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l hold -d 'Run only while this program runs, then --on-exit'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l view -d 'With --hold: chart and keypad; space stops'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l dead-man -d 'Like --view: runs only while a key is held'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l interval -d 'Time from round to round' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l gather -d 'Take a round for each line on stdin' -r -f -a "stdin\t''"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l duration -l for -d 'End after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l count -d 'End after this many rounds' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l textfile -d 'Keep a file with the last round, for Prometheus' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l record -d 'Keep what comes in a file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l trigger -d 'Wait for something: \'current > 12A\'' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l pre -d 'So long before a trigger is recorded [default: 2s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l post -d 'So long behind a trigger is recorded [default: 5s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l gsd -d 'The GSD of the slave' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l user-prm -d 'User parameters of Set_Prm (hex), if the GSD wants any' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l cfg -d 'Its configuration: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l slot-time -d 'How soon an answer begins [default: 30ms or 8ms]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l mode -d 'basic or profidrive [default: as Get_Cfg tells]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l reconnect -d 'Wait for a port that is lost, and go on'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l line -d 'One line that is refreshed, in place of the live view'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l once -d 'End behind the first trigger'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l unpaced -d 'On the bench: do not follow the wall clock'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l svg -d 'Write a picture' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l from -d 'From this time of the record on' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l to -d 'Until this time of the record' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l band -d 'How near its end is settled, in percent' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l measure -d 'Overshoot, settling time, slope; min, max, mean, RMS'
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand plot" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l record -d 'Show a record of `monitor --record`; repeatable' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l procedure -d 'Show the record of a `procedure`; repeatable' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l count -d 'Questions of the link test to a drive' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l changed -d 'List only what differs from factory settings'
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand report" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l given -d 'Take KEY = "VALUE" from a TOML file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l record -d 'Keep the record here, and go on from it' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l again -d 'Do again a step that moves and was begun before'
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand procedure" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -f -a "show" -d 'Protocol, speed, parity and addresses as they are stored in the drive'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -f -a "set" -d 'Brings the drive to another protocol'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -f -a "show" -d 'Speed, parity, addresses as stored; on a CAN bus node, rate, channels'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -f -a "set" -d 'Brings the drive to another speed, parity or address'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -s b -l baud -d 'New speed in baud' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l parity -d 'New parity of Modbus: even, odd, none' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -s a -l address -d 'New address: Modbus 1-247, VABus 1-30, CAN 1-63' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -a "import" -d 'Make a catalogue of your own of a list: CSV, or MBMap (JSON)'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and not __fish_seen_subcommand_from import export" -a "export" -d 'Write parameters as a table (CSV) that `params import` takes back'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l output -d 'Write the catalogue to this file [default: stdout]' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l column -d 'Which heading is which field: id=Nr (repeatable)' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l set -d 'What every row says: access=rw (repeatable)' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l own -d 'A family of its own, reached over plain Modbus' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l title -d 'What the device is called [default: from the list]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l base -d 'What the list calls register 0: 0, 1, 40001' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l ignore -d 'A key of MBMap that changes no value (repeatable)' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l separator -d 'Between the cells: `;` `,` tab [default: found out]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l decimal -d 'Before the decimals: `,` or `.` [default: found out]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l as -d 'table or mbmap [default: found out]' -r -f -a "table\t'A table: CSV, as spreadsheets write it'
mbmap\t'A map of registers: MBMap version 2, JSON'"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l replace -d 'Rows take the place of those that are there'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l low-half-first -d 'Of two registers the first holds the lower half'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l input-as-holding -d 'Input registers are read by code 3, not by code 4'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from import" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -l output -d 'Write to this file [default: stdout]' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -l excel -d 'For a German Excel: semicolons, decimal commas'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand params; and __fish_seen_subcommand_from export" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -f -a "apply" -d 'Write a plan into its drives, with one question'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -f -a "nmt" -d 'Start or stop the exchange of PDOs, reset nodes'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -f -a "plan" -d 'Check a plan and show what becomes of it'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -f -a "load" -d 'What PDOs cost the bus'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -f -a "show" -d 'How drives are set to the bus'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -f -a "check" -d 'Is a plan in its drives? 1 if a value differs'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and not __fish_seen_subcommand_from apply nmt plan load show check monitor" -f -a "monitor" -d 'Watch the bus. Never sends'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from apply" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l node -d 'The node that is told, 1 to 63 [default: all]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from nmt" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l dcf -d 'Write a DCF for each drive into this directory' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l svg -d 'Write a picture: drives, PDOs, sources' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l settings -d 'Show every setting of each drive'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from plan" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from load" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l timeout -d 'Wait for a reply [default: 500ms; 3s behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from check" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l duration -l for -d 'End after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand systembus; and __fish_seen_subcommand_from monitor" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -f -a "telegram" -d 'A telegram of Modbus, VABus or PROFIBUS-DP'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -f -a "can" -d 'Frames of CAN, as candump logs them or SLCAN has them'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -f -a "trace" -d 'A recording: of --trace, of candump, or of an SLCAN adapter'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -f -a "status" -d 'A status word (P.411), such as 0x0237'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -f -a "control" -d 'A control word (P.410), such as 0x000F'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -f -a "warnings" -d 'A warning word (P.270), such as 0x008B'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -f -a "fault" -d 'A fault code (P.260, FLT_err_num), such as F0500'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -f -a "error" -d 'A code of the error register (P.11), such as 11'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -f -a "pkw" -d 'A PKW block of PROFIBUS, such as 7393 0100 0000 0022'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -f -a "diagnosis" -d 'A diagnosis of PROFIBUS (Slave_Diag)'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -f -a "basic-status" -d 'A status word of the SJ2-PB in Basic mode, such as 0x0DD0'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram can trace status control warnings fault error pkw diagnosis basic-status basic-control" -f -a "basic-control" -d 'A control word of the SJ2-PB in Basic mode, such as 0x0050'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l cfg -d 'What PROFIBUS carries: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from can" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l cfg -d 'What PROFIBUS carries: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l candump -d 'Write the CAN frames of it as a log of candump' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l mode -d 'Control mode (P.412)' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l reply -d 'The slave says it'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from pkw" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from diagnosis" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-status" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from basic-control" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -f -a "live" -d 'Who is on the line: stations, idents, states, configurations'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -f -a "read" -d 'Parameters of one inverter, over PKW'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and not __fish_seen_subcommand_from live read module" -f -a "module" -d 'A module of the Basic mode: by name, or by its bytes'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l slot-time -d 'How soon an answer begins [default: 30ms or 8ms]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l questions -d 'Ask each station so often how it is' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l duration -d 'End --follow after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l follow -d 'Go on asking: stations as they come, go, or change'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from live" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l gsd -d 'The GSD of the slave' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l user-prm -d 'User parameters of Set_Prm (hex), if the GSD wants any' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l cfg -d 'Its configuration: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l slot-time -d 'How soon an answer begins [default: 30ms or 8ms]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from read" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l retries -d 'Repeats of a question [default: 2; 6 over CAN; 0 behind a gateway]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -l yes -d 'Answer the safety question with yes'
complete -c antrieb -n "__fish_antrieb_using_subcommand profibus; and __fish_seen_subcommand_from module" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l duration -l for -d 'End after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l count -d 'End after this many telegrams' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l pcap -d 'Keep a capture for Wireshark; - is stdout' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l filter -d 'Tell only such telegrams: \'address=3 !reply\'' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l trigger -d 'Wait for such a telegram, tell what is near' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l pre -d 'So long before a trigger is told [default: 2s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l post -d 'So long behind a trigger is told [default: 5s]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l cfg -d 'What PROFIBUS carries: basic, ppo1 to ppo5, or hex' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l statistics -d 'Tell the statistics so often, not only at the end' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -s p -l port -d 'Port: a tty, COM3, tcp://…, mbtcp://…, or `sim`' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -s a -l address -d 'Drives: `1`, `1,2,5-9`, or names of antrieb.toml' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -s b -l baud -d 'Speed in baud, or auto for `scan` [default: 19200]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l parity -d 'even, odd, none, or auto for `scan` [default: even]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l rs485 -d 'Who switches RS-485 to sending [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l rs485-before -d 'Pause before a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l rs485-after -d 'Pause behind a telegram, such as 1ms [default: 0]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l protocol -d 'rtu, ascii, vabus, sdo, dp, auto [default: rtu]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l drive -d 'act, acu, lxm05, l200, sj200, x200 [default: auto]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l word-order -d 'First half of 32 bits: high, low [default: ask]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l trace -d 'Record the line to a new file' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l search -d 'Find the setting of the line first, by listening'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l once -d 'End behind the first trigger'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l force -d 'Replace the file of --trace if it exists'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l link -d 'Name the pseudo terminal with this symbolic link' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l tcp -d 'Serve on a loopback address, such as 127.0.0.1:5020' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l duration -l for -d 'End after this time' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l format -d 'table, json (--json), ndjson, csv [default: table]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l lang -d 'en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -x -a "(__fish_antrieb_values)"
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l color -d 'Colour [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l profibus -d 'A PROFIBUS line with Hitachi inverters on it'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l can -d 'A CAN bus with drives on it, behind an adapter'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s v -l verbose -d 'Show settings and telegrams, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s h -l help -d 'Print help'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s h -l help -d 'Print help'

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
