#!/bin/sh
# fetch-imgui.sh TARGET: leaves the sources of Dear ImGui 1.90.1 in the folder TARGET.
#
# Debian packages Dear ImGui as a library for its own machines, without the sources that Emscripten
# needs; these come as Debian's source package. Suite trixie has the version we build with, and any
# Debian mirror carries it, so the mirror that this machine already uses is asked, with a state
# folder of our own: no root is needed and the machine's own lists stay as they are.
set -eu

suite=trixie
mkdir -p "$(dirname "$1")"
target=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
work=$target.download

stop() {
    printf '%s\n' "Dear ImGui: $1
Its sources (1.90 or newer) can also be fetched by hand: unpack them anywhere and configure with
-DKNOTWORK_IMGUI_DIR=FOLDER, or set the environment variable KNOTWORK_IMGUI_DIR for ./dev." >&2
    exit 1
}

# The mirror of the machine's own release, whichever of apt's two formats it is written in.
mirror() {
    # shellcheck disable=SC2016  # the $(names) are for apt to fill in
    apt-get indextargets --format '$(RELEASE) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' |
        awk -v own="$1" '
            $2 != "main" || $1 ~ /security|updates|backports/ { next }
            $1 == own || $1 ~ /^(stable|oldstable|testing|unstable|sid)$/ { print $3; exit }'
}

own_apt() {
    apt-get -q -o Dir::Etc::SourceList="$work/sources.list" -o Dir::Etc::SourceParts=/dev/null \
        -o Dir::State::Lists="$work/lists" -o Dir::Cache="$work/cache" \
        -o APT::Sandbox::User="$(id -un)" "$@"
}

command -v apt-get >/dev/null || stop "this system has no apt to fetch its sources with."
# shellcheck source=/dev/null
codename=$(. /etc/os-release && printf '%s' "${VERSION_CODENAME:-}")
uri=$(mirror "$codename")
[ -n "$uri" ] || stop "apt is configured without a Debian mirror that holds suite $suite."

rm -rf "$work"
mkdir -p "$work/lists/partial" "$work/cache/archives/partial" "$work/sources"
keyring=/usr/share/keyrings/debian-archive-keyring.gpg
[ -e "$keyring" ] && signed="[signed-by=$keyring] " || signed=
printf 'deb-src %s%s %s main\n' "$signed" "$uri" "$suite" >"$work/sources.list"

own_apt update || stop "the list of suite $suite could not be fetched from $uri."
(cd "$work" && own_apt source --download-only imgui) ||
    stop "its source package could not be fetched from $uri."
tar -xf "$work"/imgui_*.orig.tar.* -C "$work/sources" --strip-components=1 ||
    stop "its archive could not be unpacked (is xz-utils installed?)."
[ -e "$work/sources/imgui.cpp" ] || stop "the archive does not look as expected."

rm -rf "$target"
mv "$work/sources" "$target"
rm -rf "$work"
