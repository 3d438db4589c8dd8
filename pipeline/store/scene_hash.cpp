// The still part of a scene as one hash.
#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "core/error.h"
#include "pipeline/store/frame_key.h"

namespace carom::pipeline {
namespace {

template <class Shape>
concept NamedShape = requires {
    Shape::kName;
};

// Feeds a scene into a hash. Every alternative of a variant starts with its index.
class SceneHasher {
  public:
    explicit SceneHasher(const render::SceneDescription& scene) : scene_(scene) {}

    Hash128 hash() {
        hasher_.add("carom scene, format 3");
        hasher_.add(std::uint64_t{scene_.objects.size()});
        for (const render::ObjectDescription& object : scene_.objects) {
            add(object);
        }
        hasher_.add(std::uint64_t{scene_.lights.size()});
        for (const render::LightDescription& light : scene_.lights) {
            add_variant(light.light);
        }
        return hasher_.finish();
    }

  private:
    template <class Variant>
    void add_variant(const Variant& variant) {
        hasher_.add(std::uint64_t{variant.index()});
        std::visit([this](const auto& alternative) { this->add(alternative); }, variant);
    }

    // Materials count by what they are; an object names one, but the name itself is not seen.
    void add(const render::ObjectDescription& object) {
        add_variant(object.shape);
        hasher_.add(object.world_from_object).add(!object.track.empty());
        for (const render::MaterialDescription& material : scene_.materials) {
            if (material.name == object.material) {
                hasher_.add(material.phong.has_value());
                if (material.phong) {
                    add(*material.phong);
                } else {
                    add(material.surface);
                }
                return;
            }
        }
        throw Error("object '" + object.name + "' has the material '" + object.material +
                    "', which the scene does not describe");
    }

    /// Any shape except meshes.
    template <NamedShape Shape>
    void add(const Shape& shape) {
        shape.fields([this](const char* /*name*/, const auto& field) { add_field(field); });
    }
    template <class Field>
    void add_field(const Field& field) {
        hasher_.add(field);
    }
    void add_field(const std::array<Vec3, 3>& points) {
        for (const Vec3& point : points) {
            hasher_.add(point);
        }
    }

    void add(const render::MeshShape& mesh) {
        add_file(mesh.file);
        hasher_.add(mesh.smooth_angle);
        hasher_.add(std::uint64_t{mesh.vertices.size()});
        for (const Vec3& vertex : mesh.vertices) {
            hasher_.add(vertex);
        }
        hasher_.add(std::uint64_t{mesh.normals.size()});
        for (const Vec3& normal : mesh.normals) {
            hasher_.add(normal);
        }
        hasher_.add(std::uint64_t{mesh.uv.size()});
        for (const Vec2& uv : mesh.uv) {
            hasher_.add(uv);
        }
        hasher_.add(std::uint64_t{mesh.triangles.size()});
        for (const auto& triangle : mesh.triangles) {
            hasher_.add(triangle[0]).add(triangle[1]).add(triangle[2]);
        }
    }

    void add(const render::StandardMaterial& material) {
        add_variant(material.base);
        hasher_.add(material.metal).add(material.roughness).add(material.specular);
        hasher_.add(material.sheen).add(material.sheen_colour).add(material.bump);
        hasher_.add(material.transmission).add(material.ior);
        hasher_.add(material.transmission_colour).add(material.transmission_depth);
        hasher_.add(material.coat.weight).add(material.coat.ior).add(material.coat.roughness);
        hasher_.add(material.emission);
    }

    void add(const render::PhongMaterial& material) {
        add_variant(material.diffuse);
        hasher_.add(material.ambient.has_value()).add(material.ambient.value_or(Vec3(0, 0, 0)));
        hasher_.add(material.specular).add(material.shininess);
        hasher_.add(material.reflectance).add(material.reflectance_spread);
        hasher_.add(material.transmittance).add(material.transmittance_spread);
        hasher_.add(material.index).add(material.emission);
    }

    void add(const Vec3& colour) { hasher_.add(colour); }

    void add(const render::ImageTexture& texture) {
        add_file(texture.file);
        hasher_.add(texture.scale).add(texture.is_linear).add(texture.size.has_value());
        hasher_.add(texture.size.value_or(Vec2(0, 0))).add(texture.offset).add(texture.rotation);
    }

    void add(const render::BallTexture& ball) {
        hasher_.add(ball.colour).add(ball.white).add(ball.striped).add(ball.number);
        hasher_.add(ball.disc_radius).add(ball.spots);
    }

    void add(const render::ClothTexture& cloth) {
        hasher_.add(cloth.colour).add(cloth.thread).add(cloth.variation);
    }

    void add(const render::WoodTexture& wood) {
        hasher_.add(wood.light).add(wood.dark).add(wood.ring).add(wood.grain);
    }

    void add(const render::CheckerTexture& checker) {
        hasher_.add(checker.even).add(checker.odd).add(checker.size);
    }

    void add(const render::RectangleLight& light) {
        hasher_.add(light.centre).add(light.edge_u).add(light.edge_v).add(light.normal);
        hasher_.add(light.radiance);
        add(light.falloff);
    }

    void add(const render::SphereLight& light) {
        hasher_.add(light.centre).add(light.radius).add(light.radiance);
        add(light.falloff);
    }

    void add(const render::EnvironmentLight& light) {
        hasher_.add(light.radiance).add(light.rotation);
        add_file(light.image);
        hasher_.add(light.sky.has_value());
        if (light.sky) {
            hasher_.add(light.sky->sun).add(light.sky->turbidity).add(light.sky->ground);
        }
    }

    void add(render::Falloff falloff) { hasher_.add(static_cast<std::int32_t>(falloff)); }

    void add(const render::PointLight& light) {
        hasher_.add(light.position).add(light.intensity);
        add(light.falloff);
    }

    void add(const render::SpotLight& light) {
        hasher_.add(light.position).add(light.direction).add(light.intensity);
        hasher_.add(light.inner_angle).add(light.outer_angle);
        add(light.falloff);
    }

    void add(const render::DirectionalLight& light) {
        hasher_.add(light.direction).add(light.irradiance);
    }

    // The contents, not the path; each file is read once.
    void add_file(const std::string& path) {
        hasher_.add(!path.empty());
        if (path.empty()) {
            return;
        }
        const auto known = files_.find(path);
        hasher_.add(known != files_.end() ? known->second
                                          : files_.emplace(path, hash_file(path)).first->second);
    }

    const render::SceneDescription& scene_;
    Hasher hasher_;
    std::map<std::string, Hash128> files_;
};

}  // namespace

Hash128 hash_scene(const render::SceneDescription& scene) {
    return SceneHasher(scene).hash();
}

}  // namespace carom::pipeline
