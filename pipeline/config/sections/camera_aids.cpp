#include "pipeline/config/sections/camera_aids.h"

#include "pipeline/config/show_quantity.h"
#include "pipeline/config/value_types.h"

namespace carom::pipeline::config {

namespace {

constexpr double kStrongest = 0.17453292519943295;  // rad, of a shake
constexpr double kFastest = 20;                     // Hz

/// The kinds of shake; there is one so far.
enum class ShakeKind { handheld };

ValueType<ShakeKind> shake_kind() {
    return choice<ShakeKind>({{"handheld", ShakeKind::handheld}});
}

const MapSpec<Shake>& shake_spec() {
    static const MapSpec<Shake> spec = [] {
        MapSpec<Shake> s("shake",
                         "The movement of a camera that somebody holds: smooth noise in its "
                         "direction and, a little, in its position.");
        s.set(
             "kind", shake_kind(), [](Shake&, ShakeKind) {}, "`handheld`")
            .required();
        ValueType<double> strength = angle(between(0, kStrongest));
        strength.show = [](double value) { return show(value, Dimension::angle); };
        s.key("strength", &Shake::strength, strength,
              "root mean square of the angle by which the camera pans and tilts. It rolls by half "
              "of that and moves by 6 mm per degree");
        s.key("frequency", &Shake::frequency,
              quantity(Dimension::frequency, above_up_to(0, kFastest)),
              "frequency of the main movement. There is none faster than four times that");
        s.key("seed", &Shake::seed,
              convert<std::uint64_t>(
                  integer64(0, INT64_MAX),
                  [](std::int64_t seed) { return static_cast<std::uint64_t>(seed); }),
              "another seed gives another movement. Cameras with the same seed move together");
        return s;
    }();
    return spec;
}

/// A word, or a map.
ValueType<Shake> shake() {
    const auto word = convert<Shake>(shake_kind(), [](ShakeKind) { return Shake{}; });
    return any_of<Shake>({{is_scalar, word}, {is_map, record(shake_spec())}});
}

Framing& framing_of(CameraRig& rig) {
    return rig.framing ? *rig.framing : rig.framing.emplace();
}

}  // namespace

void add_fov_axis(MapSpec<CameraRig>& spec) {
    spec.key("fov_axis", &CameraRig::fov_axis,
             choice<FovAxis>({{"vertical", FovAxis::vertical},
                              {"horizontal", FovAxis::horizontal},
                              {"wider", FovAxis::wider}}),
             "side of the picture that `fov` and `sensor` measure: its height, its width, or "
             "whichever is longer");
}

void add_aids(MapSpec<CameraRig>& spec) {
    enum class Framed { table };
    spec.set(
        "frame", choice<Framed>({{"table", Framed::table}}),
        [](CameraRig& rig, Framed) { framing_of(rig); },
        "`table`: the camera moves along its axis, the line from `position` to `target`, to the "
        "nearest place from which the whole table with its rails is in the picture. Its direction "
        "and its field of view stay as they are");
    spec.set(
            "frame_margin", number(from_below(0, 0.45)),
            [](CameraRig& rig, double margin) { framing_of(rig).margin = margin; },
            "part of the picture's width and height that stays free at each edge", "0.05")
        .goes_with({"frame"});
    spec.key("shake", &CameraRig::shake, shake(),
             "`handheld`, or {kind, strength, frequency, seed}: the camera moves as if it were "
             "held");
}

}  // namespace carom::pipeline::config
