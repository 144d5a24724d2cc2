#include "drawing/exports.hpp"

namespace knotwork::drawing {

Result<std::string> exportScene(const scene::State& state, ExportFormat format,
                                const ExportOptions& options) {
    switch (format) {
        case ExportFormat::json: return exportJson(state);
        case ExportFormat::js: return exportJavaScript(state);
        case ExportFormat::csv: return exportCsv(state, options);
        case ExportFormat::obj: return exportObj(state, options);
        case ExportFormat::stl: return exportStl(state, options);
        case ExportFormat::gltf: return exportGltf(state, options);
        case ExportFormat::glb: return exportGlb(state, options);
        case ExportFormat::svg: break;
    }
    SvgOptions picture;
    picture.moment = options.moment;
    return svg(state, picture);
}

}  // namespace knotwork::drawing
