// The names of a table's pockets.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/billiards/table.h"

namespace carom::pipeline::config {

/// The names of the pockets that the table has, from "corner_left_front" on counter-clockwise.
[[nodiscard]] std::vector<std::string> pocket_names(const sim::billiards::TableMeasures& table);

/// Those of players, as the table is seen in its plan: "top left", "bottom side". Not for snooker,
/// whose players call the end of the black spot the top.
[[nodiscard]] std::vector<std::string> players_pocket_names(
    const sim::billiards::TableMeasures& table);

/// The pocket of the table that is meant by any of its names, by its own; empty if there is none.
[[nodiscard]] std::string pocket_of_name(const sim::billiards::TableMeasures& table,
                                         std::string_view name);

/// The pocket that a player's name means on other tables: it is ambiguous on this one; else empty.
[[nodiscard]] std::string ambiguous_pocket(const sim::billiards::TableMeasures& table,
                                           std::string_view name);

}  // namespace carom::pipeline::config
