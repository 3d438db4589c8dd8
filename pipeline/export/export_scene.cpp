#include "pipeline/export/export_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include <Imath/ImathBox.h>
#include <Imath/ImathMatrixAlgo.h>

#include "core/error.h"
#include "pipeline/camera/exposure.h"
#include "pipeline/camera/path_fit.h"
#include "pipeline/camera/rig_state.h"
#include "pipeline/camera/time_map.h"
#include "pipeline/export/export_material.h"
#include "pipeline/export/object_pose.h"
#include "pipeline/export/object_textures.h"
#include "pipeline/export/painted_sphere.h"
#include "pipeline/export/shape_mesh.h"
#include "render/geometry/smooth_normals.h"
#include "render/light/light_power.h"

namespace carom::pipeline {

namespace {

class SceneBuilder {
  public:
    /// `timeline`: nullptr for meshes without poses.
    SceneBuilder(const Shot& shot, const sim::Timeline* timeline)
        : shot_(shot), timeline_(timeline) {}

    ExportScene run() {
        scene_.name = shot_.name;
        if (timeline_ != nullptr) {
            add_film();
        }
        for (const render::MaterialDescription& material : shot_.scene.materials) {
            descriptions_[material.name] = &material;
        }
        for (const render::ObjectDescription& object : shot_.scene.objects) {
            add_object(object);
        }
        for (const render::LightDescription& light : shot_.scene.lights) {
            add_lamp(light);
        }
        return std::move(scene_);
    }

  private:
    void add_film() {
        scene_.start_time = timeline_->start_time;
        scene_.end_time = timeline_->end_time;
        scene_.fps = shot_.timing.fps.to_double();
        scene_.aspect =
            static_cast<double>(shot_.render.width) / static_cast<double>(shot_.render.height);
        scene_.lights = shot_.scene.lights;
        for (const CameraRig& rig : with_fitted_paths(shot_.cameras, *timeline_)) {
            add_camera(rig);
        }
    }

    /// The index of the material in the list. Each material is added once, or once for each size of
    /// its relief.
    std::size_t material(ExportMaterial material, MaterialTextures textures = {}) {
        const Vec2 lengths = textures.relief_lengths;
        std::map<std::pair<double, double>, std::size_t>& sizes = materials_[material.name];
        const auto [known, is_new] =
            sizes.try_emplace({lengths.x, lengths.y}, scene_.materials.size());
        if (is_new) {
            if (sizes.size() > 1) {
                material.name += " " + std::to_string(sizes.size());
            }
            scene_.materials.push_back(std::move(material));
            scene_.textures.push_back(std::move(textures));
        }
        return known->second;
    }

    void add_object(const render::ObjectDescription& object) {
        const auto known = descriptions_.find(object.material);
        const render::MaterialDescription description =
            known != descriptions_.end() ? *known->second : render::MaterialDescription{};
        ExportPart part;
        part.name = object.name;
        Mat44 body_from_object = object.world_from_object;
        if (timeline_ == nullptr) {
            part.keys.add(0, Vec3(0, 0, 0), Quat());
            if (object.track.empty()) {
                body_from_object = split_pose(object.world_from_object).remainder;
            }
        } else if (object.track.empty()) {
            // The node has the position; rotation and scale are applied to the mesh.
            part.keys.add(scene_.start_time, object.world_from_object.translation(), Quat());
            body_from_object[3][0] = body_from_object[3][1] = body_from_object[3][2] = 0;
        } else if (const sim::Track* track = timeline_->find(object.track)) {
            part.keys = linear_keys(*track, kMostExportKeys);
        } else {
            throw Error("object '" + object.name + "' is not in the timeline");
        }
        const auto* sphere = std::get_if<render::SphereShape>(&object.shape);
        const render::BallTexture* paint = ball_paint(description);
        Mat44 object_from_mesh = body_from_object.inverse();
        const auto textures = [&] {
            return lay_textures(part, material_textures(description), object, object_from_mesh,
                                timeline_ != nullptr);
        };
        if (sphere != nullptr && paint != nullptr) {
            PaintedSphere ball = painted_sphere(*paint);
            for (Vec3& vertex : ball.mesh.vertices) {
                vertex *= sphere->radius;
            }
            add_mesh(part, ball.mesh, body_from_object);
            add_fields(part, ball.fields, plain_material(description), textures());
        } else {
            render::MeshShape mesh = shape_mesh(object.shape);
            if (timeline_ != nullptr) {
                const Vec3 moved =
                    centre_far_mesh(part, object.track.empty(), mesh, body_from_object);
                object_from_mesh = body_from_object.inverse() * translation(moved);
            }
            add_mesh(part, mesh, body_from_object);
            const std::size_t look = material(plain_material(description), textures());
            part.patches = {{0, part.mesh.triangles.size(), look}};
        }
        scene_.parts.push_back(std::move(part));
    }

