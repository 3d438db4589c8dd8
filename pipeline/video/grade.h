// Grading: what a colourist does to the light of a film before the view.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

/// Whether the settings change nothing.
[[nodiscard]] bool is_neutral(const GradeSettings& settings);

/// The grade of linear Rec.709 light, prepared once and used for many pixels, from any thread.
///
/// ASC CDL (American Society of Cinematographers, "Color Decision List", version 1.2): of each
/// channel v, max(v slope + offset, 0)^power; then the saturation, around the luma of Rec.709. It
/// acts on the logarithm of light, in the encoding of ACEScct (AMPAS S-2016-001, section 4.4), so
/// that an offset of 1/17.52 is a stop and nothing above white is cut off, whatever the view.
///
/// The white balance comes first: it turns the light of a black body (Kim et al. 2002, US patent
/// 7024034, for its chromaticity) into the white of Rec.709 with the same luminance, by the
/// adaptation of Bradford (Lam 1985; ICC.1:2022, annex E).
class Grade {
  public:
    using Colour = std::array<float, 3>;

    explicit Grade(const GradeSettings& settings);

    /// Channels below 0 and NaN count as 0, those above 65504, where the encoding ends, as that.
    [[nodiscard]] Colour operator()(const Colour& light) const;

  private:
    /// A curve over the octaves of light that count, interpolated between 64 places of each.
    class LogarithmicTable {
      public:
        LogarithmicTable() = default;
        template <class Curve>
        explicit LogarithmicTable(const Curve& curve);
        [[nodiscard]] float operator()(float light) const;

      private:
        std::vector<float> table_;
    };

    using Matrix = std::array<Colour, 3>;  // rows
    static Matrix balance_for(double temperature);

    std::optional<Matrix> balance_;
    std::array<LogarithmicTable, 3> graded_;  // the encoded channel, by its light
    std::vector<float> light_;                // of encoded channels
    float saturation_;
};

}  // namespace carom::pipeline
