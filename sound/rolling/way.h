// The length of way that a contact has travelled, as a function of scene time.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace carom::sound {

struct WayPoint {
    double way = 0;       // m, travelled since the way began; never falls with time
    double speed = 0;     // m/s
    double strength = 0;  // of the read-out at this speed, as given when the way was made
};

/// A way as a table of pieces, in each of which it is a cubic Hermite curve through ways and
/// speeds.
class Way {
  public:
    /// Adds a piece from `time` to `time` + `duration` (> 0), with the speeds (m/s, >= 0) at its
    /// beginning, in its middle and at its end, and the strengths at both ends. It begins at the
    /// end of the previous piece or later. Its length is that by Simpson's rule.
    void add(double time, double duration, const std::array<double, 3>& speeds,
             const std::array<double, 2>& strengths);

    /// Before its beginning, in gaps and after its end the way stands, and the strength is 0. Times
    /// near the previous one are found fast.
    [[nodiscard]] WayPoint at(double time);

    [[nodiscard]] double length() const { return length_; }

  private:
    struct Piece {
        double time = 0;
        double duration = 0;
        double way = 0;                  // m, at its beginning
        std::array<double, 3> curve{};   // way + s (c0 + s (c1 + s c2)) for s in [0, 1]
        std::array<double, 2> speeds{};  // at both ends
        std::array<double, 2> strengths{};
    };

    std::vector<Piece> pieces_;
    std::size_t last_ = 0;  // the piece found last
    double length_ = 0;
};

}  // namespace carom::sound
