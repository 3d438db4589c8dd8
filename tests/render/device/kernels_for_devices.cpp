// The kernels of the renderer as code for devices: CUDA and OpenCL C++. Nothing is run; what counts
// is that it compiles, and that its arithmetic is not contracted or approximated
// (device_kernels_test.cpp).

#ifdef __CUDA__
#pragma clang force_cuda_host_device begin
#define CAROM_KERNEL inline __attribute__((always_inline))
#define CAROM_KERNEL_OUTLINED inline __attribute__((noinline))
#define CAROM_ENTRY extern "C" __attribute__((global)) void
#define CAROM_GLOBAL
#else
#define CAROM_KERNEL inline __attribute__((always_inline))
#define CAROM_KERNEL_OUTLINED inline __attribute__((noinline))
#define CAROM_ENTRY __kernel void
#define CAROM_GLOBAL __global
#endif
#define CAROM_KERNEL_ATTRIBUTE

#include "core/colour.h"
#include "core/elementary_float.h"
#include "render/acceleration/culling_data.h"
#include "render/camera/camera_constants.h"
#include "render/denoise/kernel_rows.h"
#include "render/geometry/affine.h"
#include "render/geometry/constants.h"
#include "render/geometry/margins.h"
#include "render/geometry/mesh_arrays.h"
#include "render/geometry/motion_pieces.h"
#include "render/geometry/shape_kind.h"
#include "render/integrator/path_constants.h"
#include "render/integrator/wave/wave_step.h"
#include "render/lanes/scalar_lanes.h"
#include "render/light/light_constants.h"
#include "render/material/albedo_numbers.h"
#include "render/material/lobe_constants.h"
#include "render/sampling/distribution_tables.h"
#include "render/sampling/one_minus_epsilon.h"
#include "render/sampling/pixel_filter_tables.h"
#include "render/sampling/sobol_tables.h"
#include "render/texture/texture_data.h"
#include "render/triangle/division.h"

namespace carom::render::device {

// The order matters.
// clang-format off
#include "render/lanes/kernels/all.h"
#include "render/geometry/kernels/all.h"
#include "render/sampling/kernels/all.h"
#include "render/texture/kernels/all.h"
#include "render/material/kernels/all.h"
#include "render/light/kernels/all.h"
#include "render/camera/kernels/thin_lens.h"
#include "render/integrator/kernels/all.h"
#include "render/integrator/wave/kernels/all.h"
#include "render/acceleration/kernels/all.h"
#include "render/denoise/kernels/all.h"
// clang-format on

namespace triangles {

using triangle::Division;
// The order matters.
// clang-format off
#include "render/triangle/kernels/common.h"
#include "render/triangle/kernels/moller_trumbore.h"
#include "render/triangle/kernels/watertight.h"
// clang-format on

}  // namespace triangles

/// What a device reads of a scene.
struct Scene {
    CameraConstants camera;
    List<TextureData> textures;
    MaterialTextures of_material;
    AreaLightConstants area;
    DeltaLightConstants delta;
    EmissiveShapeConstants shape;
    EmissiveSurfaceConstants surface;
    EnvironmentPicture sky;
    MeshArrays mesh;
    MotionPieces motion;
    HorizonTables horizon;
    LeafSlab slab;
    const float* materials;
    AlbedoNumbers albedos;
};

/// What a device reads and writes of a picture that is denoised.
struct Picture {
    SquareRow square;
    BoxRow box;
    VarianceRow variance;
    NoiseRow noise;
    DistanceRow distances;
    WeightRow weights;
    RegressionChunk regression;
    ErrorRow errors;
    LimitRow limit;
};

/// Adds numbers up, so that none is left out by the compiler.
struct Sum {
    float* to;

