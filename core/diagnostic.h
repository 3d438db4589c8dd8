// Problems and warnings as data: the subject, and a sentence for the user.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace carom {

enum class Severity { error, warning };

/// The part of a description to which a diagnostic refers.
struct Subject {
    enum class Kind : std::uint8_t {
        world,     // the simulation as a whole
        contact,   // the contact law of two materials, by name: "ball_cloth", "ball_ball" ...
        table,     // the measures of the table
        body,      // by name
        event,     // a force event, by index
        settings,  // of the renderer
        material,  // by name
        light,     // by name
        object,    // a rendered object, by name
    };
    Kind kind = Kind::world;
    std::string name{};
    std::uint32_t index = 0;

    [[nodiscard]] static Subject body(std::string name) { return {Kind::body, std::move(name)}; }
    [[nodiscard]] static Subject event(std::size_t index) {
        return {Kind::event, {}, static_cast<std::uint32_t>(index)};
    }

    bool operator==(const Subject&) const = default;
};

/// A problem or a warning. Its place in a file is derived from subject and field, never from the
/// sentence.
struct Diagnostic {
    Subject subject;
    std::string field;     // key in the shot's file: "tip", "pockets.corner.mouth"; empty: the
                           // subject as a whole
    std::string sentence;  // without its full stop; it names the subject
    Severity severity = Severity::error;

    bool operator==(const Diagnostic&) const = default;
};

}  // namespace carom
