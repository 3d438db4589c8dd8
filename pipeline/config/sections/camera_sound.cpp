#include "pipeline/config/sections/camera_sound.h"

#include <array>
#include <limits>
#include <string>
#include <utility>

#include "pipeline/config/value_types.h"
#include "sound/sound_scene.h"

namespace carom::pipeline::config {

namespace {

constexpr double kFarthest = 1e6;  // m
constexpr double kQuietest = -120;
constexpr double kLoudest = 60;  // dB

/// What the groups are, in the order of sound::kGroupNames.
constexpr std::array<std::string_view, sound::kGroupCount> kGroups{
    "balls that touch balls",
    "balls that touch cushions",
    "what falls on the bed of the table",
    "strikes",
    "balls that touch pockets",
    "all other contacts",
    "balls that roll or slide on the cloth"};

ValueType<double> gain() {
    return quantity(Dimension::level, between(kQuietest, kLoudest));
}

void check_facing(Reader& reader, const Node& node, ListenerPlace& listener) {
    constexpr double kLeast = 1e-6;  // horizontal part of the direction
    const Vec3& facing = listener.facing;
    if (!(Vec2(facing.x, facing.y).length() > kLeast * facing.length())) {
        const Entry* entry = node.find("facing");
        reader.error(entry != nullptr ? entry->value.place : node.place,
                     facing.length() > 0
                         ? "'facing' must not point straight up or down, because nothing is then "
                           "on the left or right of the listener"
                         : "'facing' must not be the zero vector");
    }
}

const MapSpec<ListenerPlace>& listener_spec() {
    static const MapSpec<ListenerPlace> spec = [] {
        ListenerPlace prototype;
        prototype.is_camera = false;
        MapSpec<ListenerPlace> s("listener", "One place from which the film is heard.", prototype);
        s.key("at", &ListenerPlace::at, vector3(Dimension::length, between(-kFarthest, kFarthest)),
              "where the listener is")
            .required();
        s.key("facing", &ListenerPlace::facing, vector3(Dimension::none),
              "direction in which the listener looks, neither straight up nor down");
        s.check(check_facing);
        return s;
    }();
    return spec;
}

ValueType<ListenerPlace> listener() {
    const auto camera = convert<ListenerPlace>(choice<bool>({{"camera", true}}),
                                               [](bool) { return ListenerPlace{}; });
    return any_of<ListenerPlace>(
        {{is_exactly("camera"), camera}, {is_map, record(listener_spec())}});
}

ValueType<double> pitch() {
    const auto word = choice<double>({{"follow", 1}, {"keep", 0}});
    return any_of<double>({{is_word, word}, {is_scalar, number(between(0, 1))}});
}

ValueType<double> dynamics() {
    const auto word = choice<double>({{"film", 2}, {"natural", 1}});
    return any_of<double>({{is_word, word}, {is_scalar, number(between(1, 4))}});
}

/// `has_defaults`: the levels have defaults that are shown.
MapSpec<CameraSound> make_mix_spec(const char* name, const char* description, bool has_defaults) {
    MapSpec<CameraSound> s(name, description);
    for (std::size_t i = 0; i < kGroups.size(); ++i) {
        s.set(
            sound::kGroupNames[i], gain(),
            [i](CameraSound& sound, double level) { sound.mix[i] = level; }, kGroups[i],
            has_defaults ? gain().show(sound::ClipSettings{}.mix[i]) : "");
    }
    return s;
}

const MapSpec<CameraSound>& film_mix_spec() {
    static const MapSpec<CameraSound> spec =
        make_mix_spec("mix", "Levels of groups of sounds.", true);
    return spec;
}

const MapSpec<CameraSound>& camera_mix_spec() {
    static const MapSpec<CameraSound> spec = make_mix_spec(
        "camera mix", "Levels of groups of sounds while a camera films, instead of the film's.",
        false);
    return spec;
}

/// Adds the common keys to the map of a T.
template <class T>
class CommonKeys {
  public:
    /// `access`: the values in a T.
    CommonKeys(MapSpec<T>& spec, CameraSound& (*access)(T&), bool has_defaults)
        : spec_(spec), access_(access), has_defaults_(has_defaults) {}

