#!/bin/sh
# questions.sh - `make questions`: write the exit questions of docs/questions.txt for learning platforms, as GIFT and as
# Moodle's XML, into build/questions/. QUESTIONS and QUESTIONS_FOLDER replace the file and the folder; the tests set
# both.
set -u
. .make/write.sh
source=${QUESTIONS:-docs/questions.txt} folder=${QUESTIONS_FOLDER:-build/questions}
if [ ! -f "$source" ] || [ ! -r "$source" ]; then
    fail 2 "$source: no such file: the course for students has no questions"
fi
begin "$folder" || exit 1
bom=$(printf '\357\273\277')
for form in gift xml; do
    write "$new/ray-marching.$form" awk -v form="$form" -v bom="$bom" -f .make/table.awk -f .make/questions.awk docs/[0-9][0-9]_*.md "$source" || exit 1
done
keep ray-marching.gift ray-marching.xml || exit 1
plain "$folder/ray-marching.gift and $folder/ray-marching.xml: $(grep -c '^## ' "$source") questions"
