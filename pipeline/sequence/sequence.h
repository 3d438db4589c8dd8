// A film of several shots and title cards, as its file describes it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/camera/rational.h"
#include "pipeline/config/film_section.h"
#include "pipeline/config/problem.h"
#include "pipeline/config/shot_source.h"
#include "pipeline/shot/shot.h"
#include "pipeline/video/output_settings.h"
#include "sim/timeline/bake_file.h"

namespace carom::pipeline {

/// Frames of a shot's own film.
struct ShotPart {
    std::string path;                    // of the shot's file
    std::vector<std::string> own;        // values that replace the shot's own (LoadOptions)
    std::vector<std::string> overrides;  // as given to --set
    Shot shot;
    std::shared_ptr<const ShotSource> source;
    std::shared_ptr<const sim::Bake> bake;  // if the file is a bake
    std::int64_t first = 0;                 // frame of the shot's film
};

struct SequencePart {
    std::variant<ShotPart, TitleCard> content;
    std::int64_t frames = 0;  // at least one
    std::int64_t fade = 0;    // frames that it has in common with the part before; of the first
                              // part: over which it appears out of black
};

struct Sequence {
    std::string name;  // of the file, without folder and extension
    int width = 0;     // pixels
    int height = 0;
    Rational fps{24};
    OutputSettings output;    // how it is encoded; each shot has its own view
    std::string output_text;  // the same as a value of YAML on one line; empty: the defaults
    std::vector<SequencePart> parts;

    /// The number of the film's frame with which each part begins.
    [[nodiscard]] std::vector<std::int64_t> starts() const;
    /// The number of frames of the film.
    [[nodiscard]] std::int64_t frames() const;
};

/// A frame of a part that a frame of the film shows.
struct SequenceLayer {
    std::size_t part = 0;
    std::int64_t frame = 0;  // from the start of the part
    double weight = 1;       // of it; the weights of a frame add up to 1, or less over black
};

/// What a frame of the film shows: one layer, or two in a fade, the earlier part first.
[[nodiscard]] std::vector<SequenceLayer> layers_of(const Sequence& sequence, std::int64_t frame);

}  // namespace carom::pipeline
