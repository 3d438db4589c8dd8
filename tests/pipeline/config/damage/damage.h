// Damages one character of a text, like a typing error.
#pragma once

#include <string>
#include <vector>

#include "tests/random_films/dice.h"

namespace carom::testing {

struct Damage {
    std::string text;  // the whole damaged text
    std::string what;  // "colon deleted", for messages
    int line = 0;      // of the damage, from 1
    /// The lines within which a problem must point: those of the construct that the damaged line
    /// belongs to. These are its parent (the nearest line above that is indented less), everything
    /// below the parent, and the line that follows: a bracket or a quote that is not closed may be
    /// noticed only there. They are all lines of the text if the damaged line has no parent.
    int first_line = 0;
    int last_line = 0;
    std::vector<std::string> enclosing;  // the parent and its parents, outwards
    std::string old_line;
    std::string new_line;
};

/// Deletes, inserts or replaces a quote, a bracket, a colon, a comma, a dash, a space of the
/// indentation, a line end or a letter of a unit.
[[nodiscard]] Damage damage(const std::string& text, Dice& dice);

}  // namespace carom::testing
