#!/bin/sh
# handouts.sh - `make handouts`: typeset the labs of docs/teaching.md for students, two pages each, as
# build/handouts.pdf, and their answers, a page for each lab, as build/handouts-answers.pdf.
set -u
export LC_ALL=C

folder=build/handouts
rm -rf "$folder"
mkdir -p "$folder" || exit 1
cat >"$folder/head.tex" <<'END'
\newfontfamily{\symbolfont}{DejaVu Sans}
\usepackage{amssymb}
\usepackage{graphicx}
\newcommand{\heading}[2]{\par\vspace{2mm}{\csname #1\endcsname\bfseries #2\par}\nopagebreak}
\newcommand{\writing}{\par\vspace{6mm}\noindent\hrulefill\par}
\setlength{\parskip}{2mm}
\setlength{\parindent}{0pt}
\raggedright
\emergencystretch=3em
\pagestyle{empty}
END

# write_pdf NAME OPTION...: write build/NAME.pdf.
write_pdf() {
    name=$1
    shift
    if ! pandoc -s -f gfm+tex_math_dollars docs/teaching.md --lua-filter .make/handouts.lua "$@" -o "build/$name.pdf" \
        --pdf-engine=xelatex -H "$folder/head.tex" -M lang=en-GB -V documentclass=article -V papersize=a4 \
        -V geometry:margin=20mm -V fontsize=11pt -V mainfont='TeX Gyre Pagella' -V monofont='DejaVu Sans Mono' \
        -V monofontoptions='Scale=0.8' 2>"$folder/log"; then
        echo "make: the handouts could not be typeset: $(grep -E -m 1 -A 2 '^!|Error' "$folder/log" | tr '\n' ' ')" >&2
        exit 1
    fi
    if grep 'Missing character' "$folder/log" | sort -u | grep . >&2; then
        echo 'make: docs/teaching.md or docs/questions.txt: the font of the handouts lacks these characters' >&2
        exit 1
    fi
    echo "build/$name.pdf: $(pdfinfo "build/$name.pdf" | awk '/^Pages/ { print $2 " pages" }')"
}

write_pdf handouts
write_pdf handouts-answers -M answers=true
