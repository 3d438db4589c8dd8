#include "sim/billiards/rack.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/core.h>

#include "core/elementary.h"
#include "core/splitmix.h"
#include "sim/billiards/ball_names.h"
#include "sim/billiards/spots.h"

namespace carom::sim::billiards {

namespace {

// Keeps touching balls from overlapping by rounding; far less than the diameter of an atom.
constexpr double kRounding = 1e-13;

/// A random number in [0, 1) as a function of (seed, index): the output function of SplitMix64,
/// applied twice.
double random_number(std::uint64_t seed, std::uint64_t index) {
    return unit_number(split_mix(split_mix(seed + kSplitMixStep) + (index + 1) * kSplitMixStep));
}

/// Positions of a triangular lattice with the pitch of a ball diameter plus the mean gap. Each ball
/// except the first is displaced by up to half the mean gap in a random direction, so that the gap
/// between two neighbours is between zero and twice the mean.
class Lattice {
  public:
    Lattice(const Vec3& apex, double ball_radius, const RackOptions& options)
        : apex_(apex),
          pitch_(2 * ball_radius + options.gap + kRounding),
          gap_(options.gap),
          seed_(options.seed) {}

    /// Row 0 is the apex, and rows run towards the foot cushion; seen in that direction, `column`
    /// counts from the right.
    Vec3 place(int row, int column, int row_length) {
        const double across = pitch_ * (column - 0.5 * (row_length - 1));
        const double along = pitch_ * row * (std::numbers::sqrt3 / 2);
        const std::uint64_t index = count_++;
        if (index == 0) {
            return apex_;
        }
        // Uniform over the disk.
        const double radius = 0.5 * gap_ * std::sqrt(random_number(seed_, 2 * index));
        const double angle = 2 * std::numbers::pi * random_number(seed_, 2 * index + 1);
        const SinCos at = sin_cos(angle);
        return apex_ + Vec3(along + radius * at.cos, across + radius * at.sin, 0);
    }

  private:
    Vec3 apex_;
    double pitch_;
    double gap_;
    std::uint64_t seed_;
    std::uint64_t count_ = 0;
};

// Row by row from the apex, each from the right, seen towards the foot cushion. The 1 is at the
// apex, the 9 in the middle, the 2 at the rear (as in the WPA's rules for televised nine-ball).
constexpr std::array<int, 5> kDiamondRows{1, 2, 3, 2, 1};
constexpr std::array<int, 9> kNineBall{1, 3, 4, 5, 9, 6, 7, 8, 2};

constexpr std::array<int, 5> kTriangleRows{1, 2, 3, 4, 5};
// WPA, The Rules of Play, "Ten Ball": 1 at the apex, 10 in the middle, 2 and 3 at the back corners.
constexpr std::array<int, 10> kTenBall{1, 4, 5, 6, 10, 7, 2, 8, 9, 3};
// WPA, "Eight Ball": 8 in the middle of the third row, a solid and a stripe at the back corners.
constexpr std::array<int, 15> kEightBall{1, 9, 2, 3, 8, 10, 11, 4, 12, 5, 6, 13, 7, 14, 15};
// BCA, "Rotation": 1 at the apex, 2 and 3 at the back corners, 15 in the middle.
constexpr std::array<int, 15> kFifteenBall{1, 4, 5, 6, 15, 7, 8, 9, 10, 11, 2, 12, 13, 14, 3};

std::vector<PlacedBall> numbered(std::span<const int> rows, std::span<const int> numbers,
                                 Lattice lattice) {
    std::vector<PlacedBall> balls;
    for (int row = 0; balls.size() < numbers.size(); ++row) {
        const int length = rows[static_cast<std::size_t>(row)];
        for (int column = 0; column < length; ++column) {
            const int number = numbers[balls.size()];
            balls.push_back({kPoolBalls[static_cast<std::size_t>(number)], number,
                             lattice.place(row, column, length)});
        }
    }
    return balls;
}

// WPBSA, Official Rules of Snooker, section 3, rule 2: the colours on their spots, the reds behind
// the pink.
std::vector<PlacedBall> snooker(const TableMeasures& table, double ball_radius,
                                const RackOptions& options) {
    const double pyramid = 0.25 * table.length;
    const double z = ball_radius;
    std::vector<PlacedBall> balls;
    // As close behind the pink as possible without touching it.
    const double behind_pink = 2 * ball_radius + options.gap + kRounding;
    Lattice lattice({pyramid + behind_pink, 0, z}, ball_radius, options);
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column <= row; ++column) {
            balls.push_back(
                {fmt::format("red_{}", balls.size() + 1), 0, lattice.place(row, column, row + 1)});
        }
    }
    for (const Spot& spot : snooker_spots(table)) {
        balls.push_back({spot.name, 0, {spot.place.x, spot.place.y, z}});
    }
    return balls;
}

// UMB, World Rules of Carom Billiard (1989), articles 13 and 23: red on the foot spot, the other
// ball on the head spot, the player's 18.25 cm to the side of that on a match table.
std::vector<PlacedBall> carom_balls(const TableMeasures& table, double ball_radius) {
    const double quarter = 0.25 * table.length;
    const double aside = 0.1825 * table.length / 2.84;
    return {{"white", 0, {-quarter, -aside, ball_radius}},
            {"yellow", 0, {-quarter, 0, ball_radius}},
            {"red", 0, {quarter, 0, ball_radius}}};
}

}  // namespace

std::vector<PlacedBall> rack(RackKind kind, const TableMeasures& table, double ball_radius,
                             const RackOptions& options) {
    const Lattice lattice({0.25 * table.length, 0, ball_radius}, ball_radius, options);
    switch (kind) {
        case RackKind::nine_ball:
            return numbered(kDiamondRows, kNineBall, lattice);
        case RackKind::eight_ball:
            return numbered(kTriangleRows, kEightBall, lattice);
        case RackKind::ten_ball:
            return numbered(kTriangleRows, kTenBall, lattice);
        case RackKind::fifteen_ball:
            return numbered(kTriangleRows, kFifteenBall, lattice);
        case RackKind::snooker:
            return snooker(table, ball_radius, options);
        case RackKind::carom:
            return carom_balls(table, ball_radius);
    }
    return {};
}

}  // namespace carom::sim::billiards
