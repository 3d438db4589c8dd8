#include "lab/comparison/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "lab/comparison/growth_rays.h"
#include "lab/comparison/structure_timing.h"
#include "render/acceleration/flush_denormals.h"

namespace carom::pipeline {

namespace {

using render::AccelerationKind;
using render::FrameScene;
using render::Ray;

constexpr std::size_t kRays = 20'000;

/// A ray with the time in its own part of the shutter.
struct TimedRay {
    std::size_t part;
    Ray ray;
};

std::vector<TimedRay> by_part(const RaysByKind& rays, int intervals) {
    std::vector<TimedRay> result;
    for (const std::vector<Ray>& of_kind : rays) {
        for (const Ray& ray : of_kind) {
            const float time = ray.time * static_cast<float>(intervals);
            const float part = std::min(std::floor(time), static_cast<float>(intervals - 1));
            result.push_back({static_cast<std::size_t>(part), ray});
            result.back().ray.time = std::min(time - part, 1.f);
        }
    }
    return result;
}

/// A structure for each part of the shutter.
class Parts {
  public:
    Parts(MeasuredScene& scene, double shutter, int intervals) {
        for (int i = 0; i < intervals; ++i) {
            const double open = shutter * i / intervals;
            const double close = shutter * (i + 1) / intervals;
            parts_.push_back(std::unique_ptr<FrameScene>(new FrameScene(scene.frame(open, close))));
            build_seconds_ += scene.structure().build_seconds();
            bytes_ += scene.structure().bytes();
        }
    }
    /// The number of rays that hit something.
    [[nodiscard]] std::size_t trace(const std::vector<TimedRay>& rays) const {
        std::size_t count = 0;
        for (const TimedRay& timed : rays) {
            count += hits(parts_[timed.part]->structure(), timed.ray) ? 1 : 0;
        }
        return count;
    }
    /// Sums over all parts.
    [[nodiscard]] double build_seconds() const { return build_seconds_; }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    std::vector<std::unique_ptr<FrameScene>> parts_;
    double build_seconds_ = 0;
    std::size_t bytes_ = 0;
};

/// The least of several times: building is quick and sensitive to other load on the machine.
double least_build_seconds(MeasuredScene& scene, double shutter, int intervals, double enough) {
    constexpr int kMost = 8;
    double least = std::numeric_limits<double>::infinity();
    double all = 0;
    for (int i = 0; i < kMost && (i < 2 || all < enough); ++i) {
        const double seconds = Parts(scene, shutter, intervals).build_seconds();
        least = std::min(least, seconds);
        all += seconds;
    }
    return least;
}

class MotionRun {
  public:
    MotionRun(const MotionOptions& options, const ComparisonProgress& progress,
              const std::stop_token& stop)
        : options_(options),
          progress_(progress),
          stop_(stop),
          scene_(restless_balls(options.balls)) {
        motion_.balls = options.balls;
        motion_.shutters = options.shutters;
        std::ranges::sort(motion_.shutters);
    }

    Motion run() {
        try {
            for (const double shutter : motion_.shutters) {
                measure_shutter(shutter);
            }
            motion_.is_whole = true;
        } catch (const Stopped&) {
            // The points measured before the stop are the result.
        }
        return std::move(motion_);
    }

  private:
    void measure_shutter(double shutter) {
        const MeasuredScene measured(scene_, AccelerationKind::bvh);
        const FrameScene frame = measured.frame(0, shutter);
        const RaysByKind rays = growth_rays(frame.structure(), kRays);
        MeasuredScene linear(scene_, AccelerationKind::brute_force);
        linear.structure().set(true);
        const FrameScene brute_force = linear.frame(0, shutter);
        static_cast<void>(hits(brute_force.structure(), rays[0].front()));
        const std::size_t shapes = linear.structure().take_counts().total().objects;
        for (const AccelerationKind kind : options_.structures) {
            for (const int intervals : options_.intervals) {
                if (shutter == 0 && intervals > 1) {
                    continue;
                }
                check_stop(stop_);
                progress_(name_of(kind), fraction_done());
                MotionPoint point = point_of(kind, intervals, shutter, rays, shapes);
                motion_.points.push_back(std::move(point));
            }
        }
    }

    [[nodiscard]] MotionPoint point_of(AccelerationKind kind, int intervals, double shutter,
                                       const RaysByKind& rays, std::size_t shapes) const {
        const render::FlushDenormals flush;
        MotionPoint point;
        point.name = name_of(kind);
        point.intervals = intervals;
        point.shutter = shutter;
        point.shapes = shapes;
        const double tests = 3.0 * static_cast<double>(kRays) * static_cast<double>(shapes);
        const auto every = static_cast<std::size_t>(
            std::ceil(is_linear(kind) ? std::max(1.0, 20 * tests / options_.most_tests) : 1.0));
        const std::vector<TimedRay> timed = by_part(thinned(rays, every), intervals);
        const auto count = static_cast<double>(timed.size());
        MeasuredScene measured(scene_, kind);
        {
            const Parts parts(measured, shutter, intervals);
            point.bytes = parts.bytes();
            std::size_t found = 0;
            point.seconds_per_ray =
                least_seconds([&] { found = parts.trace(timed); }, options_.enough_seconds, stop_) /
                count;
            point.hits = static_cast<double>(found) / count;
        }
        point.build_seconds =
            least_build_seconds(measured, shutter, intervals, options_.enough_seconds);
        point.is_counted = render::can_count(kind);
        if (point.is_counted) {
            measured.structure().set(true);
            const Parts counting(measured, shutter, intervals);
            static_cast<void>(counting.trace(timed));
            point.tests = measured.structure().take_counts();
        }
        return point;
    }

    [[nodiscard]] double fraction_done() const {
        const auto all = static_cast<double>(motion_.shutters.size() * options_.structures.size() *
                                             options_.intervals.size());
        return std::min(1.0, static_cast<double>(motion_.points.size()) / all);
    }

    const MotionOptions& options_;
    const ComparisonProgress& progress_;
    const std::stop_token& stop_;
    LaboratoryScene scene_;
    Motion motion_;
};

}  // namespace

std::string MotionPoint::full_name() const {
    return intervals == 1 ? name : name + ", " + std::to_string(intervals) + " intervals";
}

const MotionPoint* Motion::point(const std::string& full_name, double shutter) const {
    const auto found = std::ranges::find_if(points, [&](const MotionPoint& point) {
        return point.shutter == shutter && point.full_name() == full_name;
    });
    return found == points.end() ? nullptr : &*found;
}

double Motion::break_even(const MotionPoint& divided) const {
    const MotionPoint* whole = point(divided.name, divided.shutter);
    const double never = std::numeric_limits<double>::infinity();
    if (whole == nullptr || whole == &divided) {
        return never;
    }
    const double saved = whole->seconds_per_ray - divided.seconds_per_ray;
    return saved > 0 ? std::max(0.0, (divided.build_seconds - whole->build_seconds) / saved)
                     : never;
}

Motion measure_motion(const MotionOptions& options, const ComparisonProgress& progress,
                      const std::stop_token& stop) {
    return MotionRun(options, progress, stop).run();
}

}  // namespace carom::pipeline
