// Reads the materials of OBJ files (MTL; Wavefront, "Advanced Visualizer Manual", appendix B5, with
// the physically based keys that Exocortex added: Pr, Pm, Ps, Pc, Pcr).
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/vectors.h"

namespace carom::pipeline {

struct MtlPicture {
    std::string file;       // as it was written
    Vec2 scale{1, 1};       // -s
    Vec2 offset{0, 0};      // -o
    double bump = 1;        // -bm
    Vec2 range{0, 1};       // what black and white mean, by -mm
    std::string channel{};  // -imfchan: "red", "green", "blue", "alpha", "luminance", or empty
};

struct MtlMaterial {
    std::optional<Vec3> diffuse, specular, emission;           // Kd, Ks, Ke
    std::optional<double> shininess, roughness, metal, sheen;  // Ns, Pr, Pm, Ps
    std::optional<double> opacity, ior, coat, coat_roughness;  // d or 1 - Tr, Ni, Pc, Pcr
    std::optional<int> illumination;                           // illum
    /// By the statement: "map_Kd", "map_Ke", "map_Pr", "map_Pm", "map_Ps", "map_d", "map_Bump" (or
    /// bump), "norm".
    std::map<std::string, MtlPicture> pictures;
    std::set<std::string> ignored;  // statements that are not read, such as map_Ks
};

struct MtlFile {
    std::map<std::string, MtlMaterial> materials;
    std::string problem;  // "line 3: ..." of the first line that cannot be read; it was skipped
};

[[nodiscard]] MtlFile read_mtl(std::string_view text);

}  // namespace carom::pipeline
