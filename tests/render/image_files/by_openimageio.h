// What OpenImageIO reads from a file, as the measure for carom's own readers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagecache.h>
#include <gtest/gtest.h>

#include "render/image_files/raw_picture.h"

namespace carom::render {

/// All values as numbers.
inline std::vector<float> values_of(const RawPicture& picture) {
    std::vector<float> values(
        std::visit([](const auto& stored) { return stored.size(); }, picture.values));
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = picture.value(i);
    }
    return values;
}

inline RawPicture by_openimageio(const std::string& path) {
    OIIO::ImageSpec wanted;
    wanted.attribute("oiio:UnassociatedAlpha", 1);
    OIIO::ImageBuf buffer(path, 0, 0, nullptr, &wanted);
    EXPECT_TRUE(buffer.read(0, 0, true, OIIO::TypeDesc::FLOAT)) << buffer.geterror();
    const OIIO::ImageSpec& spec = buffer.spec();
    RawPicture picture{spec.width, spec.height, spec.nchannels, false, {}};
    std::vector<float> values(picture.value_count());
    EXPECT_TRUE(buffer.get_pixels(OIIO::get_roi(spec), OIIO::TypeDesc::FLOAT, values.data()));
    picture.values = std::move(values);
    return picture;
}

/// A folder of the running test, which is removed with the object.
class PictureFolder : public testing::Test {
  protected:
    PictureFolder()
        : folder_(testing::TempDir() + "carom_" +
                  testing::UnitTest::GetInstance()->current_test_info()->test_suite_name() + "_" +
                  testing::UnitTest::GetInstance()->current_test_info()->name()) {
        std::filesystem::create_directories(folder_);
    }
    ~PictureFolder() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::string path(const std::string& name) const { return folder_ + "/" + name; }

  private:
    std::string folder_;
};

}  // namespace carom::render