    void add_all() {
        const sound::ClipSettings usual;
        add("listener", &CameraSound::listener, listener(), "camera",
            "`camera`: the film is heard from where it is seen; or one place");
        add("stereo", &CameraSound::stereo,
            choice<sound::Stereo>({{"sphere", sound::Stereo::sphere},
                                   {"pan", sound::Stereo::pan},
                                   {"mono", sound::Stereo::mono}}),
            usual.stereo,
            "how directions become two channels. `sphere`: the ears of a head, for headphones and "
            "loudspeakers; `pan`: by level alone; `mono`: not at all");
        add("width", &CameraSound::width,
            choice<sound::Width>({{"frame", sound::Width::frame}, {"real", sound::Width::real}}),
            usual.width,
            "`frame`: the edges of the picture sound from the loudspeakers, even with a long lens; "
            "`real`: directions are those of the scene");
        add("pitch", &CameraSound::pitch, pitch(), usual.pitch,
            "whether the pitch of sounds follows the speed of the film: `follow`, `keep`, or how "
            "far: the pitch is multiplied by the speed to the power of this number");
        add("lowest", &CameraSound::lowest, number(above_up_to(0, 1)), usual.lowest,
            "speed below which the pitch falls no further: 1/8 is three octaves");
        add("reverse", &CameraSound::mirrors_reverse,
            choice<bool>({{"mirrored", true}, {"forward", false}}), usual.mirrors_reverse,
            "sounds while time runs backwards: `mirrored` ones swell and end in their impact, "
            "`forward` ones begin with it");
        add("delay", &CameraSound::has_delay, boolean(), usual.has_delay,
            "whether sound takes its time to the listener, 3 ms for each metre");
        add("dynamics", &CameraSound::ratio, dynamics(), usual.ratio,
            "how much the levels of loud and quiet sounds are brought together: `film`, which "
            "halves their distances from 80 dB at 1 m, `natural`, which leaves them, or what they "
            "are divided by");
        spec_.map("mix", access_, has_defaults_ ? film_mix_spec() : camera_mix_spec(),
                  "levels of groups of sounds");
    }

  private:
    template <class V>
    void add(const char* name, std::optional<V> CameraSound::*field, const ValueType<V>& type,
             const V& usual, const char* description) {
        add(name, field, type, type.show(usual), description);
    }
    template <class V>
    void add(const char* name, std::optional<V> CameraSound::*field, const ValueType<V>& type,
             const std::string& usual, const char* description) {
        spec_.set(
            name, type,
            [access = access_, field](T& target, V value) {
                access(target).*field = std::move(value);
            },
            description, has_defaults_ ? usual : std::string());
    }

    MapSpec<T>& spec_;
    CameraSound& (*access_)(T&);
    bool has_defaults_;
};

CameraSound& sound_of_all(SoundSettings& settings) {
    return settings.cameras;
}
CameraSound& itself(CameraSound& sound) {
    return sound;
}

const MapSpec<CameraSound>& camera_sound_spec() {
    static const MapSpec<CameraSound> spec = [] {
        MapSpec<CameraSound> s("camera sound",
                               "The sound while a camera films, where it differs from that of the "
                               "whole film.");
        s.key("gain", &CameraSound::gain, gain(), "level of all sounds. The default is 0 dB");
        CommonKeys<CameraSound>(s, itself, false).add_all();
        for (const char* key : {"room", "bed", "loudness", "materials"}) {
            s.refuse(key, "is the same for all cameras; give it in the shot's own 'sound'");
        }
        return s;
    }();
    return spec;
}

}  // namespace

void add_common_sound_keys(MapSpec<SoundSettings>& spec) {
    CommonKeys<SoundSettings>(spec, sound_of_all, true).add_all();
}

ValueType<CameraSound> camera_sound() {
    const auto muted = convert<CameraSound>(choice<bool>({{"none", true}}), [](bool) {
        CameraSound sound;
        sound.gain = -std::numeric_limits<double>::infinity();
        return sound;
    });
    return any_of<CameraSound>(
        {{is_exactly("none"), muted}, {is_map, record(camera_sound_spec())}});
}

}  // namespace carom::pipeline::config
