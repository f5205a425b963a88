#!/bin/sh
# The reports of certify do not depend on the locale: de_DE.UTF-8 writes a decimal comma.
# locale.sh CERTIFY SOURCE_DIR; exits 77 (skipped) if there is no such locale and none can be made.
set -eu
certify=$1
source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

if ! locale -a 2>/dev/null | grep -qiE '^de_DE\.utf-?8$'; then
  if ! localedef -i de_DE -f UTF-8 "$work/de_DE.UTF-8" >/dev/null 2>&1; then
    echo "skipped: no locale de_DE.UTF-8, and localedef cannot make it"
    exit 77
  fi
  LOCPATH=$work
  export LOCPATH
fi
# The locale really is there: it writes a comma.
comma=$(LC_ALL=de_DE.UTF-8 locale decimal_point)
if [ "$comma" != "," ]; then
  echo "skipped: de_DE.UTF-8 cannot be used (decimal point '$comma')"
  exit 77
fi

compare() {
  name=$1
  shift
  LC_ALL=C "$certify" "$@" >"$work/c.out" 2>"$work/c.err" || c=$?
  LC_ALL=de_DE.UTF-8 "$certify" "$@" >"$work/de.out" 2>"$work/de.err" || de=$?
  for out in c de; do
    sed 's/"seconds":[-+0-9.e]*/"seconds":0/' "$work/$out.out" >"$work/$out.masked"
  done
  if ! cmp "$work/c.masked" "$work/de.masked" || ! cmp "$work/c.err" "$work/de.err" || [ "${c:-0}" != "${de:-0}" ]; then
    echo "FAILED: $name differs under de_DE.UTF-8"
    exit 1
  fi
  if ! [ -s "$work/c.out" ]; then
    echo "FAILED: $name printed nothing"
    exit 1
  fi
  compared=$((compared + 1))
}

compared=0
mesh=$source/corpus/meshes/crescent_p3_22a.msh
thin=$source/corpus/elements/thin-a-doubles.bez.json
compare "the text report" check "$mesh" "$thin"
compare "the JSON report" check --format=jsonl "$mesh" "$thin" "$source/corpus/elements/quarter-disc.bez.json"
compare "the report on decimals" check --numbers=decimal "$mesh"
compare "an explanation" explain "$thin" --element=1
compare "the criteria" criteria
if [ "$compared" != 5 ]; then
  echo "FAILED: $compared comparisons instead of 5"
  exit 1
fi
echo "5 outputs are the same in C and de_DE.UTF-8"
