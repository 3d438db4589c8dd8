#include "pipeline/cli/schema_command.h"

#include "pipeline/cli/output_file.h"
#include "pipeline/config/schema.h"

namespace carom::cli {

void run_schema(const SchemaCommand& command) {
    check_output_folder(command.output);
    write_text_output(command.output.empty() ? "-" : command.output, pipeline::schema_json());
}

}  // namespace carom::cli
