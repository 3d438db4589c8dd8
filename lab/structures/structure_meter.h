// What the structures of frames cost.
#pragma once

#include <cstddef>

#include "lab/structures/make_structure.h"
#include "lab/structures/test_counts.h"

namespace carom::render {

/// Makes structures of one kind and keeps the cost of the last one. Frames are made one at a time,
/// and the counts of a structure end when the next one is made.
class StructureMeter {
  public:
    explicit StructureMeter(AccelerationKind kind) : kind_(kind) {}
    StructureMeter(const StructureMeter&) = delete;
    StructureMeter& operator=(const StructureMeter&) = delete;

    /// For the structures from now on. `counts`: whether tests are counted; replaces that of the
    /// options.
    void set(bool counts, StructureOptions options = {}) {
        options_ = std::move(options);
        options_.counts = counts ? &counts_ : nullptr;
    }

    /// Refers to this object.
    [[nodiscard]] StructureMaker maker() {
        return [this](const ShapeSet& shapes, std::span<const MeshEntry> meshes) {
            (void)counts_.take();
            MadeStructure made = make_structure(kind_, shapes, meshes, options_);
            build_seconds_ = made.build_seconds;
            bytes_ = made.bytes;
            return std::move(made.structure);
        };
    }

    [[nodiscard]] AccelerationKind kind() const { return kind_; }
    /// CPU time.
    [[nodiscard]] double build_seconds() const { return build_seconds_; }
    /// Without the shapes themselves.
    [[nodiscard]] std::size_t bytes() const { return bytes_; }
    /// Tests since the last call; all 0 unless they are counted.
    [[nodiscard]] TestCounts take_counts() { return counts_.take(); }

  private:
    AccelerationKind kind_;
    StructureOptions options_;
    SharedCounts counts_;
    double build_seconds_ = 0;
    std::size_t bytes_ = 0;
};

}  // namespace carom::render
