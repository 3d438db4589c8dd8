// Image files for tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace carom::test {

/// A picture in a temporary file that is removed with the object.
class TemporaryPicture {
  public:
    /// `name`: different for each of a test.
    explicit TemporaryPicture(const std::string& ending, const std::string& name = "")
        : path_((std::filesystem::temp_directory_path() /
                 ("carom_picture_" + std::to_string(getpid()) + "_" +
                  std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) +
                  name + ending))
                    .string()) {}
    ~TemporaryPicture() { std::filesystem::remove(path_); }
    TemporaryPicture(const TemporaryPicture&) = delete;
    TemporaryPicture& operator=(const TemporaryPicture&) = delete;

    template <class Value>
    void write(int width, int height, int channels, OIIO::TypeDesc type,
               const std::vector<Value>& values) const {
        const auto file = OIIO::ImageOutput::create(path_);
        ASSERT_TRUE(file && file->open(path_, OIIO::ImageSpec(width, height, channels, type)));
        ASSERT_TRUE(file->write_image(OIIO::BaseTypeFromC<Value>::value, values.data()));
        ASSERT_TRUE(file->close());
    }

    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    std::string path_;
};

}  // namespace carom::test
