#include "pipeline/store/frame_store.h"

#include <cstdlib>
#include <deque>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>

#include "core/error.h"
#include "pipeline/store/frame_checksum.h"
#include "pipeline/store/lock_file.h"
#include "tests/folders.h"
#include "tests/pipeline/store/child_process.h"
#include "tests/pipeline/store/sample_frames.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ChildProcess;
using carom::testing::make_film;
using carom::testing::make_key;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::IsEmpty;

namespace fs = std::filesystem;

const std::string kActor = CAROM_BINARY_DIR "/tests/carom_store_actor";

std::vector<std::string> names_in(const std::string& folder) {
    std::vector<std::string> names;
    if (fs::exists(folder)) {
        for (const auto& entry : fs::directory_iterator(folder)) {
            names.push_back(entry.path().filename().string());
        }
    }
    return names;
}

TEST(CacheFolder, EnvironmentVariables_AreUsedInOrder) {
    ::setenv("CAROM_CACHE", "/a", 1);
    ::setenv("XDG_CACHE_HOME", "/b", 1);
    ::setenv("HOME", "/c", 1);
    EXPECT_EQ(default_cache_folder(), "/a");
    ::unsetenv("CAROM_CACHE");
    EXPECT_EQ(default_cache_folder(), "/b/carom");
    ::setenv("XDG_CACHE_HOME", "", 1);
    EXPECT_EQ(default_cache_folder(), "/c/.cache/carom");
    ::setenv("XDG_CACHE_HOME", "relative/cache", 1);
    EXPECT_EQ(default_cache_folder(), "/c/.cache/carom");
    ::setenv("HOME", "relative", 1);
    EXPECT_THROW((void)default_cache_folder(), Error);
    ::setenv("HOME", "/c", 1);
    ::unsetenv("HOME");
    EXPECT_THROW((void)default_cache_folder(), Error);
}

TEST(FrameStore, WrittenFrame_IsReadBackUnchanged) {
    const ScratchFolder folder;
    const FrameStore store(folder.path("frames"));
    const Hash128 key = make_key(1);
    EXPECT_FALSE(store.contains(key));
    EXPECT_FALSE(store.read(key));
    const render::Film film = make_film(1);
    store.write(key, film, {{"carom:samples", "64"}});
    EXPECT_TRUE(store.contains(key));
    const std::optional<render::Film> back = store.read(key);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->width, film.width);
    EXPECT_EQ(back->height, film.height);
    EXPECT_EQ(back->rgba, film.rgba);
    ASSERT_EQ(back->aovs.size(), 1u);
    EXPECT_EQ(back->aovs[0].name, "Z");
    EXPECT_EQ(back->aovs[0].values, film.aovs[0].values);
    EXPECT_THAT(names_in(folder.path("frames/partial")), IsEmpty());
    EXPECT_EQ(store.path_of(key), folder.path("frames/") + key.to_string().substr(0, 2) + "/" +
                                      key.to_string() + ".exr");
}

TEST(FrameStore, FrameWithNan_IsRejectedAndLeavesNothing) {
    const ScratchFolder folder;
    const FrameStore store(folder.path());
    render::Film film = make_film(1);
    film.rgba[5] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(store.write(make_key(1), film, {}), Error);
    EXPECT_FALSE(store.contains(make_key(1)));
    EXPECT_THAT(names_in(folder.path("partial")), IsEmpty());
}

TEST(FrameStore, NoisyFrame_IsReadBackUnchangedAndIsNoFrame) {
    const ScratchFolder folder;
    const FrameStore store(folder.path());
    const Hash128 key = make_key(1);
    EXPECT_FALSE(store.read_noisy(key));
    EXPECT_EQ(store.noisy_size_bytes(key), 0U);
    render::Film film = make_film(1);
    film.half_aovs.push_back({"half.R", std::vector<std::uint16_t>(32, 0x3400)});
    store.write_noisy(key, film);
    EXPECT_FALSE(store.contains(key));
    EXPECT_FALSE(store.read(key));
    EXPECT_EQ(store.noisy_size_bytes(key), fs::file_size(store.file_of(key, ".noisy")));
    const std::optional<render::Film> back = store.read_noisy(key);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->rgba, film.rgba);
    ASSERT_EQ(back->aovs.size(), 1U);
    EXPECT_EQ(back->aovs[0].values, film.aovs[0].values);
    ASSERT_EQ(back->half_aovs.size(), 1U);
    EXPECT_EQ(back->half_aovs[0].bits, film.half_aovs[0].bits);
    EXPECT_THAT(names_in(folder.path("partial")), IsEmpty());
    film.rgba[5] = std::numeric_limits<float>::infinity();
    EXPECT_THAT([&] { store.write_noisy(make_key(2), film); },
                ::testing::ThrowsMessage<Error>(
                    ::testing::HasSubstr("': pixel (1, 0), channel G, is not a finite number; such "
                                         "a picture is not written")));
    EXPECT_THAT(names_in(folder.path("partial")), IsEmpty());
}

