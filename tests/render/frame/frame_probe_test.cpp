// The blocks of a probe are those of the frame, and all blocks together are the whole frame.
#include "render/frame/frame_probe.h"

#include <algorithm>
#include <stop_token>
#include <vector>

#include <gtest/gtest.h>

#include "tests/render/frame/table_scene.h"

namespace carom::render {
namespace {

using test::small_settings;
using test::table_frame;
using test::table_tracks;

constexpr int kBlock = 64;  // pixels

/// Neither edge is a multiple of a tile.
RenderSettings two_by_two_blocks() {
    RenderSettings settings = small_settings(100, 70, 4);
    settings.aovs = {"depth"};
    return settings;
}

/// The table without its lamps: the images of lamps in balls are not part of a block's pixels.
PreparedScene open_air(const RenderSettings& settings) {
    test::SceneBuilder builder;
    builder.material("cloth", StandardMaterial{})
        .object("bed", PlaneShape{}, Vec3(0, 0, 0), "cloth");
    builder.sphere("a", 0.03, Vec3(0, 0, 0), "cloth", "a").environment(1);
    return {builder.scene, settings};
}

std::size_t pixel_at(const Film& film, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
           static_cast<std::size_t>(x);
}

/// Whether the block shows the part of the frame whose top left pixel is (left, top).
bool shows(const Film& block, const Film& frame, int left, int top) {
    for (int y = 0; y < block.height; ++y) {
        for (int x = 0; x < block.width; ++x) {
            const std::size_t here = pixel_at(block, x, y);
            const std::size_t there = pixel_at(frame, std::min(left + x, frame.width - 1),
                                               std::min(top + y, frame.height - 1));
            if (block.aovs[0].values[here] != frame.aovs[0].values[there] ||
                !std::equal(&block.rgba[4 * here], &block.rgba[4 * here] + 4,
                            &frame.rgba[4 * there])) {
                return false;
            }
        }
    }
    return true;
}

TEST(FrameProbe, AllBlocks_ShowTheFrame) {
    const RenderSettings settings = two_by_two_blocks();
    const PreparedScene scene = open_air(settings);
    const Film frame = render_frame(scene, table_tracks(), table_frame(), settings);
    FrameProbe probe(scene, table_tracks(), table_frame(), settings, kBlock);
    ASSERT_EQ(probe.blocks_left(), 4);
    std::vector<Film> blocks = probe.render_blocks(3, {});
    ASSERT_EQ(blocks.size(), 3U);
    EXPECT_EQ(probe.blocks_left(), 1);
    const std::vector<Film> last = probe.render_blocks(3, {});
    ASSERT_EQ(last.size(), 1U) << "no more are left";
    blocks.push_back(last.front());
    for (const int top : {0, kBlock}) {
        for (const int left : {0, kBlock}) {
            EXPECT_EQ(
                std::count_if(blocks.begin(), blocks.end(),
                              [&](const Film& block) { return shows(block, frame, left, top); }),
                1)
                << left << ", " << top;
        }
    }
    EXPECT_EQ(probe.cost().pixels, 100 * 70);
    EXPECT_EQ(probe.cost().per_pixel.size(), 4U);
    EXPECT_GE(probe.frame_seconds(), probe.cost().seconds);
}

TEST(FrameProbe, AdaptiveSamplingThatNeedsNoMore_ShowsTheFrame) {
    RenderSettings settings = two_by_two_blocks();
    settings.noise = 1;  // the first samples are enough
    settings.max_samples = 8;
    const PreparedScene scene = open_air(settings);
    const Film frame = render_frame(scene, table_tracks(), table_frame(), settings);
    FrameProbe probe(scene, table_tracks(), table_frame(), settings, kBlock);
    const std::vector<Film> blocks = probe.render_blocks(4, {});
    ASSERT_EQ(blocks.size(), 4U);
    EXPECT_EQ(std::count_if(blocks.begin(), blocks.end(),
                            [&](const Film& block) { return shows(block, frame, 0, 0); }),
              1);
}

TEST(FrameProbe, StopRequested_ReturnsNoBlocks) {
    const RenderSettings settings = two_by_two_blocks();
    const PreparedScene scene = open_air(settings);
    FrameProbe probe(scene, table_tracks(), table_frame(), settings, kBlock);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(probe.render_blocks(2, {{}, stop.get_token()}).empty());
    EXPECT_EQ(probe.cost().pixels, 0) << "nothing was rendered by then";
}

}  // namespace
}  // namespace carom::render
