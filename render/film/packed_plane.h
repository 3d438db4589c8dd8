// Compresses the numbers of one channel, losslessly and fast.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace carom::render {

/// Compresses channels, one after the other; a context of the compressor is kept between them.
///
/// A channel of half floats with at most 256 different values is stored as their list and one byte
/// for each pixel; this is what rounding to a few digits leaves. In other ones neighbours are
/// alike, so the differences of their bit patterns are stored, high bytes first, then low bytes.
/// Floats are stored as four planes of bytes. Zstandard (RFC 8878) then packs the bytes at its
/// fastest usual level.
class PlanePacker {
  public:
    PlanePacker();
    ~PlanePacker();
    PlanePacker(const PlanePacker&) = delete;
    PlanePacker& operator=(const PlanePacker&) = delete;
    PlanePacker(PlanePacker&&) = delete;
    PlanePacker& operator=(PlanePacker&&) = delete;

    /// Appends the packed values to `packed`. `halves`: their bit patterns.
    void append(std::span<const std::uint16_t> halves, std::vector<std::byte>& packed);
    void append(std::span<const float> floats, std::vector<std::byte>& packed);

  private:
    struct Compressor;
    void append_bytes(std::vector<std::byte>& packed);

    std::unique_ptr<Compressor> compressor_;
    std::vector<std::uint8_t> bytes_;  // before they are compressed
};

/// Takes a channel from the front of `packed`. Throws Error if it is not what a PlanePacker makes
/// of so many numbers.
void unpack_halves(std::span<const std::byte>& packed, std::span<std::uint16_t> halves);
void unpack_floats(std::span<const std::byte>& packed, std::span<float> floats);

}  // namespace carom::render
