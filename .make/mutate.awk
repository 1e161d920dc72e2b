# mutate.awk - random mutations of C and GLSL sources, chosen by a seed.
#
#   awk -v seed=1 -v count=30 -f .make/mutate.awk FILE...
#
# The script prints up to count mutations, each as a line of file, line number, old line and new line, separated by
# byte 31. Comments, strings and preprocessor lines are never changed. A line is chosen first, then one of its
# mutations. The script has its own random generator, because every awk has a different rand.

function random(n) # from 0 to n - 1; the products stay below 2^53, so they are exact
{
    state = (state * 16807) % 2147483647
    return int(state / 2147483647 * n)
}

# The code of a line: strings and /* */ comments are replaced with blanks of the same length, and a // comment is cut
# off.
function code_of(line,    i, c, two, quote, out)
{
    out = ""
    for (i = 1; i <= length(line); i++) {
        c = substr(line, i, 1)
        two = substr(line, i, 2)
        if (in_comment && two == "*/" || !in_comment && quote == "" && two == "/*") {
            in_comment = !in_comment
            out = out "  "
            i++
        } else if (in_comment)
            out = out " "
        else if (quote != "") {
            if (c == "\\") {
                out = out " "
                i++
            } else if (c == quote)
                quote = ""
            out = out " "
        } else if (two == "//")
            break
        else if (c == "\"" || c == "'") {
            quote = c
            out = out " "
        } else
            out = out c
    }
    return out
}

# Record the mutation that replaces `size` characters at position `at` with `text`.
function mutation(at, size, text)
{
    change[lines, ++changes[lines]] = substr($0, 1, at - 1) text substr($0, at + size)
}

# The position of the bracket that closes the bracket at position `at`, or 0 if it is not on this line. comma receives
# the positions of the commas between the two, outside inner brackets.
function closing(code, at,    i, c, depth)
{
    comma_count = 0
    for (i = at; i <= length(code); i++) {
        c = substr(code, i, 1)
        if (c == "(" || c == "[")
            depth++
        else if ((c == ")" || c == "]") && --depth == 0)
            return i
        else if (c == "," && depth == 1)
            comma[++comma_count] = i
    }
    return 0
}

function change_call(code, at, name,    open, end, value)
{
    open = at + length(name)
    end = closing(code, open)
    if (name in other)
        mutation(at, length(name), other[name])
    if (!end)
        return
    value = "(" substr($0, open + 1, (comma_count ? comma[1] : end) - open - 1) ")"
    if (name ~ /^(clamp|abs|fabs|fabsf)$/ ||
        name ~ /max/ && comma_count == 1 && substr(code, comma[1], end - comma[1]) ~ /^, 0(\.0f?)?$/)
        mutation(at, end - at + 1, value)
    if (name ~ /^(if|while) ?$/)
        mutation(open, end - open + 1, "(!" substr($0, open, end - open + 1) ")")
}

function change_word(code, at, word,    before, value)
{
    before = at > 1 ? substr(code, at - 1, 1) : " "
    if (word ~ /^[0-9]/) {
        value = word
        sub(/[fuUL]+$/, "", value)
        if (word ~ /^0[xX]/)
            return
        if (word ~ /[.eE]/)
            mutation(at, length(word), value * 1 == 0 ? "0.5" : sprintf("%#.8g", value * 1.5))
        else
            mutation(at, length(word), value + 1)
    } else if (before == "." && word in other)
        mutation(at, length(word), other[word])
    else if (before != "." && substr(code, at + length(word), 1) == "(")
        change_call(code, at, word)
    else if (substr(code, at + length(word), 2) == " (" && word ~ /^(if|while)$/) {
        change_call(code, at, word " ")
    }
}

function survey(code,    at, rest, word)
{
    for (at = 1; at <= length(code); at += length(word)) {
        rest = substr(code, at)
        if (match(rest, /^([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?[fuUL]*/) || match(rest, /^[A-Za-z_][A-Za-z_0-9]*/)) {
            word = substr(rest, 1, RLENGTH)
            change_word(code, at, word)
        } else if (match(rest, /^ ([-+*\/<>]|[<>=!]=|&&|\|\||[-+*\/]=) /)) {
            word = substr(rest, 1, RLENGTH - 1)
            mutation(at + 1, RLENGTH - 2, swap[substr(word, 2)])
        } else if (match(rest, /^[(=,] ?-[A-Za-z_0-9(]/) || match(rest, /^ -[A-Za-z_0-9(]/)) {
            mutation(at + RLENGTH - 2, 1, "")
            word = substr(rest, 1, RLENGTH - 1)
        } else
            word = " "
    }
    sub(/ +$/, "", code)
    if (code ~ /^ +[^ {}][^{}]*;$/ && code !~ /^ +(for |return|[A-Za-z_0-9]+( [A-Za-z_0-9]+)* [*]*[A-Za-z_])/ &&
        previous ~ /[;{})] *$/) { # a statement, neither a declaration nor a return
        match(code, /^ +/)
        mutation(RLENGTH + 1, length(code) - RLENGTH, ";")
    }
}

BEGIN {
    split("+ - - + * / / * < <= <= < > >= >= > == != != == && || || && += -= -= += *= /= /= *=", pair, " ")
    for (i = 1; i in pair; i += 2)
        swap[pair[i]] = pair[i + 1]
    split("min max max min fmin fmax fmax fmin fminf fmaxf fmaxf fminf x y y z z x xy yx xz zx yz zy xyz yzx", pair, " ")
    for (i = 1; i in pair; i += 2)
        other[pair[i]] = pair[i + 1]
}

FNR == 1 { in_comment = in_macro = 0; previous = "" }

{
    code = code_of($0)
    skip = in_macro || code ~ /^ *#/ || code ~ /^ *(layout|precision|uniform)/
    in_macro = (in_macro || code ~ /^ *#/) && /\\$/
    if (skip || code ~ /^ *$/)
        next
    lines++
    survey(code)
    if (changes[lines]) {
        file[lines] = FILENAME
        number[lines] = FNR
        old[lines] = $0
    } else
        lines--
    previous = code
}

END {
    state = (seed * 7919 + 12345) % 2147483646 + 1
    for (i = 0; i < 10; i++)
        random(2)
    for (printed = 0; printed < count && lines > 0; printed++) {
        line = random(lines) + 1
        pick = random(changes[line]) + 1
        printf "%s\037%d\037%s\037%s\n", file[line], number[line], old[line], change[line, pick]
        change[line, pick] = change[line, changes[line]]
        if (--changes[line] == 0) { # the last line moves into the free slot
            for (i = 1; i <= changes[lines]; i++)
                change[line, i] = change[lines, i]
            file[line] = file[lines]
            number[line] = number[lines]
            old[line] = old[lines]
            changes[line] = changes[lines]
            lines--
        }
    }
}
