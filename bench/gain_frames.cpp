#include "bench/gain_frames.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

#include "bench/peer_scene.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "sim/bake.h"

namespace carom::bench {
namespace {

void apply(const GainOptions& options, render::RenderSettings& settings) {
    settings.integrator = render::IntegratorKind::path;
    settings.width = options.width;
    settings.height = options.height;
    settings.max_bounces = options.max_bounces;
    settings.noise = 0;
    settings.aovs.clear();
}

std::uint64_t mixed(std::uint64_t frame_seed, int seed) {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15;  // a number without structure
    return frame_seed + kGolden * (static_cast<std::uint64_t>(seed) << 1 | 1);
}

render::Film render_with(const render::PreparedScene& scene, const std::vector<sim::Track>& tracks,
                         render::FrameInput frame, render::RenderSettings settings,
                         const Sampling& sampling, int seed) {
    frame.seed = mixed(frame.seed, seed);
    settings.samples = sampling.samples;
    settings.noise = sampling.noise;
    settings.max_samples = 2048;
    settings.for_denoiser = sampling.for_denoiser;
    return render::render_frame(scene, tracks, frame, settings);
}

class FilmFrame final : public GainFrame {
  public:
    FilmFrame(const std::string& film, double second, int frames_later, const GainOptions& options)
        : shot_(load(film, options)) {
        sim::Bake bake;
        bake.timeline = sim::bake(shot_.world);
        pipeline::add_keyed_motions(bake, shot_);
        const pipeline::FilmSource source(shot_, bake.timeline);
        const auto frame =
            static_cast<std::int64_t>(std::llround(second * shot_.timing.fps.to_double()));
        inputs_ = source.inputs(frame + frames_later);
        scene_.emplace(shot_.scene, shot_.render);
    }

    [[nodiscard]] render::Film render(const Sampling& sampling, int seed) const override {
        return render_with(*scene_, inputs_.tracks, inputs_.frame, shot_.render, sampling, seed);
    }

  private:
    static pipeline::Shot load(const std::string& film, const GainOptions& options) {
        const std::string path = CAROM_SOURCE_DIR "/examples/" + film + ".yaml";
        pipeline::LoadResult loaded = pipeline::load_shot(path);
        if (!loaded.shot) {
            throw std::runtime_error("'" + path + "' has errors; see carom check");
        }
        apply(options, loaded.shot->render);
        return std::move(*loaded.shot);
    }

    pipeline::Shot shot_;
    pipeline::FrameInputs inputs_;
    std::optional<render::PreparedScene> scene_;
};

class BenchmarkFrame final : public GainFrame {
  public:
    explicit BenchmarkFrame(const GainOptions& options)
        : peer_(read_peer_scene(CAROM_SOURCE_DIR "/bench/peers/scene_train.json")) {
        apply(options, peer_.settings);
        scene_.emplace(peer_.scene, peer_.settings);
    }

    [[nodiscard]] render::Film render(const Sampling& sampling, int seed) const override {
        return render_with(*scene_, peer_.tracks, peer_.frame, peer_.settings, sampling, seed);
    }

  private:
    PeerScene peer_;
    std::optional<render::PreparedScene> scene_;
};

}  // namespace

std::unique_ptr<const GainFrame> open_gain_frame(const std::string& name,
                                                 const GainOptions& options) {
    if (name == "benchmark") {
        return std::make_unique<BenchmarkFrame>(options);
    }
    const std::size_t at = name.find('@');
    if (at == std::string::npos) {
        throw std::runtime_error("'" + name + "' is no frame: FILM@SECOND or benchmark");
    }
    const std::size_t plus = name.find('+', at);
    const int later = plus == std::string::npos ? 0 : std::stoi(name.substr(plus + 1));
    return std::make_unique<FilmFrame>(name.substr(0, at), std::stod(name.substr(at + 1)), later,
                                       options);
}

const std::vector<std::string>& gain_frames() {
    static const std::vector<std::string> names{"nine_ball_break@4",
                                                "nine_ball_break@1.25",
                                                "jump_shot@2",
                                                "snooker_break_off@3",
                                                "park@3",
                                                "domino_run@3",
                                                "benchmark"};
    return names;
}

const std::vector<std::string>& flicker_frames() {
    static const std::vector<std::string> names{"nine_ball_break@4", "jump_shot@2"};
    return names;
}

}  // namespace carom::bench
