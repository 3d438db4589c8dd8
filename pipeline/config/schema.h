// configs/carom.schema.json, from the table of keys.
#pragma once

#include <string>

namespace carom::pipeline {

/// The format as a JSON Schema, draft 7. It knows structure, types, ranges of plain numbers, words
/// to choose from, units, and keys that exclude each other. What may come from an included file (a
/// required key of a map that is merged) it does not ask for.
[[nodiscard]] std::string schema_json();

}  // namespace carom::pipeline
