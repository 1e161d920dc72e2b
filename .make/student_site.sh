#!/bin/sh
# student_site.sh - `make site STUDENT=1`: build the website of the course for students in build/student/. make calls it
# after the module is built, the node packages are installed and `make student` has written the folder.
set -eu
. .make/write.sh
course=build/student/ray-marching
PROGRAM_FOLDER=$PWD/build
export PROGRAM_FOLDER
mkdir -p "$course/build/web/objects"
for file in harness.js harness.wasm; do write "$course/build/web/objects/$file" cat "build/web/objects/$file"; done
ln -sfn ../../../node "$course/build/node"
cd "$course"
.make/web.sh
SITE_FOLDER=../site .make/site.sh
