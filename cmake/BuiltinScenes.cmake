# The built-in scenes are documents in src/scene/builtin; they become one header of the build tree.
file(GLOB scene_documents CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/scene/builtin/*.json")
set(generated "${PROJECT_BINARY_DIR}/generated")
file(MAKE_DIRECTORY "${generated}")
add_custom_command(
    OUTPUT "${generated}/builtin_scenes.hpp"
    COMMAND "${CMAKE_COMMAND}" "-DDOCUMENTS=${scene_documents}"
        "-DOUTPUT=${generated}/builtin_scenes.hpp"
        -P "${PROJECT_SOURCE_DIR}/cmake/EmbedScenes.cmake"
    DEPENDS "${PROJECT_SOURCE_DIR}/cmake/EmbedScenes.cmake" ${scene_documents}
    COMMENT "Collecting the built-in scenes"
    VERBATIM)
add_custom_target(knotwork_builtin_scenes_file DEPENDS "${generated}/builtin_scenes.hpp")

add_library(knotwork_builtin_scenes INTERFACE)
target_include_directories(knotwork_builtin_scenes INTERFACE "${PROJECT_BINARY_DIR}")
add_dependencies(knotwork_builtin_scenes knotwork_builtin_scenes_file)
add_library(knotwork::builtin_scenes ALIAS knotwork_builtin_scenes)
