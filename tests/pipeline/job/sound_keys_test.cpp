// The settings of a film's sound change neither a frame nor its name in the store.
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/job/film_plan.h"
#include "tests/pipeline/job/tiny_shot.h"

namespace carom::pipeline {
namespace {

using carom::testing::tiny_shot;
using carom::testing::tiny_timeline;

std::vector<Hash128> keys_of(const Shot& shot) {
    const sim::Timeline timeline = tiny_timeline();
    const FilmSource source(shot, timeline);
    std::vector<std::int64_t> frames(12);
    std::iota(frames.begin(), frames.end(), 0);
    std::vector<Hash128> keys;
    for (const FilmPlan::Picture& picture : plan_film(source, frames, {}).pictures) {
        keys.push_back(picture.key);
        keys.push_back(picture.noisy_key);
    }
    return keys;
}

TEST(FrameKeys, Sound_ChangesNone) {
    const std::vector<Hash128> keys = keys_of(tiny_shot());
    ASSERT_GE(keys.size(), 2U);
    Shot silent = tiny_shot();
    silent.sound.is_silent = true;
    EXPECT_EQ(keys_of(silent), keys);
    Shot other = tiny_shot();
    other.sound.room.kind = sound::RoomSettings::Kind::outdoors;
    other.sound.bed_reflection = 0;
    other.sound.full_scale = 20;
    other.sound.materials.resize(1);
    other.sound.materials[0].name = "ball";
    other.sound.materials[0].modulus = 1e9;
    for (CameraSound* sound : {&other.sound.cameras, &other.cameras[0].sound}) {
        sound->gain = -6;
        sound->pitch = 0;
        sound->ratio = 1;
        sound->listener = ListenerPlace{};
        sound->mix[0] = 3;
    }
    EXPECT_EQ(keys_of(other), keys);
    other.cameras[0].roll = {0.1, 0.1};
    EXPECT_NE(keys_of(other), keys);
}

}  // namespace
}  // namespace carom::pipeline
