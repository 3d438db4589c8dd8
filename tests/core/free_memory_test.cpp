#include "core/free_memory.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMebi = 1024 * 1024;

/// A fake system that contains only the files written to it.
class FakeSystem {
  public:
    FakeSystem() { fs::remove_all(root_); }
    ~FakeSystem() { fs::remove_all(root_); }
    FakeSystem(const FakeSystem&) = delete;
    FakeSystem& operator=(const FakeSystem&) = delete;
    FakeSystem(FakeSystem&&) = delete;
    FakeSystem& operator=(FakeSystem&&) = delete;

    void write(const std::string& path, const std::string& text) const {
        const fs::path file = root_.string() + path;
        fs::create_directories(file.parent_path());
        std::ofstream(file) << text;
    }
    [[nodiscard]] std::string root() const { return root_.string(); }

  private:
    fs::path root_ = fs::path(testing::TempDir()) /
                     testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST(FreeMemory_OfThisSystem, IsPositive) {
    ASSERT_TRUE(free_memory().has_value());
    EXPECT_GT(*free_memory(), 0);
}

TEST(FreeMemory_WhereNothingCanBeRead, IsUnknown) {
    const FakeSystem system;
    EXPECT_EQ(free_memory(system.root()), std::nullopt);
}

TEST(FreeMemory_WithoutControlGroups, IsWhatTheSystemHasAvailable) {
    const FakeSystem system;
    system.write("/proc/meminfo", "MemTotal:  9999 kB\nMemFree: 1 kB\nMemAvailable:   2048 kB\n");
    EXPECT_EQ(free_memory(system.root()), 2 * kMebi);
}

TEST(FreeMemory_InAControlGroup, IsLimitedByTheGroupAndItsParents) {
    const FakeSystem system;
    system.write("/proc/meminfo", "MemAvailable: 1048576 kB\n");
    system.write("/proc/self/cgroup", "0::/jobs/step_1\n");
    system.write("/sys/fs/cgroup/jobs/step_1/memory.max", "max\n");
    system.write("/sys/fs/cgroup/jobs/step_1/memory.current", "1048576\n");
    EXPECT_EQ(free_memory(system.root()), 1024 * kMebi);

    system.write("/sys/fs/cgroup/jobs/memory.max", "104857600\n");
    system.write("/sys/fs/cgroup/jobs/memory.current", "41943040\n");
    EXPECT_EQ(free_memory(system.root()), 60 * kMebi);

    system.write("/sys/fs/cgroup/jobs/step_1/memory.max", "1000\n");  // less than it uses
    EXPECT_EQ(free_memory(system.root()), 0);
}

}  // namespace
}  // namespace carom
