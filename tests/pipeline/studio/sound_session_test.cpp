// The sound of the open film in a session.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <variant>

#include "pipeline/config/load_shot.h"
#include "sim/bake.h"
#include "tests/pipeline/studio/session_fixture.h"

namespace carom::studio {
namespace {

using testing::HasSubstr;

constexpr double kRate = 48'000;

/// A ball is struck towards another one. Their contact is loud for the camera, which is near the
/// line of their centres.
std::string shot_with(const std::string& place, const std::string& sound) {
    return "carom: 1\n"
           "table: {kind: cloth}\n"
           "balls: {cue: {at: [0, 0]}, one: {at: [" +
           place +
           ", 0]}}\n"
           "events: [{strike: {ball: cue, at: 0 s, toward: one, speed: 3 m/s}}]\n"
           "cameras: [{video: [0 s, 1 s], scene: [0 s, 1 s], position: [-1.5, -0.5, 0.8], "
           "target: [0, 0, 0]}]\n"
           "render: {size: [640, 360], fps: 24}\n"
           "sound: " +
           sound + "\n";
}

/// When the balls of the shot at a path hit each other, s.
double contact_time(const std::string& path) {
    const pipeline::LoadResult loaded = pipeline::load_shot(path);
    for (const sim::Event& event : sim::bake(loaded.shot->world).events) {
        if (event.kind == sim::EventKind::impact && (event.a == "one" || event.b == "one")) {
            return event.time;
        }
    }
    throw std::runtime_error("the balls do not meet");
}

class SoundSession : public StudioSession {
  protected:
    void open(const std::string& text) {
        write_file(path("shot.yaml"), text);
        start();
    }

    SoundState sound_of(std::int64_t v) {
        return wait_for<SoundState>([v](const SoundState& state) {
            return state.v == v && (!state.reason.empty() || state.ready == state.samples);
        });
    }

    /// The time of the loudest number, s.
    double peak_time(const SoundState& state) {
        const std::optional<Download> piece = session_->find(state.address + "0.pcm");
        EXPECT_TRUE(piece);
        const std::string& bytes = *piece->bytes;
        EXPECT_EQ(bytes.size(), 4 * static_cast<std::size_t>(state.samples));
        int most = 0;
        std::size_t at = 0;
        for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
            const auto value =
                static_cast<std::int16_t>(static_cast<unsigned char>(bytes[i]) |
                                          static_cast<unsigned char>(bytes[i + 1]) << 8);
            if (std::abs(int{value}) > most) {
                most = std::abs(int{value});
                at = i / 4;
            }
        }
        EXPECT_GT(most, 10'000);
        return static_cast<double>(at) / kRate;
    }
};

TEST_F(SoundSession, Peak_IsWhereTheBallsMeet_AlsoAfterAnEdit) {
    open(shot_with("0.3", "{delay: false, room: none}"));
    const double first = contact_time(path("shot.yaml"));
    EXPECT_NEAR(peak_time(sound_of(1)), first, 1.5e-3);

    const std::string edited = shot_with("0.6", "{delay: false, room: none}");
    write_file(path("other.yaml"), edited);
    const double second = contact_time(path("other.yaml"));
    ASSERT_GT(second, first + 0.05);
    say(TextChange{2, path("shot.yaml"), edited});
    const SoundState state = sound_of(2);
    EXPECT_NEAR(peak_time(state), second, 1.5e-3);

    forget();
    say(Hello{kProtocol});  // a page that comes later
    EXPECT_EQ(sound_of(2).address, state.address);
}

TEST_F(SoundSession, SilentFilm_HasAReason) {
    open(shot_with("0.3", "none"));
    EXPECT_THAT(sound_of(1).reason, HasSubstr("'sound: none'"));
}

TEST_F(SoundSession, FilmOfSeveralShots_SoundsInAllParts) {
    write_file(path("shot.yaml"), shot_with("0.3", "{delay: false, room: none}"));
    write_file(path("film.yaml"),
               "carom: 1\nfilm:\n  shots:\n    - {title: A lesson, for: 1 s}\n    - shot.yaml\n");
    SessionOptions all = options();
    all.shot = path("film.yaml");
    start(all);
    const SoundState state = sound_of(1);
    EXPECT_EQ(state.reason, "");
    EXPECT_EQ(state.samples, 96'000);
    EXPECT_NEAR(peak_time(state), 1 + contact_time(path("shot.yaml")), 1.5e-3);
}

}  // namespace
}  // namespace carom::studio
