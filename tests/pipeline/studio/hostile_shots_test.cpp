// Shots that nobody would write by accident: the session answers its pages while it deals with
// them, and says what is wrong.
#include <cstdint>

#include "tests/folders.h"
#include "tests/pipeline/studio/session_fixture.h"

namespace carom::studio {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class StudioHostileShot : public StudioSession {
  protected:
    /// Opens the text as a shot.
    void open(const std::string& text) {
        write_file(path("shot.yaml"), text);
        start();
        expect_answer();
    }

    /// A page that comes while the session works is welcomed, and its texts are taken.
    void expect_answer() {
        for (int i = 0; i < 3; ++i) {
            forget();
            say(Hello{kProtocol});
            const std::lock_guard lock(mutex_);
            ASSERT_FALSE(sent_.empty());  // received() does not wait for work
        }
    }

    /// The first error of the newest text.
    std::string wait_for_error() {
        say(Hello{kProtocol});
        const auto problems = wait_for<Problems>(
            [](const Problems& all) { return all.complete && !all.list.empty(); });
        return problems.list.front().message;
    }

    /// The session still answers another text after all that.
    void expect_recovery() {
        forget();
        say(TextChange{100, path("shot.yaml"),
                       read_file(CAROM_SOURCE_DIR "/examples/bank_shot.yaml")});
        wait_for<ShotState>([](const ShotState& state) { return state.v == 100; });
        wait_for<Problems>([](const Problems& all) { return all.v == 100 && all.complete; });
    }
};

TEST_F(StudioHostileShot, HugeMesh_IsNotRead) {
    write_file(path("huge.obj"), "v 0 0 0\n");
    fs::resize_file(path("huge.obj"), std::uintmax_t{8} << 30U);  // a file with a hole
    open("carom: 1\nobjects: {huge: {mesh: huge.obj, at: [0, 0, 1]}}\n");
    EXPECT_THAT(
        wait_for_error(),
        HasSubstr("file 'huge.obj' has more than 128 MiB, which is too much to read again"));
    expect_recovery();
}

TEST_F(StudioHostileShot, TextWithManyAliases_IsRefused) {
    std::string text = "carom: 1\na0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
    for (int i = 1; i < 20; ++i) {
        const std::string last = "*a" + std::to_string(i - 1);
        text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
        for (int k = 0; k < 10; ++k) {
            text += (k > 0 ? ", " : "") + last;
        }
        text += "]\n";
    }
    open(text);
    EXPECT_THAT(wait_for_error(), HasSubstr("250000"));
    expect_recovery();
}

TEST_F(StudioHostileShot, DeepText_IsRefused) {
    open("carom: 1\nballs: " + std::string(100'000, '[') + "\n");
    EXPECT_FALSE(wait_for_error().empty());
    expect_recovery();
}

TEST_F(StudioHostileShot, HundredThousandBalls_AreRefused) {
    std::string text = "carom: 1\nballs:\n";
    for (int i = 0; i < 100'000; ++i) {
        text += "  b" + std::to_string(i) + ": {at: [" + std::to_string(i % 300) + ", " +
                std::to_string(i / 300) + "]}\n";
    }
    open(text);
    EXPECT_THAT(wait_for_error(), HasSubstr("CAROM_LIMITS"));
    expect_recovery();
}

TEST_F(StudioHostileShot, LongMotion_IsShownAtRestAndStoppedByTheNextText) {
    // Sixty balls that lose no energy for a thousand seconds.
    std::string balls;
    for (int i = 0; i < 60; ++i) {
        balls += "  b" + std::to_string(i) + ": {at: [" + std::to_string(i % 12 * 0.2 - 1.1) +
                 ", " + std::to_string(i / 12 * 0.2 - 0.4) + "], velocity: [" +
                 std::to_string(3 + i % 5) + ", " + std::to_string(2 + i % 7) + ", 0]}\n";
    }
    open(
        "carom: 1\ninclude: [tables/carom_10ft.yaml, looks/studio.yaml]\n"
        "simulation: {duration: 1000 s}\n"
        "physics:\n"
        "  ball_cloth: {sliding_friction: 0, rolling_friction: 0, spinning_friction: 0}\n"
        "  ball_cushion: {model: mirror, mirror: {restitution: 1}}\n"
        "  ball_ball: {restitution: 1, friction: 0}\n"
        "balls:\n" +
        balls);
    say(Hello{kProtocol});
    const auto shown = wait_for<ShotState>();
    EXPECT_FALSE(shown.objects.empty());
    wait_for<Work>([](const Work& work) { return work.what == "bake"; });
    expect_answer();
    expect_recovery();
}

TEST_F(StudioHostileShot, HugePicture_NeedsNoMemoryUntilItIsAskedFor) {
    open(
        "carom: 1\ninclude: [tables/pool_9ft.yaml, balls/pool.yaml, looks/studio.yaml]\n"
        "render: {size: [16384, 16384]}\nballs: {cue: {at: [0, 0]}}\n");
    say(Hello{kProtocol});
    const auto shot = wait_for<ShotState>();
    EXPECT_EQ(shot.film.width, 16384);
    wait_for<Problems>([](const Problems& all) { return all.complete; });
    expect_recovery();
}

}  // namespace
}  // namespace carom::studio
