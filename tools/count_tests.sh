#!/usr/bin/env bash
# Counts the single tests of a ctest run and describes those that failed or were skipped.
# Usage: tools/count_tests.sh JUNIT_REPORT REPORT_FOLDER
# ctest runs each GoogleTest program as a few processes. A process NAME writes the results of its tests to
# REPORT_FOLDER/NAME.xml, and each of these tests counts. Any other ctest entry counts as one test. A process that ended
# without a report, that failed although none of its tests did, or that ran no test counts as one failed test.
# The last line is "PASSED FAILED SKIPPED", three numbers; the lines before it are for people.
set -euo pipefail
report=$1 folder=$2
passed=0 failed=0 skipped=0

# number LINE NAME: prints N of the first NAME="N" in the line.
number() {
  local rest=${1#*" $2=\""}
  echo "${rest%%\"*}"
}

fail() {
  echo "FAILED: $*"
  failed=$((failed + 1))
}

while IFS= read -r line; do
  name=${line#*name=\"} name=${name%%\"*}
  status=${line#*status=\"} status=${status%%\"*}
  results=$folder/$name.xml
  if [ ! -s "$results" ]; then
    case $status in
      run) passed=$((passed + 1)) ;;
      disabled) skipped=$((skipped + 1)) ;;
      notrun) fail "$name did not start" ;;
      *) fail "$name" ;;
    esac
    continue
  fi
  summary=$(grep -m 1 '<testsuites ' "$results")
  all=$(number "$summary" tests) bad=$(number "$summary" failures)
  off=$(($(grep -c '<skipped message' "$results" || true) + $(number "$summary" disabled)))
  passed=$((passed + all - bad - off)) failed=$((failed + bad)) skipped=$((skipped + off))
  awk '/<testcase / { test = $0; sub(/.* classname="/, "", test); sub(/".*/, "", test)
         name = $0; sub(/.*<testcase name="/, "", name); sub(/".*/, "", name); said = 0 }
       /<failure / && !said { print "FAILED: " test "." name; said = 1 }' "$results"
  if [ "$all" -eq 0 ]; then fail "$name: its filter in tests/CMakeLists.txt matches no test"; fi
  if [ "$status" != run ] && [ "$bad" -eq 0 ] && [ "$all" -gt 0 ]; then fail "$name: the process failed, but none of its tests"; fi
done < <(grep '<testcase ' "$report")

# Print the reasons for skipped tests, each with the number of tests.
cat "$folder"/*.xml 2>/dev/null | sed -n 's/.*<skipped message="[^"]*&#x0A;\([^"]*\)".*/\1/p' |
  sed 's/&quot;/"/g; s/&apos;/'"'"'/g; s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g' | sort | uniq -c | sed 's/^ *\([0-9]*\) /  skipped: \1 x /'
echo "$passed $failed $skipped"
