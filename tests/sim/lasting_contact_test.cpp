// Lasting contacts in the timelines of simulations, against closed forms.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "shots.h"

namespace carom::sim::test {
namespace {

Body box(const std::string& name, const Vec3& size, const Vec3& position) {
    Body body;
    body.name = name;
    body.shape = Box{size};
    body.mass = 700 * size.x * size.y * size.z;
    body.material = "wood";
    body.pose.position = position;
    return body;
}

std::vector<LastingContact> contacts_of(const Timeline& timeline, const std::string& a,
                                        const std::string& b) {
    std::vector<LastingContact> found;
    std::copy_if(timeline.lasting_contacts.begin(), timeline.lasting_contacts.end(),
                 std::back_inserter(found),
                 [&](const LastingContact& c) { return c.a == a && c.b == b; });
    return found;
}

/// The box slides with the friction 0.4 from 2 m/s: its slip is 2 m/s - 0.4 g t, until it stops.
void expect_sliding(const std::vector<LastingContact>& contacts, double weight) {
    const double deceleration = 0.4 * kGravity;
    const double stop = 2 / deceleration;
    ASSERT_GT(contacts.size(), 5U);
    double impulse = 0;
    double path = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const LastingContact& contact = contacts[i];
        EXPECT_NEAR(contact.from, i == 0 ? 0 : contacts[i - 1].to, 1e-12);
        EXPECT_NEAR(contact.normal_force, weight, 0.001 * weight) << contact.from;
        const double middle = 0.5 * (contact.from + contact.to);
        EXPECT_NEAR(contact.slip, 2 - deceleration * middle, 5e-4) << contact.from;
        impulse += contact.normal_force * (contact.to - contact.from);
        path += contact.slip * (contact.to - contact.from);
    }
    EXPECT_NEAR(contacts.back().to, stop, 3e-3);
    EXPECT_NEAR(impulse, weight * stop, 0.01 * weight * stop);
    EXPECT_NEAR(path, 2 * 2 / (2 * deceleration), 1e-4);
}

TEST(LastingContact_OfASlidingBox, HasItsWeightAndItsFallingSlip) {
    WorldDescription world;
    world.duration = 3;
    world.floor_height = 0;
    world.contact_law.otherwise = {0.3, 0.4, 0};
    Body slider = box("slider", {0.2, 0.2, 0.02}, {0, 0, 0.01});
    slider.velocity = {2, 0, 0};
    world.bodies = {slider};
    const Timeline timeline = bake(world);
    expect_sliding(contacts_of(timeline, "slider", "floor"), slider.mass * kGravity);
    EXPECT_EQ(contacts_of(timeline, "slider", "floor").size(), timeline.lasting_contacts.size());
}

TEST(LastingContact_OfTwoBoxes, IsThatOfTheOneThatSlidesOnTheOther) {
    WorldDescription world;
    world.duration = 3;
    world.floor_height = 0;
    world.contact_law.otherwise = {0.3, 0.4, 0};
    Body below = box("below", {2.5, 0.5, 0.1}, {0, 0, 0.05});
    Body above = box("above", {0.2, 0.2, 0.02}, {-0.6, 0, 0.11});
    above.velocity = {2, 0, 0};
    world.bodies = {above, below};
    const Timeline timeline = bake(world);
    expect_sliding(contacts_of(timeline, "above", "below"), above.mass * kGravity);
    EXPECT_TRUE(contacts_of(timeline, "below", "floor").empty()) << "friction holds it";
}

TEST(LastingContact_OfBodiesAtRest, DoesNotExist) {
    WorldDescription world = cloth_world(3);
    for (int i = 0; i < 4; ++i) {
        world.bodies.push_back(
            box("b" + std::to_string(i), {0.1, 0.1, 0.05}, {0, 0, 0.025 + 0.05 * i}));
    }
    world.bodies.push_back(ball("one", 0.5, 0));
    world.bodies.push_back(ball("two", 0.5 + 2 * kRadius, 0));
    EXPECT_TRUE(bake(world).lasting_contacts.empty());
}

TEST(LastingContact_OfBoxesThatMoveTogether, IsOnlyThatWithTheFloor) {
    WorldDescription world;
    world.duration = 0.3;
    world.floor_height = 0;
    world.contact_law.otherwise = {0.3, 0.4, 0};
    world.bodies = {box("below", {0.2, 0.2, 0.02}, {0, 0, 0.01}),
                    box("above", {0.2, 0.2, 0.02}, {0, 0, 0.03})};
    for (Body& body : world.bodies) {
        body.material = body.name;
        body.velocity = {2, 0, 0};
    }
    world.contact_law.pairs[{"above", "below"}] = {0.3, 0.9, 0};
    const Timeline timeline = bake(world);
    EXPECT_TRUE(contacts_of(timeline, "below", "above").empty());
    const auto on_floor = contacts_of(timeline, "below", "floor");
    ASSERT_FALSE(on_floor.empty());
    const double weight = 2 * world.bodies[0].mass * kGravity;
    EXPECT_NEAR(on_floor[0].normal_force, weight, 0.01 * weight);
    EXPECT_EQ(on_floor.size(), timeline.lasting_contacts.size());
}

TEST(LastingContact_OfABallThatRollsDownASlope, HasItsLoadAndNoSlip) {
    constexpr double kAngle = 10 * std::numbers::pi / 180;
    WorldDescription world = cloth_world(0.8);
    world.contact_law.otherwise = {0.3, 0.4, 0};
    Body slope = box("slope", {3, 1, 0.1}, {0, 0, 1});
    slope.kind = BodyKind::fixed;
    slope.pose.orientation = {std::cos(kAngle / 2), 0, std::sin(kAngle / 2), 0};
    const Vec3 up(std::sin(kAngle), 0, std::cos(kAngle));
    Body roller = ball("roller", 0, 0);
    roller.pose.position = slope.pose.position + up * (0.05 + kRadius);
    world.bodies = {slope, roller};
    const Timeline timeline = bake(world);
    const auto contacts = contacts_of(timeline, "roller", "slope");
    double pressed = 0;
    for (const LastingContact& contact : contacts) {
        EXPECT_NEAR(contact.normal_force, kMass * kGravity * std::cos(kAngle), 0.02);
        EXPECT_LT(contact.slip, 0.002);
        pressed += contact.to - contact.from;
    }
    EXPECT_GT(pressed, 0.75);
    EXPECT_LT(contacts.size(), 5U);
}

/// A ball that rolls along a cushion of the model `mirror` with a further spin about its own way,
/// whose friction on the cloth presses it against the cushion: with mu m g, while the spin's
/// surface speed s = 1.5 m/s - 5/2 mu g t lasts. Across the contact normal, which is raised by
/// asin(0.27), its surface moves along the cushion with (1 + 0.27) v and up with s.
TEST(LastingContact_OfABallPressedAlongACushion, HasTheForceOfItsSpin) {
    WorldDescription world = walled_world(0.5);
    world.contact_law.ball_cushion = {CushionModel::mirror, 0.8, 0};
    world.contact_law.ball_cloth = {0.2, 0, 0, 0.5};
    const Vec3 velocity(0.8, 0, 0);
    world.bodies = {ball("cue", -0.5, 1.27 / 2 - kRadius - 1e-6, velocity,
                         rolling_spin(velocity) + Vec3(-1.5 / kRadius, 0, 0))};
    const Timeline timeline = bake(world);
    const auto contacts = contacts_of(timeline, "cue", "cushion");
    ASSERT_FALSE(contacts.empty());
    const double loss = 2.5 * 0.2 * kGravity;
    const double pressed = 1.5 / loss;
    EXPECT_LT(contacts.front().from, 0.02);
    EXPECT_NEAR(contacts.back().to, pressed, 0.01);
    for (const LastingContact& contact : contacts) {
        const double spin = 1.5 - loss * 0.5 * (contact.from + contact.to);
        EXPECT_NEAR(contact.normal_force, 0.2 * kMass * kGravity, 0.01) << contact.from;
        EXPECT_NEAR(contact.slip, std::hypot(1.27 * 0.8, spin), 0.01) << contact.from;
    }
}

}  // namespace
}  // namespace carom::sim::test
