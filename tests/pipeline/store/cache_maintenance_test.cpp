#include "pipeline/store/cache_maintenance.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <stdlib.h>
#include <unistd.h>

#include "core/error.h"
#include "pipeline/store/claim_note.h"
#include "pipeline/store/frame_checksum.h"
#include "pipeline/store/frame_store.h"
#include "pipeline/store/own_key.h"
#include "pipeline/store/pins.h"
#include "sim/timeline/bake_file.h"
#include "tests/scratch_folder.h"
#include "tests/sim/timeline/earlier_version.h"

namespace carom::pipeline {
namespace {

using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using std::chrono::hours;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Clock = std::chrono::system_clock;

namespace fs = std::filesystem;

/// A cache with valid files. Ages are hours since the last use.
struct Cache {
    ScratchFolder folder;

    [[nodiscard]] std::string path() const { return folder.path(); }

    std::string add_frame(std::uint64_t number, int age, std::size_t bytes = 1000,
                          const char* extension = ".exr") const {
        return add_file({number, 7}, age, bytes, extension);
    }
    std::string add_file(const Hash128& key, int age, std::size_t bytes,
                         const char* extension) const {
        const std::string name = key.to_string();
        const std::string parent = path() + "/frames/" + name.substr(0, 2);
        fs::create_directories(parent);
        const std::string file = parent + "/" + name + extension;
        write_text(file, std::string(bytes - 40, 'x'));
        append_checksum(file, key);
        set_age(file, age);
        return file;
    }
    std::string add_bake(int age) const {
        fs::create_directories(path() + "/bakes");
        sim::Bake bake;
        bake.physics_hash = {3, 4};
        const std::string file = path() + "/bakes/" + bake.physics_hash.to_string() + ".bake";
        sim::write_bake(bake, file);
        set_age(file, age);
        return file;
    }
    static void set_age(const std::string& file, int age) {
        fs::last_write_time(file, fs::file_time_type::clock::now() - hours(age));
    }
};

TEST(ListCache, Entries_AreSortedFromTheLeastRecentlyUsed) {
    const Cache cache;
    const std::string young = cache.add_frame(1, 1), old = cache.add_frame(2, 9);
    const std::string bake = cache.add_bake(5);
    write_text(cache.path() + "/frames/notes.exr", "not an entry");
    std::vector<std::string> paths;
    for (const CacheEntry& entry : list_cache(cache.path())) {
        paths.push_back(entry.path);
    }
    EXPECT_THAT(paths, ElementsAre(old, bake, young));
    EXPECT_EQ(list_cache(cache.path())[0].bytes, 1000U);
    EXPECT_THAT(list_cache(cache.path() + "/nowhere"), IsEmpty());
}

TEST(PruneCache, Limit_RemovesTheLeastRecentlyUsed) {
    const Cache cache;
    const std::string a = cache.add_frame(1, 1), b = cache.add_frame(2, 3),
                      c = cache.add_frame(3, 2);
    PruneOptions options;
    options.limit = 2000;
    options.dry_run = true;
    EXPECT_EQ(prune_cache(cache.path(), options).removed, 1U);
    EXPECT_TRUE(fs::exists(b)) << "a dry run removes nothing";
    options.dry_run = false;
    const PruneResult result = prune_cache(cache.path(), options);
    EXPECT_EQ(result.removed, 1U);
    EXPECT_EQ(result.removed_bytes, 1000U);
    EXPECT_EQ(result.kept_bytes, 2000U);
    EXPECT_TRUE(fs::exists(a) && !fs::exists(b) && fs::exists(c));
    EXPECT_EQ(prune_cache(cache.path(), options).removed, 0U);
}

TEST(PruneCache, Limit_RemovesNoisyFramesFirst) {
    const Cache cache;
    const std::string old = cache.add_frame(1, 9);
    const std::string noisy = cache.add_frame(2, 5, 1000, kNoisyExtension);
    const std::string young_noisy = cache.add_frame(3, 1, 1000, kNoisyExtension);
    mark_used(young_noisy);
    PruneOptions options;
    options.keep_since = Clock::now() - hours(1);
    options.limit = 2000;
    EXPECT_EQ(prune_cache(cache.path(), options).removed, 1U);
    EXPECT_TRUE(fs::exists(old) && !fs::exists(noisy) && fs::exists(young_noisy));
    options.limit = 1000;
    EXPECT_EQ(prune_cache(cache.path(), options).removed, 1U);
    EXPECT_TRUE(fs::exists(old) && !fs::exists(young_noisy)) << "also one of a running job";
    options.limit = 0;
    EXPECT_EQ(prune_cache(cache.path(), options).kept, 0U);
}

TEST(PruneCache, Limit_RemovesFramesOfOtherVersionsBeforeAllOthers) {
    const Cache cache;
    const auto add = [&](Hash128 key, int age, const char* extension = ".exr") {
        return cache.add_file(key, age, 1000, extension);
    };
    const std::string noisy = add(own_key({1, 1}), 9, kNoisyExtension);
    const std::string old = add(own_key({2, 1}), 8);
    const std::string of_other_version = add({3, 1}, 2);
    const std::string sums_of_other_version = add({4, 1}, 1, ".sums");
    PruneOptions options;
    for (const std::string& next : {of_other_version, sums_of_other_version, noisy, old}) {
        EXPECT_TRUE(fs::exists(next));
        options.limit = prune_cache(cache.path(), {}).kept_bytes - 1;
        EXPECT_EQ(prune_cache(cache.path(), options).removed, 1U);
        EXPECT_FALSE(fs::exists(next));
    }
}

TEST(PruneCache, OnlyNoisyFrames_KeepsEverythingElse) {
    const Cache cache;
    const std::string frame = cache.add_frame(1, 50), bake = cache.add_bake(50);
    const std::string old = cache.add_frame(2, 50, 1000, kNoisyExtension);
    const std::string young = cache.add_frame(3, 1, 1000, kNoisyExtension);
    PruneOptions options;
    options.only_noisy = true;
    options.remove_before = Clock::now() - hours(24);
    EXPECT_EQ(prune_cache(cache.path(), options).removed, 1U);
    EXPECT_TRUE(!fs::exists(old) && fs::exists(young));
    options.limit = 0;
    const PruneResult result = prune_cache(cache.path(), options);
    EXPECT_EQ(result.removed, 1U);
    EXPECT_EQ(result.removed_bytes, 1000U);
    EXPECT_TRUE(!fs::exists(young) && fs::exists(frame) && fs::exists(bake));
}

TEST(VerifyCache, DamagedNoisyFrame_IsFound) {
    const Cache cache;
    (void)cache.add_frame(1, 1, 1000, kNoisyExtension);
    const std::string damaged = cache.add_frame(2, 1, 1000, kNoisyExtension);
    fs::resize_file(damaged, 500);
    const VerifyResult result = verify_cache(cache.path(), {}, {});
    EXPECT_EQ(result.checked, 2U);
    ASSERT_EQ(result.damaged.size(), 1U);
    EXPECT_EQ(result.damaged[0].path, damaged);
}

TEST(PruneCache, FileInUse_IsKeptWhateverTheLimit) {
    const Cache cache;
    const std::string old = cache.add_frame(1, 5), used = cache.add_frame(2, 5);
    mark_used(used);
    PruneOptions options;
    options.limit = 0;
    options.keep_since = Clock::now() - hours(1);
    EXPECT_EQ(prune_cache(cache.path(), options).kept, 1U);
    EXPECT_TRUE(fs::exists(used) && !fs::exists(old));
}

TEST(PruneCache, Age_RemovesOldFilesWithinTheLimit) {
    const Cache cache;
    const std::string old = cache.add_frame(1, 50), young = cache.add_frame(2, 2);
    PruneOptions options;
    options.remove_before = Clock::now() - hours(24);
    EXPECT_EQ(prune_cache(cache.path(), options).removed, 1U);
    EXPECT_TRUE(!fs::exists(old) && fs::exists(young));
}

/// Older versions of carom wrote the warnings to a file beside the bake.
TEST(PruneCache, Bake_IsRemovedWithItsOldWarnings) {
    const Cache cache;
    const std::string bake = cache.add_bake(1);
    write_text(bake + ".warnings", "a warning\n");
    PruneOptions options;
    options.limit = 0;
    EXPECT_EQ(prune_cache(cache.path(), options).removed, 1U);
    EXPECT_TRUE(fs::is_empty(cache.path() + "/bakes"));
}

TEST(PruneCache, PinnedFiles_AreKept) {
    const Cache cache;
    const std::string pinned = cache.add_frame(1, 30);
    const std::string other = cache.add_frame(2, 20);
    const std::string of_job = cache.add_frame(3, 10);
    PruneOptions options;
    options.limit = 0;
    write_job_pin(cache.path(), {"film-1", "", 0}, std::vector{Hash128{3, 7}});
    {
        const Pin pin(cache.path(), std::vector{Hash128{1, 7}});
        EXPECT_EQ(prune_cache(cache.path(), options).removed, 1U);
        EXPECT_TRUE(fs::exists(pinned));
        EXPECT_FALSE(fs::exists(other));
    }
    EXPECT_EQ(prune_cache(cache.path(), options).removed, 1U);
    EXPECT_FALSE(fs::exists(pinned));
    EXPECT_TRUE(fs::exists(of_job));
    remove_job_pin(cache.path(), "film-1");
    EXPECT_EQ(prune_cache(cache.path(), options).removed, 1U);
    EXPECT_TRUE(fs::is_empty(cache.path() + "/pins"));
}

TEST(PruneCache, PinsOfKilledProcessesAndOfOldJobs_DoNotCount) {
    const Cache cache;
    (void)cache.add_frame(1, 1);
    const std::string key = Hash128{1, 7}.to_string() + "\n";
    fs::create_directories(cache.path() + "/pins");
    write_text(cache.path() + "/pins/" + host_prefix() + "1-1", key);
    write_text(cache.path() + "/pins/job-old", key);
    Cache::set_age(cache.path() + "/pins/job-old", 24 * 31);
    PruneOptions options;
    options.limit = 0;
    EXPECT_EQ(prune_cache(cache.path(), options).removed, 1U);
    EXPECT_TRUE(fs::is_empty(cache.path() + "/pins"));
}

TEST(PruneCache, LeftoversOfKilledProcesses_AreRemoved) {
    const Cache cache;
    fs::create_directories(cache.path() + "/frames/partial");
    write_text(cache.path() + "/frames/partial/" + host_prefix() + "half", "a frame");
    PruneOptions options;
    options.dry_run = true;
    (void)prune_cache(cache.path(), options);
    EXPECT_FALSE(fs::is_empty(cache.path() + "/frames/partial"));
    options.dry_run = false;
    (void)prune_cache(cache.path(), options);
    EXPECT_TRUE(fs::is_empty(cache.path() + "/frames/partial"));
}

TEST(VerifyCache, DamagedFiles_AreListed) {
    const Cache cache;
    (void)cache.add_frame(1, 1);
    const std::string frame = cache.add_frame(2, 2), bake = cache.add_bake(3);
    EXPECT_THAT(verify_cache(cache.path(), {}, {}).damaged, IsEmpty());
    for (const std::string& path : {frame, bake}) {
        std::string bytes = read_text(path);
        bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
        write_text(path, bytes);
    }
    double fraction = 0;
    const VerifyResult result = verify_cache(cache.path(), [&](double now) { fraction = now; }, {});
    EXPECT_EQ(result.checked, 3U);
    EXPECT_EQ(result.damaged.size(), 2U);
    EXPECT_EQ(fraction, 1);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)verify_cache(cache.path(), {}, stop.get_token()), Stopped);
}

