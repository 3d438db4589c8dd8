// The description of a simulated world: bodies, table, contact law and force events.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/diagnostic.h"
#include "core/pose.h"
#include "sim/billiards/game.h"
#include "sim/billiards/table.h"
#include "sim/contact_law.h"
#include "sim/force_event.h"
#include "sim/timeline/track.h"
#include "sim/timeline/track_recorder.h"

namespace carom::sim {

struct Sphere {
    double radius = 0.0285750;  // m, > 0
};

struct Box {
    Vec3 size{1, 1, 1};  // full edge lengths along the body's axes, m, > 0
};

/// A cylinder about the body's z axis with a hemisphere on each end.
struct Capsule {
    double radius = 0.02;  // m, > 0
    double length = 0.1;   // between the centres of its hemispheres, m, > 0
};

/// A cylinder about the body's z axis.
struct Cylinder {
    double radius = 0.02;  // m, > 0
    double height = 0.1;   // m, > 0
};

/// The convex hull of points in body axes, m. The origin has to be the centre of mass of the hull
/// (of uniform density), which mass_properties() computes.
struct ConvexHull {
    std::vector<Vec3> points;  // at least four, not in a plane
};

/// A closed or open surface. Allowed for fixed bodies only.
struct TriangleMesh {
    std::vector<Vec3> vertices;                           // body axes, m
    std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from outside
};

using BodyShape = std::variant<Sphere, Box, TriangleMesh, Capsule, Cylinder, ConvexHull>;

enum class BodyKind {
    dynamic,    // moves by the laws of physics
    fixed,      // never moves; others collide with it
    kinematic,  // moved by keys: it pushes others and is not pushed
};

/// The path of a kinematic body.
struct KeyedPath {
    std::shared_ptr<const Track> track;
    Vec3 centre{0, 0, 0};  // of the shape, in the axes of the track, m
};

struct Body {
    std::string name;  // unique in the world; names the track
    BodyShape shape;
    BodyKind kind = BodyKind::dynamic;
    double mass = 0.170097;          // kg, > 0; for dynamic bodies
    std::string material = "ball";   // physical material: "ball", or any name the contact law knows
    Pose pose;                       // of a kinematic body: the pose of its path at 0 s
    Vec3 velocity{0, 0, 0};          // m/s, world axes; for dynamic bodies
    Vec3 angular_velocity{0, 0, 0};  // rad/s, world axes; for dynamic bodies
    std::optional<KeyedPath> path;   // for kinematic bodies
};

struct WorldDescription {
    Vec3 gravity{0, 0, -9.81};  // m/s^2
    double duration = 10;       // s, in (0, 3600]
    double step = 1.0 / 240;    // upper bound for the step of ODE, s, in [1e-5, 0.1]
    std::uint64_t seed = 0;     // for racks' random gaps
    KeyReduction key_reduction;
    ContactLaw contact_law;
    std::optional<billiards::TableMeasures> table;  // the cloth is the plane z = 0
    /// Height z of an infinite floor, m; without one, bodies fall forever.
    std::optional<double> floor_height;
    std::vector<Body> bodies;
    std::vector<ForceEvent> events;
    /// The game whose rule puts balls back whenever everything rests.
    std::optional<billiards::Game> respot;
};

/// All problems of a description; empty if it can be simulated. `bake` throws Error with the first
/// problem's sentence.
[[nodiscard]] std::vector<Diagnostic> find_problems(const WorldDescription& world);
/// Those of its events alone.
[[nodiscard]] std::vector<Diagnostic> find_event_problems(const WorldDescription& world);

}  // namespace carom::sim
