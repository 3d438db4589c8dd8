#include "pipeline/import/import_track.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "pipeline/config/load_shot.h"
#include "pipeline/export/timeline_csv.h"
#include "pipeline/shot/keyed_motion.h"
#include "sim/bake.h"
#include "sim/timeline/rotation.h"

namespace carom::pipeline {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr double kPi = std::numbers::pi;

ImportTrackOptions named(double error = 1e-5) {
    ImportTrackOptions options;
    options.name = "hand";
    options.error = error;
    return options;
}

/// The track of a shot that includes the result.
sim::Track track_of(const std::string& csv, const ImportTrackOptions& options = named()) {
    const ImportTrackResult result = import_track(csv, "t.csv", options);
    for (const Problem& problem : result.problems) {
        ADD_FAILURE() << format(problem);
    }
    const LoadResult loaded =
        load_shot_text(result.yaml +
                           "    box: [0.1, 0.2, 0.3]\ntable: {kind: cloth}\ncameras: [{name: c, "
                           "video: [0 s, 1 s], "
                           "scene: 0 s, position: [0, -1, 1], target: [0, 0, 0]}]\n",
                       "shot.yaml");
    for (const Problem& problem : loaded.problems) {
        ADD_FAILURE() << format(problem) << result.yaml;
    }
    return loaded.shot.value().keyed.at(0);
}

std::vector<std::string> problems_of(const std::string& csv,
                                     const ImportTrackOptions& options = {}) {
    const ImportTrackResult result = import_track(csv, "t.csv", options);
    EXPECT_EQ(result.yaml, "");
    std::vector<std::string> lines;
    for (const Problem& problem : result.problems) {
        const std::string text = format(problem);
        lines.push_back(text.substr(0, text.find('\n')));
    }
    return lines;
}

TEST(ImportTrack, PositionsAlone_AreKeysOfASmoothMotion) {
    const ImportTrackResult result =
        import_track("time,x,y,z\n0,0,0,0\n0.5,1,0,0\n2,1,0,0.25\n", "folder/t.csv");
    EXPECT_THAT(result.problems, IsEmpty());
    EXPECT_EQ(result.yaml,
              "# Made by carom import-track from t.csv: 3 keys for 3 rows.\n"
              "# Insert this below an object of a shot, with the indentation of its other keys.\n"
              "motion:\n"
              "  keys:\n"
              "    - {at: 0, position: [0, 0, 0]}\n"
              "    - {at: 0.5, position: [1, 0, 0]}\n"
              "    - {at: 2, position: [1, 0, 0.25]}\n");
}

TEST(ImportTrack, Columns_CanHaveAnyOrderAndCase) {
    const ImportTrackResult result = import_track(
        "\xef\xbb\xbf# a comment\r\n Z ; Time;\"x\";Y\r\n\r\n3;0;1;2\r\n6;1;4;5\r\n", "t.csv");
    EXPECT_THAT(result.problems, IsEmpty());
    EXPECT_THAT(result.yaml, HasSubstr("{at: 0, position: [1, 2, 3]}"));
    EXPECT_THAT(result.yaml, HasSubstr("{at: 1, position: [4, 5, 6]}"));
}

TEST(ImportTrack, DecimalCommas_AreRead) {
    const std::string keys =
        import_track("time,x,y,z\n0,0,0,0\n1,0.5,0.25,-1.5e-1\n2,1,3,1.125\n", "t.csv").yaml;
    for (const char* csv :
         {"time;x;y;z\n0;0;0;0\n1;0,5;0,25;-1,5e-1\n2;1;3;1,125\n",
          "time\tx\ty\tz\r\n0\t0\t0\t0\r\n1\t0,5\t0,25\t-1,5e-1\r\n2\t1\t3\t1,125\r\n",
          "\"time\",\"x\",\"y\",\"z\"\n0,0,0,0\n1,\"0,5\",\"0,25\",\"-1,5e-1\"\n2,1,3,\"1,125\"\n",
          "sep=;\ntime;x;y;z\n0;0;0;0\n1;\"0,5\";0,25;-1,5e-1\n2;1;3;1,125\n",
          "time;x;y;z\r0;0;0;0\r1;0,5;0,25;-1,5e-1\r2;1;3;1,125\r"}) {
        const ImportTrackResult result = import_track(csv, "t.csv");
        EXPECT_THAT(result.problems, IsEmpty()) << csv;
        EXPECT_EQ(result.yaml, keys) << csv;
    }
}

TEST(ImportTrack, ThousandsSeparators_AreRefused) {
    const auto refused = [](const std::string& cell) {
        return "t.csv:3:3: error: 'x' must be a number without thousands separators, not '" + cell +
               "'";
    };
    for (const char* cell : {"1.234,5", "1 234,5", "1'234", "1.234.567",
                             "1\xc2\xa0"
                             "234"}) {
        EXPECT_THAT(problems_of("time;x;y;z\n0;0;0;0\n1;" + std::string(cell) + ";0;0\n"),
                    ElementsAre(refused(cell)));
    }
    EXPECT_THAT(problems_of("time,x,y,z\n0,0,0,0\n1,\"1,234\",0,0\n"),
                ElementsAre("t.csv:3:3: error: 'x' must be a number without thousands separators, "
                            "not '1,234'"));
    EXPECT_THAT(
        problems_of("time;x;y;z\n0;0,5;0;0\n1;1.234;0;0\n"),
        ElementsAre("t.csv:3:3: error: 'x' has a point in '1.234', but numbers of this table "
                    "have decimal commas (line 2)"));
    EXPECT_THAT(problems_of("time,x,y,z\n0,0,5,0,0\n1,0,0,0\n"),
                ElementsAre("t.csv:2:1: error: this row has 5 values, but the table has 4 columns; "
                            "if its numbers have decimal commas, separate the columns with "
                            "semicolons"));
}

TEST(ImportTrack, Angles_RotateLikeTheRotateOfAnObject) {
    const sim::Track track = track_of("time,x,y,z,rx,ry,rz\n0,0,0,0,0,0,0\n1,0,0,0,20,30,40\n");
    const auto about = [](const Vec3& axis, double degrees) {
        return sim::rotation_from_vector(degrees * kPi / 180 * axis);
    };
    const Quat expected = about({0, 0, 1}, 40) * about({0, 1, 0}, 30) * about({1, 0, 0}, 20);
    EXPECT_LT(sim::angle_between(track.sample(1).orientation, expected), 1e-8);
}

TEST(ImportTrack, SingleAngleOfSeveralTurns_KeepsItsTurns) {
    // Two turns about the vertical axis in a second, at constant speed.
    ImportTrackOptions options = named();
    options.is_linear = true;
    const sim::Track track =
        track_of("time,x,y,z,rx,ry,rz\n0,0,0,0,0,30,0\n1,0,0,0,0,30,720\n", options);
    EXPECT_NEAR(track.sample(0.5).angular_velocity.z, 4 * kPi, 1e-6);
    const std::vector<std::string> problems =
        problems_of("time,x,y,z,rx,ry,rz\n0,0,0,0,0,30,0\n1,0,0,0,300,30,720\n");
    EXPECT_THAT(problems,
                ElementsAre(HasSubstr(
                    "t.csv:3:1: error: the object turns by more than 180 degrees since")));
}

TEST(ImportTrack, MoreTurnsThanAKeyMayHave_AreSplitOrRefused) {
    ImportTrackOptions options = named();
    options.is_linear = true;
    // 90 turns from row to row: one key must not span both intervals.
    const sim::Track track = track_of(
        "time,x,y,z,rx,ry,rz\n0,0,0,0,0,0,0\n1,0,0,0,0,0,32400\n2,0,0,0,0,0,64800\n", options);
    EXPECT_NEAR(track.sample(1.5).angular_velocity.z, 180 * kPi, 1e-6);
    EXPECT_THAT(
        problems_of("time,x,y,z,rx,ry,rz\n0,0,0,0,0,0,0\n1,0,0,0,0,0,36001\n"),
        ElementsAre(HasSubstr("t.csv:3:1: error: the object makes more than 100 turns since")));
}

TEST(ImportTrack, FastTurns_FollowFromTheAngularVelocity) {
    // 1.25 turns between rows; the quaternions alone would give a quarter turn.
    const std::string csv =
        "time,x,y,z,qw,qx,qy,qz,wx,wy,wz\n"
        "0,0,0,0,1,0,0,0,0,0,7.8539816\n"
        "1,0,0,0,0.70710678,0,0,0.70710678,0,0,7.8539816\n"
        "2,0,0,0,0,0,0,1,0,0,7.8539816\n";
    ImportTrackOptions options = named();
    options.is_linear = true;
    const sim::Track track = track_of(csv, options);
    EXPECT_NEAR(track.sample(0.5).angular_velocity.z, 2.5 * kPi, 1e-5);
    EXPECT_NEAR(track.sample(1.5).angular_velocity.z, 2.5 * kPi, 1e-5);
}

/// A ball that is struck, hits another one and comes to rest.
sim::Timeline struck() {
    const LoadResult loaded = load_shot_text(
        "carom: 1\nsimulation: {duration: 3 s}\ntable: {kind: cloth}\n"
        "balls: {cue: {at: [-0.3, 0]}, one: {at: [0.1, 0.01]}}\n"
        "events: [{strike: {ball: cue, at: 0.1 s, toward: one, speed: 2, tip: [0.3, 0.2]}}]\n"
        "cameras: [{name: c, video: [0 s, 1 s], scene: 0 s, position: [0, -1, 1], target: [0, 0, "
        "0]}]\n",
        "shot.yaml");
    return sim::bake(loaded.shot.value().world);
}

TEST(ImportTrack, SampledExport_IsFollowedWithinTheError) {
    const sim::Timeline timeline = struck();
    const std::string csv = samples_to_csv(timeline, 200);
    ImportTrackOptions options = named();
    for (const std::string object : {"cue", "one"}) {
        options.object = object;
        const sim::Track track = track_of(csv, options);
        for (int n = 0; n <= 600; ++n) {
            const MotionState exact = timeline.find(object)->sample(n / 200.0);
            const MotionState got = track.sample(n / 200.0);
            ASSERT_LT((got.position - exact.position).length(), 1.1e-5) << object << " " << n;
            ASSERT_LT(sim::angle_between(got.orientation, exact.orientation), 2.2e-4) << n;
        }
        EXPECT_LT(import_track(csv, "t.csv", options).keys, 400U);
    }
}

TEST(ImportTrack, ExportOfKeys_KeepsItsVelocityJumps) {
    const sim::Timeline timeline = struck();
    ImportTrackOptions options = named();
    options.object = "cue";
    const sim::Track track = track_of(keys_to_csv(timeline), options);
    for (const sim::Key& key : timeline.find("cue")->keys()) {
        const MotionState got = track.sample(key.time);
        EXPECT_LT((got.position - key.position).length(), 1e-7);
        if (key.is_break()) {
            EXPECT_LT((got.velocity - key.velocity_in).length(), 1e-6);
            EXPECT_LT((track.sample(key.time + 2e-6).velocity - key.velocity_out).length(), 1e-3);
        }
    }
    // The positions between the keys agree too, because the Hermite curves are the same.
    for (int n = 0; n <= 3000; ++n) {
        const double time = n / 1000.0;
        ASSERT_LT(
            (track.sample(time).position - timeline.find("cue")->sample(time).position).length(),
            1e-5);
    }
}

TEST(ImportTrack, ErrorOfZero_KeepsEveryRow) {
    std::string csv = "time,x,y,z\n";
    for (int n = 0; n < 100; ++n) {
        csv += std::to_string(n * 0.01) + ",0,0," + std::to_string(n * 0.01) + "\n";
    }
    EXPECT_LT(import_track(csv, "t.csv", named()).keys, 20U);
    EXPECT_EQ(import_track(csv, "t.csv", named(0)).keys, 100U);
}

TEST(ImportTrack, TooManyKeys_AreRefused) {
    std::string csv = "time,x,y,z\n";
    for (int n = 0; n < 1200; ++n) {
        csv += std::to_string(n * 0.01) + "," + std::to_string(n % 2) + ",0,0\n";
    }
    EXPECT_THAT(
        problems_of(csv, named()),
        ElementsAre(HasSubstr("the motion needs more than 1000 keys to follow all rows "
                              "within 0.01 mm: allow a larger --error, or give fewer rows")));
}

TEST(ImportTrack, WrongHeaders_AreReportedCompletely) {
    EXPECT_THAT(problems_of(""),
                ElementsAre("t.csv:1:1: error: the table is empty: it needs a first "
                            "line that names its columns, and one line for each time"));
    EXPECT_THAT(problems_of("tme,x,y,qw,x\n0,0,0,1,0\n"),
                ElementsAre("t.csv:1:1: error: column 'time' is missing",
                            "t.csv:1:1: error: column 'z' is missing",
                            "t.csv:1:1: error: columns 'qx', 'qy' and 'qz' are missing",
                            "t.csv:1:1: warning: column 'tme' is not used (did you mean 'time'?)",
                            "t.csv:1:12: error: column 'x' is given twice"));
    EXPECT_THAT(
        problems_of("0,1,2,3\n1,1,2,3\n"),
        ::testing::Contains(StartsWith("t.csv:1:1: error: '0' is a number, but the first line")));
    EXPECT_THAT(problems_of("time,x,y,z,qw,qx,qy,qz,rx,ry,rz\n"),
                ElementsAre(HasSubstr(
                    "t.csv:1:24: error: give either 'rx, ry, rz' or 'qw, qx, qy, qz', not both")));
}

TEST(ImportTrack, WrongRows_AreReportedCompletely) {
    EXPECT_THAT(problems_of("time,x,y,z,qw,qx,qy,qz\n"
                            "0,0,0,0,1,0,0,0\n"
                            "0.1,a,,0,1,0,0,0\n"
                            "0.2,0,0\n"
                            "0.3,0,0,0,0.5,0,0,0\n"
                            "-1,1e9,0,0,1,0,0,nan\n"
                            "0.4,0,0,0,1,0,0,0\n"
                            "0.4,0,0,0,1,0,0,0\n"),
                ElementsAre("t.csv:3:5: error: 'x' must be a number, not 'a'",
                            "t.csv:3:7: error: 'y' has no value",
                            "t.csv:4:1: error: this row has 3 values, but the table has 8 columns",
                            "t.csv:5:11: error: the quaternion qw, qx, qy, qz has length 0.5, but "
                            "must have length 1",
                            "t.csv:6:1: error: 'time' must lie between 0 and 3600 s",
                            "t.csv:6:4: error: 'x' must lie between -100000 and 100000 m",
                            "t.csv:6:18: error: 'qz' must be a number, not 'nan'",
                            "t.csv:8:1: error: time 0.4 s is not later than the 0.4 s of line 7"));
}

TEST(ImportTrack, SeveralObjects_NeedAChoice) {
    const std::string csv = "object,time,x,y,z\ncue,0,0,0,0\none,0,1,0,0\ncue,1,0,0,0\n";
    EXPECT_THAT(problems_of(csv), ElementsAre("t.csv:1:1: error: the table has several objects; "
                                              "choose one with --object: cue or one"));
    ImportTrackOptions options;
    options.object = "que";
    EXPECT_THAT(problems_of(csv, options),
                ElementsAre("t.csv:1:1: error: the table has no object 'que' (did you mean "
                            "'cue'?)"));
    options.object = "one";
    EXPECT_THAT(problems_of(csv, options),
                ElementsAre(HasSubstr("the table needs at least two rows for a motion")));
    EXPECT_THAT(
        problems_of("time,x,y,z\n0,0,0,0\n", options),
        ElementsAre(HasSubstr("cannot select object 'one': the table has no column 'object'")));
}

TEST(ImportTrack, UnreadableFiles_AreReported) {
    const ImportTrackResult result = import_track_file("none/t.csv");
    ASSERT_EQ(result.problems.size(), 1U);
    EXPECT_THAT(format(result.problems[0]), StartsWith("none/t.csv: error: this file "));
}

}  // namespace
}  // namespace carom::pipeline
