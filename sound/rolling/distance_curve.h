// How far two surfaces in contact have moved past each other, as a function of scene time, and how
// loud that is.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sim/timeline/track.h"

namespace carom::sound {

/// Both ends of a piece of a curve; in between, speed and pressure are interpolated linearly.
struct PieceEnds {
    std::array<double, 2> speeds{};     // m/s
    std::array<double, 2> pressures{};  // Pa, root mean square at 1 m
};

struct CurvePoint {
    double distance = 0;     // m, since the beginning of the curve; never falls with time
    std::size_t piece = 0;   // its index, unless the curve is at rest
    double part = 0;         // of the piece's duration that is over, [0, 1]
    bool is_at_rest = true;  // nothing moves at this time
};

/// The distance travelled as a table of pieces, in each of which it is a cubic Hermite curve
/// through distances and speeds.
class DistanceCurve {
  public:
    /// Adds a piece from `time` to `time` + `duration` (> 0), with the speeds (m/s, >= 0) at its
    /// beginning, in its middle and at its end, and the pressures at both ends. It begins at the
    /// end of the previous piece or later. Its length is that by Simpson's rule.
    void add(double time, double duration, const std::array<double, 3>& speeds,
             const std::array<double, 2>& pressures);

    /// Before its beginning, in gaps and after its end the curve is at rest. Times near the
    /// previous one are found fast.
    [[nodiscard]] CurvePoint at(double time);

    /// The number of pieces.
    [[nodiscard]] std::size_t size() const { return pieces_.size(); }

    /// The ends of a piece, whose index is less than size().
    [[nodiscard]] PieceEnds& ends(std::size_t piece) { return pieces_[piece].ends; }

    /// The whole distance, m.
    [[nodiscard]] double length() const { return length_; }

  private:
    struct Piece {
        double time = 0;
        double duration = 0;
        double distance = 0;            // m, at its beginning
        std::array<double, 3> curve{};  // distance + s (c0 + s (c1 + s c2)) for s in [0, 1]
        PieceEnds ends;
    };

    std::vector<Piece> pieces_;
    std::size_t last_ = 0;  // the piece found last
    double length_ = 0;
};

/// The root mean square of the pressure at 1 m (Pa) of a ball that rolls on cloth at `speed` (m/s):
/// 40 dB + 9 dB log2(speed) (tuned: no measured level was found). Silent up to 20 mm/s; it reaches
/// the law at 40 mm/s.
[[nodiscard]] double rolling_pressure(double speed);

/// The same for a ball that slides at a slip speed: 3 dB more (tuned).
[[nodiscard]] double sliding_pressure(double slip);

/// The same for bodies that scrape at a slip speed (m/s) with a normal force (N):
/// 45 dB (tuned) times (slip / 0.1 m/s)^(3/4) sqrt(force / 1 N).
///
/// The exponent of the speed is that of "Influence of sliding speed on roughness noise" (2019), an
/// experiment and a simulation. The acoustic power is taken to be proportional to the force, as it
/// is to the area of contact in one of the two regimes of Le Bot, Bou Chakra and Michon (2011),
/// "Dissipation of vibration in rough contact", Tribology Letters 41. Silent up to 2 mm/s; it
/// reaches the law at 4 mm/s.
[[nodiscard]] double scraping_pressure(double slip, double force);

/// The two distances that a ball travels on cloth.
struct BallCurves {
    DistanceCurve rolled;  // by the speed of the centre, |v|
    DistanceCurve slid;    // by the slip speed, |v + w x r|, r from the centre to the lowest point
};

/// A contact of a ball with another thing.
struct ContactTime {
    double time = 0;      // scene time, s, at which it begins
    double duration = 0;  // s, > 0
};

/// The distances that a ball travels between two scene times (from < to) of its track. Vertical
/// motion does not count. In the track an impact changes the ball's velocity at once; here its
/// speeds change, by the smooth step, over the contact with which the impact is among `contacts`
/// (in order of time), or over 1 ms if it is not. The pieces end at all keys, and are at most 10 ms
/// long and a quarter of a contact during it (more in intervals of over ten minutes, so that there
/// are never more than 65536, one for each key and five for each contact).
[[nodiscard]] BallCurves ball_curves(const sim::Track& track, double radius, double from, double to,
                                     std::span<const ContactTime> contacts);

/// Multiplies the pressures by the gain of the dynamics with this ratio (decibels.h), for what both
/// curves make together. Pieces of the same index are at the same time, unless a curve has none.
void apply_dynamics(double ratio, BallCurves& curves);

/// A contact of nearly constant force and slip.
struct Scrape {
    double from = 0;   // scene time, s
    double to = 0;     // s, > `from`
    double force = 0;  // N, mean normal force
    double slip = 0;   // m/s, mean slip speed
};

/// The distance slipped in scrapes that follow each other without gaps. In the middle of each
/// scrape, slip and force are its own, before the first and after the last middle they are
/// constant, and in between linear: no step is heard where the record of one contact is divided.
[[nodiscard]] DistanceCurve scraping_curve(std::span<const Scrape> scrapes);

}  // namespace carom::sound
