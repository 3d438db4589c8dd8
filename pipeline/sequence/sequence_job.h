// The jobs of a film of several shots: render what the store does not have, and encode the film.
#pragma once

#include <cstdint>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/job/film_job.h"
#include "pipeline/job/film_sound.h"
#include "pipeline/job/film_status.h"
#include "pipeline/sequence/sequence.h"
#include "pipeline/sheet/contact_sheet.h"
#include "sim/timeline/bake_file.h"

namespace carom::pipeline {

/// The bakes of the shots among the parts, by the index of the part.
using SequenceBakes = std::map<std::size_t, sim::Bake>;

/// The frames of the part's shot, in its own film's numbers, that these frames of the film show.
/// None for a title card.
[[nodiscard]] std::vector<std::int64_t> own_frames(const Sequence& sequence, std::size_t part,
                                                   const std::vector<std::int64_t>& frames);

/// The job of a part that renders these frames of its shot's own film.
[[nodiscard]] FilmJobOptions part_options(FilmJobOptions options,
                                          const std::vector<std::int64_t>& own);

/// The sound of the whole film; empty if no part has any. Refers to both arguments.
[[nodiscard]] SoundMaker sequence_sound(const Sequence& sequence, const SequenceBakes& bakes,
                                        std::stop_token stop);

/// As make_film, for the frames of all parts: one progress, one file. With an empty
/// `options.output` the frames are only rendered and stored. Throws Error, Stopped.
FilmJobResult make_sequence(const Sequence& sequence, const SequenceBakes& bakes,
                            const FilmJobOptions& options, const JobObserver& observer,
                            const std::stop_token& stop);

/// What of the part's frames that the options select is stored, in its own film's numbers.
[[nodiscard]] FilmStatus part_status(const Sequence& sequence, std::size_t part,
                                     const SequenceBakes& bakes, const FilmJobOptions& options,
                                     const std::stop_token& stop);

/// Like make_sequence, but only with stored frames. Throws an Error that names the missing frames
/// in the film's numbers, unless the film so far is wanted.
FilmJobResult mux_sequence(const Sequence& sequence, const SequenceBakes& bakes,
                           const FilmJobOptions& options, const JobObserver& observer,
                           const std::stop_token& stop);

/// Calls `take` with the display values of these frames of the film in order, as make_sequence
/// encodes them. Throws Error, Stopped.
void for_each_frame(const Sequence& sequence, const SequenceBakes& bakes,
                    const std::vector<std::int64_t>& frames, const FilmJobOptions& options,
                    const JobObserver& observer,
                    const std::function<void(std::int64_t frame, const DisplayPicture&)>& take,
                    const std::stop_token& stop);

}  // namespace carom::pipeline
