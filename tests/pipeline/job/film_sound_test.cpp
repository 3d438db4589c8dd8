// The sound of jobs: which samples a film of some frames has, and where they are written.
#include "pipeline/job/film_sound.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/progress.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/shot_sound.h"
#include "tests/pipeline/job/tiny_shot.h"
#include "tests/pipeline/video/click_source.h"
#include "tests/pipeline/video/decoded_sound.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ClickSource;
using carom::testing::decode_sound;
using carom::testing::DecodedSound;
using carom::testing::FakeRenderer;
using carom::testing::make_film_with;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::tiny_timeline;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// The tiny film has twelve frames of 2000 samples.
const std::vector<double> kClicks{0.01, 0.1, 0.2, 0.3, 0.41, 0.49};

/// Films of the tiny shot, with clicks.
struct SoundJob {
    ScratchFolder folder;
    Shot shot = carom::testing::tiny_shot();
    FakeRenderer renderer{shot};
    FilmJobOptions options;
    std::vector<std::string> warnings;
    int made = 0;  // how many sounds

    SoundJob() {
        options.cache_folder = folder.path("cache");
        options.sound = [this](const SoundContext&) {
            ++made;
            return std::make_unique<ClickSource>(kClicks);
        };
    }
    std::string write(const std::string& name, const std::string& frames = {}) {
        options.output = folder.path(name);
        options.frames = frames.empty() ? FrameRange{} : parse_frame_range(frames);
        JobObserver observer;
        observer.on_warning = [this](const std::string& text) { warnings.push_back(text); };
        (void)make_film_with(renderer.function(), shot, tiny_timeline(), options, observer, {});
        return options.output;
    }
};

/// Whether `found` has the clicks' samples of these stretches, one after the other.
void expect_samples(const DecodedSound& found,
                    const std::vector<std::pair<std::int64_t, std::int64_t>>& stretches) {
    const ClickSource source(kClicks);
    for (const bool is_right : {false, true}) {
        const std::vector<double> channel = found.channel(is_right);
        std::vector<double> expected;
        for (const auto& [begin, end] : stretches) {
            for (std::int64_t i = begin; i < end; ++i) {
                expected.push_back(std::nearbyint(source.value(i, is_right ? 1 : 0) * 8388608) /
                                   8388608);
            }
        }
        ASSERT_EQ(channel.size(), expected.size());
        EXPECT_TRUE(channel == expected) << (is_right ? "right" : "left");
    }
}

TEST(FilmSoundJob, WholeFilm_HasTheWholeSound) {
    SoundJob job;
    const DecodedSound found = decode_sound(job.write("film.mkv"));
    EXPECT_EQ(found.codec, "flac");
    EXPECT_EQ(found.picture_times.size(), 12U);
    expect_samples(found, {{0, 24000}});
    EXPECT_EQ(job.made, 1);
    EXPECT_THAT(job.warnings, IsEmpty());
}

TEST(FilmSoundJob, SomeFrames_HaveTheirOwnSound) {
    SoundJob job;
    expect_samples(decode_sound(job.write("part.mkv", "4-8")), {{8000, 18000}});
    expect_samples(decode_sound(job.write("one.mkv", "5")), {{10000, 12000}});
    expect_samples(decode_sound(job.write("cut.mkv", "1-3,8-11")), {{2000, 8000}, {16000, 24000}});
    EXPECT_THAT(job.warnings, IsEmpty());
}

TEST(FilmSoundJob, Chunks_HaveTogetherTheWholeSound) {
    SoundJob job;
    std::vector<double> left;
    for (const char* chunk : {"1/3", "2/3", "3/3"}) {
        job.options.chunk = parse_frame_chunk(chunk);
        const std::vector<double> own = decode_sound(job.write("chunk.mkv")).channel(false);
        EXPECT_EQ(own.size(), 8000U);
        left.insert(left.end(), own.begin(), own.end());
    }
    job.options.chunk = {};
    EXPECT_TRUE(left == decode_sound(job.write("film.mkv")).channel(false));
}

TEST(FilmSoundJob, EveryFifthFrame_IsSilentAndSaysSo) {
    SoundJob job;
    EXPECT_FALSE(decode_sound(job.write("film.mkv", "0-11x5")).has_sound);
    EXPECT_THAT(job.warnings, ElementsAre("the film has no sound, because it leaves out frames "
                                          "between those that it shows"));
    EXPECT_EQ(job.made, 0);
}

