#include "pipeline/store/reservations.h"

#include <atomic>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/store/cache_entry.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/store/claim_note.h"
#include "pipeline/store/pins.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

namespace fs = std::filesystem;

constexpr std::uint64_t kBytes = 1000;  // of each file

std::vector<Hash128> keys(std::uint64_t first, std::uint64_t last) {
    std::vector<Hash128> all;
    for (std::uint64_t i = first; i <= last; ++i) {
        all.push_back({i, 7});
    }
    return all;
}

struct Cache {
    ScratchFolder folder;

    [[nodiscard]] std::string path() const { return folder.path(); }
    void add_frame(std::uint64_t number) const {
        const std::string file = frame_file(path(), {number, 7});
        fs::create_directories(fs::path(file).parent_path());
        write_text(file, "frame");
    }
    [[nodiscard]] std::vector<std::uint64_t> bytes() const {
        std::vector<std::uint64_t> all;
        for (const Reservation& reservation : list_reservations(path())) {
            all.push_back(reservation.bytes);
        }
        return all;
    }
    /// The pin of a process of another machine that was last heard of so many minutes ago.
    void add_foreign_pin(int minutes) const {
        fs::create_directories(path() + "/pins");
        const std::string pin = path() + "/pins/0123456789abcdef-12-1";
        write_text(pin, text_of({"process 12 on other", "", kBytes, keys(1, 2)}));
        fs::last_write_time(pin, fs::file_time_type::clock::now() - std::chrono::minutes(minutes));
    }
};

TEST(Reservations, FilesThatArrive_CountNoLonger) {
    const Cache cache;
    const Pin pin(cache.path(), keys(1, 4), kBytes);
    EXPECT_THAT(cache.bytes(), ElementsAre(4 * kBytes));
    cache.add_frame(2);
    const std::string bake = bake_file(cache.path(), {3, 7});
    fs::create_directories(fs::path(bake).parent_path());
    write_text(bake, "bake");
    EXPECT_THAT(cache.bytes(), ElementsAre(2 * kBytes));
    pin.expect(7);
    EXPECT_THAT(cache.bytes(), ElementsAre(14));
    EXPECT_THAT(list_reservations(cache.path())[0].owner, StartsWith("process "));
    pin.expect(0);
    EXPECT_THAT(cache.bytes(), IsEmpty());
    EXPECT_THAT(pinned_keys(cache.path()), SizeIs(4)) << "the keys are still protected";
}

TEST(Reservations, FilesOfTwoJobs_CountOnce) {
    const Cache cache;
    write_job_pin(cache.path(), {"a", "", kBytes}, keys(1, 3));
    const Pin pin(cache.path(), keys(2, 5), kBytes);
    std::uint64_t sum = 0;
    for (const std::uint64_t bytes : cache.bytes()) {
        sum += bytes;
    }
    EXPECT_EQ(sum, 5 * kBytes);
}

TEST(Reservations, End_WithTheJobOrItsFolder) {
    const Cache cache;
    fs::create_directories(cache.path() + "/farm/a-1");
    write_job_pin(cache.path(), {"a-1", "farm/a-1", kBytes}, keys(1, 3));
    EXPECT_THAT(cache.bytes(), ElementsAre(3 * kBytes));
    EXPECT_EQ(list_reservations(cache.path())[0].owner, "farm job a-1");
    fs::remove_all(cache.path() + "/farm/a-1");
    EXPECT_THAT(cache.bytes(), IsEmpty());
    fs::create_directories(cache.path() + "/farm/a-1");
    forget_reservation(cache.path(), "a-1");
    EXPECT_THAT(cache.bytes(), IsEmpty());
    EXPECT_THAT(pinned_keys(cache.path()), SizeIs(3));
    remove_job_pin(cache.path(), "a-1");
    EXPECT_THAT(pinned_keys(cache.path()), IsEmpty());
}

TEST(Pins, ThatCannotBeWritten_AreAnErrorIfTheCacheCanBe) {
    const Cache cache;
    write_text(cache.path() + "/pins", "a file");
    EXPECT_THAT([&] { (void)Pin(cache.path(), keys(1, 2)); },
                ::testing::ThrowsMessage<CacheUnusable>(
                    "'" + cache.path() +
                    "/pins': the folder cannot be created: Not a directory; without a pin there, "
                    "other jobs may prune the files of this one"));
    EXPECT_NO_THROW((void)Pin("/proc/none", keys(1, 2)));
}

