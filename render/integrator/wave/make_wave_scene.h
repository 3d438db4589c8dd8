// Makes the scene for the kernels of a wave.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "core/assert.h"
#include "render/acceleration/large_vector.h"
#include "render/integrator/caustics.h"
#include "render/integrator/transport_scene.h"
#include "render/integrator/wave/wave_scene.h"

namespace carom::render {

/// The memory of a frame's scene. Everything in it leads only to what else is in it, by distances:
/// a device may have a copy of the block. For processors the large arrays of meshes, textures and
/// pictures, which stay the same from frame to frame, are left where they are.
class SceneArena {
  public:
    SceneArena() = default;
    /// In which those are copied, too. `size`: of the block, at least `size_of_all` of an arena for
    /// processors.
    explicit SceneArena(std::size_t size) : is_whole_(true) { blocks_.emplace_back(size); }

    template <class T>
    [[nodiscard]] T& make() {
        return *new (room(sizeof(T))) T();
    }
    /// A copy of the list, and of what its entries lead to.
    template <class T>
    [[nodiscard]] List<T> add(const std::vector<T>& list) {
        T* const copy = static_cast<T*>(room(list.size() * sizeof(T)));
        std::uninitialized_copy(list.begin(), list.end(), copy);
        if constexpr (requires(T entry) { entry.each_list([](auto&...) {}); }) {
            std::for_each(copy, copy + list.size(), [&](T& entry) { take(entry); });
        }
        return {copy, static_cast<std::int64_t>(list.size())};
    }
    /// Copies what lists lead to, if it has to be.
    template <class Lists>
    void take(Lists& lists) {
        lists.each_list([&](auto&... list) { (take_list(list), ...); });
    }

    [[nodiscard]] std::size_t size_of_all() const { return size_of_all_; }
    /// Moves everything to other addresses. Returns where what was made first is.
    template <class T>
    [[nodiscard]] T& moved() {
        CAROM_ASSERT(is_whole_ && blocks_.size() == 1);
        LargeVector<std::byte> copy = blocks_.front();
        std::fill(blocks_.front().begin(), blocks_.front().end(), std::byte{0xff});
        blocks_.front() = std::move(copy);
        return *std::launder(reinterpret_cast<T*>(blocks_.front().data()));
    }

  private:
    static constexpr std::size_t kAlignment = 64;
    static constexpr std::size_t kBlock = std::size_t{1} << 16;
    /// Kernels read up to so many bytes beyond the last entry of a list.
    static constexpr std::size_t kReadBeyond = 16;

    [[nodiscard]] static std::size_t rounded(std::size_t bytes) {
        return (bytes + kReadBeyond + kAlignment - 1) / kAlignment * kAlignment;
    }
    template <class T>
    void take_list(List<T>& list) {
        const std::size_t bytes = static_cast<std::size_t>(list.size()) * sizeof(T);
        if (!is_whole_) {
            size_of_all_ += rounded(bytes);
        } else if (list.exists()) {
            T* const copy = static_cast<T*>(room(bytes));
            std::uninitialized_copy(list.begin(), list.end(), copy);
            list = List<T>(copy, list.size());
        }
    }
    void* room(std::size_t bytes);

    std::vector<LargeVector<std::byte>> blocks_;
    std::size_t used_ = 0;  // of the last block
    std::size_t size_of_all_ = 0;
    bool is_whole_ = false;
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

/// Adds to a scene what an integrator needs.
using WaveSetUp = std::function<void(WaveScene& scene, SceneArena& arena)>;

/// For one frame; the scene is in the arena. With expensive checks on it has been moved as a whole.
[[nodiscard]] const WaveScene& make_wave_scene(const TransportScene& scene, const WaveSetUp& set_up,
                                               SceneArena& arena);
/// What path tracing needs.
void set_up(const PathSettings& settings, const Caustics& caustics, WaveScene& wave_scene,
            SceneArena& arena);

/// Sets shapes, groups and traits, for all objects of a frame that have a material.
void add_objects(const TransportScene& scene, WaveScene& wave_scene, SceneArena& arena);

}  // namespace carom::render
