#include "geometry/sliced_work.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace knotwork {

void SlicedWork::loop(std::size_t count, double weight, Run run) {
    if (count > 0) added_.push_back({count, weight, std::move(run)});
}

bool SlicedWork::advance(double weight) {
    if (!added_.empty()) place(1 - finished_);
    do {
        if (queue_.empty()) return false;
        weight -= runSome(weight);
    } while (weight > 0);
    return !queue_.empty();
}

void SlicedWork::finish() {
    while (advance(std::numeric_limits<double>::max())) {
    }
}

double SlicedWork::fraction() const noexcept {
    if (queue_.empty()) return finished_;
    const Loop& next = queue_.back();
    const double part = static_cast<double>(at_) / static_cast<double>(next.count);
    return std::min(1.0, finished_ + next.share * part);
}

/// As many elements of the next loop as the weight allows; answers what they weigh.
double SlicedWork::runSome(double weight) {
    Loop& next = queue_.back();
    const double each = next.weight / static_cast<double>(next.count);
    const std::size_t left = next.count - at_;
    const bool all = weight >= each * static_cast<double>(left);
    const std::size_t some =
        all ? left : std::max<std::size_t>(1, static_cast<std::size_t>(weight / each));
    next.run(at_, at_ + some);
    at_ += some;
    if (stopped_) {
        queue_.clear();
        added_.clear();
        at_ = 0;
    } else if (at_ == next.count) {
        endNext();
    }
    return each * static_cast<double>(some);
}

void SlicedWork::endNext() {
    const Loop next = std::move(queue_.back());
    queue_.pop_back();
    at_ = 0;
    if (added_.empty()) finished_ += next.share;
    else place(next.share);
}

/// Puts what was added before all else, and divides the share among it by weight, or evenly where
/// nothing weighs anything.
void SlicedWork::place(double share) {
    double total = 0;
    for (const Loop& one : added_) total += one.weight;
    const double alike = share / static_cast<double>(added_.size());
    for (Loop& one : added_) one.share = total > 0 ? one.weight / total * share : alike;
    queue_.insert(queue_.end(), std::make_move_iterator(added_.rbegin()),
                  std::make_move_iterator(added_.rend()));
    added_.clear();
}

}  // namespace knotwork
