# shellcheck shell=bash
# Runs named parts of a long check and keeps what became of them, so that runs of single parts add up to one list. To be sourced
# by a script in the root of the repository, which names each part in order by `part NAME WHAT_IT_DOES`, has a function part_NAME
# for it ("_" for "-"), and sets parts_file, the file that keeps the results: sources, part, result, wall and CPU seconds, and time,
# separated by tabs.

parts=()               # all names, in order
declare -A parts_about # what each does
parts_chosen=()        # the names of those that are to be run
parts_file=

part() {
  parts+=("$1")
  parts_about[$1]=$2
}

# The sources that a result is about: the commit and, where files differ from it, "+" and a hash of what differs.
parts_sources() {
  local commit
  commit=$(git rev-parse --short=12 HEAD)
  if [ -n "$(git status --porcelain)" ]; then
    commit+=+$({ git diff HEAD; git ls-files --others --exclude-standard -z | xargs -0 -r sha256sum; } | sha256sum | cut -c 1-8)
  fi
  echo "$commit"
}

# parts_choose only|from NAME[,NAME…]: chooses those parts, or those from one on. Returns 2 if there is no such part.
parts_choose() {
  local name chosen=()
  for name in ${2//,/ }; do
    [ -n "${parts_about[$name]:-}" ] || { echo "there is no part '$name'; the parts are ${parts[*]}" >&2; return 2; }
  done
  for name in "${parts[@]}"; do
    if [[ ,$2, == *,$name,* ]] || { [ "$1" = from ] && [ ${#chosen[@]} -gt 0 ]; }; then chosen+=("$name"); fi
  done
  [ ${#chosen[@]} -gt 0 ] || { echo "no part is named; the parts are ${parts[*]}" >&2; return 2; }
  parts_chosen=("${chosen[@]}")
}

# parts_run NAME: runs a part in a shell of its own, which ends at the first command that fails, and adds it to parts_failed if one
# does. Not to be called in a condition, where bash ignores `set -e`.
parts_run() {
  local before after timing status result=passed
  before=$(parts_sources)
  echo "== $1: ${parts_about[$1]}"
  { timing=$(
    set +e
    TIMEFORMAT='%0R %0U %0S'
    { time { (
      set -e
      "part_${1//-/_}"
    ) >&5 2>&6; }; } 2>&1
    echo "$?"
  ); } 5>&1 6>&2
  status=${timing##*$'\n'}
  [ "$status" = 0 ] || result=FAILED
  after=$(parts_sources)
  [ "$before" = "$after" ] || before=changed-meanwhile
  mkdir -p "$(dirname "$parts_file")"
  awk -v OFS='\t' -v sources="$before" -v part="$1" -v result="$result" -v now="$(date '+%F %T')" \
    'NR == 1 {print sources, part, result, $1, $2 + $3, now}' <<<"$timing" >>"$parts_file"
  echo "== $1: $result"
  [ $result = passed ] || parts_failed+=("$1")
}

# parts_list: what became of each part when it last ran on the sources as they are now.
parts_list() {
  local name sources
  sources=$(parts_sources)
  for name in "${parts[@]}"; do printf '%s\t%s\n' "$name" "${parts_about[$name]}"; done |
    awk -F '\t' -v sources="$sources" -v kept="$parts_file" '
      BEGIN {
        while ((getline line < kept) > 0) {
          split(line, field, "\t")
          if (field[1] == sources) last[field[2]] = field[3] "\t" field[4] "\t" field[5]
        }
        printf "%-15s %-8s %7s %7s  %s\n", "part", "result", "wall s", "CPU s", "what it does"
      }
      {
        split($1 in last ? last[$1] : "not run\t-\t-", found, "\t")
        printf "%-15s %-8s %7s %7s  %s\n", $1, found[1], found[2], found[3], $2
        passed += found[1] == "passed"
        wall += found[2]
        cpu += found[3]
      }
      END { printf "%d of %d parts passed on %s: %d s, %d CPU s\n", passed, NR, sources, wall, cpu }'
}

# Runs the chosen parts, also after one that fails, and prints the list. Returns 1 if one failed.
parts_run_chosen() {
  local name
  parts_failed=()
  for name in "${parts_chosen[@]}"; do
    parts_run "$name"
  done
  parts_list
  [ ${#parts_failed[@]} = 0 ] || { echo "failed: ${parts_failed[*]}" >&2; return 1; }
}
