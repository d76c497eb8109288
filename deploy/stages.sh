# Stages of deploy/test: each runs a command with its output in a log, and the last one says how all of them went. Sourced,
# with the project's folder as the working directory.
# shellcheck shell=bash

readonly out=$PWD/build/test
# Of each stage, as it ends: name, seconds, seconds of processors, `ok`, `failed`, or `broken` (without a report of tests).
readonly ended=$out/stages.txt
# What failed and was tried again, which is said whether it passed then or not.
readonly second_tries=$out/second_tries.txt
rm -rf "$out" && mkdir -p "$out" && : >"$ended" || exit 1

# The folder for the reports of tests of the stage that runs; a stage that runs beside others has its own.
reports=$out

# tally FOLDER: `PASSED FAILED` of the reports in it. Before the first one Python need not be there.
tally() {
  if [[ $(find "$1" -name '*.xml' -print -quit) ]]; then /usr/bin/python3 deploy/tally.py "$1"; else echo 0 0; fi
}

# timed LOG COMMAND...: runs it with its output in the log, and its time of processors in LOG.cpu.
timed() {
  local log=$1 TIMEFORMAT='%U %S'
  shift
  { time "$@" >"$log" 2>&1; } 2>"$log.cpu"
}

# What tests and sanitizers say of what went wrong, of long logs.
readonly findings='(^|[^a-z])(FAILED|FAIL:| FAIL |Failure|ERROR: |SUMMARY: |runtime error|AssertionError|error:)'

# stage NAME COMMAND...: runs it with its output in a log and its reports in a folder of its own; says how it went and how
# long it took. A build that broke or a program that never reported is one failure by itself.
stage() {
  local name=$1 log=$out/$1.log started=$SECONDS status seconds cpu result=ok
  shift
  reports=$out/$name && mkdir -p "$reports"
  printf '[%4d s] %s ...\n' "$SECONDS" "$name"
  timed "$log" "$@"
  status=$? seconds=$((SECONDS - started))
  cpu=$(awk '{ printf "%d", $1 + $2 }' "$log.cpu")
  if ((status != 0)); then
    result=failed
    [[ $(tally "$reports" | cut -d' ' -f2) == 0 ]] && result=broken
  fi
  printf '%s %d %d %s\n' "$name" "$seconds" "$cpu" "$result" >>"$ended"
  if ((status == 0)); then
    printf '[%4d s] %s: ok (%d s)\n' "$SECONDS" "$name" "$seconds"
    return 0
  fi
  # At once, as other stages may print, too.
  {
    printf '[%4d s] %s: FAILED (%d s); what its log says, %s:\n' "$SECONDS" "$name" "$seconds" "${log#"$PWD/"}"
    grep -E -B 2 -A 6 -m 8 "$findings" "$log" | cut -c1-300 | head -n 60 | sed 's/^/    /'
    printf '    ... and its end:\n'
    tail -n 40 "$log" | sed 's/^/    /'
  } >"$log.said"
  cat "$log.said"
  return 1
}

# passed NAME: whether this stage has ended well.
passed() { grep -q "^$1 .* ok$" "$ended"; }

# beside FUNCTION: runs its stages beside those that follow, on what these leave of the processors, until
# wait_beside. They end with the script: they are a session of their own, and so the last of the kernel's groups of
# processes (sched(7), autogroup), as the idle class counts within a group alone, and a browser has its own.
beside() {
  local shell
  # shellcheck disable=SC2154  # what its caller has
  shell="set -uo pipefail; SECONDS=$SECONDS; $(declare -p out ended second_tries findings reports quick only runner)
    $(declare -f)
    yield_processors
    $1"
  setsid bash -c "$shell" &
  # shellcheck disable=SC2064  # the process of now
  trap "kill -- -$! 2>/dev/null" EXIT
}
yield_processors() {
  { echo 19 >/proc/self/autogroup; } 2>/dev/null
  chrt --idle --pid 0 $$ 2>/dev/null || renice --priority 19 $$ >/dev/null
}
wait_beside() {
  wait
  trap - EXIT
}

# finish: the table of stages and the sum of all reports; leaves with status 0 if all passed.
finish() {
  local passed failed
  read -r passed failed < <(tally "$out")
  ((failed += $(grep -c ' broken$' "$ended")))
  awk '{ printf "%-20s %5d s %6d s of processors\n", $1, $2, $3 }' "$ended"
  printf '%-20s %5d s\n' total "$SECONDS"
  [[ ! -e $second_tries ]] || sed '/^$/d; s/^Once more/tried twice/' "$second_tries"
  if grep -qv ' ok$' "$ended"; then printf 'failed: %s\n' "$(awk '$4 != "ok" { print $1 }' "$ended" | paste -sd' ')"; fi
  printf '%d passed, %d failed\n' "$passed" "$failed"
  ((failed == 0 && passed > 0)) && ! grep -qv ' ok$' "$ended"
  exit
}