TEST(FrameStore, AnyDamagedByteOfANoisyFrame_MakesItMissing) {
    const ScratchFolder folder;
    std::vector<std::string> damages;
    const FrameStore store(folder.path(), [&](const std::string&, const std::string& damage) {
        damages.push_back(damage);
    });
    const Hash128 key = make_key(1);
    store.write_noisy(key, make_film(1));
    const std::string path = store.file_of(key, ".noisy");
    const std::string whole = read_text(path);
    for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 100) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
        write_text(path, damaged);
        EXPECT_FALSE(store.read_noisy(key)) << at;
        EXPECT_FALSE(fs::exists(path)) << at;
    }
    EXPECT_EQ(damages.front(), "its contents have changed since it was written");
    write_text(path, "not a film, but long enough to contain a checksum");
    append_checksum(path, key);
    EXPECT_FALSE(store.read_noisy(key));
    EXPECT_EQ(damages.back(), "it cannot be decoded: it is no packed film");
    write_text(path, whole);
    EXPECT_TRUE(store.read_noisy(key));
}

TEST(FrameStore, AnyDamagedByte_MakesTheFrameMissing) {
    const ScratchFolder folder;
    const FrameStore store(folder.path());
    const Hash128 key = make_key(1);
    store.write(key, make_film(1), {});
    const std::string whole = read_text(store.path_of(key));
    for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 100) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
        write_text(store.path_of(key), damaged);
        EXPECT_FALSE(store.read(key)) << at;
        EXPECT_FALSE(store.contains(key)) << at;
    }
    write_text(store.path_of(key), whole);
    EXPECT_TRUE(store.read(key));
}

TEST(FrameStore, TruncatedEmptyOrForeignFile_IsMissing) {
    const ScratchFolder folder;
    const FrameStore store(folder.path());
    const Hash128 key = make_key(1), other = make_key(2);
    store.write(key, make_film(1), {});
    const std::string whole = read_text(store.path_of(key));
    for (const std::string& text :
         {std::string(), whole.substr(0, whole.size() / 2), whole.substr(0, whole.size() - 1),
          whole + "x", std::string("not a picture, but long enough to contain a checksum")}) {
        write_text(store.path_of(key), text);
        EXPECT_FALSE(store.read(key)) << text.size();
    }
    // An intact frame under the name of another frame.
    fs::create_directories(fs::path(store.path_of(other)).parent_path());
    write_text(store.path_of(other), whole);
    EXPECT_FALSE(store.read(other));
}

TEST(FrameStore, FolderThatIsRemoved_IsCreatedAgain) {
    const ScratchFolder folder;
    const FrameStore store(folder.path("frames"));
    fs::remove_all(folder.path("frames"));
    EXPECT_TRUE(store.claim(make_key(1)));
    store.write(make_key(1), make_film(1), {});
    EXPECT_TRUE(store.read(make_key(1)));
}

TEST(FrameStore, FolderThatCannotBeCreated_IsAnErrorWithItsName) {
    const ScratchFolder folder;
    write_text(folder.path("file"), "in the way");
    try {
        const FrameStore store(folder.path("file/frames"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), ::testing::StartsWith("'" + folder.path("file/frames") +
                                                        "': the folder cannot be created: "));
    }
}

// A link to itself cannot be read even by root, who can read all files.
TEST(FrameStore, FileThatCannotBeRead_IsMissingToWhomOnlyReads) {
    const ScratchFolder folder;
    const FrameStore store(folder.path());
    const Hash128 key = make_key(1);
    const std::string file = store.path_of(key);
    const std::string noisy = store.file_of(key, ".noisy");
    fs::create_directories(fs::path(file).parent_path());
    fs::create_symlink(file, file);
    fs::create_symlink(noisy, noisy);
    const auto is_unreadable = [](const std::string& path) {
        return ::testing::ThrowsMessage<Error>(
            "'" + path + "': the frame cannot be read: Too many levels of symbolic links");
    };
    EXPECT_THAT([&] { (void)store.read(key); }, is_unreadable(file));
    EXPECT_THAT([&] { (void)store.read_noisy(key); }, is_unreadable(noisy));
    EXPECT_THAT([&] { (void)store.is_intact(key); }, is_unreadable(file));
    const auto fail = [](const std::string&, const std::string&) { FAIL(); };
    const FrameStore reader(folder.path(), fail, {}, StoreAccess::only_read);
    EXPECT_FALSE(reader.read(key));
    EXPECT_FALSE(reader.read_noisy(key));
    EXPECT_FALSE(reader.is_intact(key));
}

