# shellcheck shell=bash
# Functions for long stages of work, to be sourced by scripts: one progress line for each stage, and its full output in a file.

# In a terminal the progress line is overwritten; otherwise a new line is printed at this interval.
stage_interval=${CAROM_PROGRESS_INTERVAL:-10}  # seconds
stage_child=

stage_say() { printf 'carom: %s\n' "$*" >&2; }

# take_turn FILE WHAT: waits until no other process holds the lock FILE, which stays open as descriptor 9.
take_turn() {
  exec 9>"$1"
  flock -n 9 && return
  stage_say "another call is $2; waiting for it"
  flock 9
}

# The progress of apt-get, from its status descriptor, the file LOG.status: "downloading 34 %".
apt_progress() {
  tail -n 1 "$1.status" | sed -nE \
    -e 's/^dlstatus:[^:]*:([0-9]+)[^:]*:.*/downloading \1 %/p' \
    -e 's/^pmstatus:.*:([0-9]+)(\.[0-9]+)?:.*/unpacking and setting up \1 %/p'
}

# The progress of ninja: "12 of 480".
ninja_progress() { tail -n 1 "$1" | sed -nE 's|^\[([0-9]+)/([0-9]+)\].*|\1 of \2|p'; }

no_progress() { :; }  # for commands without progress

stage_erase_line() { if [ -t 2 ]; then printf '\r\033[K' >&2; fi; }

stage_show() {  # NAME PROGRESS
  if [ -t 2 ]; then
    printf '\r\033[K%.*s' "$(($(tput cols 2>/dev/null || echo 80) - 1))" "carom: $1: $2" >&2
  else
    stage_say "$1: $2"
  fi
}

# The most relevant lines of a log that ends in an error: from the first error message on, or the last lines. apt-get's remark that
# it keeps no log of its own, in systems without /dev/pts, is none.
stage_telling_lines() {
  local first
  first=$(grep -nE '^(FAILED:|ninja: (error|fatal)|CMake Error|E: |dpkg: error)' "$1" |
    grep -v -m 1 ':E: Can not write log ' | cut -d: -f1)
  if [ -n "$first" ]; then tail -n "+$first" "$1" | head -n 30; else tail -n 15 "$1"; fi
}

stage_interrupted() {
  trap '' INT TERM HUP
  kill "$stage_child" 2>/dev/null || true  # in a terminal the child also receives Ctrl-C itself
  wait "$stage_child" 2>/dev/null || true
  stage_erase_line
  stage_say "interrupted"
  exit 130
}

# run_stage NAME LOG PROGRESS COMMAND...: runs COMMAND with its output in the file LOG; PROGRESS LOG prints the progress. If
# COMMAND fails, prints the relevant lines of LOG and ends the script.
run_stage() {
  local name=$1 log=$2 progress=$3 begin=$SECONDS next=$((SECONDS + stage_interval)) status=0 far
  shift 3
  : >"$log"
  : >"$log.status"
  if [ ! -t 2 ]; then stage_say "$name"; fi
  trap stage_interrupted INT TERM HUP
  # A background command would otherwise ignore Ctrl-C.
  env --default-signal=INT,QUIT "$@" >"$log" 2>&1 9>&- &
  stage_child=$!
  while kill -0 "$stage_child" 2>/dev/null; do
    if [ -t 2 ] || [ "$SECONDS" -ge "$next" ]; then
      far=$("$progress" "$log" 2>/dev/null) || far=
      stage_show "$name" "${far:-$((SECONDS - begin)) s}"
      next=$((SECONDS + stage_interval))
    fi
    sleep 0.2
  done
  wait "$stage_child" || status=$?
  trap - INT TERM HUP
  stage_erase_line
  rm -f "$log.status"
  [ "$status" -ne 0 ] || return 0
  stage_say "$name failed; the full output is in $log. The relevant lines:"
  stage_telling_lines "$log" >&2
  exit 1
}

# build_release ROOT TARGET...: builds these targets of the release build, and configures it first if necessary.
build_release() (
  local tree=$1 build=$1/build/release
  shift
  export NINJA_STATUS='[%f/%t] '
  mkdir -p "$build"
  take_turn "$build/.lock" "building"
  cd "$tree" || exit
  if [ ! -f "$build/build.ninja" ]; then
    run_stage "configuring" "$build/configure.log" no_progress cmake --preset release
  fi
  # If there is nothing to build, this takes a tenth of a second and prints nothing.
  if ! ninja -C "$build" -n "$@" 2>/dev/null | grep -q 'no work to do'; then
    run_stage "building" "$build/build.log" ninja_progress ninja -C "$build" "$@"
  fi
)