    CAROM_KERNEL void add(float x) const { *to = *to + x; }
    CAROM_KERNEL void add(const Vec2<float>& v) const {
        add(v.x);
        add(v.y);
    }
    CAROM_KERNEL void add(const Vec3<float>& v) const {
        add(v.x);
        add(v.y);
        add(v.z);
    }
};

using L = ScalarLanes<float>;

CAROM_KERNEL void sample_camera(const Scene& scene, const SamplerOf<L>& sampler, const Sum& sum) {
    float u[5];
    sampler.get_camera_sample(u);
    const CameraRayOf<L> ray =
        camera_ray<L>(scene.camera, {u[0], u[1]}, {{u[2], u[3]}, {u[4], u[0]}, u[1]});
    sum.add(ray.origin);
    sum.add(ray.direction);
    sum.add(ray.time);
    float x[4], y[4];
    sampler.get_2d_block(3, x, y);
    sum.add(x[1] + y[2]);
    sum.add(sampler.get_1d(5));
    sum.add(sample_gaussian_lobe<L>({u[0], u[1]}, u[2], u[3]));
}

template <ShapeKind kKind>
CAROM_KERNEL void hit(const RayOf<L>& ray, const Vec3<float>& profile, const Sum& sum) {
    const auto found = hit_unit_shape<kKind, L>(ray, 0, {profile, 0});
    sum.add(found.valid ? found.t : 0);
    const auto point = on_unit_shape<L>(kKind, {ray, found.t, profile, profile, true});
    sum.add(point.position);
    sum.add(point.normal);
    sum.add(point.uv);
}

CAROM_KERNEL void hit_shapes(const Scene& scene, const RayOf<L>& ray, const Vec3<float>& profile,
                             const Sum& sum) {
    hit<ShapeKind::sphere>(ray, profile, sum);
    hit<ShapeKind::box>(ray, profile, sum);
    hit<ShapeKind::rectangle>(ray, profile, sum);
    hit<ShapeKind::triangle>(ray, profile, sum);
    hit<ShapeKind::disk>(ray, profile, sum);
    hit<ShapeKind::frustum>(ray, profile, sum);
    hit<ShapeKind::capsule>(ray, profile, sum);
    hit<ShapeKind::rounded_box>(ray, profile, sum);
    hit<ShapeKind::plane>(ray, profile, sum);
    const auto moving = pose_at<L>(scene.motion, profile.x).in_body(ray);
    sum.add(moving.origin);
    sum.add(moving.direction);
    const auto on_mesh =
        point_on_mesh<L>(scene.mesh, MeshHitOf<L>{7, profile.x, profile.y}, nullptr, true);
    sum.add(on_mesh.position);
    sum.add(on_mesh.shading_normal);
    sum.add(on_mesh.uv);
    const auto on_sphere = point_on_sphere<L>(ray, profile.x, profile, profile.y);
    sum.add(on_sphere.position);
    const auto on_box = point_on_upright_box<L>(ray, profile.x, profile, profile, {true, true});
    sum.add(on_box.uv);
    const auto triangle =
        triangles::MollerTrumbore::prepare<L>({ray.origin, ray.direction, profile});
    const auto on_triangle = triangles::sure_hit<L>(
        triangles::RayIn<L>{ray.direction, profile, 0, profile.x}, triangle,
        triangles::doubt<L>(triangles::sum_of_sizes<L>(profile), profile.x, profile.y));
    sum.add(on_triangle.hit.valid ? on_triangle.hit.t + on_triangle.hit.u : 0);
}

CAROM_KERNEL void light(const Scene& scene, const Vec3<float>& point, const Vec3<float>& normal,
                        const Vec2<float>& u, const Sum& sum) {
    const SeenTreeOf<L> seen = see_tree<L>(scene.surface.tree, point, normal);
    const LightSampleOf<L> samples[] = {
        sample_area_light<L>(scene.area, point, u), sample_delta_light<L>(scene.delta, point),
        sample_shape<L>(scene.shape, point, u), sample_surface<L>(scene.surface, seen, point, u)};
    for (const LightSampleOf<L>& sample : samples) {
        if (sample.valid) {
            sum.add(sample.direction);
            sum.add(sample.radiance);
            sum.add(sample.distance * sample.pdf);
        }
    }
    sum.add(importance_of_area_light<L>(scene.area, point, normal));
    sum.add(pdf_of_area_light<L>(scene.area, point, normal, u.x));
    sum.add(emitted_by_area_light<L>(scene.area, point, normal));
    sum.add(distance_to_area_light<L>(scene.area, point, normal, u.x));
    if (can_sample_point_of_area_light<L>(scene.area, u.x, u.y)) {
        const LightPointOf<L> on_light = sample_point_of_area_light<L>(scene.area, point, u.y, u);
        sum.add(on_light.position);
        sum.add(on_light.normal);
        sum.add(on_light.pdf);
    }
    sum.add(importance_of_delta_light<L>(scene.delta, point, normal));
    sum.add(importance_of_shape<L>(scene.shape, point, normal));
    sum.add(pdf_of_surface<L>(scene.surface, point, normal, 7, u.x, u.y));
    sum.add(pdf_of_shape<L>(scene.shape, point, normal, u.x, normal));
    const EnvironmentSampleOf<L> sky = sample_environment_map<L>(scene.sky, u);
    sum.add(environment_radiance<L>(scene.sky, sky.uv));
    sum.add(
        environment_pdf<L>(scene.sky, sky.direction, environment_uv<L>(scene.sky, sky.direction)));
}

CAROM_KERNEL void scatter(const Scene& scene, const Vec3<float>& normal, const Vec3<float>& viewer,
                          const Vec2<float>& u, const Sum& sum) {
    SurfacePointOf<L> hit;
    hit.object_position = viewer;
    hit.geometric_normal = normal;
    hit.uv = hit.uv_metres = u;
    hit.u_gradient = hit.v_gradient = normal;
    hit.x_axis = hit.y_axis = hit.z_axis = viewer;
    const TexturePointOf<L> point =
        texture_point<L>(hit, scene.of_material.needs, viewer, u.y, 0.1f);
    const ResolvedOf<L> surface =
        resolve_surface<L>(scene.textures, scene.of_material, point, normal, normal, viewer);
    BsdfOf<L> bsdf;
    const float* number = scene.materials;
    const auto read = [&](float& x) { x = *number++; };
    LayersOf<L>::each_number(bsdf.layers, read);
    GlassOf<L>::each_number(bsdf.layers.glass, read);
    PhongOf<L>::each_number(bsdf.layers.phong, read);
    bsdf.layers.any_glass = *number++ > 0;
    bsdf.layers.any_phong = *number++ > 0;
    bsdf.layers.is_phong = *number++ > 0;
    bsdf.layers.tables = scene.albedos;
    bsdf.layers.first = 0;
    complete<L>(bsdf, surface.base, surface.geometric_normal, surface.normal, viewer,
                surface.from_behind);
    const DirectionOf<L> directions[] = {sample_coat<L>(bsdf, false, true, u),
                                         sample_base<L>(bsdf, false, u)};
    for (const DirectionOf<L>& to : directions) {
        sum.add(to.world);
        sum.add(to.weight);
        sum.add(to.pdf);
        sum.add(of_all_lobes<L>(bsdf, base_towards<L>(bsdf, to.wi, to.passes),
                                coat_towards<L>(bsdf, to.wi, to.passes))
                    .value);
    }
}

CAROM_KERNEL void follow(const Scene& scene, const RayOf<L>& ray, const Vec2<float>& u,
                         const Sum& sum) {
    const BoxLines<L> lines = box_lines<L>({ray.origin.x, ray.origin.y, ray.origin.z},
                                           {ray.direction.x, ray.direction.y, ray.direction.z});
    const PassageOf<L> way = passage<L>({{u.x, 1}, {u.y, 2}, {u.x, 3}}, lines);
    sum.add(way.enter + way.leave);
    sum.add(is_better<L>({u.x, is_finite<L>(ray, u.y)}, u.y, u.x > 0) ? u.x : u.y);
    sum.add(pass_above<L>(scene.horizon, ray.origin, ray.direction) ? u.x : u.y);
    sum.add(stay_beyond<L>(scene.slab, ray.origin, ray.direction, u.x) ? u.x : u.y);
    sum.add(lattice_point<L>(u, 2, 5));
    sum.add(power_heuristic<L>(u.x, u.y) * survival_of<L>(ray.origin));
    sum.add(solid_angle_fraction<L>(ray.origin, ray.direction, u.x, u.y, 2));
    sum.add(splitting_at<L>(0, 2, 3, u.x > u.y, u.x < u.y).any_gloss ? u.x : u.y);
}

/// A wave in a device's memory. Every thread has one vertex, whose continuing paths have places of
/// their own; what is taken is moved together afterwards.
struct Wave {
    WaveScene scene;
    CameraSamples samples;
    PathQueue paths;
    SurfaceQueue vertices;
    ShadowQueue shadows;
    EscapedQueue missed;
    LobeWave reflection, refraction;
    Floats3 own;
    const Hit* hits;
    NextPathOf<L>* coats;
    NextPathOf<L>* bases;
    NextRayOf<L>* sent;
    int* taken;              // by place, those of coats first
    int* asks_for_caustics;  // by vertex
    int* survives;           // by path
};

/// A place for a path.
template <class PathOf>
struct Place {
    PathOf* path;
    int* taken;