    static Mat44 translation(const Vec3& by) {
        Mat44 map;
        map.setTranslation(by);
        return map;
    }

    /// Moves a mesh that is far from the body's origin there. Far: 100 times its size or 10 km,
    /// where floats are 1 mm apart. Returns what was subtracted from its vertices.
    static Vec3 centre_far_mesh(ExportPart& part, bool is_static, render::MeshShape& mesh,
                                Mat44& body_from_object) {
        Imath::Box3d box;
        for (const Vec3& vertex : mesh.vertices) {
            box.extendBy(vertex * body_from_object);
        }
        const Vec3 centre = box.isEmpty() ? Vec3(0, 0, 0) : box.center();
        const double size = box.isEmpty() ? 0 : box.size().length();
        if (centre.length() <= size || centre.length() <= std::min(100 * size, 10'000.0)) {
            return {0, 0, 0};
        }
        // Moving the vertices in double first keeps all their digits.
        const Vec3 in_object = centre * body_from_object.inverse();
        for (Vec3& vertex : mesh.vertices) {
            vertex -= in_object;
        }
        Vec3 origin;
        body_from_object.multVecMatrix(in_object, origin);
        body_from_object[3][0] = body_from_object[3][1] = body_from_object[3][2] = 0;
        if (is_static) {
            part.keys.positions.front() += origin;
        } else {
            part.origin = origin;
        }
        return in_object;
    }

    static void add_mesh(ExportPart& part, const render::MeshShape& shape, const Mat44& map) {
        part.mesh = render::make_mesh(shape, map, part.name);
        if (shape.smooth_angle > 0) {
            render::smooth_normals(part.mesh, shape.smooth_angle);
        }
        const bool has_gap = std::ranges::any_of(
            part.mesh.normals, [](const auto& normal) { return normal.length() < 0.5F; });
        if (has_gap) {
            part.mesh.normals.clear();  // readers then compute flat normals
        }
    }

    /// Gives the fields of one colour each, into which a ball's surface is divided, their
    /// materials.
    void add_fields(ExportPart& part, const std::vector<PaintedSphere::Field>& fields,
                    const ExportMaterial& plain, const MaterialTextures& textures) {
        std::size_t first = 0;
        for (const PaintedSphere::Field& field : fields) {
            ExportMaterial look = plain;
            look.name += (field.name.empty() ? "" : " ") + field.name;
            look.base = field.colour;
            MaterialTextures of_field = textures;
            if (textures.surface) {
                render::StandardMaterial surface = *textures.surface;
                surface.base = field.colour;
                of_field.surface = std::make_shared<const render::StandardMaterial>(surface);
            }
            part.patches.push_back(
                {first, field.triangles, material(std::move(look), std::move(of_field))});
            first += field.triangles;
        }
    }

    void add_lamp(const render::LightDescription& light) {
        ExportPart part;
        part.name = light.name;
        ExportMaterial glow;
        glow.name = "light " + light.name;
        glow.base = Vec3(0, 0, 0);
        if (const auto* rectangle = std::get_if<render::RectangleLight>(&light.light)) {
            const Vec3 u = rectangle->edge_u;
            const bool is_right_handed = u.cross(rectangle->edge_v).dot(rectangle->normal) > 0;
            const Vec3 v = is_right_handed ? rectangle->edge_v : -rectangle->edge_v;
            add_mesh(part, shape_mesh(render::ParallelogramShape{-u - v, 2.0 * u, 2.0 * v}), {});
            part.keys.add(scene_.start_time, place_of(rectangle->centre), Quat());
            glow.emission = rectangle->radiance;
        } else if (const auto* sphere = std::get_if<render::SphereLight>(&light.light)) {
            add_mesh(part, shape_mesh(render::SphereShape{sphere->radius}), {});
            part.keys.add(scene_.start_time, place_of(sphere->centre), Quat());
            glow.emission = sphere->radiance;
        } else if (const auto* disk = std::get_if<render::DiskLight>(&light.light)) {
            add_disk(part, disk->centre, disk->normal, disk->radius);
            glow.emission = disk->radiance;
        } else if (const auto* shade = std::get_if<render::ShadeLight>(&light.light)) {
            add_disk(part, shade->centre, shade->normal, shade->shape.radius);
            glow.emission = render::mean_radiance(*shade);
        } else {
            return;
        }
        part.mesh.uv.clear();
        part.patches = {{0, part.mesh.triangles.size(), material(std::move(glow))}};
        scene_.lamps.push_back(std::move(part));
    }

    void add_disk(ExportPart& part, const Vec3& centre, const Vec3& normal, double radius) {
        Quat turn;
        turn.setRotation(Vec3(0, 0, 1), normal);
        add_mesh(part, shape_mesh(render::DiskShape{radius}), turn.toMatrix44());
        part.keys.add(scene_.start_time, place_of(centre), Quat());
    }

    [[nodiscard]] Vec3 place_of(const Vec3& centre) const {
        return timeline_ == nullptr ? Vec3(0, 0, 0) : centre;
    }

    /// Adds a camera with one key per frame and one for its last instant.
    void add_camera(const CameraRig& rig) {
        ExportCamera camera;
        camera.name = rig.name;
        camera.sensor_height = rig.sensor_height;
        const double start = rig.video_start.to_double();
        const double length = rig.video_end.to_double() - start;
        const double frames = std::max(1.0, std::ceil(length * scene_.fps - 1e-9));
        if (frames > static_cast<double>(kMostExportKeys)) {
            throw Error("camera '" + rig.name + "' has too many frames for an export (more than " +
                        std::to_string(kMostExportKeys) + ")");
        }
        const auto count = static_cast<std::int64_t>(frames);
        for (std::int64_t i = 0; i <= count; ++i) {
            const double elapsed = std::min(length, static_cast<double>(i) / scene_.fps);
            const WideRational time(Rational::nearest(start + elapsed));
            ExportCameraKey key;
            key.video_time = start + elapsed;
            key.scene_time = scene_time_at(rig, time).to_double();
            try {
                key.state = camera_state(rig, {progress_at(rig, time), key.scene_time}, *timeline_);
            } catch (const Error& error) {
                throw Error("camera '" + rig.name + "': " + error.what());
            }
            camera.keys.push_back(key);
        }
        scene_.cameras.push_back(std::move(camera));
    }

    const Shot& shot_;
    const sim::Timeline* timeline_;
    ExportScene scene_;
    std::map<std::string, const render::MaterialDescription*> descriptions_;
    std::map<std::string, std::map<std::pair<double, double>, std::size_t>> materials_;
};

}  // namespace

std::vector<ExportCameraKey> ExportCamera::by_scene_time() const {
    std::vector<ExportCameraKey> result = keys;
    std::ranges::stable_sort(result, {}, &ExportCameraKey::scene_time);
    const auto is_same = [](const ExportCameraKey& a, const ExportCameraKey& b) {
        return a.scene_time == b.scene_time;
    };
    result.erase(std::unique(result.begin(), result.end(), is_same), result.end());
    return result;
}

Quat CameraAxes::orientation() const {
    const Imath::M33d rows(right.x, right.y, right.z, up.x, up.y, up.z, back.x, back.y, back.z);
    return Imath::extractQuat(Mat44(rows, Vec3(0, 0, 0))).normalized();
}

CameraAxes camera_axes(const render::CameraState& state) {
    const Vec3 forward = (state.target - state.position).normalized();
    const Vec3 level = forward.cross(state.up).normalized();
    const Vec3 upright = level.cross(forward);
    const double c = std::cos(state.roll);
    const double s = std::sin(state.roll);
    return {c * level + s * upright, c * upright - s * level, -forward};
}

std::string exported_path(const std::string& path, const std::string& folder) {
    std::error_code ignored;
    const std::filesystem::path from = std::filesystem::weakly_canonical(
        std::filesystem::absolute(folder.empty() ? "." : folder, ignored), ignored);
    const std::filesystem::path to = std::filesystem::weakly_canonical(path, ignored);
    return to.lexically_proximate(from).generic_string();
}

ExportScene export_scene(const Shot& shot, const sim::Timeline& timeline) {
    return SceneBuilder(shot, &timeline).run();
}

ExportScene export_meshes(const Shot& shot) {
    return SceneBuilder(shot, nullptr).run();
}

}  // namespace carom::pipeline
