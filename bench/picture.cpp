#include "bench/picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <OpenImageIO/imageio.h>

namespace carom::bench {
namespace {

Error relative_error(const Picture& x, const Picture& reference) {
    std::vector<double> pixels;
    for (std::size_t i = 0; i < x.size(); i += 3) {
        double sum = 0;
        for (std::size_t c = i; c < i + 3; ++c) {
            const double f = static_cast<double>(reference[c]);
            const double d = static_cast<double>(x[c]) - f;
            sum += d * d / (f * f + 0.01) / 3;
        }
        pixels.push_back(sum);
    }
    std::sort(pixels.begin(), pixels.end());
    const std::size_t kept = pixels.size() - pixels.size() / 1000;
    Error error;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        error.all += pixels[i];
        error.trimmed += i < kept ? pixels[i] : 0;
    }
    error.all /= static_cast<double>(pixels.size());
    error.trimmed /= static_cast<double>(kept);
    return error;
}

struct BlockMean {
    double mean = 0;
    double variance = 0;  // of the mean
};

/// The mean of one block over the runs.
BlockMean block_mean(const std::vector<Picture>& runs, int width, int x0, int y0, int block) {
    double sum = 0;
    double squares = 0;
    for (const Picture& run : runs) {
        double mean = 0;
        for (int y = y0; y < y0 + block; ++y) {
            const std::size_t row =
                3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x0));
            for (std::size_t i = row; i < row + 3 * static_cast<std::size_t>(block); ++i) {
                mean += static_cast<double>(run[i]);
            }
        }
        mean /= 3.0 * block * block;
        sum += mean;
        squares += mean * mean;
    }
    const double n = static_cast<double>(runs.size());
    const double mean = sum / n;
    return {mean, std::max(0.0, squares / n - mean * mean) / (n - 1)};
}

}  // namespace

Picture mean_of(const std::vector<Picture>& pictures, std::size_t except) {
    Picture mean(pictures[0].size(), 0.0f);
    const std::size_t count = pictures.size() - (except < pictures.size() ? 1 : 0);
    const float weight = 1.0f / static_cast<float>(count);
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        for (std::size_t i = 0; k != except && i < mean.size(); ++i) {
            mean[i] += weight * pictures[k][i];
        }
    }
    return mean;
}

std::vector<Error> errors_of(const std::vector<Picture>& pictures, const std::string& reference) {
    std::vector<Error> errors;
    const Picture known = reference.empty() ? Picture() : read_picture(reference);
    const double others = static_cast<double>(pictures.size()) - 1;
    const double own_fraction = known.empty() ? others / (others + 1) : 1;
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        Error error = relative_error(pictures[k], known.empty() ? mean_of(pictures, k) : known);
        error.all *= own_fraction;
        error.trimmed *= own_fraction;
        errors.push_back(error);
    }
    return errors;
}

BlockComparison compare_blocks(const std::vector<Picture>& a, const std::vector<Picture>& b,
                               int width, int block, double tolerance, double standard_errors) {
    if (a.size() < 2 || b.size() < 2 || a[0].size() != b[0].size()) {
        throw std::runtime_error("blocks need two sets of at least two pictures of one size");
    }
    const int height = static_cast<int>(a[0].size()) / (3 * width);
    BlockComparison result;
    double sum_a = 0;
    double sum_b = 0;
    double worst_excess = -1;
    for (int y = 0; y + block <= height; y += block) {
        for (int x = 0; x + block <= width; x += block) {
            const BlockMean in_a = block_mean(a, width, x, y, block);
            const BlockMean in_b = block_mean(b, width, x, y, block);
            sum_a += in_a.mean;
            sum_b += in_b.mean;
            const double difference = std::abs(in_a.mean - in_b.mean);
            const double error = std::sqrt(in_a.variance + in_b.variance);
            const double excess =
                difference / std::max(tolerance * in_b.mean, standard_errors * error);
            result.blocks += 1;
            result.beyond += excess > 1 ? 1 : 0;
            if (excess > worst_excess) {
                worst_excess = excess;
                result.worst = difference / in_b.mean;
                result.worst_x = x;
                result.worst_y = y;
            }
        }
    }
    result.mean_difference = sum_a / sum_b - 1;
    return result;
}

Picture read_picture(const std::string& path) {
    const auto file = OIIO::ImageInput::open(path);
    if (!file) {
        throw std::runtime_error("cannot read '" + path + "'");
    }
    const OIIO::ImageSpec& spec = file->spec();
    Picture picture(3 * static_cast<std::size_t>(spec.width) *
                    static_cast<std::size_t>(spec.height));
    file->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, picture.data());
    return picture;
}

void write_picture(const std::string& path, const Picture& picture, int width) {
    const auto file = OIIO::ImageOutput::create(path);
    const int height = static_cast<int>(picture.size()) / (3 * width);
    const OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::FLOAT);
    if (!file || !file->open(path, spec) ||
        !file->write_image(OIIO::TypeDesc::FLOAT, picture.data()) || !file->close()) {
        throw std::runtime_error("cannot write '" + path + "'");
    }
}

}  // namespace carom::bench
