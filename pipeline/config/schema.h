// Generates configs/carom.schema.json from the table of keys.
#pragma once

#include <string>

namespace carom::pipeline {

/// The format as a JSON Schema, draft 7. It describes structure, types, ranges of plain numbers,
/// choices, units, and keys that exclude each other. It does not require keys that may come from an
/// included file (required keys of maps that are merged).
[[nodiscard]] std::string schema_json();

}  // namespace carom::pipeline
