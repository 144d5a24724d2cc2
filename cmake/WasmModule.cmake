# knotwork_wasm_module(name EXPORT_NAME ... SOURCES ... FAST ... USES ... LINK ...): one module of glue (.mjs)
# and wasm. The glue runs in Node and in browsers; the loader in web/ always hands it the bytes of
# the wasm, so the glue never has to find a file by itself.
set(KNOTWORK_WASM_LINK_OPTIONS
    --bind --no-entry
    -fno-rtti               # chooses the embind library that fits objects without RTTI
    -sMODULARIZE -sEXPORT_ES6 -sUSE_ES6_IMPORT_META=0 -sENVIRONMENT=web,worker
    -sDYNAMIC_EXECUTION=0   # no new Function: the page forbids unsafe-eval
    -sFILESYSTEM=0
    -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=2147483648
    -sTOTAL_STACK=1048576   # the default is 5 MiB in 3.1.6 and 64 KiB in 3.1.69
    -sASSERTIONS=0 -sMALLOC=emmalloc
    -Wl,-mllvm,-slp-threshold=10000)  # as when compiling: cmake/OurCode.cmake says why

function(knotwork_wasm_module name)
    cmake_parse_arguments(PARSE_ARGV 1 module "" "EXPORT_NAME" "SOURCES;FAST;USES;LINK")
    if(NOT module_SOURCES)
        return()
    endif()
    add_executable(${name} ${module_SOURCES})
    set_target_properties(${name} PROPERTIES SUFFIX .mjs)
    # embind without RTTI needs to be told that it cannot name types it was never told about
    target_compile_definitions(${name} PRIVATE EMSCRIPTEN_HAS_UNBOUND_TYPE_NAMES=0)
    knotwork_optimise("${module_SOURCES}" "${module_FAST}")
    target_link_libraries(${name} PRIVATE ${module_USES} knotwork_our_code)
    if(EXISTS /usr/share/nodejs/acorn)
        # Debian's Emscripten 3.1.6 needs acorn, which a node that is not Debian's own does not find
        set_target_properties(${name} PROPERTIES RULE_LAUNCH_LINK
            "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs:$ENV{NODE_PATH}")
    endif()
    target_link_options(${name} PRIVATE
        -O2 -flto -msimd128 ${KNOTWORK_WASM_LINK_OPTIONS} -sEXPORT_NAME=${module_EXPORT_NAME}
        ${module_LINK})
endfunction()
