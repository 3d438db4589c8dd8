// Files that are served in parts: films.
#include <fstream>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "tests/pipeline/server/running_server.h"

namespace {

using carom::testing::HttpAnswer;
using carom::testing::RunningServer;

/// A server with the file /film of 1,000,000 bytes, in which byte i is i mod 251.
class ServedFile : public ::testing::Test {
  protected:
    ServedFile() {
        content_.resize(1'000'000);
        for (std::size_t i = 0; i < content_.size(); ++i) {
            content_[i] = static_cast<char>(i % 251);
        }
        std::ofstream(path_, std::ios::binary) << content_;
        running_ = std::make_unique<RunningServer>(
            carom::server::ServerOptions{},
            std::map<std::string, carom::server::Resource>{
                {"/film", {"video/mp4", nullptr, path_}},
                {"/memory", {"video/mp4", std::make_shared<const std::string>(content_), ""}},
                {"/gone", {"video/mp4", nullptr, path_ + ".gone"}},
                {"/folder", {"video/mp4", nullptr, ::testing::TempDir()}},
                {"/pipe", {"video/mp4", nullptr, path_ + ".pipe"}}});
    }
    ~ServedFile() override { std::remove(path_.c_str()); }

    [[nodiscard]] HttpAnswer ask(const std::string& range, const std::string& path = "/film") {
        return running_->ask(
            running_->request(path, range.empty() ? "" : "Range: " + range + "\r\n"));
    }
    void expect_part(const std::string& range, std::size_t begin, std::size_t end) {
        for (const char* path : {"/film", "/memory"}) {
            const HttpAnswer answer = ask(range, path);
            EXPECT_EQ(answer.status, 206) << range;
            EXPECT_EQ(answer.field("Content-Range"), "bytes " + std::to_string(begin) + "-" +
                                                         std::to_string(end - 1) + "/1000000");
            EXPECT_EQ(answer.field("Accept-Ranges"), "bytes");
            EXPECT_EQ(answer.field("Content-Type"), "video/mp4");
            EXPECT_TRUE(answer.body == content_.substr(begin, end - begin)) << range;
        }
    }

    std::string path_ = ::testing::TempDir() + "/served_file_test.mp4";
    std::string content_;
    std::unique_ptr<RunningServer> running_;
};

TEST_F(ServedFile, NoRange_Whole) {
    for (const char* range :
         {"", "bytes=5-2", "bytes=x-", "bytes=-", "lines=1-2", "bytes=0-1,5-6"}) {
        const HttpAnswer answer = ask(range);
        EXPECT_EQ(answer.status, 200) << range;
        EXPECT_TRUE(answer.body == content_) << range;
    }
}

TEST_F(ServedFile, Range_Part) {
    expect_part("bytes=0-99", 0, 100);
    expect_part("bytes=0-0", 0, 1);
    expect_part("bytes=300000-700000", 300'000, 700'001);
    expect_part("bytes=0-", 0, 1'000'000);
    expect_part("bytes=999999-", 999'999, 1'000'000);
    expect_part("bytes=-5", 999'995, 1'000'000);
    expect_part("bytes=-2000000", 0, 1'000'000);
    expect_part("bytes=999990-2000000", 999'990, 1'000'000);
    expect_part("bytes=5-18446744073709551615", 5, 1'000'000);
}

TEST_F(ServedFile, RangeOutside_NotSatisfiable) {
    for (const char* range :
         {"bytes=1000000-", "bytes=1000000-1000001", "bytes=-0", "bytes=18446744073709551615-"}) {
        const HttpAnswer answer = ask(range);
        EXPECT_EQ(answer.status, 416) << range;
        EXPECT_EQ(answer.field("Content-Range"), "bytes */1000000");
    }
}

TEST_F(ServedFile, Head_HasTheLengthOnly) {
    carom::testing::RawClient client(running_->port());
    client.send(running_->request("/film", "", "HEAD") + running_->request("/film"));
    EXPECT_EQ(client.read_answer(false).field("Content-Length"), "1000000");
    EXPECT_TRUE(client.read_answer().body == content_);
}

TEST_F(ServedFile, NotARegularFile_NotFound) {
    ASSERT_EQ(::mkfifo((path_ + ".pipe").c_str(), 0600), 0);
    for (const char* path : {"/gone", "/folder", "/pipe"}) {
        EXPECT_EQ(ask("", path).status, 404) << path;
    }
    std::remove((path_ + ".pipe").c_str());
}

TEST_F(ServedFile, FileThatBecomesShorter_EndsTheConnection) {
    content_.resize(64 << 20, 'x');
    std::ofstream(path_, std::ios::binary) << content_;
    carom::testing::RawClient client(running_->port(), 4096);
    client.send(running_->request("/film"));
    EXPECT_EQ(client.read_answer(false).status, 200);
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << "short";
    EXPECT_TRUE(client.is_closed_by_server());
}

}  // namespace
