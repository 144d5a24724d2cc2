# shellcheck shell=sh
# shellcheck disable=SC2154  # logs is set in ./dev
# The fuzz targets: one for each file of tests/fuzz, each with a few seeds in tests/fuzz/corpus.

fuzz_targets() {
    for file in tests/fuzz/*.cpp; do basename "$file" .cpp; done
}

# fuzz_run target folder option...: one target over its seeds and a folder where its finds go.
fuzz_run() {
    fuzz_target=$1
    fuzz_folder=$2
    shift 2
    mkdir -p "$fuzz_folder" build/fuzz/crashes
    "build/native-fuzz/fuzz_$fuzz_target" -max_len=4096 -timeout=25 -print_final_stats=1 \
        -artifact_prefix="build/fuzz/crashes/$fuzz_target-" "$@" \
        "$fuzz_folder" "tests/fuzz/corpus/$fuzz_target"
}

# Replays the seeds, then looks further for 20 seconds, the same way every time.
fuzz_briefly() {
    rm -rf "build/fuzz/$1-test"
    fuzz_run "$1" "build/fuzz/$1-test" -runs=0 &&
        fuzz_run "$1" "build/fuzz/$1-test" -seed=1 -max_total_time=20 -verbosity=0
}

say_how_to_replay() { # from the log of a run that failed
    sed -n 's/^Does not hold: /  does not hold: /p; s/^\(Base64: .*\)/  \1/p' "$1"
    sed -n 's|.*Test unit written to \(build/fuzz/crashes/\([a-z_]*\)-.*\)|  ./dev fuzz \2 \1   runs it again|p' "$1"
}

fuzz_suite() {
    fuzz_passed=0
    fuzz_failed=0
    for name in $(fuzz_targets); do
        if step "Fuzzing $name (seeds and 20 s)" "fuzz-$name" fuzz_briefly "$name"; then
            fuzz_passed=$((fuzz_passed + 1))
        else
            fuzz_failed=$((fuzz_failed + 1))
            say_how_to_replay "$logs/fuzz-$name.log"
        fi
    done
    record fuzz "$fuzz_passed" "$fuzz_failed"
}

# ./dev fuzz: without arguments says what there is; finds are kept in build/fuzz/TARGET.
fuzz_command() {
    case " $(fuzz_targets | tr '\n' ' ') " in
    *" ${1:-} "*) ;;
    *) stop "Usage: ./dev fuzz TARGET [SECONDS | FILE]. There are the targets:
$(fuzz_targets)" ;;
    esac
    build_preset native-fuzz "the fuzz targets" || return 1
    if [ -f "${2:-}" ]; then
        exec "build/native-fuzz/fuzz_$1" "$2"
    fi
    fuzz_run "$1" "build/fuzz/$1" -max_total_time="${2:-60}"
}
