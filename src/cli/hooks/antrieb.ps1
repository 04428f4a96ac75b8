
    # Values come from the program itself; what it has nothing for is completed as below.
    $typed = @($commandAst.CommandElements | ForEach-Object { $_.Extent.Text.Trim("'", '"') })
    $behind = @($typed | Select-Object -Skip 1)
    $next = @(if ($wordToComplete -eq '') { '--next' })
    $found = @(& $typed[0] complete powershell @next '--' @behind 2>$null)
    if ($found.Count -gt 0) {
        return $found | ForEach-Object {
            $value, $told = $_ -split "`t", 2
            if (-not $told) { $told = $value }
            if ($value.StartsWith('@')) { $text = "'$value'" } else { $text = $value }
            [CompletionResult]::new($text, $value, [CompletionResultType]::ParameterValue, $told)
        }
    }
