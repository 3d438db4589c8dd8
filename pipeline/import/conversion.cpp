#include "pipeline/import/conversion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "pipeline/config/text.h"

namespace carom::pipeline::scene_text {

void Conversion::note(const std::string& text) {
    constexpr std::size_t kMost = 100;
    if (notes.size() <= kMost && noted.insert(text).second) {
        notes.push_back(notes.size() < kMost ? text : "further notes are not listed");
    }
}

std::string Conversion::name(const char* kind, const std::string& given, Names& names) {
    std::string made = names.claim(given);
    if (made != given) {
        note(std::string(kind) + " " + config::quote(given) + " is called " + made +
             " in the shot");
    }
    return made;
}

std::string yaml(double value) {
    if (std::abs(value) < 1e-15) {
        return "0";
    }
    return fmt::format("{:.9g}", value);
}

std::string yaml(const Vec3& value) {
    return "[" + yaml(value.x) + ", " + yaml(value.y) + ", " + yaml(value.z) + "]";
}

std::string yaml_text(const std::string& value) {
    std::string text = "\"";
    for (const char c : value) {
        if (c == '"' || c == '\\') {
            text += '\\';
        }
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            text += fmt::format("\\x{:02x}", static_cast<unsigned>(c));
        } else {
            text += c;
        }
    }
    return text + "\"";
}

std::string yaml_rotation(const Vec3& x, const Vec3& y, const Vec3& z) {
    // The rotation matrix has these columns. Its angle follows from the trace, its axis from the
    // antisymmetric part or, for half a turn, from the symmetric part.
    const double cosine = std::clamp((x.x + y.y + z.z - 1) / 2, -1.0, 1.0);
    Vec3 axis(y.z - z.y, z.x - x.z, x.y - y.x);
    const double sine = axis.length() / 2;
    double angle = std::atan2(sine, cosine);
    if (angle < 1e-12) {
        return {};
    }
    if (sine < 1e-6) {
        // (R + 1) / 2 = axis axis^T
        const Vec3 squares((x.x + 1) / 2, (y.y + 1) / 2, (z.z + 1) / 2);
        if (squares.x >= squares.y && squares.x >= squares.z) {
            axis = Vec3(squares.x, (x.y + y.x) / 4, (x.z + z.x) / 4);
        } else if (squares.y >= squares.z) {
            axis = Vec3((x.y + y.x) / 4, squares.y, (y.z + z.y) / 4);
        } else {
            axis = Vec3((x.z + z.x) / 4, (y.z + z.y) / 4, squares.z);
        }
        angle = std::numbers::pi;
    }
    return "rotate: {axis: " + yaml(axis.normalized()) +
           ", angle: " + yaml(angle * 180 / std::numbers::pi) + " deg}";
}

Vec3 middle_of_moving_spheres(const SceneModel& scene) {
    for (const bool moving_only : {true, false}) {
        Vec3 sum(0, 0, 0);
        int count = 0;
        for (const Object& object : scene.objects) {
            if (object.kind == ShapeKind::sphere && (object.uses_physics || !moving_only)) {
                sum += *object.position;
                ++count;
            }
        }
        if (count > 0) {
            return sum / count;
        }
    }
    return scene.cameras.empty() ? Vec3(0, 0, 0) : scene.cameras.front().targets.front();
}

}  // namespace carom::pipeline::scene_text
