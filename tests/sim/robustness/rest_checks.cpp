#include "rest_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include <fmt/core.h>

#include "core/length.h"
#include "nonnegative_least_squares.h"
#include "sim/numeric/tolerances.h"
#include "sim/ode/process.h"
#include "sim/scheduler/contact_finder.h"

namespace carom::sim::test {
namespace {

constexpr double kAllowedOverlap = 5e-5;  // m
constexpr double kAllowedResidual = 1e-3;
constexpr int kSides = 16;

/// A pyramid of `count` sides around a cone of this radius: its edges, in a plane across `normal`.
std::vector<Vec3> edges_around(const Vec3& normal, double radius, int count) {
    const Vec3 axis = std::abs(normal.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 right = unit(normal.cross(axis));
    const Vec3 forward = normal.cross(right);
    std::vector<Vec3> edges;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        edges.push_back((right * std::cos(angle) + forward * std::sin(angle)) *
                        (radius / std::cos(std::numbers::pi / count)));
    }
    return edges;
}

/// What a contact exerts on its first body: a force, and a moment about the point of contact.
struct Wrench {
    Vec3 force, moment;
};

/// The edges of the cone of all wrenches that the contact can exert.
std::vector<Wrench> wrenches_of(const ode::StepContact& contact) {
    std::vector<Vec3> moments;
    for (const Vec3& rolling : contact.rolling_arm > 0
                                   ? edges_around(contact.normal, contact.rolling_arm, 8)
                                   : std::vector<Vec3>{{0, 0, 0}}) {
        moments.push_back(rolling + contact.normal * contact.torsional_arm);
        moments.push_back(rolling - contact.normal * contact.torsional_arm);
    }
    std::vector<Wrench> wrenches;
    for (const Vec3& friction : edges_around(contact.normal, contact.friction, kSides)) {
        for (const Vec3& moment : moments) {
            wrenches.push_back({contact.normal + friction, moment});
        }
    }
    return wrenches;
}

/// The bodies that rest, each in an island of those that touch each other. What creeps (more slowly
/// than at kSleepSpeed, at which it would wake them) holds them like the static environment: of
/// what has come to rest some bodies sleep before others.
class RestingBodies {
  public:
    RestingBodies(const WorldDescription& world, const Timeline& timeline, double time,
                  const std::function<bool(const Body&)>& takes_part)
        : environment_(world),
          bodies_(make_moving_bodies(world, environment_)),
          islands_(bodies_.size()) {
        std::iota(islands_.begin(), islands_.end(), 0);
        for (MovingBody& body : bodies_) {
            place(body, timeline, time, takes_part);
        }
        contacts_ = finder().find(bodies_, placements_of(bodies_));
        for (const BodyContact& found : contacts_) {
            if (is_free(found.contact.first) && is_free(found.contact.second)) {
                join(found.contact.first, found.contact.second);
            }
        }
    }

    [[nodiscard]] std::vector<std::string> faults() const {
        std::vector<std::string> faults;
        for (const BodyContact& found : contacts_) {
            if (found.contact.depth > kAllowedOverlap) {
                faults.push_back(fmt::format(
                    "'{}' rests {:.3f} mm inside of '{}'", body(found.contact.first).name(),
                    found.contact.depth * 1e3, finder().name_of(found.partner, bodies_)));
            }
        }
        for (int number = 0; number < static_cast<int>(bodies_.size()); ++number) {
            if (is_free(number) && root(number) == number) {
                check_island(number, faults);
            }
        }
        return faults;
    }

  private:
    static void place(MovingBody& body, const Timeline& timeline, double time,
                      const std::function<bool(const Body&)>& takes_part) {
        if (body.is_kinematic()) {
            body.state = body.path->at(time);
            body.mode = body.path->is_moving_from(time) ? Mode::solver : Mode::asleep;
            return;
        }
        constexpr double kStill = 1e-9;  // m/s, rad/s
        const MotionState state = timeline.find(body.name())->sample(time);
        body.state = state;
        body.state.orientation = state.orientation * body.principal;
        const bool rests =
            length(state.velocity) < kStill && length(state.angular_velocity) < kStill;
        const bool creeps = body.max_point_speed() < kSleepSpeed;
        body.mode = rests ? Mode::solver : creeps ? Mode::asleep : Mode::gone;
        if (!takes_part(*body.description)) {
            body.mode = Mode::gone;
        }
    }

