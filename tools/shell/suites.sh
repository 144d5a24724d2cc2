# shellcheck shell=sh
# shellcheck disable=SC2154  # logs is set in ./dev
# The suites of ./dev test. Each one reports how many tests passed and failed; a suite that cannot be
# built, or that runs no test at all, is a failure.

passed=0
failed=0
table=

record() { # record suite passed failed remark
    passed=$((passed + $2))
    failed=$((failed + $3))
    table="$table$(printf '%-12s %6d passed %4d failed  %s' "$1" "$2" "$3" "${4:-}")
"
}

record_counts() { # record_counts suite passed failed exit-status
    set -- "$1" "${2:-0}" "${3:-0}" "$4"
    if [ "$4" -ne 0 ] && [ "$3" -eq 0 ]; then
        record "$1" "$2" 1 "ended with status $4"
    elif [ $(($2 + $3)) -eq 0 ]; then
        record "$1" 0 1 "ran no tests"
    else
        record "$1" "$2" "$3"
    fi
}

check() { # check suite title command...: a suite that is one yes or no
    check_suite=$1
    check_title=$2
    shift 2
    if step "$check_title" "$check_suite" "$@"; then record "$check_suite" 1 0; else record "$check_suite" 0 1; fi
}

node_suite() { # node_suite suite file...: node's test runner, readable on the screen, TAP for counting
    node_name=$1
    shift
    node_log=$logs/$node_name.tap
    say "Running the $node_name tests ..."
    node_status=0
    node --test --test-reporter=spec --test-reporter-destination=stdout \
        --test-reporter=tap --test-reporter-destination="$node_log" "$@" || node_status=$?
    record_counts "$node_name" "$(sed -n 's/^# pass //p' "$node_log")" \
        "$(awk '/^# (fail|cancelled|skipped|todo) [0-9]+$/ { n += $3 } END { print n + 0 }' "$node_log")" \
        "$node_status"
}

google_suite() { # google_suite suite program: a GoogleTest executable
    google_log=$logs/$1.log
    google_status=0
    step "Running the $1 tests" "$1" "$2" --gtest_color=no || google_status=$?
    record_counts "$1" "$(sed -n 's/^\[  PASSED  \] \([0-9]*\) test.*/\1/p' "$google_log" | tail -n 1)" \
        "$(sed -n 's/^\[  FAILED  \] \([0-9]*\) test.*/\1/p' "$google_log" | tail -n 1)" "$google_status"
}

not_built() { record "$1" 0 1 "could not be built"; }

source_tests="tests/node/layers.test.mjs tests/node/repository.test.mjs"

other_node_tests() {
    for file in tests/node/*.test.mjs; do
        case " $source_tests " in *" $file "*) ;; *) printf '%s ' "$file" ;; esac
    done
}

# shellcheck disable=SC2046,SC2086  # lists of files without spaces in their names
run_suite() {
    case $1 in
    sources) node_suite sources $source_tests ;;
    types) check types "Checking the types of the JavaScript" node_modules/.bin/tsc ;;
    native)
        if build_preset native "the C++ tests"; then
            google_suite native build/native/knotwork_tests
        else not_built native; fi
        ;;
    wasm) if build_dist; then record wasm 1 0; else not_built wasm; fi ;;
    node) node_suite node $(other_node_tests) ;;
    clang)
        if build_preset native-clang "the libraries with clang"; then record clang 1 0; else not_built clang; fi
        ;;
    sanitizers)
        if build_preset native-san "the C++ tests with sanitizers"; then
            google_suite sanitizers build/native-san/knotwork_tests
        else not_built sanitizers; fi
        ;;
    fuzz)
        if build_preset native-fuzz "the fuzz targets"; then fuzz_suite; else not_built fuzz; fi
        ;;
    browser) node_suite browser tests/browser/*.test.mjs ;;
    *) stop "There is no suite '$1'; there are: $all_suites" ;;
    esac
}

# The quick ones first, and what depends on dist/ after the suite that builds it.
all_suites="sources types native wasm node clang sanitizers fuzz browser"

run_suites() {
    begin=$(date +%s)
    # shellcheck disable=SC2086  # several suites
    [ $# -gt 0 ] || set -- $all_suites
    for suite in "$@"; do run_suite "$suite"; done
    printf '\n%s\n%d s altogether; logs in %s\n' "$table" $(($(date +%s) - begin)) "$logs"
    printf '%d passed, %d failed\n' "$passed" "$failed"
    [ "$failed" -eq 0 ]
}
