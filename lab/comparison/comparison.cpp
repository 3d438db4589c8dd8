#include "lab/comparison/comparison.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/cpu_time.h"
#include "core/error.h"
#include "lab/comparison/named_list.h"
#include "lab/structures/make_structure.h"
#include "lab/structures/structure_meter.h"
#include "lab/triangle/kernel_test.h"
#include "render/frame/frame.h"
#include "render/threads/thread_arena.h"

namespace carom::pipeline {

namespace {

using render::AccelerationKind;
using render::KindCounts;
using render::RayKind;
using render::RenderSettings;
using render::TestCounts;

/// The structures of `text` for which `suits` is true. Of a list all must be.
std::vector<AccelerationKind> suitable_structures(
    const std::string& text, const std::function<bool(AccelerationKind)>& suits,
    const std::string& complaint) {
    std::vector<AccelerationKind> kinds = structures_from_text(text);
    if (text == "all") {
        std::erase_if(kinds, std::not_fn(suits));
    }
    const auto wrong = std::ranges::find_if_not(kinds, suits);
    if (wrong != kinds.end()) {
        throw Error(fmt::format("the structure '{}' {}", name_of(*wrong), complaint));
    }
    return kinds;
}

/// One ray through each pixel, and the rays that follow from it.
RenderSettings one_sample(RenderSettings settings) {
    settings.width = settings.height = 1;
    settings.samples = 1;
    settings.noise = 0;
    settings.distributed.pixel_samples = settings.distributed.blur_samples = 1;
    settings.distributed.lens_samples = 1;
    return settings;
}

/// The same view with a fraction of the pixels.
RenderSettings scaled_down(RenderSettings settings, double fraction) {
    const double scale = std::sqrt(std::min(fraction, 1.0));
    const auto smaller = [&](int size) {
        return std::max(1, static_cast<int>(std::lround(size * scale)));
    };
    settings.width = smaller(settings.width);
    settings.height = smaller(settings.height);
    return settings;
}

/// Measures the cost of one frame with one structure.
class FrameMeter {
  public:
    /// Refers to the scene. `threads`: 0 for one per processor.
    FrameMeter(const LaboratoryScene& scene, int threads) : scene_(scene), arena_(threads) {}

    /// `settings`: those of the scene, or of a part of its picture; `counts`: whether tests are
    /// counted, which takes time. Throws Error, Stopped.
    [[nodiscard]] ComparedStructure measure(RenderSettings settings, AccelerationKind kind,
                                            bool counts, const render::StructureOptions& options,
                                            const WorkContext& context) {
        ComparedStructure result;
        result.name = name_of(kind);
        result.shadow_rays = options.shadow_rays_stop ? ShadowRays::any : ShadowRays::closest;
        result.is_counted = counts;
        arena_.execute([&] {
            if (!structure_ || structure_->kind() != kind) {
                prepared_.reset();
                structure_.emplace(kind);
                prepared_.emplace(scene_.scene, settings, structure_->maker());
            }
            structure_->set(counts, options);
            const double start = process_cpu_seconds();
            (void)render::render_frame(*prepared_, scene_.tracks, scene_.frame, settings, context);
            result.cpu_seconds = process_cpu_seconds() - start - structure_->build_seconds();
        });
        result.build_seconds = structure_->build_seconds();
        result.bytes = structure_->bytes();
        result.tests = structure_->take_counts();
        return result;
    }

  private:
    const LaboratoryScene& scene_;
    render::ThreadArena arena_;
    // Of the last measurement: what frames share is reused for parts of a picture.
    std::optional<render::StructureMeter> structure_;
    std::optional<render::PreparedScene> prepared_;
};

class ComparisonRun {
  public:
    ComparisonRun(const LaboratoryScene& scene, const ComparisonOptions& options,
                  const ComparisonProgress& progress, std::stop_token stop,
                  render::TriangleTestMaker triangle_test = {})
        : scene_(scene),
          options_(options),
          triangle_test_(std::move(triangle_test)),
          progress_(progress),
          stop_(std::move(stop)),
          meter_(scene, options.threads) {
        result_.name = scene.name;
        result_.what = scene.what;
        result_.width = scene.settings.width;
        result_.height = scene.settings.height;
    }