TEST(FilmSoundJob, AudioNone_GivesTheBytesOfAFilmWithoutSound) {
    SoundJob job;
    job.shot.output.audio = AudioCodec::none;
    const std::string unwanted = read_text(job.write("a.mkv"));
    job.shot.output.audio = {};
    const std::string with_sound = read_text(job.write("b.mkv"));
    job.options.sound = nullptr;
    job.shot.sound.is_silent = true;
    EXPECT_TRUE(read_text(job.write("c.mkv")) == unwanted);
    EXPECT_FALSE(with_sound == unwanted);
    EXPECT_EQ(job.made, 1);
}

TEST(FilmSoundJob, SoundOfAKilledOrUnstoredJob_IsTheSame) {
    SoundJob job;
    const std::string bytes = read_text(job.write("film.mkv"));
    EXPECT_TRUE(read_text(job.write("again.mkv")) == bytes) << "all frames are stored";
    job.options.no_store = true;
    EXPECT_TRUE(read_text(job.write("unstored.mkv")) == bytes);
    job.options.no_store = false;
    job.options.so_far = true;
    EXPECT_TRUE(read_text(job.write("so_far.mkv")) == bytes);
}

TEST(FilmSoundJob, FilmSoFar_HasTheWholeSound) {
    SoundJob job;
    (void)job.write("part.mkv", "0-3");
    job.options.so_far = true;
    const DecodedSound found = decode_sound(job.write("so_far.mkv"));
    EXPECT_EQ(found.picture_times.size(), 12U);
    expect_samples(found, {{0, 24000}});
}

TEST(FilmSoundJob, Hdr10WithItsPreview_HasTheSoundOnce) {
    SoundJob job;
    job.shot.output.codec = Codec::hevc;
    job.shot.output.hdr10 = Hdr10Settings{1000, 203};
    const DecodedSound found = decode_sound(job.write("film.mkv"));
    EXPECT_EQ(found.picture_times.size(), 12U);
    expect_samples(found, {{0, 24000}});
    EXPECT_EQ(job.made, 1) << "a sound is made only when it is needed";
}

TEST(FilmSoundJob, Mp4WithPoster_HasBoth) {
    SoundJob job;
    job.shot.output.codec = Codec::h264;
    job.shot.render.height = 32;
    job.shot.output.poster = 0.2;
    const DecodedSound found = decode_sound(job.write("film.mp4"));
    EXPECT_EQ(found.codec, "aac");
    for (const double instant : kClicks) {
        EXPECT_NEAR(found.click_near(instant), instant, 1e-3);
    }
    EXPECT_EQ(found.picture_times.size(), 12U);
    EXPECT_THAT(job.folder.names(), Not(Contains("film-poster.jpg")));
}

TEST(FilmSoundJob, ImageSequence_HasTheSoundOfTheWholeFilmBesideIt) {
    SoundJob job;
    (void)job.write("shot.##.png", "4-5");
    EXPECT_THAT(job.folder.names(), Contains("shot.05.png"));
    const DecodedSound found = decode_sound(job.folder.path("shot.wav"));
    EXPECT_EQ(found.codec, "pcm_s24le");
    expect_samples(found, {{0, 24000}});
    job.shot.output.audio = AudioCodec::none;
    (void)job.write("quiet.##.png", "4-5");
    EXPECT_THAT(job.folder.names(), Not(Contains("quiet.wav")));
}

/// Fails, or is stopped, at its first sample.
template <class Failure>
class FailingSource : public SoundSource {
  public:
    explicit FailingSource(Failure failure) : failure_(std::move(failure)) {}
    std::size_t read(std::span<double> /*left*/, std::span<double> /*right*/) override {
        throw failure_;
    }

  private:
    Failure failure_;
};

TEST(FilmSoundJob, SoundThatFails_FailsTheFilmAndLeavesNoFile) {
    for (const char* name : {"film.mkv", "shot.##.png"}) {
        SoundJob job;
        job.options.sound = [](const SoundContext&) {
            return std::make_unique<FailingSource<Error>>(Error("the sound failed"));
        };
        try {
            (void)job.write(name);
            FAIL() << "no error";
        } catch (const Error& error) {
            EXPECT_STREQ(error.what(), "the sound failed");
        }
        EXPECT_THAT(job.folder.names(), Not(Contains("film.mkv")));
        EXPECT_THAT(job.folder.names(), Not(Contains("shot.wav")));
    }
}

