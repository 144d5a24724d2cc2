# Dear ImGui's own font has no Greek letters, superscripts or accents: a subset of DejaVu Sans is
# cut at build time and becomes an array in <build tree>/generated/ui_font.hpp.
if(DEFINED ENV{KNOTWORK_UI_FONT})
    set(KNOTWORK_UI_FONT "$ENV{KNOTWORK_UI_FONT}" CACHE FILEPATH "")
endif()
find_file(KNOTWORK_UI_FONT NAMES DejaVuSans.ttf
    PATHS /usr/share/fonts /usr/local/share/fonts
    PATH_SUFFIXES truetype/dejavu truetype/ttf-dejavu dejavu TTF dejavu-sans-fonts
    NO_CMAKE_FIND_ROOT_PATH DOC "The font that the panels are written in")
find_program(KNOTWORK_FONTTOOLS fonttools NO_CMAKE_FIND_ROOT_PATH)
if(NOT KNOTWORK_UI_FONT)
    message(FATAL_ERROR "DejaVuSans.ttf was not found. Install it (Debian: fonts-dejavu-core) or "
        "name a TrueType font with Greek letters with -DKNOTWORK_UI_FONT=...")
endif()
if(NOT KNOTWORK_FONTTOOLS)
    message(FATAL_ERROR "fonttools was not found in PATH (Debian: package fonttools).")
endif()

# Latin-1, Greek, dashes and quotes, super- and subscripts, arrows, the mathematics that we write, and
# the signs on buttons.
string(CONCAT glyphs
    "U+0020-007E,U+00A0-00FF,U+0391-03C9,U+2010-2015,U+2018-201E,U+2026,U+2032-2033,U+2070-2094,"
    "U+2190-2195,U+21BA-21BB,U+2202,U+2208,U+2211-2213,U+221A,U+221E,U+222B,U+2248,U+2260,"
    "U+2264-2265,U+2297,U+22C5,U+25A0,U+25B2,U+25B6,U+25BC,U+25C0,U+25CF,U+25CB,U+2713,U+FFFD")
set(generated "${PROJECT_BINARY_DIR}/generated")
file(MAKE_DIRECTORY "${generated}")
add_custom_command(
    OUTPUT "${generated}/ui_font.hpp"
    COMMAND "${KNOTWORK_FONTTOOLS}" subset "${KNOTWORK_UI_FONT}" "--unicodes=${glyphs}"
        --no-hinting --notdef-outline "--layout-features=" --name-IDs=0,13
        "--drop-tables+=GSUB,GPOS,GDEF,FFTM,kern" "--output-file=${generated}/ui_font.ttf"
    COMMAND "${CMAKE_COMMAND}" "-DINPUT=${generated}/ui_font.ttf"
        "-DOUTPUT=${generated}/ui_font.hpp" -P "${PROJECT_SOURCE_DIR}/cmake/EmbedFont.cmake"
    DEPENDS "${PROJECT_SOURCE_DIR}/cmake/EmbedFont.cmake" "${KNOTWORK_UI_FONT}"
    COMMENT "Cutting the font of the panels"
    VERBATIM)
add_custom_target(knotwork_ui_font_file DEPENDS "${generated}/ui_font.hpp")

add_library(knotwork_ui_font INTERFACE)
target_include_directories(knotwork_ui_font INTERFACE "${PROJECT_BINARY_DIR}")
add_dependencies(knotwork_ui_font knotwork_ui_font_file)
add_library(knotwork::ui_font ALIAS knotwork_ui_font)
