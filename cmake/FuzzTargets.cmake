# One program for each file of tests/fuzz: clang's libFuzzer over the layers that read what strangers
# write. The preset native-fuzz builds them; ./dev fuzz and ./dev test run them.
option(KNOTWORK_FUZZ "Build the fuzz targets (clang)" OFF)
if(NOT KNOTWORK_FUZZ)
    return()
endif()

add_custom_target(knotwork_fuzz)
file(GLOB fuzz_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/fuzz/*.cpp")
foreach(source IN LISTS fuzz_sources)
    get_filename_component(name "${source}" NAME_WE)
    add_executable(fuzz_${name} EXCLUDE_FROM_ALL "${source}")
    target_include_directories(fuzz_${name} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
    target_link_libraries(fuzz_${name} PRIVATE knotwork_drawing knotwork_our_code)
    target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
    add_dependencies(knotwork_fuzz fuzz_${name})
endforeach()
