#include "pipeline/check/file_check.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/scratch_folder.h"

namespace carom::pipeline {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class FileCheck : public ::testing::Test {
  protected:
    /// A file that is named at a line.
    [[nodiscard]] NamedFile named(const std::string& name, FileKind kind, int line = 1) const {
        NamedFile file{kind, path(name), {}};
        file.where.place = {"shot.yaml", line, 5};
        file.where.key_path = "key";
        return file;
    }
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
    }
    void write_picture(const std::string& name, int width, int height, int channels,
                       const std::vector<float>& values) const {
        const auto output = OIIO::ImageOutput::create(path(name));
        ASSERT_TRUE(output);
        const bool is_float = name.ends_with(".exr");
        ASSERT_TRUE(output->open(
            path(name), OIIO::ImageSpec(width, height, channels,
                                        is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8)));
        ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
        ASSERT_TRUE(output->close());
    }

    /// The messages, each with its severity.
    [[nodiscard]] std::vector<std::string> messages(const std::vector<NamedFile>& files,
                                                    const FileCheckOptions& options = {}) {
        std::vector<std::string> texts;
        for (const Problem& problem : checker_.check(files, options).problems) {
            EXPECT_EQ(problem.place.file, "shot.yaml");
            EXPECT_EQ(problem.key_path, "key");
            texts.push_back((problem.severity == Severity::error ? "error: " : "warning: ") +
                            problem.message);
        }
        return texts;
    }

    FileChecker checker_;

  private:
    testing::ScratchFolder folder_;
};

TEST_F(FileCheck, GoodFiles_HaveNoProblems) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write_picture("a.png", 2, 1, 3, {0, 0, 0, 1, 1, 1});
    EXPECT_THAT(messages({named("a.obj", FileKind::mesh), named("a.png", FileKind::texture),
                          named("a.png", FileKind::environment),
                          named("a.png", FileKind::annotation_picture)}),
                IsEmpty());
    NamedFile font = named("", FileKind::font);
    font.path = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    EXPECT_THAT(messages({font}), IsEmpty());
}

TEST_F(FileCheck, EveryWrongFile_IsAnErrorAtItsPlace) {
    write("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    write("empty", "");
    write("text.txt", "this is something else\n");
    write_picture("whole.png", 16, 16, 3, std::vector<float>(3 * 256, 0.5f));
    std::filesystem::resize_file(path("whole.png"), 60);
    for (const FileKind kind : {FileKind::texture, FileKind::normals, FileKind::environment,
                                FileKind::annotation_picture}) {
        EXPECT_THAT(messages({named("whole.png", kind)}),
                    ElementsAre("error: image '" + path("whole.png") +
                                "' cannot be read: the file ends too early"));
        EXPECT_THAT(
            messages({named("empty", kind)}),
            ElementsAre("error: image '" + path("empty") + "' cannot be read: the file is empty"));
        EXPECT_THAT(messages({named("text.txt", kind)}),
                    ElementsAre(HasSubstr("error: image '" + path("text.txt") + "'")));
    }
    for (const std::string name : {"range.obj", "empty", "text.txt"}) {
        EXPECT_THAT(messages({named(name, FileKind::mesh)}),
                    ElementsAre(HasSubstr("error: '" + path(name) + "'")));
        EXPECT_THAT(messages({named(name, FileKind::font)}),
                    ElementsAre("error: font '" + path(name) +
                                "' cannot be used: it is not a TrueType or OpenType font, or it is "
                                "damaged"));
    }
    // All at once, each at its line; the same place and sentence once.
    const FileReport report = checker_.check(
        std::vector{named("empty", FileKind::texture, 3), named("text.txt", FileKind::font, 4),
                    named("empty", FileKind::texture, 3), named("empty", FileKind::texture, 7)});
    ASSERT_THAT(report.problems, SizeIs(3));
    EXPECT_EQ(report.problems[0].place.line, 3);
    EXPECT_EQ(report.problems[1].place.line, 4);
    EXPECT_EQ(report.problems[2].place.line, 7);
}

TEST_F(FileCheck, FontThatEndsTooEarly_IsAnError) {
    std::filesystem::copy_file("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", path("a.ttf"));
    const auto size = std::filesystem::file_size(path("a.ttf"));
    for (const double part : {0.9, 0.5, 0.1, 0.001}) {
        std::filesystem::resize_file(path("a.ttf"),
                                     static_cast<std::uintmax_t>(part * static_cast<double>(size)));
        EXPECT_THAT(messages({named("a.ttf", FileKind::font)}),
                    ElementsAre(HasSubstr("cannot be used: ")))
            << part;
    }
}

TEST_F(FileCheck, WhatIsIgnoredInAMesh_IsTold) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn nan 0 0\nf 1//1 2//1 3//1\n");
    EXPECT_THAT(messages({named("a.obj", FileKind::mesh)}),
                ElementsAre("warning: '" + path("a.obj") +
                            "': line 4: a normal has no length or is not three numbers; it is "
                            "ignored"));
}

