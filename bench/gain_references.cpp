#include "bench/gain_references.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace carom::bench {
namespace {

/// The sums of the pictures with even and with odd numbers. A picture's number is its seed.
struct Sums {
    std::uint32_t pictures = 0;
    std::uint32_t numbers = 0;  // of a sum
    std::vector<float> even, odd;
};

void write(const Sums& sums, const std::string& path) {
    const std::string unfinished = path + ".unfinished";
    std::ofstream file(unfinished, std::ios::binary);
    const auto put = [&](const void* data, std::size_t bytes) {
        file.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
    };
    put(&sums.pictures, sizeof sums.pictures);
    put(&sums.numbers, sizeof sums.numbers);
    put(sums.even.data(), sums.numbers * sizeof(float));
    put(sums.odd.data(), sums.numbers * sizeof(float));
    file.close();
    if (!file) {
        throw std::runtime_error("cannot write '" + unfinished + "'");
    }
    std::filesystem::rename(unfinished, path);
}

Sums read(const std::string& path, std::size_t numbers) {
    Sums sums;
    std::ifstream file(path, std::ios::binary);
    const auto get = [&](void* data, std::size_t bytes) {
        file.read(static_cast<char*>(data), static_cast<std::streamsize>(bytes));
    };
    get(&sums.pictures, sizeof sums.pictures);
    get(&sums.numbers, sizeof sums.numbers);
    if (!file || sums.numbers != numbers) {
        throw std::runtime_error("'" + path + "' is no reference of this size");
    }
    sums.even.resize(numbers);
    sums.odd.resize(numbers);
    get(sums.even.data(), numbers * sizeof(float));
    get(sums.odd.data(), numbers * sizeof(float));
    if (!file) {
        throw std::runtime_error("'" + path + "' is incomplete");
    }
    return sums;
}

}  // namespace

std::string reference_path(const std::string& folder, const std::string& frame,
                           const GainOptions& options) {
    return folder + "/" + frame + "_" + std::to_string(options.width) + "x" +
           std::to_string(options.height) + "_" + std::to_string(options.max_bounces) + ".ref";
}

Picture colours_of(const render::Film& film) {
    Picture result;
    result.reserve(film.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
        result.insert(result.end(), {film.rgba[i], film.rgba[i + 1], film.rgba[i + 2]});
    }
    return result;
}

void make_reference(const std::string& path, const GainFrame& frame, int samples) {
    constexpr int kFirstSeed = 1000;  // those below are measured
    Sums sums;
    const bool is_resumed = std::filesystem::exists(path);
    while (static_cast<int>(sums.pictures) * kReferenceNet < samples) {
        if (is_resumed && sums.pictures == 0) {
            std::uint32_t head[2] = {0, 0};
            std::ifstream(path, std::ios::binary).read(reinterpret_cast<char*>(head), sizeof head);
            sums = read(path, head[1]);
            continue;
        }
        const Picture picture =
            colours_of(frame.render({kReferenceNet}, kFirstSeed + static_cast<int>(sums.pictures)));
        sums.numbers = static_cast<std::uint32_t>(picture.size());
        sums.even.resize(picture.size());
        sums.odd.resize(picture.size());
        std::vector<float>& sum = sums.pictures % 2 == 0 ? sums.even : sums.odd;
        std::transform(picture.begin(), picture.end(), sum.begin(), sum.begin(), std::plus());
        sums.pictures += 1;
        write(sums, path);
    }
}

Reference read_reference(const std::string& path, const GainOptions& options) {
    const Sums sums = read(path, static_cast<std::size_t>(options.width) *
                                     static_cast<std::size_t>(options.height) * 3);
    const auto evens = static_cast<float>((sums.pictures + 1) / 2);
    const auto odds = static_cast<float>(sums.pictures / 2);
    if (odds == 0) {
        throw std::runtime_error("'" + path + "' is incomplete");
    }
    Reference reference;
    reference.samples = static_cast<int>(sums.pictures) * kReferenceNet;
    for (std::size_t i = 0; i < sums.even.size(); ++i) {
        const float a = sums.even[i] / evens;
        const float b = sums.odd[i] / odds;
        reference.mean.push_back(0.5f * (a + b));
        reference.difference.push_back(0.5f * (a - b));
    }
    return reference;
}

double error_of(const Picture& x, const Reference& reference) {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const auto r = static_cast<double>(reference.mean[i]);
        const auto own = static_cast<double>(reference.difference[i]);
        const double d = static_cast<double>(x[i]) - r;
        sum += (d * d - own * own) / (r * r + 0.01);
    }
    return sum / static_cast<double>(x.size());
}

}  // namespace carom::bench
