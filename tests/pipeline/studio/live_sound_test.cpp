// The sound of the film that is open: its pieces, and what replaces them.
#include "pipeline/studio/live_sound.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <unistd.h>

#include "pipeline/config/load_shot.h"
#include "pipeline/sound/film_scene.h"
#include "sim/bake.h"
#include "sound/file/wav_file.h"
#include "sound/mix/film_sound.h"
#include "tests/patience.h"

namespace carom::studio {
namespace {

using testing::HasSubstr;

/// One ball hits another one after 0.1 s, as a camera hears it for a second.
const std::string kShot = R"(carom: 1
table: {kind: cloth}
balls:
  cue: {at: [0, 0]}
  one: {at: [0.3, 0]}
events: [{strike: {ball: cue, at: 0 s, toward: one, speed: 3 m/s}}]
cameras: [{video: [0 s, 1 s], scene: [0 s, 1 s], position: [0, -2, 1], target: [0, 0, 0]}]
render: {size: [640, 360], fps: 24}
)";

struct Baked {
    std::shared_ptr<const pipeline::Shot> shot;
    std::shared_ptr<const sim::Timeline> timeline;
};

Baked bake(const std::string& text) {
    const auto path = std::filesystem::temp_directory_path() /
                      ("carom_live_sound_" + std::to_string(getpid()) + ".yaml");
    std::ofstream(path) << text;
    pipeline::LoadResult loaded = pipeline::load_shot(path.string());
    std::filesystem::remove(path);
    if (!loaded.shot) {
        throw std::runtime_error(loaded.problems.front().message);
    }
    const auto shot = std::make_shared<const pipeline::Shot>(std::move(*loaded.shot));
    return {shot, std::make_shared<const sim::Timeline>(sim::bake(shot->world))};
}

LiveSound::Make heard(const Baked& film) {
    return [film] { return heard_film(*film.shot, *film.timeline); };
}

class LiveSoundTest : public testing::Test {
  protected:
    /// Films are computed at once, unless a test says otherwise.
    void start(LiveSoundOptions options = {.rest = {}}) {
        sound_ = std::make_unique<LiveSound>(
            [this](int opening, const SoundState& state) {
                const std::lock_guard lock(mutex_);
                openings_.push_back(opening);
                states_.push_back(state);
                wake_.notify_all();
            },
            options);
    }

    /// Waits for the last state of that version: there is all of the sound, or none.
    SoundState last_of(std::int64_t v) {
        std::unique_lock lock(mutex_);
        const bool came = wake_.wait_for(lock, kPatience, [&] {
            return !states_.empty() && states_.back().v == v &&
                   (states_.back().ready == states_.back().samples ||
                    !states_.back().reason.empty());
        });
        if (!came) {
            throw std::runtime_error("the sound does not come");
        }
        return states_.back();
    }

