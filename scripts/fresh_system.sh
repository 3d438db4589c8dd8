# Sourced by scripts that need a fresh Debian system: debootstrap in $CAROM_TREE, or in a temporary folder that is removed at the end.
# It uses the mirrors, keys and certificates of this system. Needs root.
[ "$(id -u)" -eq 0 ] || { echo "$0: debootstrap and chroot need root" >&2; exit 1; }
release=bookworm
if [ -n "${CAROM_TREE:-}" ]; then tree=$CAROM_TREE; else tree=$(mktemp -d --tmpdir carom_tree_XXXXXX); fi

leave_system() {
  local place
  for place in ccache dev/pts sys proc; do umount -R "$tree/$place" 2>/dev/null || true; done
  [ -z "${CAROM_TREE:-}" ] || return 0
  if grep -qF " $tree/" /proc/self/mounts; then
    echo "$0: something is still mounted below $tree, which is kept" >&2
  else
    rm -rf "$tree"
  fi
}
trap leave_system EXIT

# inside COMMAND…: runs a command in the fresh system with an empty environment.
inside() { chroot "$tree" /usr/bin/env -i HOME=/tmp PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive "$@"; }

make_system() {
  local mirror trust=()
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep -v -i security | head -n 1)
  [ -f /usr/share/keyrings/debian-archive-keyring.gpg ] || trust=(--no-check-gpg)
  if [ ! -f "$tree/etc/debian_version" ]; then
    debootstrap --variant=minbase "${trust[@]}" "$release" "$tree" "$mirror" >"$tree.log" 2>&1 || {
      tail -n 20 "$tree.log" >&2
      exit 1
    }
    rm -f "$tree.log"
  fi
  chmod 755 "$tree"  # mktemp makes it 0700, and users other than root run programs in it, munge's installation does
  cp -r /etc/apt/. "$tree/etc/apt/"
  cp /etc/resolv.conf /etc/hosts "$tree/etc/"
  mountpoint -q "$tree/proc" || mount -t proc proc "$tree/proc"
  # With all that is mounted below it, since Slurm looks for the groups of processes there.
  mountpoint -q "$tree/sys" || { mount --rbind /sys "$tree/sys" && mount --make-rslave "$tree/sys"; }
  mountpoint -q "$tree/dev/pts" || mount -t devpts devpts "$tree/dev/pts"
  inside apt-get update -q >/dev/null
}

# What npm in the fresh system has to know of this one: words for `inside`.
npm_words() {
  npm_config=()
  command -v npm >/dev/null || return 0
  npm_config+=("npm_config_registry=$(npm config get registry)")
  if [ -n "${NODE_EXTRA_CA_CERTS:-}" ]; then
    cp "$NODE_EXTRA_CA_CERTS" "$tree/srv/certificates.pem"
    npm_config+=(NODE_EXTRA_CA_CERTS=/srv/certificates.pem npm_config_cafile=/srv/certificates.pem)
  fi
}

# Puts a clone of the committed sources into /srv/carom, and this system's compiler cache into /ccache.
put_sources() {
  local cache
  rm -rf "$tree/srv/carom"
  git clone -q --depth 1 "file://$PWD" "$tree/srv/carom"
  npm_words
  # ccache distinguishes the languages of compiler messages.
  build_words=(${LANG:+LANG="$LANG"} "${npm_config[@]}")
  if cache=$(ccache -k cache_dir 2>/dev/null); then
    mkdir -p "$tree/ccache"
    mount --bind "$cache" "$tree/ccache"
    # It finds what was built here if it knows the compiler in the same way: by its content, or by its time.
    build_words+=(CCACHE_DIR=/ccache CCACHE_COMPILERCHECK="$(ccache -k compiler_check)")
  fi
}
