// Frames that are stopped and go on, in another process as it were: the film is the same.
#include "render/frame/frame_sums.h"

#include <algorithm>
#include <cstring>
#include <stop_token>

#include "core/error.h"
#include "render/threads/thread_arena.h"
#include "tests/render/frame/table_scene.h"
#include "tests/render/frame/ways_to_sample.h"

namespace carom::render {
namespace {

using test::expect_same;
using test::table_frame;
using test::table_tracks;

std::vector<std::byte> saved(const FrameSums& sums) {
    std::vector<std::byte> bytes;
    sums.save([&](std::span<const std::byte> piece) {
        EXPECT_FALSE(piece.empty());
        bytes.insert(bytes.end(), piece.begin(), piece.end());
    });
    return bytes;
}

std::optional<FrameSums> loaded(std::span<const std::byte> bytes, std::size_t pixels) {
    return FrameSums::load(
        [&](std::span<std::byte> wanted) {
            if (wanted.size() > bytes.size()) {
                return false;
            }
            std::memcpy(wanted.data(), bytes.data(), wanted.size());
            bytes = bytes.subspan(wanted.size());
            return true;
        },
        pixels);
}

class Sums : public testing::TestWithParam<RenderSettings> {
  protected:
    /// Stops as soon as the progress is this.
    std::optional<Film> render_until(double fraction) {
        std::stop_source stop;
        WorkContext context;
        context.stop = stop.get_token();
        context.progress = [&](double now) {
            if (now >= fraction) {
                stop.request_stop();
            }
        };
        try {
            return arena_.execute([&] {
                return render_frame(scene_, table_tracks(), table_frame(), GetParam(), context,
                                    &sums_);
            });
        } catch (const Stopped&) {
            return std::nullopt;
        }
    }

    [[nodiscard]] static std::size_t pixels() {
        return static_cast<std::size_t>(GetParam().width) *
               static_cast<std::size_t>(GetParam().height);
    }

    ThreadArena arena_{2};
    PreparedScene scene_{test::table().scene, GetParam()};
    FrameSums sums_;
};

TEST_P(Sums, StoppedFrameThatGoesOn_IsThatOfRenderFrame) {
    const Film expected = render_frame(scene_, table_tracks(), table_frame(), GetParam());
    std::uint64_t samples = 0;
    int stops = 0;
    for (const double fraction : {0.0, 0.3, 0.5, 0.7, 0.9}) {
        const bool is_stopped = !render_until(fraction);
        stops += is_stopped ? 1 : 0;
        EXPECT_LT(fraction < 0.2 ? sums_.samples() : 0, expected.statistics.camera_rays);
        EXPECT_GE(sums_.samples(), is_stopped ? samples : 0);
        samples = sums_.samples();
        std::optional<FrameSums> again = loaded(saved(sums_), pixels());
        ASSERT_TRUE(again);
        sums_ = std::move(*again);
    }
    EXPECT_GE(stops, 3);
    const std::optional<Film> film = render_until(2);
    ASSERT_TRUE(film);
    expect_same(*film, expected);
    EXPECT_EQ(sums_.samples(), 0U) << "a finished frame uses them up";
}

TEST_P(Sums, DamagedBytes_AreNotSums) {
    (void)render_until(0.4);
    const std::vector<std::byte> bytes = saved(sums_);
    EXPECT_TRUE(loaded(bytes, pixels()));
    EXPECT_FALSE(loaded(bytes, pixels() + 1));
    EXPECT_FALSE(loaded({}, pixels()));
    EXPECT_FALSE(loaded(std::span(bytes).subspan(1), pixels()));
    EXPECT_FALSE(loaded(std::span(bytes).first(bytes.size() - 1), pixels()));
    EXPECT_FALSE(loaded(std::span(bytes).first(bytes.size() / 2), pixels()));
}

TEST_P(Sums, OfAFrameOfAnotherSize_AreAnError) {
    (void)render_until(0.4);
    RenderSettings larger = GetParam();
    larger.width += 1;
    EXPECT_THROW((void)render_frame(scene_, table_tracks(), table_frame(), larger, {}, &sums_),
                 Error);
}

INSTANTIATE_TEST_SUITE_P(All, Sums, testing::ValuesIn(test::ways_to_sample()), test::name_of_way);

}  // namespace
}  // namespace carom::render
