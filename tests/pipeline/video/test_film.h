// A short film for tests of the writer.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "pipeline/video/video_writer.h"
#include "tests/scratch_folder.h"

namespace carom::testing {

using Picture = std::vector<std::uint16_t>;

/// A saturated disc with a soft edge that moves over a gradient.
inline Picture moving_disc(int width, int height, int frame) {
    Picture picture;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double dx = x - width * (0.3 + 0.02 * frame);
            const double dy = y - height * 0.5;
            const double disc =
                1 / (1 + std::exp(0.5 * (std::sqrt(dx * dx + dy * dy) - height * 0.25)));
            const double ground = 0.2 + 0.3 * y / height;
            const auto code = [&](double paint, double cloth) {
                return static_cast<std::uint16_t>(65535 *
                                                  (disc * paint + (1 - disc) * cloth * ground));
            };
            picture.insert(picture.end(), {code(0.9, 0.1), code(0.7, 0.8), code(0.1, 0.5)});
        }
    }
    return picture;
}

struct Film {
    std::string name = "film.mp4";
    int width = 128;
    int height = 72;
    int frames = 30;
    pipeline::Rational fps{24};
    pipeline::OutputSettings output;
    std::map<std::string, std::string> metadata;

    std::string write(const ScratchFolder& folder) const {
        const std::string path = folder.path(name);
        pipeline::VideoWriter writer(path, {width, height, fps}, output, metadata);
        for (int i = 0; i < frames; ++i) {
            writer.write(moving_disc(width, height, i));
        }
        writer.finish();
        return path;
    }
};

}  // namespace carom::testing
