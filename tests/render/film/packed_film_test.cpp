#include "render/film/packed_film.h"

#include <cmath>
#include <cstring>
#include <numeric>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "render/film/half_float.h"
#include "render/film/image_file.h"

namespace carom::render {
namespace {

/// A film of 37 x 11 pixels with every kind of channel.
Film some_film() {
    Film film;
    film.width = 37;
    film.height = 11;
    const int pixels = film.width * film.height;
    for (int i = 0; i < 4 * pixels; ++i) {
        film.rgba.push_back(std::exp(0.01f * static_cast<float>(i)) - 1);
    }
    HalfChannel few{"half_albedo.R", {}};
    HalfChannel many{"exact_normal.X", {}};
    Channel floats{"Z", {}};
    for (int i = 0; i < pixels; ++i) {
        few.bits.push_back(half_bits(static_cast<float>(i % 5 - 2) / 8));
        many.bits.push_back(half_bits(static_cast<float>(i - 200) / 256));
        floats.values.push_back(1 / static_cast<float>(i + 1));
    }
    film.aovs = {floats};
    film.half_aovs = {few, many};
    film.notes = {{"cryptomatte/1/name", "object"}, {"rays_camera", "1234"}};
    film.statistics.camera_rays = 7;
    return as_stored(std::move(film), {});
}

void expect_same(const Film& a, const Film& b) {
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.rgba, b.rgba);
    EXPECT_EQ(a.notes, b.notes);
    ASSERT_EQ(a.aovs.size(), b.aovs.size());
    for (std::size_t i = 0; i < a.aovs.size(); ++i) {
        EXPECT_EQ(a.aovs[i].name, b.aovs[i].name);
        EXPECT_EQ(a.aovs[i].values, b.aovs[i].values) << a.aovs[i].name;
    }
    ASSERT_EQ(a.half_aovs.size(), b.half_aovs.size());
    for (std::size_t i = 0; i < a.half_aovs.size(); ++i) {
        EXPECT_EQ(a.half_aovs[i].name, b.half_aovs[i].name);
        EXPECT_EQ(a.half_aovs[i].bits, b.half_aovs[i].bits) << a.half_aovs[i].name;
    }
}

TEST(PackedFilm, Film_IsUnpackedUnchanged) {
    const Film film = some_film();
    expect_same(unpack_film(pack_film(film, "film")), film);
}

TEST(PackedFilm, EveryHalfFloat_KeepsItsBits) {
    Film film;
    film.width = 256;
    film.height = 256;
    film.rgba.resize(4 * 65536);
    HalfChannel all{"half.R", std::vector<std::uint16_t>(65536)};
    std::iota(all.bits.begin(), all.bits.end(), std::uint16_t{0});
    film.half_aovs = {all};
    EXPECT_EQ(unpack_film(pack_film(film, "film")).half_aovs[0].bits, all.bits);
}

TEST(PackedFilm, ExactlyAndMoreThan256Values_AreKept) {
    for (const int different : {1, 255, 256, 257}) {
        Film film;
        film.width = 600;
        film.height = 1;
        film.rgba.resize(2400);
        HalfChannel channel{"half.R", {}};
        for (int i = 0; i < 600; ++i) {
            channel.bits.push_back(half_bits(static_cast<float>(i % different)));
        }
        film.half_aovs = {channel};
        EXPECT_EQ(unpack_film(pack_film(film, "film")).half_aovs[0].bits, channel.bits)
            << different;
    }
}

TEST(PackedFilm, ValuesBeyondHalfFloats_AreRoundedAsAnExrFileRoundsThem) {
    Film film;
    film.width = 1;
    film.height = 1;
    film.rgba = {1e9f, -1e9f, 0.1f, 1};
    EXPECT_EQ(unpack_film(pack_film(film, "film")).rgba, as_stored(film, {}).rgba);
}

TEST(PackedFilm, BytesThatAreMissingOrTooMany_AreAnError) {
    const std::vector<std::byte> whole = pack_film(some_film(), "film");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_THROW((void)unpack_film(std::span(whole).first(size)), Error) << size;
    }
    std::vector<std::byte> longer = whole;
    longer.push_back(std::byte{0});
    EXPECT_THROW((void)unpack_film(longer), Error);
}

TEST(PackedFilm, SizeThatTheBytesCannotHave_IsRefusedBeforeMemoryIsTaken) {
    std::vector<std::byte> bytes = pack_film(some_film(), "film");
    const std::int32_t edge = 16384;
    std::memcpy(bytes.data() + 8, &edge, sizeof(edge));
    std::memcpy(bytes.data() + 12, &edge, sizeof(edge));
    EXPECT_THAT([&] { (void)unpack_film(bytes); },
                testing::ThrowsMessage<Error>("it is too short for its pixels"));
    bytes[0] = std::byte{'x'};
    EXPECT_THAT([&] { (void)unpack_film(bytes); },
                testing::ThrowsMessage<Error>("it is no packed film"));
}

// Zstandard packs a plane of equal bytes 32768 times at most, and the film has a plane per channel.
TEST(PackedFilm, ChannelsThatTheBytesCannotHave_AreRefusedBeforeMemoryIsTaken) {
    Film film;
    film.width = film.height = 1;
    film.rgba.assign(4, 0.5f);
    film.half_aovs.assign(60, {"depth", {1}});
    std::vector<std::byte> bytes = pack_film(film, "film");
    const auto edge =
        static_cast<std::int32_t>(std::sqrt(32'768.0 * 0.1 * static_cast<double>(bytes.size())));
    std::memcpy(bytes.data() + 8, &edge, sizeof(edge));
    std::memcpy(bytes.data() + 12, &edge, sizeof(edge));
    EXPECT_THAT([&] { (void)unpack_film(bytes); },
                testing::ThrowsMessage<Error>("it is too short for its pixels"));
}

}  // namespace
}  // namespace carom::render
