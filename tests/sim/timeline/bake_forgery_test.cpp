// Forged files, with a valid hash but invalid content.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bake_generated.h"
#include "bake_helpers.h"
#include "core/error.h"
#include "sim/timeline/bake_format.h"
#include "tests/folders.h"

namespace carom::sim {
namespace {

namespace fb = carom::bake_format;
using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

std::string refusal_of_content(std::span<const std::byte> content) {
    try {
        (void)decode_bake(encode_envelope(content), "shot.bake");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// A small bake's content, changed in place through the generated accessors.
std::string refusal_after(const std::function<void(fb::Content&)>& change) {
    std::vector<std::byte> content = encode_content(test::small_bake());
    change(*flatbuffers::GetMutableRoot<fb::Content>(content.data()));
    return refusal_of_content(content);
}

template <class T>
T& mutable_at(flatbuffers::Vector<const T*>& vector, flatbuffers::uoffset_t index) {
    return *vector.GetMutableObject(index);
}

TEST(BakeForgery, UnchangedContent_IsAccepted) {
    EXPECT_EQ(refusal_after([](fb::Content&) {}), "");
}

TEST(BakeForgery, KeysOutOfOrder_AreNamed) {
    EXPECT_EQ(refusal_after([](fb::Content& content) {
                  auto* track = content.mutable_tracks()->GetMutableObject(0);
                  mutable_at(*track->mutable_keys(), 2).mutate_time(1.25);
              }),
              "'shot.bake' is damaged: track 'cue', key 2: its time is not later than that of the "
              "previous key");
}

TEST(BakeForgery, NotANumber_IsNamed) {
    EXPECT_EQ(refusal_after([](fb::Content& content) {
                  auto* track = content.mutable_tracks()->GetMutableObject(1);
                  mutable_at(*track->mutable_keys(), 0).mutable_position().mutate_y(std::nan(""));
              }),
              "'shot.bake' is damaged: track 'one', key 0: a value is not finite");
}

TEST(BakeForgery, HugeRotation_IsRefusedBeforeItIsIntegrated) {
    EXPECT_EQ(
        refusal_after([](fb::Content& content) {
            auto* track = content.mutable_tracks()->GetMutableObject(0);
            mutable_at(*track->mutable_keys(), 0).mutable_angular_velocity_out().mutate_x(1e300);
        }),
        "'shot.bake' is damaged: its objects turn more than 1e6 rad about changing axes");
}

TEST(BakeForgery, EventKindOutOfRange_IsRefused) {
    EXPECT_EQ(
        refusal_after([](fb::Content& content) {
            mutable_at(*content.mutable_events(), 1).mutate_kind(static_cast<fb::EventKind>(15));
        }),
        "'shot.bake' is damaged: an event is of an unknown kind");
}

TEST(BakeForgery, EventNameOutOfRange_IsRefused) {
    EXPECT_EQ(refusal_after([](fb::Content& content) {
                  mutable_at(*content.mutable_events(), 1).mutate_b(4'000'000'000U);
              }),
              "'shot.bake' is damaged: an event refers to a name that does not exist");
}

TEST(BakeForgery, EventsOutOfOrder_AreNamed) {
    EXPECT_EQ(refusal_after([](fb::Content& content) {
                  mutable_at(*content.mutable_events(), 2).mutate_time(1);
              }),
              "'shot.bake' is damaged: event 2 is earlier than the previous one");
}

TEST(BakeForgery, EnergyNotFinite_IsNamed) {
    EXPECT_EQ(refusal_after([](fb::Content& content) {
                  mutable_at(*content.mutable_energy(), 1).mutate_potential(HUGE_VAL);
              }),
              "'shot.bake' is damaged: energy sample 1 has a value that is not finite");
}

TEST(BakeForgery, WorkOfAnotherNumberOfSamples_IsRefused) {
    EXPECT_EQ(refusal_after([](fb::Content& content) {
                  auto* work = content.mutable_energy_work();
                  reinterpret_cast<flatbuffers::uoffset_t*>(work)[0] = work->size() - 1;
              }),
              "'shot.bake' is damaged: it has the work of 2 energy samples, but 3 samples");
}

TEST(BakeForgery, InfiniteDuration_IsRefused) {
    EXPECT_EQ(refusal_after([](fb::Content& content) { content.mutate_end_time(HUGE_VAL); }),
              "'shot.bake' is damaged: its start or end time is not finite");
}

TEST(BakeForgery, LastingContactWithAnUnknownName_IsRefused) {
    EXPECT_EQ(refusal_after([](fb::Content& content) {
                  mutable_at(*content.mutable_lasting_contacts(), 1).mutate_b(1'000);
              }),
              "'shot.bake' is damaged: a lasting contact refers to a name that does not exist");
}

TEST(BakeForgery, LastingContactOfNegativeForce_IsNamed) {
    EXPECT_EQ(refusal_after([](fb::Content& content) {
                  mutable_at(*content.mutable_lasting_contacts(), 1).mutate_normal_force(-1);
              }),
              "'shot.bake' is damaged: lasting contact 1 has a negative force or slip");
}

TEST(BakeForgery, LastingContactThatEndsTooEarly_IsNamed) {
    EXPECT_EQ(refusal_after([](fb::Content& content) {
                  mutable_at(*content.mutable_lasting_contacts(), 0).mutate_to(0.125);
              }),
              "'shot.bake' is damaged: lasting contact 0 ends before it begins");
}

TEST(BakeForgery, BallPutBackToNaN_IsNamed) {
    EXPECT_EQ(refusal_after([](fb::Content& content) {
                  mutable_at(*content.mutable_put_backs(), 0).mutable_to().mutate_z(std::nan(""));
              }),
              "'shot.bake' is damaged: ball put back 0 has a value that is not finite");
}

TEST(BakeForgery, BallPutBackWithAnUnknownName_IsRefused) {
    EXPECT_EQ(refusal_after([](fb::Content& content) {
                  mutable_at(*content.mutable_put_backs(), 0).mutate_ball(4'000'000'000U);
              }),
              "'shot.bake' is damaged: a ball put back refers to a name that does not exist");
}

TEST(BakeForgery, WarningAboutAnUnknownSubject_IsRefused) {
    EXPECT_EQ(refusal_after([](fb::Content& content) {
                  content.mutable_warnings()->GetMutableObject(0)->mutate_subject(
                      static_cast<fb::SubjectKind>(9));
              }),
              "'shot.bake' is damaged: a warning is about a subject of an unknown kind");
}

// Ten thousand tracks that share the same bytes would become gigabytes.
TEST(BakeForgery, SharedParts_AreRefused) {
    FlatBufferBuilder builder;
    const std::vector<fb::Key> keys(1000);
    const auto keys_offset = builder.CreateVectorOfStructs(keys);
    const auto name = builder.CreateString("cue");
    const auto track = fb::CreateTrack(builder, name, keys_offset);
    const auto tracks = builder.CreateVector(std::vector<Offset<fb::Track>>(10'000, track));
    const auto names = builder.CreateVectorOfStrings(std::vector<std::string>{});
    const auto events = builder.CreateVectorOfStructs(std::vector<fb::Event>{});
    const auto energy = builder.CreateVectorOfStructs(std::vector<fb::EnergySample>{});
    const auto contacts = builder.CreateVectorOfStructs(std::vector<fb::LastingContact>{});
    const auto put_backs = builder.CreateVectorOfStructs(std::vector<fb::PutBack>{});
    const auto warnings = builder.CreateVector(std::vector<Offset<fb::Warning>>{});
    const auto text = builder.CreateString("");
    const auto assets = builder.CreateVector(std::vector<Offset<fb::Asset>>{});
    const fb::Hash hash(0, 0);
    builder.Finish(fb::CreateContent(builder, &hash, 0, 1, tracks, names, events, energy, contacts,
                                     put_backs, warnings, text, assets));
    const std::span bytes(reinterpret_cast<const std::byte*>(builder.GetBufferPointer()),
                          builder.GetSize());
    // The first copy already fails for its quaternions; the budget is spent before that.
    EXPECT_THAT(refusal_of_content(bytes), testing::StartsWith("'shot.bake' is damaged: "));
}

// Inner buffers, found by the fuzzer, that once caused a fault; each file is named for its fault.
TEST(BakeForgery, FilesThatTheFuzzerFound_AreRefused) {
    const std::map<std::string, std::string> sentences{
        // A list of structs at a multiple of four: reading its doubles was undefined behaviour.
        {"misaligned_energy", "a list is not aligned to eight bytes"},
        // An angle that overflows: the number of its quarter turns did not fit into an integer.
        {"infinite_spin", "a track has no name"},
    };
    const std::string folder = CAROM_SOURCE_DIR "/tests/sim/timeline/forged_bakes/";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename();
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        EXPECT_EQ(refusal_of_content(std::as_bytes(std::span(text))),
                  "'shot.bake' is damaged: " + sentences.at(name))
            << name;
    }
}

TEST(BakeForgery, RandomBytes_AreRefusedWithoutACrash) {
    test::RandomNumbers numbers(77);
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<std::byte> rubbish(static_cast<std::size_t>(numbers.between(0, 300)));
        for (std::byte& byte : rubbish) {
            byte = static_cast<std::byte>(numbers.between(0, 256));
        }
        EXPECT_NE(refusal_of_content(rubbish), "");
    }
}

// Any byte of a valid content is replaced by any other: the result is a bake or an Error.
TEST(BakeForgery, ReplacedBytes_AreReadOrRefused) {
    const std::vector<std::byte> content = encode_content(test::small_bake());
    test::RandomNumbers numbers(78);
    int refused = 0;
    for (int trial = 0; trial < 20'000; ++trial) {
        std::vector<std::byte> changed = content;
        for (int byte = 0; byte < 1 + trial % 4; ++byte) {
            changed[numbers.below(changed.size())] =
                static_cast<std::byte>(numbers.between(0, 256));
        }
        try {
            const Bake bake = decode_content(changed);
            EXPECT_EQ(find_problem(bake), std::nullopt);
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace carom::sim
