# The session behind the bindings is plain C++: everything in src/bindings but the registration.
file(GLOB session_sources CONFIGURE_DEPENDS
    "${PROJECT_SOURCE_DIR}/src/bindings/marshal*.cpp"
    "${PROJECT_SOURCE_DIR}/src/bindings/session*.cpp"
    "${PROJECT_SOURCE_DIR}/src/bindings/queries*.cpp")
add_library(knotwork_session STATIC ${session_sources})
target_link_libraries(knotwork_session PUBLIC knotwork_drawing PRIVATE knotwork_our_code)

# What ./dev bench compares WebAssembly with.
if(KNOTWORK_BENCH)
    add_executable(knotwork_bench "${PROJECT_SOURCE_DIR}/tests/bench/native/main.cpp")
    target_link_libraries(knotwork_bench PRIVATE knotwork_scene knotwork_our_code)
endif()

# The C++ tests. KNOTWORK_TESTS=OFF compiles the libraries only (a second compiler's opinion).
option(KNOTWORK_TESTS "Build the C++ tests" ON)
if(NOT KNOTWORK_TESTS)
    return()
endif()

file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/cpp/*.cpp")
file(GLOB counting CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/cpp/counted/*.cpp")
list(REMOVE_ITEM sources ${counting})
if(NOT sources)
    return()
endif()

# ./dev coverage: without optimisation, so that every line is there to be counted.
option(KNOTWORK_COVERAGE "Count which lines of the geometry the tests reach (GCC)" OFF)
if(KNOTWORK_COVERAGE)
    target_compile_options(knotwork_geometry PRIVATE --coverage -O0)
    add_link_options(--coverage)
endif()

find_package(GTest REQUIRED)
find_library(rapidcheck_library rapidcheck REQUIRED)
find_path(rapidcheck_headers rapidcheck.h REQUIRED)
enable_testing()
add_executable(knotwork_tests ${sources})
target_include_directories(knotwork_tests PRIVATE "${PROJECT_SOURCE_DIR}/tests/cpp")
target_compile_definitions(knotwork_tests PRIVATE
    KNOTWORK_SOURCE_DIR="${PROJECT_SOURCE_DIR}" $<$<BOOL:${KNOTWORK_SANITIZE}>:KNOTWORK_SANITIZED>)
target_include_directories(knotwork_tests SYSTEM PRIVATE "${rapidcheck_headers}")
target_link_libraries(knotwork_tests PRIVATE
    knotwork_session knotwork_app knotwork_our_code GTest::gtest_main ${rapidcheck_library})
# Operation counts: the sources of meshes once more, under another name for their namespace, over
# points and steps that count.
file(GLOB counted CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/geometry/mesh*.cpp")
foreach(name checks result)
    list(APPEND counted "${PROJECT_SOURCE_DIR}/src/geometry/${name}.cpp")
endforeach()
add_library(knotwork_counted OBJECT ${counted} ${counting})
target_compile_definitions(knotwork_counted PRIVATE knotwork=knotwork_counted)
target_include_directories(knotwork_counted PRIVATE
    "${PROJECT_SOURCE_DIR}/tests/cpp/counted" "${PROJECT_SOURCE_DIR}/tests/cpp")
target_link_libraries(knotwork_counted PRIVATE knotwork_our_code GTest::gtest)
target_sources(knotwork_tests PRIVATE $<TARGET_OBJECTS:knotwork_counted>)
# Of an inline function the linker keeps the first copy: the one that counts.
if(KNOTWORK_COVERAGE)
    target_link_options(knotwork_tests PRIVATE
        "LINKER:--whole-archive" "$<TARGET_FILE:knotwork_geometry>" "LINKER:--no-whole-archive")
endif()
# A property that fails throws: rapidcheck is made so. What they test is compiled without exceptions.
file(GLOB properties CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/cpp/properties/*.cpp")
set(property_options -fexceptions -frtti)
if(KNOTWORK_SANITIZE)
    # asks objects for their type that code without it has made
    list(APPEND property_options -fno-sanitize=vptr)
endif()
set_source_files_properties(${properties} PROPERTIES COMPILE_OPTIONS "${property_options}")
add_test(NAME knotwork_tests COMMAND knotwork_tests)
