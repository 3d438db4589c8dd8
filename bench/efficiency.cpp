// efficiency SCENE.json: renders a comparison scene with several seeds and prints CPU seconds,
// rays, relMSE and efficiency = 1 / (relMSE * CPU s), trimmed of the worst 0.1 % of the pixels and
// not.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <OpenImageIO/imageio.h>

#include "bench/peer_scene.h"

namespace carom::bench {
namespace {

using Picture = std::vector<float>;  // RGB

struct Run {
    Picture picture;
    double cpu_seconds = 0;
    double rays = 0;
    double camera_rays = 0;
};

struct Error {
    double trimmed = 0;
    double all = 0;
};

double cpu_now() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Run render_once(const PeerScene& scene, const render::PreparedScene& prepared, int seed) {
    render::FrameInput frame = scene.frame;
    frame.seed = static_cast<std::uint64_t>(seed);
    const double start = cpu_now();
    const render::Film film = render_frame(prepared, scene.tracks, frame, scene.settings);
    Run run;
    run.cpu_seconds = cpu_now() - start;
    const render::RenderStatistics& count = film.statistics;
    run.camera_rays = static_cast<double>(count.camera_rays);
    run.rays = static_cast<double>(count.camera_rays + count.scattered_rays + count.shadow_rays);
    for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
        run.picture.insert(run.picture.end(), {film.rgba[i], film.rgba[i + 1], film.rgba[i + 2]});
    }
    return run;
}

/// Mean over pixels and channels of (x - reference)^2 / (reference^2 + 0.01).
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

Picture mean_of(const std::vector<Run>& runs, std::size_t except) {
    Picture mean(runs[0].picture.size(), 0.0f);
    const float share = 1.0f / static_cast<float>(runs.size() - (except < runs.size() ? 1 : 0));
    for (std::size_t k = 0; k < runs.size(); ++k) {
        for (std::size_t i = 0; k != except && i < mean.size(); ++i) {
            mean[i] += share * runs[k].picture[i];
        }
    }
    return mean;
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

void write_picture(const std::string& path, const Picture& picture, const PeerScene& scene) {
    const auto file = OIIO::ImageOutput::create(path);
    const OIIO::ImageSpec spec(scene.settings.width, scene.settings.height, 3,
                               OIIO::TypeDesc::FLOAT);
    if (!file || !file->open(path, spec) ||
        !file->write_image(OIIO::TypeDesc::FLOAT, picture.data()) || !file->close()) {
        throw std::runtime_error("cannot write '" + path + "'");
    }
}

/// Error of every run, against the reference or else, with its expected noise subtracted, against
/// the mean of the other runs.
std::vector<Error> errors_of(const std::vector<Run>& runs, const std::string& reference) {
    std::vector<Error> errors;
    const Picture known = reference.empty() ? Picture() : read_picture(reference);
    const double others = static_cast<double>(runs.size()) - 1;
    const double own_share = known.empty() ? others / (others + 1) : 1;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        Error error = relative_error(runs[k].picture, known.empty() ? mean_of(runs, k) : known);
        error.all *= own_share;
        error.trimmed *= own_share;
        errors.push_back(error);
    }
    return errors;
}

void report(const std::vector<Run>& runs, const std::vector<Error>& errors) {
    double cpu = 0;
    double rays = 0;
    double camera_rays = 0;
    double trimmed = 0;
    double all = 0;
    double lowest = errors[0].all;
    double highest = errors[0].all;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        cpu += runs[k].cpu_seconds;
        rays += runs[k].rays;
        camera_rays += runs[k].camera_rays;
        trimmed += errors[k].trimmed;
        all += errors[k].all;
        lowest = std::min(lowest, errors[k].all);
        highest = std::max(highest, errors[k].all);
    }
    const double n = static_cast<double>(runs.size());
    const double pixels = static_cast<double>(runs[0].picture.size()) / 3;
    std::printf(
        "%zu seeds, %.1f samples: %.3f CPU s, %.2f Mrays/s per core, relMSE %.3e trimmed / %.3e "
        "all "
        "(%.2e to %.2e), efficiency %.0f / %.0f\n",
        runs.size(), camera_rays / n / pixels, cpu / n, rays / cpu / 1e6, trimmed / n, all / n,
        lowest, highest, n * n / (trimmed * cpu), n * n / (all * cpu));
}

int run(int argc, char** argv) {
    CLI::App app("Efficiency of the renderer on a comparison scene");
    std::string scene_path;
    std::string reference;
    std::string output;
    int samples = 16;
    int seeds = 8;
    int first_seed = 1;
    app.add_option("scene", scene_path, "neutral scene, JSON")->required();
    app.add_option("--samples", samples, "per pixel")->capture_default_str();
    double noise = 0;
    app.add_option("--noise", noise, "adaptive sampling down to this; --samples is the least then");
    app.add_option("--seeds", seeds, "runs")->capture_default_str()->check(CLI::Range(1, 4096));
    app.add_option("--first-seed", first_seed)->capture_default_str();
    app.add_option("--reference", reference, "EXR; without it runs are compared with each other");
    app.add_option("--mean", output, "write the mean of all runs to this EXR");
    CLI11_PARSE(app, argc, argv);
    PeerScene scene = read_peer_scene(scene_path);
    scene.settings.samples = samples;
    scene.settings.noise = noise;
    scene.settings.max_samples = 4096;
    const render::PreparedScene prepared(scene.scene, scene.settings);
    std::vector<Run> runs;
    for (int seed = 0; seed < seeds; ++seed) {
        runs.push_back(render_once(scene, prepared, first_seed + seed));
    }
    if (!output.empty()) {
        write_picture(output, mean_of(runs, runs.size()), scene);
    }
    if (seeds > 1 || !reference.empty()) {
        report(runs, errors_of(runs, reference));
    }
    return 0;
}

}  // namespace
}  // namespace carom::bench

int main(int argc, char** argv) {
    try {
        return carom::bench::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "efficiency: %s\n", error.what());
        return 1;
    }
}
