# shellcheck shell=sh
# shellcheck disable=SC2154  # logs is set in ./dev
# One line on the screen for each step, everything else in a log of its own under build/logs.

say() { printf '%s\n' "$*"; }

stop() { # stop message...: a paragraph that says what is wrong and what to do
    printf '\n%s\n' "$*" >&2
    exit 1
}

# step title log command...: runs the command quietly; a failure shows the end of its log.
step() {
    step_title=$1
    step_log=$logs/$2.log
    shift 2
    step_begin=$(date +%s)
    printf '%s ... ' "$step_title"
    if "$@" >"$step_log" 2>&1 </dev/null; then
        say "done ($(($(date +%s) - step_begin)) s)"
        return 0
    fi
    say "failed"
    tail -n 40 "$step_log" >&2
    printf '\n%s failed; the whole output is in %s\n' "$step_title" "$step_log" >&2
    return 1
}
