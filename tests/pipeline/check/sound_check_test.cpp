// Tests of the warnings about sound.
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/check/motion_check.h"
#include "pipeline/sound/film_scene.h"

namespace carom::pipeline {
namespace {

/// A ball that rolls along x from -1 m to 1 m in 2 s, impacts at 0.5 s and 1.5 s, a listener in one
/// place, and a camera that shows the scene from 0 s to 2 s.
struct Film {
    Film() {
        sim::Body ball;
        ball.name = "cue";
        ball.shape = sim::Sphere{0.03};
        ball.pose.position = {-1, 0, 0.03};
        shot.world.bodies = {ball};
        CameraRig rig;
        rig.name = "whole";
        rig.video_end = Rational(2);
        rig.time_map = {Rational(0), Rational(2)};
        shot.cameras = {rig};
        shot.sound.cameras.listener = ListenerPlace{false, {0, -1, 0.5}, {0, 1, 0}};
        timeline.end_time = 2;
        sim::Key start;
        start.position = {-1, 0, 0.03};
        start.velocity_in = start.velocity_out = {1, 0, 0};
        sim::Key end = start;
        end.time = 2;
        end.position = {1, 0, 0.03};
        timeline.tracks.emplace_back("cue", std::vector{start, end});
        for (const double time : {0.5, 1.5}) {
            sim::Event impact;
            impact.time = time;
            impact.a = "cue";
            impact.b = "cushion";
            timeline.events.push_back(impact);
        }
    }

    /// The sentences of the warnings, a line each.
    [[nodiscard]] std::string warnings() const {
        std::string text;
        for (const Problem& problem : sound_problems(shot, nullptr, timeline)) {
            EXPECT_EQ(problem.severity, Severity::warning);
            text += problem.message + "\n";
        }
        return text;
    }

    void show(const Rational& from, const Rational& to) { shot.cameras[0].time_map = {from, to}; }

