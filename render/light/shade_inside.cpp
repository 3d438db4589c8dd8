#include "render/light/shade_inside.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/colour.h"

namespace carom::render {

namespace {

constexpr std::size_t kRings = 56;  // a multiple of the intervals between nodes
constexpr double kPi = std::numbers::pi;

struct CrossSection {
    double height = 0;  // m, from the opening
    double radius = 0;  // m
};

/// The area of a disk times the fraction of its diffuse light that falls onto a coaxial one, m^2.
double exchange(const CrossSection& a, const CrossSection& b) {
    const double distance = b.height - a.height;
    const double sum = a.radius * a.radius + b.radius * b.radius + distance * distance;
    const double product = 2 * a.radius * b.radius;
    return 0.5 * kPi * (sum - std::sqrt(std::max(0.0, sum * sum - product * product)));
}

/// The wall in rings, the ceiling around the disk, and how much light they send each other.
class Inside {
  public:
    explicit Inside(const ShadeLight& light)
        : disk_{light.depth, light.disk_radius}, shape_(light.shape) {
        for (std::size_t i = 0; i <= kRings; ++i) {
            const double height = light.depth * static_cast<double>(i) / kRings;
            sections_[i] = {height, shape_.radius_at(height)};
        }
        sections_[kRings].radius = std::max(sections_[kRings].radius, disk_.radius);
    }

    [[nodiscard]] const CrossSection& ceiling() const { return sections_[kRings]; }
    [[nodiscard]] const CrossSection& opening() const { return sections_[0]; }
    [[nodiscard]] const CrossSection& disk() const { return disk_; }

    [[nodiscard]] double area(std::size_t ring) const {
        const CrossSection& a = sections_[ring];
        const CrossSection& b = sections_[ring + 1];
        const Vec2 side(b.radius - a.radius, b.height - a.height);
        return kPi * (a.radius + b.radius) * side.length();
    }
    [[nodiscard]] double area_around_disk() const {
        return kPi * (ceiling().radius * ceiling().radius - disk_.radius * disk_.radius);
    }
    /// Between a ring and a disk above or below it: what passes the edge of the ring that is nearer
    /// to the disk and not the other.
    [[nodiscard]] double with_disk(std::size_t ring, const CrossSection& other) const {
        const double lower = exchange(sections_[ring], other);
        const double upper = exchange(sections_[ring + 1], other);
        return std::abs(upper - lower);
    }
    [[nodiscard]] double with_ceiling(std::size_t ring) const {
        return with_disk(ring, ceiling()) - with_disk(ring, disk_);
    }
    [[nodiscard]] double between(std::size_t a, std::size_t b) const {
        if (a == b) {
            // What leaves neither through its lower nor its upper edge.
            const double across = exchange(sections_[a], sections_[a + 1]);
            const auto disk_area = [](const CrossSection& s) { return kPi * s.radius * s.radius; };
            return area(a) - (disk_area(sections_[a]) - across) -
                   (disk_area(sections_[a + 1]) - across);
        }
        const std::size_t low = std::min(a, b);
        const std::size_t high = std::max(a, b);
        return with_disk(low, sections_[high]) - with_disk(low, sections_[high + 1]);
    }

