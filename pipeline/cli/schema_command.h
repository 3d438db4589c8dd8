// carom schema.
#pragma once

#include "pipeline/cli/commands.h"

namespace carom::cli {

void run_schema(const SchemaCommand& command);

}  // namespace carom::cli
