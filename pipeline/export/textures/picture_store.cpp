#include "pipeline/export/textures/picture_store.h"

#include <algorithm>
#include <utility>

#include "core/field_hasher.h"
#include "pipeline/export/textures/baked_picture.h"
#include "render/image_files/read_picture.h"

namespace carom::pipeline {

namespace {

struct FileName {
    std::string path;
};
constexpr auto fields_of(Describes<FileName>) {
    return fields<FileName>(file_field("path", &FileName::path));
}

Hash128 stamp_of(const std::string& path) {
    FieldHasher hasher(FileHash::stamp);
    hasher.add_value(FileName{path});
    return hasher.finish();
}

/// The means of squares of pixels.
template <class Value>
std::vector<Value> means(const std::vector<Value>& values, const render::RawPicture& picture,
                         int width, int height, int step) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    std::vector<Value> result;
    result.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * channels);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (std::size_t c = 0; c < channels; ++c) {
                double sum = 0;
                int count = 0;
                for (int v = y * step; v < std::min((y + 1) * step, picture.height); ++v) {
                    for (int u = x * step; u < std::min((x + 1) * step, picture.width); ++u) {
                        const std::size_t pixel =
                            static_cast<std::size_t>(v) * static_cast<std::size_t>(picture.width) +
                            static_cast<std::size_t>(u);
                        sum += static_cast<double>(values[pixel * channels + c]);
                        ++count;
                    }
                }
                constexpr double kRounding = std::is_integral_v<Value> ? 0.5 : 0;
                result.push_back(static_cast<Value>(sum / count + kRounding));
            }
        }
    }
    return result;
}

render::RawPicture smaller(const render::RawPicture& picture, int most_side) {
    const int step = (std::max(picture.width, picture.height) + most_side - 1) / most_side;
    render::RawPicture result = picture;
    result.width = (picture.width + step - 1) / step;
    result.height = (picture.height + step - 1) / step;
    std::visit(
        [&](const auto& values) {
            result.values = means(values, picture, result.width, result.height, step);
        },
        picture.values);
    return result;
}

}  // namespace

struct PictureStore::Stored {
    std::shared_ptr<const render::RawPicture> picture;
    PictureFacts facts;
};

std::shared_ptr<const PictureStore::Stored> PictureStore::stored(const std::string& path) {
    return pictures_.get(stamp_of(path), [&] {
        render::RawPicture picture = render::read_picture(path);
        const PictureFacts facts = picture_facts(read_picture_bytes(path), picture);
        if (is_too_large(facts)) {
            picture = smaller(picture, limits_.most_side);
        }
        return Stored{std::make_shared<const render::RawPicture>(std::move(picture)), facts};
    });
}

PictureFacts PictureStore::facts(const std::string& path) {
    return *facts_.get(stamp_of(path), [&] { return stored(path)->facts; });
}

std::shared_ptr<const render::RawPicture> PictureStore::picture(const std::string& path) {
    return stored(path)->picture;
}

bool PictureStore::is_too_large(const PictureFacts& facts) const {
    return std::max(facts.width, facts.height) > limits_.most_side;
}

std::shared_ptr<const EncodedPicture> PictureStore::made(
    const Hash128& hash, const std::function<EncodedPicture()>& make) {
    return made_.get(hash, make);
}

}  // namespace carom::pipeline
