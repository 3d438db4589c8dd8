#include "sim/timeline/bake_file.h"

#include <filesystem>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bake_helpers.h"
#include "core/error.h"
#include "sim/timeline/event_fields.h"
#include "sim/timeline/track_fields.h"
#include "tests/core/field_changes.h"

namespace carom {

constexpr auto fields_of(Describes<Hash128>) {
    return fields<Hash128>(field("high", &Hash128::high), field("low", &Hash128::low));
}

constexpr auto fields_of(Describes<Subject>) {
    return fields<Subject>(field("kind", &Subject::kind), field("name", &Subject::name),
                           field("index", &Subject::index));
}

constexpr auto fields_of(Describes<Diagnostic>) {
    using T = Diagnostic;
    return fields<T>(field("subject", &T::subject), field("field", &T::field),
                     field("sentence", &T::sentence),
                     unhashed("severity", &T::severity, "a bake has warnings only"));
}

}  // namespace carom

namespace carom::sim {

constexpr auto fields_of(Describes<Asset>) {
    return fields<Asset>(field("path", &Asset::path), field("content_hash", &Asset::content_hash));
}

namespace {

namespace fs = std::filesystem;

TEST(BakeFile, RoundTrip_IsEqualBitForBit) {
    const Bake bake = test::small_bake();
    const std::vector<std::byte> bytes = encode_bake(bake);
    const Bake again = decode_bake(bytes, "memory");
    EXPECT_EQ(again, bake);
    EXPECT_EQ(encode_bake(again), bytes);
}

/// A bake with one element of each kind; all times may be shifted by a second.
Bake one_of_each() {
    Bake bake;
    Timeline& timeline = bake.timeline;
    timeline.end_time = 5;
    timeline.tracks.emplace_back("cue", std::vector<Key>(1));
    timeline.events.push_back({EventKind::impact, 0, 5, "cue", "one"});
    timeline.lasting_contacts.push_back({"cue", "one", 0, 5, 1, 1});
    timeline.put_backs.push_back({"cue", 0, {0, 0, 0}, {0, 0, 0}});
    timeline.warnings.push_back({{}, "tip", "the tip misses", Severity::warning});
    timeline.energy.emplace_back();
    bake.assets.push_back({"/shade.obj", {1, 2}});
    return bake;
}

TEST(BakeFile, RoundTrip_KeepsEveryField) {
    Bake bake = one_of_each();
    const std::vector<std::byte> before = encode_bake(bake);
    std::size_t count = 0;
    carom::test::FieldChanges changes([&](const std::string& place, bool is_kept) {
        const std::vector<std::byte> bytes = is_kept ? encode_bake(bake) : before;
        EXPECT_EQ(bytes != before, is_kept) << place;
        EXPECT_TRUE(!is_kept || decode_bake(bytes, "memory") == bake) << place;
        ++count;
    });
    changes.of(bake.physics_hash, "physics_hash");
    changes.of(bake.shot_text, "shot_text");
    changes.of(bake.assets[0], "asset");
    changes.of(bake.timeline.start_time, "start_time");
    changes.of(bake.timeline.end_time, "end_time");
    changes.of(bake.timeline.events[0], "event");
    changes.of(bake.timeline.lasting_contacts[0], "contact");
    changes.of(bake.timeline.put_backs[0], "put_back");
    changes.of(bake.timeline.warnings[0], "warning");
    changes.of(bake.timeline.energy[0], "energy");
    EXPECT_EQ(count, 2U + 1 + 3 + 2 + (7 + 9) + 6 + (2 + 6) + 6 + 4);
}

TEST(BakeFile, RoundTrip_KeepsEveryFieldOfAKey) {
    Key key;
    key.orientation = {0.6, 0.8, 0, 0};
    const auto bake = [&key] {
        Key unit = key;
        unit.orientation.normalize();
        Bake result = one_of_each();
        result.timeline.tracks = {Track("cue", {unit})};
        return result;
    };
    const Bake before = bake();
    carom::test::FieldChanges([&](const std::string& place, bool) {
        EXPECT_NE(bake(), before) << place;
        EXPECT_EQ(decode_bake(encode_bake(bake()), "memory"), bake()) << place;
    }).of(key);
}

TEST(BakeFile, RoundTrip_KeepsNegativeZeroAndDenormals) {
    Bake bake;
    Key key;
    key.position = {-0.0, std::numeric_limits<double>::denorm_min(), -1e12};
    bake.timeline.tracks.emplace_back("ball", std::vector<Key>{key});
    const Bake again = decode_bake(encode_bake(bake), "memory");
    const Vec3 position = again.timeline.tracks[0].keys()[0].position;
    EXPECT_TRUE(std::signbit(position.x));
    EXPECT_EQ(position.y, std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(position.z, -1e12);
}

TEST(BakeFile, EmptyBake_RoundTrips) {
    EXPECT_EQ(decode_bake(encode_bake(Bake{}), "memory"), Bake{});
}

TEST(BakeFile, LargeBake_RoundTrips) {
    Bake bake;
    for (std::uint64_t ball = 0; ball < 16; ++ball) {
        const Track track = test::random_track(ball, 500);
        bake.timeline.tracks.emplace_back(
            "ball_" + std::to_string(ball),
            std::vector<Key>(track.keys().begin(), track.keys().end()));
    }
    for (int index = 0; index < 5000; ++index) {
        bake.timeline.events.push_back(
            {EventKind::impact, index * 0.01, index * 0.01, "ball_1", "cushion"});
    }
    EXPECT_EQ(decode_bake(encode_bake(bake), "memory"), bake);
}

TEST(BakeFile, SameBake_GivesTheSameBytes) {
    EXPECT_EQ(encode_bake(test::small_bake()), encode_bake(test::small_bake()));
}

TEST(BakeFile, Bytes_BeginWithTheFileIdentifier) {
    const auto bytes = encode_bake(test::small_bake());
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(bytes.data()) + 4, 4), "CBAK");
}

// Every compiler and build writes the same bytes. A change here is a change of the format: increase
// kSchemaVersion if old readers would misunderstand it.
TEST(BakeFile, Bytes_ArePinned) {
    EXPECT_EQ(hash_bytes(encode_bake(test::small_bake())).to_string(),
              "d8f3cda71c4c0b21d7959a67317f4a5e");
}

TEST(BakeFile, UnalignedBuffer_IsRead) {
    const auto bytes = encode_bake(test::small_bake());
    for (std::size_t shift = 1; shift < 8; ++shift) {
        std::vector<std::byte> shifted(shift);
        shifted.insert(shifted.end(), bytes.begin(), bytes.end());
        EXPECT_EQ(decode_bake(std::span(shifted).subspan(shift), "memory"), test::small_bake());
    }
}

struct BadBake {
    const char* name;
    void (*spoil)(Bake&);
    const char* problem;
};

class BakeRefusal : public testing::TestWithParam<BadBake> {};

// A bake that could not be read again is not written.
TEST_P(BakeRefusal, BadBake_IsNotWritten) {
    Bake bake = test::small_bake();
    GetParam().spoil(bake);
    EXPECT_THAT([&] { (void)encode_bake(bake); },
                testing::ThrowsMessage<Error>("the bake cannot be written: " +
                                              std::string(GetParam().problem)));
}

INSTANTIATE_TEST_SUITE_P(
    Bakes, BakeRefusal,
    testing::Values(
        BadBake{"far_away",
                [](Bake& b) {
                    Key key;
                    key.position.x = 1e13;
                    b.timeline.tracks.emplace_back("far", std::vector<Key>{key});
                },
                "track 'far', key 0: a value is larger than 1e12"},
        BadBake{"jump",
                [](Bake& b) {
                    std::vector<Key> keys(2);
                    keys[1].time = 1e-200;
                    keys[1].position.x = 1;
                    b.timeline.tracks.emplace_back("jumper", keys);
                },
                "track 'jumper', key 1: its position is too far from that of the previous key "
                "for the time between them"},
        BadBake{"endless", [](Bake& b) { b.timeline.end_time = HUGE_VAL; },
                "its start or end time is not finite"},
        BadBake{"backwards", [](Bake& b) { b.timeline.end_time = -1; }, "it ends before it starts"},
        BadBake{"nameless_track",
                [](Bake& b) { b.timeline.tracks.emplace_back("", std::vector<Key>(1)); },
                "a track has no name"},
        BadBake{"twins", [](Bake& b) { b.timeline.tracks.push_back(b.timeline.tracks[0]); },
                "two tracks have the name 'cue'"},
        BadBake{"long_name",
                [](Bake& b) {
                    b.timeline.tracks.emplace_back(std::string(1025, 'a'), std::vector<Key>(1));
                },
                "the name of a track is longer than 1024 bytes"},
        BadBake{
            "event_order",
            [](Bake& b) { b.timeline.events[0].time = 1.5, b.timeline.events[0].end_time = 1.5; },
            "event 1 is earlier than the previous one"},
        BadBake{"event_end", [](Bake& b) { b.timeline.events[0].end_time = 0.25; },
                "event 0 ends before it begins"},
        BadBake{"event_nan", [](Bake& b) { b.timeline.events[1].normal.y = std::nan(""); },
                "event 1 has a value that is not finite"},
        BadBake{"event_kind",
                [](Bake& b) { b.timeline.events[2].kind = static_cast<EventKind>(15); },
                "event 2 is of an unknown kind"},
        BadBake{"event_name", [](Bake& b) { b.timeline.events[2].b = std::string(1025, 'a'); },
                "event 2 has a name of more than 1024 bytes"},
        BadBake{"energy_order", [](Bake& b) { b.timeline.energy[2].time = 0.25; },
                "energy sample 2 is earlier than the previous one"},
        BadBake{"energy_nan", [](Bake& b) { b.timeline.energy[0].kinetic = std::nan(""); },
                "energy sample 0 has a value that is not finite"},
        BadBake{"contact_order", [](Bake& b) { b.timeline.lasting_contacts[1].from = 0; },
                "lasting contact 1 is earlier than the previous one"},
        BadBake{"contact_nan", [](Bake& b) { b.timeline.lasting_contacts[0].slip = std::nan(""); },
                "lasting contact 0 has a value that is not finite"},
        BadBake{"contact_name",
                [](Bake& b) { b.timeline.lasting_contacts[0].a = std::string(1025, 'a'); },
                "lasting contact 0 has a name of more than 1024 bytes"},
        BadBake{"put_back_order",
                [](Bake& b) {
                    b.timeline.put_backs.push_back(b.timeline.put_backs[0]);
                    b.timeline.put_backs[1].time = 1;
                },
                "ball put back 1 is earlier than the previous one"},
        BadBake{"put_back_name",
                [](Bake& b) { b.timeline.put_backs[0].ball = std::string(1025, 'a'); },
                "ball put back 0 has a name of more than 1024 bytes"},
        BadBake{
            "warning_subject",
            [](Bake& b) { b.timeline.warnings[1].subject.kind = static_cast<Subject::Kind>(9); },
            "warning 1 is about a subject of an unknown kind"},
        BadBake{"warning_name",
                [](Bake& b) { b.timeline.warnings[1].subject.name = std::string(1025, 'a'); },
                "warning 1 has a subject with a name of more than 1024 bytes"},
        BadBake{"silent_warning", [](Bake& b) { b.timeline.warnings[0].sentence.clear(); },
                "warning 0 has no sentence, or one of more than 16384 bytes"},
        BadBake{"error_among_warnings",
                [](Bake& b) { b.timeline.warnings[2].severity = Severity::error; },
                "warning 2 has the severity of an error"},
        BadBake{"many_warnings",
                [](Bake& b) { b.timeline.warnings.resize(1025, b.timeline.warnings[0]); },
                "it has more than 1024 warnings"},
        BadBake{"asset_path", [](Bake& b) { b.assets[0].path = std::string(4097, 'a'); },
                "the path of an asset is longer than 4096 bytes"}),
    [](const auto& instance) { return instance.param.name; });

class BakeOnDisk : public testing::Test {
  protected:
    BakeOnDisk() { fs::create_directories(folder_); }
    ~BakeOnDisk() override { fs::remove_all(folder_); }