TEST(FrameClaim, SecondClaim_IsDeniedUntilTheFirstEnds) {
    const ScratchFolder folder;
    const FrameStore store(folder.path());
    {
        std::optional<Claim> first = store.claim(make_key(1));
        ASSERT_TRUE(first);
        EXPECT_FALSE(store.claim(make_key(1)));
        EXPECT_TRUE(store.claim(make_key(2)));
        const Claim moved = std::move(*first);
        first.reset();
        EXPECT_FALSE(store.claim(make_key(1)));
    }
    EXPECT_TRUE(store.claim(make_key(1)));
    EXPECT_THAT(names_in(folder.path("locks")), IsEmpty());
}

TEST(FrameClaim, KilledOwner_ReleasesItsClaim) {
    const ScratchFolder folder;
    const FrameStore store(folder.path());
    ChildProcess owner({kActor, "claim", folder.path(), folder.path("claimed")});
    ASSERT_TRUE(owner.wait_until([&] { return fs::exists(folder.path("claimed")); }));
    EXPECT_FALSE(store.claim(make_key(1)));
    owner.kill();
    (void)owner.wait();
    EXPECT_EQ(names_in(folder.path("locks")).size(), 1u);
    EXPECT_TRUE(store.claim(make_key(1)));
    EXPECT_THAT(names_in(folder.path("locks")), IsEmpty());
}

TEST(FrameClaim, LinkWhoseReplyWasLostAndThatIsSeenLate_IsHeldAllTheSame) {
    const ScratchFolder folder;
    const FrameStore store(folder.path());
    ChildProcess owner({"/usr/bin/env",
                        "LD_PRELOAD=" CAROM_BINARY_DIR "/tests/libcarom_late_files.so", kActor,
                        "claim", folder.path(), folder.path("claimed")});
    ASSERT_TRUE(owner.wait_until([&] { return fs::exists(folder.path("claimed")); }));
    EXPECT_EQ(lock_state_of(folder.path("locks/") + make_key(1).to_string() + ".0"),
              LockState::busy)
        << "else others on this machine take it for dead";
}

TEST(FrameClaim, LockOfAKilledOwner_IsRemovedByTheNextStore) {
    const ScratchFolder folder;
    { const FrameStore store(folder.path()); }
    write_text(folder.path("locks/") + make_key(7).to_string(), "");
    write_text(folder.path("partial/") + host_prefix() + "left", "half a frame");
    const FrameStore owner(folder.path());
    EXPECT_THAT(names_in(folder.path("locks")), IsEmpty());
    EXPECT_THAT(names_in(folder.path("partial")), IsEmpty());
    const std::optional<Claim> claim = owner.claim(make_key(7));
    const FrameStore next(folder.path());
    EXPECT_FALSE(next.claim(make_key(7)));
}

TEST(FrameClaim, ManyProcesses_NeverHaveItAtTheSameTime) {
    const ScratchFolder folder;
    std::deque<ChildProcess> children;
    for (int i = 0; i < 4; ++i) {
        children.emplace_back(std::vector<std::string>{kActor, "repeat", folder.path("store"),
                                                       folder.path("in_use")});
    }
    for (ChildProcess& child : children) {
        EXPECT_EQ(child.wait(), 0);
    }
    EXPECT_THAT(names_in(folder.path("store/locks")), IsEmpty());
}

TEST(FrameStore, KilledWriter_LeavesNoPartialFrame) {
    const ScratchFolder folder;
    for (int round = 0; round < 6; ++round) {
        ChildProcess writer({kActor, "write", folder.path()});
        // Every new store removes abandoned files while the writer is running.
        ASSERT_TRUE(
            writer.wait_until([&] { return FrameStore(folder.path()).contains(make_key(0)); }));
        std::this_thread::sleep_for(std::chrono::milliseconds(3 + 7 * round));
        writer.kill();
        (void)writer.wait();
        const FrameStore store(folder.path());
        EXPECT_THAT(names_in(folder.path("partial")), IsEmpty());
        for (std::uint64_t number = 0; number < 8; ++number) {
            if (store.contains(make_key(number))) {
                const std::optional<render::Film> film = store.read(make_key(number));
                ASSERT_TRUE(film);
                EXPECT_EQ(film->rgba, make_film(static_cast<int>(number)).rgba);
            }
        }
        fs::remove(store.path_of(make_key(0)));
    }
}

}  // namespace
}  // namespace carom::pipeline
