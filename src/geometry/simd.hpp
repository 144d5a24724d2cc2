// Two doubles at a time: WebAssembly's 128-bit vectors, elsewhere the compiler's own vectors,
// which it lowers to SSE2, NEON or plain arithmetic.
//
// Written with the intrinsics because LLVM 14 does not vectorise lane loops for wasm, and engines
// recognise the shuffles of wasm_i32x4_shuffle where they miss __builtin_shufflevector's.
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#else
#include <cmath>
#include <cstring>
#endif

namespace knotwork::simd {

#if defined(__wasm_simd128__)

struct Double2 {
    v128_t lanes;
};

[[nodiscard]] inline Double2 splat(double value) noexcept { return {wasm_f64x2_splat(value)}; }
[[nodiscard]] inline Double2 load(const double* from) noexcept { return {wasm_v128_load(from)}; }
[[nodiscard]] inline Double2 loadSplat(const double* from) noexcept {
    return {wasm_v128_load64_splat(from)};
}
inline void store(double* to, Double2 value) noexcept { wasm_v128_store(to, value.lanes); }

[[nodiscard]] inline Double2 operator+(Double2 a, Double2 b) noexcept {
    return {wasm_f64x2_add(a.lanes, b.lanes)};
}
[[nodiscard]] inline Double2 operator-(Double2 a, Double2 b) noexcept {
    return {wasm_f64x2_sub(a.lanes, b.lanes)};
}
[[nodiscard]] inline Double2 operator*(Double2 a, Double2 b) noexcept {
    return {wasm_f64x2_mul(a.lanes, b.lanes)};
}
[[nodiscard]] inline Double2 operator/(Double2 a, Double2 b) noexcept {
    return {wasm_f64x2_div(a.lanes, b.lanes)};
}

[[nodiscard]] inline Double2 squareRoot(Double2 a) noexcept {
    return {wasm_f64x2_sqrt(a.lanes)};
}

/// (a0, b0), (a0, b1), (a1, b0) and (a1, b1).
[[nodiscard]] inline Double2 firstFirst(Double2 a, Double2 b) noexcept {
    return {wasm_i32x4_shuffle(a.lanes, b.lanes, 0, 1, 4, 5)};
}
[[nodiscard]] inline Double2 firstSecond(Double2 a, Double2 b) noexcept {
    return {wasm_i32x4_shuffle(a.lanes, b.lanes, 0, 1, 6, 7)};
}
[[nodiscard]] inline Double2 secondFirst(Double2 a, Double2 b) noexcept {
    return {wasm_i32x4_shuffle(a.lanes, b.lanes, 2, 3, 4, 5)};
}
[[nodiscard]] inline Double2 secondSecond(Double2 a, Double2 b) noexcept {
    return {wasm_i32x4_shuffle(a.lanes, b.lanes, 2, 3, 6, 7)};
}

/// In each lane `reached` where a ≥ b, otherwise `before`.
[[nodiscard]] inline Double2 fromOn(Double2 a, Double2 b, Double2 reached,
                                    Double2 before) noexcept {
    return {wasm_v128_bitselect(reached.lanes, before.lanes, wasm_f64x2_ge(a.lanes, b.lanes))};
}

/// The larger and the smaller ones; a where b is no number.
[[nodiscard]] inline Double2 larger(Double2 a, Double2 b) noexcept {
    return {wasm_f64x2_pmax(a.lanes, b.lanes)};
}
[[nodiscard]] inline Double2 smaller(Double2 a, Double2 b) noexcept {
    return {wasm_f64x2_pmin(a.lanes, b.lanes)};
}
/// Neither is a NaN.
[[nodiscard]] inline bool areNumbers(Double2 a) noexcept {
    return wasm_i64x2_all_true(wasm_f64x2_eq(a.lanes, a.lanes));
}
/// All four are less than the limit, and none a NaN.
[[nodiscard]] inline bool areBelow(Double2 a, Double2 b, Double2 limit) noexcept {
    return wasm_i64x2_all_true(wasm_v128_and(wasm_f64x2_lt(a.lanes, limit.lanes),
                                             wasm_f64x2_lt(b.lanes, limit.lanes)));
}
/// The lowest 32 bits of each.
[[nodiscard]] inline std::uint32_t firstBits(Double2 a) noexcept {
    return static_cast<std::uint32_t>(wasm_i32x4_extract_lane(a.lanes, 0));
}
[[nodiscard]] inline std::uint32_t secondBits(Double2 a) noexcept {
    return static_cast<std::uint32_t>(wasm_i32x4_extract_lane(a.lanes, 2));
}

/// What holds in each lane; nothing does of a NaN.
struct Truth2 {
    v128_t lanes;
};

[[nodiscard]] inline Truth2 operator==(Double2 a, Double2 b) noexcept {
    return {wasm_f64x2_eq(a.lanes, b.lanes)};
}
[[nodiscard]] inline Truth2 operator>(Double2 a, Double2 b) noexcept {
    return {wasm_f64x2_gt(a.lanes, b.lanes)};
}
[[nodiscard]] inline Truth2 operator>=(Double2 a, Double2 b) noexcept {
    return {wasm_f64x2_ge(a.lanes, b.lanes)};
}
[[nodiscard]] inline Truth2 operator&(Truth2 a, Truth2 b) noexcept {
    return {wasm_v128_and(a.lanes, b.lanes)};
}
[[nodiscard]] inline Truth2 operator|(Truth2 a, Truth2 b) noexcept {
    return {wasm_v128_or(a.lanes, b.lanes)};
}
[[nodiscard]] inline bool inBoth(Truth2 a) noexcept { return wasm_i64x2_bitmask(a.lanes) == 3; }

[[nodiscard]] inline double first(Double2 a) noexcept {
    return wasm_f64x2_extract_lane(a.lanes, 0);
}
[[nodiscard]] inline double second(Double2 a) noexcept {
    return wasm_f64x2_extract_lane(a.lanes, 1);
}

#else

typedef double Lanes __attribute__((vector_size(16)));

struct Double2 {
    Lanes lanes;
};

[[nodiscard]] inline Double2 splat(double value) noexcept { return {Lanes{value, value}}; }
[[nodiscard]] inline Double2 load(const double* from) noexcept {
    Double2 value;
    std::memcpy(&value, from, sizeof value);
    return value;
}
[[nodiscard]] inline Double2 loadSplat(const double* from) noexcept { return splat(*from); }
inline void store(double* to, Double2 value) noexcept { std::memcpy(to, &value, sizeof value); }

[[nodiscard]] inline Double2 operator+(Double2 a, Double2 b) noexcept {
    return {a.lanes + b.lanes};
}
[[nodiscard]] inline Double2 operator-(Double2 a, Double2 b) noexcept {
    return {a.lanes - b.lanes};
}
[[nodiscard]] inline Double2 operator*(Double2 a, Double2 b) noexcept {
    return {a.lanes * b.lanes};
}
[[nodiscard]] inline Double2 operator/(Double2 a, Double2 b) noexcept {
    return {a.lanes / b.lanes};
}

[[nodiscard]] inline Double2 squareRoot(Double2 a) noexcept {
    return {Lanes{std::sqrt(a.lanes[0]), std::sqrt(a.lanes[1])}};
}

/// (a0, b0), (a0, b1), (a1, b0) and (a1, b1).
[[nodiscard]] inline Double2 firstFirst(Double2 a, Double2 b) noexcept {
    return {Lanes{a.lanes[0], b.lanes[0]}};
}
[[nodiscard]] inline Double2 firstSecond(Double2 a, Double2 b) noexcept {
    return {Lanes{a.lanes[0], b.lanes[1]}};
}
[[nodiscard]] inline Double2 secondFirst(Double2 a, Double2 b) noexcept {
    return {Lanes{a.lanes[1], b.lanes[0]}};
}
[[nodiscard]] inline Double2 secondSecond(Double2 a, Double2 b) noexcept {
    return {Lanes{a.lanes[1], b.lanes[1]}};
}

/// In each lane `reached` where a ≥ b, otherwise `before`.
[[nodiscard]] inline Double2 fromOn(Double2 a, Double2 b, Double2 reached,
                                    Double2 before) noexcept {
    return {Lanes{a.lanes[0] >= b.lanes[0] ? reached.lanes[0] : before.lanes[0],
                  a.lanes[1] >= b.lanes[1] ? reached.lanes[1] : before.lanes[1]}};
}

/// The larger and the smaller ones; a where b is no number.
[[nodiscard]] inline Double2 larger(Double2 a, Double2 b) noexcept {
    return {Lanes{a.lanes[0] < b.lanes[0] ? b.lanes[0] : a.lanes[0],
                  a.lanes[1] < b.lanes[1] ? b.lanes[1] : a.lanes[1]}};
}
[[nodiscard]] inline Double2 smaller(Double2 a, Double2 b) noexcept {
    return {Lanes{b.lanes[0] < a.lanes[0] ? b.lanes[0] : a.lanes[0],
                  b.lanes[1] < a.lanes[1] ? b.lanes[1] : a.lanes[1]}};
}
/// Neither is a NaN.
[[nodiscard]] inline bool areNumbers(Double2 a) noexcept {
    return a.lanes[0] == a.lanes[0] && a.lanes[1] == a.lanes[1];
}
/// All four are less than the limit, and none a NaN.
[[nodiscard]] inline bool areBelow(Double2 a, Double2 b, Double2 limit) noexcept {
    return a.lanes[0] < limit.lanes[0] && a.lanes[1] < limit.lanes[1] &&
           b.lanes[0] < limit.lanes[0] && b.lanes[1] < limit.lanes[1];
}
/// The lowest 32 bits of each.
[[nodiscard]] inline std::uint32_t firstBits(Double2 a) noexcept {
    return static_cast<std::uint32_t>(__builtin_bit_cast(std::uint64_t, double{a.lanes[0]}));
}
[[nodiscard]] inline std::uint32_t secondBits(Double2 a) noexcept {
    return static_cast<std::uint32_t>(__builtin_bit_cast(std::uint64_t, double{a.lanes[1]}));
}

/// What holds in each lane; nothing does of a NaN.
struct Truth2 {
    bool first;
    bool second;
};

[[nodiscard]] inline Truth2 operator==(Double2 a, Double2 b) noexcept {
    return {a.lanes[0] == b.lanes[0], a.lanes[1] == b.lanes[1]};
}
[[nodiscard]] inline Truth2 operator>(Double2 a, Double2 b) noexcept {
    return {a.lanes[0] > b.lanes[0], a.lanes[1] > b.lanes[1]};
}
[[nodiscard]] inline Truth2 operator>=(Double2 a, Double2 b) noexcept {
    return {a.lanes[0] >= b.lanes[0], a.lanes[1] >= b.lanes[1]};
}
[[nodiscard]] inline Truth2 operator&(Truth2 a, Truth2 b) noexcept {
    return {a.first && b.first, a.second && b.second};
}
[[nodiscard]] inline Truth2 operator|(Truth2 a, Truth2 b) noexcept {
    return {a.first || b.first, a.second || b.second};
}
[[nodiscard]] inline bool inBoth(Truth2 a) noexcept { return a.first && a.second; }

[[nodiscard]] inline double first(Double2 a) noexcept { return a.lanes[0]; }
[[nodiscard]] inline double second(Double2 a) noexcept { return a.lanes[1]; }

#endif

/// The nearest whole numbers, also as integers.
struct Wholes2 {
    Double2 numbers;
    std::uint32_t first;
    std::uint32_t second;
};

/// Of numbers from 0 to 2^31.
[[nodiscard]] inline Wholes2 nearestWholes(Double2 a) noexcept {
    // Next to 2^52 numbers are whole, and their lowest bits count them.
    const Double2 shift = splat(0x1p52);
    const Double2 shifted = a + shift;
    return {shifted - shift, firstBits(shifted), secondBits(shifted)};
}

/// Two points.
struct Points2 {
    Double2 x;
    Double2 y;
    Double2 z;
};

/// From x0 y0 z0 x1 y1 z1.
[[nodiscard]] inline Points2 loadInterleaved(const double* from) noexcept {
    const Double2 xy = load(from);
    const Double2 zx = load(from + 2);
    const Double2 yz = load(from + 4);
    return {firstSecond(xy, zx), secondFirst(xy, yz), firstSecond(zx, yz)};
}

/// Two points as x0 y0 z0 x1 y1 z1.
inline void storeInterleaved(double* to, Double2 x, Double2 y, Double2 z) noexcept {
    store(to, firstFirst(x, y));
    store(to + 2, firstSecond(z, x));
    store(to + 4, secondSecond(y, z));
}

}  // namespace knotwork::simd
