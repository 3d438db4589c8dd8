// denoise_gain FOLDER: what denoising gains on frames of the examples and on the benchmark scene,
// against the references in the folder (denoise_references). It renders each frame without and with
// the denoiser, on one thread, and prints CPU seconds, errors and the gain at equal CPU time; the
// blocks that denoising made worse; and how much films flicker.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/gain_blocks.h"
#include "bench/gain_references.h"
#include "core/cpu_time.h"
#include "pipeline/store/frame_store.h"
#include "render/film/image_file.h"
#include "render/frame/denoiser_planes.h"
#include "render/threads/thread_arena.h"

namespace carom::bench {
namespace {

struct Options {
    GainOptions size;
    std::string folder;
    std::vector<std::string> frames = gain_frames();
    std::vector<int> samples{2, 8, 32};                   // denoised
    std::vector<int> compared{2, 4, 8, 16, 32, 64, 128};  // noisy
    std::vector<double> noise;                            // targets of adaptive sampling
    int seeds = 4;
    bool lists_blocks = false;
};

constexpr double kNever = 1e9;  // s

/// Of a way to make a picture: CPU seconds, the least of all seeds, since other work on the machine
/// only adds to them, and the error, the mean over seeds.
struct Cost {
    int samples = 0;
    double seconds = kNever;
    double error = 0;
};

struct Denoised {
    std::vector<Picture> noisy, clean;  // by seed
    Cost cost;
    double noisy_error = 0;
    double estimated = 0;       // error, by the denoiser itself
    double rendering = kNever;  // CPU s
    double filtering = kNever;
    double storing = kNever;
};

template <class Work>
double cpu_of(const Work& work) {
    const double begin = process_cpu_seconds();
    work();
    return process_cpu_seconds() - begin;
}

/// Does the work; `least` becomes its CPU seconds if they are fewer.
template <class Work>
void shorten(double& least, const Work& work) {
    least = std::min(least, cpu_of(work));
}

Cost noisy_cost(const GainFrame& frame, int samples, const Reference& reference,
                const Options& options) {
    Cost cost;
    cost.samples = samples;
    for (int seed = 0; seed < options.seeds; ++seed) {
        render::Film film;
        shorten(cost.seconds, [&] { film = frame.render({samples}, seed); });
        cost.error += error_of(colours_of(film), reference) / options.seeds;
    }
    return cost;
}

Denoised denoise(const GainFrame& frame, int samples, const Reference& reference,
                 const Options& options) {
    const pipeline::FrameStore store(options.folder + "/stored");
    Denoised result;
    const double pixels = options.size.width * options.size.height;
    for (int seed = 0; seed < options.seeds; ++seed) {
        render::Film noisy;
        render::Film clean;
        shorten(result.rendering, [&] { noisy = frame.render({samples, 0, true}, seed); });
        shorten(result.filtering, [&] { clean = render::denoised(noisy); });
        const render::Film stored =
            render::as_stored(noisy, {});  // as all frames are, noisy or not
        shorten(result.storing, [&] { store.write_noisy({}, stored); });
        for (const float error : render::error_after_denoising(noisy)) {
            result.estimated += static_cast<double>(error) / (pixels * options.seeds);
        }
        result.noisy.push_back(colours_of(noisy));
        result.clean.push_back(colours_of(clean));
        result.noisy_error += error_of(result.noisy.back(), reference) / options.seeds;
        result.cost.error += error_of(result.clean.back(), reference) / options.seeds;
    }
    result.cost.samples = samples;
    result.cost.seconds = result.rendering + result.filtering + result.storing;
    return result;
}

/// The error of a noisy picture that takes this time, interpolated in logarithms.
double error_at(const std::vector<Cost>& curve, double seconds) {
    std::size_t i = 1;
    while (i + 1 < curve.size() && curve[i].seconds < seconds) {
        ++i;
    }
    const Cost& a = curve[i - 1];
    const Cost& b = curve[i];
    const double slope = std::log(b.error / a.error) / std::log(b.seconds / a.seconds);
    return a.error * std::pow(seconds / a.seconds, slope);
}

std::vector<Cost> curve_of(const GainFrame& frame, const Reference& reference,
                           const Options& options) {
    std::vector<Cost> curve;
    for (const int samples : options.compared) {
        curve.push_back(noisy_cost(frame, samples, reference, options));
        std::printf("  %4d samples: %6.3f CPU s, error %.3e\n", samples, curve.back().seconds,
                    curve.back().error);
    }
    return curve;
}

void print(const BlockGain& gain, bool lists_blocks) {
    std::printf("    blocks worse: %.2f %% of %d, largest factor %.2f\n",
                100.0 * gain.worse / gain.blocks, gain.blocks, gain.largest_factor);
    for (const WorseBlock& block : gain.worst) {
        if (lists_blocks) {
            std::printf("      (%3d, %3d): %.2e from %.2e\n", block.x, block.y, block.clean,
                        block.noisy);
        }
    }
}

/// Adaptive sampling from 8 samples on.
void measure_adaptive(const GainFrame& frame, double noise, bool for_denoiser,
                      const Reference& reference, const Options& options) {
    constexpr int kFirst = 8;
    double seconds = 0;
    double error = 0;
    double samples = 0;
    for (int seed = 0; seed < options.seeds; ++seed) {
        render::Film film;
        seconds += cpu_of([&] {
            film = frame.render({kFirst, noise, for_denoiser}, seed);
            film = for_denoiser ? render::denoised(film) : film;
        });
        error += error_of(colours_of(film), reference);
        samples += static_cast<double>(film.statistics.camera_rays) / options.size.width /
                   options.size.height;
    }
    const double left = std::sqrt(error / options.seeds);
    std::printf("  %s until %.4f: left %.4f (%.2f), %.1f samples, %.3f CPU s\n",
                for_denoiser ? "denoised" : "noisy", noise, left, left / noise,
                samples / options.seeds, seconds / options.seeds);
    std::fflush(stdout);
}

/// Products of gains, by the place of the sample count in the options.
struct Products {
    std::vector<double> gain, least;
};

void measure(const std::string& name, const Options& options, Products& products) {
    const auto frame = open_gain_frame(name, options.size);
    const Reference reference =
        read_reference(reference_path(options.folder, name, options.size), options.size);
    std::printf("%s, reference of %d samples\n", name.c_str(), reference.samples);
    const std::vector<Cost> curve = curve_of(*frame, reference, options);
    for (std::size_t i = 0; i < options.samples.size(); ++i) {
        const Denoised result = denoise(*frame, options.samples[i], reference, options);
        const double equal = error_at(curve, result.cost.seconds);
        const double gain = equal / result.cost.error;
        products.gain[i] *= gain;
        products.least[i] = std::min(products.least[i], gain);
        std::printf(
            "  %4d denoised: %6.3f CPU s (%.3f rendering, %.3f filtering, %.3f storing), "
            "error %.3e from %.3e (%.2f), estimated %.3e; at equal time %.2f\n",
            options.samples[i], result.cost.seconds, result.rendering, result.filtering,
            result.storing, result.cost.error, result.noisy_error,
            result.noisy_error / result.cost.error, result.estimated, gain);
        if (options.seeds > 1) {
            print(compare_blocks(result.noisy, result.clean, reference, options.size.width),
                  options.lists_blocks);
        }
        std::fflush(stdout);
    }
    for (const double noise : options.noise) {
        measure_adaptive(*frame, noise, false, reference, options);
        measure_adaptive(*frame, noise, true, reference, options);
    }
}

void measure_flicker(const std::string& name, const Options& options) {
    const std::string next_name = name + "+1";
    const auto reference_of = [&](const std::string& which) {
        return read_reference(reference_path(options.folder, which, options.size), options.size);
    };
    const Reference before = reference_of(name);
    const Reference after = reference_of(next_name);
    const auto frame = open_gain_frame(name, options.size);
    const auto next = open_gain_frame(next_name, options.size);
    std::printf("%s and the next frame\n", name.c_str());
    for (const int samples : options.samples) {
        Flicker noisy;
        Flicker clean;
        for (int seed = 0; seed < options.seeds; ++seed) {
            const render::Film a = frame->render({samples, 0, true}, 2 * seed);
            const render::Film b = next->render({samples, 0, true}, 2 * seed + 1);
            noisy += flicker(colours_of(a), colours_of(b), before, after, options.size.width);
            clean += flicker(colours_of(render::denoised(a)), colours_of(render::denoised(b)),
                             before, after, options.size.width);
        }
        std::printf("  %4d samples: flicker %.2f times lower, that of 8x8 means %.2f times\n",
                    samples, noisy.of_pixels / clean.of_pixels, noisy.of_blocks / clean.of_blocks);
        std::fflush(stdout);
    }
}

void run(const Options& options, bool flickers) {
    Products products;
    products.gain.assign(options.samples.size(), 1);
    products.least.assign(options.samples.size(), 1e9);
    for (const std::string& name : options.frames) {
        measure(name, options, products);
    }
    for (std::size_t i = 0; i < options.samples.size(); ++i) {
        const double mean =
            std::pow(products.gain[i], 1.0 / static_cast<double>(options.frames.size()));
        std::printf("%d samples: geometric mean %.2f, least %.2f\n", options.samples[i], mean,
                    products.least[i]);
    }
    if (flickers) {
        for (const std::string& name : flicker_frames()) {
            measure_flicker(name, options);
        }
    }
}

}  // namespace
}  // namespace carom::bench

int main(int count, char** words) {
    CLI::App app{"What denoising gains."};
    carom::bench::Options options;
    bool flickers = false;
    app.add_option("folder", options.folder, "of the references")->required();
    app.add_option("--frames", options.frames, "FILM@SECOND or benchmark");
    app.add_option("--samples", options.samples, "that are denoised")->capture_default_str();
    app.add_option("--compared", options.compared, "samples of the noisy pictures");
    app.add_option("--noise", options.noise, "targets of adaptive sampling");
    app.add_option("--seeds", options.seeds)->capture_default_str();
    app.add_option("--width", options.size.width)->capture_default_str();
    app.add_option("--height", options.size.height)->capture_default_str();
    app.add_option("--bounces", options.size.max_bounces)->capture_default_str();
    app.add_flag("--blocks", options.lists_blocks, "lists the ten blocks that became worst");
    app.add_flag("--flicker", flickers, "measures flicker, too");
    CLI11_PARSE(app, count, words);
    try {
        carom::render::ThreadArena arena(1);
        arena.execute([&] { carom::bench::run(options, flickers); });
    } catch (const std::exception& error) {
        std::fprintf(stderr, "denoise_gain: %s\n", error.what());
        return 1;
    }
}