TEST(Reservations, KilledProcess_ReservesNothing) {
    const Cache cache;
    fs::create_directories(cache.path() + "/pins");
    write_text(cache.path() + "/pins/" + host_prefix() + "1-1",
               text_of({"process 1 on here", "", kBytes, keys(1, 2)}));
    EXPECT_THAT(cache.bytes(), IsEmpty());
    EXPECT_TRUE(fs::is_empty(cache.path() + "/pins"));
}

TEST(Pins, ProcessesOfOneNumber_HaveDifferentNames) {
    const Cache cache;
    const Pin pin(cache.path(), keys(1, 2));
    EXPECT_THAT(pin.name(), ::testing::MatchesRegex(host_prefix() + "[0-9]+-[0-9a-f]{8}-[0-9]+"))
        << "in two containers, two processes of this machine may have the same number";
}

TEST(Reservations, ProcessOfAnotherMachine_CountsWhileItRenewsItsPin) {
    const Cache cache;
    cache.add_foreign_pin(5);
    EXPECT_THAT(cache.bytes(), ElementsAre(2 * kBytes));
    cache.add_foreign_pin(15);
    EXPECT_THAT(cache.bytes(), IsEmpty());
    EXPECT_THAT(pinned_keys(cache.path()), SizeIs(2)) << "its frames are protected for longer";
}

/// Reserves room for keys in a cache with `free` bytes. Returns the error.
std::string ask(const Cache& cache, const std::string& job, const std::vector<Hash128>& wanted,
                std::uint64_t free) {
    RoomRequest request{cache.path(), job_pin_name(job)};
    request.free = free;
    try {
        reserve_room(request, [&] { write_job_pin(cache.path(), {job, "", kBytes}, wanted); }, {});
    } catch (const NoRoom& error) {
        remove_job_pin(cache.path(), job);
        return error.what();
    }
    return {};
}

TEST(ReserveRoom, BytesThatOthersNeed_AreNotFree) {
    const Cache cache;
    EXPECT_EQ(ask(cache, "a", keys(1, 3), 4000), "");
    EXPECT_EQ(ask(cache, "b", keys(11, 12), 4000),
              "the cache '" + cache.path() +
                  "' has too little space: 2 missing files of this job need about 2 kB, and 4 kB "
                  "are left; 3 kB are reserved by farm job a (3 kB)");
    EXPECT_EQ(ask(cache, "b", keys(3, 4), 4000), "") << "one of its files is reserved anyway";
    cache.add_frame(1);
    cache.add_frame(2);
    EXPECT_EQ(ask(cache, "c", keys(11, 11), 3000), "") << "two files of a have arrived";
    EXPECT_THAT(ask(cache, "d", keys(21, 21), 3000), HasSubstr("farm job c (1 kB)"));
    remove_job_pin(cache.path(), "c");
    EXPECT_EQ(ask(cache, "d", keys(21, 21), 3000), "");
}

TEST(ReserveRoom, WhatIsPruned_IsRoom) {
    const Cache cache;
    const Pin pin(cache.path(), keys(1, 4), kBytes);
    RoomRequest request{cache.path(), pin.name(), 2000, 1, 2000};
    EXPECT_NO_THROW(reserve_room(request, [] {}, {}));
    request.removable = 1000;
    EXPECT_THROW(reserve_room(request, [] {}, {}), NoRoom);
    request.least_part = 0.75;
    EXPECT_NO_THROW(reserve_room(request, [] {}, {}));
}

TEST(ReserveRoom, OfManyThatAskAtOnce_OnlySoManyGetRoomAsFit) {
    const Cache cache;
    constexpr int kJobs = 8;
    std::atomic<int> accepted{0};
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < kJobs; ++i) {
            threads.emplace_back([&, i] {
                const auto first = static_cast<std::uint64_t>(100 * i);
                accepted +=
                    ask(cache, std::to_string(i), keys(first, first + 9), 35 * kBytes).empty() ? 1
                                                                                               : 0;
            });
        }
    }
    EXPECT_EQ(accepted, 3) << "each needs 10 files";
    EXPECT_THAT(list_reservations(cache.path()), SizeIs(3));
}

TEST(ReserveRoom, Stop_EndsTheWaiting) {
    const Cache cache;
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(reserve_room(
                     {cache.path(), "job-a"}, [] {}, stop.get_token()),
                 Stopped);
}

}  // namespace
}  // namespace carom::pipeline