    Comparison run() {
        try {
            count_rays();
            for (const ShadowRays shadow_rays : options_.shadow_rays) {
                for (const AccelerationKind kind : options_.structures) {
                    result_.rows.push_back(row_of(kind, shadow_rays));
                }
            }
            result_.is_whole = true;
        } catch (const Stopped&) {
            // The rows measured before the stop are the result.
        }
        return std::move(result_);
    }

  private:
    // From the first structure that counts in less time than brute force.
    void count_rays() {
        AccelerationKind kind = AccelerationKind::kd_tree;
        for (const AccelerationKind asked : options_.structures) {
            if (!is_linear(asked) && render::can_count(asked)) {
                kind = asked;
                break;
            }
        }
        const ShadowRays shadow_rays = options_.shadow_rays.front();
        counted_[{kind, shadow_rays}] = count(kind, shadow_rays, scene_.settings);
        const TestCounts& counts = counted_[{kind, shadow_rays}];
        for (std::size_t i = 0; i < counts.of.size(); ++i) {
            result_.rays.of[i].rays = counts.of[i].rays;
        }
        const TestCounts one =
            count(AccelerationKind::brute_force, ShadowRays::closest, one_sample(scene_.settings));
        result_.shapes = one[RayKind::primary].objects / one[RayKind::primary].rays;
    }

    ComparedStructure row_of(AccelerationKind kind, ShadowRays shadow_rays) {
        const double all_tests =
            static_cast<double>(result_.rays.total().rays) * static_cast<double>(result_.shapes);
        const bool is_computed = is_linear(kind) && all_tests > options_.most_tests;
        ComparedStructure row = is_computed ? computed(kind, shadow_rays, all_tests)
                                            : least_time(kind, shadow_rays, scene_.settings);
        row.is_counted = render::can_count(kind);
        if (row.is_counted && !is_computed) {
            const auto found = counted_.find({kind, shadow_rays});
            row.tests =
                found != counted_.end() ? found->second : count(kind, shadow_rays, scene_.settings);
        }
        return row;
    }

    // Every ray of a kind takes as many tests in the whole picture as in a part of it: those for
    // the nearest hit are as many as the shapes.
    ComparedStructure computed(AccelerationKind kind, ShadowRays shadow_rays, double all_tests) {
        constexpr double kPart = 0.25;  // of the tests that are allowed
        const RenderSettings part =
            scaled_down(scene_.settings, kPart * options_.most_tests / all_tests);
        const TestCounts counts = count(kind, shadow_rays, part);
        ComparedStructure row = least_time(kind, shadow_rays, part);
        for (std::size_t i = 0; i < counts.of.size(); ++i) {
            const KindCounts& some = counts.of[i];
            const std::uint64_t rays = result_.rays.of[i].rays;
            const auto of_all = [&](std::uint64_t tests) {
                const double each =
                    some.rays > 0 ? static_cast<double>(tests) / static_cast<double>(some.rays)
                                  : static_cast<double>(result_.shapes);
                return static_cast<std::uint64_t>(std::llround(static_cast<double>(rays) * each));
            };
            row.tests.of[i] = {rays, of_all(some.objects), of_all(some.boxes), 0};
        }
        const KindCounts total = row.tests.total();
        const KindCounts measured = counts.total();
        row.build_seconds = 0;
        row.cpu_seconds *= static_cast<double>(total.objects + total.boxes) /
                           static_cast<double>(measured.objects + measured.boxes);
        row.is_computed = true;
        return row;
    }

    TestCounts count(AccelerationKind kind, ShadowRays shadow_rays,
                     const RenderSettings& settings) {
        return measure(kind, shadow_rays, true, settings).tests;
    }

    // The least time of several frames if they are quick, because other load on the machine only
    // slows them down.
    ComparedStructure least_time(AccelerationKind kind, ShadowRays shadow_rays,
                                 const RenderSettings& settings) {
        constexpr int kMostFrames = 5;
        ComparedStructure least = measure(kind, shadow_rays, false, settings);
        double all = least.cpu_seconds;
        for (int i = 1; i < kMostFrames && all < options_.enough_seconds; ++i) {
            done_ -= 1;
            const ComparedStructure again = measure(kind, shadow_rays, false, settings);
            all += again.cpu_seconds;
            least.cpu_seconds = std::min(least.cpu_seconds, again.cpu_seconds);
            least.build_seconds = std::min(least.build_seconds, again.build_seconds);
        }
        return least;
    }

