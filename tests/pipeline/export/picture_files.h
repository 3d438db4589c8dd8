// Small pictures in a temporary folder.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "render/image_files/png_file.h"
#include "tests/scratch_folder.h"

namespace carom::testing {

using Pixel = std::array<int, 4>;

class PictureFiles : public ::testing::Test {
  protected:
    /// A PNG file of these pixels, row by row from the top, three or four channels.
    std::string png(const std::string& name, int width, const std::vector<Pixel>& pixels,
                    int channels = 3) const {
        std::vector<std::uint8_t> values;
        for (const Pixel& pixel : pixels) {
            for (int c = 0; c < channels; ++c) {
                values.push_back(static_cast<std::uint8_t>(pixel[static_cast<std::size_t>(c)]));
            }
        }
        const int height = static_cast<int>(pixels.size()) / width;
        const std::vector<std::byte> bytes = render::encode_png(values, width, height, {});
        write_text(folder_.path(name),
                   std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
        return folder_.path(name);
    }

    /// The pixels of a PNG file; those without alpha have 255.
    static std::vector<Pixel> pixels_of(std::string_view file) {
        const render::RawPicture picture =
            render::decode_png(std::as_bytes(std::span(file.data(), file.size())), "test");
        std::vector<Pixel> pixels;
        const auto& values = std::get<std::vector<std::uint8_t>>(picture.values);
        const auto channels = static_cast<std::size_t>(picture.channels);
        for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
            Pixel pixel{0, 0, 0, 255};
            for (std::size_t c = 0; c < channels; ++c) {
                pixel[c] = values[i * channels + c];
            }
            pixels.push_back(pixel);
        }
        return pixels;
    }

    ScratchFolder folder_;
};

}  // namespace carom::testing
