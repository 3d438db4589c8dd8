// Reads the materials and lights of a scene text.
#include "pipeline/import/scene_reader.h"

namespace carom::pipeline::scene_text {

void SceneReader::phong_info(const Name& name, const Item& block) {
    PhongInfo p;
    p.name = name;
    constexpr Limits kNonNegative{0, 1e9};
    attributes("phong_info", name)
        .vector("ambient", p.ambient)
        .vector("diffuse", p.diffuse)
        .vector("specular", p.specular)
        .real("shininess", p.shininess, kNonNegative)
        .real("reflectance", p.reflectance, kNonNegative)
        .real("diffuse_reflection", p.diffuse_reflection, kNonNegative)
        .real("refraction", p.refraction, kNonNegative)
        .real("diffuse_refraction", p.diffuse_refraction, kNonNegative)
        .real("refraction_index", p.refraction_index, {0, 1e9, false, true})
        .read(block.group, name.place);
    claim("phong_info", name, model_.phong_infos.size());
    model_.phong_infos.push_back(std::move(p));
}

void SceneReader::texture(const Name& name, const Item& block) {
    Texture t{name, {}};
    attributes("texture", name)
        .word("filename", t.filename)
        .required()
        .read(block.group, name.place);
    claim("texture", name, model_.textures.size());
    model_.textures.push_back(std::move(t));
}

void SceneReader::material_phong(const Name& name, const Item& block) {
    std::optional<Name> phong;
    attributes("material_phong", name)
        .word("phong_info", phong)
        .required()
        .read(block.group, name.place);
    Material m;
    m.name = name;
    m.phong = refer("phong_info", phong).value_or(0);
    claim("material", name, model_.materials.size());
    model_.materials.push_back(std::move(m));
}

void SceneReader::material_texture(const Name& name, const Item& block) {
    std::optional<Name> phong;
    std::optional<Name> texture;
    Material m;
    m.name = name;
    attributes("material_texture", name)
        .word("phong_info", phong)
        .required()
        .word("texture", texture)
        .required()
        .real("scale_U", m.scale_u, {0, 1e9, false, true, true})
        .real("scale_V", m.scale_v, {0, 1e9, false, true, true})
        .read(block.group, name.place);
    m.phong = refer("phong_info", phong).value_or(0);
    m.texture = refer("texture", texture);
    claim("material", name, model_.materials.size());
    model_.materials.push_back(std::move(m));
}

void SceneReader::add_light(Light light) {
    claim("light", light.name, model_.lights.size());
    model_.lights.push_back(std::move(light));
}

void SceneReader::light_point(const Name& name, const Item& block) {
    Light l{name, LightKind::point, {}, {}, {}, {}, {}};
    attributes("light_point", name)
        .vector("position", l.position)
        .required()
        .vector("color", l.colour)
        .also("colour")
        .read(block.group, name.place);
    add_light(std::move(l));
}

void SceneReader::light_rect(const Name& name, const Item& block) {
    Light l{name, LightKind::rectangle, {}, {}, {}, {}, {}};
    attributes("light_rect", name)
        .vector("position", l.position)
        .required()
        .vector("x", l.x)
        .required()
        .vector("y", l.y)
        .required()
        .vector("color", l.colour)
        .also("colour")
        .read(block.group, name.place);
    add_light(std::move(l));
}

void SceneReader::light_bulb(const Name& name, const Item& block) {
    Light l{name, LightKind::bulb, {}, {}, {}, {}, {}};
    attributes("light_bulb", name)
        .vector("position", l.position)
        .required()
        .real("radius", l.radius, {0, 1e9, false, true})
        .required()
        .vector("color", l.colour)
        .also("colour")
        .read(block.group, name.place);
    add_light(std::move(l));
}

}  // namespace carom::pipeline::scene_text
