// Writing of frames as EXR. The other direction: exr_read.cpp.
#include <algorithm>
#include <cstring>
#include <exception>
#include <span>
#include <vector>

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfRationalAttribute.h>
#include <ImfStringAttribute.h>

#include "render/film/exr_notes.h"
#include "render/film/film_check.h"
#include "render/film/half_float.h"
#include "render/film/image_file.h"
#include "render/film/picture_bytes.h"
#include "render/image_files/exr_library.h"

namespace carom::render {
namespace {

constexpr const char* kColourNames[4] = {"R", "G", "B", "A"};

/// A file in memory.
class MemoryFile : public Imf::OStream {
  public:
    MemoryFile() : OStream("memory") {}

    void write(const char bytes[], int count) override {
        const std::size_t size = static_cast<std::size_t>(count);
        bytes_.resize(std::max(bytes_.size(), position_ + size));
        std::memcpy(bytes_.data() + position_, bytes, size);
        position_ += size;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

  private:
    std::vector<std::byte> bytes_;
    std::size_t position_ = 0;
};

void add_texts(Imf::Header& header, const ImageMetadata& texts) {
    for (const auto& [key, value] : texts) {
        // As OpenEXR calls it ("Standard Attributes", openexr.com).
        const std::string name = key == "ImageDescription" ? "comments" : key;
        header.insert(name, Imf::StringAttribute(value));
    }
}

void add_standard(Imf::Header& header, const ExrStandardAttributes& standard) {
    // ITU-R BT.709-6, item 1.4.
    const Imf::Chromaticities rec709({0.64f, 0.33f}, {0.30f, 0.60f}, {0.15f, 0.06f},
                                     {0.3127f, 0.3290f});
    header.insert("worldToCamera", Imf::M44fAttribute(standard.world_to_camera));
    header.insert("worldToNDC", Imf::M44fAttribute(standard.world_to_ndc));
    const Imf::Rational fps(standard.fps_numerator, standard.fps_denominator);
    header.insert("framesPerSecond", Imf::RationalAttribute(fps));
    header.insert("chromaticities", Imf::ChromaticitiesAttribute(rec709));
}

void add_channels(Imf::Header& header, const Film& film) {
    for (const char* name : kColourNames) {
        header.channels().insert(name, Imf::Channel(Imf::HALF));
    }
    for (const Channel& aov : film.aovs) {
        header.channels().insert(aov.name, Imf::Channel(Imf::FLOAT));
    }
}

using Halves = std::vector<Imath::half>;

Halves as_halves(const std::vector<float>& values) {
    Halves halves(values.size());
    std::transform(values.begin(), values.end(), halves.begin(), to_half);
    return halves;
}

/// Where the library finds the pixels. It only reads them, although it takes pointers to char.
Imf::FrameBuffer buffer_of(const Film& film, const Halves& colours) {
    const std::size_t width = static_cast<std::size_t>(film.width);
    Imf::FrameBuffer buffer;
    const auto insert = [&](const std::string& name, Imf::PixelType type, const void* start,
                            std::size_t step) {
        buffer.insert(name, Imf::Slice(type, const_cast<char*>(static_cast<const char*>(start)),
                                       step, step * width));
    };
    for (std::size_t c = 0; c < 4; ++c) {
        insert(kColourNames[c], Imf::HALF, colours.data() + c, 4 * sizeof(Imath::half));
    }
    for (const Channel& aov : film.aovs) {
        insert(aov.name, Imf::FLOAT, aov.values.data(), sizeof(float));
    }
    return buffer;
}

}  // namespace

void write_exr(const Film& film, const std::string& path, const ImageMetadata& metadata,
               const std::optional<ExrStandardAttributes>& standard) {
    check_film(film, path);
    const Halves colours = as_halves(film.rgba);
    MemoryFile memory;
    try {
        Imf::Header header(film.width, film.height);
        header.compression() = Imf::ZIP_COMPRESSION;
        add_channels(header, film);
        // The same picture has the same bytes, so that no file holds the time of the day.
        header.insert("capDate", Imf::StringAttribute("1970:01:01 00:00:00"));
        add_texts(header, metadata);
        add_texts(header, film.notes);
        if (standard) {
            add_standard(header, *standard);
        }
        use_exr_threads();
        Imf::OutputFile output(memory, header);
        output.setFrameBuffer(buffer_of(film, colours));
        output.writePixels(film.height);
    } catch (const std::exception& error) {
        refuse_to_write(path, exr_reason(error.what()));
    }
    write_picture_bytes(path, memory.bytes());
}

Film as_stored(Film film, const ImageMetadata& metadata) {
    std::transform(film.rgba.begin(), film.rgba.end(), film.rgba.begin(), as_half);
    film.notes.insert(metadata.begin(), metadata.end());
    std::erase_if(film.notes, [](const auto& note) { return !is_note(note.first); });
    film.statistics = {};
    return film;
}

}  // namespace carom::render
