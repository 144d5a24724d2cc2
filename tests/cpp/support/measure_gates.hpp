// How far lengths, frames and searches may be from the truth.
#pragma once

namespace knotwork::test::gates {

// Lengths relative to the whole; measured against closed forms: 6e-15.
inline constexpr double length = 2e-14;
// The inverse of the length, back and forth, relative to the whole.
inline constexpr double lengthInverse = 1e-13;
// Tangent, normal and binormal against an orthonormal basis.
inline constexpr double orthonormal = 1e-14;

}  // namespace knotwork::test::gates