  private:
    CrossSection disk_;
    ShadeShape shape_;
    std::array<CrossSection, kRings + 1> sections_;
};

/// Radiances over that of the disk, for one colour.
struct Radiances {
    std::array<double, kRings> wall{};
    double ceiling = 0;
};

Radiances solve(const Inside& inside, double albedo) {
    std::array<std::array<double, kRings>, kRings> between{};
    std::array<double, kRings> from_disk{}, with_ceiling{};
    for (std::size_t i = 0; i < kRings; ++i) {
        from_disk[i] = inside.with_disk(i, inside.disk());
        with_ceiling[i] = inside.with_ceiling(i);
        for (std::size_t j = 0; j < kRings; ++j) {
            between[i][j] = inside.between(i, j);
        }
    }
    Radiances result;
    const double around = inside.area_around_disk();
    constexpr double kSettled = 1e-12;
    for (double change = 1; change > kSettled;) {
        change = 0;
        const auto set = [&](double& radiance, double value) {
            change = std::max(change, std::abs(value - radiance));
            radiance = value;
        };
        double onto_ceiling = 0;
        for (std::size_t i = 0; i < kRings; ++i) {
            double sum = from_disk[i] + with_ceiling[i] * result.ceiling;
            for (std::size_t j = 0; j < kRings; ++j) {
                sum += between[i][j] * result.wall[j];
            }
            set(result.wall[i], albedo * sum / inside.area(i));
            onto_ceiling += with_ceiling[i] * result.wall[i];
        }
        set(result.ceiling, around > 0 ? albedo * onto_ceiling / around : 0);
    }
    return result;
}

/// The fraction of the disk's radiance that a matt disk in the opening has with the same power.
double out_of(const Inside& inside, const Radiances& radiances) {
    const CrossSection& opening = inside.opening();
    const double of_disk = exchange(inside.disk(), opening);
    double sum = of_disk + (exchange(inside.ceiling(), opening) - of_disk) * radiances.ceiling;
    for (std::size_t i = 0; i < kRings; ++i) {
        sum += inside.with_disk(i, opening) * radiances.wall[i];
    }
    return sum / (kPi * opening.radius * opening.radius);
}

/// At a node between rings: the mean of its neighbours, at the ends what they lead to.
double at_node(const std::array<double, kRings>& wall, int node) {
    constexpr std::size_t kPerNode = kRings / (ShadeConstants::kNodes - 1);
    const std::size_t edge = static_cast<std::size_t>(node) * kPerNode;
    if (edge == 0) {
        return std::max(0.0, 1.5 * wall[0] - 0.5 * wall[1]);
    }
    if (edge == kRings) {
        return std::max(0.0, 1.5 * wall[kRings - 1] - 0.5 * wall[kRings - 2]);
    }
    return 0.5 * (wall[edge - 1] + wall[edge]);
}

/// The share of the light by which the disk is brighter than the mean of all else that is seen:
/// directions have the density of their radiance then, if all else has its mean.
float chance_of_disk(const Inside& inside, double of_disk, double mean) {
    const double opening = kPi * inside.opening().radius * inside.opening().radius;
    const double sees_disk = exchange(inside.disk(), inside.opening()) / opening;
    const double rest = std::max(0.0, mean - of_disk * sees_disk) / std::max(1e-9, 1 - sees_disk);
    constexpr double kLargest = 0.9;
    const double excess = std::max(0.0, of_disk - rest) * sees_disk;
    return static_cast<float>(mean > 0 ? std::min(kLargest, excess / mean) : 0);
}

}  // namespace

ShadeInside shade_inside(const ShadeLight& light) {
    const Inside inside(light);
    ShadeInside result;
    ShadeConstants& made = result.constants;
    made.depth = static_cast<float>(light.depth);
    made.squares = V3f(light.shape.squares());
    made.disk_radius = static_cast<float>(light.disk_radius);
    made.disk2 = made.disk_radius * made.disk_radius;
    const double edge = light.shape.radius_at(light.depth);
    made.edge2 = std::max(made.disk2, static_cast<float>(edge * edge));
    made.disk = V3f(light.radiance);
    for (int colour = 0; colour < 3; ++colour) {
        const Radiances radiances = solve(inside, light.albedo[colour]);
        const double radiance = light.radiance[colour];
        result.mean_radiance[colour] = radiance * out_of(inside, radiances);
        made.ceiling[colour] = static_cast<float>(radiance * radiances.ceiling);
        for (int node = 0; node < ShadeConstants::kNodes; ++node) {
            made.wall[node][colour] = static_cast<float>(radiance * at_node(radiances.wall, node));
        }
    }
    made.disk_chance =
        chance_of_disk(inside, luminance(light.radiance), luminance(result.mean_radiance));
    return result;
}

}  // namespace carom::render
