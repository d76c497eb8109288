# Stages of deploy/test: each runs a command with its output in a log, and the last one says how all of them went. Sourced,
# with the project's folder as the working directory.
# shellcheck shell=bash

readonly out=$PWD/build/test
# Of each stage, as it ends: name, seconds, seconds of processors, `ok`, `failed`, or `broken` (without a report of tests).
readonly ended=$out/stages.txt
rm -rf "$out" && mkdir -p "$out" && : >"$ended" || exit 1

# tally: `PASSED FAILED` of all reports so far. Before the first one Python need not be there.
tally() {
  if [[ $(find "$out" -name '*.xml' -print -quit) ]]; then /usr/bin/python3 deploy/tally.py "$out"; else echo 0 0; fi
}
failures() { tally | cut -d' ' -f2; }

# timed LOG COMMAND...: runs it with its output in the log, and its time of processors in LOG.cpu.
timed() {
  local log=$1 TIMEFORMAT='%U %S'
  shift
  { time "$@" >"$log" 2>&1; } 2>"$log.cpu"
}

# stage NAME COMMAND...: runs it with its output in a log; says how it went and how long it took. A build that broke or a
# program that never reported is one failure by itself. Stages that run beside others must not report tests.
stage() {
  local name=$1 log=$out/$1.log started=$SECONDS failures_before status seconds cpu result=ok
  shift
  failures_before=$(failures)
  printf '[%4d s] %s ...\n' "$SECONDS" "$name"
  timed "$log" "$@"
  status=$? seconds=$((SECONDS - started))
  cpu=$(awk '{ printf "%d", $1 + $2 }' "$log.cpu")
  if ((status != 0)); then
    result=failed
    [[ $(failures) == "$failures_before" ]] && result=broken
  fi
  printf '%s %d %d %s\n' "$name" "$seconds" "$cpu" "$result" >>"$ended"
  if ((status == 0)); then
    printf '[%4d s] %s: ok (%d s)\n' "$SECONDS" "$name" "$seconds"
    return 0
  fi
  printf '[%4d s] %s: FAILED (%d s); the end of its log, %s:\n' "$SECONDS" "$name" "$seconds" "${log#"$PWD/"}"
  tail -n 80 "$log" | sed 's/^/    /'
  return 1
}

# passed NAME: whether this stage has ended well.
passed() { grep -q "^$1 .* ok$" "$ended"; }

# beside FUNCTION: runs its stages beside those that follow, on what these leave of the processors, until
# wait_beside. They end with the script: their processes are a group.
beside() {
  set -m
  {
    renice --priority 19 "$BASHPID" >/dev/null
    "$1"
  } &
  set +m
  # shellcheck disable=SC2064  # the process of now
  trap "kill -- -$! 2>/dev/null" EXIT
}
wait_beside() {
  wait
  trap - EXIT
}

# finish: the table of stages and the sum of all reports; leaves with status 0 if all passed.
finish() {
  local passed failed
  read -r passed failed < <(tally)
  ((failed += $(grep -c ' broken$' "$ended")))
  awk '{ printf "%-20s %5d s %6d s of processors\n", $1, $2, $3 }' "$ended"
  printf '%-20s %5d s\n' total "$SECONDS"
  if grep -qv ' ok$' "$ended"; then printf 'failed: %s\n' "$(awk '$4 != "ok" { print $1 }' "$ended" | paste -sd' ')"; fi
  printf '%d passed, %d failed\n' "$passed" "$failed"
  ((failed == 0 && passed > 0)) && ! grep -qv ' ok$' "$ended"
  exit
}
