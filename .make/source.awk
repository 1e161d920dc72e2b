# source.awk - find the definitions in a C or GLSL source, for the scripts that maintain the pages.

# A line of a source without its strings and comments, so that only brackets in its code are counted.
function bare(line)
{
    gsub(/'(\\.|[^'\\])'/, "0", line)
    gsub(/"(\\.|[^"\\])*"/, "0", line)
    if (in_comment) {
        if (!index(line, "*/"))
            return ""
        sub(/^.*\*\//, "", line)
        in_comment = 0
    }
    sub(/\/\/.*/, "", line)
    gsub(/\/\*([^*]|\*+[^*\/])*\*+\//, "", line)
    if (index(line, "/*")) {
        sub(/\/\*.*/, "", line)
        in_comment = 1
    }
    sub(/[ \t]+$/, "", line)
    return line
}

function count(text, pattern)
{
    return gsub(pattern, "", text)
}

# Record that file defines name from line first to line last. shape is function, struct or other.
function define(file, name, first, last, shape)
{
    definitions[file, name]++
    names[file] = names[file] shape " " name "\n"
    from[file, name] = first
    to[file, name] = last
}

# Record the names that a statement beginning in column 0 defines.
function define_statement(file, text, first, last,    at, head, mark, piece, shape, n, i)
{
    at = match(text, /[{=;(\[]/)
    head = substr(text, 1, at - 1)
    mark = substr(text, at, 1)
    sub(/[ \t]+$/, "", head)
    if (mark == "(" && !index(text, "{"))
        return
    if (head ~ /^extern /)
        return
    if (mark == ";" && head ~ /^(struct|enum|union) [A-Za-z0-9_]+$/)
        return
    shape = mark == "(" ? "function" : mark == "{" && head ~ /^struct / ? "struct" : "other"
    n = split(head, piece, ",")
    for (i = 1; i <= n; i++)
        if (match(piece[i], /[A-Za-z0-9_]+$/))
            define(file, substr(piece[i], RSTART), first, last, shape)
}

# Read a file, only once, and record its definitions. Returns the number of its lines, or -1 if the file cannot be read
# or is empty.
function read_source(file,    line, n, code, first, text, depth, word)
{
    if (file in lines)
        return lines[file]
    n = first = depth = in_comment = 0
    while ((getline line < file) > 0) {
        source[file, ++n] = line
        if (line ~ /\\$/ || source[file, n - 1] ~ /\\$/) {
            if (line ~ /^#define / && split(line, word, /[ (]/) >= 2)
                define(file, word[2], n, n, "other")
            continue
        }
        code = bare(line)
        if (line ~ /^#define / && split(line, word, /[ (]/) >= 2)
            define(file, word[2], n, n, "other")
        if (line ~ /^#/ || (!first && code ~ /^[A-Z_]+\([A-Z_]+\)$/)) # a directive, or a macro call alone on a line
            continue
        if (!first && code ~ /^[A-Za-z_]/) {
            first = n
            text = ""
        }
        if (!first)
            continue
        text = text " " code
        depth += count(code, "[{]") - count(code, "[}]")
        if (depth <= 0 && (code ~ /;$/ || (code ~ /}$/ && text ~ /^[^={\[]*\(/))) {
            define_statement(file, substr(text, 2), first, n)
            first = depth = 0
        }
    }
    lines[file] = n > 0 ? n : -1
    close(file)
    return lines[file]
}
