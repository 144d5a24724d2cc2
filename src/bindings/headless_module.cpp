// The session as both modules export it.
#include "bindings/session.hpp"

#include <emscripten/bind.h>
#include <malloc.h>

namespace {

/// Bytes that the module has allocated and not freed: flat memory can be tested to the byte.
double memoryInUse(const knotwork::bindings::Session&) {
    return static_cast<double>(mallinfo().uordblks);
}

}  // namespace

EMSCRIPTEN_BINDINGS(knotwork_session) {
    using knotwork::bindings::Session;
    emscripten::class_<Session>("Session")
        .constructor<>()
        .function("error", &Session::error)
        .function("room", &Session::room)
        .function("block", &Session::block)
        .function("parameters", &Session::parameters)
        .function("integers", &Session::integers)
        .function("bulk", &Session::bulk)
        .function("dropBulk", &Session::dropBulk)
        .function("release", &Session::release)
        .function("inputText", &Session::inputText)
        .function("held", &Session::held)
        .function("memoryInUse", &memoryInUse)
        .function("bFunction", &Session::bFunction)
        .function("bFunctionSpec", &Session::bFunctionSpec)
        .function("bFunctionTraits", &Session::bFunctionTraits)
        .function("bFunctionWarning", &Session::bFunctionWarning)
        .function("bFunctionDerivatives", &Session::bFunctionDerivatives)
        .function("bFunctionSample", &Session::bFunctionSample)
        .function("bFunctions", &Session::bFunctions)
        .function("ask", &Session::ask)
        .function("askCurve", &Session::askCurve)
        .function("askSurface", &Session::askSurface)
        .function("curve", &Session::curve)
        .function("curveSpec", &Session::curveSpec)
        .function("curvePoint", &Session::curvePoint)
        .function("curveDerivatives", &Session::curveDerivatives)
        .function("curveSample", &Session::curveSample)
        .function("curveAt", &Session::curveAt)
        .function("curvePolyline", &Session::curvePolyline)
        .function("parametricCurves", &Session::parametricCurves)
        .function("curveFrame", &Session::curveFrame)
        .function("curveClosestPoint", &Session::curveClosestPoint)
        .function("curveSphere", &Session::curveSphere)
        .function("curveLength", &Session::curveLength)
        .function("curveParameterAtLength", &Session::curveParameterAtLength)
        .function("curveKnots", &Session::curveKnots)
        .function("curveGrevilles", &Session::curveGrevilles)
        .function("curveControlPoints", &Session::curveControlPoints)
        .function("curveInsertKnot", &Session::curveInsertKnot)
        .function("curveRefine", &Session::curveRefine)
        .function("curveBasis", &Session::curveBasis)
        .function("curveBasisAt", &Session::curveBasisAt)
        .function("curveBlendBasis", &Session::curveBlendBasis)
        .function("curveWithPose", &Session::curveWithPose)
        .function("curveLocal", &Session::curveLocal)
        .function("curveWithKnots", &Session::curveWithKnots)
        .function("surface", &Session::surface)
        .function("surfaceSpec", &Session::surfaceSpec)
        .function("surfacePoint", &Session::surfacePoint)
        .function("surfaceDerivatives", &Session::surfaceDerivatives)
        .function("normals", &Session::normals)
        .function("surfaceGrid", &Session::surfaceGrid)
        .function("surfaceNormal", &Session::surfaceNormal)
        .function("surfaceCurvatures", &Session::surfaceCurvatures)
        .function("parametricSurfaces", &Session::parametricSurfaces)
        .function("subdivision", &Session::subdivision)
        .function("subdivisionPoints", &Session::subdivisionPoints)
        .function("dropSubdivision", &Session::dropSubdivision)
        .function("fit", &Session::fit)
        .function("interpolate", &Session::interpolate)
        .function("enclosingSphere", &Session::enclosingSphere)
        .function("openScene", &Session::openScene)
        .function("sceneDocument", &Session::sceneDocument)
        .function("sceneSchema", &Session::sceneSchema)
        .function("sceneExecute", &Session::sceneExecute)
        .function("sceneUndo", &Session::sceneUndo)
        .function("sceneRedo", &Session::sceneRedo)
        .function("sceneCanUndo", &Session::sceneCanUndo)
        .function("sceneCanRedo", &Session::sceneCanRedo)
        .function("sceneRevision", &Session::sceneRevision)
        .function("sceneDrawing", &Session::sceneDrawing)
        .function("dropDrawing", &Session::dropDrawing)
        .function("scenes", &Session::scenes)
        .function("documentSchema", &Session::documentSchema);
}
