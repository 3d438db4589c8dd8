// Places labels so that they do not overlap.
#pragma once

#include <vector>

#include "core/vectors.h"

namespace carom::pipeline {

/// Millimetres on paper, y downwards.
struct PaperBox {
    Vec2 low{0, 0}, high{0, 0};
};

class LabelPlacer {
  public:
    /// Labels stay within `paper` if they can.
    explicit LabelPlacer(const PaperBox& paper) : paper_(paper) {}

    /// Adds a box that labels should not cover. A weight of 1 counts as much as a label.
    void keep_free(const PaperBox& box, double weight = 1);

    /// Returns the corner (smallest x and y) for a label of `size` near `place`, at least `gap`
    /// away from it, where it covers as little as possible. Later labels keep away from it.
    Vec2 place(const Vec2& place, const Vec2& size, double gap);

  private:
    struct Taken {
        PaperBox box;
        double weight = 1;
    };

    [[nodiscard]] double cost(const PaperBox& box) const;

    PaperBox paper_;
    std::vector<Taken> taken_;
};

}  // namespace carom::pipeline
