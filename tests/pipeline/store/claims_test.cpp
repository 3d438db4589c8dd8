#include "pipeline/store/claims.h"

#include <atomic>
#include <chrono>
#include <deque>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using std::chrono::milliseconds;

namespace fs = std::filesystem;

constexpr ClaimTimes kQuick{milliseconds(5), milliseconds(60)};

/// Writes the claim of another machine.
void write_foreign(const ScratchFolder& folder, const std::string& name, std::uint64_t beat,
                   ClaimNote::State state = ClaimNote::State::working) {
    write_text(folder.path(name), text_of({"elsewhere/1", "7-1", beat, state}));
}

std::vector<std::string> names_in(const std::string& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        names.push_back(entry.path().filename().string());
    }
    return names;
}

TEST(ClaimNote, Text_IsReadAgainAndHasTheSameLengthForEachBeat) {
    const ClaimNote note{"host/1", "12-ab-3", 17, ClaimNote::State::finished};
    EXPECT_EQ(parse_claim_note(text_of(note)), note);
    const ClaimNote later{"host/1", "12-ab-3", 1234567, ClaimNote::State::working};
    EXPECT_EQ(text_of(later).size(), text_of(note).size());
    ClaimNote dated = note;
    dated.since = time_now();
    EXPECT_EQ(parse_claim_note(text_of(dated)), dated);
    for (const char* text : {"", "carom claim 2\n", "carom claim 1\nhost a\nprocess b\nbeat x\n"}) {
        EXPECT_FALSE(parse_claim_note(text)) << text;
    }
}

TEST(Claims, LivingClaimOfAnotherMachine_IsRespected) {
    const ScratchFolder folder;
    Claims claims(folder.path(), kQuick);
    for (std::uint64_t beat = 0; beat < 10; ++beat) {
        write_foreign(folder, "frame.0", beat);
        EXPECT_FALSE(claims.claim("frame"));
        std::this_thread::sleep_for(milliseconds(20));
    }
}

TEST(Claims, ClaimOfAnotherMachineWithoutHeartbeat_IsReplacedAfterAWhile) {
    const ScratchFolder folder;
    write_foreign(folder, "frame.0", 3);
    Claims claims(folder.path(), kQuick);
    EXPECT_FALSE(claims.claim("frame"));  // seen for the first time
    std::this_thread::sleep_for(kQuick.dead_after);
    {
        const std::optional<Claim> claim = claims.claim("frame");
        ASSERT_TRUE(claim);
        EXPECT_TRUE(claim->replaces_dead_one());
        EXPECT_THAT(names_in(folder.path()), ::testing::UnorderedElementsAre("frame.0", "frame.1"));
        Claims others(folder.path(), kQuick);
        EXPECT_FALSE(others.claim("frame"));
    }
    EXPECT_THAT(names_in(folder.path()), ::testing::IsEmpty());
}

TEST(Claims, OfTwoThatFindItDead_OneReplacesIt) {
    for (int round = 0; round < 50; ++round) {
        const ScratchFolder folder;
        write_foreign(folder, "frame.0", 3);
        std::deque<Claims> all;
        std::vector<std::optional<Claim>> granted(4);
        for (std::size_t i = 0; i < granted.size(); ++i) {
            all.emplace_back(folder.path(), ClaimTimes{milliseconds(500), milliseconds(1)});
            EXPECT_FALSE(all.back().claim("frame"));
        }
        std::this_thread::sleep_for(milliseconds(2));
        {
            std::vector<std::jthread> threads;
            for (std::size_t i = 0; i < granted.size(); ++i) {
                threads.emplace_back([&, i] { granted[i] = all[i].claim("frame"); });
            }
        }
        EXPECT_EQ(std::ranges::count_if(granted, [](const auto& one) { return one.has_value(); }),
                  1);
        granted.clear();
    }
}

