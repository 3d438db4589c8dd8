// The light of camera samples, kept apart by the branches of their paths.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/integrator/path_state.h"

namespace carom::render {

/// The branches of a sample are added up in their own order, coats before the base, in whatever
/// order a wave reaches them: the result depends neither on the sorting of a wave nor on what else
/// is in it. Rows of numbers, one for each branch, by sample.
class BranchSums {
  public:
    /// For so many samples. `coats`: the most directions of one coat, [1, 16].
    BranchSums(int samples, int coats)
        : samples_(static_cast<std::size_t>(samples)),
          second_(coats + 1),
          sums_(static_cast<std::size_t>(rows()) * 3 * samples_) {
        for (int k = 0; k < coats; ++k) {
            set(2 + kBranchesOfOneCoat * static_cast<std::uint32_t>(k), k);
        }
        set(3, coats);
    }

    /// Forgets everything.
    void clear() { std::fill(sums_.begin(), sums_.end(), 0.0F); }

    /// Adds the radiance that a path finds at its `vertex`, after so many `scatterings`.
    void add(int sample, int vertex, std::uint32_t branch, const V3f& radiance, int scatterings) {
        const int row = vertex == 0   ? 0
                        : vertex == 1 ? 1 + first_[branch]
                                      : 1 + second_ + last_[branch];
        const int of_light = scatterings <= 1 ? row : indirect() + row;
        for (int channel = 0; channel < 3; ++channel) {
            sums_[place(of_light, channel, sample)] += radiance[channel];
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
            // Different numbers: the compiler makes vector code of the loop.
            float* __restrict sum = &sums_[place(first, 0, 0)];
            const float* __restrict more = &sums_[place(row, 0, 0)];
            for (std::size_t i = 0; i < 3 * samples_; ++i) {
                sum[i] += more[i];
            }
        }
    }
    [[nodiscard]] V3f at(int row, int sample) const {
        return {sums_[place(row, 0, sample)], sums_[place(row, 1, sample)],
                sums_[place(row, 2, sample)]};
    }

    [[nodiscard]] std::size_t place(int row, int channel, int sample) const {
        return static_cast<std::size_t>(3 * row + channel) * samples_ +
               static_cast<std::size_t>(sample);
    }

    std::size_t samples_;
    int second_;  // branches of a second vertex
    std::array<std::uint8_t, 256> first_{}, last_{};
    std::vector<float> sums_;  // by row, channel and sample
};

}  // namespace carom::render
