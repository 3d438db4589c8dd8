#include "render/frame/frame_session.h"

#include <algorithm>
#include <limits>

#include "core/cpu_time.h"
#include "core/error.h"
#include "render/acceleration/flush_denormals.h"
#include "render/frame/check_settings.h"
#include "render/frame/denoiser_rows.h"
#include "render/frame/large_picture.h"
#include "render/frame/prepared_scene.h"
#include "render/frame/tile_loop.h"
#include "render/threads/thread_arena.h"

namespace carom::render {
namespace {

const PreparedScene::Data& checked(const PreparedScene& scene, const FrameInput& frame,
                                   const RenderSettings& settings) {
    check(settings, frame, scene.data().branches);
    return scene.data();
}

const CutOuts* cut_outs_of(const PreparedScene& scene) {
    const auto& cut_outs = scene.data().cut_outs;
    return cut_outs ? &*cut_outs : nullptr;
}

const StaticGeometry* near_of(const PreparedScene& scene) {
    const auto& near = scene.data().near;
    return near ? &*near : nullptr;
}

}  // namespace

FrameSession::FrameSession(const PreparedScene& scene, std::span<const sim::Track> tracks,
                           const FrameInput& frame, const RenderSettings& settings,
                           const SumsKind& kind, FrameSums::Data& sums)
    : prepared_(scene),
      settings_(settings),
      frame_(frame),
      kind_(kind),
      sums_(sums),
      frame_scene_(checked(scene, frame, settings).geometry, tracks, frame.scene_open,
                   frame.scene_close, cut_outs_of(scene), near_of(scene)),
      lights_(scene.data().lights.in_frame(frame_scene_.motions())),
      transport_{frame_scene_, scene.data().materials, lights_, scene.data().object_count,
                 scene.data().far.get()},
      tiles_(settings, frame, transport_),
      is_planned_(!tiles_.is_adaptive()) {
    const auto count = static_cast<std::size_t>(tiles_.tile_count());
    if (sums_.pixels == 0) {
        sums_.pixels = pixel_count();
        sums_.tiles.resize(count);
        sums_.seconds.resize(count);
    }
    const auto is_other = [&](const TileSums& tile) {
        const auto index = static_cast<int>(&tile - sums_.tiles.data());
        return !tile.empty() && (tile.size() != tiles_.area(index).pixels() || tile.kind() != kind);
    };
    if (sums_.pixels != pixel_count() || sums_.tiles.size() != count ||
        std::ranges::any_of(sums_.tiles, is_other)) {
        throw Error("the sums are those of another frame");
    }
    part_.width = settings.width;
    part_.height = settings.height;
    part_.pixel = [](int x, int y) { return std::pair(x, y); };
    for (int tile = 0; tile < tiles_.tile_count(); ++tile) {
        part_.tiles.push_back(tile);
    }
}

void FrameSession::restrict_to(FramePart part) {
    part_ = std::move(part);
    is_whole_ = false;
    is_planned_ = !tiles_.is_adaptive();
    sums_.has_plan = false;  // not of all tiles
}

TileSums& FrameSession::sums_of(int tile) {
    TileSums& sums = sums_.tiles[static_cast<std::size_t>(tile)];
    if (sums.empty()) {
        sums = TileSums(tiles_.area(tile).pixels(), kind_);
    }
    return sums;
}

template <class Visit>
void FrameSession::for_each_pixel(const Visit& visit) const {
    for (int y = 0; y < part_.height; ++y) {
        for (int x = 0; x < part_.width; ++x) {
            const auto at = part_.pixel(x, y);
            const int tile = tiles_.tile_of(at.first, at.second);
            visit(x, y, tile, tiles_.area(tile).pixel(at.first, at.second));
        }
    }
}

int FrameSession::most_of_round() const {
    int most = 0;
    for (const int tile : part_.tiles) {
        const std::vector<int>& planned = sums_.tiles[static_cast<std::size_t>(tile)].planned;
        if (!sums_.has_plan || planned.empty()) {
            return tiles_.samples();
        }
        most = std::max(most, *std::ranges::max_element(planned));
    }
    return most;
}

/// Of what the plan still asks for.
SessionRound FrameSession::further_round() const {
    SessionRound round;
    for (int tile = 0; tile < tiles_.tile_count() && is_whole_; ++tile) {
        const TileSums& sums = sums_.tiles[static_cast<std::size_t>(tile)];
        double samples = 0;
        for (std::size_t pixel = 0; pixel < sums.size(); ++pixel) {
            samples += sums.planned[pixel] - sums.samples(pixel);
        }
        round.lacking.push_back(samples / static_cast<double>(sums.size()) / settings_.samples);
    }
    round.expected = expected_.empty() ? round.lacking : expected_;
    return round;
}

void FrameSession::refine(int up_to, const WorkContext& context, SessionObserver& observer) {
    for (;;) {
        SessionRound round = sums_.has_plan ? further_round() : SessionRound{.is_first = true};
        const int most = most_of_round();
        round.is_last = is_planned_ || up_to < most;
        take(up_to, round, context, observer);
        samples_ = std::max(samples_, std::min(up_to, most));
        if (round.is_last) {
            return;
        }
        plan_next_round(context, observer);
        if (is_planned_) {
            return;
        }
    }
}

void FrameSession::take(int up_to, const SessionRound& round, const WorkContext& context,
                        SessionObserver& observer) {
    observer.begin(round);
    const SampleLimit limit{round.is_first ? std::min(up_to, tiles_.samples()) : up_to,
                            !round.is_first};
    const auto tile_at = [&](int n) {
        return part_.tiles[static_cast<std::size_t>(round.is_first ? observer.nth_tile(n) : n)];
    };
    for_all_tiles(
        static_cast<int>(part_.tiles.size()), context, sums_.statistics,
        [&](int n) {
            const int tile = tile_at(n);
            const double begin = thread_cpu_seconds();
            const RenderStatistics count =
                tiles_.add_samples(tile, sums_of(tile), limit, context.stop);
            const double seconds = thread_cpu_seconds() - begin;
            if (round.is_first) {
                sums_.seconds[static_cast<std::size_t>(tile)] += static_cast<float>(seconds);
            }
            observer.sampled(tile, count, seconds);
            return count;
        },
        [&](int n) { observer.finished(round, tile_at(n)); });
}

void FrameSession::trace_features(const WorkContext& context, SessionObserver& observer) {
    RenderStatistics none;
    for_all_tiles(
        static_cast<int>(part_.tiles.size()), {{}, context.stop}, none,
        [&](int n) {
            const int tile = part_.tiles[static_cast<std::size_t>(n)];
            TileSums& sums = sums_of(tile);
            if (sums.traced.empty()) {
                const double begin = thread_cpu_seconds();
                sums.traced = tiles_.trace_features(tile, sums);
                observer.traced(tile, thread_cpu_seconds() - begin);
            }
            return RenderStatistics{};
        },
        [](int) {});
}

/// Once all pixels have the samples of the current round.
void FrameSession::plan_next_round(const WorkContext& context, SessionObserver& observer) {
    if (settings_.for_denoiser) {
        trace_features(context, observer);
    }
    give_back_memory_of(pixel_count());  // of the tiles' samples, before the denoiser needs some
    const double begin = process_cpu_seconds();
    const MeasuredError error = measured_error(context);
    std::vector<int> plan;
    plan.reserve(static_cast<std::size_t>(part_.width) * static_cast<std::size_t>(part_.height));
    for_each_pixel([&](int, int, int tile, std::size_t pixel) {
        plan.push_back(sums_of(tile).samples(pixel));
    });
    SampleRound round = next_round(plan, error, settings_);
    is_planned_ = !round.is_needed;
    sums_.has_plan = true;
    expected_.assign(is_whole_ ? static_cast<std::size_t>(tiles_.tile_count()) : 0, 0);
    auto planned = round.plan.begin();
    auto expected = round.expected.begin();
    for (const int tile : part_.tiles) {
        sums_of(tile).planned.assign(sums_of(tile).size(), 0);
    }
    for_each_pixel([&](int, int, int tile, std::size_t pixel) {
        TileSums& sums = sums_of(tile);
        // A pixel at the frame's edge may be seen several times.
        sums.planned[pixel] = sums.planned[pixel] == 0 ? *planned : sums.planned[pixel];
        ++planned;
        if (is_whole_) {
            expected_[static_cast<std::size_t>(tile)] +=
                static_cast<double>(*expected - sums.samples(pixel)) /
                static_cast<double>(sums.size()) / settings_.samples;
        }
        ++expected;
    });
    observer.planned(process_cpu_seconds() - begin);
}

double FrameSession::mean_samples() const {
    double samples = 0;
    for (const TileSums& sums : sums_.tiles) {
        for (std::size_t pixel = 0; pixel < sums.size(); ++pixel) {
            samples += sums.samples(pixel);
        }
    }
    return samples / static_cast<double>(pixel_count());
}

/// The images of lights in balls are traced for it; these rays are not counted.
MeasuredError FrameSession::measured_error(const WorkContext& context) const {
    std::vector<SplatPicture> pictures;
    if (is_whole_) {
        pictures = trace_reflections(mean_samples(), false, context).pictures;
    }
    if (settings_.for_denoiser) {
        return render::measured_error(error_after_denoising(
            DenoiserRows(part_, tiles_, sums_.tiles, pictures), {{}, context.stop}));
    }
    std::vector<V3f> means;
    std::vector<V3f> differences;
    for_each_pixel([&](int x, int y, int tile, std::size_t pixel) {
        V3f half[2];
        for (int h = 0; h < 2; ++h) {
            half[h] = sums_.tiles[static_cast<std::size_t>(tile)].mean_of_half(pixel, h);
            if (is_whole_) {
                half[h] += pictures[static_cast<std::size_t>(h)].at(x, y);
            }
        }
        means.push_back(0.5F * (half[0] + half[1]));
        differences.push_back(0.5F * (half[0] - half[1]));
    });
    return error_of_halves(means, differences, part_.width, part_.height);
}

FramePlanes FrameSession::make_planes(const std::vector<std::string>& aovs,
                                      bool for_denoiser) const {
    Film film;
    film.width = settings_.width;
    film.height = settings_.height;
    film.rgba.reserve(4 * pixel_count());
    RenderSettings settings = settings_;
    settings.aovs = aovs;
    return {std::move(film), AovPlanes(settings, frame_, frame_scene_, prepared_.data().names),
            for_denoiser ? DenoiserPlanes(settings_.width, settings_.height) : DenoiserPlanes()};
}

void FrameSession::write(int tile, FramePlanes& planes) const {
    const TileSums& sums = sums_.tiles[static_cast<std::size_t>(tile)];
    if (!sums.empty()) {
        tiles_.write(tile, sums, planes.film);
        tiles_.write(tile, sums, planes.aovs);
        tiles_.write(tile, sums, planes.denoiser);
    }
}

void FrameSession::write_all(FramePlanes& planes, const std::stop_token& stop,
                             const std::function<void(int tile)>& written) const {
    RenderStatistics none;
    const int across = tiles_.tile_of(settings_.width - 1, 0) + 1;
    for (int first = 0; first < tiles_.tile_count(); first += across) {
        const TileArea area = tiles_.area(first);
        planes.make_room(static_cast<std::size_t>(area.top + area.height) *
                         static_cast<std::size_t>(settings_.width));
        for_all_tiles(
            across, {{}, stop}, none,
            [&](int n) {
                write(first + n, planes);
                return RenderStatistics{};
            },
            [](int) {});
        for (int tile = first; tile < first + across && written; ++tile) {
            written(tile);
        }
    }
}

Film FrameSession::film_of(FramePlanes planes, const Reflections& reflections) const {
    Film film = std::move(planes.film);
    const std::vector<SplatPicture>& pictures = reflections.pictures;
    const float weight = 1.0F / static_cast<float>(pictures.size());
    for (const SplatPicture& picture : pictures) {
        for (int y = 0; y < film.height; ++y) {
            float* rgba =
                &film.rgba[4 * static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width)];
            for (int x = 0; x < film.width; ++x, rgba += 4) {
                const V3f light = picture.at(x, y);
                for (int c = 0; c < 3; ++c) {
                    rgba[c] += weight * light[c];
                }
            }
        }
    }
    if (!planes.denoiser.empty()) {
        planes.denoiser.add_to_colours(pictures[0], pictures[1]);
    }
    planes.aovs.finish_variance(reflections.moments.variance());
    film.statistics += reflections.statistics;
    film.aovs = planes.aovs.take();
    film.notes = planes.aovs.take_notes();
    film.half_aovs = planes.denoiser.take();
    return film;
}

