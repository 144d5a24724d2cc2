# cmake "-DDOCUMENTS=a.json;b.json" -DOUTPUT=builtin_scenes.hpp -P EmbedScenes.cmake
# The order is that of `order.txt` beside the documents: it is the order of the gallery.
list(GET DOCUMENTS 0 first)
cmake_path(GET first PARENT_PATH folder)
file(STRINGS "${folder}/order.txt" order)
list(LENGTH order listed)
list(LENGTH DOCUMENTS present)
if(NOT listed EQUAL present)
    message(FATAL_ERROR "order.txt names ${listed} scenes, the folder holds ${present}.")
endif()

set(entries "")
foreach(id IN LISTS order)
    file(READ "${folder}/${id}.json" document)
    string(APPEND entries "    BuiltinScene{\"${id}\", R\"json(${document})json\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "#pragma once\n\n// The built-in scenes, written by cmake/EmbedScenes.cmake.\n"
    "#include \"scene/builtin.hpp\"\n\n#include <array>\n\n"
    "namespace knotwork::scene {\n\ninline constexpr std::array generatedScenes{\n${entries}};\n\n"
    "}  // namespace knotwork::scene\n")
