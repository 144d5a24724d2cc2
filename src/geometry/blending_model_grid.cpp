#include "geometry/blending_model_grid.hpp"

#include "geometry/surface.hpp"

#include <algorithm>

namespace knotwork {

namespace {

bool shifts(const BlendingSurface& surface) noexcept {
    const BlendingSpan u = surface.alongU().spanAt(surface.domain().u.end, Side::left);
    const BlendingSpan v = surface.alongV().spanAt(surface.domain().v.end, Side::left);
    return surface.shiftU(u) != 0 || surface.shiftV(v) != 0;
}

Affine plus(const Affine& a, double factor, const Affine& b) noexcept {
    return {a.linear + factor * b.linear, a.offset + factor * b.offset};
}

}  // namespace

bool BlendedModelGrid::suits(const BlendingSurface& surface) noexcept {
    if (!surface.cutsModel() || shifts(surface)) return false;
    if (surface.model().as<ParametricSurface>() != nullptr) return true;
    const auto* spline = surface.model().as<BsplineSurface>();
    return spline != nullptr && !spline->rational() && spline->domain() == surface.domain();
}

BlendedModelGrid::BlendedModelGrid(const BlendingSurface& surface, const GridLine& u,
                                   const GridLine& v)
    : surface_(surface),
      model_(surface.model().as<ParametricSurface>()),
      spline_(surface.model().as<BsplineSurface>()),
      u_(surface.alongU(), u),
      v_(surface.alongV(), v),
      // A model has the origin besides, which the maps move.
      terms_(model_ != nullptr ? model_->axes().size() + 1
                               : static_cast<std::size_t>(spline_->knotsV().degree()) + 1),
      columns_(v.count, 2 * terms_, 3, leastNormal(surface)) {
    if (spline_ != nullptr) {
        basisU_.emplace(spline_->knotsU(), u);
        basisV_.emplace(spline_->knotsV(), v);
        points_.resize(spline_->columnCount());
    } else {
        alongU_.resize(2 * (terms_ - 1) * u.count);
        for (std::size_t i = 0; i < u.count; ++i) {
            model_->factorsU(u_.span(i).t, 1, std::span(alongU_).subspan(2 * (terms_ - 1) * i));
        }
        points_.resize(terms_);
    }
    slopes_.resize(points_.size());
    addColumns(v);
    row_.resize(runs_.size() * 2 * terms_ * 6);
}

std::size_t BlendedModelGrid::runOf(std::size_t cell, std::size_t span) {
    // Only the last column of a closed direction is one of the first run again.
    for (const std::size_t known : {runs_.size() - 1, std::size_t{0}}) {
        if (known < runs_.size() && runs_[known].cell == cell && runs_[known].span == span) {
            return known;
        }
    }
    runs_.push_back({cell, span});
    return runs_.size() - 1;
}

void BlendedModelGrid::addColumns(const GridLine& v) {
    std::vector<double> own(2 * terms_);  // g_k and its derivative in turn
    std::vector<double> values(2 * terms_);
    std::vector<double> slopes(2 * terms_);
    for (std::size_t j = 0; j < v.count; ++j) {
        if (spline_ != nullptr) {
            for (std::size_t k = 0; k < terms_; ++k) {
                own[2 * k] = basisV_->at(j)[k];
                own[2 * k + 1] = basisV_->at(j)[terms_ + k];
            }
        } else {
            model_->factorsV(v_.span(j).t, 1, own);
            own[2 * terms_ - 2] = 1;
            own[2 * terms_ - 1] = 0;
        }
        for (std::size_t b = 0; b < 2; ++b) {
            const double weight = b == 0 ? 1 - v_.value(j) : v_.value(j);
            const double slope = b == 0 ? -v_.slope(j) : v_.slope(j);
            for (std::size_t k = 0; k < terms_; ++k) {
                values[b * terms_ + k] = weight * own[2 * k];
                slopes[b * terms_ + k] = weight * own[2 * k + 1] + slope * own[2 * k];
            }
        }
        const std::size_t run =
            runOf(v_.span(j).first, spline_ != nullptr ? basisV_->span(j) : 0);
        columns_.add(j, run * 2 * terms_, values.data(), slopes.data(), 1);
    }
}

void BlendedModelGrid::takeModel(std::size_t row) noexcept {
    std::fill(points_.begin(), points_.end(), Vec3(0));
    std::fill(slopes_.begin(), slopes_.end(), Vec3(0));
    if (spline_ == nullptr) {
        for (std::size_t k = 0; k + 1 < terms_; ++k) {
            const double* factors = &alongU_[2 * ((terms_ - 1) * row + k)];
            points_[k][model_->axes()[k]] = factors[0];
            slopes_[k][model_->axes()[k]] = factors[1];
        }
        return;
    }
    const std::size_t columns = spline_->columnCount();
    const double* values = basisU_->at(row);
    for (std::size_t i = 0; i < basisU_->terms(); ++i) {
        const std::size_t line = spline_->knotsU().pointIndex(basisU_->span(row), i);
        for (std::size_t j = 0; j < columns; ++j) {
            const Vec3& point = spline_->points()[line * columns + j];
            points_[j] += values[i] * point;
            slopes_[j] += values[basisU_->terms() + i] * point;
        }
    }
}

/// The patches of column j of the net of patches, blended along u.
BlendedModelGrid::Maps BlendedModelGrid::mapsAt(std::size_t row, std::size_t j) const noexcept {
    const BlendingSpan& span = u_.span(row);
    const Affine& first = surface_.place(span.first, j).placement();
    const Affine change = plus(surface_.place(span.second, j).placement(), -1, first);
    const Affine none{Mat3(0.0), Vec3(0)};
    return {plus(first, u_.value(row), change), plus(none, u_.slope(row), change)};
}

void BlendedModelGrid::prepare(std::size_t row) noexcept {
    takeModel(row);
    double* to = row_.data();
    for (const Run& run : runs_) {
        for (std::size_t b = 0; b < 2; ++b) {
            const std::size_t next = run.cell + 1 == surface_.alongV().count ? 0 : run.cell + 1;
            const Maps maps = mapsAt(row, b == 0 ? run.cell : next);
            for (std::size_t k = 0; k < terms_; ++k, to += 6) {
                const std::size_t at =
                    spline_ != nullptr ? spline_->knotsV().pointIndex(run.span, k) : k;
                // All control points are moved, of a model only the origin.
                const double moved = spline_ != nullptr || k + 1 == terms_ ? 1 : 0;
                const Vec3 point = maps.map.vector(points_[at]) + moved * maps.map.offset;
                const Vec3 slope = maps.map.vector(slopes_[at]) + maps.slope.vector(points_[at]) +
                                   moved * maps.slope.offset;
                for (int axis = 0; axis < 3; ++axis) {
                    to[axis] = point[axis];
                    to[3 + axis] = slope[axis];
                }
            }
        }
    }
}

}  // namespace knotwork
