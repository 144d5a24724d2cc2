# shellcheck shell=sh
# CMake's presets, configured when they have to be and compiled quietly.

build_preset() { # build_preset preset words
    if [ ! -e "build/$1/build.ninja" ]; then
        step "Configuring $2" "configure-$1" cmake --preset "$1" || return 1
    fi
    step "Compiling $2" "compile-$1" cmake --build --preset "$1"
}
