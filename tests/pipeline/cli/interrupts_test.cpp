#include "pipeline/cli/terminal/interrupts.h"

#include <chrono>
#include <functional>
#include <thread>

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

namespace carom::cli {
namespace {

bool becomes_true(const std::function<bool()>& condition) {
    for (int i = 0; i < 12'000 && !condition(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return condition();
}

TEST(Interrupts, FirstSignal_TriggersTheTokenAndIsReported) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        std::atomic<int> reports{0};
        const Interrupts interrupts([&reports] { ++reports; });
        EXPECT_FALSE(interrupts.token().stop_requested());
        ::raise(signal);
        EXPECT_TRUE(becomes_true([&] { return interrupts.token().stop_requested(); }));
        EXPECT_EQ(reports, 1);
    }
}

TEST(InterruptsDeathTest, SecondSignal_EndsTheProcessImmediately) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            const Interrupts interrupts([] {});
            ::raise(SIGINT);
            ::raise(SIGTERM);
        },
        ::testing::ExitedWithCode(130), "");
}

TEST(Interrupts, SignalIgnoredFromTheStart_RemainsIgnored) {
    ::signal(SIGHUP, SIG_IGN);
    {
        const Interrupts interrupts([] {});
        ::raise(SIGHUP);
        ::raise(SIGHUP);  // would end the process
        EXPECT_FALSE(interrupts.token().stop_requested());
    }
    ::signal(SIGHUP, SIG_DFL);
}

TEST(Interrupts, ClosedPipe_IsOnlyAnErrorOfTheWrite) {
    const Interrupts interrupts([] {});
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    ::close(ends[0]);
    EXPECT_EQ(::write(ends[1], "x", 1), -1);
    EXPECT_EQ(errno, EPIPE);
    ::close(ends[1]);
}

TEST(Interrupts, Destructor_RestoresTheSignals) {
    {
        const Interrupts interrupts([] {});
    }
    struct sigaction action {};
    ::sigaction(SIGINT, nullptr, &action);
    EXPECT_EQ(action.sa_handler, SIG_DFL);
}

}  // namespace
}  // namespace carom::cli