TEST(FilmSoundJob, SoundThatIsStopped_StopsTheJob) {
    SoundJob job;
    job.options.sound = [](const SoundContext&) {
        return std::make_unique<FailingSource<Stopped>>(Stopped());
    };
    EXPECT_THROW((void)job.write("film.mkv"), Stopped);
    EXPECT_THAT(job.folder.names(), Not(Contains("film.mkv")));
}

TEST(FilmSoundJob, MusicWithoutOtherSound_IsPlayed) {
    SoundJob job;
    const std::string music = job.write("film.mkv");  // the sound of a film may be music
    SoundJob with_music;
    with_music.options.sound = nullptr;
    with_music.shot.output.music = MusicSettings{music};
    expect_samples(decode_sound(with_music.write("film.mkv", "3-6")), {{6000, 14000}});
}

TEST(FilmSoundJob, MissingMusic_FailsBeforeAnythingIsRendered) {
    SoundJob job;
    job.shot.output.music = MusicSettings{job.folder.path("none.flac")};
    try {
        (void)job.write("film.mkv");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("none.flac': No such file or directory"));
    }
    EXPECT_THAT(job.renderer.rendered(), IsEmpty());
}

/// A ball that falls on the bed once.
TEST(ShotSound, OfAFilm_IsThatOfItsFramesForAnyChunk) {
    SoundJob job;
    sim::Body ball;
    ball.name = "cue";
    ball.shape = sim::Sphere{0.03};
    job.shot.world.bodies = {ball};
    sim::Timeline timeline = tiny_timeline();
    sim::Event event;
    event.time = 0.2;
    event.a = "cue";
    event.b = "cloth";
    event.normal = {0, 0, 1};
    event.normal_impulse = 0.2;
    event.place = {0.2, 0, 0};
    timeline.events.push_back(event);
    job.options.sound = shot_sound(job.shot, timeline, {});
    const std::vector<double> whole = decode_sound(job.write("film.mkv")).channel(false);
    ASSERT_EQ(whole.size(), 24000U);
    const std::vector<double> part = decode_sound(job.write("part.mkv", "3-7")).channel(false);
    EXPECT_TRUE(std::equal(part.begin(), part.end(), whole.begin() + 6000));
    EXPECT_GT(*std::max_element(part.begin(), part.end()), 0.01);

    job.shot.sound.is_silent = true;
    EXPECT_FALSE(shot_sound(job.shot, timeline, {}));
}

TEST(ShotSound, StoppedWhileItIsMade_Throws) {
    const Shot shot = carom::testing::tiny_shot();
    const sim::Timeline timeline = tiny_timeline();
    std::stop_source stop;
    stop.request_stop();
    const SoundMaker make = shot_sound(shot, timeline, stop.get_token());
    std::vector<double> samples(10);
    EXPECT_THROW((void)make({})->read(samples, samples), Stopped);
}

TEST(SoundBytes, FollowTheCodecAndTheFrames) {
    const SoundMaker make = [](const SoundContext&) {
        return std::make_unique<ClickSource>(kClicks);
    };
    const SoundedFilm film{240, Rational(24)};
    std::vector<std::int64_t> second(24);
    std::iota(second.begin(), second.end(), 100);
    OutputSettings output;
    EXPECT_EQ(sound_bytes(make, output, "a.mp4", film, second), 32000);
    EXPECT_EQ(sound_bytes(make, output, "a.webm", film, second), 24000);
    EXPECT_EQ(sound_bytes(make, output, "a.##.png", film, second), 2880000) << "of the whole film";
    EXPECT_EQ(sound_bytes(make, output, "a.mp4", film, {0, 10, 20}), 0);
    EXPECT_EQ(sound_bytes({}, output, "a.mp4", film, second), 0);
    output.audio_bit_rate = 64e3;
    EXPECT_EQ(sound_bytes(make, output, "a.mp4", film, second), 8000);
    output.audio = AudioCodec::pcm;
    EXPECT_EQ(sound_bytes(make, output, "a.mov", film, second), 288000);
    output.audio = AudioCodec::none;
    EXPECT_EQ(sound_bytes(make, output, "a.mov", film, second), 0);
}

TEST(LacksSound, FramesThatFollowEachOther_HaveSound) {
    EXPECT_FALSE(lacks_sound({}));
    EXPECT_FALSE(lacks_sound({7}));
    EXPECT_FALSE(lacks_sound({0, 1, 2, 3}));
    EXPECT_FALSE(lacks_sound({0, 1, 2, 50, 51}));
    EXPECT_TRUE(lacks_sound({0, 2}));
    EXPECT_TRUE(lacks_sound({0, 2, 4, 6}));
}

}  // namespace
}  // namespace carom::pipeline
