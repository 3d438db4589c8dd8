#include "sim/scheduler/contact_log.h"

#include <algorithm>
#include <tuple>

namespace carom::sim {

/// A tap, which takes no time, stands for the time since the previous one.
void ContactLog::Sum::add(const ContactLoad& load, double since) {
    const double time = load.to - (load.to > load.from ? load.from : since);
    to = std::max(to, load.to);
    impulse += load.normal_impulse;
    slip_path += load.slip * time;
    slip_time += time;
}

void ContactLog::Sum::add(const Sum& next) {
    to = next.to;
    impulse += next.impulse;
    slip_path += next.slip_path;
    slip_time += next.slip_time;
}

ContactLog::Range ContactLog::Range::with(double value) const {
    return {std::min(least, value), std::max(most, value)};
}

std::uint32_t ContactLog::pair_number(const std::string& a, const std::string& b) {
    const auto [place, is_new] =
        numbers_[a].try_emplace(b, static_cast<std::uint32_t>(open_.size()));
    if (is_new) {
        open_.emplace_back();
    }
    return place->second;
}

void ContactLog::add(const std::string& a, const std::string& b, const ContactLoad& load) {
    const bool rests = load.slip + load.turning < kStillSpeed;
    const std::uint32_t pair = pair_number(a, b);
    Open& open = open_[pair];
    if (open.is_open && (rests ? load.to : load.from) - open.piece.to > kLongestPause) {
        end_stretch(pair);
    }
    if (rests && !open.is_open) {
        return;
    }
    if (!open.is_open) {
        open = {};
        open.is_open = true;
        open.from = open.piece.from = open.piece.to = load.from;
        if (load.from == load.to) {
            return;  // the first tap, which stands for no time
        }
    }
    if (rests) {
        if (open.rest.duration() == 0) {
            open.rest.from = open.piece.to;
        }
        open.rest.add(load, open.end());
        return;
    }
    const double since = open.end();
    if (open.rest.duration() > 0) {
        open.piece.add(open.rest);
        open.rest = {};
    }
    open.piece.add(load, since);
    if (open.piece.duration() >= kPiece) {
        join(pair);
    }
}

/// The last piece is complete: it is joined to those before it, or they are written.
void ContactLog::join(std::uint32_t pair) {
    Open& open = open_[pair];
    const double force = open.piece.force();
    const double slip = open.piece.slip();
    const Range forces = open.has_joined ? open.forces.with(force) : Range{force, force};
    const Range slips = open.has_joined ? open.slips.with(slip) : Range{slip, slip};
    const bool is_alike =
        forces.most <= kJoinedForces * forces.least &&
        slips.most <= std::max(kJoinedSlips * slips.least, slips.least + kStillSpeed);
    if (open.has_joined && is_alike) {
        open.joined.add(open.piece);
        open.forces = forces;
        open.slips = slips;
    } else {
        if (open.has_joined) {
            write(pair, open.joined);
        }
        open.has_joined = true;
        open.joined = open.piece;
        open.forces = {force, force};
        open.slips = {slip, slip};
    }
    const double end = open.piece.to;
    open.piece = {};
    open.piece.from = open.piece.to = end;
}

void ContactLog::end_stretch(std::uint32_t pair) {
    Open& open = open_[pair];
    open.is_open = false;
    if (open.piece.to - open.from < kMinStretch) {
        return;
    }
    if (open.piece.duration() > 0) {
        join(pair);
    }
    if (open.has_joined) {
        write(pair, open.joined);
    }
}

void ContactLog::write(std::uint32_t pair, const Sum& sum) {
    written_.push_back({pair, sum});
    if (written_.size() >= 2 * most_) {
        keep_greatest();
    }
}

/// Of equal impulses the earlier are kept.
void ContactLog::keep_greatest() {
    if (written_.size() <= most_) {
        return;
    }
    const auto last = written_.begin() + static_cast<std::ptrdiff_t>(most_);
    std::nth_element(written_.begin(), last, written_.end(), [](const Piece& a, const Piece& b) {
        return std::tuple(-a.sum.impulse, a.sum.from, a.pair) <
               std::tuple(-b.sum.impulse, b.sum.from, b.pair);
    });
    written_.erase(last, written_.end());
}

std::vector<LastingContact> ContactLog::take() {
    for (std::uint32_t pair = 0; pair < open_.size(); ++pair) {
        if (open_[pair].is_open) {
            end_stretch(pair);
        }
    }
    keep_greatest();
    std::vector<std::pair<const std::string*, const std::string*>> names(open_.size());
    for (const auto& [a, partners] : numbers_) {
        for (const auto& [b, number] : partners) {
            names[number] = {&a, &b};
        }
    }
    std::vector<LastingContact> contacts;
    contacts.reserve(written_.size());
    for (const Piece& piece : written_) {
        const auto& [a, b] = names[piece.pair];
        contacts.push_back(
            {*a, *b, piece.sum.from, piece.sum.to, piece.sum.force(), piece.sum.slip()});
    }
    std::sort(contacts.begin(), contacts.end(),
              [](const LastingContact& x, const LastingContact& y) {
                  return std::tie(x.from, x.a, x.b) < std::tie(y.from, y.a, y.b);
              });
    return contacts;
}

}  // namespace carom::sim
