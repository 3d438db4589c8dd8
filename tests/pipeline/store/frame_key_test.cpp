#include "pipeline/store/frame_key.h"

#include <cmath>
#include <functional>
#include <set>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/store/own_key.h"
#include "render/frame/frame_fields.h"
#include "render/scene/render_settings_fields.h"
#include "tests/core/field_changes.h"

namespace carom::pipeline {
namespace {

sim::Key make_key(double time, const Vec3& position, const Vec3& velocity, const Vec3& spin,
                  const Quat& orientation = {}) {
    sim::Key key;
    key.time = time;
    key.position = position;
    key.orientation = orientation;
    key.velocity_in = key.velocity_out = velocity;
    key.angular_velocity_in = key.angular_velocity_out = spin;
    return key;
}

Quat turned_about_y(double angle) {
    return {std::cos(angle / 2), 0, std::sin(angle / 2), 0};
}

/// "cue" rolls along x from 0 s to 2 s and rests from then on; "one" rests.
std::vector<sim::Key> cue_keys() {
    return {make_key(0, {0, 0, 0.03}, {1, 0, 0}, {0, 33, 0}),
            make_key(1, {0.75, 0, 0.03}, {0.5, 0, 0}, {0, 17, 0}, turned_about_y(25)),
            make_key(2, {1, 0, 0.03}, {0, 0, 0}, {0, 0, 0}, turned_about_y(33.5)),
            make_key(4, {1, 0, 0.03}, {0, 0, 0}, {0, 0, 0}, turned_about_y(33.5))};
}

/// All inputs of a key, for tests that change one of them.
struct Inputs {
    PlannedFrame frame;
    Shutter shutter;
    render::SceneDescription scene;
    render::RenderSettings settings;
    std::vector<sim::Key> cue = cue_keys();
    std::vector<sim::Key> one{make_key(0, {2, 0.1, 0.03}, {0, 0, 0}, {0, 0, 0})};
    std::string cue_name = "cue";

    Inputs() {
        frame.scene_open = 0.4;
        frame.scene_close = 0.42;
        scene.materials = {{"red", {}}, {"blue", {}}};
        scene.materials[1].surface.base = Vec3(0, 0, 1);
        scene.objects.resize(3);
        scene.objects[0] = {"cloth", render::PlaneShape{}, {}, "", "blue"};
        scene.objects[1] = {"cue ball", render::SphereShape{0.03}, {}, "cue", "red"};
        scene.objects[2] = {"one ball", render::SphereShape{0.03}, {}, "one", "red"};
        scene.lights = {{"sky", render::EnvironmentLight{}}};
    }

    [[nodiscard]] sim::Timeline timeline() const {
        sim::Timeline timeline;
        timeline.tracks.emplace_back("unseen",
                                     std::vector{make_key(0, {0, 0, 0}, {0, 0, 0}, {0, 0, 0})});
        timeline.tracks.emplace_back(cue_name, cue);
        timeline.tracks.emplace_back("one", one);
        return timeline;
    }

