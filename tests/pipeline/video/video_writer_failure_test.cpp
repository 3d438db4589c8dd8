#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "pipeline/video/video_writer.h"
#include "tests/pipeline/video/click_source.h"
#include "tests/pipeline/video/decoded_video.h"
#include "tests/pipeline/video/file_size_limit.h"
#include "tests/pipeline/video/test_film.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using carom::testing::ClickSource;
using carom::testing::decode_video;
using carom::testing::FileSizeLimit;
using carom::testing::Film;
using carom::testing::moving_disc;
using carom::testing::read_text;
using carom::testing::ScratchFolder;
using carom::testing::write_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(VideoWriter, DestroyedBeforeFinish_LeavesNoFile) {
    const ScratchFolder folder;
    {
        VideoWriter writer(folder.path("film.mp4"), {64, 64}, {});
        writer.write(moving_disc(64, 64, 0));
    }
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(VideoWriter, ExistingTarget_IsReplacedOnlyByACompleteFilm) {
    const ScratchFolder folder;
    write_text(folder.path("film.mp4"), "old");
    {
        VideoWriter writer(folder.path("film.mp4"), {64, 64}, {});
        writer.write(moving_disc(64, 64, 0));
        EXPECT_EQ(read_text(folder.path("film.mp4")), "old");
    }
    EXPECT_EQ(read_text(folder.path("film.mp4")), "old");
    Film{}.write(folder);
    EXPECT_THAT(folder.names(), ElementsAre("film.mp4"));
    EXPECT_EQ(decode_video(folder.path("film.mp4")).frames.size(), 30U);
}

TEST(VideoWriter, NoFrames_IsAnErrorAndLeavesNoFile) {
    const ScratchFolder folder;
    VideoWriter writer(folder.path("film.mp4"), {64, 64}, {});
    EXPECT_THROW(writer.finish(), Error);
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(VideoWriter, MissingFolder_IsReported) {
    const ScratchFolder folder;
    const std::string path = folder.path("none/film.mp4");
    try {
        const VideoWriter writer(path, {64, 64}, {});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), "cannot write '" + path + "': No such file or directory");
    }
}

TEST(VideoWriter, FullDisk_IsAnErrorThatLeavesNoFile) {
    // The limits fall in the header, in the pictures, and in the phase that moves the index to the
    // front.
    std::size_t whole = 0;
    {
        const ScratchFolder folder;
        whole = read_text(Film{}.write(folder)).size();
    }
    for (const std::size_t bytes : {std::size_t{16}, whole / 2, whole - 600, whole - 1}) {
        const ScratchFolder folder;
        const std::string path = folder.path("film.mp4");
        std::string message;
        {
            const FileSizeLimit limit(bytes);
            try {
                Film{}.write(folder);
            } catch (const Error& error) {
                message = error.what();
            }
        }
        EXPECT_THAT(message, HasSubstr("cannot write '" + path + "'")) << bytes << " of " << whole;
        EXPECT_THAT(message, HasSubstr("File too large")) << bytes << " of " << whole;
        EXPECT_THAT(folder.names(), IsEmpty());
    }
}

TEST(VideoWriter, FullDiskWithSound_IsAnErrorThatLeavesNoFile) {
    for (const char* name : {"film.mp4", "film.mkv"}) {
        const auto write = [&](const std::string& path) {
            VideoWriter writer(path, {64, 64}, {}, {},
                               std::make_unique<ClickSource>(std::vector{0.1, 0.5}));
            for (int i = 0; i < 30; ++i) {
                writer.write(moving_disc(64, 64, i));
            }
            writer.finish();
        };
        std::size_t whole = 0;
        {
            const ScratchFolder folder;
            write(folder.path(name));
            whole = read_text(folder.path(name)).size();
        }
        for (const std::size_t bytes : {whole / 3, whole / 2, whole - 600, whole - 1}) {
            const ScratchFolder folder;
            std::string message;
            {
                const FileSizeLimit limit(bytes);
                try {
                    write(folder.path(name));
                } catch (const Error& error) {
                    message = error.what();
                }
            }
            EXPECT_THAT(message, HasSubstr("cannot write '" + folder.path(name) + "'")) << bytes;
            EXPECT_THAT(message, HasSubstr("File too large")) << bytes;
            EXPECT_THAT(folder.names(), IsEmpty());
        }
    }
}

TEST(VideoWriter, OddSize_IsRefusedWithTheMessageOfTheCheck) {
    const ScratchFolder folder;
    try {
        const VideoWriter writer(folder.path("film.mp4"), {65, 64}, {});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("64x64 and 66x64"));
    }
    EXPECT_THAT(folder.names(), IsEmpty());
}

}  // namespace
}  // namespace carom::pipeline