TEST(Claims, WorkFinishedElsewhere_IsNotDoneAgainUntilItShouldBeSeen) {
    const ScratchFolder folder;
    write_foreign(folder, "frame.0", 3, ClaimNote::State::finished);
    Claims claims(folder.path(), kQuick);
    EXPECT_FALSE(claims.claim("frame"));
    std::this_thread::sleep_for(kQuick.dead_after);
    EXPECT_TRUE(claims.claim("frame"));
}

TEST(Claims, FinishedClaim_StaysUntilTheEnd) {
    const ScratchFolder folder;
    {
        Claims claims(folder.path(), kQuick);
        {
            std::optional<Claim> claim = claims.claim("frame");
            ASSERT_TRUE(claim);
            claim->finish();
        }
        EXPECT_THAT(read_text(folder.path("frame.0")), ::testing::HasSubstr("state finished"));
        // On its own machine the result would be seen: it is to be made again.
        EXPECT_TRUE(claims.claim("frame"));
    }
    EXPECT_THAT(names_in(folder.path()), ::testing::IsEmpty());
}

TEST(Claims, ClaimsThatReplacedAFinishedOne_AreNotRemovedAtItsEnd) {
    const ScratchFolder folder;
    std::optional<Claims> first(std::in_place, folder.path(), kQuick);
    {
        std::optional<Claim> claim = first->claim("frame");
        ASSERT_TRUE(claim);
        claim->finish();
    }
    Claims second(folder.path(), kQuick);
    second.forget("frame");
    const std::optional<Claim> again = second.claim("frame");
    ASSERT_TRUE(again);
    first.reset();
    EXPECT_THAT(names_in(folder.path()), ::testing::ElementsAre("frame.0"));
}

TEST(Claims, Heartbeat_IsCountedWhileTheOwnerWorks) {
    const ScratchFolder folder;
    Claims claims(folder.path(), kQuick);
    const std::optional<Claim> claim = claims.claim("frame");
    ASSERT_TRUE(claim);
    const auto beat = [&] { return read_claim_note(folder.path("frame.0"))->beat; };
    const std::uint64_t first = beat();
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (beat() < first + 3 && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(milliseconds(1));
    }
    EXPECT_GE(beat(), first + 3);
}

TEST(Claims, ClaimThatCannotBeRead_IsAnErrorWithItsReasonAndNobodyWaits) {
    const ScratchFolder folder;
    fs::create_directory(folder.path("frame.0"));
    Claims claims(folder.path(), kQuick);
    EXPECT_THAT([&] { (void)claims.claim("frame"); },
                ::testing::ThrowsMessage<Error>("'" + folder.path("frame.0") +
                                                "': the claim cannot be read: Is a directory"));
    EXPECT_NO_THROW(claims.remove_dead());
}

TEST(Claims, Holder_IsNamedWithItsLastSignOfLife) {
    const ScratchFolder folder;
    Claims claims(folder.path(), kQuick);
    EXPECT_EQ(claims.holder("frame"), "");
    write_text(folder.path("frame.0"), text_of({"n7/1", "4711-ab-1", 3, ClaimNote::State::working,
                                                "2026-11-29T07:40:18Z"}));
    EXPECT_FALSE(claims.claim("frame"));
    const std::string holder = "process 4711 on n7 has claimed it since 2026-11-29T07:40:18Z";
    EXPECT_EQ(claims.holder("frame"), holder + "; its last sign of life came 0 s ago");
    write_text(folder.path("frame.0"), text_of({"n7/1", "4711-ab-1", 3, ClaimNote::State::finished,
                                                "2026-11-29T07:40:18Z"}));
    EXPECT_EQ(claims.holder("frame"), holder + " and finished it, which is not seen here yet");
    write_text(folder.path("frame.0"), "");
    EXPECT_EQ(claims.holder("frame"),
              "'" + folder.path("frame.0") + "' does not say who has claimed it");
}

TEST(Claims, FolderThatCannotBeMade_IsAnErrorWithItsReason) {
    const ScratchFolder folder;
    write_text(folder.path("file"), "in the way");
    Claims claims(folder.path("file/locks"), kQuick);
    try {
        (void)claims.claim("frame");
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("Not a directory"));
    }
}

}  // namespace
}  // namespace carom::pipeline
