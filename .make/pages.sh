# shellcheck shell=sh
# pages.sh - lists all pages, for the scripts that typeset them and source this file. The order is: how to read the
# course, the chapters, the reference pages, the guide for teachers, and the pages on the code.

pages() {
    for page in docs/README.md docs/[0-9][0-9]_*.md; do
        [ ! -e "$page" ] || echo "$page"
    done
    for name in engine using platforms benchmark errata errata_workshop errata_sky further_reading glossary teaching architecture contributing; do
        [ ! -e "docs/$name.md" ] || echo "docs/$name.md" # the course for students has no guide for teachers
    done
}
