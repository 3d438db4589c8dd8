// Display RGB to the planes that video codecs take.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace carom::pipeline {

/// One plane of a picture; `stride` is in elements.
template <class T>
struct PlaneView {
    T* data = nullptr;
    std::ptrdiff_t stride = 0;
};

/// 8-bit Y'CbCr of ITU-R BT.709-6 (items 3.2 to 3.5) in limited range, colour subsampled 4:2:0
/// with the siting that H.264 assumes unless told otherwise (ITU-T H.264, E.2.1,
/// chroma_sample_loc_type 0): level with the even columns, halfway between two rows.
///
/// `rgb`: width * height * 3, both even. The arithmetic is in integers: the same planes on every
/// processor. Codes between two whole ones are dithered by the pixel's place (dither.h), so every
/// code is within 1 of the exact value, and exact values stay.
void convert_to_yuv420(std::span<const std::uint16_t> rgb, int width, int height,
                       PlaneView<std::uint8_t> luma, PlaneView<std::uint8_t> blue_difference,
                       PlaneView<std::uint8_t> red_difference);

/// The three channels, unchanged, each in a plane.
void split_channels(std::span<const std::uint16_t> rgb, int width, int height,
                    PlaneView<std::uint16_t> red, PlaneView<std::uint16_t> green,
                    PlaneView<std::uint16_t> blue);

}  // namespace carom::pipeline
