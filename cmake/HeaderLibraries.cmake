# GLM and nlohmann-json consist of headers that normally lie in the system's include folder. That
# folder itself must not be given to Emscripten (it would hide Emscripten's own C library), so a
# folder of the build tree holds a link to each library, and only that folder is searched.
function(knotwork_header_library target variable folder probe package)
    find_path(${variable} NAMES "${probe}"
        PATHS /usr/local/include /usr/include /opt/homebrew/include NO_CMAKE_FIND_ROOT_PATH
        DOC "The folder that holds ${folder}/")
    if(NOT ${variable})
        message(FATAL_ERROR "The headers of ${folder} (${probe}) were not found. Install them "
            "(Debian: ${package}) or name the folder that holds them with -D${variable}=...")
    endif()
    set(holder "${PROJECT_BINARY_DIR}/headers/${folder}")
    file(MAKE_DIRECTORY "${holder}")
    file(CREATE_LINK "${${variable}}/${folder}" "${holder}/${folder}" SYMBOLIC)
    add_library(knotwork_headers_${target} INTERFACE)
    target_include_directories(knotwork_headers_${target} SYSTEM INTERFACE "${holder}")
    add_library(knotwork::${target} ALIAS knotwork_headers_${target})
endfunction()

knotwork_header_library(glm KNOTWORK_GLM_INCLUDE_DIR glm glm/glm.hpp libglm-dev)
knotwork_header_library(json KNOTWORK_JSON_INCLUDE_DIR nlohmann nlohmann/json.hpp nlohmann-json3-dev)
