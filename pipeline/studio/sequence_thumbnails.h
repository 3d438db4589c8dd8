// Small pictures of the frames of a film of several shots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "pipeline/sequence/sequence.h"
#include "pipeline/studio/film_thumbnails.h"

namespace carom::studio {

/// For one thread. Pictures come from the store of finished frames, those of title cards are drawn.
class SequenceThumbnails {
  public:
    /// Refers to the sequence. The folder of the cache is not empty.
    SequenceThumbnails(const pipeline::Sequence& sequence, std::string cache_folder);

    /// The frame as a JPEG, with its fade; nothing if the cache does not have all that it shows.
    /// Throws Error.
    [[nodiscard]] std::optional<std::string> jpeg(std::int64_t frame);

  private:
    [[nodiscard]] std::optional<SmallPicture> layer(const pipeline::SequenceLayer& layer);

    const pipeline::Sequence& sequence_;
    std::string cache_folder_;
    std::map<std::size_t, std::unique_ptr<FilmThumbnails>> shots_;  // by their parts
};

}  // namespace carom::studio
