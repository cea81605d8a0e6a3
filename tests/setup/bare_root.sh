#!/usr/bin/env bash
# Runs ./run on a Debian that has nothing: proof that the [build] packages are complete.
#
# usage: bare_root.sh SUITE FOLDER     bookworm is Debian 12, trixie 13; FOLDER is new, or one that an
#                                      earlier call made; needs root, debootstrap and 10 GB
# The program draws without a display; what it wrote lies in FOLDER/umbrascope/umbrascope-out.
set -euo pipefail
[ $# -eq 2 ] || { sed -n '4,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
suite=$1
source=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
[ "$(id -u)" -eq 0 ] || { echo "bare_root.sh: needs root, for chroot" >&2; exit 2; }
command -v debootstrap >/dev/null || { echo "bare_root.sh: install debootstrap first" >&2; exit 2; }

mkdir -p "$2"
root=$(cd "$2" && pwd)
[ -e "$root/etc/debian_version" ] || debootstrap --variant=minbase "$suite" "$root"
mkdir -p "$root/umbrascope"
# The sources as they are now, without what was built.
tar -C "$source" --exclude=./build --exclude=./.git --exclude=./umbrascope-out -cf - . |
  tar -C "$root/umbrascope" -xf -

mounted=()
finish() {
  local folder
  for folder in "${mounted[@]}"; do umount "$root/$folder"; done
}
trap finish EXIT
for folder in proc dev; do
  mountpoint -q "$root/$folder" && continue
  if [ "$folder" = proc ]; then mount -t proc proc "$root/proc"; else mount --bind /dev "$root/dev"; fi
  mounted+=("$folder")
done
chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
  bash -c 'cd /umbrascope && time ./run'
