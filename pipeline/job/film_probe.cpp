#include "pipeline/job/film_probe.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/cpu_time.h"

namespace carom::pipeline {
namespace {

/// Blocks of one size. Large ones tell most about the size of a film, small ones suffice for time.
constexpr std::array kPlans{BlockPlan{64, 2, 6, 20}, BlockPlan{32, 4, 12, 64},
                            BlockPlan{16, 4, 24, 200}};
constexpr double kMostFrames = 1000;   // in sequences, of all sites
constexpr int kSequence = 4;           // pictures
constexpr double kCertain = 0.01;      // relative standard error of a frame's time
constexpr double kPart = 0.1;          // of a film's time that its forecast may take
constexpr double kSequencePart = 0.7;  // of the forecast's time

/// The number of places in the film where a camera's pictures are measured.
std::size_t sites_per_camera(std::size_t cameras) {
    return cameras <= 4 ? 3 : cameras <= 8 ? 2 : 1;
}

/// The relative standard error of the time of a frame, from those of its blocks.
double standard_error(const render::ProbeCost& cost) {
    const auto count = static_cast<double>(cost.per_pixel.size());
    double sum = 0;
    double squares = 0;
    for (const double value : cost.per_pixel) {
        sum += value;
        squares += value * value;
    }
    const double mean = sum / count;
    if (count < 2 || mean <= 0) {
        return 1;
    }
    return std::sqrt(std::max(0.0, squares / count - mean * mean) / (count - 1)) / mean;
}

bool is_certain(const SiteMeasurement& site) {
    return standard_error(site.frames.front().cost()) < kCertain;
}

}  // namespace

std::size_t SiteMeasurement::common_blocks() const {
    std::size_t count = blocks.empty() ? 0 : blocks.front().size();
    for (const std::vector<render::Film>& of_frame : blocks) {
        count = std::min(count, of_frame.size());
    }
    return count;
}

FilmProbe::FilmProbe(const FilmSource& source, const FilmPlan& plan,
                     const std::vector<std::size_t>& pictures)
    : source_(source), plan_(plan), plan_of_blocks_(kPlans.back()) {
    for (const std::size_t picture : pictures) {
        const FilmPlan::Picture& planned = plan.pictures[picture];
        const std::string rig = source.layers(planned.frame).at(planned.layer).rig;
        auto found = std::find_if(cameras_.begin(), cameras_.end(),
                                  [&](const ProbeCamera& camera) { return camera.name == rig; });
        if (found == cameras_.end()) {
            found = cameras_.insert(found, ProbeCamera{rig, {}});
        }
        found->pictures.push_back(picture);
    }
    choose_sites();
}

/// The first sites of all cameras come first, then the second ones.
void FilmProbe::choose_sites() {
    const std::size_t most = sites_per_camera(cameras_.size());
    for (std::size_t i = 0; i < most; ++i) {
        for (std::size_t camera = 0; camera < cameras_.size(); ++camera) {
            const std::vector<std::size_t>& pictures = cameras_[camera].pictures;
            if (i >= pictures.size()) {
                continue;
            }
            const std::size_t count = std::min(most, pictures.size());
            // In the middle of equal parts, the middle part first.
            const std::size_t part = (count / 2 + i) % count;
            const std::size_t place = pictures.size() * (2 * part + 1) / (2 * count);
            const std::size_t end = std::min(pictures.size(), place + kSequence);
            SiteMeasurement measurement;
            measurement.site.camera = camera;
            measurement.site.pictures.assign(pictures.begin() + static_cast<std::ptrdiff_t>(place),
                                             pictures.begin() + static_cast<std::ptrdiff_t>(end));
            sites_.push_back(std::move(measurement));
        }
    }
}

/// Opens the next frame of the site's sequence. Returns false if there is none.
bool FilmProbe::open_frame(SiteMeasurement& site, const render::PreparedScene& scene) {
    if (site.frames.size() == site.site.pictures.size()) {
        return false;
    }
    const FilmPlan::Picture& picture = plan_.pictures[site.site.pictures[site.frames.size()]];
    const FrameInputs inputs = source_.inputs(source_.layers(picture.frame).at(picture.layer));
    site.frames.emplace_back(scene, inputs.tracks, inputs.frame, source_.shot().render,
                             plan_of_blocks_.size);
    site.blocks.emplace_back();
    return true;
}

/// Adds blocks until each frame of the site has `count` of them.
void FilmProbe::add_blocks(SiteMeasurement& site, int count, const std::stop_token& limit) {
    for (std::size_t i = 0; i < site.frames.size(); ++i) {
        while (std::ssize(site.blocks[i]) < count && site.frames[i].blocks_left() > 0 &&
               !limit.stop_requested()) {
            std::vector<render::Film> more =
                site.frames[i].render_blocks(plan_of_blocks_.at_once, {{}, limit});
            std::move(more.begin(), more.end(), std::back_inserter(site.blocks[i]));
        }
    }
}

/// A first estimate of the time to render all pictures.
double FilmProbe::film_seconds() const {
    double seconds = 0;
    double measured = 0;
    double pictures = 0;
    for (const SiteMeasurement& site : sites_) {
        if (!site.frames.empty() && site.frames.front().cost().pixels > 0) {
            seconds += site.frames.front().frame_seconds();
            measured += 1;
        }
    }
    for (const ProbeCamera& camera : cameras_) {
        pictures += static_cast<double>(camera.pictures.size());
    }
    return measured > 0 ? pictures * seconds / measured : 0;
}

/// Opens second, third ... frames of as many sites as `frames` allows.
void FilmProbe::extend_sequences(const render::PreparedScene& scene, std::size_t frames,
                                 const std::stop_token& limit) {
    for (std::size_t length = 2; length <= kSequence; ++length) {
        for (std::size_t i = 0; i < sites_.size() && length * (i + 1) <= frames; ++i) {
            if (!limit.stop_requested() && sites_[i].frames.size() == length - 1) {
                (void)open_frame(sites_[i], scene);
            }
        }
    }
}

/// Measures a few small blocks of each site, replaces them by blocks of a size that the budget
/// allows, and returns the budget in CPU seconds.
double FilmProbe::scout(const render::PreparedScene& scene, const CpuBudget& allowed,
                        const std::stop_token& limit) {
    for (SiteMeasurement& site : sites_) {
        if (!limit.stop_requested() && open_frame(site, scene)) {
            add_blocks(site, kPlans.back().at_once, limit);
        }
    }
    const double film = film_seconds();
    const double budget = std::min(allowed.most, std::max(allowed.least, kPart * film));
    double pictures = 0;
    for (const ProbeCamera& camera : cameras_) {
        pictures += static_cast<double>(camera.pictures.size());
    }
    const render::RenderSettings& settings = source_.shot().render;
    const double per_pixel = film / pictures / settings.width / settings.height;
    const auto found = std::find_if(kPlans.begin(), kPlans.end(), [&](const BlockPlan& plan) {
        return per_pixel * plan.size * plan.size * plan.fewest *
                   static_cast<double>(sites_.size()) <
               kSequencePart * budget;
    });
    if (found != kPlans.end() && found->size > plan_of_blocks_.size) {
        plan_of_blocks_ = *found;
        for (SiteMeasurement& site : sites_) {
            site.frames.clear();
            site.blocks.clear();
            if (!limit.stop_requested()) {
                (void)open_frame(site, scene);
            }
        }
    }
    per_frame_ = per_pixel * plan_of_blocks_.size * plan_of_blocks_.size * plan_of_blocks_.fewest;
    return budget;
}

void FilmProbe::measure(const render::PreparedScene& scene, bool sequences,
                        const CpuBudget& allowed, const std::stop_token& limit) {
    const double begin = process_cpu_seconds();
    const double budget = scout(scene, allowed, limit);
    if (sequences && per_frame_ > 0) {
        const double frames = kSequencePart * budget / per_frame_;
        extend_sequences(scene, static_cast<std::size_t>(std::min(frames, kMostFrames)), limit);
    }
    for (int count = plan_of_blocks_.at_once; count <= plan_of_blocks_.most;
         count += plan_of_blocks_.at_once) {
        for (SiteMeasurement& site : sites_) {
            if (site.frames.empty()) {
                continue;
            }
            if (count <= plan_of_blocks_.fewest ||
                (!is_certain(site) && process_cpu_seconds() - begin < budget)) {
                add_blocks(site, count, limit);
            }
        }
    }
    std::erase_if(sites_, [](const SiteMeasurement& site) {
        return site.frames.empty() || site.frames.front().cost().pixels == 0;
    });
}

render::Film mosaic_of(const std::vector<render::Film>& blocks, std::size_t columns) {
    render::Film film;
    const auto side = static_cast<std::size_t>(blocks.front().width);
    const std::size_t rows = (blocks.size() + columns - 1) / columns;
    film.width = static_cast<int>(columns * side);
    film.height = static_cast<int>(rows * side);
    for (const render::Channel& channel : blocks.front().aovs) {
        film.aovs.push_back({channel.name, {}});
    }
    for (const render::HalfChannel& channel : blocks.front().half_aovs) {
        film.half_aovs.push_back({channel.name, {}});
    }
    for (std::size_t y = 0; y < rows * side; ++y) {
        for (std::size_t x = 0; x < columns * side; ++x) {
            const render::Film& block = blocks[(y / side * columns + x / side) % blocks.size()];
            const std::size_t pixel = y % side * side + x % side;
            const auto rgba = block.rgba.begin() + static_cast<std::ptrdiff_t>(4 * pixel);
            film.rgba.insert(film.rgba.end(), rgba, rgba + 4);
            for (std::size_t c = 0; c < film.aovs.size(); ++c) {
                film.aovs[c].values.push_back(block.aovs[c].values[pixel]);
            }
            for (std::size_t c = 0; c < film.half_aovs.size(); ++c) {
                film.half_aovs[c].bits.push_back(block.half_aovs[c].bits[pixel]);
            }
        }
    }
    return film;
}

}  // namespace carom::pipeline
