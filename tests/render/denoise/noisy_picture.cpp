#include "tests/render/denoise/noisy_picture.h"

#include <cmath>

namespace carom::render::test {

NoisyPicture::NoisyPicture(int picture_width, int picture_height)
    : width(picture_width), height(picture_height) {
    const std::size_t pixels = index(0, height);
    for (auto* planes : {&truth, &mean, &difference}) {
        for (std::vector<float>& plane : *planes) {
            plane.assign(pixels, 0);
        }
    }
    for (auto* planes : {&exact, &error, &feature_difference}) {
        for (std::vector<float>& plane : *planes) {
            plane.assign(pixels, 0);
        }
    }
}

template <class Visit>
void NoisyPicture::for_each_pixel(const Visit& visit) const {
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            visit(x, y, index(x, y));
        }
    }
}

void NoisyPicture::set_colour(int channel, const Value& value) {
    for_each_pixel([&](int x, int y, std::size_t i) {
        truth[channel][i] = mean[channel][i] = value(x, y);
        difference[channel][i] = 0;
    });
}

void NoisyPicture::set_feature(int feature, const Value& value) {
    for_each_pixel([&](int x, int y, std::size_t i) { exact[feature][i] = value(x, y); });
}

void NoisyPicture::add_noise(Noise& noise, float deviation) {
    add_noise(noise, [&](int, int) { return deviation; });
}

void NoisyPicture::add_noise(Noise& noise, const Value& deviation) {
    for_each_pixel([&](int x, int y, std::size_t i) {
        const float here = deviation(x, y);
        for (int c = 0; c < 3; ++c) {
            const float a = noise(here);
            const float b = noise(here);
            mean[c][i] += (a + b) / 2;
            difference[c][i] += (a - b) / 2;
        }
    });
}

void NoisyPicture::add_feature_noise(Noise& noise, int feature, float deviation, float slope) {
    for_each_pixel([&](int, int, std::size_t i) {
        const float a = noise(deviation);
        const float b = noise(deviation);
        error[feature][i] += (a + b) / 2;
        feature_difference[feature][i] += (a - b) / 2;
        for (int c = 0; c < 3; ++c) {
            mean[c][i] += slope * (a + b) / 2;
            difference[c][i] += slope * (a - b) / 2;
        }
    });
}

void NoisyPicture::mix_samples_into_exact(float part) {
    share.assign(mean[0].size(), part);
    for (std::size_t f = 0; f < kFeatures; ++f) {
        for (std::size_t i = 0; i < exact[f].size(); ++i) {
            exact[f][i] += part * error[f][i];
            error[f][i] *= 1 - part;
        }
    }
}

DenoiseInput NoisyPicture::input() const {
    DenoiseInput input;
    input.width = width;
    input.height = height;
    for (int c = 0; c < 3; ++c) {
        input.colour[c] = {{mean[c].data()}, {difference[c].data()}};
    }
    for (std::size_t f = 0; f < kFeatures; ++f) {
        input.features.push_back(
            {{exact[f].data()}, {error[f].data()}, {feature_difference[f].data()}});
    }
    if (!variance.empty()) {
        input.variance = {variance.data()};
    }
    if (!share.empty()) {
        input.share_of_samples = {share.data()};
    }
    return input;
}

NoisyPicture NoisyPicture::part(int x0, int y0, int part_width, int part_height) const {
    NoisyPicture result(part_width, part_height);
    const auto copy = [&](const std::vector<float>& from, std::vector<float>& to) {
        to.resize(result.index(0, part_height));
        result.for_each_pixel(
            [&](int x, int y, std::size_t i) { to[i] = from[index(x0 + x, y0 + y)]; });
    };
    for (int c = 0; c < 3; ++c) {
        copy(truth[c], result.truth[c]);
        copy(mean[c], result.mean[c]);
        copy(difference[c], result.difference[c]);
    }
    for (std::size_t f = 0; f < kFeatures; ++f) {
        copy(exact[f], result.exact[f]);
        copy(error[f], result.error[f]);
        copy(feature_difference[f], result.feature_difference[f]);
    }
    if (!variance.empty()) {
        copy(variance, result.variance);
    }
    if (!share.empty()) {
        copy(share, result.share);
    }
    return result;
}

double NoisyPicture::noisy_error() const {
    double sum = 0;
    for (int c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < mean[c].size(); ++i) {
            const auto d = static_cast<double>(mean[c][i] - truth[c][i]);
            sum += d * d;
        }
    }
    return sum / static_cast<double>(3 * mean[0].size());
}

double NoisyPicture::error_of(const DenoisedPicture& picture) const {
    double sum = 0;
    for (std::size_t i = 0; i < mean[0].size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto d = static_cast<double>(picture.rgb[3 * i + c] - truth[c][i]);
            sum += d * d;
        }
    }
    return sum / static_cast<double>(3 * mean[0].size());
}

NoisyPicture discs(int width, int height, std::uint32_t seed) {
    constexpr int kSpacing = 24;  // pixels
    NoisyPicture picture(width, height);
    const auto on_disc = [](int x, int y) {
        const int dx = x % kSpacing - kSpacing / 2;
        const int dy = y % kSpacing - kSpacing / 2;
        return dx * dx + dy * dy < 64;
    };
    const auto albedo = [&](int channel, int x, int y) {
        if (on_disc(x, y)) {
            return 0.3f + 0.2f * static_cast<float>((x / kSpacing + channel) % 3);
        }
        return 0.5f + 0.1f * static_cast<float>((x + 2 * y) % 3 - 1);
    };
    const auto height_of = [&](int x, int y) {
        return on_disc(x, y) ? 0.5f + 0.05f * static_cast<float>(y % kSpacing - 12) : 1.0f;
    };
    for (int c = 0; c < 3; ++c) {
        picture.set_colour(
            c, [&](int x, int y) { return albedo(c, x, y) * (0.3f + 0.4f * height_of(x, y)); });
        picture.set_feature(c, [&](int x, int y) { return albedo(c, x, y); });
    }
    picture.set_feature(5, height_of);
    Noise noise(seed);
    picture.add_feature_noise(noise, 1, 0.03f, 0.5f);
    picture.add_noise(noise, 0.05f);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if ((x / 40 + y / 30) % 3 == 0) {  // a texture that no feature knows
                const std::size_t i = picture.index(x, y);
                const float detail = 0.25f * static_cast<float>((x * x + 3 * y * y + x * y) % 5);
                picture.mean[0][i] += detail;
                picture.truth[0][i] += detail;
            }
        }
    }
    picture.variance.assign(picture.index(0, height), 0.02f);
    return picture;
}

}  // namespace carom::render::test
