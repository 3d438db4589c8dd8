// Checks what a shot says about the sound of its bodies and about the places of listeners.
#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/config/build/builder.h"
#include "pipeline/config/text.h"

namespace carom::pipeline::config {

namespace {

using Path = std::vector<std::string>;

/// What has a contact time and modes of its own.
constexpr std::array<std::string_view, 5> kStructures{"cushion", "cloth", "tip", "pocket", "wood"};

/// The physical materials of the shot's bodies.
std::set<std::string> materials_of(const sim::WorldDescription& world) {
    std::set<std::string> names;
    for (const sim::Body& body : world.bodies) {
        names.insert(body.material);
    }
    return names;
}

void report(Builder& builder, const Path& path, const std::string& message) {
    FoundPlace found = find_place(builder.root, path);
    builder.reader.error_at_path(found.place, message, std::move(found.key_path));
}

/// Reports those of the material's `values` that are given, since it has no use for them.
template <class... Values>
void report_unused(Builder& builder, const std::string& name, const std::string& reason,
                   const Values&... values) {
    const auto report_one = [&](const char* key, bool is_given) {
        if (is_given) {
            report(builder, {"sound", "materials", name, key},
                   quote(key) + " has no meaning for " + quote(name) + ", " + reason);
        }
    };
    (report_one(values.first, values.second), ...);
}

void check_material(Builder& builder, const SoundMaterial& material,
                    const std::set<std::string>& solids) {
    const bool is_structure = std::ranges::find(kStructures, material.name) != kStructures.end();
    const bool is_solid = solids.contains(material.name);
    if (!is_structure && !is_solid) {
        std::vector<std::string> known(solids.begin(), solids.end());
        known.insert(known.end(), kStructures.begin(), kStructures.end());
        Message help = hint(material.name, known);
        if (help.text.empty()) {
            help = " (the materials are " + enumerate(known, "and") + ")";
        }
        builder.reader.warning(
            builder.place_of({"sound", "materials", material.name}),
            "nothing in the shot is of the material " + quote(material.name) + help);
        return;
    }
    if (!is_structure) {
        report_unused(builder, material.name,
                      "whose contacts and vibrations follow from its modulus, mass and shape",
                      std::pair("contact", material.contact.has_value()),
                      std::pair("modes", material.modes.has_value()));
    }
    if (!is_solid) {
        report_unused(builder, material.name, "which has a contact time and modes instead",
                      std::pair("modulus", material.modulus.has_value()),
                      std::pair("poisson", material.poisson.has_value()),
                      std::pair("loss", material.loss.has_value()));
    }
}

/// Warns of a listener that a ball begins around.
void check_listener(Builder& builder, const CameraSound& sound, const Path& path) {
    if (!sound.listener || sound.listener->is_camera) {
        return;
    }
    for (const sim::Body& body : builder.shot.world.bodies) {
        const auto* ball = std::get_if<sim::Sphere>(&body.shape);
        if (ball != nullptr && (sound.listener->at - body.pose.position).length() < ball->radius) {
            builder.reader.warning(
                builder.place_of(path),
                "the listener is inside " + quote(body.name) + " when the simulation begins");
        }
    }
}

}  // namespace

void build_sound(Builder& builder) {
    const Reader::Scope scope(builder.reader, "sound", {});
    const SoundSettings& sound = builder.shot.sound = builder.file.sound;
    const std::set<std::string> solids = materials_of(builder.shot.world);
    for (const SoundMaterial& material : sound.materials) {
        check_material(builder, material, solids);
    }
    check_listener(builder, sound.cameras, {"sound", "listener", "at"});
    for (std::size_t i = 0; i < builder.shot.cameras.size(); ++i) {
        check_listener(builder, builder.shot.cameras[i].sound,
                       {"cameras", fmt::format("{}", i), "sound", "listener", "at"});
    }
}

}  // namespace carom::pipeline::config
