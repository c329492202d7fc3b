#!/usr/bin/env bash
# The Debian packages of a build on a bare Debian 12, a fresh minimal system in a folder of its own: installs the program with what
# it depends on and nothing else, runs the main job, a report and a restart, installs the libraries, builds and runs
# examples/ on them, removes all, and holds files and packages of the system to those of before.
# usage: deb.sh BUILD [COMPILER_LAUNCHER]      BUILD: a build tree; build/package, as tools/package/build makes it, holds what is given away
# Without root, debootstrap, mounts or Debian's mirror: examples/ on the libraries of BUILD alone, then skipped (77). Some
# minutes; fetches some 400 MB.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/package}
launcher=${2:-}
say() { echo "deb: $*"; }
fail() { echo "deb: $*" >&2; exit 1; }
skip() {
    say "no bare system: $*; examples on the libraries of $build"
    tests/package/examples.sh "$build" "$launcher" || fail "examples"
    exit 77
}
[ "$(id -u)" -eq 0 ] || skip "not root"
command -v debootstrap >/dev/null || skip "no debootstrap"
mirror=$({ cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null || true; } |
    sed -n 's/^URIs: *\(http[^ ]*\/debian\)\/*$/\1/p; s/^deb \(\[[^]]*\] \)\?\(http[^ ]*\/debian\)\/* .*/\2/p' | head -1)

root=$(mktemp -d /var/tmp/deb-test.XXXXXX)
clean() {
    umount -l "$root/proc" "$root/dev" 2>/dev/null || true
    rm -f "$root.log"
    mountpoint -q "$root/proc" || mountpoint -q "$root/dev" || rm -rf --one-file-system "$root"
}
trap clean EXIT
debootstrap --variant=minbase bookworm "$root" "${mirror:-http://deb.debian.org/debian}" >"$root.log" 2>&1 || skip "no system from ${mirror:-deb.debian.org}: $(tail -1 "$root.log")"
mount -t proc proc "$root/proc" && mount --bind /dev "$root/dev" || skip "nothing can be mounted here"
cpack --config "$build/CPackConfig.cmake" -B "$root/job" >/dev/null
program=$(find "$root/job" -maxdepth 1 -name 'corpuscle_*.deb')
library=$(find "$root/job" -maxdepth 1 -name 'libcorpuscle-dev_*.deb')
[ -n "$program" ] && [ -n "$library" ] || fail "$build makes no two packages"
cp /etc/resolv.conf "$root/etc/resolv.conf"
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
cp -r /usr/local/share/ca-certificates/. "$root/usr/local/share/ca-certificates/" 2>/dev/null || true
mkdir -p "$root/job/models" "$root/job/tests"
cp -r examples "$root/job"
cp -r tests/package "$root/job/tests"
cp -r models/tank_test "$root/job/models"

inside() {
    env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        ${http_proxy:+http_proxy=$http_proxy} ${https_proxy:+https_proxy=$https_proxy} \
        chroot "$root" /bin/bash -euc "cd /job; $*"
}
# What the system holds, but for caches, logs and the lists of the package system itself
state() {
    inside "dpkg-query -W -f '\${Package} \${Status}\n' | grep 'ok installed'"
    (cd "$root" && find . -xdev \( -path ./job -o -path ./proc -o -path ./dev -o -path ./tmp -o -path ./var/cache -o -path ./var/log \
        -o -path ./var/lib/apt -o -path ./var/lib/dpkg \) -prune -o -print)
}
inside "apt-get update -q >/dev/null"
state | sort >"$root/job/before"

inside "apt-get install -y -q --no-install-recommends ./$(basename "$program") >/dev/null"
inside "corpuscle --version"
run="corpuscle run /usr/share/corpuscle/models/driver_bag_folded/driver_bag_folded.k -D NP=20000 -q"
inside "$run -o folded --until 2; corpuscle report folded >/dev/null; test -s folded/report.html"
inside "$run -o broken --until 4 & until [ -e broken/results.h5 ]; do sleep 0.1; done; sleep 1; kill -INT \$!; wait \$! || true
    $run -o broken --until 4 --restart >/dev/null; corpuscle export broken --csv >/dev/null; tail -1 broken/history.csv" >"$root/job/end"
awk -F, '{ exit !($1 > 3.99 && $1 < 4.01) }' "$root/job/end" || fail "the restarted run did not come to 4 ms: $(cut -c1-80 "$root/job/end")"
say "program: installed, run, restarted, reported"

inside "apt-get install -y -q --no-install-recommends ./$(basename "$library") g++ cmake ninja-build pkg-config >/dev/null"
inside "CXX=g++ tests/package/examples.sh --prefix /usr" || fail "examples"
say "examples: built and run on the installed libraries"

inside "apt-get purge -y -q --autoremove corpuscle libcorpuscle-dev g++ cmake ninja-build pkg-config >/dev/null"
state | sort >"$root/job/after"
comm -13 "$root/job/before" "$root/job/after" >"$root/job/left"
if grep -i corpuscle "$root/job/left"; then fail "traces of corpuscle are left"; fi
say "removed: $(wc -l <"$root/job/left") files are left by Debian's own packages, none of corpuscle"
sed 's/^/    /' "$root/job/left" | head -20
