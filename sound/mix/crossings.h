// When a film shows the events of its shots.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <queue>
#include <vector>

#include "sound/sound_scene.h"

namespace carom::sound {

/// The film time in [passage.from, passage.to), s, at which a passage first shows a scene time;
/// empty if it does not. Exact to 1e-12 s. A passage that stands still shows nothing new. One that
/// runs from scene time a to b shows [a, b), backwards (b, a], so that of two passages that follow
/// each other only one shows the instant between them.
[[nodiscard]] std::optional<double> film_time_of(const Passage& passage, double scene_time);

/// An impact or a strike as a passage shows it.
struct Crossing {
    double film_time = 0;     // s
    std::size_t shot = 0;     // index in SoundScene::shots
    std::size_t event = 0;    // index in the shot's timeline's events
    std::size_t passage = 0;  // index in the shot's passages
};

/// Enumerates the impacts and strikes of a film in order of film time, then of the shot, the place
/// in the log and the passage. Its memory is one entry for each passage that is open.
class Crossings {
  public:
    /// `scene` must outlive it and not change.
    explicit Crossings(const SoundScene& scene);

    /// The next one before this film time (s), if there is one.
    [[nodiscard]] std::optional<Crossing> next_before(double film_time);

  private:
    /// Indices of a shot's impacts and strikes, by time and, at the same time, by place in the log.
    struct Order {
        std::vector<std::size_t> forwards;
        std::vector<std::size_t> backwards;  // by falling time
    };
    /// The events of one passage that are still to come; `next` and `end` are places in an order.
    struct Cursor {
        Crossing at;
        std::size_t next = 0;
        std::size_t end = 0;
        bool is_backwards = false;
    };
    struct Later {
        bool operator()(const Cursor& a, const Cursor& b) const;
    };
    struct PassageIndex {
        std::size_t shot = 0;
        std::size_t passage = 0;
    };

    [[nodiscard]] const Passage& passage(const PassageIndex& index) const;
    void open(const PassageIndex& index);
    void push_next(Cursor cursor);

    const SoundScene& scene_;
    std::vector<Order> orders_;          // by shot
    std::vector<PassageIndex> waiting_;  // in order of their beginning, last first
    std::priority_queue<Cursor, std::vector<Cursor>, Later> open_;
};

}  // namespace carom::sound
