#include "pipeline/store/drop_frame.h"

#include <chrono>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>

#include "pipeline/store/cache_entry.h"
#include "pipeline/store/sums_file.h"
#include "tests/pipeline/store/sample_frames.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::make_film;
using carom::testing::make_key;
using carom::testing::ScratchFolder;
using carom::testing::write_text;

namespace fs = std::filesystem;

struct Dropping {
    ScratchFolder folder;
    FrameStore store{folder.path("frames")};
    Hash128 key = make_key(1);
    Hash128 noisy_key = make_key(2);

    Dropping() {
        store.write(key, make_film(1), {});
        store.write_noisy(noisy_key, make_film(2));
        fs::create_directories(folder.path("frames/locks"));
    }

    void claim_elsewhere(const Hash128& claimed, ClaimNote::State state) const {
        write_text(folder.path("frames/locks/") + claimed.to_string() + ".0",
                   text_of(ClaimNote{"elsewhere", "7-1", 3, state}));
    }
    [[nodiscard]] bool is_anything_there() const {
        return store.contains(key) || store.noisy_size_bytes(noisy_key) > 0;
    }
};

TEST(DropFrame, StoredFrame_LosesBothItsPictures) {
    const Dropping dropping;
    EXPECT_TRUE(drop_frame(dropping.store, dropping.key, dropping.noisy_key));
    EXPECT_FALSE(dropping.is_anything_there());
    EXPECT_TRUE(dropping.store.claim(dropping.key)) << "a worker can take it at once";
    EXPECT_TRUE(drop_frame(dropping.store, dropping.key, dropping.noisy_key)) << "nothing to drop";
}

TEST(DropFrame, ClaimsOfOthersThatAreFinished_DoNotKeepIt) {
    const Dropping dropping;
    dropping.claim_elsewhere(dropping.key, ClaimNote::State::finished);
    dropping.claim_elsewhere(dropping.noisy_key, ClaimNote::State::finished);
    EXPECT_TRUE(drop_frame(dropping.store, dropping.key, dropping.noisy_key));
    EXPECT_FALSE(dropping.is_anything_there());
    EXPECT_TRUE(dropping.store.claim(dropping.key));
    EXPECT_TRUE(dropping.store.claim(dropping.noisy_key));
}

TEST(DropFrame, FrameThatIsNotThere_NeedsNoClaim) {
    const Dropping dropping;
    const Hash128 other = make_key(3);
    dropping.claim_elsewhere(other, ClaimNote::State::working);
    EXPECT_TRUE(drop_frame(dropping.store, other, other));
    EXPECT_FALSE(dropping.store.claim(other)) << "who renders it goes on";
}

TEST(DropFrame, ClaimsOfADeadWorkerElsewhere_KeepItUntilTheyCountAsDead) {
    const Dropping dropping;
    dropping.claim_elsewhere(dropping.key, ClaimNote::State::working);
    dropping.claim_elsewhere(dropping.noisy_key, ClaimNote::State::working);
    fs::remove(dropping.store.path_of(dropping.key));
    fs::remove(dropping.store.file_of(dropping.noisy_key, kNoisyExtension));
    write_text(dropping.store.file_of(dropping.noisy_key, ".sums"), "of some samples");
    constexpr std::chrono::milliseconds kDeadAfter{60};
    const FrameStore store(dropping.folder.path("frames"), {},
                           {std::chrono::milliseconds(5), kDeadAfter});
    EXPECT_FALSE(drop_frame(store, dropping.key, dropping.noisy_key));
    std::this_thread::sleep_for(kDeadAfter);
    EXPECT_TRUE(drop_frame(store, dropping.key, dropping.noisy_key)) << "of both at once";
    EXPECT_EQ(stored_samples(store, dropping.noisy_key), 0U);
}

TEST(DropFrame, FrameThatIsBeingRendered_Stays) {
    const Dropping dropping;
    const Hash128 other = make_key(3);
    dropping.claim_elsewhere(other, ClaimNote::State::working);
    dropping.store.write_noisy(other, make_film(3));
    EXPECT_FALSE(drop_frame(dropping.store, other, other));
    const Hash128 begun = make_key(4);
    dropping.claim_elsewhere(begun, ClaimNote::State::working);
    EXPECT_FALSE(drop_frame(dropping.store, dropping.key, begun)) << "its noisy picture is begun";
    EXPECT_TRUE(dropping.store.contains(dropping.key));
}

}  // namespace
}  // namespace carom::pipeline
