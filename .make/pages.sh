# shellcheck shell=sh
# pages.sh - read by the scripts that set all pages: their order. How to read the course, the chapters, what is
# looked up, how to teach it, how the house is built.

pages() {
    for page in docs/README.md docs/[0-9][0-9]_*.md; do
        [ ! -e "$page" ] || echo "$page"
    done
    for name in using platforms benchmark errata errata_workshop errata_sky glossary teaching architecture contributing; do
        echo "docs/$name.md"
    done
}
