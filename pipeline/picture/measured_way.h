// The direction in which a ball moves after a contact, up to its next contact.
#pragma once

#include <optional>
#include <string>

#include "pipeline/picture/annotation.h"
#include "pipeline/picture/contact.h"
#include "sim/timeline/timeline.h"

namespace carom::pipeline {

/// What ends the way of an object after a contact.
enum class WayEnd {
    none,       // the timeline ends
    contact,    // it touches something else than the cloth
    potted,     // it falls into a pocket
    off_table,  // it leaves the table
    resting,    // it comes to rest
    moved,      // it is struck, or an event pushes, places or removes it
};

/// The way of an object after a contact, and where its direction was measured.
struct MeasuredWay {
    std::optional<Vec3> direction{};  // unit, level; empty: it does not move
    double measured = 0;              // scene time, s
    bool is_cut = false;              // measured at the end, before what was asked for
    bool is_rolling = false;          // whether it rolls then
    bool is_flying = false;           // whether it is in the air then
    WayEnd end = WayEnd::none;
    std::string other{};  // contact: what it touches; potted: the pocket
    double end_time = 0;  // scene time, s
    Vec3 end_place{};     // of its centre, m
};

/// Measures the way at the asked time after the contact, or at its end if that comes first. Empty
/// if the timeline does not have the object. Impacts with the cloth, and further impacts of the
/// same contact (sim::kOneContact), do not end the way.
[[nodiscard]] std::optional<MeasuredWay> measured_way(const sim::Timeline& timeline,
                                                      const std::string& object,
                                                      const Contact& contact,
                                                      const std::string& other,
                                                      const MeasuringTime& asked);

}  // namespace carom::pipeline
