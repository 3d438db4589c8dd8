#include "pipeline/cli/terminal/standard_descriptors.h"

#include <cerrno>
#include <cstdlib>
#include <initializer_list>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace carom::cli {
namespace {

/// 0 if files that are opened get none of the three descriptors, and the closed one still fails.
int outcome_without(int descriptor) {
    ::close(descriptor);
    reserve_standard_descriptors();
    char byte = 0;
    const bool fails = descriptor == STDIN_FILENO ? ::read(descriptor, &byte, 1) < 0
                                                  : ::write(descriptor, &byte, 1) < 0;
    if (!fails || errno != EBADF) {
        return 1;
    }
    return ::open("/dev/null", O_RDWR) > STDERR_FILENO ? 0 : 2;
}

TEST(StandardDescriptorsDeathTest, ClosedDescriptors_AreNotReused) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        EXPECT_EXIT(std::_Exit(outcome_without(descriptor)), ::testing::ExitedWithCode(0), "")
            << descriptor;
    }
}

TEST(StandardDescriptors, OpenDescriptors_AreUnchanged) {
    reserve_standard_descriptors();
    EXPECT_EQ(::write(STDERR_FILENO, "", 0), 0);
}

}  // namespace
}  // namespace carom::cli
