// Crossings and apexes are the same however a path is cut into pieces, and whether they are
// predicted or followed.
#include "sim/path_detectors.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/force_event.h"

namespace carom::sim {
namespace {

constexpr double kGravity = 9.81;

/// A ball thrown up at `rise` (m/s) that flies along x at 1 m/s, from `start` s on.
PathPiece thrown(double rise, double start, double length) {
    const double height = start * (rise - 0.5 * kGravity * start);
    return {length,
            {Vec3(start, 0, height), Vec3(1, 0, rise - kGravity * start),
             Vec3(0, 0, -0.5 * kGravity), Vec3(0, 0, 0)}};
}

template <class Detector>
std::vector<double> followed(Detector detector, double rise, const std::vector<double>& cuts) {
    std::vector<double> times;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        for (const double time :
             detector.follow(thrown(rise, cuts[i - 1], cuts[i] - cuts[i - 1]))) {
            times.push_back(cuts[i - 1] + time);
        }
    }
    return times;
}

/// As PathTriggers does it: predicts from each cut to the end, and notes what comes before the
/// next.
template <class Detector>
std::vector<double> predicted(Detector detector, double rise, const std::vector<double>& cuts) {
    std::vector<double> times;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        double from = cuts[i - 1];
        for (bool is_done = false; !is_done;) {
            const PathPiece piece = thrown(rise, from, cuts.back() - from);
            Detector ahead = detector;
            const std::vector<double> found = ahead.follow(piece);
            detector.begin(piece);
            is_done = found.empty() || from + found[0] > cuts[i];
            if (!is_done) {
                from += found[0];
                if (times.empty() || from > times.back() + 1e-9) {
                    times.push_back(from);
                    detector.note();
                } else {
                    is_done = true;
                }
            }
        }
    }
    return times;
}

TEST(PathDetectors_OnAPathCutAnywhere, FindTheSame) {
    const double rise = 2;
    const double apex = rise / kGravity;
    const LineDetector line({0.3, -1}, {0.3, 1});
    for (const std::vector<double>& cuts : std::vector<std::vector<double>>{
             {0, 0.4}, {0, 0.1, 0.4}, {0, apex, 0.3, 0.4}, {0, 0.3, 0.4}, {0, 0.29, 0.31, 0.4}}) {
        for (const auto& times : {followed(line, rise, cuts), predicted(line, rise, cuts)}) {
            ASSERT_EQ(times.size(), 1U);
            EXPECT_NEAR(times[0], 0.3, 1e-12);
        }
        for (const auto& times :
             {followed(ApexDetector(), rise, cuts), predicted(ApexDetector(), rise, cuts)}) {
            ASSERT_EQ(times.size(), 1U);
            EXPECT_NEAR(times[0], apex, 1e-12);
        }
    }
}

TEST(LineDetector_BesideTheSegment, RemembersTheSide) {
    LineDetector short_line({0.3, 1}, {0.3, 2});
    EXPECT_TRUE(short_line.follow(thrown(2, 0, 0.4)).empty());
    PathPiece back;
    back.length = 0.4;
    back.coefficients = {Vec3(0.4, 1.5, 0), Vec3(-1, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)};
    const std::vector<double> times = short_line.follow(back);
    ASSERT_EQ(times.size(), 1U) << "it is on the far side, though it did not cross the segment";
    EXPECT_NEAR(times[0], 0.1, 1e-12);
}

TEST(LineDetector_OfABodyThatIsPutOnTheOtherSide, FindsNoCrossing) {
    LineDetector line({0.3, -1}, {0.3, 1});
    EXPECT_TRUE(line.follow(thrown(2, 0, 0.2)).empty());
    EXPECT_TRUE(line.follow(thrown(2, 0.35, 0.05)).empty());
}

TEST(LineDetector_OfABodyThatStartsOnTheLine, FindsNoCrossing) {
    LineDetector line({0, -1}, {0, 1});
    EXPECT_TRUE(line.follow(thrown(2, 0, 0.4)).empty());
}

TEST(ApexDetector_OfALowHop, FindsNone) {
    const double rise = std::sqrt(2 * kGravity * kMinRise);
    EXPECT_TRUE(ApexDetector().follow(thrown(0.999 * rise, 0, 1)).empty());
    EXPECT_EQ(ApexDetector().follow(thrown(1.001 * rise, 0, 1)).size(), 1U);
}

TEST(RestDetector, CountsOnlyMotionsThatCanBeSeen) {
    RestDetector detector;
    EXPECT_FALSE(detector.rest());  // it has rested from the start
    detector.move(is_visible(1.9e-4, 0.009, 0.4));
    EXPECT_FALSE(detector.rest());
    for (const bool is_seen :
         {is_visible(2.1e-4, 0, 0), is_visible(0, 0.011, 0), is_visible(0, 0, 0.6)}) {
        detector.move(is_seen);
        detector.move(false);
        EXPECT_TRUE(detector.has_moved());
        EXPECT_TRUE(detector.rest());
        EXPECT_FALSE(detector.rest());
    }
}

}  // namespace
}  // namespace carom::sim
