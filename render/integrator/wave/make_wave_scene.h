// Makes the scene for the kernels of a wave.
#pragma once

#include <cstddef>
#include <memory>
#include <memory_resource>
#include <utility>
#include <vector>

#include "render/integrator/caustics.h"
#include "render/integrator/transport_scene.h"
#include "render/integrator/wave/wave_scene.h"

namespace carom::render {

/// The memory of a scene's plain data, all of which it frees together.
class SceneArena {
  public:
    /// A copy of the list.
    template <class T>
    [[nodiscard]] T* add(const std::vector<T>& list) {
        return std::uninitialized_copy(list.begin(), list.end(), room_for<T>(list.size())) -
               list.size();
    }
    template <class T>
    [[nodiscard]] List<T> list(const std::vector<T>& from) {
        return {add(from), static_cast<std::int32_t>(from.size())};
    }

  private:
    template <class T>
    T* room_for(std::size_t count) {
        static_assert(std::is_trivially_destructible_v<T>);
        return static_cast<T*>(memory_->allocate(count * sizeof(T), 64));
    }

    std::unique_ptr<std::pmr::monotonic_buffer_resource> memory_ =
        std::make_unique<std::pmr::monotonic_buffer_resource>();
};

/// Numbers of many things, which become NumberRows.
class NumberTable {
  public:
    /// Appends the numbers of one thing, which has `each_number`.
    template <class Numbers>
    void add(const Numbers& numbers) {
        Numbers::each_number(numbers, [&](float number) { numbers_.push_back(number); });
        count_ += 1;
    }
    void add(const std::vector<float>& numbers) {
        numbers_.insert(numbers_.end(), numbers.begin(), numbers.end());
        count_ += 1;
    }
    [[nodiscard]] NumberRows rows(SceneArena& arena) const;

  private:
    std::vector<float> numbers_;  // of one thing after the other
    std::size_t count_ = 0;
};

/// For one frame. Meshes, textures and pictures are borrowed; the rest is in `arena`.
[[nodiscard]] WaveScene make_wave_scene(const TransportScene& scene, SceneArena& arena);
/// Adds what path tracing needs.
void set_up(WaveScene& wave_scene, const PathSettings& settings, const Caustics& caustics,
            SceneArena& arena);

/// Sets shapes, groups and traits, for all objects of a frame that have a material.
void add_objects(const TransportScene& scene, SceneArena& arena, WaveScene& wave_scene);

}  // namespace carom::render
