#include "render/film/image_file.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace carom::render {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class ImageFile : public testing::Test {
  protected:
    ImageFile()
        : folder_(testing::TempDir() + "carom_film_" +
                  testing::UnitTest::GetInstance()->current_test_info()->name()) {
        std::filesystem::create_directories(folder_);
    }
    ~ImageFile() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::string path(const std::string& name) const { return folder_ + "/" + name; }

    static std::string bytes(const std::string& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    static std::string message_of_reading(const std::string& file) {
        try {
            static_cast<void>(read_exr(file));
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(file));
            return error.what();
        }
        return "no error";
    }

  private:
    std::string folder_;
};

Film some_film(int width, int height) {
    Film film;
    film.width = width;
    film.height = height;
    Channel depth{"Z", {}};
    Channel normal{"N.X", {}};
    for (int i = 0; i < width * height; ++i) {
        const float x = static_cast<float>(i);
        film.rgba.insert(film.rgba.end(), {0.5f * x, 0.25f, 1 / (1 + x), 1});
        depth.values.push_back(1.000001f + x);
        normal.values.push_back(-0.333333333f);
    }
    film.aovs = {depth, normal};
    return film;
}

TEST_F(ImageFile, Exr_RoundTripsColoursAsHalfAndOthersAsFloat) {
    const Film film = some_film(37, 23);
    write_exr(film, path("a.exr"), {{"carom:shot", "break"}});
    const Film back = read_exr(path("a.exr"));
    ASSERT_EQ(back.width, 37);
    ASSERT_EQ(back.height, 23);
    ASSERT_EQ(back.aovs.size(), 2u);
    for (std::size_t i = 0; i < film.rgba.size(); ++i) {
        // Half: 11 bits of precision, so half a unit in the last place is 2^-11 of the value.
        ASSERT_NEAR(back.rgba[i], film.rgba[i], std::abs(film.rgba[i]) * 0x1p-11f + 1e-7f);
    }
    for (std::size_t c = 0; c < 2; ++c) {
        EXPECT_EQ(back.aovs[c].name, film.aovs[c].name);
        EXPECT_EQ(back.aovs[c].values, film.aovs[c].values);
    }
}

TEST_F(ImageFile, AsStored_IsWhatIsReadBack) {
    Film film = some_film(37, 23);
    film.aovs[0].values[5] = -1e30f;
    // Ties, subnormal numbers, and numbers beyond the largest.
    const float odd[] = {1 + 0x1p-11f, 1 + 0x3p-11f, 0x1.8p-25f, 0x1p-25f, -0x1.23p-20f,
                         65519,        65520,        -1e9f,      -0.0f,    0x1.ffep-15f};
    std::copy(std::begin(odd), std::end(odd), film.rgba.begin());
    film.notes = {{"cryptomatte/3ae39a5/name", "CryptoObject"}, {"from", "elsewhere"}};
    film.statistics.camera_rays = 12;
    const ImageMetadata metadata = {{"rays_camera", "12"}, {"carom_version", "1.2"}};
    write_exr(film, path("a.exr"), metadata);
    const Film read = read_exr(path("a.exr"));
    const Film stored = as_stored(film, metadata);
    EXPECT_EQ(std::memcmp(stored.rgba.data(), read.rgba.data(), 4 * read.rgba.size()), 0);
    EXPECT_NE(stored.rgba, film.rgba);
    ASSERT_EQ(stored.aovs.size(), read.aovs.size());
    for (std::size_t c = 0; c < read.aovs.size(); ++c) {
        EXPECT_EQ(stored.aovs[c].name, read.aovs[c].name);
        EXPECT_EQ(stored.aovs[c].values, read.aovs[c].values);
    }
    EXPECT_EQ(stored.notes, read.notes);
    EXPECT_EQ(stored.notes.at("rays_camera"), "12");
    EXPECT_EQ(stored.statistics.camera_rays, read.statistics.camera_rays);
}

TEST_F(ImageFile, ExrWrittenAgain_IsIdentical) {
    // The file contains halves already, so that reading and writing it changes nothing.
    write_exr(some_film(40, 30), path("a.exr"));
    const Film once = read_exr(path("a.exr"));
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // no time of the day is written
    write_exr(once, path("b.exr"));
    const Film twice = read_exr(path("b.exr"));
    EXPECT_EQ(once.rgba, twice.rgba);
    EXPECT_EQ(bytes(path("a.exr")), bytes(path("b.exr")));
}

