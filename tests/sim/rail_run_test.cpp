// Balls that run along the rail into a corner pocket.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "pocket_shots.h"

namespace carom::sim::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// Players report that a ball along the rail drops at any speed or at none. With jaws as lively as
// the cushions, three times as many slow balls drop as fast ones.
TEST(PoolCorner_BallAlongTheRail, DropsAtAnySpeed) {
    const PocketTable& table = pocket_tables()[0];
    const double usual = table.layout().measures.jaw_restitution;
    std::vector<double> openings;
    for (const double speed : {1.0, 3.0, 5.0}) {
        openings.push_back(rail_opening(table, speed, 0, usual));
    }
    const auto [least, most] = std::minmax_element(openings.begin(), openings.end());
    EXPECT_GT(*least, 0.03);
    EXPECT_LT(*most, 1.1 * *least);
    EXPECT_LT(rail_opening(table, 3, 0, 1), 0.5 * openings[1]);
}

/// Appends the openings along the rail to the file that `CAROM_POCKET_TABLE` names, as a table for
/// docs/tables.md.
TEST(RailTable_WhenRequested, IsAppended) {
    const char* path = std::getenv("CAROM_POCKET_TABLE");
    if (path == nullptr) {
        GTEST_SKIP() << "CAROM_POCKET_TABLE is not set";
    }
    std::ofstream out(path, std::ios::app);
    out << "\n| corner pocket | jaws | angle | 1 m/s | 2 m/s | 3 m/s | 5 m/s "
           "|\n|---|---|---|---|---|---|---|\n";
    for (const auto& [number, name] : {std::pair{0, "pool"}, std::pair{3, "snooker"}}) {
        for (const double jaws : {0.7, 1.0}) {
            for (const double angle : {0.0, 3.0}) {
                out << "| " << name << " | " << jaws << " | " << angle << "° |";
                for (const double speed : {1.0, 2.0, 3.0, 5.0}) {
                    const double opening =
                        rail_opening(pocket_tables()[static_cast<std::size_t>(number)], speed,
                                     angle * kDegree, jaws);
                    std::array<char, 20> cell{};
                    std::snprintf(cell.data(), cell.size(), " %.0f |", opening * 1e3);
                    out << cell.data();
                }
                out << "\n";
            }
        }
    }
}

}  // namespace
}  // namespace carom::sim::test
