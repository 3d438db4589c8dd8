#include "sound/rolling/way.h"

#include <algorithm>

#include "core/assert.h"

namespace carom::sound {
void Way::add(double time, double duration, const std::array<double, 3>& speeds,
              const std::array<double, 2>& pressures) {
    CAROM_ASSERT(duration > 0);
    CAROM_ASSERT(pieces_.empty() || time >= pieces_.back().time);
    const double way = duration * (speeds[0] + 4 * speeds[1] + speeds[2]) / 6;
    const double at_start = speeds[0] * duration;
    const double at_end = speeds[2] * duration;
    pieces_.push_back({time,
                       duration,
                       length_,
                       {at_start, 3 * way - 2 * at_start - at_end, at_start + at_end - 2 * way},
                       {{speeds[0], speeds[2]}, pressures}});
    length_ += way;
}

WayPoint Way::at(double time) {
    if (pieces_.empty() || time < pieces_.front().time) {
        return {};
    }
    const auto is_in = [&](std::size_t index) {
        return pieces_[index].time <= time &&
               (index + 1 == pieces_.size() || time < pieces_[index + 1].time);
    };
    if (!is_in(last_)) {
        if (last_ + 1 < pieces_.size() && is_in(last_ + 1)) {
            ++last_;
        } else if (last_ > 0 && is_in(last_ - 1)) {
            --last_;
        } else {
            const auto after =
                std::upper_bound(pieces_.begin(), pieces_.end(), time,
                                 [](double t, const Piece& piece) { return t < piece.time; });
            last_ = static_cast<std::size_t>(after - pieces_.begin()) - 1;
        }
    }
    const Piece& piece = pieces_[last_];
    const double s = (time - piece.time) / piece.duration;
    if (s > 1) {
        return {piece.way + piece.curve[0] + piece.curve[1] + piece.curve[2], last_, 1, true};
    }
    return {piece.way + s * (piece.curve[0] + s * (piece.curve[1] + s * piece.curve[2])), last_, s,
            false};
}

}  // namespace carom::sound
