#include "sound/rolling/read_out.h"

#include <algorithm>
#include <utility>

namespace carom::sound {
namespace {

/// The least strength of a texture by which a pressure is divided: slower ways are below 20 Hz with
/// all their octaves.
constexpr double kLeastStrength = 1e-3;

}  // namespace

void ReadOut::set_way(Way way, double offset) {
    way_ = std::move(way);
    offset_ = offset;
    piece_ = kNoPiece;
    begin();
}

double ReadOut::at(double scene_time, double playing_speed, double ratio) {
    const WayPoint point = way_.at(scene_time);
    if (has_last_) {
        shift_ += (point.way + last_way_) / 2 * (ratio - last_ratio_);
    } else {
        shift_ = 0;
        has_last_ = true;
    }
    last_way_ = point.way;
    last_ratio_ = ratio;
    if (point.stands) {
        return 0;
    }
    if (point.piece != piece_ || playing_speed != playing_speed_) {
        enter_piece(point.piece, playing_speed);
    }
    if (scales_[0] == 0 && scales_[1] == 0) {
        return 0;
    }
    return reader_.at(offset_ + ratio * point.way - shift_, first_weights_, last_weights_,
                      point.part);
}

// Between the ends of a piece the weights are linear, so they are a function of scene time and
// playing speed alone.
void ReadOut::enter_piece(std::size_t piece, double playing_speed) {
    const WayEnds& ends = way_.ends(piece);
    if (piece != piece_) {
        piece_ = piece;
        for (std::size_t end = 0; end < 2; ++end) {
            const double pressure = ends.pressures[end];
            scales_[end] = pressure > 0 ? pressure / std::max(reader_.strength(ends.speeds[end]),
                                                              kLeastStrength)
                                        : 0;
        }
    }
    playing_speed_ = playing_speed;
    if (scales_[0] == 0 && scales_[1] == 0) {
        return;
    }
    first_weights_ = reader_.weights(ends.speeds[0] * playing_speed);
    last_weights_ = reader_.weights(ends.speeds[1] * playing_speed);
    for (std::size_t i = 0; i < first_weights_.size(); ++i) {
        first_weights_[i] *= scales_[0];
        last_weights_[i] *= scales_[1];
    }
}

}  // namespace carom::sound
