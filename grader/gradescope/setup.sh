#!/bin/sh
# Gradescope runs this once, when it makes the image of the autograder: installs
# what the grader needs, builds it, and grades the references as a class of one,
# which builds the suites of the assignment and shows in the log that all works.
set -eu
source=${AUTOGRADER_SOURCE:-/autograder/source}
class=$(mktemp -d)
mkdir "$class/reference"
cp "$source"/tree/solutions/*/* "$class/reference"
"$source/tree/grader/grader" run "$class" --out "$class.out" \
    --assignment "$source/assignment.toml"
rm -rf "$class" "$class.out"