    CAROM_KERNEL void operator()(const PathOf& continuing, bool goes) const {
        *path = continuing;
        *taken = goes ? 1 : 0;
    }
};

/// The places of a vertex.
struct Places {
    NextPathOf<L>* paths;
    int* taken;
    int stride;

    [[nodiscard]] CAROM_KERNEL Place<NextPathOf<L>> at(int k) const {
        return {paths + k * stride, taken + k * stride};
    }
};
struct PlacesOfVertex {
    Places coat, base;
    int* asks;

    CAROM_KERNEL void near_sphere(bool needed) const { *asks = needed ? 1 : 0; }
};

CAROM_KERNEL void step_of_path(const Wave& wave, int i) {
    wave.survives[i] = survivors_of<L>(wave.samples, wave.paths, i) ? 1 : 0;
    const int count = wave.vertices.count;
    for (const WaveGroup& group : wave.scene.groups) {
        resolve_surfaces<L>({wave.scene, group, wave.paths, wave.hits, wave.vertices, count}, i);
    }
    const WaveStep step{wave.scene, wave.samples, wave.paths, wave.vertices, wave.shadows};
    int* const of_bases = wave.taken + count * wave.scene.glossy_samples;
    shade_surfaces<L>(step, i,
                      PlacesOfVertex{{wave.coats + i, wave.taken + i, count},
                                     {wave.bases + i, of_bases + i, count},
                                     wave.asks_for_caustics + i});
    trace_coats<L>(step, i, Place<NextPathOf<L>>{wave.coats + i, wave.taken + i});
    sum_light<L>(wave.shadows, i);
    shade_background<L>(wave.scene, wave.paths, wave.missed, i);
    for (const WaveLight& light : wave.scene.all_lights) {
        const LightHitOf<L> hit{{0, 0, 2}, {0, 0, -1}, 1, {0, 0, 1}, 7};
        wave.missed.light.x.at[i] = radiance_of_light<L>(wave.scene, light, wave.paths, i, hit).x;
    }
}

CAROM_KERNEL void step_of_ray(const Wave& wave, int i) {
    const DistributedStep step{wave.scene,     1,          {},
                               wave.samples,   wave.paths, wave.vertices,
                               wave.shadows,   wave.own,   wave.reflection,
                               wave.refraction};
    shade_rays<L>(step, i);
    wave.survives[i] = find_lobes<L>(step, i).reflection;
    send_rays<L>(step, wave.reflection, 0, i, Place<NextRayOf<L>>{wave.sent + i, wave.taken + i});
}

CAROM_ENTRY wave_step(CAROM_GLOBAL const Wave* waves, int i) {
    step_of_path(*waves, i);
    step_of_ray(*waves, i);
}

CAROM_ENTRY denoise(CAROM_GLOBAL const Picture* pictures, int x, CAROM_GLOBAL float* results) {
    const Picture& picture = *pictures;
    square<L>(picture.square, x);
    sum_columns<L>(picture.box, x);
    mean_of_sums<L>(picture.box, x);
    join_variance<L>(picture.variance, x);
    judge_noise<L>(picture.noise, x);
    measure_distances<L>(picture.distances, x);
    weigh<L>(picture.weights, x);
    regress<L, 0>(picture.regression, x);
    regress<L, 3>(picture.regression, x);
    regress<L, 6>(picture.regression, x);
    regress<L, 9>(picture.regression, x);
    estimate_errors<L>(picture.errors, x);
    limit<L>(picture.limit, x);
    *results = repeats_first<L>(picture.square.values, x) ? 1 : 0;
}

CAROM_ENTRY kernels(CAROM_GLOBAL const Scene* scenes, CAROM_GLOBAL const unsigned* numbers,
                    CAROM_GLOBAL float* results) {
    const Scene& scene = *scenes;
    const Sum sum{results};
    const SamplerOf<L> sampler(numbers[0], numbers[1]);
    float u[4];
    sampler.get_4d(numbers[2], u);
    const Vec3<float> point{u[0], u[1], u[2]};
    const Vec3<float> normal = sample_cosine_hemisphere<L>({u[2], u[3]});
    sample_camera(scene, sampler, sum);
    hit_shapes(scene, {point, normal}, {u[3], u[1], u[0]}, sum);
    light(scene, point, normal, {u[1], u[3]}, sum);
    scatter(scene, normal, unit<L>(point), {u[1], u[3]}, sum);
    follow(scene, {point, normal}, {u[0], u[3]}, sum);
}

}  // namespace carom::render::device

#ifdef __CUDA__
#pragma clang force_cuda_host_device end
#endif
