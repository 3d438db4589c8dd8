#include "pipeline/import/mesh_material.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "core/error.h"
#include "core/text.h"
#include "pipeline/config/text.h"
#include "pipeline/import/conversion.h"
#include "render/image_files/picture_light.h"
#include "render/image_files/read_picture.h"

namespace carom::pipeline {
namespace {

using config::quote;
using scene_text::yaml;
using scene_text::yaml_text;

constexpr double kBrightest = 1e9;    // of an emission
constexpr double kBumpDepth = 0.001;  // m, of `-bm 1`, which has no unit

double limited(double value) {
    return std::clamp(value, 0.0, 1.0);
}

Vec3 limited(const Vec3& colour, double most) {
    return {std::clamp(colour.x, 0.0, most), std::clamp(colour.y, 0.0, most),
            std::clamp(colour.z, 0.0, most)};
}

double largest(const Vec3& colour) {
    return std::max({colour.x, colour.y, colour.z});
}

/// Whether a picture has normals: on average they point outwards, which is blue. Some programs name
/// such pictures in `map_Bump`.
bool has_normals(const std::string& path) {
    constexpr std::size_t kMostLooks = 10'000;
    try {
        const render::RawPicture picture = render::read_picture(path);
        const std::size_t step = picture.pixel_count() / kMostLooks + 1;
        Vec3 sum(0, 0, 0);
        double count = 0;
        for (std::size_t i = 0; i < picture.pixel_count(); i += step) {
            sum += Vec3(render::pixel_light(picture, i, true).colour);
            count += 1;
        }
        const Vec3 mean = sum / std::max(count, 1.0);
        return std::abs(mean.x - 0.5) < 0.1 && std::abs(mean.y - 0.5) < 0.1 && mean.z > 0.7;
    } catch (const Error&) {
        return false;  // carom check tells what is wrong with it
    }
}

class StandardKeys {
  public:
    StandardKeys(const std::string& name, const MtlMaterial& material, bool has_uv,
                 const MeshFiles& files)
        : name_(name), m_(material), has_uv_(has_uv), files_(files) {}

    std::string text() {
        add_base();
        add_opacity();
        add_roughness();
        add_number("metal", "map_Pm", m_.metal);
        add_number("sheen", "map_Ps", m_.sheen);
        add_coat();
        add_emission();
        add_relief();
        if (!m_.ignored.empty()) {
            note(enumerate(std::vector<std::string>(m_.ignored.begin(), m_.ignored.end()), "and") +
                 (m_.ignored.size() == 1 ? " is" : " are") + " not read");
        }
        return std::move(text_);
    }

  private:
    void note(const std::string& sentence) const {
        files_.note("material " + quote(name_) + ": " + sentence);
    }

    void add(const std::string& key, const std::string& value) {
        text_ += (text_.empty() ? "" : ", ") + key + ": " + value;
    }

    /// The file of a statement's picture; empty if it has none or it was not found.
    [[nodiscard]] std::filesystem::path file_of(const std::string& statement) const {
        const auto picture = m_.pictures.find(statement);
        if (picture == m_.pictures.end()) {
            return {};
        }
        std::filesystem::path file = files_.find(picture->second.file);
        if (file.empty()) {
            note("no picture " + quote(picture->second.file) +
                 " was found; a constant replaces it");
        } else if (!has_uv_) {
            note("it has a picture, but its faces have no texture coordinates");
        }
        return file;
    }

    /// The keys of `image` for the picture of a statement: "{file: a.png}".
    [[nodiscard]] std::string image(const std::string& statement, const std::filesystem::path& file,
                                    const std::string& more = {}) const {
        const MtlPicture& picture = m_.pictures.at(statement);
        std::string text = "{file: " + yaml_text(files_.name(file));
        if (picture.scale != Vec2(1, 1) && picture.scale.x > 0 && picture.scale.y > 0) {
            text += ", scale: [" + yaml(picture.scale.x) + ", " + yaml(picture.scale.y) + "]";
        }
        if (picture.offset != Vec2(0, 0)) {
            text += ", offset: [" + yaml(-picture.offset.x) + ", " + yaml(-picture.offset.y) + "]";
        }
        return text + more + "}";
    }

    [[nodiscard]] std::string number_image(const std::string& statement,
                                           const std::filesystem::path& file) const {
        const std::string& channel = m_.pictures.at(statement).channel;
        return "image: " + image(statement, file, channel.empty() ? "" : ", channel: " + channel);
    }

    /// Whether the statement has a picture, which is added to `key`. White is `most`.
    bool add_picture(const char* key, const std::string& statement, double most = 1) {
        const std::filesystem::path file = file_of(statement);
        if (file.empty()) {
            return false;
        }
        const Vec2 range = m_.pictures.at(statement).range * most;
        std::string text = "{" + number_image(statement, file);
        if (range != Vec2(0, 1)) {
            text += ", range: [" + yaml(limited(range.x)) + ", " + yaml(limited(range.y)) + "]";
        }
        add(key, text + "}");
        return true;
    }

