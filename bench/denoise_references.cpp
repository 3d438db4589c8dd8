// denoise_references FOLDER [--samples N] [--frames NAME...]: renders the references of
// denoise_gain into the folder, on one thread. What is there already is not rendered again.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "bench/gain_references.h"
#include "render/threads/thread_arena.h"

namespace {

using namespace carom;

std::vector<std::string> all_frames() {
    std::vector<std::string> names = bench::gain_frames();
    for (const std::string& name : bench::flicker_frames()) {
        names.push_back(name + "+1");
    }
    return names;
}

}  // namespace

int main(int count, char** words) {
    CLI::App app{"Renders the references of denoise_gain."};
    std::string folder;
    int samples = 4096;
    std::vector<std::string> frames = all_frames();
    bench::GainOptions options;
    app.add_option("folder", folder, "where they are written")->required();
    app.add_option("--samples", samples, "of a pixel")->capture_default_str();
    app.add_option("--frames", frames, "FILM@SECOND, FILM@SECOND+1 or benchmark");
    app.add_option("--width", options.width)->capture_default_str();
    app.add_option("--height", options.height)->capture_default_str();
    app.add_option("--bounces", options.max_bounces)->capture_default_str();
    CLI11_PARSE(app, count, words);
    try {
        std::filesystem::create_directories(folder);
        render::ThreadArena arena(1);
        for (const std::string& name : frames) {
            std::printf("%s\n", name.c_str());
            std::fflush(stdout);
            const auto frame = bench::open_gain_frame(name, options);
            const std::string path = bench::reference_path(folder, name, options);
            arena.execute([&] { bench::make_reference(path, *frame, samples); });
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "denoise_references: %s\n", error.what());
        return 1;
    }
}
