
    # Values come from the program itself, and nothing is added to them by anybody else; options and verbs are completed as below.
    $typed = @($commandAst.CommandElements | ForEach-Object { $_.Extent.Text.Trim("'", '"') })
    $behind = @($typed | Select-Object -Skip 1)
    $next = @(if ($wordToComplete -eq '') { '--next' })
    $found = @(& $typed[0] complete powershell @next '--' @behind 2>$null)
    # Where nothing is returned PowerShell completes files; an empty word keeps it from that.
    if ($found.Count -gt 0 -and $found[0] -eq "`tfiles") { return }
    if ($found.Count -gt 0 -and $found[0].StartsWith("`t")) { return '' }
    if ($found.Count -gt 0) {
        return $found | ForEach-Object {
            $value, $told = $_ -split "`t", 2
            if (-not $told) { $told = $value }
            if ($value.StartsWith('@')) { $text = "'$value'" } else { $text = $value }
            [CompletionResult]::new($text, $value, [CompletionResultType]::ParameterValue, $told)
        }
    }
