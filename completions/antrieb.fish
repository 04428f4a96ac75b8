# Print an optspec for argparse to handle cmd's options that are independent of any subcommand.
function __fish_antrieb_global_optspecs
    string join \n p/port= a/address= b/baud= parity= stop-bits= data-bits= rs485= rs485-before= rs485-after= protocol= drive= word-order= timeout= retries= format= json lang= q/quiet v/verbose trace= color= no-progress catalogue= config= no-config dry-run force yes h/help V/version
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

complete -c antrieb -n "__fish_antrieb_needs_command" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_needs_command" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_needs_command" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_needs_command" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_needs_command" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_needs_command" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_needs_command" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_needs_command" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_needs_command" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_needs_command" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_needs_command" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_needs_command" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_needs_command" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_needs_command" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_needs_command" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_needs_command" -s V -l version -d 'Print version'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "scan" -d 'Finds every drive on a line, whatever its setting'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "identify" -d 'Tells what a drive is, and how it is set up for talking to it'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "read" -d 'Reads parameters'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "write" -d 'Writes parameters'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "dataset" -d 'Shows, selects, copies and compares the four data sets of a drive'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "diag" -d 'Diagnoses a drive and the line to it'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "statemachine" -d 'Shows the state of the drive, and walks it through its state machine'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "state" -d 'Shows the state of the drive, and walks it through its state machine'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "sollwert" -d 'Shows setpoints and actual values side by side, or gives a setpoint'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "setpoint" -d 'Shows setpoints and actual values side by side, or gives a setpoint'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "monitor" -d 'Watches drives: state, setpoint, actual value, current, fault and warnings, or parameters of your choice'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "protocol" -d 'Shows or changes the protocol of a drive: Modbus RTU, Modbus ASCII, VABus'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "line" -d 'Changes speed, parity or address of a drive, and follows it'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "params" -d 'Browses the parameter catalogue. No drive is needed'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "decode" -d 'Explains telegrams, words and codes. No drive is needed'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "sniff" -d 'Listens on a line and tells every telegram: when, who speaks, the bytes, and what they say. Never sends'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "simulate" -d 'Serves simulated drives in real time on a pseudo terminal or a TCP port'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "schema" -d 'Prints the JSON Schema of a verb\'s output, or of every verb\'s'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "completions" -d 'Prints a completion script'
complete -c antrieb -n "__fish_antrieb_needs_command" -f -a "man" -d 'Prints a man page: of the program, or of a verb'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l resume -d 'Go on where this result of `scan --json` ends' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l thorough -d 'By the book: gives every address its full time before the next is asked'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l fast -d 'One time around, nothing is asked again; the first setting with a drive ends the search for settings'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l until-first -d 'The first drive ends the search'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand scan" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand identify" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l type -d 'Read with this type, whatever the catalogue says: uint, int, word, long' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l decimals -d 'Show this many decimals, whatever the catalogue says' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand read" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l type -d 'Write with this type, whatever the catalogue says: uint, int, word, long' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l decimals -d 'Take the value with this many decimals, whatever the catalogue says' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l force -d 'Send also what the catalogue forbids or what would change nothing, and let the drive judge'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand write" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -f -a "show" -d 'Show parameters in all four data sets side by side'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -f -a "active" -d 'Show which data set the drive works with (P.249) and what selects it (P.414)'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -f -a "select" -d 'Select a data set (P.414): 1-4, or 0 for the digital inputs'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -f -a "copy" -d 'Copy the values of one data set into another'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and not __fish_seen_subcommand_from show active select copy diff" -f -a "diff" -d 'Compare two data sets; exits with 1 if they differ'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from active" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l ram -d 'Select in RAM only, until power-off'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from select" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l ram -d 'Copy into RAM only, until power-off'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from copy" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand dataset; and __fish_seen_subcommand_from diff" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l link-test -d 'Ask N harmless questions and show error rate and reply times' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l clear -d 'Set the diagnostic counters to zero after showing them'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l check -d 'For scripts: exit with 1 if a fault is present'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and not __fish_seen_subcommand_from line" -f -a "line" -d 'The line itself'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l count -d 'How many questions to ask each drive' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand diag; and __fish_seen_subcommand_from line" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "show" -d 'Show state, words, control mode, what is missing (the default)'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "shutdown" -d 'Shut down: to "ready to switch on"'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "switch-on" -d 'Walk to "switched on"; the shaft does not turn yet'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "enable" -d 'Walk to "operation enabled": the motor is powered and follows its setpoint'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "disable" -d 'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "disable-voltage" -d 'Disable voltage: the shaft coasts'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "quick-stop" -d 'Quick stop: by the emergency ramps P.424 and P.425'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "reset" -d 'Reset a fault: once, when the drive\'s 15 s lock has passed'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "goto" -d 'Walk to a state, the shortest way'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "contacts" -d 'Set virtual contacts through the control word (P.412 = 2): S1IND … S6IND, MFI1D, EM-S1IND … EM-S3IND'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from shutdown" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from switch-on" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from enable" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from disable-voltage" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from quick-stop" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from reset" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from goto" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand statemachine; and __fish_seen_subcommand_from contacts" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "show" -d 'Show state, words, control mode, what is missing (the default)'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "shutdown" -d 'Shut down: to "ready to switch on"'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "switch-on" -d 'Walk to "switched on"; the shaft does not turn yet'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "enable" -d 'Walk to "operation enabled": the motor is powered and follows its setpoint'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "disable" -d 'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "disable-voltage" -d 'Disable voltage: the shaft coasts'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "quick-stop" -d 'Quick stop: by the emergency ramps P.424 and P.425'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "reset" -d 'Reset a fault: once, when the drive\'s 15 s lock has passed'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "goto" -d 'Walk to a state, the shortest way'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and not __fish_seen_subcommand_from show shutdown switch-on enable disable disable-voltage quick-stop reset goto contacts" -f -a "contacts" -d 'Set virtual contacts through the control word (P.412 = 2): S1IND … S6IND, MFI1D, EM-S1IND … EM-S3IND'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from shutdown" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from switch-on" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from enable" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from disable-voltage" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from quick-stop" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from reset" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from goto" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand state; and __fish_seen_subcommand_from contacts" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l mode -d 'What is set: frequency, percent (ACTIVE); velocity, position, homing, current, speed, gear, jog (LXM05)' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l set -d 'Set a parameter of the mode first, such as RAMPacc=2000; with --hold it is given back' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l start -d 'How the movement starts, in modes that need it: absolute (default), relative' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l until -d 'Wait for something before the program goes on: `reached` (status bit 10); the time of --duration begins there' -r -f -a "reached\t'The drive reports the setpoint as reached'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l source -d 'Set what forms the setpoint for the run, in RAM; ACTIVE P.434: line = line setpoint only, sum = internal and line setpoint added' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l ramp -d 'Lead the setpoint on a straight line: FROM:TO:TIME, such as 0Hz:50Hz:20s' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l profile -d 'Lead the setpoint by a file of lines `TIME, SETPOINT`, such as `5s, 25Hz`' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l jog -d 'Enable, run for this time, stop: the same as --enable --hold --duration TIME' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l enable -d 'Walk the state machine to "operation enabled" first'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l force -d 'Give also a setpoint beyond its limit, and let the drive judge'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand sollwert" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l mode -d 'What is set: frequency, percent (ACTIVE); velocity, position, homing, current, speed, gear, jog (LXM05)' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l set -d 'Set a parameter of the mode first, such as RAMPacc=2000; with --hold it is given back' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l start -d 'How the movement starts, in modes that need it: absolute (default), relative' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l until -d 'Wait for something before the program goes on: `reached` (status bit 10); the time of --duration begins there' -r -f -a "reached\t'The drive reports the setpoint as reached'"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l source -d 'Set what forms the setpoint for the run, in RAM; ACTIVE P.434: line = line setpoint only, sum = internal and line setpoint added' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l ramp -d 'Lead the setpoint on a straight line: FROM:TO:TIME, such as 0Hz:50Hz:20s' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l profile -d 'Lead the setpoint by a file of lines `TIME, SETPOINT`, such as `5s, 25Hz`' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l jog -d 'Enable, run for this time, stop: the same as --enable --hold --duration TIME' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l duration -d 'With --hold: end after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l on-exit -d 'How to stop at the end, on Ctrl-C, on an error; another Ctrl-C takes the next stronger way: ramp (ACTIVE: P.392 decides; LXM05: setpoint 0, or a quick stop in modes that it does not stop), quick-stop, coast, keep' -r -f -a "ramp\t'Disable operation: transition 5, which coasts, brakes or ramps as P.392 says'
quick-stop\t'Quick stop: the emergency ramps P.424 and P.425'
coast\t'Disable voltage: the shaft coasts'
keep\t'Leave it running'"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l watchdog -d 'Set the drive\'s own watchdog (P.413, MBnode_guard) to this time for the run, in RAM, and restore it afterwards' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l wait -d 'How long to wait for a state beyond what ramps and holding times need, at most 10 min in all unless this is longer; and how long missing answers are borne where the drive has no watchdog (with one: half of its time) [default: 3s]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l enable -d 'Walk the state machine to "operation enabled" first'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l force -d 'Give also a setpoint beyond its limit, and let the drive judge'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l hold -d 'Keep the drive running only while this program runs, then stop it as --on-exit says'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l take-control -d 'ACTIVE: take control with P.412 = 1 for the run, in RAM, and give it back afterwards'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand setpoint" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l interval -d 'Time from round to round; 0 is as fast as the line allows' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l duration -d 'End after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l count -d 'End after this many rounds' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l reconnect -d 'Wait for a port that is lost, such as an adapter that was unplugged, and go on when it is back'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l line -d 'One line that is refreshed, in place of the live view'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l unpaced -d 'On the built-in bench: do not follow the wall clock; minutes of the bench take milliseconds'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand monitor" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -f -a "show" -d 'Protocol, speed, parity and addresses as they are stored in the drive'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and not __fish_seen_subcommand_from show set" -f -a "set" -d 'Brings the drive to another protocol'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand protocol; and __fish_seen_subcommand_from set" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -f -a "show" -d 'Speed, parity and addresses as they are stored in the drive'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and not __fish_seen_subcommand_from show set" -f -a "set" -d 'Brings the drive to another speed, parity or address'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from show" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -s b -l baud -d 'New speed; ACTIVE: 2400, 4800, 9600, 19200, 57600 or 115200, LXM05: 9600, 19200 or 38400' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l parity -d 'New parity of Modbus: even, odd, none' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -s a -l address -d 'New address: of Modbus 1-247 (P.1376, MBadr), of VABus 1-30 (P.394)' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l now-baud -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l now-parity -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l now-address -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand line; and __fish_seen_subcommand_from set" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand params" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "telegram" -d 'A telegram of Modbus or VABus: hex bytes, or an ASCII telegram from its colon on'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "trace" -d 'A recording made with --trace'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "status" -d 'A status word (P.411), such as 0x0237'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "control" -d 'A control word (P.410), such as 0x000F'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "warnings" -d 'A warning word (P.270), such as 0x008B'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "fault" -d 'A fault code (P.260, FLT_err_num), such as F0500, EB303, 0x0500 or 1280'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and not __fish_seen_subcommand_from telegram trace status control warnings fault error" -f -a "error" -d 'A code of the error register (P.11), such as 11'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from telegram" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from trace" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from status" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l mode -d 'Control mode (P.412) that decides what the bits mean: 0 contacts, 1 state machine, 2 remote contacts' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from control" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from warnings" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from fault" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand decode; and __fish_seen_subcommand_from error" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l for -d 'End after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l count -d 'End after this many telegrams' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand sniff" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l link -d 'Name the pseudo terminal with this symbolic link' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l tcp -d 'Serve on this loopback address instead of a pseudo terminal, such as 127.0.0.1:5020' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l for -d 'End after this time' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand simulate" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand schema" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand completions" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s p -l port -d 'Where the drives are: a tty (/dev/ttyUSB0, COM3), a network port, or `sim`, the built-in bench [env: ANTRIEB_PORT]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s a -l address -d 'Drives to talk to: `1`, `1,2,5-9`, or a name from antrieb.toml; 0 writes to everybody' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s b -l baud -d 'Speed in baud; `auto`: scan finds it [default: 19200]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l parity -d 'Parity: even, odd, none; `auto`: scan finds it [default: even]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l stop-bits -d 'Stop bits [default: 1; 2 without parity]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l data-bits -d 'Data bits [default: 8 for RTU, 7 for ASCII]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l rs485 -d 'Who switches an RS-485 line between sending and listening: auto, kernel, rts, adapter [default: auto]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l rs485-before -d 'Wait so long between switching to sending and the telegram, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l rs485-after -d 'Wait so long between the telegram and switching to listening, such as 1ms [default: 0]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l protocol -d 'Protocol on the line: rtu, ascii, vabus; `auto`: scan finds it [default: rtu]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l drive -d 'What the drives are: auto, act, acu, lxm05 [default: auto, ask the drive]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l word-order -d 'Which half of a 32-bit value goes first, where values take two registers: high, low [default: ask the drive]' -r -f -a "high\t'The upper 16 bits'
low\t'The lower 16 bits'"
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l timeout -d 'How long to wait for a reply, such as 500ms or 2s [default: 500ms; 3s behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l retries -d 'How often to repeat a question that got no valid reply [default: 2; 0 behind a gateway]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l format -d 'Output: table, json, ndjson, csv [default: table]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l lang -d 'Language of names and texts: en, de [default: from LC_ALL, LC_MESSAGES, LANG]' -r
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l trace -d 'Record the line to a new file that `decode trace` reads; --force replaces an old one' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l color -d 'Colour: auto, always, never [default: auto]' -r -f -a "auto\t'On a terminal, unless NO_COLOR is set or TERM is dumb'
always\t'Always'
never\t'Never'"
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l catalogue -d 'More catalogue files; later ones win (repeatable)' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l config -d 'Project file to read in place of ./antrieb.toml' -r -F
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l json -d 'Same as --format json'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s q -l quiet -d 'Less on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s v -l verbose -d 'Show the settings with where each comes from, and every telegram, decoded, with its time, on stderr'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l no-progress -d 'No progress bar'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l no-config -d 'Read no project file and no user configuration'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l dry-run -d 'Show the telegrams that would be sent; open nothing'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l force -d 'Replace the file of --trace if it exists, and do what the verb does not do unasked'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -l yes -d 'Answer the safety question with yes; never taken from environment or files'
complete -c antrieb -n "__fish_antrieb_using_subcommand man" -s h -l help -d 'Print help (see more with \'--help\')'