    void add_number(const char* key, const std::string& statement,
                    const std::optional<double>& value) {
        if (!add_picture(key, statement) && value && *value > 0) {
            add(key, yaml(limited(*value)));
        }
    }

    void add_base() {
        const std::filesystem::path file = file_of("map_Kd");
        add("base", file.empty() ? yaml(limited(m_.diffuse.value_or(Vec3(0.8, 0.8, 0.8)), 1))
                                 : "{image: " + image("map_Kd", file) + "}");
    }

    /// The models of illumination 4, 6, 7 and 9 are those of glass. Of all others, `d` says how
    /// much of the surface is there.
    void add_opacity() {
        const double opacity = limited(m_.opacity.value_or(1));
        if (add_picture("opacity", "map_d", opacity) || opacity == 1) {
            return;
        }
        const int model = m_.illumination.value_or(0);
        is_glass_ = model == 4 || model == 6 || model == 7 || model == 9;
        if (!is_glass_) {
            add("opacity", yaml(opacity));
            return;
        }
        add("transmission", yaml(1 - opacity));
        add("ior", yaml(std::clamp(m_.ior.value_or(1.5), 1.0, 3.0)));
        note("its transparency became glass");
    }

    /// Highlights of n have the width of a microfacet lobe with alpha^2 = 2 / (n + 2) (Walter et
    /// al. 2007, section 5.2), and alpha is the square of the roughness. A specular colour of 0.5
    /// is what programs write for a plain dielectric, which is a weight of 1.
    void add_roughness() {
        const bool is_matt = m_.illumination && *m_.illumination < 2;
        const double weight = largest(m_.specular.value_or(Vec3(0, 0, 0)));
        if (is_glass_ && m_.pictures.contains("map_Pr")) {
            note("map_Pr is not read, because glass has the same roughness everywhere");
        }
        const bool has_picture = !is_glass_ && add_picture("roughness", "map_Pr");
        if (!has_picture && (m_.roughness || (m_.shininess && !is_matt))) {
            add("roughness", yaml(limited(m_.roughness.value_or(std::pow(
                                 2 / (std::max(0.0, m_.shininess.value_or(0)) + 2), 0.25)))));
        }
        if (weight > 0 && !is_matt) {
            add("specular", yaml(limited(2 * weight)));
        }
    }

    void add_coat() {
        if (m_.coat && *m_.coat > 0) {
            add("coat", "{weight: " + yaml(limited(*m_.coat)) +
                            ", roughness: " + yaml(limited(m_.coat_roughness.value_or(0))) + "}");
        }
    }

    /// A black `Ke` beside a picture is what programs write that have no factor.
    void add_emission() {
        const Vec3 emission = limited(m_.emission.value_or(Vec3(0, 0, 0)), kBrightest);
        const double strength = largest(emission);
        const std::filesystem::path file = file_of("map_Ke");
        if (file.empty()) {
            if (strength > 0) {
                add("emission", yaml(emission));
            }
            return;
        }
        const Vec3 tint = strength > 0 ? emission / strength : Vec3(1, 1, 1);
        const bool is_tinted = tint != Vec3(1, 1, 1);
        add("emission",
            "{image: " + image("map_Ke", file, is_tinted ? ", tint: " + yaml(tint) : "") + "}");
        if (strength > 0 && strength != 1) {
            add("emission_strength", yaml(strength));
        }
    }

    void add_relief() {
        const bool has_norm = m_.pictures.contains("norm");
        if (has_norm && m_.pictures.contains("map_Bump")) {
            note("map_Bump is not read, because norm is");
        }
        const std::string statement = has_norm ? "norm" : "map_Bump";
        const std::filesystem::path file = file_of(statement);
        if (file.empty()) {
            return;
        }
        const double bump = m_.pictures.at(statement).bump;
        if (has_norm || has_normals(file.string())) {
            const bool is_plain = bump == 1 || bump < 0;
            add("normal", "{image: " + image(statement, file) +
                              (is_plain ? "" : ", strength: " + yaml(std::min(bump, 10.0))) + "}");
        } else {
            const double depth = std::clamp(bump * kBumpDepth, -1.0, 1.0);
            add("height", "{" + number_image(statement, file) + ", depth: " + yaml(depth) + "}");
            note("the depth of its relief has no unit in the file; it is " +
                 fmt::format("{:.3g} mm", 1000 * depth));
        }
    }

    const std::string& name_;
    const MtlMaterial& m_;
    bool has_uv_;
    const MeshFiles& files_;
    bool is_glass_ = false;
    std::string text_;
};

}  // namespace

std::string standard_keys(const std::string& name, const MtlMaterial& material, bool has_uv,
                          const MeshFiles& files) {
    return StandardKeys(name, material, has_uv, files).text();
}

}  // namespace carom::pipeline
