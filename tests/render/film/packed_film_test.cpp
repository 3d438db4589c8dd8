#include "render/film/packed_film.h"

#include <cmath>
#include <cstring>
#include <string>

#include <Imath/half.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
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
    Channel few{"half_albedo.R", {}, true};
    Channel many{"exact_normal.X", {}, true};
    Channel floats{"Z", {}};
    for (int i = 0; i < pixels; ++i) {
        few.values.push_back(static_cast<float>(i % 5 - 2) / 8);
        many.values.push_back(static_cast<float>(i - 200) / 256);
        floats.values.push_back(1 / static_cast<float>(i + 1));
    }
    film.aovs = {few, many, floats};
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
        EXPECT_EQ(a.aovs[i].is_half, b.aovs[i].is_half);
        EXPECT_EQ(a.aovs[i].values, b.aovs[i].values) << a.aovs[i].name;
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
    Channel all{"half.R", std::vector<float>(65536), true};
    Imath::half half;
    for (std::size_t i = 0; i < 65536; ++i) {
        half.setBits(static_cast<std::uint16_t>(i));
        all.values[i] = half.isFinite() ? static_cast<float>(half) : 0.0f;
    }
    film.aovs = {all};
    const Film back = unpack_film(pack_film(film, "film"));
    EXPECT_EQ(std::memcmp(back.aovs[0].values.data(), all.values.data(), 4 * 65536), 0)
        << "the sign of zero counts, too";
}

TEST(PackedFilm, ExactlyAndMoreThan256Values_AreKept) {
    for (const int different : {1, 255, 256, 257}) {
        Film film;
        film.width = 600;
        film.height = 1;
        film.rgba.resize(2400);
        Channel channel{"half.R", {}, true};
        for (int i = 0; i < 600; ++i) {
            channel.values.push_back(static_cast<float>(i % different));
        }
        film.aovs = {channel};
        EXPECT_EQ(unpack_film(pack_film(film, "film")).aovs[0].values, channel.values) << different;
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
    film.aovs.assign(60, {"depth", {1.0f}, true});
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
