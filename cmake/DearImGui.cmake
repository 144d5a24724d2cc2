# Dear ImGui with its OpenGL back end, from the folder KNOTWORK_IMGUI_DIR. When none is given, the
# sources are fetched once from the Debian mirror that this machine uses and kept in build/.
set(KNOTWORK_IMGUI_DIR "$ENV{KNOTWORK_IMGUI_DIR}" CACHE PATH
    "A folder with the sources of Dear ImGui 1.90 or newer (empty: fetch them)")

set(imgui_dir "${KNOTWORK_IMGUI_DIR}")
if(NOT imgui_dir)
    set(imgui_dir "${PROJECT_SOURCE_DIR}/build/third-party/imgui")
    if(NOT EXISTS "${imgui_dir}/imgui.h")
        message(STATUS "Fetching the sources of Dear ImGui")
        execute_process(COMMAND "${PROJECT_SOURCE_DIR}/tools/fetch-imgui.sh" "${imgui_dir}"
            COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
    endif()
endif()
if(NOT EXISTS "${imgui_dir}/imgui.h")
    message(FATAL_ERROR "KNOTWORK_IMGUI_DIR is ${imgui_dir}, which holds no imgui.h.")
endif()

file(STRINGS "${imgui_dir}/imgui.h" imgui_version REGEX "#define IMGUI_VERSION_NUM ")
string(REGEX MATCH "[0-9]+" imgui_version "${imgui_version}")
if(imgui_version LESS 19000)
    message(FATAL_ERROR
        "Dear ImGui in ${imgui_dir} has version number ${imgui_version}; 19000 (1.90) is needed.")
endif()

# The demo stays out; our own panels and scenes are what there is to show. Natively (for tests of the
# panels) there is no back end, since there is nothing to draw on.
add_library(knotwork_imgui STATIC
    "${imgui_dir}/imgui.cpp" "${imgui_dir}/imgui_draw.cpp" "${imgui_dir}/imgui_tables.cpp"
    "${imgui_dir}/imgui_widgets.cpp")
target_compile_definitions(knotwork_imgui PUBLIC
    IMGUI_DISABLE_DEMO_WINDOWS IMGUI_DISABLE_DEBUG_TOOLS IMGUI_DISABLE_FILE_FUNCTIONS
    IMGUI_DISABLE_OBSOLETE_FUNCTIONS)
target_compile_options(knotwork_imgui PRIVATE -w -fno-exceptions -fno-rtti)
target_include_directories(knotwork_imgui SYSTEM PUBLIC "${imgui_dir}" "${imgui_dir}/backends")
if(EMSCRIPTEN)
    target_sources(knotwork_imgui PRIVATE "${imgui_dir}/backends/imgui_impl_opengl3.cpp")
    target_compile_definitions(knotwork_imgui PRIVATE IMGUI_IMPL_OPENGL_ES3)
    target_compile_options(knotwork_imgui PRIVATE -Oz -flto)
endif()
add_library(knotwork::imgui ALIAS knotwork_imgui)

include(UiFont)