    [[nodiscard]] std::string path(const char* name) const { return (folder_ / name).string(); }

    fs::path folder_ = fs::path(testing::TempDir()) /
                       (std::string("carom_bake_") +
                        testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(BakeOnDisk, RoundTrip_IsEqualBitForBit) {
    const Bake bake = test::small_bake();
    write_bake(bake, path("shot.bake"));
    EXPECT_EQ(read_bake(path("shot.bake")), bake);
    EXPECT_EQ(fs::file_size(path("shot.bake")), encode_bake(bake).size());
}

TEST_F(BakeOnDisk, MissingFile_IsNamed) {
    EXPECT_THAT([&] { (void)read_bake(path("no.bake")); },
                testing::ThrowsMessage<Error>("cannot read '" + path("no.bake") +
                                              "': No such file or directory"));
}

TEST_F(BakeOnDisk, Folder_IsRefused) {
    EXPECT_THAT(
        [&] { (void)read_bake(folder_.string()); },
        testing::ThrowsMessage<Error>("cannot read '" + folder_.string() + "': Is a directory"));
}

TEST_F(BakeOnDisk, ForeignFile_HasItsOwnMessage) {
    std::ofstream(path("shot.yaml")) << "carom: 1\nballs: {cue: {at: [0, 0]}}\n";
    std::ofstream(path("empty")) << "";
    std::ofstream(path("huge")) << "x";
    fs::resize_file(path("huge"), std::uintmax_t{1} << 40);  // sparse
    for (const char* name : {"shot.yaml", "empty", "huge"}) {
        EXPECT_THAT([&] { (void)read_bake(path(name)); },
                    testing::ThrowsMessage<Error>("'" + path(name) + "' is not a carom bake"));
    }
    EXPECT_THAT([] { (void)read_bake("/dev/null"); },
                testing::ThrowsMessage<Error>("'/dev/null' is not a carom bake"));
}

}  // namespace
}  // namespace carom::sim
