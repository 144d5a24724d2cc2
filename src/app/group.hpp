// Several points, or several local curves or patches, that are moved, turned and scaled together.
//
// What a group is made to do is said from where it stood when the Group was made: a later command
// takes the place of an earlier one and is not added to it.
#pragma once

#include "app/drag_moves.hpp"
#include "app/target.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace knotwork::app {

/// A target with how its object is placed at the moment.
struct Member {
    Target target;
    Frame frame;
};

/// The mean of where they stand, as round as a pixel allows; there is at least one.
[[nodiscard]] Vec3 centreOf(const std::vector<Target>& targets, double pixel) noexcept;

class Group {
public:
    /// All members are of one kind, points or poses, and in the document; there is at least one.
    /// Axes and directions are those of the first one's object. `pixel` units are as fine as numbers
    /// get.
    [[nodiscard]] static Group of(const scene::State& state, const std::vector<Member>& members,
                                  double pixel);

    /// The mean of the members, in the world: what stays where it is in turns and scalings.
    [[nodiscard]] const Vec3& centre() const noexcept { return centre_; }
    [[nodiscard]] const Frame& frame() const noexcept { return frame_; }
    /// Whether some points have two coordinates, which a hand does not make three.
    [[nodiscard]] bool inPlane() const noexcept { return inPlane_; }
    [[nodiscard]] std::vector<std::string> paths() const;

    // Commands without a gesture, one for all.
    [[nodiscard]] scene::Json moved(const Vec3& by) const;
    /// About one of the axes through the centre.
    [[nodiscard]] scene::Json turned(int axis, double angle) const;
    /// From the centre in all directions. Poses have no other scaling in common.
    [[nodiscard]] scene::Json scaled(double factor) const;
    /// Points along one of the axes, poses in all directions.
    [[nodiscard]] scene::Json scaledAlong(int axis, double factor) const;

private:
    /// The members of one object.
    struct Part {
        Frame frame;
        std::string object;               ///< id
        std::string list;                 ///< of points: the whole of it
        std::vector<std::string> paths;   ///< of points
        scene::Json values = nullptr;     ///< of points: all of the list
        scene::Json locals = scene::Json::array();  ///< of poses
    };
    [[nodiscard]] static Part partOf(const scene::State& state, const Member& member);
    [[nodiscard]] Vec3 centreIn(const Part& part) const noexcept;
    [[nodiscard]] scene::Json posed(const Part& part, scene::Json by) const;
    template <class Map>
    [[nodiscard]] scene::Json mapped(const Part& part, const Map& map) const;
    template <class Make>
    [[nodiscard]] scene::Json together(const Make& make) const;

    bool poses_ = false;
    bool inPlane_ = false;
    double pixel_ = 0;
    Vec3 centre_{0.0};
    Frame frame_;
    std::vector<Part> parts_;
};

/// The command that takes all of these away, or null where some cannot be.
[[nodiscard]] scene::Json removal(std::vector<Target> targets);

}  // namespace knotwork::app