TEST_F(ImageFile, SameFilm_SameBytes) {
    const ImageMetadata metadata = {{"carom:frame", "12"}, {"carom:shot", "break"}};
    write_exr(some_film(64, 36), path("a.exr"), metadata);
    write_exr(some_film(64, 36), path("b.tmp.123"), metadata);  // and under any name
    const std::string a = bytes(path("a.exr"));
    EXPECT_EQ(a, bytes(path("b.tmp.123")));
    EXPECT_THAT(a, HasSubstr("break"));
    EXPECT_EQ(a.find("DateTime"), std::string::npos);
    EXPECT_EQ(a.find("HostComputer"), std::string::npos);
    EXPECT_EQ(a.find("carom_film"), std::string::npos) << "the path is in the file";
}

TEST_F(ImageFile, Notes_ComeBackAndAreReadByOthers) {
    Film film = some_film(16, 16);
    film.notes = {{"cryptomatte/3ae39a5/name", "CryptoObject"},
                  {"cryptomatte/3ae39a5/manifest", std::string(3000, 'x')}};
    write_exr(film, path("a.exr"), {{"shot", "break"}});
    EXPECT_EQ(read_exr(path("a.exr")).notes, film.notes);
    const auto input = OIIO::ImageInput::open(path("a.exr"));
    ASSERT_TRUE(input);
    const OIIO::ImageSpec spec = input->spec();
    EXPECT_EQ(spec.get_string_attribute("cryptomatte/3ae39a5/name"), "CryptoObject");
    EXPECT_EQ(spec.get_string_attribute("shot"), "break");
    EXPECT_EQ(spec.channelformat(0), OIIO::TypeHalf);
    EXPECT_EQ(spec.channelformat(4), OIIO::TypeFloat);
}

// Another program's reader sees them with the types and names of the standard.
TEST_F(ImageFile, StandardAttributes_AreReadByOthersAndByUs) {
    ExrStandardAttributes standard;
    for (int i = 0; i < 16; ++i) {
        standard.world_to_camera[i / 4][i % 4] = static_cast<float>(i);
        standard.world_to_ndc[i / 4][i % 4] = static_cast<float>(100 + i);
    }
    standard.fps_numerator = 24000;
    standard.fps_denominator = 1001;
    write_exr(some_film(16, 9), path("a.exr"), {{"shot", "break"}}, standard);
    const std::string file = bytes(path("a.exr"));
    // How an attribute begins: two zero-terminated texts and a little-endian length.
    const auto start = [](const std::string& name, const std::string& type, char size) {
        return name + '\0' + type + '\0' + size + std::string(3, '\0');
    };
    EXPECT_THAT(file, HasSubstr(start("worldToCamera", "m44f", 64)));
    EXPECT_THAT(file, HasSubstr(start("worldToNDC", "m44f", 64)));
    EXPECT_THAT(file, HasSubstr(start("framesPerSecond", "rational", 8)));
    EXPECT_THAT(file, HasSubstr(start("chromaticities", "chromaticities", 32)));
    const auto input = OIIO::ImageInput::open(path("a.exr"));
    ASSERT_TRUE(input);
    const OIIO::ImageSpec spec = input->spec();
    Imath::M44f matrix;
    ASSERT_TRUE(spec.getattribute("worldtocamera", OIIO::TypeMatrix, &matrix));
    EXPECT_EQ(matrix, standard.world_to_camera);
    EXPECT_EQ(read_exr(path("a.exr")).rgba.size(), 4u * 16 * 9);
}

// A store of an earlier version stays usable.
TEST_F(ImageFile, ChannelsWithFormerNames_GetTheirCurrentNames) {
    Film film = some_film(4, 3);
    film.aovs = {{"Z", std::vector<float>(12, 1)},
                 {"object_id", std::vector<float>(12, 2)},
                 {"variance", std::vector<float>(12, 3)}};
    write_exr(film, path("a.exr"));
    std::vector<std::string> names;
    for (const Channel& channel : read_exr(path("a.exr")).aovs) {
        names.push_back(channel.name);
    }
    EXPECT_THAT(names, testing::UnorderedElementsAre("Z", "object_id.X", "variance.X"));
}

