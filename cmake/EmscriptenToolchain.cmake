# Finds the Emscripten that is in PATH and hands over to its own toolchain file, so that presets
# need no knowledge of where a distribution or emsdk puts it.
if(NOT KNOTWORK_EMCC)
    find_program(KNOTWORK_EMCC emcc NO_CMAKE_FIND_ROOT_PATH)
endif()
if(NOT KNOTWORK_EMCC)
    message(FATAL_ERROR "emcc (Emscripten 3.1.6 or newer) is not in PATH.")
endif()

execute_process(COMMAND "${KNOTWORK_EMCC}" -dumpversion
    OUTPUT_VARIABLE emcc_version OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(emcc_version VERSION_LESS 3.1.6)
    message(FATAL_ERROR
        "Emscripten ${emcc_version} was found at ${KNOTWORK_EMCC}; 3.1.6 or newer is needed.")
endif()

file(REAL_PATH "${KNOTWORK_EMCC}" emcc_file)
cmake_path(GET emcc_file PARENT_PATH emscripten_root)
include("${emscripten_root}/cmake/Modules/Platform/Emscripten.cmake")
