// What a film's sound is computed from, as plain data: the things that sound, the places from which
// they are heard, and the map from film time to scene time.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/vectors.h"
#include "sim/timeline/timeline.h"

namespace carom::sound {

inline constexpr int kSampleRate = 48000;     // Hz, of all sound
inline constexpr double kSpeedOfSound = 343;  // m/s, in air of 20 degrees Celsius

/// The film time (s) of a sample.
[[nodiscard]] constexpr double time_of_sample(std::int64_t sample) {
    return static_cast<double>(sample) / kSampleRate;
}

/// What a solid is made of, for the duration of its contacts and for its own modes.
struct Material {
    double modulus = 5.84e9;    // Young's modulus, Pa, > 0
    double poisson = 0.34;      // in [0, 0.5)
    double loss = 0.02;         // loss factor, 1 / Q of its modes, > 0
    double restitution = 0.95;  // of two bodies of it, [0, 1]: from an impulse to a speed

    bool operator==(const Material&) const = default;
};

/// A mode of a resonator, which an impact excites.
struct Mode {
    double frequency = 440;  // Hz, > 0
    double q = 10;           // > 0.5
    double gain = 0;         // Pa m per N s: of the pressure at 1 m, which falls with 1/r

    bool operator==(const Mode&) const = default;
};

/// A surface or a tip that bodies touch: a bank of modes. Its contact time is measured instead of
/// computed.
struct Resonator {
    double contact = 1e-3;        // s, of a contact at `reference_speed`
    double contact_exponent = 0;  // of the contact time over the speed of approach
    double reference_speed = 1;   // m/s
    double restitution = 0.5;     // [0, 1], from an impulse to a speed of approach
    std::vector<Mode> modes;

    bool operator==(const Resonator&) const = default;
};

struct BallShape {
    double radius = 0.028575;  // m, > 0
};
struct BoxShape {
    Vec3 size{1, 1, 1};  // m, full edges along the axes of the body's track
};
/// Any other shape: it sounds like the sphere of its volume.
struct OtherShape {
    double volume = 1e-4;  // m^3, > 0
};

/// A body that may sound. Its place at any time is that of the track of its name; a body without a
/// track never moves.
struct SoundBody {
    std::string name;
    std::variant<BallShape, BoxShape, OtherShape> shape;
    double mass = 0.17;  // kg, > 0; infinite for bodies that do not move
    Material material;
    Vec3 position{0, 0, 0};  // m, of a body without a track
};

/// Groups of sounds whose levels can be set, and which can be written as files of their own.
enum class Group { balls, cushions, cloth, stick, pockets, objects, rolling };
inline constexpr std::size_t kGroupCount = 7;

/// Their names in shots and of files, by Group.
inline constexpr std::array<std::string_view, kGroupCount> kGroupNames{
    "balls", "cushions", "cloth", "stick", "pockets", "objects", "rolling"};

/// Where the listener is, and where it looks: orthogonal unit vectors.
struct Listener {
    Vec3 position{0, 0, 0};
    Vec3 right{1, 0, 0};
    Vec3 ahead{0, 1, 0};
    Vec3 up{0, 0, 1};
    double half_width = 0.5;  // rad, half of the horizontal angle that the picture shows
};

enum class Stereo { sphere, pan, mono };
enum class Width { frame, real };

/// How a camera's sound is made.
struct ClipSettings {
    double gain = 0;              // dB
    double pitch = 1;             // exponent of the speed: 1 follows it, 0 keeps the pitch
    double lowest = 0.125;        // the pitch goes no lower than at this speed, > 0
    bool mirrors_reverse = true;  // backwards, sounds are mirrored in time about their instants
    bool has_delay = true;        // sound takes its time to the listener
    Stereo stereo = Stereo::sphere;
    Width width = Width::frame;
    double ratio = 2;  // of the compression of levels, >= 1; 1 leaves them as they are
    std::array<double, kGroupCount> mix{};  // dB, by Group
};

/// A segment of the film, shown by one camera, in which scene time is monotonic: it rises, falls or
/// stands still. All times are of the film, s, in [from, to). Functions may be called for times up
/// to 30 ms outside of it, and depend on nothing but their argument. Where one clip continues at
/// the scene time at which another ends, both give the same number there: an impact at that instant
/// is then heard once.
struct Clip {
    double from = 0;
    double to = 0;
    std::string camera;
    std::function<double(double)> scene_time;  // s
    std::function<double(double)> speed;       // scene s per film s; of one sign in the whole clip
    std::function<Listener(double)> listener;
    std::function<double(double)> weight;  // of the pressure, [0, 1]; it changes during fades
    ClipSettings settings;
};

/// The room in which the listener is.
struct RoomSettings {
    enum class Kind { none, box, outdoors };
    Kind kind = Kind::box;
    Vec3 size{8, 6, 2.8};            // m, along the axes
    Vec3 floor_centre{0, 0, -0.8};   // m, the middle of the floor (or the ground outdoors)
    double reverberation_low = 0.6;  // s to -60 dB, at low frequencies
    double reverberation_high = 0.35;

    bool operator==(const RoomSettings&) const = default;
};

/// The resonators, by what bodies touch.
struct Resonators {
    Resonator cushion, bed, stick, pocket, wood, box_on_cloth;
};

/// One shot of a film: its motion, what sounds in it, and how the film shows it.
struct SoundShot {
    const sim::Timeline* timeline = nullptr;
    std::vector<SoundBody> bodies;
    std::vector<Clip> clips;       // in order of time; fades overlap
    bool has_bed = false;          // a slate bed at z = 0, under cloth
    double bed_reflection = 0.85;  // of the pressure, [0, 1]
    Resonators resonators;
    RoomSettings room;
};

/// The sound of a whole film.
struct SoundScene {
    std::vector<SoundShot> shots;
    std::int64_t frames = 0;  // samples of each channel: its length
    /// Pressure of full scale, Pa; empty: so that the film's true peak is -1 dBTP, but never below
    /// 0.2 Pa.
    std::optional<double> full_scale;
    std::optional<double> loudness;  // LUFS that are asked for, with a limiter
};

}  // namespace carom::sound
