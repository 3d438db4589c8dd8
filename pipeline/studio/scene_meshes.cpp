#include "pipeline/studio/scene_meshes.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <system_error>
#include <utility>
#include <variant>

#include "core/field_hasher.h"
#include "pipeline/export/object_pose.h"
#include "pipeline/export/scene_glb.h"
#include "pipeline/studio/lighter_meshes.h"

namespace carom::studio {

namespace {

// While meshes are dragged, a page may ask for those of some versions ago.
constexpr std::size_t kLeastFiles = 4;
constexpr std::size_t kMostFiles = 32;
constexpr std::size_t kMostBytes = std::size_t{64} << 20;  // beyond kLeastFiles

/// Pictures are known by their time and size, as meshes are.
void add_material(FieldHasher& hasher, const render::MaterialDescription& material) {
    hasher.add(material.name);
    hasher.add_value(material);
}

void add_light(FieldHasher& hasher, const render::LightDescription& light) {
    if (const auto* rectangle = std::get_if<render::RectangleLight>(&light.light)) {
        hasher.add(light.name).add(rectangle->edge_u).add(rectangle->edge_v);
        hasher.add(rectangle->normal).add(rectangle->radiance);
    } else if (const auto* sphere = std::get_if<render::SphereLight>(&light.light)) {
        hasher.add(light.name).add(sphere->radius).add(sphere->radiance);
    } else if (const auto* disk = std::get_if<render::DiskLight>(&light.light)) {
        hasher.add(light.name).add(disk->radius).add(disk->normal).add(disk->radiance);
    } else if (const auto* shade = std::get_if<render::ShadeLight>(&light.light)) {
        hasher.add(light.name);
        hasher.add_value(*shade);
    }
}

template <class T>
void add_all(FieldHasher& hasher, const std::vector<T>& values) {
    hasher.add_bytes(std::as_bytes(std::span(values)));
}

/// The numbers as they lie in memory: a table has a hundred thousand of them. A mesh's file is
/// known by its time and its size, so that it is not read for every change of the shot.
void add_shape(FieldHasher& hasher, const render::Shape& shape) {
    const auto* mesh = std::get_if<render::MeshShape>(&shape);
    if (mesh == nullptr) {
        hasher.add_value(shape);
        return;
    }
    hasher.add(mesh->file).add(mesh->smooth_angle);
    if (!mesh->file.empty()) {
        std::error_code code;
        const auto time = std::filesystem::last_write_time(mesh->file, code);
        hasher.add(code ? std::int64_t{0} : std::int64_t{time.time_since_epoch().count()});
        const std::uintmax_t size = std::filesystem::file_size(mesh->file, code);
        hasher.add(code ? std::uint64_t{0} : std::uint64_t{size});
    }
    add_all(hasher, mesh->vertices);
    add_all(hasher, mesh->normals);
    add_all(hasher, mesh->uv);
    add_all(hasher, mesh->triangles);
}

}  // namespace

Hash128 hash_meshes(const pipeline::Shot& shot) {
    FieldHasher hasher(FileHash::stamp);
    for (const render::ObjectDescription& object : shot.scene.objects) {
        hasher.add(object.name).add(object.material);
        add_shape(hasher, object.shape);
        hasher.add(object.track.empty() ? pipeline::split_pose(object.world_from_object).remainder
                                        : object.world_from_object);
    }
    for (const render::MaterialDescription& material : shot.scene.materials) {
        add_material(hasher, material);
    }
    for (const render::LightDescription& light : shot.scene.lights) {
        add_light(hasher, light);
    }
    return hasher.finish();
}

std::string MeshFiles::add(const pipeline::Shot& shot) {
    std::string hash = hash_meshes(shot).to_string();
    {
        const std::lock_guard lock(mutex_);
        const auto found = std::ranges::find(files_, hash, &File::hash);
        if (found != files_.end()) {
            std::rotate(found, found + 1, files_.end());
            return hash;
        }
    }
    pipeline::ExportScene scene = pipeline::export_meshes(shot);
    lighten(scene);
    auto bytes = std::make_shared<const std::string>(pipeline::scene_to_glb(scene, pictures_));
    const std::lock_guard lock(mutex_);
    bytes_ += bytes->size();
    files_.push_back({hash, std::move(bytes)});
    while (files_.size() > kMostFiles || (files_.size() > kLeastFiles && bytes_ > kMostBytes)) {
        bytes_ -= files_.front().bytes->size();
        files_.pop_front();
    }
    return hash;
}

std::shared_ptr<const std::string> MeshFiles::find(std::string_view hash) const {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(files_, hash, &File::hash);
    return found == files_.end() ? nullptr : found->bytes;
}

}  // namespace carom::studio
