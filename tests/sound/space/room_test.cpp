#include "sound/space/room.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/sound/named_room.h"

namespace carom::sound {
namespace {

const Vec3 kSource(0.4, -0.3, 0.05);
const Vec3 kListener(-1, -2, 0.9);

TEST(Room, Names_AreThoseOfTheirRooms) {
    std::vector<std::string_view> names;
    for (const NamedRoom& one : rooms()) {
        names.push_back(one.name);
    }
    EXPECT_EQ(names, (std::vector<std::string_view>{"none", "studio", "club", "hall", "outdoors"}));
    EXPECT_EQ(room_named("club"), RoomSettings{});
    EXPECT_EQ(room_named("none").kind, RoomSettings::Kind::none);
    EXPECT_EQ(room_named("hall").size, Vec3(30, 20, 8));
    EXPECT_EQ(room_named("outdoors").kind, RoomSettings::Kind::outdoors);
}

TEST(Room, CriticalDistance_IsThatOfTheFormula) {
    EXPECT_NEAR(critical_distance(room_named("club")), 0.057 * std::sqrt(134.4 / 0.6), 1e-12);
    EXPECT_NEAR(critical_distance(room_named("club")), 0.85, 0.005);
}

TEST(Reflections, BoxWithPlaceInside_HasSixImages) {
    const RoomSettings room = room_named("club");
    const std::vector<Reflection> reflections = reflections_of(room, kSource, kListener);
    ASSERT_EQ(reflections.size(), 6U);
    const Vec3 expected[] = {{-8.4, -0.3, 0.05}, {7.6, -0.3, 0.05},  {0.4, -5.7, 0.05},
                             {0.4, 6.3, 0.05},   {0.4, -0.3, -1.65}, {0.4, -0.3, 3.95}};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR((reflections[i].image - expected[i]).length(), 0, 1e-12) << i;
        EXPECT_EQ(reflections[i].axis, static_cast<int>(i / 2));
    }
}

// A reflection keeps the part of the energy that Eyring's formula asks for: after T, sound has been
// reflected c T S / 4 V times, and 60 dB are gone.
TEST(Reflections, Absorption_DecaysBy60DecibelsInTheTimeOfTheRoom) {
    const RoomSettings room = room_named("hall");
    const Reflection reflection = *reflections_of(room, kSource, kListener).begin();
    const double volume = 30 * 20 * 8;
    const double surface = 2 * (30 * 20 + 20 * 8 + 8 * 30);
    const auto decay_in = [&](double reverberation, double factor) {
        const double count = 343 * reverberation * surface / (4 * volume);
        return count * 20 * std::log10(factor);
    };
    const auto delay = std::polar(1.0, -2 * std::numbers::pi * kHighFrequency / kSampleRate);
    const double high =
        std::abs(reflection.gain * (1 - reflection.pole) / (1.0 - reflection.pole * delay));
    // 0.161 instead of 24 ln 10 / c makes 0.02 dB.
    EXPECT_NEAR(decay_in(1.2, reflection.gain), -60, 0.1);
    EXPECT_NEAR(decay_in(0.8, high), -60, 0.1);
}

TEST(Reflections, Outdoors_OnlyTheGroundReflects) {
    const std::vector<Reflection> reflections =
        reflections_of(room_named("outdoors"), kSource, kListener);
    ASSERT_EQ(reflections.size(), 1U);
    EXPECT_NEAR((reflections[0].image - Vec3(0.4, -0.3, -1.65)).length(), 0, 1e-12);
    EXPECT_EQ(reflections[0].pole, 0);
    EXPECT_EQ(reflections_of(room_named("none"), kSource, kListener).size(), 0U);
}

TEST(Reflections, ListenerOutside_PushesTheWallBackWithoutAJump) {
    const RoomSettings room = room_named("club");
    const auto image_in_right_wall = [&](double x) {
        return reflections_of(room, kSource, Vec3(x, 0, 1))[1].image.x;
    };
    EXPECT_NEAR(image_in_right_wall(3), 7.6, 1e-12);
    EXPECT_NEAR(image_in_right_wall(10), 2 * 10.3 - 0.4, 1e-12);
    for (double x = 3; x < 6; x += 0.01) {
        EXPECT_LT(std::abs(image_in_right_wall(x + 0.01) - image_in_right_wall(x)), 0.0201);
    }
    // No image is ever nearer than the source's way over the wall.
    const std::vector<Reflection> reflections =
        reflections_of(room, Vec3(20, -30, -5), Vec3(-20, 30, 9));
    for (const Reflection& reflection : reflections) {
        EXPECT_GT((reflection.image - Vec3(-20, 30, 9)).length(), 0.6);
    }
}

TEST(Pole, Filter_HasTheRatioAtTheHighFrequency) {
    for (const double ratio : {0.99999, 0.8, 0.3, 0.01}) {
        const double pole = pole_for(ratio);
        const auto delay = std::polar(1.0, -2 * std::numbers::pi * kHighFrequency / kSampleRate);
        EXPECT_NEAR(std::abs((1 - pole) / (1.0 - pole * delay)), ratio, 1e-12);
        EXPECT_GE(pole, 0);
        EXPECT_LT(pole, 1);
    }
    EXPECT_EQ(pole_for(1), 0);
    EXPECT_EQ(pole_for(1.5), 0);
}

}  // namespace
}  // namespace carom::sound
