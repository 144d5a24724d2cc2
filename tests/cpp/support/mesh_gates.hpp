// How far subdivided meshes may be from the truth; coordinates up to 10, errors rounded up.
#pragma once

namespace knotwork::test::gates {

/// One level against the sums of the textbook. Largest: 4e-15.
inline constexpr double subdivided = 8e-15;

}  // namespace knotwork::test::gates