    ComparedStructure measure(AccelerationKind kind, ShadowRays shadow_rays, bool counts,
                              const RenderSettings& settings) {
        // Most rows take two frames; counting the rays takes one more.
        const double steps =
            2.0 * static_cast<double>(options_.structures.size() * options_.shadow_rays.size());
        const WorkContext context{[&, kind](double fraction) {
                                      reported_ = std::max(
                                          reported_, std::min(1.0, (done_ + fraction) / steps));
                                      progress_(name_of(kind), reported_);
                                  },
                                  stop_};
        const render::StructureOptions structure{nullptr, shadow_rays == ShadowRays::any,
                                                 options_.sizes, triangle_test_};
        ComparedStructure result = meter_.measure(settings, kind, counts, structure, context);
        done_ += settings.width == 1 ? 0 : 1;
        return result;
    }

    const LaboratoryScene& scene_;
    const ComparisonOptions& options_;
    render::TriangleTestMaker triangle_test_;  // empty: the renderer's
    const ComparisonProgress& progress_;
    std::stop_token stop_;
    FrameMeter meter_;
    Comparison result_;
    std::map<std::pair<AccelerationKind, ShadowRays>, TestCounts> counted_;
    double done_ = 0;      // frames
    double reported_ = 0;  // fraction that was reported
};

}  // namespace

const char* name_of(ShadowRays shadow_rays) {
    return shadow_rays == ShadowRays::any ? "any" : "closest";
}

const ComparedStructure* Comparison::brute_force_row(const ComparedStructure& row) const {
    const auto is_it = [&](const ComparedStructure& other) {
        return other.name == name_of(AccelerationKind::brute_force) &&
               other.shadow_rays == row.shadow_rays;
    };
    const auto found = std::ranges::find_if(rows, is_it);
    return found == rows.end() ? nullptr : &*found;
}

Comparison compare_structures(const LaboratoryScene& scene, const ComparisonOptions& options,
                              const ComparisonProgress& progress, const std::stop_token& stop) {
    if (options.kernels.empty()) {
        return ComparisonRun(scene, options, progress, stop).run();
    }
    Comparison result;
    for (std::size_t i = 0; i < options.kernels.size() && (i == 0 || result.is_whole); ++i) {
        const render::triangle::KernelName kernel = options.kernels[i];
        const auto part_of_all = [&](std::string_view structure, double fraction) {
            progress(structure, (static_cast<double>(i) + fraction) /
                                    static_cast<double>(options.kernels.size()));
        };
        Comparison part = ComparisonRun(scene, options, part_of_all, stop,
                                        render::triangle::triangle_test(kernel))
                              .run();
        for (ComparedStructure& row : part.rows) {
            row.name += ", " + std::string(name(kernel));
        }
        part.rows.insert(part.rows.begin(), result.rows.begin(), result.rows.end());
        result = std::move(part);
    }
    return result;
}

bool is_linear(AccelerationKind kind) {
    return kind == AccelerationKind::brute_force || kind == AccelerationKind::single_boxes;
}

std::vector<AccelerationKind> structures_from_text(const std::string& text) {
    std::vector<AccelerationKind> all;
    std::ranges::transform(render::kAccelerationNames, std::back_inserter(all),
                           &render::AccelerationName::kind);
    if (text.empty()) {
        throw Error("no structure is given; use one of " + render::structure_names() + ", or all");
    }
    if (text == "all") {
        // Brute force comes first, because the others are compared with it.
        std::rotate(all.begin(), std::ranges::find(all, AccelerationKind::brute_force), all.end());
        return all;
    }
    return named_in<AccelerationKind>(text, "structure", all, render::name_of);
}

std::vector<AccelerationKind> structures_with_kernels(const std::string& text) {
    return suitable_structures(text, render::has_triangle_tests, "has its own triangle test");
}

std::vector<AccelerationKind> structures_with_size(const std::string& text,
                                                   render::VariedSize size) {
    return suitable_structures(
        text, [&](AccelerationKind kind) { return render::depends_on(kind, size); },
        fmt::format("does not depend on the {}", facts(size).words));
}

}  // namespace carom::pipeline
