// Borrowed arrays in plain data, for kernels.
#pragma once

#include <cstdint>

namespace carom::render {

/// Entries that lie side by side, elsewhere. Kept as the distance to them from here: a block of
/// memory with both in it may be moved, to another machine too. (A copy elsewhere is one of the
/// same entries.)
template <class T>
class List {
  public:
    List() = default;
    List(const T* data, std::int64_t count) : count_(count) { set(data); }
    /// Of a container that lives as long.
    template <class Container>
    explicit List(const Container& entries)
        : List(entries.data(), static_cast<std::int64_t>(entries.size())) {}
    List(const List& other) : List(other.data(), other.count_) {}
    List& operator=(const List& other) {
        set(other.data());
        count_ = other.count_;
        return *this;
    }
    ~List() = default;

    [[nodiscard]] bool exists() const { return count_ > 0; }
    [[nodiscard]] int count() const { return static_cast<int>(count_); }
    [[nodiscard]] std::int64_t size() const { return count_; }
    /// Must exist to be read.
    [[nodiscard]] const T* data() const {
        // Not as `this` plus a distance, which compilers would take for a place in this list
        // itself.
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast,performance-no-int-to-ptr)
        return reinterpret_cast<const T*>(place() + distance_);
    }
    [[nodiscard]] const T* begin() const { return data(); }
    [[nodiscard]] const T* end() const { return data() + count_; }
    [[nodiscard]] const T& operator[](std::int64_t i) const { return data()[i]; }

  private:
    [[nodiscard]] std::uint64_t place() const {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast)
        return reinterpret_cast<std::uint64_t>(this);
    }
    void set(const T* data) {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast)
        distance_ = reinterpret_cast<std::uint64_t>(data) - place();
    }

    std::uint64_t distance_ = 0;
    std::int64_t count_ = 0;
};

}  // namespace carom::render
