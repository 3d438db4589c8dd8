#include "sim/scheduler/near_pairs.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "core/length.h"
#include "shots.h"
#include "sim/numeric/tolerances.h"

namespace carom::sim::test {
namespace {

using Pairs = std::vector<NearPairs::Pair>;

/// Boxes of 20 mm to 0.2 m in a cube of 1 m, at random places.
class Cloud {
  public:
    explicit Cloud(int count) {
        for (int i = 0; i < count; ++i) {
            Body box;
            box.name = "box" + std::to_string(i);
            const double size = between(0.02, i % 10 == 0 ? 0.2 : 0.04);
            box.shape = Box{{size, size, size}};
            box.pose.position = {between(0, 1), between(0, 1), between(1, 2)};
            world_.bodies.push_back(box);
        }
        bodies = make_moving_bodies(world_, StaticEnvironment(world_));
        for (const MovingBody& body : bodies) {
            placed.push_back({body.state, body.mode});
        }
    }

    double between(double low, double high) {
        return std::uniform_real_distribution(low, high)(random_);
    }

    /// Some jump, fall asleep, wake or leave, and all get other velocities.
    void disturb() {
        constexpr Mode kModes[] = {Mode::solver, Mode::asleep, Mode::closed_form};
        for (Placement& body : placed) {
            body.state.velocity = {between(-0.5, 0.5), between(-0.5, 0.5), between(-0.5, 0.5)};
            if (between(0, 1) < 0.02) {
                body.state.position.x += between(-0.3, 0.3);
            }
            if (between(0, 1) < 0.3) {
                body.mode = kModes[static_cast<int>(between(0, 3))];
            }
        }
    }

    [[nodiscard]] bool collide(std::uint32_t i, std::uint32_t k) const {
        const auto sleeps = [](const Placement& p) { return p.mode == Mode::asleep; };
        const Placement& a = placed[i];
        const Placement& b = placed[k];
        return (a.is_in_solver() && (b.is_in_solver() || sleeps(b))) ||
               (sleeps(a) && b.is_in_solver());
    }
    /// Every pair that the list has to contain.
    [[nodiscard]] Pairs touching() const {
        Pairs pairs;
        for (std::uint32_t i = 0; i < placed.size(); ++i) {
            for (std::uint32_t k = i + 1; k < placed.size(); ++k) {
                const Vec3 apart = placed[i].state.position - placed[k].state.position;
                if (collide(i, k) && length(apart) <= bodies[i].bounding_radius() +
                                                          bodies[k].bounding_radius() +
                                                          kSolidMargin) {
                    pairs.emplace_back(i, k);
                }
            }
        }
        return pairs;
    }

  private:
    std::mt19937 random_{7};
    WorldDescription world_ = cloth_world(1);

  public:
    std::vector<MovingBody> bodies;
    std::vector<Placement> placed;
};

TEST(NearPairs, OfMovingBodies_ContainAllThatTouchInOrder) {
    Cloud cloud(300);
    cloud.disturb();
    NearPairs near(kSolidMargin);
    std::size_t most = 0;
    for (int step = 0; step < 400; ++step) {
        const Pairs found = near.find(cloud.bodies, cloud.placed);
        const Pairs touching = cloud.touching();
        ASSERT_TRUE(std::ranges::is_sorted(found));
        ASSERT_EQ(std::ranges::adjacent_find(found), found.end());
        ASSERT_TRUE(std::ranges::includes(found, touching)) << step;
        for (const auto& [i, k] : found) {
            ASSERT_TRUE(cloud.collide(i, k)) << step;
        }
        most = std::max(most, touching.size());
        for (Placement& placed : cloud.placed) {
            if (placed.is_in_solver()) {
                placed.state.position += placed.state.velocity / 960;
            }
        }
        if (step % 40 == 39) {
            cloud.disturb();
        }
    }
    EXPECT_GT(most, 50U);
}

TEST(NearPairs, OfManySleepingBodiesAndOneThatMoves_AreFew) {
    Cloud cloud(2000);
    for (Placement& placed : cloud.placed) {
        placed.mode = Mode::asleep;
    }
    NearPairs near(kSolidMargin);
    EXPECT_TRUE(near.find(cloud.bodies, cloud.placed).empty());
    cloud.placed[7].mode = Mode::solver;
    const Pairs found = near.find(cloud.bodies, cloud.placed);
    EXPECT_GT(found.size(), 0U);
    EXPECT_LT(found.size(), 40U);
    for (const auto& [i, k] : found) {
        EXPECT_TRUE(i == 7 || k == 7);
    }
}

/// A body in closed form is not one of them.
TEST(NearPairs, AfterABodyHasLeft_HaveItNoLonger) {
    Cloud cloud(2);
    cloud.placed[1].state.position = cloud.placed[0].state.position;
    NearPairs near(kSolidMargin);
    EXPECT_EQ(near.find(cloud.bodies, cloud.placed), Pairs({{0, 1}}));
    cloud.placed[1].mode = Mode::closed_form;
    EXPECT_TRUE(near.find(cloud.bodies, cloud.placed).empty());
}

}  // namespace
}  // namespace carom::sim::test
