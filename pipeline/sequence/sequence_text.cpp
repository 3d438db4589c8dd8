#include "pipeline/sequence/sequence_text.h"

#include <algorithm>
#include <variant>

#include <fmt/core.h>

#include "core/json_text.h"

namespace carom::pipeline {
namespace {

std::string time_text(std::int64_t frames, const Rational& fps) {
    return (Rational(frames) / fps).to_string() + " s";
}

/// Which decide about size and rate.
bool has_shots(const Sequence& sequence) {
    return std::ranges::any_of(sequence.parts, [](const SequencePart& part) {
        return std::holds_alternative<ShotPart>(part.content);
    });
}

std::string colour_text(const Vec3& colour) {
    return fmt::format("[{}, {}, {}]", colour.x, colour.y, colour.z);
}

/// JSON's texts are valid in YAML.
std::string card_text(const TitleCard& card) {
    std::string text = "title: " + json_string(card.text);
    if (!card.subtitle.empty()) {
        text += ", subtitle: " + json_string(card.subtitle);
    }
    return text + ", colour: " + colour_text(card.colour) +
           ", background: " + colour_text(card.background);
}

}  // namespace

std::string sequence_text(const Sequence& sequence,
                          const std::function<std::string(std::size_t)>& file_of) {
    const auto time = [&](std::int64_t frames) { return time_text(frames, sequence.fps); };
    std::string text = "carom: 1\nfilm:\n";
    if (!has_shots(sequence)) {
        text += fmt::format("  size: [{}, {}]\n  fps: {}\n", sequence.width, sequence.height,
                            sequence.fps.to_string());
    }
    text += "  shots:\n";
    for (std::size_t i = 0; i < sequence.parts.size(); ++i) {
        const SequencePart& part = sequence.parts[i];
        text += "    - {";
        if (const auto* shot = std::get_if<ShotPart>(&part.content)) {
            text += "shot: " + json_string(file_of(i)) + ", from: " + time(shot->first) +
                    ", to: " + time(shot->first + part.frames);
        } else {
            text += card_text(std::get<TitleCard>(part.content)) + ", for: " + time(part.frames);
        }
        text += ", fade: " + time(part.fade) + "}\n";
    }
    return sequence.output_text.empty() ? text : text + "output: " + sequence.output_text + "\n";
}

}  // namespace carom::pipeline
