// A texture that is read out along a way.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sound/rolling/texture.h"
#include "sound/rolling/way.h"

namespace carom::sound {

/// The pressure at 1 m that moving along a way makes. Its root mean square is the way's pressure at
/// normal speed; at another playing speed the same texture is read out slower or faster, and only
/// the limits of audible frequencies change the level.
class ReadOut {
  public:
    ReadOut(std::uint64_t seed, const Texture& texture) : reader_(seed, texture) {}

    /// `offset`: the place in the texture (m) where the way begins.
    void set_way(Way way, double offset);

    /// Forgets the previous call of at().
    void begin() { has_last_ = false; }

    /// The pressure, Pa. `ratio`: playing speed / film's speed. The place that is read is the
    /// integral of the ratio over the way since begin(), plus a constant. In parts,
    ///     int r dx = r x - int x dr,
    /// it depends on the time alone where the ratio is constant.
    [[nodiscard]] double at(double scene_time, double playing_speed, double ratio);

  private:
    void enter_piece(std::size_t piece, double playing_speed);

    static constexpr auto kNoPiece = static_cast<std::size_t>(-1);

    TextureReader reader_;
    Way way_;
    double offset_ = 0;
    bool has_last_ = false;
    double last_way_ = 0;
    double last_ratio_ = 1;
    double shift_ = 0;  // int x dr since begin()
    // Of the present piece of the way, and of the playing speed there.
    std::size_t piece_ = kNoPiece;
    std::array<double, 2> scales_{};  // pressure per strength of the texture at normal speed
    double playing_speed_ = 0;
    TextureReader::Weights first_weights_{}, last_weights_{};
};

}  // namespace carom::sound
