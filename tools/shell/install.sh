# shellcheck shell=sh
# shellcheck disable=SC2154  # logs and stamps are set in ./dev
# What the build needs, how each thing is recognised, and how Debian's apt supplies what is missing.

first_file() { # first_file path...: is one of them there?
    for candidate in "$@"; do
        [ ! -e "$candidate" ] || return 0
    done
    return 1
}

have_header() { first_file "/usr/local/include/$1" "/usr/include/$1" "/opt/homebrew/include/$1"; }

have_font() {
    folder=/usr/share/fonts
    first_file "${KNOTWORK_UI_FONT:-$folder/truetype/dejavu/DejaVuSans.ttf}" \
        $folder/dejavu/DejaVuSans.ttf $folder/TTF/DejaVuSans.ttf \
        $folder/dejavu-sans-fonts/DejaVuSans.ttf
}

have_imgui() { # apt also supplies these sources: tools/fetch-imgui.sh
    [ -n "${KNOTWORK_IMGUI_DIR:-}" ] || command -v apt-get || test -e build/third-party/imgui/imgui.h
}

have_libfuzzer() {
    folder=$(clang++ -print-resource-dir) && first_file "$folder"/lib/*/libclang_rt.fuzzer*
}

have_chromium() {
    [ -n "${KNOTWORK_CHROMIUM:-}" ] || command -v chromium >/dev/null
}

# needs group: lines of  package | probe | what is looked for, in words
needs() {
    case $1 in
    wasm) cat <<'LIST' ;;
emscripten|command -v emcc|emcc (Emscripten 3.1.6 or newer) in PATH
cmake|command -v cmake|cmake (3.25 or newer) in PATH
ninja-build|command -v ninja|ninja in PATH
nodejs|command -v node|node (18 or newer) in PATH
npm|command -v npm|npm in PATH
libglm-dev|have_header glm/glm.hpp|glm/glm.hpp in /usr/include or /usr/local/include
nlohmann-json3-dev|have_header nlohmann/json.hpp|nlohmann/json.hpp in /usr/include or /usr/local/include
fonttools|command -v fonttools|fonttools in PATH
fonts-dejavu-core|have_font|DejaVuSans.ttf in /usr/share/fonts, or a font named in KNOTWORK_UI_FONT
imgui|have_imgui|the sources of Dear ImGui (1.90 or newer), their folder named in KNOTWORK_IMGUI_DIR
xz-utils|command -v xz|xz in PATH
ca-certificates|test -e /etc/ssl|certificates in /etc/ssl
LIST
    native) cat <<'LIST' ;;
g++|command -v g++|g++ in PATH
clang|command -v clang++|clang++ in PATH
libclang-rt-dev|have_libfuzzer|clang's sanitizers and libFuzzer (libclang_rt.fuzzer in clang's own folder)
libgtest-dev|have_header gtest/gtest.h|GoogleTest's gtest/gtest.h in /usr/include or /usr/local/include
librapidcheck-dev|have_header rapidcheck.h|rapidcheck.h in /usr/include or /usr/local/include
LIST
    browser) cat <<'LIST' ;;
chromium|have_chromium|chromium in PATH, or its file named in KNOTWORK_CHROMIUM
LIST
    esac
}

missing() { # missing column group...: that column of every need that is not met
    column=$1
    shift
    for group in "$@"; do
        needs "$group" | while IFS='|' read -r package probe words; do
            $probe >/dev/null 2>&1 && continue
            [ "$column" = packages ] && printf '%s ' "$package" || printf '  %s\n' "$words"
        done
    done
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

apt_install() {
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q update || return 1
    # shellcheck disable=SC2086  # the packages are several words
    as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get -q install -y --no-install-recommends $packages
}

install_missing() {
    packages=$(missing packages "$@")
    [ -n "$packages" ] || return 0
    if ! command -v apt-get >/dev/null; then
        stop "This system has no apt-get to install what is missing. Please install it by other
means and run the command again. Not found:
$(missing words "$@")"
    fi
    if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
        stop "Some packages are missing and installing them takes root, but this is not root and
there is no sudo. As root, please run
  apt-get update && apt-get install --no-install-recommends $packages"
    fi
    say "Installing with apt-get, without recommended packages: $packages"
    if [ "$(id -u)" -ne 0 ]; then sudo -v || stop "sudo was refused."; fi
    step "Installing (minutes on a bare system; log: $logs/apt.log)" apt apt_install ||
        stop "apt-get could not install: $packages"
    remaining=$(missing words "$@")
    [ -z "$remaining" ] || stop "Still not found after installing:
$remaining"
}

version_reaches() { # version_reaches found needed
    printf '%s\n' "$1 $2" | awk '{
        split($1, found, "."); split($2, needed, ".")
        for (i = 1; i <= 3; i++) if (found[i] + 0 != needed[i] + 0) exit found[i] + 0 < needed[i] + 0
    }'
}

require_version() { # require_version name command found needed advice
    version_reaches "${3:-0}" "$4" || stop "$1 ${3:-of unknown version} was found at \
$(command -v "$2"), but $4 or newer is needed. $5"
}

# Versions are asked for again only when one of the programs has changed.
check_versions() {
    tools=$(for name in emcc cmake node; do ls -lL "$(command -v $name)"; done)
    [ "$tools" != "$(cat "$stamps/tools" 2>/dev/null)" ] || return 0
    rm -f "$stamps/tools"
    require_version Emscripten emcc "$(emcc -dumpversion 2>/dev/null)" 3.1.6 \
        "Debian 12 and later have it (package emscripten), as has emsdk; PATH decides which is used."
    require_version CMake cmake "$(cmake --version | sed -n 's/^cmake version //p')" 3.25 \
        "Debian 12 and later have it (package cmake)."
    require_version Node.js node "$(node --version | sed 's/^v//')" 18 \
        "Debian 12 and later have it (package nodejs); PATH decides which is used."
    rm -rf build/wasm
    printf '%s' "$tools" >"$stamps/tools"
}

install_npm_packages() {
    if [ -d node_modules ] && cmp -s package-lock.json "$stamps/package-lock.json"; then return 0; fi
    step "Installing npm packages into node_modules/" npm npm ci --ignore-scripts ||
        stop "npm could not install the packages that package-lock.json names. They come from the
registry that npm is configured with: $(npm config get registry)"
    cp package-lock.json "$stamps/package-lock.json"
}
