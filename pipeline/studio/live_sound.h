// The sound of the film as it is now, in pieces that the page gets. One thread of its own computes
// it.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "pipeline/studio/heard_film.h"
#include "pipeline/studio/sound_messages.h"

namespace carom::studio {

struct LiveSoundOptions {
    /// A film is computed once it was the newest one for so long: not at every step of a drag,
    /// which would take the processor from the simulation.
    std::chrono::milliseconds rest{250};
    /// The longest film, because all pieces are kept in memory: 0.2 MB for each second.
    double most_seconds = 600;
    std::int64_t piece = std::int64_t{5} * sound::kSampleRate;  // samples of each channel
};

/// All functions may be called from any thread, and return without waiting for work.
class LiveSound {
  public:
    /// Called from the thread of the sound, with the number that came with the film.
    using Send = std::function<void(int opening, const SoundState& state)>;
    /// Called on that thread. What the scene refers to lives as long as the function.
    using Make = std::function<HeardFilm()>;

    explicit LiveSound(Send send, const LiveSoundOptions& options = {});
    /// Stops all work and waits for its end.
    ~LiveSound();
    LiveSound(const LiveSound&) = delete;
    LiveSound& operator=(const LiveSound&) = delete;
    LiveSound(LiveSound&&) = delete;
    LiveSound& operator=(LiveSound&&) = delete;

    /// Where the pieces are: "/sound/3/0.pcm".
    static constexpr std::string_view kFolder = "/sound/";

    /// The film of version `v` of the texts. Work on the one before is stopped; its pieces can be
    /// got until the first one of this film is there.
    void set(int opening, std::int64_t v, Make make);

    /// There is no film.
    void clear();

    /// The piece at a path ("/sound/3/0.pcm"); null if there is none.
    [[nodiscard]] std::shared_ptr<const std::string> find(std::string_view path) const;

  private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace carom::studio
