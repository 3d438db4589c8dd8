#include "sound/rolling/rolling_source.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace carom::sound {
namespace {

constexpr double kRadius = 0.028575;  // m
constexpr double kEnd = 4;            // s of the scene

sim::Event event(sim::EventKind kind, double time) {
    sim::Event event;
    event.kind = kind;
    event.time = event.end_time = time;
    event.a = "one";
    return event;
}

/// A shot of a ball with this constant velocity along x and this spin about y from 0 to 4 s.
struct Shot {
    sim::Timeline timeline;
    SoundShot shot;

    Shot(double velocity, double spin, const std::vector<sim::Event>& events) {
        sim::Key first;
        sim::Key last;
        last.time = kEnd;
        first.position = {0, 0, kRadius};
        last.position = {kEnd * velocity, 0, kRadius};
        first.velocity_in = first.velocity_out = {velocity, 0, 0};
        first.angular_velocity_in = first.angular_velocity_out = {0, spin, 0};
        last.velocity_in = last.velocity_out = first.velocity_in;
        last.angular_velocity_in = last.angular_velocity_out = first.angular_velocity_in;
        timeline.end_time = kEnd;
        timeline.tracks.emplace_back("one", std::vector{first, last});
        timeline.events = events;
        SoundBody body;
        body.name = "one";
        body.shape = BallShape{kRadius};
        shot.bodies.push_back(body);
        shot.timeline = &timeline;
    }
    Shot(const Shot&) = delete;
    Shot& operator=(const Shot&) = delete;