    Shot shot;
    sim::Timeline timeline;
};

const std::string kNotHeard =
    " not heard, because no camera shows that time: a film has the sound of what it shows, "
    "wherever the listener is\n";

TEST(SoundCheck, FilmThatShowsEverything_HasNoWarning) {
    EXPECT_EQ(Film().warnings(), "");
}

TEST(SoundCheck, UnseenImpacts_AreCounted) {
    Film film;
    film.show(Rational(0), Rational(1));
    EXPECT_EQ(film.warnings(), "the impact at 1.500 s of the scene is" + kNotHeard);
    film.show(Rational(9, 10), Rational(6, 10));  // backwards
    EXPECT_EQ(film.warnings(), "2 impacts from 0.500 s to 1.500 s of the scene are" + kNotHeard);
    CameraRig other = film.shot.cameras[0];
    other.time_map = {Rational(3, 2), Rational(1, 2)};
    film.shot.cameras.push_back(other);
    EXPECT_EQ(film.warnings(), "");
}

TEST(SoundCheck, ListenerWithTheCamera_NeedsNoImpacts) {
    Film film;
    film.show(Rational(0), Rational(1));
    film.shot.sound.cameras.listener->is_camera = true;
    EXPECT_EQ(film.warnings(), "");
    film.shot.sound.cameras.listener.reset();
    EXPECT_EQ(film.warnings(), "");
}

TEST(SoundCheck, BallThatRollsOverTheListener_IsNamedWithItsTime) {
    Film film;
    film.shot.sound.cameras.listener->at = {0.03, 0, 0.03};  // reached by the surface at 1 s
    EXPECT_EQ(film.warnings(), "the listener is inside 'cue' at 1.004 s of the scene\n");
    film.shot.sound.cameras.listener->at = {0.03, 0, 0.0601};  // just above it
    EXPECT_EQ(film.warnings(), "");
    film.shot.cameras[0].sound.listener = ListenerPlace{false, {0.5, 0, 0.03}, {0, 1, 0}};
    EXPECT_EQ(film.warnings(), "the listener is inside 'cue' at 1.471 s of the scene\n");
}

/// The sentences of the warnings about a loudness, a line each.
std::string loudness_warnings(Film& film, double loudness) {
    film.shot.sound.loudness = loudness;
    std::string text;
    const sound::SoundScene scene =
        film_scene(film.shot, film.timeline, 0, frame_count(film.shot.cameras, film.shot.timing));
    for (const Problem& problem : loudness_problems(scene, nullptr)) {
        EXPECT_EQ(problem.severity, Severity::warning);
        text += problem.message + "\n";
    }
    return text;
}

TEST(SoundCheck, LoudnessThatTakesMuchLimiting_IsReportedWithOneThatDoesNot) {
    Film film;
    sim::Body other = film.shot.world.bodies[0];
    other.name = "one";
    film.shot.world.bodies.push_back(other);
    film.shot.cameras[0].position = BezierPath{{{{0, -2, 1}, "", 0}}};
    film.shot.cameras[0].target = BezierPath{{{{0, 0, 0}, "", 0}}};
    for (sim::Event& impact : film.timeline.events) {
        impact.b = "one";
        impact.normal = {0, -1, 0};
        impact.normal_impulse = 0.3;
    }
    const std::string warning = loudness_warnings(film, -16);
    EXPECT_TRUE(std::regex_match(
        warning, std::regex("for -16 LUFS the loudest sounds are turned down by [0-9]+\\.[0-9] dB; "
                            "with more than 12 dB they sound dull, which -[0-9]+ LUFS would "
                            "avoid; a higher 'dynamics' may help\n")))
        << warning;
    const double avoids = std::stod(warning.substr(warning.rfind("which ") + 6));
    EXPECT_LT(avoids, -16);
    EXPECT_EQ(loudness_warnings(film, avoids), "");
    EXPECT_NE(loudness_warnings(film, avoids + 2), "");
    const std::string missed = loudness_warnings(film, -10);
    EXPECT_TRUE(std::regex_match(
        missed,
        std::regex("the film has -1[0-9]\\.[0-9] LUFS instead of -10 LUFS, [0-9]\\.[0-9] LU "
                   "less: its loudest sounds are short .* turned down by 30 dB\\. Ask for " +
                   std::regex_replace(warning.substr(warning.rfind("which ") + 6),
                                      std::regex(" would(.|\n)*"), "") +
                   "; a higher 'dynamics', up to 4, may help, .*\n")))
        << missed;
    film.shot.sound.is_silent = true;
    EXPECT_EQ(loudness_warnings(film, -10), "");
}

TEST(SoundCheck, FixedGainThatIsTooHigh_IsReportedWithOneThatIsNot) {
    Film film;
    film.shot.cameras[0].position = BezierPath{{{{0, -2, 1}, "", 0}}};
    film.shot.cameras[0].target = BezierPath{{{{0, 0, 0}, "", 0}}};
    for (sim::Event& impact : film.timeline.events) {
        impact.normal = {0, -1, 0};
        impact.normal_impulse = 0.3;
    }
    const auto warnings = [&](double full_scale) {
        film.shot.sound.full_scale = full_scale;
        const std::int64_t frames = frame_count(film.shot.cameras, film.shot.timing);
        std::string text;
        for (const Problem& problem :
             loudness_problems(film_scene(film.shot, film.timeline, 0, frames), nullptr)) {
            EXPECT_EQ(problem.severity, Severity::warning);
            text += problem.message + "\n";
        }
        return text;
    };
    const std::string warning = warnings(1e-3);
    EXPECT_TRUE(std::regex_match(
        warning,
        std::regex("with the fixed gain the loudest sounds exceed the highest true peak, -1 dB, so "
                   "they are turned down by [0-9]+\\.[0-9] dB; 'full_scale: [0-9.]+ Pa' avoids "
                   "it\n")))
        << warning;
    EXPECT_EQ(warnings(std::stod(warning.substr(warning.find("full_scale: ") + 12))), "");
}

TEST(SoundCheck, SilentFilm_HasNoWarning) {
    Film film;
    film.show(Rational(0), Rational(1));
    film.shot.sound.is_silent = true;
    EXPECT_EQ(film.warnings(), "");
}

}  // namespace
}  // namespace carom::pipeline
