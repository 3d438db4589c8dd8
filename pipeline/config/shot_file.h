// The sections of a shot's YAML, before names are resolved and geometry is built.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/camera/camera_rig.h"
#include "pipeline/config/open_strikes.h"
#include "pipeline/config/source_set.h"
#include "pipeline/config/value_types.h"
#include "pipeline/picture/annotation.h"
#include "pipeline/shot/ball_set.h"
#include "pipeline/shot/cue_stick.h"
#include "pipeline/shot/keyed_motion.h"
#include "pipeline/shot/lamp.h"
#include "pipeline/shot/sound_settings.h"
#include "pipeline/solve/solver.h"
#include "pipeline/video/output_settings.h"
#include "render/scene/render_settings.h"
#include "render/scene/scene_description.h"
#include "sim/aim/find_aims.h"
#include "sim/billiards/rack.h"
#include "sim/world.h"

namespace carom::pipeline::config {

/// Properties of all balls. A single ball may replace them.
struct BallSetSection {
    std::optional<BallSet> kind;  // empty: the kind of the table
    std::optional<double> radius;
    std::optional<double> mass;
};

/// Changes of the dimensions of the standard table.
struct PocketSection {
    std::optional<double> mouth, throat, jaw_angle, hole_radius, shelf, drop, lip_radius;
};

struct PocketsSection {
    bool none = false;
    std::optional<PocketSection> corner;
    std::optional<PocketSection> side;
    std::optional<double> jaw_restitution;
    bool has_return = true;
};

struct TableSection {
    sim::billiards::TableKind kind = sim::billiards::TableKind::pool;
    std::optional<std::string> size;
    std::optional<double> length, width, cushion_height, cushion_width, rail_width, rail_height,
        height;
    std::optional<PocketsSection> pockets;
    bool is_drawn = true;
    Place size_place;
};

/// A place on the table: a spot by its name, or a point.
struct TablePlace {
    std::string spot;  // empty: the point
    Coordinates point;
};

struct RackSection {
    sim::billiards::RackKind set = sim::billiards::RackKind::nine_ball;
    std::optional<TablePlace> at;  // of the apex; default: the foot spot
    double gap = sim::billiards::RackOptions{}.gap;
};

/// The look of a ball: a material, or changes of the paint of its set.
struct BallLook {
    std::optional<std::string> material;
    std::optional<Vec3> colour, white;
    std::optional<bool> striped;
    std::optional<int> number, spots;
    std::optional<double> disc_radius, band_width;
};

/// The sides of a table, as TableLayout::sides lists them.
enum class TableSide { front, right, back, left };

/// The place of a ball that touches another body or a cushion.
struct TouchingPlace {
    std::string partner;   // a ball or an object; empty: the cushion
    double direction = 0;  // of this ball as seen from it, counter-clockwise from +x, rad
    std::optional<TableSide> cushion;
    std::optional<double> along;  // of the centre at the cushion: its x or y, m
};

struct BallSection {
    std::optional<TablePlace> at;
    std::optional<TouchingPlace> touching;
    std::optional<Coordinates> velocity;
    std::optional<Vec3> spin;  // rad/s
    std::optional<Quat> rotate;
    std::optional<double> radius;
    std::optional<double> mass;
    std::optional<BallLook> look;
};

/// How an object takes part in the simulation.
struct ObjectPhysics {
    std::optional<sim::BodyKind> kind;  // default: dynamic, or kinematic with a motion
    std::optional<double> density;
    std::optional<double> mass;
    std::string material = "object";  // physical
    std::optional<Vec3> velocity;
    std::optional<Vec3> spin;
};

struct ObjectSection {
    std::optional<render::Shape> shape;
    bool is_degenerate = false;           // a triangle or parallelogram without area
    std::optional<sim::BodyShape> solid;  // the collision shape, if `shape` does not define it
    Vec3 at{0, 0, 0};
    Vec3 centre{0, 0, 0};  // of mass, from the origin in the object's axes (hulls)
    Quat rotate;
    Vec3 scale{1, 1, 1};
    std::optional<double> smooth;           // rad, of a mesh
    std::optional<std::vector<Vec3>> axes;  // three, instead of `rotate` and `scale`
    std::optional<std::string> material;    // of the look
    std::optional<ObjectPhysics> physics;
    std::optional<KeyedMotion> motion;
    Place shape_place;
};

/// A want, and where it stands. A measure is read once the world is known.
struct WantSection {
    solve::Want want;
    Place place;
};

/// A strike that is found.
struct SolveSection {
    std::optional<int> event;  // empty: the first strike whose direction or speed is not given
    std::vector<WantSection> wants, avoided;
    std::vector<solve::Preference> prefer{solve::Preference::likely};
    solve::PlayerError player = *solve::player_error("club");
    Place place;
};

struct EventSection {
    sim::ForceEvent event;
    std::optional<sim::Aim> aim;      // of a strike, instead of its direction
    std::optional<bool> shows_stick;  // of a strike; empty: as the shot says
    Place place;
};

/// The visible cue stick.
struct StickSection {
    bool is_shown = true;
    double length = ShownStick{}.length;
    std::optional<double> tip;  // diameter
};

/// The exposure: a time, or a fraction of a turn of a rotary shutter.
struct ShutterSection {
    Rational length{1, 2};
    bool is_turn = true;
    ShutterClock clock = ShutterClock::video;
    ShutterPosition position = ShutterPosition::centre;
    double switch_ratio = Shutter{}.switch_ratio;
};

/// The room around the table.
struct SetSection {
    double near = render::FarRegion{}.distance;
    double cell = render::FarRegion{}.cell;
    int samples = render::FarRegion{}.samples;
    std::string light;  // absolute path of a file, or empty
};

struct RenderSection {
    render::RenderSettings settings;
    std::optional<int> short_side;  // pixels that the size is scaled to
    Rational fps{24};
    ShutterSection shutter;
};

struct ShotFile {
    sim::WorldDescription world;  // from `simulation` and `physics`
    BallSetSection ball_set;
    std::optional<TableSection> table;
    std::optional<SetSection> set;
    std::optional<RackSection> rack;
    std::vector<Named<BallSection>> balls;
    std::vector<Named<ObjectSection>> objects;
    std::vector<EventSection> events;
    std::vector<SolveSection> solve;  // in the order in which they are found
    std::vector<OpenStrike> open;     // of these
    std::vector<Named<render::MaterialDescription>> materials;  // their own names are empty
    std::vector<Named<Lamp>> lights;                            // without their names
    std::optional<StickSection> stick;
    std::vector<CameraRig> cameras;
    Place cameras_place;
    RenderSection render;
    OutputSettings output;
    SoundSettings sound;
    std::vector<Annotation> annotations;
};

}  // namespace carom::pipeline::config