Reflections FrameSession::trace_reflections(bool with_variance, const WorkContext& context) const {
    const double samples =
        static_cast<double>(sums_.statistics.camera_rays) / static_cast<double>(pixel_count());
    return trace_reflections(samples, with_variance, context);
}

Reflections FrameSession::trace_reflections(double samples, bool with_variance,
                                            const WorkContext& context) const {
    const bool has_two = has_halves(settings_);
    Reflections all;
    all.moments = with_variance ? SplatMoments(pixel_count()) : SplatMoments();
    for (int index = 0; index < (has_two ? 2 : 1); ++index) {
        const Half half{has_two ? samples / 2 : samples, index, has_two ? 0.5F : 1.0F};
        all.pictures.emplace_back(settings_.width, settings_.height);
        for (const std::vector<Splat>& image : trace_half(half, all.statistics, context)) {
            tiles_.add(image, all.pictures.back());
            if (with_variance) {
                tiles_.add(image, half.weight, all.moments);
            }
        }
    }
    return all;
}

std::vector<std::vector<Splat>> FrameSession::trace_half(const Half& half,
                                                         RenderStatistics& statistics,
                                                         const WorkContext& context) const {
    const std::size_t number = tiles_.reflection_count();
    std::vector<std::vector<Splat>> images(number);
    std::vector<RenderStatistics> counts(number);
    parallel_for(number, [&](std::size_t i) {
        if (!context.stop.stop_requested()) {
            const FlushDenormals flush;
            images[i] = tiles_.reflection(i, half.samples, half.index, counts[i]);
        }
    });
    if (context.stop.stop_requested()) {
        throw Stopped();
    }
    for (const RenderStatistics& count : counts) {
        statistics += count;
    }
    return images;
}

}  // namespace carom::render
