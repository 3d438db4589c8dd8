// From the event log to sources of sound: which spheres are accelerated and which modes are excited
// by an impact.
#pragma once

#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "sound/sound_scene.h"
#include "sound/source/pulse.h"

namespace carom::sound {

/// A rigid sphere whose velocity changes by `velocity_step` during the contact.
struct SphereSource {
    Vec3 centre{0, 0, 0};         // m
    double radius = 0;            // m
    Vec3 velocity_step{0, 0, 0};  // m/s
    double factor = 1;            // of the pressure: less than 1 for a mirror image in the bed
    bool operator==(const SphereSource&) const = default;
};

/// What one impact sounds like, wherever it is heard. All sources follow the same force.
struct ImpactSound {
    Group group = Group::balls;
    Vec3 place{0, 0, 0};                     // m, of the contact, from which the modes sound, too
    double impulse = 0;                      // N s, > 0
    double contact_time = 0;                 // s
    PulseShape shape = PulseShape::elastic;  // of the force; soft with resonators
    std::vector<SphereSource> spheres;
    std::vector<Mode> modes;  // gains for 1 N s
};

/// Makes the sounds of the events of one shot, which must outlive this object. The shot does not
/// change meanwhile. May be used by several threads.
class ImpactSounds {
  public:
    explicit ImpactSounds(const SoundShot& shot);

    /// The sound of an impact or a strike; empty for other events, and for those without an impulse
    /// or between things that are not among the shot's bodies. A ball that falls into a pocket has
    /// no sound of its own: its impacts with the pocket's lining are events. A ball on the cloth
    /// sounds with its mirror image in the bed. Cushions, the cloth and pockets have sounds of
    /// their own; all other surfaces and scenery are wood.
    [[nodiscard]] std::optional<ImpactSound> sound_of(const sim::Event& event) const;

    /// The longest time in which any mode of the shot falls to 1/e, s.
    [[nodiscard]] double longest_decay() const;

  private:
    struct Entry {
        const SoundBody* body = nullptr;
        const sim::Track* track = nullptr;  // null: it never moves
    };

    [[nodiscard]] const Entry* entry(std::string_view name) const;
    [[nodiscard]] std::optional<ImpactSound> of_strike(const sim::Event& event) const;
    [[nodiscard]] ImpactSound of_bodies(const sim::Event& event, const Entry& a,
                                        const Entry& b) const;
    [[nodiscard]] ImpactSound of_surface(const sim::Event& event, const Entry& body) const;
    void add_body(const Entry& entry, const sim::Event& event, double sign, double mode_factor,
                  ImpactSound& sound) const;
    void add_sphere(const Vec3& centre, double radius, const Vec3& velocity_step,
                    ImpactSound& sound) const;

    const SoundShot& shot_;
    std::unordered_map<std::string_view, Entry> entries_;
};

}  // namespace carom::sound