TEST_F(ImageFile, DisplayFormats_HoldTheSamePictureAndSayWhatItIs) {
    std::vector<std::uint8_t> rgb;
    for (int i = 0; i < 32 * 24; ++i) {
        const int x = i % 32;
        const int y = i / 32;
        rgb.insert(rgb.end(), {static_cast<std::uint8_t>(8 * x), static_cast<std::uint8_t>(10 * y),
                               static_cast<std::uint8_t>(4 * x + 5 * y)});
    }
    for (const std::string name : {"a.png", "a.bmp", "a.tga", "a.jpg"}) {
        write_display_image(rgb, 32, 24, path(name),
                            {{"ImageDescription", "break, frame 12"}, {"Software", "carom 1"}});
        const auto input = OIIO::ImageInput::open(path(name));
        ASSERT_TRUE(input) << name;
        const OIIO::ImageSpec spec = input->spec();
        ASSERT_EQ(spec.width, 32);
        ASSERT_EQ(spec.height, 24);
        ASSERT_EQ(spec.nchannels, 3) << name;
        std::vector<std::uint8_t> back(rgb.size());
        ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeUInt8, back.data()));
        int worst = 0;
        for (std::size_t i = 0; i < rgb.size(); ++i) {
            worst = std::max(worst, std::abs(int{back[i]} - int{rgb[i]}));
        }
        EXPECT_LE(worst, name == "a.jpg" ? 12 : 0) << name;
        if (name != "a.bmp") {  // the format has no place for it
            EXPECT_EQ(spec.get_string_attribute("ImageDescription"), "break, frame 12") << name;
        }
    }
}

TEST_F(ImageFile, NoFurtherChannels_IsFine) {
    Film film = some_film(16, 16);
    film.aovs.clear();
    write_exr(film, path("a.exr"));
    EXPECT_TRUE(read_exr(path("a.exr")).aovs.empty());
}

TEST_F(ImageFile, TooBrightPixels_AreClampedToHalf) {
    Film film = some_film(16, 16);
    film.rgba[0] = 1e9f;
    film.rgba[1] = -1e9f;
    film.aovs[0].values[0] = 1e9f;  // floats keep large values
    write_exr(film, path("a.exr"));
    const Film back = read_exr(path("a.exr"));
    EXPECT_EQ(back.rgba[0], 65504);
    EXPECT_EQ(back.rgba[1], -65504);
    EXPECT_EQ(back.aovs[0].values[0], 1e9f);
}

