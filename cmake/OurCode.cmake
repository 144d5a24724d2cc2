# What holds for every translation unit of ours, and for no one else's.

# Results must be the same to the bit natively and in wasm, so no fused multiply-add.
set(KNOTWORK_CODE_OPTIONS -ffp-contract=off -fno-exceptions -fno-rtti)

set(KNOTWORK_WARNING_OPTIONS
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # a false alarm of its own std::string: GCC's bug 105651
    list(APPEND KNOTWORK_WARNING_OPTIONS -Wno-restrict)
endif()

# LLVM 14 (Emscripten 3.1.6) may load again for a splat what it has just overwritten when it makes
# lanes of straight-line code (`row = matrix * row` came out wrong). The kernels that matter are
# written with intrinsics, so nothing is lost without that.
if(EMSCRIPTEN)
    list(APPEND KNOTWORK_CODE_OPTIONS -msimd128 -fno-slp-vectorize)
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

# knotwork_layer(name [SMALL] [EXCEPT regex] [FOLDERS folders...] [USES libraries...]): the library
# knotwork_<name> from src/<name>/*.cpp and the named folders in it, without the files whose names
# match the expression.
# A layer that has no sources is an interface library, so that the others can always name it.
# What calls WebGL lies in src/<name>/gl and is compiled for wasm only; everything else also natively,
# for the tests. SMALL is for code that runs a few times a frame: size counts there, speed does not.
function(knotwork_layer name)
    cmake_parse_arguments(PARSE_ARGV 1 layer "SMALL" "EXCEPT" "FOLDERS;USES")
    file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${name}/*.cpp")
    foreach(folder IN LISTS layer_FOLDERS)
        file(GLOB more CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${name}/${folder}/*.cpp")
        list(APPEND sources ${more})
    endforeach()
    if(layer_EXCEPT)
        list(FILTER sources EXCLUDE REGEX "/${name}/[^/]*(${layer_EXCEPT})[^/]*$")
    endif()
    if(EMSCRIPTEN)
        file(GLOB gl_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${name}/gl/*.cpp")
        list(APPEND sources ${gl_sources})
    endif()
    if(sources)
        add_library(knotwork_${name} STATIC ${sources})
        target_link_libraries(knotwork_${name} PUBLIC ${layer_USES} PRIVATE knotwork_our_code)
        if(layer_SMALL AND EMSCRIPTEN)
            target_compile_options(knotwork_${name} PRIVATE -Oz)
        endif()
    else()
        add_library(knotwork_${name} INTERFACE)
        target_link_libraries(knotwork_${name} INTERFACE ${layer_USES})
    endif()
endfunction()
