# Stages of deploy/test: each runs a command with its output in a log, and the last one says how all of them went. Sourced,
# with the project's folder as the working directory.
# shellcheck shell=bash

readonly out=$PWD/build/test
rm -rf "$out" && mkdir -p "$out" || exit 1
table=() failed_stages=() failed_without_report=0

# tally: `PASSED FAILED` of all reports so far. Before the first one Python need not be there.
tally() {
  if [[ $(find "$out" -name '*.xml' -print -quit) ]]; then /usr/bin/python3 deploy/tally.py "$out"; else echo 0 0; fi
}
failures() { tally | cut -d' ' -f2; }

# stage NAME COMMAND...: runs it with its output in a log; one line says how it went, and how long it took.
stage() {
  local name=$1 started=$SECONDS failures_before
  shift
  failures_before=$(failures)
  printf '[%4d s] %s ...\n' "$SECONDS" "$name"
  "$@" >"$out/$name.log" 2>&1
  ended "$name" $? "$((SECONDS - started))" "$failures_before"
}

# background NAME PROGRAM...: starts it on the processors' idle time; await NAME waits for it. One at a time, and it
# leaves no report. It has a session of its own, as the kernel shares the processors among sessions first (autogroup).
background() {
  local name=$1
  shift
  printf '[%4d s] %s ... (in the background)\n' "$SECONDS" "$name"
  background_started=$SECONDS
  # shellcheck disable=SC2016  # expanded by that shell
  setsid bash -c '{ echo 19 >/proc/self/autogroup; } 2>/dev/null; chrt --idle --pid 0 $$ || renice -n 19 -p $$; exec "$@"' bash "$@" >"$out/$name.log" 2>&1 &
  background_pid=$!
  # shellcheck disable=SC2064  # that process
  trap "kill -- -$background_pid 2>/dev/null" EXIT
}

# await NAME: waits for the command of background(), which gets its share of the processors now. The table has the time
# that was waited.
await() {
  local name=$1 started=$SECONDS status
  printf '[%4d s] %s: waiting, begun %d s ago\n' "$SECONDS" "$name" "$((SECONDS - background_started))"
  foreground "$background_pid"
  wait "$background_pid"
  status=$?
  trap - EXIT
  ended "$name" "$status" "$((SECONDS - started))" "$(failures)"
}

# foreground PID: gives the process and its descendants the usual priority.
foreground() {
  local child children=()
  chrt --other --pid 0 "$1" 2>/dev/null || true
  { echo 0 >"/proc/$1/autogroup"; } 2>/dev/null || true
  read -ra children 2>/dev/null <"/proc/$1/task/$1/children" || true
  for child in "${children[@]}"; do foreground "$child"; done
}

# ended NAME STATUS SECONDS FAILURES_BEFORE: says how a stage went. A build that broke or a program that never reported
# is one failure by itself.
ended() {
  local name=$1 status=$2 seconds=$3 failures_before=$4 log=$out/$1.log
  table+=("$(printf '%-20s %5d s' "$name" "$seconds")")
  if ((status == 0)); then
    printf '[%4d s] %s: ok (%d s)\n' "$SECONDS" "$name" "$seconds"
    return 0
  fi
  failed_stages+=("$name")
  [[ $(failures) == "$failures_before" ]] && ((++failed_without_report))
  printf '[%4d s] %s: FAILED (%d s); the end of its log, %s:\n' "$SECONDS" "$name" "$seconds" "${log#"$PWD/"}"
  tail -n 80 "$log" | sed 's/^/    /'
  return 1
}

# finish: the table of stages and the sum of all reports; leaves with status 0 if all passed.
finish() {
  local passed failed
  read -r passed failed < <(tally)
  ((failed += failed_without_report))
  printf '%s\n' "${table[@]}" "$(printf '%-20s %5d s' total "$SECONDS")"
  ((${#failed_stages[@]})) && printf 'failed: %s\n' "${failed_stages[*]}"
  printf '%d passed, %d failed\n' "$passed" "$failed"
  ((failed == 0 && passed > 0))
  exit
}
