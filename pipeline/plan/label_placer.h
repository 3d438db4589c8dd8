// Finds room for labels, so that they do not lie on each other.
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

    /// Something that should stay visible; a weight of 1 is as bad to cover as a label.
    void keep_free(const PaperBox& box, double weight = 1);

    /// The corner (smallest x and y) for a label of `size` that belongs to `place`, at least `gap`
    /// away from it: where it covers least, and near. It is kept free from then on.
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