    [[nodiscard]] Hash128 key() const {
        return frame_key(frame_inputs(frame, shutter, scene, timeline(), settings.seed), scene,
                         hash_scene(scene), settings);
    }
};

using Change = std::function<void(Inputs&)>;

Hash128 key_with(const Change& change) {
    Inputs inputs;
    change(inputs);
    return inputs.key();
}

render::DistributedSettings& distributed(Inputs& i) {
    i.settings.integrator = render::IntegratorKind::distributed;
    return i.settings.distributed;
}

TEST(FrameKey, SettingsOfTheUnusedIntegrator_DoNotEnter) {
    EXPECT_EQ(key_with([](Inputs& i) { i.settings.distributed.shadow_samples = 9; }),
              Inputs().key());
    EXPECT_EQ(key_with([](Inputs& i) {
                  distributed(i);
                  i.settings.samples = 65;
              }),
              key_with([](Inputs& i) { distributed(i); }));
}

TEST(FrameKey, SameInputs_HaveTheSameKey) {
    EXPECT_EQ(Inputs().key(), Inputs().key());
}

TEST(FrameKey, NumbersNamesAndDirection_DoNotEnter) {
    const Hash128 key = Inputs().key();
    EXPECT_EQ(key, key_with([](Inputs& i) { i.frame.number = 77; }));
    EXPECT_EQ(key, key_with([](Inputs& i) { i.frame.rig = "other"; }));
    EXPECT_EQ(key, key_with([](Inputs& i) { i.frame.reversed = true; }));
    EXPECT_EQ(key, key_with([](Inputs& i) { i.frame.video_time = i.frame.scene_time = 9; }));
    EXPECT_EQ(key, key_with([](Inputs& i) { i.scene.objects[1].name = "white"; }));
    EXPECT_EQ(key, key_with([](Inputs& i) { i.scene.lights[0].name = "dome"; }));
    EXPECT_EQ(key, key_with([](Inputs& i) {
                  i.cue_name = "queue";
                  i.scene.objects[1].track = "queue";
              }));
    EXPECT_EQ(key, key_with([](Inputs& i) {
                  i.scene.materials[0].name = "crimson";
                  i.scene.objects[1].material = i.scene.objects[2].material = "crimson";
              }));
    EXPECT_EQ(key, key_with([](Inputs& i) { i.scene.materials.push_back({"unused", {}}); }));
}

TEST(FrameKey, NamesWithMattes_Enter) {
    const auto with_mattes = [](const Change& change) {
        return key_with([&](Inputs& i) {
            i.settings.aovs = {"depth", "cryptomatte_object"};
            change(i);
        });
    };
    const Hash128 key = with_mattes([](Inputs&) {});
    EXPECT_NE(key, with_mattes([](Inputs& i) { i.scene.objects[1].name = "white"; }));
    EXPECT_NE(key, with_mattes([](Inputs& i) {
                  i.scene.materials[0].name = "crimson";
                  i.scene.objects[1].material = i.scene.objects[2].material = "crimson";
              }));
    EXPECT_NE(key, with_mattes([](Inputs& i) { i.scene.lights[0].name = "dome"; }));
    EXPECT_EQ(key, with_mattes([](Inputs& i) { i.frame.rig = "other"; }));
}

TEST(FrameKey, MotionOutsideTheShutter_DoesNotEnter) {
    const Hash128 key = Inputs().key();
    EXPECT_EQ(key, key_with([](Inputs& i) { i.cue.back().time = 60; }));
    EXPECT_EQ(key, key_with([](Inputs& i) { i.cue.pop_back(); }));
    EXPECT_EQ(key, key_with([](Inputs& i) { i.cue[2].position.x = 3; }));
    EXPECT_EQ(key, key_with([](Inputs& i) {
                  i.cue[1].velocity_out = {0, 5, 0};
                  i.cue[1].angular_velocity_out = {9, 0, 0};
              }));
    EXPECT_EQ(key, key_with([](Inputs& i) {
                  i.one.push_back(make_key(3, {2, 0.1, 0.03}, {0, 0, 0}, {0, 0, 0}));
              }));
}

TEST(FrameKey, EveryFieldOfTheFrame_Enters) {
    Inputs i;
    i.frame.scene_close = 2;
    FrameInputs inputs = frame_inputs(i.frame, i.shutter, i.scene, i.timeline(), 0);
    const auto key = [&] { return frame_key(inputs, i.scene, {}, i.settings); };
    EXPECT_EQ(carom::test::expect_changes_count(inputs.frame, key),
              1U + 3 + 2 * (3 * 3 + 6 + 1 + 4));
}

TEST(FrameKey, EverySettingOfTheIntegrator_Enters) {
    Inputs i;
    std::set<Hash128> keys{i.key()};
    carom::test::FieldChanges([&](const std::string& place, bool counts) {
        const bool is_used = !place.starts_with(".distributed");
        EXPECT_EQ(keys.insert(i.key()).second, counts && is_used) << place;
    }).of(i.settings);
    EXPECT_EQ(keys.size(), 1U + 13 + 2);  // an entry of the list of planes, and its change
    (void)distributed(i);
    EXPECT_EQ(carom::test::expect_changes_count(i.settings.distributed, [&] { return i.key(); }),
              1U + 9);
}

TEST(FrameKey, DenoisedPicture_HasAnotherKeyForEveryFrameAndStrength) {
    const Hash128 one = key_with([](Inputs&) {});
    const Hash128 other = key_with([](Inputs& i) { i.settings.samples += 2; });
    const std::set<Hash128> keys{one,
                                 other,
                                 denoised_key(one, 1),
                                 denoised_key(one, 0.5),
                                 denoised_key(other, 1),
                                 denoised_key(denoised_key(one, 1), 1)};
    EXPECT_EQ(keys.size(), 6U);
    EXPECT_EQ(denoised_key(one, 1), denoised_key(one, 1));
    EXPECT_TRUE(is_own_key(one) && is_own_key(denoised_key(one, 1)));
}

TEST(FrameKey, LensThatOnlyTheViewHas_DoesNotEnter) {
    EXPECT_EQ(Inputs().key(), key_with([](Inputs& i) { i.frame.look = {1, 0.001}; }));
}

TEST(FrameKey, EveryVisibleChange_ChangesIt) {
    const std::vector<std::pair<const char*, Change>> changes{
        {"scene_open", [](Inputs& i) { i.frame.scene_open = 0.39; }},
        {"scene_close", [](Inputs& i) { i.frame.scene_close = 0.43; }},
        {"camera_open", [](Inputs& i) { i.frame.camera_open.roll = 1; }},
        {"camera_close", [](Inputs& i) { i.frame.camera_close.roll = 1; }},
        {"lens", [](Inputs& i) { i.frame.camera_open.lens.emplace(); }},
        {"lens of the other end", [](Inputs& i) { i.frame.camera_close.lens.emplace(); }},
        {"distortion", [](Inputs& i) { i.frame.camera_open.lens.emplace().distortion = 0.01; }},
        {"switch_ratio", [](Inputs& i) { i.shutter.switch_ratio = 0.5; }},
        {"path", [](Inputs& i) { i.cue[1].position.y = 1e-5; }},
        {"velocity", [](Inputs& i) { i.cue[0].velocity_out.y = 1e-5; }},
        {"spin", [](Inputs& i) { i.cue[0].angular_velocity_out.z = 1e-5; }},
        {"turns", [](Inputs& i) { i.cue[1].orientation = turned_about_y(25.1); }},
        {"resting place", [](Inputs& i) { i.one[0].position.x = 2.00001; }},
        {"resting orientation", [](Inputs& i) { i.one[0].orientation = turned_about_y(0.1); }},
        {"binding",
         [](Inputs& i) { std::swap(i.scene.objects[1].track, i.scene.objects[2].track); }},
        {"shared track", [](Inputs& i) { i.scene.objects[2].track = "cue"; }},
        {"no track", [](Inputs& i) { i.scene.objects[2].track = ""; }},
        {"shape", [](Inputs& i) { i.scene.objects[2].shape = render::SphereShape{0.031}; }},
        {"material", [](Inputs& i) { i.scene.objects[2].material = "blue"; }},
    };
    std::vector<std::pair<Hash128, std::string>> seen{{Inputs().key(), "nothing"}};
    for (const auto& [name, change] : changes) {
        const Hash128 key = key_with(change);
        for (const auto& [other, other_name] : seen) {
            EXPECT_NE(key, other) << name << " gives the key of " << other_name;
        }
        seen.emplace_back(key, name);
    }
}

TEST(FrameKey, ImpactInsideTheShutter_EntersWithItsInstant) {
    const auto impact_at = [](double time, double angle) {
        return key_with([&](Inputs& i) {
            i.frame.scene_open = 0.9;
            i.frame.scene_close = 1.1;
            i.cue[1].time = time;
            i.cue[1].velocity_out = {-std::cos(angle), std::sin(angle), 0};
        });
    };
    EXPECT_EQ(impact_at(1, 0.2), impact_at(1, 0.2));
    EXPECT_NE(impact_at(1, 0.2), impact_at(1.0001, 0.2));
    EXPECT_NE(impact_at(1, 0.2), impact_at(1, 0.2001));
}

TEST(FrameKey, SceneAtRest_DoesNotDependOnTheTime) {
    const auto resting_at = [](double open, double close) {
        return key_with([&](Inputs& i) {
            i.frame.scene_open = open;
            i.frame.scene_close = close;
        });
    };
    EXPECT_EQ(resting_at(2.5, 2.52), resting_at(3.5, 3.52));
    EXPECT_EQ(resting_at(2.5, 2.52), resting_at(3.9, 4.1));  // the end of the bake
    EXPECT_EQ(resting_at(2, 2.02), resting_at(7, 7.5));
    EXPECT_NE(resting_at(1.99, 2.01), resting_at(7, 7.5));
}

TEST(FrameKey, FrozenTime_DependsOnThePoseAlone) {
    const auto frozen = [](const Change& change) {
        return key_with([&](Inputs& i) {
            i.frame.scene_open = i.frame.scene_close = 1;
            change(i);
        });
    };
    const Hash128 key = frozen([](Inputs&) {});
    EXPECT_EQ(key, frozen([](Inputs& i) { i.cue[1].velocity_out = {3, 3, 3}; }));
    EXPECT_NE(key, frozen([](Inputs& i) { i.cue[1].position.y = 1e-6; }));
}

TEST(FrameInputs, TracksThatRest_HaveOneKey) {
    Inputs i;
    const FrameInputs moving = frame_inputs(i.frame, i.shutter, i.scene, i.timeline(), 0);
    ASSERT_EQ(moving.tracks.size(), 2u);
    EXPECT_EQ(moving.tracks[0], *i.timeline().find("cue"));
    EXPECT_EQ(moving.tracks[1].keys().size(), 1u);
    EXPECT_EQ(moving.frame.scene_open, 0.4);
    i.frame.scene_open = 3;
    i.frame.scene_close = 3.5;
    const FrameInputs resting = frame_inputs(i.frame, i.shutter, i.scene, i.timeline(), 0);
    EXPECT_EQ(resting.tracks[0].keys().size(), 1u);
    EXPECT_EQ(resting.tracks[0].keys()[0].position, Vec3(1, 0, 0.03));
    EXPECT_EQ(resting.frame.scene_open, 0);
    EXPECT_EQ(resting.frame.scene_close, 0);
}

TEST(FrameInputs, TracksThatMove_ShareTheTimelinesKeys) {
    Inputs i;
    const sim::Timeline timeline = i.timeline();
    const FrameInputs inputs = frame_inputs(i.frame, i.shutter, i.scene, timeline, 0);
    const sim::Track* original = timeline.find(inputs.tracks[0].name());
    ASSERT_TRUE(original != nullptr && original->keys().size() > 1);
    EXPECT_EQ(inputs.tracks[0].keys().data(), original->keys().data());
}

// So the noise of a film of a frozen scene, or of a retimed film, depends on what is shown.
TEST(FrameInputs, Seed_DependsOnSceneTimeAndCamera) {
    const auto seed = [](const Change& change, std::uint64_t render_seed = 0) {
        Inputs i;
        change(i);
        return frame_inputs(i.frame, i.shutter, i.scene, i.timeline(), render_seed).frame.seed;
    };
    const std::uint64_t usual = seed([](Inputs&) {});
    EXPECT_EQ(usual, seed([](Inputs& i) { i.frame.number = 77; }));
    EXPECT_EQ(usual, seed([](Inputs& i) { i.frame.video_time = 9; }));
    EXPECT_EQ(usual, seed([](Inputs& i) { i.cue[1].position.y = 1; }));
    EXPECT_EQ(usual, seed([](Inputs& i) { i.scene.objects[2].material = "blue"; }));
    EXPECT_NE(usual, seed([](Inputs&) {}, 1));
    EXPECT_NE(usual, seed([](Inputs& i) { i.frame.scene_open = 0.41; }));
    const auto frozen = [&](double camera) {
        return seed([&](Inputs& i) {
            i.frame.scene_open = i.frame.scene_close = 1;
            i.frame.camera_open.position.x = camera;
        });
    };
    EXPECT_NE(frozen(0), frozen(0.01));
    EXPECT_EQ(frozen(0.01), frozen(0.01));
}

TEST(FrameInputs, BallThatIsPutElsewhere_MovesOnlyInThatExposure) {
    Inputs i;
    const double landed = sim::time_after_jump(0.41);
    i.one = {make_key(0.41, {2, 0.1, 0.03}, {0, 0, 0}, {0, 0, 0}),
             make_key(landed, {0, 0, 0.03}, {0, 0, 0}, {0, 0, 0})};
    const auto inputs = [&](double open, double close) {
        i.frame.scene_open = open;
        i.frame.scene_close = close;
        return frame_inputs(i.frame, i.shutter, i.scene, i.timeline(), 0).tracks[1];
    };
    EXPECT_EQ(inputs(0.4, 0.42).keys().size(), 2u);
    EXPECT_EQ(inputs(0.3, 0.41).keys().size(), 1u);
    EXPECT_EQ(inputs(0.3, 0.41).keys()[0].position, Vec3(2, 0.1, 0.03));
    EXPECT_EQ(inputs(0.41, 0.43).keys().size(), 1u);
    EXPECT_EQ(inputs(0.41, 0.43).keys()[0].position, Vec3(0, 0, 0.03));
}

TEST(FrameInputs, SpinInPlace_CountsAsMotion) {
    Inputs i;
    i.one = {
        make_key(0, {2, 0.1, 0.03}, {0, 0, 0}, {0, 0, 1}),
        make_key(1, {2, 0.1, 0.03}, {0, 0, 0}, {0, 0, 1}, {std::cos(0.5), 0, 0, std::sin(0.5)})};
    EXPECT_EQ(frame_inputs(i.frame, i.shutter, i.scene, i.timeline(), 0).tracks[1].keys().size(),
              2u);
}

TEST(FrameInputs, MissingTrack_IsAnErrorNamingBoth) {
    Inputs i;
    i.scene.objects[2].track = "two";
    try {
        (void)frame_inputs(i.frame, i.shutter, i.scene, i.timeline(), 0);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "object 'one ball' follows the track 'two', which the timeline does not have");
    }
}

}  // namespace
}  // namespace carom::pipeline
