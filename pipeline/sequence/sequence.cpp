#include "pipeline/sequence/sequence.h"

namespace carom::pipeline {

std::vector<std::int64_t> Sequence::starts() const {
    std::vector<std::int64_t> all;
    std::int64_t end = 0;
    for (const SequencePart& part : parts) {
        all.push_back(all.empty() ? 0 : end - part.fade);
        end = all.back() + part.frames;
    }
    return all;
}

std::int64_t Sequence::frames() const {
    return parts.empty() ? 0 : starts().back() + parts.back().frames;
}

std::vector<SequenceLayer> layers_of(const Sequence& sequence, std::int64_t frame) {
    const std::vector<std::int64_t> starts = sequence.starts();
    std::vector<SequenceLayer> layers;
    for (std::size_t i = 0; i < sequence.parts.size(); ++i) {
        const SequencePart& part = sequence.parts[i];
        const std::int64_t own = frame - starts[i];
        if (own < 0 || own >= part.frames) {
            continue;
        }
        // The weights of the fade's frames are those in their middles.
        const double weight =
            own < part.fade ? (static_cast<double>(own) + 0.5) / static_cast<double>(part.fade) : 1;
        for (SequenceLayer& before : layers) {
            before.weight *= 1 - weight;
        }
        layers.push_back({i, own, weight});
    }
    return layers;
}

}  // namespace carom::pipeline
