#include "pipeline/job/memory_forecast.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include "pipeline/video/codec_info.h"
#include "pipeline/video/encoder_presets.h"
#include "pipeline/video/image_sequence.h"
#include "pipeline/video/picture_kind.h"

namespace carom::pipeline {

namespace {

// All figures are differences of largest resident sizes on Debian 12 with two threads
// (docs/reliability.md has the table, bench/memory_forecast the command).

/// The program with its libraries, the table, the balls and a room around them.
constexpr double kProgram = 180e6;
/// The film of a frame, its tiles, the frame that is being stored, and its view transform.
constexpr double kPicturePerPixel = 62;
/// The sums of all samples of an evenly sampled frame that may be resumed, and of one that is
/// sampled adaptively, in halves; for the denoiser (render/frame/tile_sums.h).
constexpr double kEvenSums = 32;
constexpr double kSumsOfHalves = 48;
constexpr double kSumsForDenoiser = 121;
/// One AOV, while it is rendered and while it is stored.
constexpr double kPerPixelAndAov = 20;

/// What adaptive sampling measures between two rounds.
constexpr double kRoundsPerPixel = 60;

/// What the denoiser needs: 32 channels, while they are rendered, packed and filtered.
constexpr double kForDenoiser = 125;

/// The memory of a mesh in multiples of its file size: arrays in double, and the tree.
double mesh_growth(const std::string& extension) {
    return extension == ".ply" ? 6.5 : 3.3;
}
/// Images are stored in float, together with the table that is used to sample them.
constexpr double kImageGrowth = 8;

double scene_bytes(const Shot& shot) {
    double bytes = 0;
    for (const sim::Asset& asset : shot.assets) {
        std::error_code error;
        const auto size = std::filesystem::file_size(asset.path, error);
        const std::string extension = extension_of(asset.path);
        const bool is_mesh = extension == ".obj" || extension == ".ply";
        bytes +=
            error ? 0
                  : static_cast<double>(size) * (is_mesh ? mesh_growth(extension) : kImageGrowth);
    }
    return bytes;
}

/// The memory of the pictures that the encoder compares, in bytes per pixel at 8 bits.
double encoder_bytes_per_pixel(Codec codec, const OutputSettings& output) {
    switch (codec) {
        case Codec::h264:
            return presets_of(output.preset).h264_memory;
        case Codec::hevc:
            return presets_of(output.preset).hevc_memory;
        case Codec::av1:
            return 190;
        case Codec::vp9:
            return 125;
        case Codec::ffv1:
            return 145;
        case Codec::prores:
        case Codec::mjpeg:
        case Codec::uncompressed:
            return 20;
    }
    return 0;
}

double encoder_bytes(const Shot& shot, const std::string& output, double pixels) {
    if (is_image_sequence(output) || is_picture_path(output)) {
        return 0;
    }
    const Codec codec = codec_for(shot.output, output);
    const bool is_deep = bits_of(shot.output, codec) > 8 && info(codec).has_choice_of_bits;
    return pixels * encoder_bytes_per_pixel(codec, shot.output) * (is_deep ? 2 : 1);
}

}  // namespace

std::uint64_t forecast_memory(const Shot& shot, const std::string& output, bool keeps_sums) {
    const double pixels = static_cast<double>(shot.render.width) * shot.render.height;
    const auto aovs = static_cast<double>(shot.render.aovs.size());
    double per_pixel = kPicturePerPixel + aovs * kPerPixelAndAov;
    if (shot.render.for_denoiser) {
        per_pixel += kForDenoiser;
    }
    const bool is_adaptive = render::is_adaptive(shot.render);
    const double sums = shot.render.for_denoiser ? kSumsForDenoiser
                        : is_adaptive            ? kSumsOfHalves
                                                 : kEvenSums;
    if (is_adaptive) {
        // The film replaces the sums as it is written.
        per_pixel = std::max(per_pixel, sums + kRoundsPerPixel);
    } else if (keeps_sums) {
        per_pixel += sums;
    }
    const double bytes =
        kProgram + scene_bytes(shot) + pixels * per_pixel + encoder_bytes(shot, output, pixels);
    return static_cast<std::uint64_t>(std::llround(bytes));
}

std::string memory_text(std::uint64_t bytes) {
    const double amount = static_cast<double>(bytes);
    if (amount >= 1e9) {
        return fmt::format("{:.1f} GB", amount / 1e9);
    }
    return fmt::format("{:.0f} MB", amount >= 1e8 ? 10 * std::round(amount / 1e7) : amount / 1e6);
}

}  // namespace carom::pipeline
