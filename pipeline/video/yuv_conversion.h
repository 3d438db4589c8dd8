// Conversion of display RGB to the planes that video codecs need.
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

template <class T>
struct YuvPlanes {
    PlaneView<T> luma, blue_difference, red_difference;
};

/// Converts to 8-bit Y'CbCr of ITU-R BT.709-6 (items 3.2 to 3.5) in limited range. Colour is
/// subsampled 4:2:0 with the default siting of H.264 (ITU-T H.264, E.2.1, chroma_sample_loc_type
/// 0): at the even columns, halfway between two rows.
///
/// `rgb`: width * height * 3, both even. The arithmetic uses integers, so that every processor
/// gives the same planes. Fractional codes are dithered by the pixel's position (dither.h): every
/// code is within 1 of the exact value, and whole values do not change.
void convert_to_yuv420(std::span<const std::uint16_t> rgb, int width, int height,
                       const YuvPlanes<std::uint8_t>& planes);

struct YuvCoding {
    bool bt2020 = false;       // BT.2020's matrix (non-constant luminance) instead of BT.709's
    bool halve_height = true;  // 4:2:0; otherwise 4:2:2, on the same columns
};

/// The same in 10 bits: luma in [64, 940], colour in [64, 960], in the low bits of each code.
void convert_to_yuv10(std::span<const std::uint16_t> rgb, int width, int height, YuvCoding coding,
                      const YuvPlanes<std::uint16_t>& planes);

/// Converts to 8-bit Y'CbCr of JPEG: BT.601's matrix in full range (ITU-T T.871, 7), with colour at
/// every pixel. Dithered as above.
void convert_to_jpeg_yuv(std::span<const std::uint16_t> rgb, int width, int height,
                         const YuvPlanes<std::uint8_t>& planes);

/// Converts to 8 bits a channel: blue, green and red of each pixel. Dithered as above.
void convert_to_bgr24(std::span<const std::uint16_t> rgb, int width, int height,
                      PlaneView<std::uint8_t> pixels);

/// Copies the three channels, unchanged, into one plane each.
void split_channels(std::span<const std::uint16_t> rgb, int width, int height,
                    PlaneView<std::uint16_t> red, PlaneView<std::uint16_t> green,
                    PlaneView<std::uint16_t> blue);

}  // namespace carom::pipeline
