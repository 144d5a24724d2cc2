# cmake -DINPUT=font.ttf -DOUTPUT=ui_font.hpp -P EmbedFont.cmake
file(READ "${INPUT}" bytes HEX)
string(LENGTH "${bytes}" size)
math(EXPR size "${size} / 2")
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE "${OUTPUT}" "#pragma once\n\n// A TrueType font, written by cmake/EmbedFont.cmake.\n"
    "namespace knotwork::ui {\n\ninline constexpr unsigned int uiFontSize = ${size};\n"
    "inline constexpr unsigned char uiFont[uiFontSize] = {\n${bytes}};\n\n}  // namespace\n")
