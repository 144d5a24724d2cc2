// How far subdivided meshes may be from the truth; coordinates up to 10. Largest differences of the
// zoo's meshes, about doubled.
#pragma once

namespace knotwork::test::gates {

inline constexpr double subdivided = 4e-15;       // one level against the textbook's sums: 1.8e-15
inline constexpr double affineLevels = 1.2e-14;   // three levels of a moved mesh: 5.6e-15
inline constexpr double limitPosition = 2e-15;    // of a mesh and of a finer one: 9e-16
inline constexpr double limitNormal = 1e-14;      // 5e-15

}  // namespace knotwork::test::gates
