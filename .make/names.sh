# shellcheck shell=sh
# names.sh - prints names and other text that a user, a file or a program has given. Such text may contain anything: a
# terminal obeys some bytes, and a line break ends a row of a table. Scripts here print it only with these functions.
export LC_ALL=C

# clean MOST TEXT: print the text in one line, with \x1b and so on instead of control characters, of bytes that are not
# UTF-8, and of characters that reverse the order of others. If the text has more than MOST characters, the middle is
# left out; 0 means that nothing is.
clean() {
    case $2 in
    *[!\ -~]*) ;;
    *) if [ "$1" = 0 ] || [ "${#2}" -le "$1" ]; then
        printf '%s\n' "$2"
        return
    fi ;;
    esac
    # awk prints only ASCII, because not every awk can print single bytes.
    # shellcheck disable=SC2016 # the dollar is awk's
    printf '%b\n' "$(printf '%s' "$2" | od -An -v -tu1 | awk -v most="$1" '
        { for (i = 1; i <= NF; i++) byte[++n] = $i }
        END {
            for (i = 1; i <= n; i += size) {
                a = byte[i]; b = byte[i + 1]; c = byte[i + 2]
                size = a < 128 ? 1 : a >= 194 && a < 224 ? 2 : a >= 224 && a < 240 ? 3 : a >= 240 && a < 245 ? 4 : 0
                for (k = 1; k < size; k++)
                    if (byte[i + k] < 128 || byte[i + k] > 191) size = 0
                shown = size && a >= 32 && a != 127 && !(a == 194 && b < 160) && # control characters
                    !(a == 224 && b < 160 || a == 237 && b > 159 || a == 240 && b < 144 || a == 244 && b > 143) && # no UTF-8
                    !(a == 226 && (b == 128 && c >= 168 && c <= 174 || b == 129 && c >= 166 && c <= 169)) # order
                if (!shown) size = 1
                text[++m] = shown ? "" : sprintf("\\0134x%02x", a)
                for (k = 0; shown && k < size; k++) text[m] = text[m] sprintf("\\0%03o", byte[i + k])
            }
            for (i = 1; i <= m; i++)
                if (most == 0 || m <= most || i <= most / 2 || i > m - most / 2) printf "%s", text[i]
                else if (!left_out++) printf "..."
        }')"
}

# plain TEXT: print the whole text. is_plain TEXT: true if nothing in it needs to be replaced.
plain() { clean 0 "$1"; }
is_plain() { [ "$(plain "$1")" = "$1" ]; }

# report WORDS: print a message in one line. fail STATUS WORDS: end the script with a message.
report() {
    printf 'make: %s\n' "$(clean 1600 "$*")" >&2
}
fail() {
    status=$1
    shift
    report "$*"
    exit "$status"
}
