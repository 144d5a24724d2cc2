// An array that nothing is written to before its owner does: a std::vector sets all its elements to
// zero first, and what is larger than the caches goes through memory once more for that.
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace knotwork {

template <class T>
class RawArray {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_default_constructible_v<T>);

public:
    RawArray() noexcept = default;
    /// The elements have no values yet.
    explicit RawArray(std::size_t size) : elements_(new T[size]), size_(size) {}

    [[nodiscard]] T* data() noexcept { return elements_.get(); }
    [[nodiscard]] const T* data() const noexcept { return elements_.get(); }
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] T* begin() noexcept { return data(); }
    [[nodiscard]] T* end() noexcept { return data() + size_; }
    [[nodiscard]] const T* begin() const noexcept { return data(); }
    [[nodiscard]] const T* end() const noexcept { return data() + size_; }
    [[nodiscard]] T& operator[](std::size_t i) noexcept { return elements_[i]; }
    [[nodiscard]] const T& operator[](std::size_t i) const noexcept { return elements_[i]; }

private:
    std::unique_ptr<T[]> elements_;
    std::size_t size_ = 0;
};

}  // namespace knotwork