    [[nodiscard]] const MovingBody& body(int number) const {
        return bodies_[static_cast<std::size_t>(number)];
    }
    [[nodiscard]] ContactFinder finder() const { return ContactFinder(environment_); }
    [[nodiscard]] bool is_free(int number) const {
        return number >= 0 && body(number).is_in_solver() && !body(number).is_kinematic();
    }
    [[nodiscard]] int root(int number) const {
        while (islands_[static_cast<std::size_t>(number)] != number) {
            number = islands_[static_cast<std::size_t>(number)];
        }
        return number;
    }
    void join(int a, int b) {
        const std::pair<int, int> roots = std::minmax({root(a), root(b)});
        islands_[static_cast<std::size_t>(roots.second)] = roots.first;
    }

    /// Adds the force and moment about the centre of body `number`, as fractions of its weight.
    void add(int number, const Vec3& point, const Vec3& force, const Vec3& moment,
             const std::map<int, std::size_t>& rows, std::vector<double>& column) const {
        const auto row = rows.find(number);
        if (row == rows.end()) {
            return;
        }
        const MovingBody& b = body(number);
        const double weight = b.mass * length(environment_.gravity);
        const Vec3 about =
            (moment + (point - b.state.position).cross(force)) / (weight * b.bounding_radius());
        for (int axis = 0; axis < 3; ++axis) {
            column[row->second + static_cast<std::size_t>(axis)] = force[axis] / weight;
            column[row->second + 3 + static_cast<std::size_t>(axis)] = about[axis];
        }
    }

    void check_island(int island, std::vector<std::string>& faults) const {
        std::map<int, std::size_t> rows;
        for (int number = island; number < static_cast<int>(bodies_.size()); ++number) {
            if (is_free(number) && root(number) == island) {
                rows.emplace(number, 6 * rows.size());
            }
        }
        std::vector<std::vector<double>> columns;
        for (const BodyContact& found : contacts_) {
            if (!rows.contains(found.contact.first) && !rows.contains(found.contact.second)) {
                continue;
            }
            for (const Wrench& wrench : wrenches_of(found.contact)) {
                const double weight = body(found.contact.first).mass * length(environment_.gravity);
                const Vec3 force = wrench.force * weight;
                const Vec3 moment = wrench.moment * weight;
                columns.emplace_back(6 * rows.size(), 0);
                add(found.contact.first, found.contact.point, force, moment, rows, columns.back());
                add(found.contact.second, found.contact.point, -force, -moment, rows,
                    columns.back());
            }
        }
        std::vector<double> load(6 * rows.size(), 0);
        const Vec3 up = environment_.gravity * (-1 / length(environment_.gravity));
        for (const auto& [number, row] : rows) {
            for (int axis = 0; axis < 3; ++axis) {
                load[row + static_cast<std::size_t>(axis)] = up[axis];
            }
        }
        const std::vector<double> residual = nonnegative_residual(columns, load);
        for (const auto& [number, row] : rows) {
            double square = 0;
            for (std::size_t i = row; i < row + 6; ++i) {
                square += residual[i] * residual[i];
            }
            if (std::sqrt(square) > kAllowedResidual) {
                faults.push_back(
                    fmt::format("'{}' rests without being held: {:.4f} of its weight is missing, "
                                "in an island of {}",
                                body(number).name(), std::sqrt(square), rows.size()));
                return;
            }
        }
    }

    ode::ThreadGuard guard_;
    StaticEnvironment environment_;
    std::vector<MovingBody> bodies_;
    std::vector<int> islands_;
    std::vector<BodyContact> contacts_;
};

}  // namespace

std::vector<std::string> find_unheld(const WorldDescription& world, const Timeline& timeline,
                                     double time,
                                     const std::function<bool(const Body&)>& takes_part) {
    if (length(world.gravity) == 0) {
        return {};
    }
    return RestingBodies(world, timeline, time, takes_part).faults();
}

}  // namespace carom::sim::test
