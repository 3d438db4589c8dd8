#include "pipeline/picture/values.h"

#include <gtest/gtest.h>

#include "pipeline/picture/contact.h"
#include "pipeline/picture/track_line.h"
#include "tests/pipeline/picture/moving_balls.h"

namespace carom::pipeline {
namespace {

using carom::testing::kRadius;
using carom::testing::two_balls;

std::string shown(const std::string& text, double scene_time) {
    const auto pieces = parse_value_text(text);
    return text_with_values(std::get<std::vector<TextPiece>>(pieces), {42, 3.5, scene_time, 0.125},
                            two_balls());
}

TEST(Values, OfAFrame_AreItsNumberTimesAndSpeed) {
    EXPECT_EQ(shown("{frame} {video_time} {scene_time:.1f} {playback_speed}", 0.25),
              "42 3.500 0.2 0.125");
}

TEST(Values, OfABall_AreItsMotionAtTheSceneTime) {
    EXPECT_EQ(shown("{cue.speed} {cue.direction} {cue.spin} {cue.x} {cue.y:.2f} {cue.z}", 0.25),
              "2.00 0 40.0 -0.500 0.00 0.030");
    EXPECT_EQ(shown("{cue.speed} {cue.direction} {cue.y:.2f}", 0.75), "1.00 270 -0.25");
    EXPECT_EQ(shown("{cue.distance} {one.distance}", 0.75), "1.25 0.25");
}

TEST(Values, OfTwoBalls_AreAngleAndDistance) {
    EXPECT_EQ(shown("{angle cue one}", 0.75), "180");
    EXPECT_EQ(shown("{distance cue one}", 0.5), "0.060");
}

TEST(Values, OfABallAtRest_HaveNoDirection) {
    EXPECT_EQ(shown("{one.direction} {angle cue one} {one.speed}", 0.25), "– – 0.00");
}

TEST(NumberText, ThatRoundsToZero_HasNoSign) {
    EXPECT_EQ(number_text(-0.001, "", ".2f"), "0.00");
    EXPECT_EQ(number_text(-0.0, "", ".2f"), "0.00");
    EXPECT_EQ(number_text(-0.5, ".1f", ".2f"), "-0.5");
}

TEST(FirstContact, Values_AreThoseOfTheNamedObject) {
    const sim::Timeline timeline = two_balls();
    const auto contact = first_contact(timeline, "cue", "one");
    ASSERT_TRUE(contact.has_value());
    EXPECT_EQ(contact->time, 0.5);
    EXPECT_EQ(contact->centre, Vec3(0, 0, kRadius));
    EXPECT_NEAR(contact->velocity.x, 2, 1e-9);
    EXPECT_LT(contact->normal.x, 0);
    EXPECT_GT(first_contact(timeline, "one", "cue")->normal.x, 0);
    EXPECT_FALSE(first_contact(timeline, "cue", "two").has_value());
    EXPECT_FALSE(first_contact(timeline, "two", "cue").has_value());
}

TEST(TrackLine, OfACurve_DeviatesLessThanHalfAMillimetre) {
    sim::Key start, end;
    start.velocity_in = start.velocity_out = {1, 0, 0};
    end.time = 1;
    end.position = {0.5, 0.5, 0};
    end.velocity_in = end.velocity_out = {0, 1, 0};
    const sim::Track track("ball", {start, end});
    const std::vector<LinePoint> line = track_line(track, 0, 1);
    EXPECT_GT(line.size(), 4U);
    EXPECT_LT(line.size(), 40U);
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec3 middle = track.sample(0.5 * (line[i - 1].time + line[i].time)).position;
        const Vec3 along = (line[i].position - line[i - 1].position).normalized();
        const Vec3 off = middle - line[i - 1].position;
        EXPECT_LT((off - off.dot(along) * along).length(), 0.0005);
    }
}

}  // namespace
}  // namespace carom::pipeline