TEST_F(FileCheck, BlemishesOfAPicture_AreCounted) {
    write_picture("a.exr", 4, 1, 3, {1, 1, 1, -1, 1, 1, std::nanf(""), -2, 1, 1, INFINITY, 1});
    for (const FileKind kind : {FileKind::environment, FileKind::texture}) {
        EXPECT_THAT(messages({named("a.exr", kind)}),
                    ElementsAre("warning: image '" + path("a.exr") +
                                "' has a negative, infinite or undefined value in 3 of 4 pixels; "
                                "negative and undefined ones become 0, infinite ones 65504"));
    }
}

TEST_F(FileCheck, TransparencyOfAPicture_IsAWarningUnlessItIsMeant) {
    write_picture("a.png", 2, 1, 4, {0, 0, 0, 0, 1, 1, 1, 1});
    const std::string start = "warning: image '" + path("a.png") + "' is transparent in 1 of 2 ";
    EXPECT_THAT(
        messages({named("a.png", FileKind::texture)}),
        ElementsAre(start + "pixels, where a light grey is seen; cut the surface out there, "
                            "beside 'base', with 'opacity: {image: ...}' of the same file, "
                            "or choose the colour: 'image: {file: ..., background: 0.8}'"));
    EXPECT_THAT(messages({named("a.png", FileKind::environment)}),
                ElementsAre(start + "pixels, where it is dark"));
    EXPECT_THAT(messages({named("a.png", FileKind::annotation_picture)}), IsEmpty());
    EXPECT_THAT(messages({named("a.png", FileKind::normals)}), IsEmpty());
    NamedFile chosen = named("a.png", FileKind::texture);
    chosen.is_transparency_meant = true;
    EXPECT_THAT(messages({chosen}), IsEmpty());
}

TEST_F(FileCheck, LargeFiles_AreCheckedByTheirHeaders) {
    write_picture("small.png", 1, 1, 3, {0, 0, 0});
    write_picture("large.png", 64, 64, 3, std::vector<float>(3 * 64 * 64, 0.5f));
    std::filesystem::resize_file(path("large.png"),
                                 std::filesystem::file_size(path("large.png")) - 20);
    const std::vector<NamedFile> files{named("large.png", FileKind::texture),
                                       named("small.png", FileKind::texture),
                                       named("large.png", FileKind::environment)};
    FileCheckOptions by_header;
    by_header.most_bytes = std::filesystem::file_size(path("small.png"));
    const FileReport report = checker_.check(files, by_header);
    EXPECT_THAT(report.problems, IsEmpty());
    ASSERT_THAT(report.read_by_header, SizeIs(1));
    EXPECT_EQ(report.read_by_header.front().path, path("large.png"));
    EXPECT_THAT(messages(files), SizeIs(1));
    // The header itself is read.
    write("large.png", std::string("\x89PNG\r\n\x1a\n and nothing that belongs to a picture"));
    EXPECT_THAT(messages(files, by_header), SizeIs(1));
}

TEST_F(FileCheck, ChangedFile_IsReadAgain) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    EXPECT_THAT(messages({named("a.obj", FileKind::mesh)}), SizeIs(1));
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    std::filesystem::last_write_time(
        path("a.obj"), std::filesystem::last_write_time(path("a.obj")) + std::chrono::seconds(2));
    EXPECT_THAT(messages({named("a.obj", FileKind::mesh)}), IsEmpty());
}

TEST_F(FileCheck, Music_IsTriedByWhatTheProgramHas) {
    write("a.mp3", "no music");
    FileCheckOptions options;
    EXPECT_THAT(messages({named("a.mp3", FileKind::music)}, options), IsEmpty());
    options.try_music = [](const std::string& file) { throw Error("'" + file + "' is silent"); };
    FileChecker other;
    EXPECT_THAT(other.check(std::vector{named("a.mp3", FileKind::music)}, options).problems,
                SizeIs(1));
}

}  // namespace
}  // namespace carom::pipeline
