# What holds for every translation unit of ours, and for no one else's.

# Results must be the same to the bit natively and in wasm, so no fused multiply-add.
set(KNOTWORK_CODE_OPTIONS -ffp-contract=off -fno-exceptions -fno-rtti)

set(KNOTWORK_WARNING_OPTIONS
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # a false alarm of its own std::string: GCC's bug 105651
    list(APPEND KNOTWORK_WARNING_OPTIONS -Wno-restrict)
endif()

if(EMSCRIPTEN)
    list(APPEND KNOTWORK_CODE_OPTIONS -msimd128 -flto)
endif()

if(KNOTWORK_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # GCC cannot follow initialisation through its own instrumentation and says so of std::optional
    list(APPEND KNOTWORK_WARNING_OPTIONS -Wno-maybe-uninitialized)
endif()

add_library(knotwork_our_code INTERFACE)
target_compile_options(knotwork_our_code INTERFACE
    ${KNOTWORK_CODE_OPTIONS} ${KNOTWORK_WARNING_OPTIONS})
target_include_directories(knotwork_our_code INTERFACE "${PROJECT_SOURCE_DIR}/src")

# Sanitizers are for everything that is linked together, also code that is not ours.
if(KNOTWORK_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all
        -fno-omit-frame-pointer -g1)
    add_link_options(-fsanitize=address,undefined)
endif()
if(KNOTWORK_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# knotwork_optimise(sources fast): how the sources of a target are optimised for wasm.
#
# Size counts there: with -O2 everywhere the headless module had 212 kB gzipped when it had 147 with
# -Oz everywhere. The `fast` ones hold loops over many points and what is done for every
# picture: at -O2 they take a third of the time. They get no -Oz at all, since Emscripten 3.1.6 stops
# inlining for a file whose command line has it anywhere, whatever follows.
#
# LLVM 14 (Emscripten 3.1.6) may load again for a splat what it has just overwritten when it makes
# lanes of straight-line code (`row = matrix * row` came out wrong), so it may not. The kernels that
# matter are written with intrinsics, and nothing is lost. The option counts only after -O.
function(knotwork_optimise sources fast)
    set_source_files_properties(${sources} PROPERTIES
        COMPILE_OPTIONS "-Oz;-fno-slp-vectorize")
    set_source_files_properties(${fast} PROPERTIES COMPILE_OPTIONS "-O2;-fno-slp-vectorize")
endfunction()

# knotwork_layer(name [USES libraries...] [FAST files...]): the library knotwork_<name> from
# src/<name>/*.cpp. A layer that has no sources is an interface library, so that the others can always
# name it. What calls WebGL lies in src/<name>/gl and is compiled for wasm only; everything else also
# natively, for the tests.
function(knotwork_layer name)
    cmake_parse_arguments(PARSE_ARGV 1 layer "" "" "USES;FAST")
    set(folder "${PROJECT_SOURCE_DIR}/src/${name}")
    file(GLOB sources CONFIGURE_DEPENDS "${folder}/*.cpp")
    if(EMSCRIPTEN)
        file(GLOB gl_sources CONFIGURE_DEPENDS "${folder}/gl/*.cpp")
        list(APPEND sources ${gl_sources})
    endif()
    if(NOT sources)
        add_library(knotwork_${name} INTERFACE)
        target_link_libraries(knotwork_${name} INTERFACE ${layer_USES})
        return()
    endif()
    add_library(knotwork_${name} STATIC ${sources})
    target_link_libraries(knotwork_${name} PUBLIC ${layer_USES} PRIVATE knotwork_our_code)
    if(EMSCRIPTEN)
        list(TRANSFORM layer_FAST REPLACE "(.+)" "${folder}/\\1.cpp")
        knotwork_optimise("${sources}" "${layer_FAST}")
    endif()
endfunction()
