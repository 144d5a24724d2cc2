# shellcheck shell=sh
# CMake's presets, configured when they have to be and compiled quietly.

# A node that is not Debian's own does not find the packages that Debian's Emscripten uses.
if [ -d /usr/share/nodejs/acorn ]; then
    export NODE_PATH="/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}"
fi

build_preset() { # build_preset preset words
    if [ ! -e "build/$1/build.ninja" ]; then
        step "Configuring $2" "configure-$1" cmake --preset "$1" || return 1
    fi
    step "Compiling $2" "compile-$1" cmake --build --preset "$1"
}
