// The keys of the section `sound`.
#include <string>
#include <utility>
#include <vector>

#include "pipeline/config/sections/camera_sound.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/value_types.h"
#include "sound/space/room.h"

namespace carom::pipeline::config {

namespace {

constexpr double kLargestRoom = 1000;         // m
constexpr double kLongestReverberation = 30;  // s
constexpr double kLongestContact = 0.1;       // s
constexpr double kHighestMode = 100e3;        // Hz
constexpr double kLargestPressure = 1e6;      // Pa, of full scale
constexpr double kSoftest = 1e3;              // Pa
constexpr double kStiffest = 2e12;            // Pa
constexpr double kQuietestFilm = -70;         // LUFS
constexpr double kLoudestFilm = -5;           // LUFS
constexpr int kMaxModes = 64;

using sound::RoomSettings;

void check_reverberation(Reader& reader, const Node& node, RoomSettings& room) {
    const Entry* times = node.find("reverberation");
    if (times != nullptr && room.reverberation_high > room.reverberation_low) {
        reader.error(times->value.items.at(1).place,
                     "'reverberation' of high frequencies (the second time) must not be longer "
                     "than that of low ones");
    }
}

const MapSpec<RoomSettings>& room_spec() {
    static const MapSpec<RoomSettings> spec = [] {
        MapSpec<RoomSettings> s("room",
                                "A room like a box. The middle of its floor is below the origin.",
                                RoomSettings{});
        s.key("size", &RoomSettings::size, vector3(Dimension::length, between(1, kLargestRoom)),
              "length along x, width along y and height");
        const auto times = list_of(time(above_up_to(0, kLongestReverberation)), 2, 2);
        s.set(
            "reverberation", times,
            [](RoomSettings& room, const std::vector<double>& ends) {
                room.reverberation_low = ends[0];
                room.reverberation_high = ends[1];
            },
            "times in which the reverberation falls by 60 dB, at low frequencies and at 8 kHz",
            times.show({s.prototype().reverberation_low, s.prototype().reverberation_high}));
        s.check(check_reverberation);
        return s;
    }();
    return spec;
}

/// A name, or a room's measures.
ValueType<RoomSettings> room() {
    std::vector<std::pair<std::string, RoomSettings>> named;
    for (const sound::NamedRoom& one : sound::rooms()) {
        named.emplace_back(one.name, one.room);
    }
    return any_of<RoomSettings>({{is_scalar, choice(named)}, {is_map, record(room_spec())}});
}

/// The pressure of full scale; empty: it is found from the film.
struct FilmGain {
    std::optional<double> full_scale;
};

const MapSpec<FilmGain>& film_gain_spec() {
    static const MapSpec<FilmGain> spec = [] {
        MapSpec<FilmGain> s("full scale",
                            "A fixed gain of the film, so that films can be compared: a pressure "
                            "of the scene gives the same sample in all of them.");
        s.key("full_scale", &FilmGain::full_scale,
              quantity(Dimension::pressure, above_up_to(0, kLargestPressure)),
              "pressure at the listener that is the largest sample. 20 Pa is a peak of 120 dB")
            .required();
        return s;
    }();
    return spec;
}

ValueType<FilmGain> film_gain() {
    const auto found =
        convert<FilmGain>(choice<bool>({{"auto", true}}), [](bool) { return FilmGain{}; });
    return any_of<FilmGain>({{is_exactly("auto"), found}, {is_map, record(film_gain_spec())}});
}

const MapSpec<sound::Mode>& mode_spec() {
    static const MapSpec<sound::Mode> spec = [] {
        using sound::Mode;
        MapSpec<Mode> s("mode", "A vibration that a contact excites, and that rings on.");
        s.key("frequency", &Mode::frequency,
              quantity(Dimension::frequency, above_up_to(0, kHighestMode)), "frequency")
            .required();
        s.key("q", &Mode::q, number(inside(0.5, 1e6)),
              "quality factor: in q periods the vibration fades to e^-pi, 4 %")
            .required();
        s.key("gain", &Mode::gain, number(between(0, 1000)),
              "pressure in Pa, at a distance of 1 m, with which it answers an impulse of 1 N s")
            .required();
        return s;
    }();
    return spec;
}

const MapSpec<SoundMaterial>& sound_material_spec() {
    static const MapSpec<SoundMaterial> spec = [] {
        MapSpec<SoundMaterial> s(
            "sound material",
            "What balls and objects are made of, and what they touch. `modulus`, `poisson` and "
            "`loss` are for solids: the physical materials of balls (`ball`) and objects. "
            "`contact` and `modes` are for `cushion`, `cloth` (the bed of the table), `tip`, "
            "`pocket` and `wood` (the rail, and whatever else is hit). What is not given is that "
            "of common materials.");
        s.key("modulus", &SoundMaterial::modulus, elastic_modulus(between(kSoftest, kStiffest)),
              "modulus of elasticity (Young's modulus). Contacts of stiff solids are short and "
              "bright");
        s.key("poisson", &SoundMaterial::poisson, number(from_below(0, 0.5)), "Poisson's ratio");
        s.key("loss", &SoundMaterial::loss, number(above_up_to(0, 1)),
              "loss factor of the solid's own vibrations, which is 1 / Q");
        s.key("contact", &SoundMaterial::contact, time(above_up_to(0, kLongestContact)),
              "how long a contact lasts. Those with the cloth and the tip are shorter at high "
              "speed; this is then their length at 1 m/s and 3 m/s");
        s.key("modes", &SoundMaterial::modes, list_of(record(mode_spec()), 0, kMaxModes),
              "vibrations that each contact excites. They replace all usual ones");
        return s;
    }();
    return spec;
}

void set_materials(SoundSettings& settings, std::vector<Named<SoundMaterial>> materials) {
    settings.materials.clear();
    for (Named<SoundMaterial>& named : materials) {
        settings.materials.push_back(std::move(named.value));
        settings.materials.back().name = std::move(named.name);
    }
}

const MapSpec<SoundSettings>& sound_spec() {
    static const MapSpec<SoundSettings> spec = [] {
        MapSpec<SoundSettings> s(
            "sound", "The sound of the film. It is computed from the impacts and the motion.");
        s.key("room", &SoundSettings::room, room(),
              "room around the listener: a name, or its measures. `none` has no echo at all, "
              "`outdoors` only that of the ground");
        s.key("bed", &SoundSettings::bed_reflection, number(between(0, 1)),
              "part of the pressure that the bed of the table reflects");
        add_common_sound_keys(s);
        s.set(
            "gain", film_gain(),
            [](SoundSettings& settings, const FilmGain& gain) {
                settings.full_scale = gain.full_scale;
            },
            "`auto`: the film is as loud as it can be without distortion (a true peak of -1 dB), "
            "unless everything in it is quiet; or a fixed gain",
            "auto");
        s.key("loudness", &SoundSettings::loudness,
              quantity(Dimension::loudness, between(kQuietestFilm, kLoudestFilm)),
              "integrated loudness of the film with its music (EBU R 128), reached with a limiter; "
              "a "
              "warning says if it is not. By default the loudness is what results")
            .excluded_by({"gain", [](const Node& value) { return value.is_map(); }, "",
                          "contradicts the fixed 'gain' of the film; give only one of them"});
        s.set("materials", named("sound material", sound_material_spec()), set_materials,
              "properties of physical materials and surfaces");
        return s;
    }();
    return spec;
}

}  // namespace

ValueType<SoundSettings> film_sound() {
    const auto silent = convert<SoundSettings>(choice<bool>({{"none", true}}), [](bool) {
        SoundSettings settings;
        settings.is_silent = true;
        return settings;
    });
    return any_of<SoundSettings>({{is_exactly("none"), silent}, {is_map, record(sound_spec())}});
}

}  // namespace carom::pipeline::config
