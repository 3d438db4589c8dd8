#include "pipeline/server/page_files.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>

#include "core/error.h"

namespace {

using carom::server::media_type;
using carom::server::read_page_files;
using ::testing::HasSubstr;

TEST(PageFiles, Folder_IsReadWithItsSubfolders) {
    const std::string folder = ::testing::TempDir() + "/page_files_test";
    std::filesystem::create_directories(folder + "/icons");
    std::ofstream(folder + "/index.html") << "page";
    std::ofstream(folder + "/icons/ball.svg") << "ball";
    const auto files = read_page_files(folder);
    std::filesystem::remove_all(folder);
    ASSERT_EQ(files.size(), 3);
    EXPECT_EQ(*files.at("/").bytes, "page");
    EXPECT_EQ(files.at("/index.html").type, "text/html; charset=utf-8");
    EXPECT_EQ(*files.at("/icons/ball.svg").bytes, "ball");
    EXPECT_EQ(files.at("/icons/ball.svg").type, "image/svg+xml");
}

TEST(PageFiles, MissingFolder_IsAnError) {
    try {
        static_cast<void>(read_page_files("/nowhere"));
        FAIL();
    } catch (const carom::Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  "'/nowhere': the folder cannot be read: No such file or directory");
    }
}

TEST(PageFiles, UnknownEnding_IsOnlyBytes) {
    EXPECT_EQ(media_type("main.js"), "text/javascript; charset=utf-8");
    EXPECT_EQ(media_type("main.js.exe"), "application/octet-stream");
    EXPECT_EQ(media_type(""), "application/octet-stream");
}

}  // namespace
