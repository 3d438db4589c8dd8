#include "pipeline/job/frame_queue.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "core/error.h"

namespace carom::pipeline {
namespace {

TEST(FrameQueue, AwaitedPicture_IsHandedOver) {
    constexpr int kAttempts = 200;  // the reader must be waiting by then, but may start late
    FrameQueue queue(kAttempts);
    int handed_over = 0;
    for (std::size_t i = 0; i < kAttempts && handed_over == 0; ++i) {
        std::optional<render::Film> film;
        std::thread reader([&] { film = queue.receive(i, {}); });
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        queue.mark_ready(i, render::Film{7, 5, {}, {}, {}, {}, {}});
        reader.join();
        handed_over += film && film->width == 7 ? 1 : 0;
    }
    EXPECT_EQ(handed_over, 1);
}

TEST(FrameQueue, PictureThatIsNotAwaited_IsNotKept) {
    FrameQueue queue(2);
    queue.mark_ready(0, render::Film{7, 5, {}, {}, {}, {}, {}});
    EXPECT_FALSE(queue.receive(0, {}));
    queue.request_again(0);
    EXPECT_TRUE(queue.take_request());
    queue.mark_ready(0);
    EXPECT_FALSE(queue.receive(0, {}));
}

TEST(FrameQueue, Stopped_HandsNothingOver) {
    FrameQueue queue(1);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)queue.receive(0, stop.get_token()), Stopped);
}

}  // namespace
}  // namespace carom::pipeline
