#include "pipeline/store/sums_file.h"

#include <filesystem>
#include <fstream>
#include <span>

#include <gtest/gtest.h>

#include "core/error.h"
#include "render/frame/frame_sums_data.h"
#include "tests/pipeline/store/sample_frames.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::make_key;
using carom::testing::ScratchFolder;

constexpr std::size_t kPixels = 20000;  // more than one piece of the file
constexpr std::size_t kTiles = 100;

render::FrameSums make_sums() {
    render::FrameSums sums;
    render::FrameSums::Data& data = sums.data();
    data.pixels = kPixels;
    render::SumsKind kind;
    kind.objects = true;
    for (std::size_t n = 0; n < kTiles; ++n) {
        render::TileSums& tile = data.tiles.emplace_back(kPixels / kTiles, kind);
        for (std::size_t i = 0; i < tile.size(); ++i) {
            render::RadianceSample sample;
            sample.radiance = {static_cast<float>(n), 0.5F, 1e30F};
            sample.object = static_cast<std::uint32_t>(i);
            tile.add(i, std::span(&sample, 1));
            data.statistics.camera_rays += 1;
        }
        data.seconds.push_back(1);
    }
    sums.data().statistics.shadow_rays = 77;
    return sums;
}

struct SumsFile : ::testing::Test {
    ScratchFolder folder;
    FrameStore store{folder.path("frames")};
    Hash128 key = make_key(1);
    std::string path = store.file_of(key, ".sums");
};

TEST_F(SumsFile, WrittenSums_AreReadBackUntilTheyAreRemoved) {
    EXPECT_EQ(read_sums(store, key, kPixels).samples(), 0U);
    write_sums(store, key, make_sums());
    render::FrameSums sums = read_sums(store, key, kPixels);
    EXPECT_EQ(sums.samples(), make_sums().samples());
    EXPECT_EQ(stored_samples(store, key), make_sums().samples());
    EXPECT_EQ(stored_samples(store, make_key(2)), 0U);
    EXPECT_EQ(sums.data().statistics.shadow_rays, 77U);
    const render::TileSums& tile = sums.data().tiles.at(95);
    EXPECT_EQ(tile.mean(7), render::V3f(95, 0.5F, 1e30F));
    EXPECT_EQ(tile.means(7).objects[0].object, 7U);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path("frames") + "/partial"));
    remove_sums(store, key);
    EXPECT_EQ(read_sums(store, key, kPixels).samples(), 0U);
}

TEST_F(SumsFile, DamagedSums_AreNone) {
    write_sums(store, key, make_sums());
    const auto size = static_cast<std::streamoff>(std::filesystem::file_size(path));
    for (const std::streamoff at : {std::streamoff{0}, std::streamoff{9}, size / 2, size - 1}) {
        write_sums(store, key, make_sums());
        std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
        file.seekg(at);
        const int byte = file.get();
        file.seekp(at);
        file.put(static_cast<char>(byte ^ 4));
        file.close();
        EXPECT_EQ(read_sums(store, key, kPixels).samples(), 0U) << at;
    }
    write_sums(store, key, make_sums());
    std::filesystem::resize_file(path, static_cast<std::uintmax_t>(size) - 1);
    EXPECT_EQ(read_sums(store, key, kPixels).samples(), 0U);
}

TEST_F(SumsFile, SumsOfAnotherFrameOrSize_AreNone) {
    write_sums(store, key, make_sums());
    EXPECT_EQ(read_sums(store, key, kPixels - 1).samples(), 0U);
    const Hash128 other = make_key(2);
    std::filesystem::create_directories(
        std::filesystem::path(store.file_of(other, ".sums")).parent_path());
    std::filesystem::rename(path, store.file_of(other, ".sums"));
    EXPECT_EQ(read_sums(store, other, kPixels).samples(), 0U);
}

}  // namespace
}  // namespace carom::pipeline
