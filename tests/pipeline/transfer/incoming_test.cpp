#include "pipeline/store/incoming.h"

#include <chrono>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ScratchFolder;
using carom::testing::write_text;

namespace fs = std::filesystem;

void set_age(const std::string& path, int hours) {
    fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(hours));
}

TEST(OldArrivals, AreRemovedAfterADay) {
    const ScratchFolder cache;
    const std::string young = make_incoming_folder(cache.path());
    const std::string old = make_incoming_folder(cache.path());
    write_text(old + "/file", "half");
    fs::create_directories(cache.path("frames/ab"));
    for (const char* name :
         {"frames/ab/.ab.exr.Xy1", "frames/ab/.ab.exr.Xy2", "frames/ab/ab.exr"}) {
        write_text(cache.path(name), "half");
        set_age(cache.path(name), 25);
    }
    set_age(cache.path("frames/ab/.ab.exr.Xy2"), 1);
    set_age(young, 25);
    write_text(young + "/file", "still arriving");
    set_age(old + "/file", 25);
    set_age(old, 25);
    remove_old_arrivals(cache.path());
    EXPECT_TRUE(fs::exists(young + "/file"));
    EXPECT_FALSE(fs::exists(old));
    EXPECT_FALSE(fs::exists(cache.path("frames/ab/.ab.exr.Xy1")));
    EXPECT_TRUE(fs::exists(cache.path("frames/ab/.ab.exr.Xy2")));
    EXPECT_TRUE(fs::exists(cache.path("frames/ab/ab.exr")));
}

}  // namespace
}  // namespace carom::pipeline
