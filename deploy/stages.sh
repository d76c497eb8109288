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

# stage NAME COMMAND...: runs it with its output in a log; says how it went and how long it took. A build that broke or a
# program that never reported is one failure by itself.
stage() {
  local name=$1 log=$out/$1.log started=$SECONDS failures_before status seconds
  shift
  failures_before=$(failures)
  printf '[%4d s] %s ...\n' "$SECONDS" "$name"
  "$@" >"$log" 2>&1
  status=$? seconds=$((SECONDS - started))
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