TEST_F(ImageFile, NotFinitePixel_IsRefusedByName) {
    const auto message = [&](const Film& film) {
        try {
            write_exr(film, path("bad.exr"));
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    Film film = some_film(16, 9);
    film.rgba[4 * (3 * 16 + 5) + 1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(message(film), "'" + path("bad.exr") +
                                 "': pixel (5, 3), channel G, is not a finite number; such a "
                                 "picture is not written");
    film = some_film(16, 9);
    film.aovs[1].values[17] = std::numeric_limits<float>::infinity();
    EXPECT_THAT(message(film), HasSubstr("pixel (1, 1), channel N.X"));
    EXPECT_FALSE(std::filesystem::exists(path("bad.exr")));
}

TEST_F(ImageFile, FolderMissing_IsAnError) {
    EXPECT_THROW(write_exr(some_film(16, 16), path("no/such/folder/a.exr")), Error);
    EXPECT_THROW(write_display_image(std::vector<std::uint8_t>(48), 4, 4, path("no/a.png")), Error);
}

/// Small files, too, whose data waits in a buffer until the file is closed.
TEST_F(ImageFile, DiskFull_IsAnErrorInEveryFormat) {
    const std::vector<std::uint8_t> rgb(3 * 16 * 16, 7);
    for (const std::string name : {"full.exr", "full.png", "full.jpg", "full.bmp", "full.tga"}) {
        std::filesystem::create_symlink("/dev/full", path(name));
        EXPECT_THAT(
            [&] {
                if (name == "full.exr") {
                    write_exr(some_film(16, 16), path(name));
                } else {
                    write_display_image(rgb, 16, 16, path(name));
                }
            },
            ThrowsMessage<Error>("'" + path(name) +
                                 "': the picture cannot be written: No space left on device"));
    }
}

TEST_F(ImageFile, FileMissing_IsAnError) {
    EXPECT_THAT(message_of_reading(path("none.exr")), HasSubstr("the frame cannot be read"));
}

TEST_F(ImageFile, ForeignFiles_AreRefused) {
    std::ofstream(path("text.exr")) << "this is no picture";
    EXPECT_NE(message_of_reading(path("text.exr")), "no error");
    std::ofstream(path("empty.exr")).flush();
    EXPECT_NE(message_of_reading(path("empty.exr")), "no error");
    write_display_image(std::vector<std::uint8_t>(3 * 16 * 16, 7), 16, 16, path("png.png"));
    std::filesystem::rename(path("png.png"), path("png.exr"));
    EXPECT_NE(message_of_reading(path("png.exr")), "no error");
}

/// Found by tests/fuzz/fuzz_store: OpenEXR cleared two gigabytes for a text of two bytes.
TEST_F(ImageFile, HeadersWithExcessiveSizes_AreRejectedBeforeUse) {
    write_exr(some_film(16, 9), path("a.exr"), {{"note", "xy"}});
    const std::string whole = bytes(path("a.exr"));
    const auto message = [&](const std::string& what, std::size_t skipped, const std::string& by) {
        std::string changed = whole;
        const std::size_t at = whole.find(what);
        EXPECT_NE(at, std::string::npos);
        changed.replace(at + skipped, by.size(), by);
        std::ofstream(path("b.exr"), std::ios::binary) << changed;
        return message_of_reading(path("b.exr"));
    };
    using namespace std::string_literals;
    EXPECT_THAT(message("note\0string\0"s, 12, "\xff\xff\xff\x7f"),
                HasSubstr("its header is longer than the file"));
    EXPECT_THAT(message("note\0string\0"s, 5, "strinG"),
                HasSubstr("frames have no attribute of the type 'strinG' and length 2"));
    EXPECT_THAT(message("displayWindow\0box2i\0"s, 20, "\x9"),
                HasSubstr("frames have no attribute of the type 'box2i' and length 9"));
    EXPECT_THAT(message("channels\0chlist\0"s, 20, "\0"s),
                HasSubstr("frames have no attribute of the type 'chlist'"));
    EXPECT_THAT(message("dataWindow\0box2i\0"s, 29, "\xff\xff\0\0\xff\xff\0\0"s),
                HasSubstr("the file is too short for its pixels"));
    EXPECT_THAT(message("compression\0compression\0"s, 28, "\4"),
                HasSubstr("frames are packed by 'zip'"));
    EXPECT_THAT(message("v/1\1"s, 5, "\x10"), HasSubstr("an OpenEXR file of another kind"));
    EXPECT_THAT(message("v/1\1"s, 0, "V"), HasSubstr("it is no OpenEXR file"));
}

TEST_F(ImageFile, TruncatedAnywhere_IsRefused) {
    write_exr(some_film(64, 36), path("a.exr"));
    const std::string whole = bytes(path("a.exr"));
    for (std::size_t keep = 0; keep < whole.size(); keep += 197) {
        std::ofstream(path("cut.exr"), std::ios::binary) << whole.substr(0, keep);
        EXPECT_NE(message_of_reading(path("cut.exr")), "no error") << keep;
    }
}

TEST_F(ImageFile, FlippedBytes_AreRefusedOrReadWithoutHarm) {
    write_exr(some_film(32, 18), path("a.exr"));
    const std::string whole = bytes(path("a.exr"));
    int refused = 0;
    for (std::size_t at = 0; at < whole.size(); at += 29) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
        std::ofstream(path("bad.exr"), std::ios::binary) << damaged;
        try {
            const Film film = read_exr(path("bad.exr"));
            EXPECT_EQ(film.rgba.size(), 4 * static_cast<std::size_t>(film.width) *
                                            static_cast<std::size_t>(film.height));
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 10);
}

TEST_F(ImageFile, DisplayImages_KeepTheirPixelsWhereTheFormatDoes) {
    std::vector<std::uint8_t> rgb;
    for (int i = 0; i < 3 * 31 * 17; ++i) {
        rgb.push_back(static_cast<std::uint8_t>(i * 7));
    }
    for (const std::string name : {"a.png", "a.bmp", "a.tga", "a.jpg"}) {
        write_display_image(rgb, 31, 17, path(name), {{"Description", "a test"}});
        write_display_image(rgb, 31, 17, path("b" + name), {{"Description", "a test"}});
        EXPECT_EQ(bytes(path(name)), bytes(path("b" + name))) << name;
        const auto input = OIIO::ImageInput::open(path(name));
        ASSERT_TRUE(input) << name;
        ASSERT_EQ(input->spec().width, 31);
        ASSERT_EQ(input->spec().height, 17);
        std::vector<std::uint8_t> back(rgb.size());
        ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeUInt8, back.data()));
        if (name != "a.jpg") {
            EXPECT_EQ(back, rgb) << name;
        }
    }
}

TEST_F(ImageFile, UnknownExtension_IsAnError) {
    const std::vector<std::uint8_t> rgb(48);
    EXPECT_THROW(write_display_image(rgb, 4, 4, path("a.nonsense")), Error);
}

}  // namespace
}  // namespace carom::render
