#include "tests/pipeline/cli/sound_files.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <cstring>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "tests/scratch_folder.h"

namespace carom::testing {

namespace {

constexpr std::size_t kHeader = 44;  // bytes
constexpr std::size_t kFrame = 6;    // bytes of both channels

/// A number of the header, little-endian.
std::uint32_t number(const std::string& bytes, std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = size; i-- > 0;) {
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

std::int32_t sample_at(const std::string& bytes, std::size_t at) {
    return static_cast<std::int32_t>(number(bytes, at, 3) << 8) / 256;
}

void require(bool condition, const std::string& what) {
    if (!condition) {
        throw std::runtime_error(what);
    }
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) {
        cells.push_back(cell);
    }
    return cells;
}

}  // namespace

WavSamples read_wav(const std::string& path) {
    const std::string bytes = read_text(path);
    require(bytes.size() >= kHeader && bytes.starts_with("RIFF"), path + " is not a .wav file");
    require(number(bytes, 22, 2) == 2 && number(bytes, 24, 4) == 48000 &&
                number(bytes, 34, 2) == 24 && number(bytes, 40, 4) == bytes.size() - kHeader,
            path + " has a wrong header");
    WavSamples samples;
    for (std::size_t at = kHeader; at + kFrame <= bytes.size(); at += kFrame) {
        samples.left.push_back(sample_at(bytes, at));
        samples.right.push_back(sample_at(bytes, at + 3));
    }
    return samples;
}

std::vector<double> in_full_scale(const std::vector<std::int32_t>& samples) {
    std::vector<double> result(samples.size());
    std::ranges::transform(samples, result.begin(), [](std::int32_t x) { return x / 0x1p23; });
    return result;
}

std::vector<HeardRow> read_heard(const std::string& path) {
    std::istringstream text(read_text(path));
    std::string line;
    require(static_cast<bool>(std::getline(text, line)), path + " is empty");
    const std::vector<std::string> names = cells_of(line);
    std::vector<HeardRow> rows;
    while (std::getline(text, line)) {
        const std::vector<std::string> cells = cells_of(line);
        require(cells.size() == names.size(), path + " has an incomplete row");
        std::map<std::string, std::string> row;
        for (std::size_t i = 0; i < names.size(); ++i) {
            row[names[i]] = cells[i];
        }
        const auto value = [&row](const char* name) { return std::stod(row.at(name)); };
        rows.push_back({row.at("kind"), row.at("a"), row.at("b"), row.at("camera"),
                        value("film_time"), value("scene_time"), value("speed"),
                        value("time_factor"), value("delay"), value("impulse"), value("peak_time"),
                        value("peak")});
    }
    return rows;
}

std::size_t peak_index(const std::vector<std::int32_t>& samples, std::int64_t from,
                       std::int64_t to) {
    const auto size = static_cast<std::int64_t>(samples.size());
    const auto first = samples.begin() + std::clamp<std::int64_t>(from, 0, size);
    const auto last = samples.begin() + std::clamp<std::int64_t>(to, 0, size);
    const auto found = std::max_element(
        first, last, [](std::int32_t a, std::int32_t b) { return std::abs(a) < std::abs(b); });
    return static_cast<std::size_t>(found - samples.begin());
}

double power_at(const std::vector<double>& samples, double frequency) {
    // The Fourier sum by Horner's rule.
    const std::complex<double> turn =
        std::polar(1.0, -2 * std::numbers::pi * frequency / kSampleRate);
    std::complex<double> sum = 0;
    for (auto sample = samples.rbegin(); sample != samples.rend(); ++sample) {
        sum = sum * turn + *sample;
    }
    return std::norm(sum);
}

double spectral_peak(const std::vector<double>& samples, double from, double to) {
    double best = from;
    double highest = -1;
    for (double frequency = from; frequency <= to; frequency *= 1.001) {
        const double power = power_at(samples, frequency);
        if (power > highest) {
            highest = power;
            best = frequency;
        }
    }
    return best;
}

}  // namespace carom::testing
