#include "render/integrator/wave/make_wave_scene.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "render/light/far_light.h"

namespace carom::render {
namespace {

/// How many directions a path's first vertex samples towards what has a tree: whole blocks of
/// random numbers.
constexpr int kSamplesOfTree = 4;

/// Sets what kernels need of a light of each kind.
struct KnownLight {
    const LightSet& lights;
    WaveLight& known;

    /// A path's first vertex samples four directions, a block of random numbers, towards a
    /// rectangle: their penumbrae would cause most of the noise, and four shadow rays traced
    /// together cost little more than one. With many area lights each gets one, because together
    /// they are smooth enough.
    void operator()(const AreaLightConstants& light) const {
        constexpr std::size_t kFewLights = 4;
        known.kind = WaveLight::Kind::area;
        known.area = light;
        known.is_round = light.is_round;
        known.samples = lights.area_light_count() <= kFewLights && !light.is_round ? 4 : 1;
    }
    void operator()(const SampledEnvironment& /*light*/) const {
        const bool has_light = lights.directions().picture().distribution.density.exists();
        known.kind = has_light ? WaveLight::Kind::environment : WaveLight::Kind::dark_environment;
    }
    void operator()(const DeltaLight& light) const {
        known.kind = WaveLight::Kind::delta;
        known.delta = light.constants();
    }
    void operator()(const EmissiveObject& object) const {
        known.is_round = object.is_round();
        if (object.motion() != nullptr) {
            known.motion = object.motion()->pieces();
        }
        if (const EmissiveShape* shape = object.curved()) {
            known.kind = WaveLight::Kind::curved_object;
            known.shape = shape->constants();
            return;
        }
        known.kind = WaveLight::Kind::flat_object;
        known.surface = object.flat()->constants();
        known.samples = known.surface.tree.exists() ? kSamplesOfTree : 1;
    }
};

/// Puts lights into the scene's tree: all lamps that can be, if they are more than a few or far,
/// and all emissive objects, likewise.
LightTree make_tree(const LightSet& lights, const FarLight* far, std::vector<WaveLight>& made) {
    constexpr std::size_t kFewLights = 8;
    std::vector<LightBounds> in_tree(made.size());
    const auto put = [&](std::size_t first, std::size_t last) {
        std::vector<std::size_t> numbers;
        for (std::size_t light = first; light < last; ++light) {
            const auto bounds = bounds_of(lights.lights()[light]);
            made[light].is_in_panorama = bounds && far != nullptr &&
                                         made[light].kind != WaveLight::Kind::delta &&
                                         far->grid().is_far(bounds->box.center());
            if (bounds && !made[light].is_in_panorama) {
                numbers.push_back(light);
                in_tree[light] = *bounds;
            }
        }
        for (const std::size_t light : numbers) {
            made[light].is_in_tree = numbers.size() > kFewLights && in_tree[light].strength > 0;
            in_tree[light].strength = made[light].is_in_tree ? in_tree[light].strength : 0;
        }
    };
    put(0, lights.first_emissive());
    put(lights.first_emissive(), made.size());
    return LightTree(in_tree);
}

WaveMaterials make_materials(const std::vector<Material>& all, SceneArena& arena) {
    WaveMaterials materials;
    NumberTable layers, glass, phong;
    std::vector<float> is_phong, slices;
    std::vector<std::int32_t> first_albedo;
    std::int32_t nodes = 0;  // of tables of a kind
    const auto has = [&](bool (Material::*trait)() const) {
        return std::any_of(all.begin(), all.end(),
                           [&](const Material& material) { return (material.*trait)(); });
    };
    for (const Material& material : all) {
        const auto& numbers = material.numbers();
        layers.add(numbers);
        glass.add(numbers.glass);
        phong.add(numbers.phong);
        is_phong.push_back(material.is_phong() ? 1.0F : 0.0F);
        slices.push_back(static_cast<float>(material.table_slices()));
        first_albedo.push_back(nodes);
        nodes += material.table_slices() * kAlbedoNodes;
    }
    std::vector<float> albedos;
    for (std::size_t kind = 0; kind < kAlbedoKinds; ++kind) {
        for (const Material& material : all) {
            const float* const table = *AlbedoNumbers::each(material.numbers().tables)[kind];
            albedos.insert(albedos.end(), table, table + material.table_slices() * kAlbedoNodes);
        }
    }
    materials.transmits = has(&Material::is_transmissive);
    materials.layers = layers.rows(arena);
    materials.glass = has(&Material::is_glass) ? glass.rows(arena) : NumberRows{};
    materials.phong = has(&Material::is_phong) ? phong.rows(arena) : NumberRows{};
    materials.is_phong = arena.add(is_phong);
    materials.albedos = {arena.add(albedos), nodes};
    materials.first_albedo = arena.add(first_albedo);
    materials.slices = arena.add(slices);
    materials.varies = has(&Material::varies);
    return materials;
}

WaveScene& make_in(const TransportScene& scene, const WaveSetUp& set_up, SceneArena& arena) {
    WaveScene& known = arena.make<WaveScene>();
    std::vector<WaveLight> lights;
    for (const Light& light : scene.lights.lights()) {
        WaveLight& made = lights.emplace_back();
        made.number = static_cast<int>(lights.size()) - 1;
        std::visit(KnownLight{scene.lights, made}, light);
        known.has_environment = known.has_environment || made.is_environment();
    }
    const LightTree tree = make_tree(scene.lights, scene.far, lights);
    known.light_tree = tree.data();
    known.light_tree.each_list(
        [&](auto&... list) { ((list = arena.add(std::vector(list.begin(), list.end()))), ...); });
    known.all_lights = arena.add(lights);
    known.lights = known.all_lights;
    const Environment& environment = scene.lights.directions();
    if (scene.far != nullptr) {
        known.has_far = true;
        known.sky_distance = kFarDistance;
        known.near_low = scene.far->grid().near().min;
        known.near_high = scene.far->grid().near().max;
    }
    known.environment_importance = environment.importance();
    if (environment.is_sampled() && environment.picture().distribution.density.exists()) {
        known.has_sky = true;
        known.sky = environment.picture();
        arena.take(known.sky);
    }
    add_objects(scene, known, arena);
    known.materials = make_materials(scene.materials, arena);
    std::vector<TextureData> textures;
    std::vector<MaterialTextures> textures_of;
    for (const Material& material : scene.materials) {
        const std::vector<TextureData>& list = material.textures().list();
        textures_of.push_back(material.textures().numbers());
        textures_of.back().first = static_cast<std::int32_t>(textures.size());
        textures.insert(textures.end(), list.begin(), list.end());
    }
    known.textures = arena.add(textures);
    known.textures_of = arena.add(textures_of);
    set_up(known, arena);
    return known;
}

}  // namespace

void* SceneArena::room(std::size_t bytes) {
    const std::size_t size = rounded(bytes);
    size_of_all_ += size;
    if (blocks_.empty() || used_ + size > blocks_.back().size()) {
        CAROM_ASSERT(!is_whole_);
        blocks_.emplace_back(std::max(size, kBlock));
        used_ = 0;
    }
    used_ += size;
    return blocks_.back().data() + (used_ - size);
}

NumberRows NumberTable::rows(SceneArena& arena) const {
    const std::size_t row = count_ > 0 ? numbers_.size() / count_ : 0;
    std::vector<float> sorted;
    for (std::size_t number = 0; number < row; ++number) {
        for (std::size_t thing = 0; thing < count_; ++thing) {
            sorted.push_back(numbers_[thing * row + number]);
        }
    }
    return {arena.add(sorted), static_cast<std::int32_t>(count_)};
}

const WaveScene& make_wave_scene(const TransportScene& scene, const WaveSetUp& set_up,
                                 SceneArena& arena) {
    const WaveScene& made = make_in(scene, set_up, arena);
#ifdef CAROM_VALIDATION
    constexpr std::size_t kMostToMove = std::size_t{64} << 20;
    if (arena.size_of_all() <= kMostToMove) {
        arena = SceneArena(arena.size_of_all());
        make_in(scene, set_up, arena);
        return arena.moved<WaveScene>();
    }
#endif
    return made;
}

void set_up(const PathSettings& settings, const Caustics& caustics, WaveScene& wave_scene,
            SceneArena& arena) {
    std::vector<WaveLight> lights;
    std::copy_if(wave_scene.all_lights.begin(), wave_scene.all_lights.end(),
                 std::back_inserter(lights),
                 [](const WaveLight& light) { return !light.is_in_tree && !light.is_in_panorama; });
    if (wave_scene.light_tree.exists()) {
        WaveLight& many = lights.emplace_back();
        many.kind = WaveLight::Kind::many;
        many.samples = kSamplesOfTree;
    }
    wave_scene.lights = arena.add(lights);
    if (settings.strategy == DirectStrategy::scattering_only) {
        wave_scene.lights = {};
        wave_scene.has_environment = false;
    }
    wave_scene.spheres = arena.add(caustics.sphere_bounds());
    std::vector<std::int32_t> sphere_of_object = caustics.sphere_of_object();
    sphere_of_object.resize(static_cast<std::size_t>(wave_scene.group_of_object.size()), -1);
    wave_scene.sphere_of_object = arena.add(sphere_of_object);
    wave_scene.strategy = settings.strategy;
    wave_scene.max_bounces = settings.max_bounces;
    const bool has_gloss = std::any_of(wave_scene.traits.begin(), wave_scene.traits.end(),
                                       [](std::uint8_t trait) { return (trait & kHasGloss) != 0; });
    wave_scene.glossy_samples = has_gloss ? settings.glossy_samples : 1;
    wave_scene.split_vertices = settings.split_vertices;
    wave_scene.caustics = settings.caustics;
}

}  // namespace carom::render
