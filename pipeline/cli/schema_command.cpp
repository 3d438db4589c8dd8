#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/config/schema.h"

namespace carom::cli {

void run(const SchemaCommand& command, CommandContext& /*context*/) {
    check_output_folder(command.output);
    write_text_output(command.output.empty() ? "-" : command.output, pipeline::schema_json());
}

}  // namespace carom::cli
