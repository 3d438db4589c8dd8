// A packed film has a magic number, its size, its notes, the names and kinds of its channels, and
// then the numbers of each: R, G, B, A and the others (packed_plane.h). Texts follow their length
// in four bytes.
#include "render/film/packed_film.h"

#include <array>
#include <cstdint>
#include <iterator>
#include <string>

#include "core/assert.h"
#include "core/error.h"
#include "render/film/byte_stream.h"
#include "render/film/film_check.h"
#include "render/film/half_float.h"
#include "render/film/packed_plane.h"

namespace carom::render {
namespace {

constexpr std::array<char, 8> kMagic{'c', 'a', 'r', 'o', 'm', 'p', 'f', '1'};
constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;
/// Zstandard packs a byte that is repeated 128 kB at a time in four bytes (RFC 8878, 3.1.1.2).
constexpr std::int64_t kMostPacked = 32'768;

void append_text(const std::string& text, std::vector<std::byte>& bytes) {
    append_value(static_cast<std::uint32_t>(text.size()), bytes);
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    bytes.insert(bytes.end(), first, first + text.size());
}

std::string take_text(std::span<const std::byte>& bytes) {
    const std::span<const std::byte> text = take_bytes(take_value<std::uint32_t>(bytes), bytes);
    return {reinterpret_cast<const char*>(text.data()), text.size()};
}

/// Packs every `step`th value and returns whether all are finite.
[[nodiscard]] bool append_halves(const float* first, std::size_t step,
                                 std::vector<std::uint16_t>& halves, PlanePacker& packer,
                                 std::vector<std::byte>& bytes) {
    FiniteCheck check;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        const float value = first[step * i];
        check.add(value);
        halves[i] = half_bits(value);
    }
    packer.append(halves, bytes);
    return check.all_finite();
}

void take_halves(std::span<const std::byte>& bytes, std::vector<std::uint16_t>& halves,
                 float* first, std::size_t step) {
    unpack_halves(bytes, halves);
    Imath::half half;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        half.setBits(halves[i]);
        first[step * i] = half;
    }
}

/// The film without its numbers.
Film take_header(std::span<const std::byte>& bytes) {
    if (take_value<std::array<char, 8>>(bytes) != kMagic) {
        throw Error("it is no packed film");
    }
    Film film;
    film.width = take_value<std::int32_t>(bytes);
    film.height = take_value<std::int32_t>(bytes);
    for (auto count = take_value<std::uint32_t>(bytes); count > 0; --count) {
        std::string key = take_text(bytes);
        film.notes[std::move(key)] = take_text(bytes);
    }
    for (auto count = take_value<std::uint32_t>(bytes); count > 0; --count) {
        std::string name = take_text(bytes);
        const bool is_half = take_value<std::uint8_t>(bytes) != 0;
        if (!is_half && !film.half_aovs.empty()) {
            throw Error("its channels are in the wrong order");
        }
        is_half ? void(film.half_aovs.push_back({std::move(name), {}}))
                : void(film.aovs.push_back({std::move(name), {}}));
    }
    const std::int64_t pixels = std::int64_t{film.width} * film.height;
    const auto planes =
        4 + std::ssize(film.aovs) + std::ssize(film.half_aovs);  // of a byte per pixel at least
    if (film.width <= 0 || film.height <= 0 || pixels > kMostPixels ||
        pixels > kMostPacked * static_cast<std::int64_t>(bytes.size()) / planes) {
        throw Error("it is too short for its pixels");
    }
    return film;
}

}  // namespace

std::vector<std::byte> pack_film(const Film& film, const std::string& path) {
    const std::size_t pixels = film.rgba.size() / 4;
    std::vector<std::byte> bytes;
    append_value(kMagic, bytes);
    append_value(std::int32_t{film.width}, bytes);
    append_value(std::int32_t{film.height}, bytes);
    append_value(static_cast<std::uint32_t>(film.notes.size()), bytes);
    for (const auto& [key, text] : film.notes) {
        append_text(key, bytes);
        append_text(text, bytes);
    }
    append_value(static_cast<std::uint32_t>(film.aovs.size() + film.half_aovs.size()), bytes);
    for (const Channel& channel : film.aovs) {
        CAROM_ASSERT(channel.values.size() == pixels);
        append_text(channel.name, bytes);
        append_value(std::uint8_t{0}, bytes);
    }
    for (const HalfChannel& channel : film.half_aovs) {
        CAROM_ASSERT(channel.bits.size() == pixels);
        append_text(channel.name, bytes);
        append_value(std::uint8_t{1}, bytes);
    }
    PlanePacker packer;
    std::vector<std::uint16_t> halves(pixels);
    bool finite = true;
    for (std::size_t c = 0; c < 4; ++c) {
        finite = append_halves(film.rgba.data() + c, 4, halves, packer, bytes) && finite;
    }
    for (const Channel& channel : film.aovs) {
        finite = all_finite(channel.values) && finite;
        packer.append(channel.values, bytes);
    }
    for (const HalfChannel& channel : film.half_aovs) {
        packer.append(channel.bits, bytes);
    }
    if (!finite) {
        check_film(film, path);  // throws
    }
    return bytes;
}

Film unpack_film(std::span<const std::byte> bytes) {
    Film film = take_header(bytes);
    const auto pixels =
        static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
    film.rgba.resize(4 * pixels);
    std::vector<std::uint16_t> halves(pixels);
    for (std::size_t c = 0; c < 4; ++c) {
        take_halves(bytes, halves, film.rgba.data() + c, 4);
    }
    for (Channel& channel : film.aovs) {
        channel.values.resize(pixels);
        unpack_floats(bytes, channel.values);
    }
    for (HalfChannel& channel : film.half_aovs) {
        channel.bits.resize(pixels);
        unpack_halves(bytes, channel.bits);
    }
    if (!bytes.empty()) {
        throw Error("it is longer than its channels");
    }
    return film;
}

}  // namespace carom::render
