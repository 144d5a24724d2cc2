# Two modules from the same libraries: one that only computes, and one that also draws. The bindings
# are compiled into each, since nothing refers to their registration and an archive would drop it.
set(bindings "${PROJECT_SOURCE_DIR}/src/bindings")
file(GLOB headless_sources CONFIGURE_DEPENDS
    "${bindings}/marshal*.cpp" "${bindings}/session*.cpp" "${bindings}/queries*.cpp"
    "${bindings}/headless*.cpp")
file(GLOB page_sources CONFIGURE_DEPENDS "${bindings}/*.cpp")

# What stands between a program and the points of a curve that it has just changed.
set(fast_bindings session session_curves session_bspline marshal_bspline marshal_cbor
    marshal_lists)
list(TRANSFORM fast_bindings REPLACE "(.+)" "${bindings}/\\1.cpp")

knotwork_wasm_module(knotwork EXPORT_NAME createKnotwork
    SOURCES ${headless_sources} FAST ${fast_bindings}
    USES knotwork_drawing)

knotwork_wasm_module(knotwork_page EXPORT_NAME createKnotworkPage
    SOURCES ${page_sources} FAST ${fast_bindings}
    USES knotwork_app
    LINK -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2
        -sEXPORTED_RUNTIME_METHODS=GL)  # the page makes the context and hands it over
