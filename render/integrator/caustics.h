// Light that a smooth ball mirrors onto its surroundings.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/integrator/direct_light.h"
#include "render/integrator/mirrored_light.h"
#include "render/integrator/path_state.h"
#include "render/integrator/transport_scene.h"

namespace carom::render {

/// A path that finds such light by chance makes a bright speck. At a path's first two vertices it
/// is sought on purpose instead: a ball, a light and a point of the light are chosen
/// (mirrored_light.h). What is so connected is left out where paths meet it.
class Caustics {
  public:
    explicit Caustics(const TransportScene& scene);

    /// Whether light is sought at this vertex: not for narrow lobes, which find it better
    /// themselves.
    [[nodiscard]] bool connects(const Path& path, const ShadingVertex& vertex) const;

    /// An estimate of it, scattered towards the path's previous vertex. `object`: that the vertex
    /// lies on.
    [[nodiscard]] V3f connected(const Path& path, const ShadingVertex& vertex, std::uint32_t object,
                                const PathDimensions& dimensions, RenderStatistics& count) const;

    /// Whether light that a path finds by way of a mirror on `object` from a vertex that connects
    /// was sought there.
    [[nodiscard]] bool covers(std::uint32_t object, std::size_t light) const {
        return object < index_.size() && index_[object] >= 0 &&
               pairs_[static_cast<std::size_t>(index_[object]) * light_count_ + light] > 0;
    }

    /// What balls are chosen by, an array for each number: for vectors.
    struct Places {
        std::vector<float> x, y, z;  // the middle of the places that the centre takes
        std::vector<float> reach;    // from there to the farthest point
        std::vector<float> radius2;
        std::vector<float> gain;  // how much more it mirrors than a coat of index 1.5, at least 1
    };
    [[nodiscard]] const Places& places() const { return places_; }
    /// By object: its index in `places`, or -1; objects beyond the end have none.
    [[nodiscard]] const std::vector<int>& place_of_object() const { return index_; }

  private:
    [[nodiscard]] float weight(std::size_t ball, const V3f& position, const V3f& normal) const;
    [[nodiscard]] float total_weight(const ShadingVertex& vertex, std::size_t own) const;
    [[nodiscard]] V3f through(std::size_t ball, const Path& path, const ShadingVertex& vertex,
                              const std::array<float, 4>& u, RenderStatistics& count) const;
    void add(const MirrorBall& ball);

    TransportScene scene_;
    std::size_t light_count_ = 0;
    std::vector<MirrorBall> balls_;
    std::vector<float> intensity_;  // by ball: sum over its lights
    Places places_;
    std::vector<int> index_;    // by object: into balls_, or -1
    std::vector<float> pairs_;  // ball by ball, each light's intensity there; 0: not connected
};

}  // namespace carom::render
