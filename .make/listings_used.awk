# listings_used.awk - for listings.sh, check that the pages use their listings. Requires source.awk; operands: the
# pages. A page must name each of its listings in backticks in its text. A block of code of three lines or more that is
# not generated must not be a copy of a source, because it would become outdated. Variables:
#
#   sources  the files that a block may have been copied from, separated by spaces
#   library  the files whose functions and structs must all be listed or linked on some page; may be empty

function fail(where, text)
{
    print where ": " text > "/dev/stderr"
    bad = 1
}

# ---- A page ----

# Record the words of a line's inline code.
function note_spoken(line,    part, word, n, m, i, k)
{
    n = split(line, part, "`")
    for (i = 2; i < n; i += 2) {
        m = split(part[i], word, /[^A-Za-z0-9_.]+/)
        for (k = 1; k <= m; k++)
            spoken[word[k]] = 1
    }
}

# A link such as [`heightStretch`](../shaders/transform.glsl) counts as the listing of a function of a few lines. The
# source must define the name.
function note_linked(line,    part, file)
{
    while (match(line, /\[`[A-Za-z0-9_]+`\]\([^)#]*\.(glsl|frag|c|h)/)) {
        split(substr(line, RSTART + 2, RLENGTH - 2), part, /`\]\(/)
        file = part[2]
        if (!sub(/^\.\.\//, "", file) && match(page, /.*\//))
            file = substr(page, 1, RLENGTH) file
        line = substr(line, index(line, part[2]) + length(part[2]))
        read_source(file)
        if ((file, part[1]) in definitions)
            listed[file, part[1]] = 1
        else
            fail(page ":" FNR, "a link names `" part[1] "`, which " file " does not define")
    }
}

# At the end of a page, check that its text has named each of its listings.
function end_page(    i, name)
{
    for (i = 1; i <= shown; i++) {
        name = show[i]
        if (name == "*") {
            name = show_file[i]
            sub(/.*\//, "", name)
        }
        if (!(name in spoken))
            fail(page ":" show_at[i], "a listing that the page's text never names: `" name "`")
    }
    split("", spoken)
    shown = 0
}

# ---- Copies ----

# A line as it is compared with a possible copy: without its comment, and with single spaces.
function plain(line)
{
    sub(/\/\/.*/, "", line)
    gsub(/[ \t]+/, " ", line)
    gsub(/^ | $/, "", line)
    return line
}

# The line of the file at which the block begins if the file contains all lines of the block in this order, otherwise 0.
function copied_from(file,    i, k, first)
{
    read_source(file)
    k = 1
    for (i = 1; i <= lines[file] && k <= held; i++)
        if (plain(source[file, i]) == block[k]) {
            if (k++ == 1)
                first = i
        }
    return k > held ? first : 0
}

function judge_block(    file, n, i, at)
{
    n = held < 3 ? 0 : split(sources, file, " ")
    for (i = 1; i <= n; i++)
        if ((at = copied_from(file[i]))) {
            fail(page ":" block_at, "copied by hand from " file[i] ":" at ": replace it with a marker")
            return
        }
}

# ---- The pages ----

FNR == 1 {
    if (page != "")
        end_page()
    page = FILENAME
    fenced = marked = 0
}

/^ *```/ {
    if (fenced && code)
        judge_block()
    fenced = !fenced
    code = fenced && !marked && /^ *```(glsl|c)$/
    block_at = FNR
    held = marked = 0
    next
}

fenced {
    if (code && (line_plain = plain($0)) != "")
        block[++held] = line_plain
    next
}

/^<!-- code: / {
    show[++shown] = $4
    show_file[shown] = $3
    show_at[shown] = FNR
    listed[$3, $4] = marked = 1
    next
}

{
    marked = 0
    note_spoken($0)
    note_linked($0)
}

END {
    if (page != "")
        end_page()
    n = split(library, file, " ")
    for (i = 1; i <= n; i++) {
        read_source(file[i])
        m = split(names[file[i]], line, "\n")
        for (k = 1; k < m; k++) {
            split(line[k], word, " ")
            if (word[1] == "other" || (file[i] ~ /scene\.glsl$/ && word[2] ~ /^[Tt]race/))
                continue
            if (!((file[i], word[2]) in listed))
                fail(file[i] ":" from[file[i], word[2]], "the " word[1] " " word[2] " is on no page")
        }
    }
    exit bad
}