    [[nodiscard]] RollingSource source() const {
        const std::vector<RollingSource> sources = rolling_sources(shot);
        EXPECT_EQ(sources.size(), 1U);
        return sources.at(0);
    }
};

const std::vector<sim::Event> kRolling{event(sim::EventKind::rolling, 0)};

/// Without dynamics.
ClipSettings natural() {
    ClipSettings settings;
    settings.ratio = 1;
    return settings;
}

Clip clip_of(std::function<double(double)> scene_time, double speed,
             const ClipSettings& settings = natural()) {
    Clip clip;
    clip.to = 1000;
    clip.scene_time = std::move(scene_time);
    clip.speed = [speed](double) { return speed; };
    clip.settings = settings;
    return clip;
}

Clip forward(double speed = 1, const ClipSettings& settings = natural()) {
    return clip_of([speed](double time) { return speed * time; }, speed, settings);
}

std::vector<double> played(const RollingSource& source, const Clip& clip, std::size_t count,
                           std::size_t block = 1024) {
    std::vector<double> pressure(count);
    RollingVoice voice(source);
    for (std::size_t first = 0; first < count; first += block) {
        const std::size_t size = std::min(block, count - first);
        voice.add(ClipBlock(clip, static_cast<std::int64_t>(first), size),
                  std::span(pressure).subspan(first, size));
    }
    return pressure;
}

double decibels(const std::vector<double>& pressure) {
    double sum = 0;
    for (const double sample : pressure) {
        sum += sample * sample;
    }
    return 10 * std::log10(sum / static_cast<double>(pressure.size()) / 4e-10);
}

int zero_crossings(const std::vector<double>& pressure) {
    int count = 0;
    for (std::size_t n = 1; n < pressure.size(); ++n) {
        count += (pressure[n] > 0) != (pressure[n - 1] > 0) ? 1 : 0;
    }
    return count;
}

TEST(RollingBall, Level_Is40DecibelsAtOneMetrePerSecondAnd9MorePerDoubling) {
    const std::size_t count = 4 * kSampleRate;
    for (const auto& [speed, level] :
         {std::pair(0.5, 31.0), std::pair(1.0, 40.0), std::pair(2.0, 49.0), std::pair(4.0, 58.0)}) {
        const Shot shot(speed, speed / kRadius, kRolling);
        EXPECT_NEAR(decibels(played(shot.source(), forward(), count)), level, 1) << speed;
        EXPECT_NEAR(20 * std::log10(rolling_pressure(speed) / 20e-6), level, 1e-4);
    }
}

TEST(RollingBall, Sliding_Is3DecibelsMoreOfTheSlipSpeed) {
    // The ball slides without turning, so both oscillators have the same speed.
    const Shot shot(2, 0, kRolling);
    const double level = 49 + 10 * std::log10(1 + std::pow(10, 0.3));
    EXPECT_NEAR(decibels(played(shot.source(), forward(), 4 * kSampleRate)), level, 1);
}

TEST(RollingBall, AtRestOrBelow20MillimetresPerSecond_IsZero) {
    for (const double speed : {0.0, 0.0199}) {
        const Shot shot(speed, speed / kRadius, kRolling);
        for (const double sample : played(shot.source(), forward(), kSampleRate)) {
            ASSERT_EQ(sample, 0);
        }
    }
    EXPECT_GT(rolling_pressure(0.0201), 0);
}

TEST(RollingBall, Airborne_EndsIt) {
    std::vector<sim::Event> events = kRolling;
    events.push_back(event(sim::EventKind::airborne, 1));
    events.push_back(event(sim::EventKind::rolling, 2));
    const Shot shot(1, 1 / kRadius, events);
    const std::vector<double> pressure = played(shot.source(), forward(), 3 * kSampleRate);
    for (std::size_t n = kSampleRate; n <= 2 * kSampleRate; ++n) {
        ASSERT_EQ(pressure[n], 0);
    }
    EXPECT_NE(pressure[kSampleRate - 100], 0);
    EXPECT_NE(pressure[2 * kSampleRate + 100], 0);
    // It fades out: the last millisecond has a fifth of the pressure at most.
    double most = 0;
    for (std::size_t n = kSampleRate - 48; n < kSampleRate; ++n) {
        most = std::max(most, std::abs(pressure[n]));
    }
    EXPECT_LT(most, 2e-3 * 4 / 5);
    const RollingSource source = shot.source();
    EXPECT_TRUE(source.sounds(1.5, 0.5));
    EXPECT_TRUE(source.sounds(1.5, 2.5));
    EXPECT_FALSE(source.sounds(1.2, 1.8));
    EXPECT_FALSE(source.sounds(5, 6));
}

TEST(RollingBall, Backwards_IsTheMirrorImage) {
    const Shot shot(1.7, 0, kRolling);
    const int last = 3 * kSampleRate;
    for (const double speed : {1.0, 0.25, 1.0 / 40}) {
        const std::vector<double> there = played(shot.source(), forward(speed), last + 1);
        const std::vector<double> back =
            played(shot.source(), clip_of([&](double time) { return speed * (3 - time); }, -speed),
                   last + 1);
        double largest = 0;
        double most = 0;
        for (int n = 0; n <= last; ++n) {
            largest = std::max(largest, std::abs(there[n] - back[last - n]));
            most = std::max(most, std::abs(there[n]));
        }
        EXPECT_LT(largest, 1e-9 * most) << speed;
        EXPECT_GT(most, 0);
    }
}

TEST(RollingBall, SlowPicture_LowersThePitch) {
    const Shot shot(6, 6 / kRadius, kRolling);
    const int normal = zero_crossings(played(shot.source(), forward(), 2 * kSampleRate));
    const auto ratio_at = [&](double speed, const ClipSettings& settings) {
        return zero_crossings(played(shot.source(), forward(speed, settings), 2 * kSampleRate)) /
               static_cast<double>(normal);
    };
    ClipSettings keep = natural();
    keep.pitch = 0;
    ClipSettings root = natural();
    root.pitch = 0.5;
    EXPECT_NEAR(ratio_at(0.5, natural()), 0.5, 0.05);
    EXPECT_NEAR(ratio_at(0.25, keep), 1, 0.1);
    EXPECT_NEAR(ratio_at(0.25, root), 0.5, 0.05);
    // No lower than at the lowest speed.
    EXPECT_NEAR(ratio_at(1.0 / 40, natural()) / ratio_at(1.0 / 8, natural()), 1, 0.1);
}

TEST(RollingBall, AlmostStandingPicture_FadesThoughThePitchStays) {
    const Shot shot(6, 6 / kRadius, kRolling);
    ClipSettings keep = natural();
    keep.pitch = 0;
    // A tenth of a hundredth: 20 dB. Of the scene, 10 s show what lasts 10 ms.
    const auto clip = [&](double speed) {
        return clip_of([speed](double time) { return 1 + speed * time; }, speed, keep);
    };
    const std::size_t count = 10 * kSampleRate;
    EXPECT_NEAR(decibels(played(shot.source(), clip(1e-2), count)) -
                    decibels(played(shot.source(), clip(1e-3), count)),
                20, 1);
}

TEST(RollingBall, StandingPicture_IsSilent) {
    const Shot shot(2, 0, kRolling);
    const Clip frozen = clip_of([](double) { return 1.234; }, 0);
    for (const double sample : played(shot.source(), frozen, 5000)) {
        ASSERT_EQ(sample, 0);
    }
}

TEST(RollingBall, RampOfTheSpeed_HasNoStep) {
    // From normal speed to a stop within 2 s; the pitch is kept in one case.
    const Shot shot(2, 0, kRolling);
    for (const double pitch : {0.0, 0.5, 1.0}) {
        ClipSettings settings = natural();
        settings.pitch = pitch;
        Clip ramp = clip_of([](double time) { return time - time * time / 4; }, 1, settings);
        ramp.speed = [](double time) { return std::max(0.0, 1 - time / 2); };
        const std::vector<double> pressure = played(shot.source(), ramp, 2 * kSampleRate);
        double steepest = 0;
        double most = 0;
        for (std::size_t n = 1; n < pressure.size(); ++n) {
            steepest = std::max(steepest, std::abs(pressure[n] - pressure[n - 1]));
            most = std::max(most, std::abs(pressure[n]));
        }
        EXPECT_LT(steepest, most / 5) << pitch;
    }
}

TEST(RollingBall, BlockSize_ChangesNoBit) {
    std::vector<sim::Event> events = kRolling;
    events.push_back(event(sim::EventKind::airborne, 0.3));
    events.push_back(event(sim::EventKind::sliding, 0.5));
    const Shot shot(3, 10, events);
    Clip ramp = clip_of([](double time) { return time - time * time / 4; }, 1);
    ramp.speed = [](double time) { return 1 - time / 2; };
    ramp.settings.pitch = 0.4;
    const std::vector<double> whole = played(shot.source(), ramp, 50000, 50000);
    for (const std::size_t size : {1U, 64U, 1024U, 4096U}) {
        EXPECT_EQ(played(shot.source(), ramp, 50000, size), whole) << size;
    }
}

// The duration of each contact is heard with the ball's own change of speed.
TEST(RollingBall, Contacts_AreThoseWithAnything) {
    std::vector<sim::Event> events = kRolling;
    for (const char* other : {"cushion", "cloth", "two", "cushion"}) {
        sim::Event impact = event(sim::EventKind::impact, static_cast<double>(events.size()) / 2);
        impact.b = other;
        impact.normal_impulse = 0.1;
        events.push_back(impact);
    }
    events[3].a = "a_ball_with_a_long_name";
    events[3].b = "one";
    Shot shot(1, 1 / kRadius, events);
    SoundBody other = shot.shot.bodies[0];
    other.name = events[3].a;
    shot.shot.bodies.push_back(other);
    const RollingSource source = shot.source();
    std::vector<double> times;
    for (const ContactTime& contact : std::get<RollingBall>(source.motion).contacts) {
        times.push_back(contact.time);
        EXPECT_GT(contact.duration, 0);
    }
    EXPECT_EQ(times, (std::vector<double>{0.5, 1, 1.5, 2}));
}

TEST(RollingBall, Place_IsThatOfTheBall) {
    const Shot shot(2, 0, kRolling);
    EXPECT_NEAR((shot.source().place(1.5) - Vec3(3, 0, kRadius)).length(), 0, 1e-12);
}

/// A box that lies on "two" with a normal force and slips.
RollingSource scraping_source(double force, double slip, const std::string& other = "two") {
    static sim::Timeline timeline;
    timeline = {};
    timeline.end_time = kEnd;
    timeline.lasting_contacts.push_back({"box", other, 0.5, 3.5, force, slip});
    SoundBody body;
    body.name = "box";
    body.shape = BoxShape{};
    body.position = {1, 2, 3};
    SoundShot shot;
    shot.timeline = &timeline;
    shot.bodies.push_back(body);
    const std::vector<RollingSource> sources = rolling_sources(shot);
    EXPECT_EQ(sources.size(), 1U);
    return sources.at(0);
}

TEST(Scraping, Level_GrowsWithTheForceAndTheSlip) {
    const auto level = [](double force, double slip) {
        return decibels(played(scraping_source(force, slip), forward(), 4 * kSampleRate)) +
               10 * std::log10(4.0 / 3);  // it sounds for three of four seconds
    };
    EXPECT_NEAR(level(1, 0.1), 45, 1);
    EXPECT_NEAR(level(4, 0.1), 45 + 10 * std::log10(4), 1);
    EXPECT_NEAR(level(1, 0.4), 45 + 15 * std::log10(4), 1);
    EXPECT_NEAR(scraping_pressure(0.1, 4), 2 * 20e-6 * std::pow(10, 45.0 / 20), 1e-9);
    EXPECT_EQ(scraping_source(4, 0.1).place(1), Vec3(1, 2, 3));
}

TEST(Scraping, PartsOfOneContact_DoNotFadeBetween) {
    sim::Timeline timeline;
    timeline.lasting_contacts = {{"box", "two", 0, 1, 1, 0.1},
                                 {"box", "three", 0.5, 0.7, 1, 0.1},
                                 {"box", "two", 1, 2, 1, 0.1},
                                 {"box", "two", 3, 4, 1, 0.1}};
    SoundBody body;
    body.name = "box";
    SoundShot shot;
    shot.timeline = &timeline;
    shot.bodies.push_back(body);
    const std::vector<RollingSource> sources = rolling_sources(shot);
    ASSERT_EQ(sources.size(), 2U);
    const std::size_t second = kSampleRate;
    const std::vector<double> box_two = played(sources[0], forward(), 4 * second);
    const std::vector<double> box_three = played(sources[1], forward(), second);
    const auto level = [](const std::vector<double>& pressure, double from, double to) {
        return decibels({pressure.begin() + static_cast<int>(from * kSampleRate),
                         pressure.begin() + static_cast<int>(to * kSampleRate)});
    };
    EXPECT_NEAR(level(box_two, 0.98, 1.02), 45, 3);
    EXPECT_NEAR(level(box_two, 1.97, 1.995), 45, 3);
    EXPECT_LT(level(box_two, 1.999, 2), 45 - 12);
    EXPECT_EQ(level(box_two, 2, 3), -std::numeric_limits<double>::infinity());
    EXPECT_NEAR(level(box_two, 3.1, 3.9), 45, 2);
    EXPECT_EQ(level(box_three, 0.7, 1), -std::numeric_limits<double>::infinity());
    EXPECT_NEAR(level(box_three, 0.55, 0.65), 45, 3);
}

TEST(RollingBall, Dynamics_LiftWhatIsQuiet) {
    const Shot shot(1, 1 / kRadius, kRolling);  // 40 dB
    ClipSettings film;
    film.ratio = 2;
    EXPECT_NEAR(decibels(played(shot.source(), forward(1, film), kSampleRate)) -
                    decibels(played(shot.source(), forward(), kSampleRate)),
                20, 1e-3);
}

// From 3 m/s to 0.5 m/s within a contact of 5.5 ms with a cushion.
TEST(RollingBall, Blow_MakesNoStep) {
    Shot shot(3, 3 / kRadius, kRolling);
    std::vector<sim::Key> keys(shot.timeline.tracks[0].keys().begin(),
                               shot.timeline.tracks[0].keys().end());
    sim::Key hit = keys[0];
    hit.time = 1;
    hit.position.x = 3;
    hit.velocity_out = {-0.5, 0, 0};
    hit.angular_velocity_out = {0, -0.5 / kRadius, 0};
    keys[1].position.x = 1.5;
    keys[1].velocity_in = keys[1].velocity_out = hit.velocity_out;
    keys[1].angular_velocity_in = keys[1].angular_velocity_out = hit.angular_velocity_out;
    keys.insert(keys.begin() + 1, hit);
    shot.timeline.tracks[0] = sim::Track("one", keys);
    sim::Event impact = event(sim::EventKind::impact, 1);
    impact.b = "cushion";
    impact.normal = {-1, 0, 0};
    impact.normal_impulse = 0.5;
    shot.timeline.events.push_back(impact);
    shot.shot.resonators.cushion.contact = 0.0055;
    for (const double speed : {1.0, 1.0 / 8}) {
        const auto count = static_cast<std::size_t>(1.5 / speed * kSampleRate);
        const std::vector<double> pressure = played(shot.source(), forward(speed), count);
        double most = 0;
        double sharpest = 0;
        for (std::size_t n = 1; n + 1 < count; ++n) {
            most = std::max(most, std::abs(pressure[n]));
            sharpest =
                std::max(sharpest, std::abs(pressure[n - 1] - 2 * pressure[n] + pressure[n + 1]));
        }
        EXPECT_LT(sharpest, (speed == 1 ? 0.05 : 0.002) * most) << speed;
    }
}

TEST(Scraping, ContactsWithoutSlip_AreNoSources) {
    sim::Timeline timeline;
    timeline.lasting_contacts = {{"box", "two", 0, 1, 5, 0}, {"box", "two", 1, 2, 0, 1}};
    SoundBody body;
    body.name = "box";
    SoundShot shot;
    shot.timeline = &timeline;
    shot.bodies.push_back(body);
    EXPECT_TRUE(rolling_sources(shot).empty());
}

TEST(Scraping, BallOnCloth_IsHeardOnlyByItsRolling) {
    Shot shot(1, 1 / kRadius, kRolling);
    shot.timeline.lasting_contacts = {{"one", "cloth", 0, 1, 2, 0.5},
                                      {"one", "cushion", 1, 2, 2, 0.5}};
    const std::vector<RollingSource> sources = rolling_sources(shot.shot);
    ASSERT_EQ(sources.size(), 2U);
    EXPECT_FALSE(sources[1].sounds(0, 0.9));
    EXPECT_TRUE(sources[1].sounds(1.1, 1.9));
}

}  // namespace
}  // namespace carom::sound
