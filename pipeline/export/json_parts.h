// The parts of an export as JSON, which can be left out.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace carom::pipeline {

struct JsonParts {
    bool tracks = true;
    bool objects = true;
    bool meshes = true;  // the vertices and triangles of objects
    bool materials = true;
    bool events = true;
    bool contacts = true;  // lasting_contacts
    bool put_backs = true;
    bool energy = true;
    bool cameras = true;
};

struct JsonPart {
    const char* name;
    bool JsonParts::*wanted;
};

/// All of them with the words that name them.
inline constexpr std::array kJsonParts{
    JsonPart{"tracks", &JsonParts::tracks},       JsonPart{"objects", &JsonParts::objects},
    JsonPart{"meshes", &JsonParts::meshes},       JsonPart{"materials", &JsonParts::materials},
    JsonPart{"events", &JsonParts::events},       JsonPart{"contacts", &JsonParts::contacts},
    JsonPart{"put_backs", &JsonParts::put_backs}, JsonPart{"energy", &JsonParts::energy},
    JsonPart{"cameras", &JsonParts::cameras},
};

/// The words, in the order of the parts.
[[nodiscard]] inline std::vector<std::string> json_part_names() {
    std::vector<std::string> names;
    names.reserve(kJsonParts.size());
    for (const JsonPart& part : kJsonParts) {
        names.emplace_back(part.name);
    }
    return names;
}

}  // namespace carom::pipeline
