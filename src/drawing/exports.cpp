#include "drawing/exports.hpp"

#include "drawing/export_parts.hpp"

#include <limits>
#include <utility>

namespace knotwork::drawing {

SceneExport::SceneExport(scene::State state, const SvgOptions& picture)
    : run_(std::make_unique<ExportRun>()) {
    run_->state = std::move(state);
    planPicture(*run_, picture);
}

SceneExport::SceneExport(scene::State state, ExportFormat format, const ExportOptions& options)
    : run_(std::make_unique<ExportRun>()) {
    run_->state = std::move(state);
    run_->options = options;
    if (format == ExportFormat::svg) {
        SvgOptions picture;
        picture.moment = options.moment;
        planPicture(*run_, picture);
    } else if (format == ExportFormat::json || format == ExportFormat::js ||
               format == ExportFormat::csv || format == ExportFormat::obj) {
        planText(*run_, format);
    } else {
        planBinary(*run_, format);
    }
}

SceneExport::SceneExport(SceneExport&&) noexcept = default;
SceneExport& SceneExport::operator=(SceneExport&&) noexcept = default;
SceneExport::~SceneExport() = default;

Result<bool> SceneExport::advance(double numbers) {
    const bool more = run_->work.advance(numbers);
    if (run_->refusal) return *run_->refusal;
    return more;
}

double SceneExport::fraction() const noexcept { return run_->work.fraction(); }

std::string SceneExport::take() {
    if (run_->flush) run_->flush();
    return std::exchange(run_->text, std::string());
}

Result<std::string> SceneExport::finish() {
    for (;;) {
        const auto more = advance(std::numeric_limits<double>::max());
        if (!more) return more.error();
        if (!*more) return take();
    }
}

Result<std::string> exportScene(const scene::State& state, ExportFormat format,
                                const ExportOptions& options) {
    return SceneExport(state, format, options).finish();
}

}  // namespace knotwork::drawing
