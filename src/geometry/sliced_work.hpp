// Work in slices: loops that are run a piece at a time, so that whoever waits for it can see how far
// it is, do something else meanwhile, or drop it.
//
// A loop calls its function for one range of its elements after the other, and loops are run in the
// order in which they were queued, so the result is the same wherever the slices end. There is no
// clock in here: a slice is as long as the weight that it is given, and whoever drives the work finds
// out how much of that fits between two pictures.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace knotwork {

class SlicedWork {
public:
    /// What is done for the elements first … last − 1. As std::function, but that it cannot be copied
    /// and takes a third of the code.
    class Run {
    public:
        template <class F>
        Run(F function)
            : held_(new F(std::move(function)), [](void* held) { delete static_cast<F*>(held); }),
              call_([](void* held, std::size_t first, std::size_t last) {
                  (*static_cast<F*>(held))(first, last);
              }) {}
        void operator()(std::size_t first, std::size_t last) const {
            call_(held_.get(), first, last);
        }

    private:
        std::unique_ptr<void, void (*)(void*)> held_;
        void (*call_)(void*, std::size_t, std::size_t);
    };

    /// Queues a loop over `count` elements which weigh so much altogether, in any unit that all loops
    /// of a work have in common.
    void loop(std::size_t count, double weight, Run run);
    /// A loop over one element. Only a step may queue loops while it is run; they come right after
    /// it, before all that was queued earlier.
    template <class F>
    void step(double weight, F run) {
        loop(1, weight, [run = std::move(run)](std::size_t, std::size_t) { run(); });
    }

    /// Goes on for about this weight, by one element at least. Whether anything is left to do.
    bool advance(double weight);
    void finish();
    /// For the function of a loop: nothing comes after it any more.
    void stop() noexcept { stopped_ = true; }

    [[nodiscard]] bool done() const noexcept { return queue_.empty() && added_.empty(); }
    /// How much of the work is done: from 0 to 1, never less than before. A step hands its share on
    /// to the loops that it queues, by their weights, so its own weight is to stand for theirs.
    [[nodiscard]] double fraction() const noexcept;

private:
    struct Loop {
        std::size_t count = 0;
        double weight = 0;
        Run run;
        double share = 0;  ///< of the whole work
    };
    double runSome(double weight);
    void endNext();
    void place(double share);

    std::vector<Loop> queue_;  ///< the next one last
    std::vector<Loop> added_;  ///< while a step is run, or before the first slice
    std::size_t at_ = 0;       ///< elements of the next loop that are done
    double finished_ = 0;      ///< share of the loops that are over
    bool stopped_ = false;
};

}  // namespace knotwork
