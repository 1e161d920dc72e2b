# listings.awk - process one page for listings.sh: it reads the page from standard input or an operand, and writes it
# with regenerated blocks to standard output. Requires source.awk. Variables: mode (write, check), page, build.

function fail(text)
{
    print page ":" FNR ": " text > "/dev/stderr"
    bad = 1
}

# ---- Listings ----

# The listing of a name, with its lines joined by newlines, or "" after an error.
function listing(file, name,    first, last, text, i)
{
    if (read_source(file) < 0) {
        fail("listing: " file ": cannot be read, or is empty")
        return ""
    }
    first = 1
    last = lines[file]
    if (name != "*") {
        if (definitions[file, name] != 1) {
            fail("listing: " file (definitions[file, name] ? \
                ": defines " name " more than once" : ": defines no " name))
            return ""
        }
        first = from[file, name]
        last = to[file, name]
    }
    for (i = first; i <= last; i++)
        text = text source[file, i] "\n"
    return "```" (file ~ /\.[ch]$/ ? "c" : file ~ /\.(glsl|frag|vert)$/ ? "glsl" : "") "\n" \
        text "```\n"
}

# ---- The table of parameters ----

# The part of a line from column a up to, but not including, column b, or to the end if b is 0, without outer spaces.
function cell(line, a, b,    text)
{
    text = b ? substr(line, a, b - a) : substr(line, a)
    gsub(/^ +| +$/, "", text)
    gsub(/\|/, "\\|", text)
    return text
}

# The parameters and textures of a program as Markdown tables, or "" after an error. The words in the first line of each
# table that --list prints determine where its columns begin.
function table(stem,    command, line, text, n, name, at, i, wrong)
{
    command = build "/" stem " --list"
    while ((command | getline line) > 0) {
        if (line == "") {
            n = 0
            text = text "\n"
        } else if (!n) {
            n = split(line, name, " ")
            wrong = wrong || name[1] !~ /^(name|texture)$/
            for (i = 1; i <= n; i++) {
                at[i] = index(line, name[i])
                text = text (i > 1 ? " " : "| ") name[i] " |"
            }
            text = text "\n|"
            for (i = 1; i <= n; i++)
                text = text " --- |"
            text = text "\n"
        } else {
            text = text "| `" cell(line, at[1], at[2]) "` |"
            for (i = 2; i <= n; i++)
                text = text " " cell(line, at[i], i < n ? at[i + 1] : 0) " |"
            text = text "\n"
        }
    }
    if (close(command) != 0 || wrong || text == "") {
        fail("parameters: " command ": failed, or prints no table: run make first")
        return ""
    }
    return text
}

# ---- The reading time ----

# The minutes that it takes to read a number of words, rounded up to a multiple of five.
function minutes(words, a_minute)
{
    return 5 * int((words / a_minute + 4.999) / 5)
}

# The keys that --help lists, as a Markdown table, or "" after an error. A line that begins further to the right than
# the keys goes on with the meaning of the line above.
function keys(    command, line, rows, listed, key, meaning)
{
    command = build "/00_first_scene --help"
    while ((command | getline line) > 0) {
        if (line ~ /^In the window/)
            listed = 1
        else if (listed && line == "")
            listed = 0
        else if (listed && line ~ /^   /)
            sub(/ \|\n$/, substr(line, 21) " |\n", rows)
        else if (listed) {
            key = substr(line, 3)
            meaning = key
            sub(/  .*/, "", key)
            sub(/^([^ ]+ )* +/, "", meaning)
            rows = rows "| " key " | " meaning " |\n"
        }
    }
    close(command)
    if (rows == "")
        fail("keys: " command ": lists no keys: run make first")
    return rows == "" ? "" : "| key | what it does |\n| --- | --- |\n" rows
}

# The time for the page, at 200 words of the story or 100 words of the proofs per minute: first with and then without
# the minutes that words.awk gives for figures, questions, formulas and listings.
function time(    command, line, word)
{
    command = "awk -f .make/words.awk \"" page "\""
    command | getline line
    close(command)
    split(line, word, " ")
    return "**Time.** " minutes(word[1] + 200 * word[3], 200) " minutes with its figures and questions, " \
        minutes(word[1], 200) " if you only read" (word[2] ? ", and " minutes(word[2], 100) " more for the proofs" : "") ".\n"
}

# ---- The page ----

# The block that a marker requests, or "" after an error.
function block(line,    word, n)
{
    n = split(line, word, " ")
    if (line == "<!-- time -->")
        return time()
    if (line == "<!-- keys -->")
        return keys()
    if (word[2] == "parameters:" && n == 4 && word[4] == "-->")
        return table(word[3])
    if (word[2] == "code:" && n == 5 && word[5] == "-->")
        return listing(word[3], word[4])
    fail("malformed marker: " line)
    return ""
}

# After the block below a marker has been read, write the new one.
function finish()
{
    if (old != fresh && mode == "check") {
        print page ":" at ": differs from its source (make docs rewrites it): " marker \
            > "/dev/stderr"
        bad = 1
    }
    printf "%s", fresh
    state = "text"
}

BEGIN { state = "text" }

# On the first line below a marker, either the old block begins, or there is no block yet.
state == "marker" {
    begins = marker ~ /^<!-- code:/ ? "^```" : marker ~ /^<!-- time/ ? "^\\*\\*Time\\.\\*\\*" : "^\\|"
    if ($0 ~ begins) {
        state = begins == "^```" ? "listing" : "rows"
        old = $0 "\n"
        next
    }
    finish()
}

state == "listing" {
    old = old $0 "\n"
    if (/^```$/)
        finish()
    next
}

# After an empty line, a second table may follow, which lists the textures.
state == "rows" {
    if ($0 ~ begins) {
        old = old held $0 "\n"
        held = ""
        next
    }
    if ($0 == "" && held == "") {
        held = "\n"
        next
    }
    finish()
    printf "%s", held
    held = ""
}

# Markers inside another fence are text and are ignored.
state == "text" && /^```/ { fenced = !fenced }

{ print }

state == "text" && !fenced && /^<!-- *(code:|parameters:|keys|time)/ {
    marker = $0
    at = FNR
    old = ""
    fresh = block($0)
    if (fresh != "")
        state = "marker"
}

END {
    if (state == "listing")
        fail("the fence below line " at " has no end")
    else if (state != "text") {
        finish()
        printf "%s", held
    }
    if (fenced)
        fail("a fence has no end")
    exit bad
}
