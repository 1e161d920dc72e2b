#!/bin/sh
# questions.sh - `make questions`: write the exit questions of docs/questions.txt for learning platforms, as GIFT and as
# Moodle's XML, into build/questions/. QUESTIONS and QUESTIONS_FOLDER replace the file and the folder; the tests set
# both.
set -eu
export LC_ALL=C
source=${QUESTIONS:-docs/questions.txt} folder=${QUESTIONS_FOLDER:-build/questions}
[ -r "$source" ] || { echo "make: $source: no such file: the course for students has no questions" >&2; exit 2; }
mkdir -p "$folder"
for form in gift xml; do
    if ! awk -v form="$form" -f .make/questions.awk docs/[0-9][0-9]_*.md "$source" >"$folder/ray-marching.$form"; then
        rm -f "$folder"/ray-marching.*
        exit 1
    fi
done
echo "$folder/ray-marching.gift and $folder/ray-marching.xml: $(grep -c '^## ' "$source") questions"
