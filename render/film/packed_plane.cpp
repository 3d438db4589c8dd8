#include "render/film/packed_plane.h"

#include <algorithm>
#include <bit>

#include <zstd.h>

#include "core/assert.h"
#include "core/error.h"
#include "render/film/byte_stream.h"

namespace carom::render {
namespace {

constexpr int kLevel = 1;  // three times as fast as level 3, which saves one percent
constexpr std::size_t kMaxListed = 256;

/// How the bytes that are compressed stand for numbers.
enum class Coding : std::uint8_t { listed, differences, floats };

/// Small numbers for small differences of either sign.
std::uint16_t folded(std::uint16_t difference) {
    const auto sign = static_cast<std::uint16_t>(difference >> 15 ? 0xffffU : 0);
    return static_cast<std::uint16_t>((difference << 1) ^ sign);
}
std::uint16_t unfolded(std::uint16_t number) {
    const auto sign = static_cast<std::uint16_t>(number & 1 ? 0xffffU : 0);
    return static_cast<std::uint16_t>((number >> 1) ^ sign);
}

/// The different values, ascending; empty if there are more than kMaxListed.
std::vector<std::uint16_t> list_of(std::span<const std::uint16_t> values) {
    std::vector<std::uint8_t> occurs(std::size_t{1} << 16);
    for (const std::uint16_t value : values) {
        occurs[value] = 1;
    }
    std::vector<std::uint16_t> list;
    for (std::size_t value = 0; value < occurs.size(); ++value) {
        if (occurs[value] != 0) {
            if (list.size() == kMaxListed) {
                return {};
            }
            list.push_back(static_cast<std::uint16_t>(value));
        }
    }
    return list;
}

/// The bytes that stand for halves, in `bytes`.
void write_places(std::span<const std::uint16_t> halves, const std::vector<std::uint16_t>& list,
                  std::vector<std::uint8_t>& bytes) {
    std::vector<std::uint8_t> place(std::size_t{1} << 16);
    for (std::size_t i = 0; i < list.size(); ++i) {
        place[list[i]] = static_cast<std::uint8_t>(i);
    }
    bytes.resize(halves.size());
    std::transform(halves.begin(), halves.end(), bytes.begin(),
                   [&](std::uint16_t half) { return place[half]; });
}

void write_differences(std::span<const std::uint16_t> halves, std::vector<std::uint8_t>& bytes) {
    const std::size_t count = halves.size();
    bytes.resize(2 * count);
    std::uint16_t before = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint16_t number = folded(static_cast<std::uint16_t>(halves[i] - before));
        before = halves[i];
        bytes[i] = static_cast<std::uint8_t>(number >> 8);
        bytes[count + i] = static_cast<std::uint8_t>(number);
    }
}

/// Takes a block of Zstandard from the front, which must have so many bytes when it is unpacked.
std::vector<std::uint8_t> unpack_bytes(std::size_t count, std::span<const std::byte>& packed) {
    const std::span<const std::byte> block = take_bytes(take_value<std::uint64_t>(packed), packed);
    if (ZSTD_getFrameContentSize(block.data(), block.size()) != count) {
        throw Error("a channel has another size");
    }
    std::vector<std::uint8_t> bytes(count);
    if (ZSTD_decompress(bytes.data(), count, block.data(), block.size()) != count) {
        throw Error("a channel cannot be unpacked");
    }
    return bytes;
}

void read_places(std::span<const std::byte>& packed, std::span<std::uint16_t> halves) {
    const std::size_t listed = take_value<std::uint16_t>(packed);
    std::vector<std::uint16_t> list(listed);
    for (std::uint16_t& value : list) {
        value = take_value<std::uint16_t>(packed);
    }
    const std::vector<std::uint8_t> bytes = unpack_bytes(halves.size(), packed);
    list.resize(kMaxListed);
    std::transform(bytes.begin(), bytes.end(), halves.begin(),
                   [&](std::uint8_t place) { return list[place]; });
}

void read_differences(std::span<const std::byte>& packed, std::span<std::uint16_t> halves) {
    const std::size_t count = halves.size();
    const std::vector<std::uint8_t> bytes = unpack_bytes(2 * count, packed);
    std::uint16_t before = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = static_cast<std::uint16_t>(bytes[i] << 8 | bytes[count + i]);
        before = static_cast<std::uint16_t>(before + unfolded(number));
        halves[i] = before;
    }
}

}  // namespace

struct PlanePacker::Compressor {
    ZSTD_CCtx* context = ZSTD_createCCtx();

    Compressor() = default;
    ~Compressor() { ZSTD_freeCCtx(context); }
    Compressor(const Compressor&) = delete;
    Compressor& operator=(const Compressor&) = delete;
    Compressor(Compressor&&) = delete;
    Compressor& operator=(Compressor&&) = delete;
};

PlanePacker::PlanePacker() : compressor_(std::make_unique<Compressor>()) {
    if (compressor_->context == nullptr) {
        throw Error("there is not enough memory to compress a frame");
    }
}

PlanePacker::~PlanePacker() = default;

/// Appends a block's length and the block.
void PlanePacker::append_bytes(std::vector<std::byte>& packed) {
    const std::size_t begin = packed.size() + sizeof(std::uint64_t);
    packed.resize(begin + ZSTD_compressBound(bytes_.size()));
    const std::size_t size =
        ZSTD_compressCCtx(compressor_->context, packed.data() + begin, packed.size() - begin,
                          bytes_.data(), bytes_.size(), kLevel);
    CAROM_ASSERT(ZSTD_isError(size) == 0);  // it has room enough
    packed.resize(begin + size);
    const std::uint64_t length = size;
    std::memcpy(packed.data() + begin - sizeof(length), &length, sizeof(length));
}

void PlanePacker::append(std::span<const std::uint16_t> halves, std::vector<std::byte>& packed) {
    const std::vector<std::uint16_t> list = list_of(halves);
    if (list.empty()) {
        append_value(Coding::differences, packed);
        write_differences(halves, bytes_);
    } else {
        append_value(Coding::listed, packed);
        append_value(static_cast<std::uint16_t>(list.size()), packed);
        for (const std::uint16_t value : list) {
            append_value(value, packed);
        }
        write_places(halves, list, bytes_);
    }
    append_bytes(packed);
}

void PlanePacker::append(std::span<const float> floats, std::vector<std::byte>& packed) {
    append_value(Coding::floats, packed);
    const std::size_t count = floats.size();
    bytes_.resize(4 * count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto bits = std::bit_cast<std::uint32_t>(floats[i]);
        for (std::size_t k = 0; k < 4; ++k) {
            bytes_[k * count + i] = static_cast<std::uint8_t>(bits >> 8 * k);
        }
    }
    append_bytes(packed);
}

void unpack_halves(std::span<const std::byte>& packed, std::span<std::uint16_t> halves) {
    switch (take_value<Coding>(packed)) {
        case Coding::listed:
            read_places(packed, halves);
            return;
        case Coding::differences:
            read_differences(packed, halves);
            return;
        case Coding::floats:
            break;
    }
    throw Error("a channel is of another kind");
}

void unpack_floats(std::span<const std::byte>& packed, std::span<float> floats) {
    if (take_value<Coding>(packed) != Coding::floats) {
        throw Error("a channel is of another kind");
    }
    const std::size_t count = floats.size();
    const std::vector<std::uint8_t> bytes = unpack_bytes(4 * count, packed);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            bits |= std::uint32_t{bytes[k * count + i]} << 8 * k;
        }
        floats[i] = std::bit_cast<float>(bits);
    }
}

}  // namespace carom::render
