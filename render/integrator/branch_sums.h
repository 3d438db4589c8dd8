// The light of camera samples, kept apart by the branches of their paths.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/integrator/path_state.h"
#include "render/integrator/wave/queue_memory.h"

namespace carom::render {

/// The branches of a sample are added up in their own order, coats before the base, in whatever
/// order a wave reaches them: the result depends neither on the sorting of a wave nor on what else
/// is in it. Rows of numbers, one for each branch, by sample.
class BranchSums {
  public:
    /// `coats`: the most directions of one coat, [1, 16].
    explicit BranchSums(int coats) : second_(coats + 1), rows_(static_cast<std::size_t>(rows())) {
        for (int k = 0; k < coats; ++k) {
            set(2 + kBranchesOfOneCoat * static_cast<std::uint32_t>(k), k);
        }
        set(3, coats);
    }

    /// Forgets everything.
    void clear() {
        for (Row& row : rows_) {
            row = {};
        }
    }

    /// Adds the radiance that a path finds at its `vertex`, after so many `scatterings`.
    void add(int sample, int vertex, std::uint32_t branch, const V3f& radiance, int scatterings) {
        const int row = vertex == 0   ? 0
                        : vertex == 1 ? 1 + first_[branch]
                                      : 1 + second_ + last_[branch];
        Row& sum = rows_[static_cast<std::size_t>(scatterings <= 1 ? row : indirect() + row)];
        for (int channel = 0; channel < 3; ++channel) {
            sum[static_cast<std::size_t>(channel)][sample] += radiance[channel];
        }
    }

    /// Adds the rows up; `direct_of` and `indirect_of` return the sums from then on.
    void finish() {
        add_up(0, indirect());
        add_up(indirect(), rows());
    }
    /// Light seen directly, or scattered once.
    [[nodiscard]] V3f direct_of(int sample) const { return at(0, sample); }
    [[nodiscard]] V3f indirect_of(int sample) const { return at(indirect(), sample); }

  private:
    using Row = std::array<float[kWaveSamples], 3>;

    /// Rows of direct light: the first vertex, and the branches of the second.
    [[nodiscard]] int indirect() const { return 1 + second_; }
    /// Those of indirect light are followed by the branches that the second vertex makes.
    [[nodiscard]] int rows() const { return indirect() + 1 + second_ + 2 * second_; }

    /// `place`: of a branch of the second vertex.
    void set(std::uint32_t branch, int place) {
        first_[branch] = static_cast<std::uint8_t>(place);
        const std::size_t twice = std::size_t{2} * branch;
        last_[twice] = static_cast<std::uint8_t>(2 * place);
        last_[twice + 1] = static_cast<std::uint8_t>(2 * place + 1);
        last_[branch] = static_cast<std::uint8_t>(2 * place + 1);  // was not split
    }
    void add_up(int first, int last) {
        for (int row = first + 1; row < last; ++row) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                // Different arrays: the compiler makes vector code of the loop.
                float* __restrict sum = rows_[static_cast<std::size_t>(first)][channel];
                const float* __restrict more = rows_[static_cast<std::size_t>(row)][channel];
                for (int i = 0; i < kWaveSamples; ++i) {
                    sum[i] += more[i];
                }
            }
        }
    }
    [[nodiscard]] V3f at(int row, int sample) const {
        const Row& sums = rows_[static_cast<std::size_t>(row)];
        return {sums[0][sample], sums[1][sample], sums[2][sample]};
    }

    int second_;  // branches of a second vertex
    std::array<std::uint8_t, 256> first_{}, last_{};
    std::vector<Row> rows_;
};

}  // namespace carom::render