    /// All numbers of the pieces that can be got.
    [[nodiscard]] std::vector<std::int16_t> numbers(const SoundState& state) const {
        std::vector<std::int16_t> all;
        for (int i = 0; i * state.piece < state.ready; ++i) {
            const auto bytes = sound_->find(state.address + std::to_string(i) + ".pcm");
            for (std::size_t n = 0; n + 1 < bytes->size(); n += 2) {
                const auto low = static_cast<unsigned char>((*bytes)[n]);
                const auto high = static_cast<unsigned char>((*bytes)[n + 1]);
                all.push_back(static_cast<std::int16_t>(low | high << 8));
            }
        }
        return all;
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::vector<int> openings_;
    std::vector<SoundState> states_;
    std::unique_ptr<LiveSound> sound_;
};

TEST_F(LiveSoundTest, Pieces_AreTheSamplesOfTheFilm) {
    const Baked film = bake(kShot);
    start({.rest = {}, .piece = 10'001});
    sound_->set(7, 3, heard(film));
    const SoundState state = last_of(3);
    EXPECT_EQ(state.rate, 48'000);
    EXPECT_EQ(state.samples, 48'000);
    EXPECT_THAT(openings_, testing::Each(7));
    ASSERT_EQ(states_.size(), 5U);
    EXPECT_EQ(states_.front().ready, 10'001);
    EXPECT_EQ(states_.front().address, state.address);

    sound::FilmSound source(pipeline::film_scene(*film.shot, *film.timeline, 0, 24));
    std::vector<double> left(48'000);
    std::vector<double> right(48'000);
    ASSERT_EQ(source.read(left, right), left.size());
    const std::vector<std::int16_t> got = numbers(state);
    ASSERT_EQ(got.size(), 2 * left.size());
    double most = 0;
    double loudest = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
        most = std::max({most, std::abs(got[2 * i] - 32767 * left[i]),
                         std::abs(got[2 * i + 1] - 32767 * right[i])});
        loudest = std::max(loudest, std::abs(left[i]));
    }
    EXPECT_LE(most, 0.5);
    EXPECT_GT(loudest, 0.2);
}

TEST_F(LiveSoundTest, AnotherFilm_TakesThePlaceOfTheFirst) {
    const Baked film = bake(kShot);
    start();
    sound_->set(1, 1, heard(film));
    const SoundState first = last_of(1);
    sound_->set(1, 2, heard(film));
    const SoundState second = last_of(2);
    EXPECT_NE(first.address, second.address);
    EXPECT_FALSE(sound_->find(first.address + "0.pcm"));
    EXPECT_TRUE(sound_->find(second.address + "0.pcm"));
    EXPECT_FALSE(sound_->find(second.address + "1.pcm"));
    EXPECT_FALSE(sound_->find("/sound/../0.pcm"));
    sound_->clear();
    EXPECT_FALSE(sound_->find(second.address + "0.pcm"));
}

TEST_F(LiveSoundTest, FilmThatIsReplacedAtOnce_IsNotComputed) {
    const Baked film = bake(kShot);
    start({.rest = std::chrono::milliseconds(1000)});
    std::atomic<int> made = 0;
    for (int v = 1; v <= 5; ++v) {
        sound_->set(1, v, [&made, film] {
            ++made;
            return heard_film(*film.shot, *film.timeline);
        });
        std::this_thread::sleep_for(std::chrono::milliseconds(5));  // a step of a drag
    }
    last_of(5);
    EXPECT_EQ(made, 1);
    EXPECT_EQ(states_.front().v, 5);
}

TEST_F(LiveSoundTest, WorkOnAnOldFilm_IsStopped) {
    const Baked film = bake(kShot);
    start();
    // A film of hours would keep the thread for minutes.
    sound_->set(1, 1, [film] {
        HeardFilm all = heard_film(*film.shot, *film.timeline);
        all.samples = std::int64_t{48'000} * 3'600 * 100;
        return all;
    });
    sound_->set(1, 2, heard(film));
    last_of(2);
    sound_->set(1, 3, heard(film));
    sound_.reset();  // ends at once, too
    EXPECT_EQ(states_.front().v, 2);
}

TEST_F(LiveSoundTest, FilmWithoutSound_HasAReason) {
    start({.rest = {}, .most_seconds = 0.5});
    sound_->set(1, 1, heard(bake(kShot + "sound: none\n")));
    EXPECT_THAT(last_of(1).reason, HasSubstr("sound: none"));
    EXPECT_EQ(last_of(1).address, "");
    sound_->set(1, 2, heard(bake(kShot)));
    EXPECT_THAT(last_of(2).reason, HasSubstr("longer"));
    sound_->set(1, 3, []() -> HeardFilm { throw std::runtime_error("a reason"); });
    EXPECT_EQ(last_of(3).reason, "a reason");
}

/// Reads a sound to its end; returns its length.
std::size_t read_all(pipeline::SoundSource& source, std::span<double> left,
                     std::span<double> right) {
    std::size_t count = 0;
    while (const std::size_t got = source.read(left.subspan(count), right.subspan(count))) {
        count += got;
    }
    return count;
}

/// A .wav file of half a second with the number 0.25 in both channels, and its path.
std::string constant_music() {
    const std::string path = (std::filesystem::temp_directory_path() /
                              ("carom_live_music_" + std::to_string(getpid()) + ".wav"))
                                 .string();
    sound::WavFile writer(path, 24'000);
    const std::vector<double> channel(24'000, 0.25);
    writer.write(channel, channel);
    writer.finish();
    return path;
}

TEST_F(LiveSoundTest, Music_IsHeardUnderTheSoundOrAlone) {
    const std::string file = constant_music();
    start();
    const std::string music = "output: {music: {file: " + file + "}}\n";
    sound_->set(1, 1, heard(bake(kShot + "sound: none\n" + music)));
    const SoundState alone = last_of(1);
    EXPECT_EQ(alone.reason, "");
    EXPECT_EQ(alone.samples, 48'000);
    std::vector<std::int16_t> got = numbers(alone);
    ASSERT_EQ(got.size(), 96'000U);
    EXPECT_NEAR(got[20'000], 0.25 * 32767, 1);
    EXPECT_EQ(got[2 * 24'000], 0) << "after the music's end";
    sound_->set(1, 2, heard(bake(kShot + music)));
    got = numbers(last_of(2));
    const auto loudest = std::ranges::max(got);
    EXPECT_GT(loudest, 0.4 * 32767);
    EXPECT_LE(loudest, 0.8913 * 32767) << "a true peak of -1 dB";
    EXPECT_LE(got[100], 0.25 * 32767 + 1) << "the music, before the impact";
    EXPECT_GT(got[100], 0.15 * 32767);
    sound_->set(1, 3, heard(bake(kShot + "output: {music: " + file + ", audio: none}\n")));
    EXPECT_THAT(last_of(3).reason, HasSubstr("audio: none"));
    const Baked film = bake(kShot + music);
    std::filesystem::remove(file);
    sound_->set(1, 4, heard(film));
    EXPECT_THAT(last_of(4).reason, HasSubstr(file));
}

TEST(HeardFilm, OfSeveralShots_NeedsTheMotionOfAll) {
    const Baked film = bake(kShot);
    SequenceAnswer answer;
    pipeline::Sequence sequence;
    sequence.fps = film.shot->timing.fps;
    for (int i = 0; i < 2; ++i) {
        pipeline::SequencePart part;
        part.frames = 24;
        pipeline::ShotPart shot;
        shot.shot = *film.shot;
        part.content = std::move(shot);
        sequence.parts.push_back(std::move(part));
    }
    answer.sequence = std::make_shared<const pipeline::Sequence>(std::move(sequence));
    answer.timelines = {film.timeline, film.timeline};
    const HeardFilm both = heard_film(answer);
    EXPECT_EQ(both.reason, "");
    EXPECT_EQ(both.samples, 96'000);
    std::vector<double> left(100'000);
    std::vector<double> right(left.size());
    EXPECT_EQ(read_all(*both.make({}), left, right), 96'000U);
    const auto loudest_of = [&](std::size_t first) {
        return *std::max_element(left.begin() + static_cast<std::ptrdiff_t>(first),
                                 left.begin() + static_cast<std::ptrdiff_t>(first) + 48'000);
    };
    EXPECT_GT(loudest_of(0), 0.2);
    EXPECT_NEAR(loudest_of(48'000), loudest_of(0), 0.05);
    answer.timelines[1] = nullptr;
    EXPECT_THAT(heard_film(answer).reason, HasSubstr("long to simulate"));
}

}  // namespace
}  // namespace carom::studio
