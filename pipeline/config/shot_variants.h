// Variants of a shot: worlds that differ from its own in some values, read without parsing its
// files again.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/config/load_shot.h"
#include "sim/world.h"

namespace carom::pipeline {

/// A value that a variant has instead of the shot's.
struct VariedValue {
    std::string key;   // as in --set: "events[0].strike.speed"
    std::string text;  // YAML: "3.2 m/s"
};

/// Any number of threads may use it at once.
class ShotVariants {
  public:
    /// Reads the shot with all files that it includes; `options` as for load_shot. `origin` names
    /// the texts of varied values in problems: "--vary". Throws Error if the shot cannot be read;
    /// load_shot says why.
    ShotVariants(const std::string& path, const LoadOptions& options, std::string origin);
    ~ShotVariants();
    ShotVariants(const ShotVariants&) = delete;
    ShotVariants& operator=(const ShotVariants&) = delete;

    /// The text of a single value of the shot; empty if the shot does not give it.
    [[nodiscard]] std::optional<std::string> text_of(const std::string& key) const;

    /// The world of the shot itself.
    [[nodiscard]] const sim::WorldDescription& own_world() const;

    struct World {
        std::optional<sim::WorldDescription> world;  // empty if a problem is an error
        std::vector<Problem> problems;
    };
    /// The world that load_shot gives for the shot with these values.
    [[nodiscard]] World world(std::span<const VariedValue> values) const;

    struct Events {
        std::optional<std::vector<sim::ForceEvent>> events;  // empty if a problem is an error
        std::vector<Problem> problems;
    };
    /// The events of that world; quicker than `world`. The keys must be those of events
    /// (is_in_events).
    [[nodiscard]] Events events(std::span<const VariedValue> values) const;

  private:
    struct Data;
    std::unique_ptr<const Data> data_;
};

/// Whether a value at that key belongs to an event, so that it changes nothing else of the world.
[[nodiscard]] bool is_in_events(const std::string& key);

/// Whether a value at that key can change how a shot moves; true for keys that do not exist.
[[nodiscard]] bool can_change_motion(const std::string& key);

}  // namespace carom::pipeline
