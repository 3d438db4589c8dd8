// The length of way that a contact has travelled, as a function of scene time.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace carom::sound {

/// What a way is at both ends of a piece; in between it is interpolated linearly.
struct WayEnds {
    std::array<double, 2> speeds{};     // m/s
    std::array<double, 2> pressures{};  // Pa, root mean square at 1 m
};

struct WayPoint {
    double way = 0;         // m, travelled since the way began; never falls with time
    std::size_t piece = 0;  // its index, if the way does not stand
    double part = 0;        // of the piece that is over, [0, 1]
    bool stands = true;
};

/// A way as a table of pieces, in each of which it is a cubic Hermite curve through ways and
/// speeds.
class Way {
  public:
    /// Adds a piece from `time` to `time` + `duration` (> 0), with the speeds (m/s, >= 0) at its
    /// beginning, in its middle and at its end, and the pressures at both ends. It begins at the
    /// end of the previous piece or later. Its length is that by Simpson's rule.
    void add(double time, double duration, const std::array<double, 3>& speeds,
             const std::array<double, 2>& pressures);

    /// Before its beginning, in gaps and after its end the way stands. Times near the previous one
    /// are found fast.
    [[nodiscard]] WayPoint at(double time);

    [[nodiscard]] std::size_t size() const { return pieces_.size(); }

    /// The ends of a piece, whose index is less than size().
    [[nodiscard]] WayEnds& ends(std::size_t piece) { return pieces_[piece].ends; }
    [[nodiscard]] const WayEnds& ends(std::size_t piece) const { return pieces_[piece].ends; }

    [[nodiscard]] double length() const { return length_; }

  private:
    struct Piece {
        double time = 0;
        double duration = 0;
        double way = 0;                 // m, at its beginning
        std::array<double, 3> curve{};  // way + s (c0 + s (c1 + s c2)) for s in [0, 1]
        WayEnds ends;
    };

    std::vector<Piece> pieces_;
    std::size_t last_ = 0;  // the piece found last
    double length_ = 0;
};

}  // namespace carom::sound
