#include "bench/farm_frames.h"

namespace carom::bench {

FarmFrames::FarmFrames(int count)
    : frames_(static_cast<std::size_t>(count)), order_(bit_reversed_order(count)) {}

void FarmFrames::claim(int number, int worker, double now) {
    FarmFrame& frame = at(number);
    if (frame.state == FrameState::claimed) {
        claims_.erase({frame.last_change, number});
    }
    frame.state = FrameState::claimed;
    frame.owner = worker;
    frame.rendered_since = now;
    frame.last_change = now;
    ++frame.claims;
    claims_.insert({now, number});
}

void FarmFrames::beat(int number, int worker, double now) {
    FarmFrame& frame = at(number);
    if (frame.state == FrameState::claimed && frame.owner == worker) {
        claims_.erase({frame.last_change, number});
        frame.last_change = now;
        claims_.insert({now, number});
    }
}

void FarmFrames::finish(int number) {
    FarmFrame& frame = at(number);
    if (frame.state == FrameState::claimed) {
        claims_.erase({frame.last_change, number});
    }
    if (frame.state != FrameState::done) {
        frame.state = FrameState::done;
        ++done_;
    }
}

void FarmFrames::hand_over(int number, int worker, double part) {
    FarmFrame& frame = at(number);
    if (frame.state == FrameState::claimed && frame.owner == worker) {
        claims_.erase({frame.last_change, number});
        frame.state = FrameState::open;
        frame.work_left *= 1 - part;
    }
}

int FarmFrames::first_open() const {
    if (done_ + static_cast<int>(claims_.size()) == count()) {
        return -1;
    }
    for (const int number : order_) {
        if ((*this)[number].state == FrameState::open) {
            return number;
        }
    }
    return -1;
}

std::vector<int> FarmFrames::all_open() const {
    std::vector<int> open;
    if (done_ + static_cast<int>(claims_.size()) == count()) {
        return open;
    }
    for (const int number : order_) {
        if ((*this)[number].state == FrameState::open) {
            open.push_back(number);
        }
    }
    return open;
}

int FarmFrames::stalest_claim() const {
    return claims_.empty() ? -1 : claims_.begin()->second;
}

int FarmFrames::not_begun_since(double time) const {
    for (const auto& [change, number] : claims_) {
        if ((*this)[number].rendered_since < time) {
            return number;
        }
    }
    return -1;
}

std::vector<int> bit_reversed_order(int count) {
    int bits = 0;
    while ((1 << bits) < count) {
        ++bits;
    }
    std::vector<int> order;
    for (int i = 0; i < (1 << bits); ++i) {
        int reversed = 0;
        for (int bit = 0; bit < bits; ++bit) {
            reversed |= ((i >> bit) & 1) << (bits - 1 - bit);
        }
        if (reversed < count) {
            order.push_back(reversed);
        }
    }
    return order;
}

}  // namespace carom::bench
