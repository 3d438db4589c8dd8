#include "sound/file/wav_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/assert.h"
#include "sound/sound_scene.h"

namespace carom::sound {
namespace {

constexpr std::uint32_t kChannels = 2;
constexpr std::uint32_t kSampleBytes = 3;
constexpr std::uint32_t kFrameBytes = kChannels * kSampleBytes;
constexpr std::uint32_t kBytesPerSecond = kSampleRate * kFrameBytes;
constexpr std::uint32_t kSampleBits = 8 * kSampleBytes;
constexpr std::uint32_t kFormatBytes = 16;
constexpr std::uint32_t kLongSizesBytes = 28;
constexpr std::uint32_t kSizeElsewhere = 0xFFFFFFFF;  // in the chunk ds64

void put(std::vector<std::byte>& bytes, std::string_view text) {
    for (const char c : text) {
        bytes.push_back(static_cast<std::byte>(c));
    }
}

/// Appends the lowest `count` bytes, the lowest first.
void put(std::vector<std::byte>& bytes, std::uint64_t number, unsigned count) {
    for (unsigned i = 0; i < count; ++i) {
        bytes.push_back(static_cast<std::byte>(number >> (8 * i) & 0xFF));
    }
}

void put_format(std::vector<std::byte>& bytes) {
    put(bytes, "fmt ");
    put(bytes, kFormatBytes, 4);
    put(bytes, 1, 2);  // PCM
    put(bytes, kChannels, 2);
    put(bytes, kSampleRate, 4);
    put(bytes, kBytesPerSecond, 4);
    put(bytes, kFrameBytes, 2);
    put(bytes, kSampleBits, 2);
}

}  // namespace

std::vector<std::byte> wav_header(std::int64_t frames) {
    const std::uint64_t data = static_cast<std::uint64_t>(frames) * kFrameBytes;
    // The size in the first chunk counts what follows it.
    const std::uint64_t short_size = 4 + 8 + kFormatBytes + 8 + data;
    const bool is_long = short_size > std::numeric_limits<std::uint32_t>::max() - 1;
    std::vector<std::byte> bytes;
    put(bytes, is_long ? "RF64" : "RIFF");
    put(bytes, is_long ? kSizeElsewhere : short_size, 4);
    put(bytes, "WAVE");
    if (is_long) {
        put(bytes, "ds64");
        put(bytes, kLongSizesBytes, 4);
        put(bytes, short_size + 8 + kLongSizesBytes, 8);
        put(bytes, data, 8);
        put(bytes, static_cast<std::uint64_t>(frames), 8);
        put(bytes, 0, 4);  // no further sizes
    }
    put_format(bytes);
    put(bytes, "data");
    put(bytes, is_long ? kSizeElsewhere : data, 4);
    return bytes;
}

std::int32_t pcm24(double sample) {
    constexpr double kScale = 8388608;  // 2^23
    return static_cast<std::int32_t>(
        std::clamp(std::nearbyint(sample * kScale), -kScale, kScale - 1));
}

WavFile::WavFile(const std::string& path, std::int64_t frames) : file_(path), missing_(frames) {
    CAROM_ASSERT(frames >= 0);
    file_.write(wav_header(frames));
}

void WavFile::write(std::span<const double> left, std::span<const double> right) {
    CAROM_ASSERT(left.size() == right.size());
    missing_ -= static_cast<std::int64_t>(left.size());
    CAROM_ASSERT(missing_ >= 0);
    bytes_.clear();
    for (std::size_t i = 0; i < left.size(); ++i) {
        put(bytes_, static_cast<std::uint32_t>(pcm24(left[i])), kSampleBytes);
        put(bytes_, static_cast<std::uint32_t>(pcm24(right[i])), kSampleBytes);
    }
    file_.write(bytes_);
}

void WavFile::finish() {
    CAROM_ASSERT(missing_ == 0);
    file_.finish();
}

}  // namespace carom::sound