/// Another user, which only the system's administrator can become.
TEST(VerifyCache, FilesOfOthers_AreNeitherIntactNorDamaged) {
    if (::geteuid() != 0) {
        GTEST_SKIP() << "needs two users";
    }
    constexpr uid_t kOther = 65534;
    const Cache cache;
    const std::string frame = cache.add_frame(1, 1), bake = cache.add_bake(2);
    (void)cache.add_frame(2, 1);
    fs::permissions(cache.path(), fs::perms(0755));
    for (const std::string& path : {frame, bake}) {
        fs::permissions(path, fs::perms(0600));
    }
    ASSERT_EQ(::seteuid(kOther), 0);
    const VerifyResult result = verify_cache(cache.path(), {}, {});
    ASSERT_EQ(::seteuid(0), 0);
    EXPECT_EQ(result.checked, 3U);
    EXPECT_THAT(result.damaged, IsEmpty());
    ASSERT_EQ(result.unreadable.size(), 2U);
}

TEST(VerifyCache, BakeOfAnotherVersion_IsNotDamaged) {
    const Cache cache;
    const std::string bake = cache.add_bake(1);
    const std::string old = sim::test::with_earlier_version(read_text(bake));
    ASSERT_FALSE(old.empty());
    write_text(bake, old);
    EXPECT_THAT(verify_cache(cache.path(), {}, {}).damaged, IsEmpty());
}

