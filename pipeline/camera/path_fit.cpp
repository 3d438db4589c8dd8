#include "pipeline/camera/path_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/error.h"
#include "pipeline/camera/bezier.h"
#include "pipeline/camera/camera_path.h"
#include "pipeline/camera/steady_up.h"

namespace carom::pipeline {
namespace {

constexpr int kSamples = 400;
constexpr std::array kDegrees{1, 2, 3, 4, 6, 8, 11, 15, 20, 25, kHighestFitDegree};

struct Sample {
    Progress fraction;
    Vec3 position;
};

// The samples are denser towards the ends, like Chebyshev nodes, so that the fitted polynomial does
// not oscillate.
std::vector<Sample> sample_path(const sim::Track& track, double from, double to) {
    std::vector<Sample> samples;
    samples.reserve(kSamples);
    for (int i = 0; i < kSamples; ++i) {
        const double angle = std::numbers::pi * i / (kSamples - 1);
        const Progress fraction{(1 - cosine(angle)) / 2, (1 + cosine(angle)) / 2};
        samples.push_back({fraction, track.sample(from + (to - from) * fraction.done).position});
    }
    return samples;
}

// The points at which the error is measured. They include instants between the fitted ones and
// every key of the track, where the path may have a corner.
std::vector<Sample> check_samples(const sim::Track& track, double from, double to) {
    std::vector<double> fractions;
    for (int i = 0; i <= 2 * kSamples; ++i) {
        fractions.push_back(double(i) / (2 * kSamples));
    }
    for (const sim::PathSegment& segment : track.segments(from, to)) {
        fractions.push_back((segment.start - from) / (to - from));
    }
    std::vector<Sample> samples;
    samples.reserve(fractions.size());
    for (const double fraction : fractions) {
        samples.push_back(
            {{fraction, 1 - fraction}, track.sample(from + (to - from) * fraction).position});
    }
    return samples;
}

// The Bernstein polynomials of one degree at one parameter, by their recursion. It sums products of
// non-negative numbers, so it is numerically stable at any degree.
std::vector<double> bernstein(int degree, Progress fraction) {
    std::vector<double> values(static_cast<std::size_t>(degree) + 1, 0);
    values[0] = 1;
    for (int d = 1; d <= degree; ++d) {
        for (int i = d; i > 0; --i) {
            values[i] = values[i] * fraction.left + values[i - 1] * fraction.done;
        }
        values[0] *= fraction.left;
    }
    return values;
}

// A matrix by columns, and the right-hand side.
struct Equations {
    std::vector<std::vector<double>> columns;
    std::vector<Vec3> right;
};

// Linear least squares by Householder reflections (Golub and Van Loan, "Matrix Computations", 4th
// ed. 2013, section 5.3). Bernstein polynomials of high degree are nearly dependent, and the normal
// equations would square the condition number.
std::vector<Vec3> solve_least_squares(Equations equations) {
    auto& columns = equations.columns;
    auto& right = equations.right;
    const std::size_t rows = right.size();
    std::vector<double> diagonal(columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k) {
        std::vector<double>& mirror = columns[k];  // becomes the reflection's normal from row k on
        double length = 0;
        for (std::size_t i = k; i < rows; ++i) {
            length += mirror[i] * mirror[i];
        }
        length = std::sqrt(length);
        diagonal[k] = mirror[k] > 0 ? -length : length;
        mirror[k] -= diagonal[k];
        double square = 0;
        for (std::size_t i = k; i < rows; ++i) {
            square += mirror[i] * mirror[i];
        }
        for (std::size_t j = k + 1; j < columns.size(); ++j) {
            double dot = 0;
            for (std::size_t i = k; i < rows; ++i) {
                dot += mirror[i] * columns[j][i];
            }
            for (std::size_t i = k; i < rows; ++i) {
                columns[j][i] -= 2 * dot / square * mirror[i];
            }
        }
        Vec3 dot(0, 0, 0);
        for (std::size_t i = k; i < rows; ++i) {
            dot += right[i] * mirror[i];
        }
        for (std::size_t i = k; i < rows; ++i) {
            right[i] -= dot * (2 / square * mirror[i]);
        }
    }
    std::vector<Vec3> solution(columns.size());
    for (std::size_t k = columns.size(); k-- > 0;) {
        Vec3 rest = right[k];
        for (std::size_t j = k + 1; j < columns.size(); ++j) {
            rest -= solution[j] * columns[j][k];
        }
        solution[k] = rest / diagonal[k];
    }
    return solution;
}

PathFit fit_degree(const std::vector<Sample>& samples, const std::vector<Sample>& checks,
                   int degree) {
    const Vec3 first = samples.front().position;
    const Vec3 last = samples.back().position;
    Equations equations;
    equations.columns.assign(static_cast<std::size_t>(degree) - 1,
                             std::vector<double>(samples.size()));
    for (std::size_t row = 0; row < samples.size(); ++row) {
        const std::vector<double> values = bernstein(degree, samples[row].fraction);
        for (std::size_t i = 0; i < equations.columns.size(); ++i) {
            equations.columns[i][row] = values[i + 1];
        }
        equations.right.push_back(samples[row].position - first * values.front() -
                                  last * values.back());
    }
    PathFit fit;
    fit.points = solve_least_squares(std::move(equations));
    fit.points.insert(fit.points.begin(), first);
    fit.points.push_back(last);
    const BezierCurve curve(fit.points);
    for (const Sample& sample : checks) {
        fit.error =
            std::max(fit.error, (curve.position(sample.fraction) - sample.position).length());
    }
    return fit;
}

void replace_along(CameraPath& path, const CameraRig& rig, const sim::Timeline& timeline,
                   bool is_target, std::vector<FittedPath>* list) {
    const auto* along = std::get_if<AlongPath>(&path);
    if (along == nullptr) {
        return;
    }
    PathFit fit;
    BezierPath bezier;
    try {
        bezier = fit_bezier_path(*along, timeline, &fit);
    } catch (const Error& error) {
        throw Error("camera '" + rig.name + "': " + error.what());
    }
    if (list != nullptr) {
        list->push_back({rig.name, along->object, is_target,
                         static_cast<int>(fit.points.size()) - 1, fit.error});
    }
    path = std::move(bezier);
}

}  // namespace

PathFit fit_path(const sim::Track& track, double from, double to) {
    if (from == to) {
        return {{track.sample(from).position}, 0};
    }
    const std::vector<Sample> samples = sample_path(track, std::min(from, to), std::max(from, to));
    const std::vector<Sample> checks = check_samples(track, std::min(from, to), std::max(from, to));
    PathFit best;
    for (const int degree : kDegrees) {
        PathFit fit = fit_degree(samples, checks, degree);
        if (best.points.empty() || fit.error < best.error) {
            best = std::move(fit);
        }
        if (best.error <= kFitError) {
            break;
        }
    }
    if (to < from) {
        std::reverse(best.points.begin(), best.points.end());
    }
    return best;
}

BezierPath fit_bezier_path(const AlongPath& path, const sim::Timeline& timeline, PathFit* fit) {
    PathFit result = fit_path(find_track(timeline, path.object), path.from, path.to);
    BezierPath bezier;
    bezier.even_pace = path.even_pace;
    bezier.easing = path.easing;
    for (const Vec3& point : result.points) {
        bezier.points.push_back({point + path.offset, "", 0});
    }
    if (fit != nullptr) {
        *fit = std::move(result);
    }
    return bezier;
}

std::vector<CameraRig> with_fitted_paths(std::span<const CameraRig> rigs,
                                         const sim::Timeline& timeline,
                                         std::vector<FittedPath>* fitted) {
    std::vector<CameraRig> result(rigs.begin(), rigs.end());
    for (CameraRig& rig : result) {
        replace_along(rig.position, rig, timeline, false, fitted);
        replace_along(rig.target, rig, timeline, true, fitted);
    }
    keep_up(result, timeline);
    return result;
}

}  // namespace carom::pipeline
