#include "render/frame_scene/frame_scene.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/assert.h"
#include "core/error.h"
#include "render/acceleration/hybrid_structure.h"
#include "render/acceleration/moving_shape.h"
#include "render/frame_scene/cut_outs.h"
#include "render/frame_scene/static_geometry_data.h"
#include "render/frame_scene/surface.h"

namespace carom::render {

struct FrameScene::Data {
    const StaticGeometry::Data* geometry = nullptr;
    std::vector<std::shared_ptr<const RigidMotion>> motions;  // by object; null for static ones
};

namespace {

using TracksByName = std::unordered_map<std::string_view, const sim::Track*>;

/// Of several tracks with the same name the first one counts.
TracksByName by_name(std::span<const sim::Track> tracks) {
    TracksByName result;
    result.reserve(tracks.size());
    for (const sim::Track& track : tracks) {
        result.try_emplace(track.name(), &track);
    }
    return result;
}

const sim::Track& find_track(const TracksByName& tracks, const SceneObject& object) {
    const auto found = tracks.find(object.track);
    if (found != tracks.end()) {
        return *found->second;
    }
    throw Error("object '" + object.name + "' follows the track '" + object.track +
                "', which the timeline does not have");
}

void add_spheres(ShapeSet& shapes, const RigidMotion& motion, float radius, std::uint32_t object) {
    const std::span<const PathPiece> path = motion.path();
    for (std::size_t i = 0; i < path.size(); ++i) {
        SphereSegment sphere;
        sphere.path = path[i];
        if (i > 0) {
            sphere.start = path[i].start;
        }
        if (i + 1 < path.size()) {
            sphere.end = path[i].end;
        }
        sphere.radius = radius;
        sphere.object = object;
        shapes.add_sphere(sphere);
    }
}

/// Flat shapes touch the sides of their boxes.
Imath::Box3f bounds_of(const SceneObject& object, const RigidMotion& motion) {
    if (object.kind == ShapeKind::plane) {
        return swept_bounds(motion, object.bounding_radius);
    }
    V3f half_size(1);
    visit_shape(object.kind, [&](auto shape) { half_size = shape.half_size(object.parameters); });
    return swept_bounds(motion, object.bounding_radius, object.frame.world_from_unit, half_size);
}

void add_moving(ShapeSet& shapes, const StaticGeometry::Data& geometry, std::uint32_t index,
                const std::shared_ptr<const RigidMotion>& motion) {
    const SceneObject& object = geometry.objects[index];
    if (object.is_round) {
        add_spheres(shapes, *motion, object.half_size.x, index);
        return;
    }
    if (motion->is_static()) {
        const UnitFrame frame =
            placed(object.frame, motion->position(0), motion->world_from_body(0));
        add_static_shape(shapes, object, index, frame);
        return;
    }
    MovingShape shape;
    shape.kind = object.kind;
    shape.unit_from_body = object.frame.unit_from_world;
    shape.parameters = object.parameters;
    shape.motion = motion;
    shape.bounds = bounds_of(object, *motion);
    shape.object = index;
    shapes.moving.push_back(std::move(shape));
}

using Motions = std::vector<std::shared_ptr<const RigidMotion>>;

ShapeSet with_movers(ShapeSet shapes, const StaticGeometry::Data& geometry,
                     const Motions& motions) {
    for (std::uint32_t i = 0; i < geometry.objects.size(); ++i) {
        if (motions[i] && geometry.objects[i].kind != ShapeKind::mesh) {
            add_moving(shapes, geometry, i, motions[i]);
        }
    }
    for (MeshInstance instance : geometry.tracked_instances) {
        instance.motion = motions[instance.object];
        instance.bounds =
            swept_bounds(*instance.motion, geometry.objects[instance.object].bounding_radius);
        shapes.instances.push_back(std::move(instance));
    }
    return shapes;
}

/// A tree over static shapes serves every frame if few other shapes exist; with many others, one
/// tree over all shapes is faster.
std::unique_ptr<AccelerationStructure> hybrid_structure(const StaticGeometry::Data& geometry,
                                                        const Motions& motions) {
    if (geometry.static_tree) {
        const ShapeSet others = with_movers(geometry.outside_tree, geometry, motions);
        if (loop_cost(others) < kTreeThreshold) {
            return std::make_unique<HybridStructure>(others, geometry.static_tree);
        }
    }
    return std::make_unique<HybridStructure>(
        with_movers(geometry.static_shapes, geometry, motions));
}

std::unique_ptr<AccelerationStructure> make_structure_of(const StaticGeometry::Data& geometry,
                                                         const Motions& motions) {
    return geometry.maker ? geometry.maker(with_movers(geometry.static_shapes, geometry, motions),
                                           geometry.static_meshes)
                          : hybrid_structure(geometry, motions);
}

}  // namespace

FrameScene::FrameScene(const StaticGeometry& geometry, std::span<const sim::Track> tracks,
                       double scene_open, double scene_close, const CutOuts* cut_outs,
                       const StaticGeometry* near)
    : data_(std::make_unique<Data>()) {
    CAROM_ASSERT(scene_open <= scene_close);
    const StaticGeometry::Data& shared = geometry.data();
    data_->geometry = &shared;
    data_->motions.resize(shared.objects.size());
    const TracksByName track_of = by_name(tracks);
    std::unordered_map<const sim::Track*, std::shared_ptr<const RigidMotion>> motion_of;
    for (std::uint32_t i = 0; i < shared.objects.size(); ++i) {
        const SceneObject& object = shared.objects[i];
        if (object.is_tracked()) {
            const sim::Track& track = find_track(track_of, object);
            std::shared_ptr<const RigidMotion>& motion = motion_of[&track];
            if (!motion) {
                motion = std::make_shared<const RigidMotion>(track, scene_open, scene_close);
            }
            data_->motions[i] = motion;
        }
    }
    structure_ = make_structure_of(shared, data_->motions);
    if (near != nullptr) {
        near_ = make_structure_of(near->data(), data_->motions);
    }
    if (cut_outs == nullptr) {
        return;
    }
    Imath::Box3f bounds;
    for (std::uint32_t i = 0; i < shared.objects.size(); ++i) {
        const SceneObject& object = shared.objects[i];
        if (object.material != kNoMaterial && cut_outs->is_cut_out(object.material)) {
            bounds.extendBy(this->bounds(i));
        }
    }
    if (!bounds.isEmpty()) {
        whole_ = std::move(structure_);
        structure_ = std::make_unique<CutOutStructure>(*this, *cut_outs, *whole_, bounds);
        if (near_) {
            near_whole_ = std::move(near_);
            near_ = std::make_unique<CutOutStructure>(*this, *cut_outs, *near_whole_, bounds);
        }
    }
}

FrameScene::~FrameScene() = default;

SurfacePoint FrameScene::surface_at(const Ray& ray, const Hit& hit) const {
    CAROM_ASSERT(hit.object < data_->motions.size());
    return surface_of(data_->geometry->objects[hit.object], data_->motions[hit.object].get(), ray,
                      hit);
}

Imath::Box3f FrameScene::bounds(std::uint32_t index) const {
    CAROM_ASSERT(index < data_->motions.size());
    const SceneObject& object = data_->geometry->objects[index];
    Imath::Box3f box;
    if (object.kind == ShapeKind::plane) {
        box.makeInfinite();
    } else if (const RigidMotion* motion = data_->motions[index].get()) {
        box = swept_bounds(*motion, object.bounding_radius);
    } else if (object.kind == ShapeKind::mesh) {
        for (const V3f& vertex : object.mesh->vertices) {
            box.extendBy(object.place_of_vertex(vertex));
        }
    } else {
        const V3f& centre = object.frame.world_from_unit.translation;
        box = {centre - V3f(object.bounding_radius), centre + V3f(object.bounding_radius)};
    }
    return box;
}

V3f FrameScene::moved(std::uint32_t object, const V3f& position, float from_time,
                      float to_time) const {
    CAROM_ASSERT(object < data_->motions.size());
    const RigidMotion* motion = data_->motions[object].get();
    if (motion == nullptr) {
        return position;
    }
    const V3f arm =
        rotate_back(motion->world_from_body(from_time), position - motion->position(from_time));
    return motion->position(to_time) + rotate(motion->world_from_body(to_time), arm);
}

std::vector<FrameScene::Sphere> FrameScene::spheres() const {
    std::vector<Sphere> result;
    for (std::uint32_t i = 0; i < data_->motions.size(); ++i) {
        const SceneObject& object = data_->geometry->objects[i];
        if (!object.is_round || object.light.has_value()) {
            continue;
        }
        const RigidMotion* motion = data_->motions[i].get();
        Imath::Box3f centres(object.frame.world_from_unit.translation);
        if (motion != nullptr) {
            centres = motion->position_bounds();
        }
        result.push_back({i, object.material, object.half_size.x, centres});
    }
    return result;
}

V3f FrameScene::centre(std::uint32_t object, float time) const {
    const RigidMotion* motion = data_->motions[object].get();
    return motion != nullptr ? motion->position(time)
                             : data_->geometry->objects[object].frame.world_from_unit.translation;
}

Imath::Quatf FrameScene::world_from_body(std::uint32_t object, float time) const {
    return data_->motions[object]->world_from_body(time);
}

const SceneObject& FrameScene::object(std::uint32_t object) const {
    return data_->geometry->objects[object];
}

std::span<const std::shared_ptr<const RigidMotion>> FrameScene::motions() const {
    return data_->motions;
}

bool FrameScene::moves(std::uint32_t object) const {
    return data_->motions[object] != nullptr;
}

std::uint32_t FrameScene::material(std::uint32_t object) const {
    return data_->geometry->objects[object].material;
}

std::size_t FrameScene::object_count() const {
    return data_->motions.size();
}

}  // namespace carom::render
