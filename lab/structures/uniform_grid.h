// A uniform grid.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lab/structures/boxes.h"
#include "lab/structures/mailbox.h"
#include "lab/structures/structure_options.h"

namespace carom::render {

/// A ray visits cell after cell (Fujimoto, Tanaka and Iwata 1986, "ARTS: accelerated ray-tracing
/// system"; Amanatides and Woo 1987). There are about four cells per shape if no other number is
/// asked for. A shape is in every cell that its box overlaps and is tested once, as far as the
/// mailbox remembers.
class UniformGrid {
  public:
    UniformGrid(const Primitives& primitives, const StructureSizes& sizes);

    template <class Query>
    void search(Query& query) const;

    [[nodiscard]] std::size_t bytes() const { return bytes_of(first_) + bytes_of(shapes_); }

  private:
    [[nodiscard]] std::size_t cell_at(const std::array<int, 3>& at) const {
        return (static_cast<std::size_t>(at[2]) * static_cast<std::size_t>(count_[1]) +
                static_cast<std::size_t>(at[1])) *
                   static_cast<std::size_t>(count_[0]) +
               static_cast<std::size_t>(at[0]);
    }
    [[nodiscard]] int index_of(int axis, double place) const {
        const auto k = static_cast<std::size_t>(axis);
        const double cells = (place - static_cast<double>(bounds_.min[axis])) / edge_[k];
        return std::clamp(static_cast<int>(cells), 0, count_[k] - 1);
    }

    Imath::Box3f bounds_;
    std::array<int, 3> count_{};
    std::array<double, 3> edge_{};      // of a cell, m
    std::vector<std::uint32_t> first_;  // by cell, with the total number at the end
    std::vector<std::uint32_t> shapes_;
};

template <class Query>
void UniformGrid::search(Query& query) const {
    float enter = 0;
    if (shapes_.empty() || !query.enters(bounds_, enter)) {
        return;
    }
    const Ray& ray = query.ray();
    std::array<int, 3> at{};
    std::array<double, 3> next{};  // distance at which the ray leaves the cell along each axis
    const auto leaves = [&](int axis) {
        const auto k = static_cast<std::size_t>(axis);
        const auto d = static_cast<double>(ray.direction[axis]);
        const double plane = static_cast<double>(bounds_.min[axis]) + edge_[k] * (at[k] + (d > 0));
        return d != 0 ? (plane - static_cast<double>(ray.origin[axis])) / d
                      : static_cast<double>(kInfinity);
    };
    for (int axis = 0; axis < 3; ++axis) {
        at[static_cast<std::size_t>(axis)] = index_of(
            axis, static_cast<double>(ray.origin[axis]) +
                      static_cast<double>(enter) * static_cast<double>(ray.direction[axis]));
        next[static_cast<std::size_t>(axis)] = leaves(axis);
    }
    Mailbox mailbox;
    for (;;) {
        query.note_node();
        query.note_boxes(1);
        const std::size_t cell = cell_at(at);
        for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
            if (!mailbox.knows(shapes_[i]) && query.test(shapes_[i])) {
                return;
            }
        }
        const std::size_t axis =
            next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
        const int step = ray.direction[static_cast<int>(axis)] > 0 ? 1 : -1;
        at[axis] += step;
        if (query.is_beyond(next[axis]) || at[axis] < 0 || at[axis] >= count_[axis]) {
            return;
        }
        next[axis] = leaves(static_cast<int>(axis));
    }
}

}  // namespace carom::render
