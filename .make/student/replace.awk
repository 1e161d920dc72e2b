# replace.awk FILE - print the file after replacing the sentences that a list gives for it. Variables: name, the file's
# name in the list; list, the path of replaced.txt. Fails if a sentence is not found.
BEGIN {
    while ((getline line < list) > 0)
        if (line !~ /^#/ && index(line, name " | ") == 1) {
            line = substr(line, length(name) + 4)
            at = index(line, " |")
            before[++count] = substr(line, 1, at - 1)
            after[count] = substr(line, at + 3)
            sub(/^ +/, "", after[count])
        }
    RS = "\001"
}
{
    text = $0
    for (i = 1; i <= count; i++) {
        pattern = before[i]
        gsub(/[][().*|`+?^$\\]/, "[&]", pattern)
        gsub(/\[\[\]/, "\\[", pattern)
        gsub(/\[\]\]/, "\\]", pattern)
        gsub(/ +/, "[ \n]+", pattern)
        if (after[i] == "") pattern = pattern "\n?"
        if (!match(text, pattern)) {
            printf "make: %s: replaced.txt names a sentence that this page does not contain: %s\n", name, before[i] > "/dev/stderr"
            failed = 1
            exit
        }
        text = substr(text, 1, RSTART - 1) after[i] substr(text, RSTART + RLENGTH)
    }
    printf "%s", text
}
END { exit failed }