TEST(CacheSize, Texts_AreParsedAndFormatted) {
    EXPECT_EQ(parse_cache_size("20 GB"), 20'000'000'000U);
    EXPECT_EQ(parse_cache_size(" 1.5MB "), 1'500'000U);
    EXPECT_EQ(parse_cache_size("0"), 0U);
    EXPECT_EQ(parse_cache_size("none"), kNoLimit);
    for (const char* wrong : {"", "20", "GB", "-1 GB", "1e3 MB", "1.2.3 GB", "20 gigs", "9e99 TB",
                              "999999999999999999 TB", "0x1 GB", "inf GB"}) {
        try {
            (void)parse_cache_size(wrong);
            ADD_FAILURE() << wrong;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("'" + std::string(wrong) + "' is not a size"));
        }
    }
    EXPECT_EQ(size_text(20'000'000'000U), "20 GB");
    EXPECT_EQ(size_text(999'900), "1 MB");
    EXPECT_EQ(size_text(1234), "1.23 kB");
    EXPECT_EQ(size_text(12), "12 B");
    EXPECT_EQ(size_text(0), "0 B");
    EXPECT_EQ(size_text(kNoLimit), "no limit");
}

TEST(CacheSize, Environment_IsUsedUnlessASizeIsGiven) {
    ::setenv("CAROM_CACHE_SIZE", "3 MB", 1);
    EXPECT_EQ(cache_size_limit(""), 3'000'000U);
    EXPECT_EQ(cache_size_limit("1 kB"), 1000U);
    ::setenv("CAROM_CACHE_SIZE", "lots", 1);
    try {
        (void)cache_size_limit("");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("CAROM_CACHE_SIZE: 'lots' is not a size"));
    }
    ::unsetenv("CAROM_CACHE_SIZE");
    EXPECT_EQ(cache_size_limit(""), 20'000'000'000U);
}

}  // namespace
}  // namespace carom::pipeline
