#include "pipeline/job/observer_gate.h"

namespace carom::pipeline {

void ObserverGate::tell(std::string_view stage, double share) {
    if (observer_.on_progress) {
        observer_.on_progress(stage, share);
    }
}

void ObserverGate::render_progress(double share) {
    const std::scoped_lock lock(mutex_);
    if (share > render_share_) {
        render_share_ = share;
        tell("render", share);
        if (share >= 1 && encode_share_ > 0) {
            tell("encode", encode_share_);
        }
    }
}

void ObserverGate::encode_progress(double share) {
    const std::scoped_lock lock(mutex_);
    if (share > encode_share_) {
        encode_share_ = share;
        if (render_share_ >= 1) {
            tell("encode", share);
        }
    }
}

void ObserverGate::warning(const std::string& message) {
    const std::scoped_lock lock(mutex_);
    if (observer_.on_warning) {
        observer_.on_warning(message);
    }
}

void ObserverGate::frame(std::int64_t number, bool from_store, double seconds, std::uint64_t rays) {
    const std::scoped_lock lock(mutex_);
    if (observer_.on_frame) {
        observer_.on_frame(number, from_store, seconds, rays);
    }
}

}  // namespace carom::pipeline
