#!/bin/bash
# figures_html.sh - `make figures-html`: write each interactive figure as one file that loads nothing,
# build/figures/NAME.html, and build/figures/index.html, which lists them.
set -eu
. .make/write.sh
begin build
mkdir "$new/figures"
node docs/web/figures_html.mjs "$new/figures"
keep figures
echo "build/figures/index.html lists $(find build/figures -name '[0-9]*.html' | wc -l) figures"
