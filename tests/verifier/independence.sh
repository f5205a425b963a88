#!/bin/sh
# independence.sh SOURCE VERIFIER MOST_LINES: the verifier has nothing of ours but its own folder: its includes, what it is linked with, and its text.
set -u
source=$1 program=$2 most=$3
cd "$source" || exit 2
failures=0
fail() { echo "$*"; failures=$((failures + 1)); }

files=$(find verifier -name '*.cpp' -o -name '*.hpp' | sort)
[ "$(echo "$files" | wc -l)" -ge 8 ] || fail "verifier/ has too few sources: $files"

# Includes: <gmp.h>, <gmpxx.h>, headers of the standard library (no dot, no slash), and its own.
for file in $files; do
  grep -hE '^[[:space:]]*#[[:space:]]*include' "$file" | while read -r line; do
    case $line in
      *'<gmpxx.h>'* | *'<gmp.h>'*) ;;
      *'<'*[./]*'>'*) echo "$file: $line" ;;
      *'<'*'>'*) ;;
      *'"'*'"'*)
        name=$(echo "$line" | sed 's/.*"\(.*\)".*/\1/')
        case $name in */*) echo "$file: $line" ;; esac
        [ -f "verifier/$name" ] || echo "$file: $line" ;;
      *) echo "$file: $line" ;;
    esac
  done
done | sort -u > "${TMPDIR:-/tmp}/bezcert-includes-$$"
[ -s "${TMPDIR:-/tmp}/bezcert-includes-$$" ] && fail "includes that are not its own: $(cat "${TMPDIR:-/tmp}/bezcert-includes-$$")"
rm -f "${TMPDIR:-/tmp}/bezcert-includes-$$"

# Shared libraries of the program.
if command -v readelf > /dev/null; then
  for library in $(readelf -d "$program" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p'); do
    case $library in
      libgmp.so* | libgmpxx.so* | libstdc++.so* | libm.so* | libgcc_s.so* | libc.so* | ld-linux*) ;;
      libasan.so* | libubsan.so*) ;;  # preset asan
      *) fail "linked with $library" ;;
    esac
  done
  # Nothing of the library's namespace in it.
  if command -v nm > /dev/null && nm -C "$program" 2> /dev/null | grep -q 'bezcert::'; then
    fail "symbols of lib/ in it: $(nm -C "$program" | grep 'bezcert::' | head -3)"
  fi
fi

# Lines of 40 characters or more (without blanks) that lib/ has as well.
strip() { cat "$@" | sed 's/[[:space:]]//g' | grep -v '^#include' | awk 'length($0) >= 40' | sort -u; }
lib=$(mktemp) own=$(mktemp)
find lib certify -name '*.cpp' -o -name '*.hpp' | tr '\n' '\0' | xargs -0 cat | sed 's/[[:space:]]//g' | grep -v '^#include' | awk 'length($0) >= 40' | sort -u > "$lib"
strip $files > "$own"
[ "$(wc -l < "$own")" -ge 100 ] || fail "too few long lines to compare"
# Trivial: signatures, and the calls that everybody writes in these words.
trivial='^(boolend_to_begin=false;///<aendswherebbegins|boolbegin_to_end=false;///<abeginswherebends|std::stringread_file\(conststd::string&path\)\{|std::stringsha256\(std::string_viewbytes\)[;{]|constauto\[end,error\]=std::from_chars\(digits\.data\(\),digits\.data\(\)\+digits\.size\(\),value\);)$'
common=$(comm -12 "$lib" "$own" | grep -vE "$trivial")
[ -z "$common" ] || fail "lines that lib/ has as well: $common"
rm -f "$lib" "$own"

lines=$(cat $files | wc -l)
echo "verifier/: $lines lines"
[ "$lines" -lt "$most" ] || fail "verifier/ has $lines lines, expected fewer than $most"
[ "$failures" -eq 0 ]
