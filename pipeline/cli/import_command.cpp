#include <filesystem>

#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/import/import_scene.h"

namespace carom::cli {

void run(const ImportCommand& command, CommandContext& context) {
    const std::string path = output_or_default(command.output, command.scene, ".yaml");
    const bool to_stdout = path == "-";
    const std::string folder =
        to_stdout ? "." : std::filesystem::absolute(path).parent_path().string();
    if (!to_stdout) {
        check_output_folder(path);
        std::error_code ignored;
        if (std::filesystem::equivalent(path, command.scene, ignored)) {
            throw InputError("the output '" + path +
                             "' is the scene itself; give another file with -o");
        }
    }
    pipeline::ImportOptions options;
    options.unit = command.unit;
    options.is_z_up = command.up == "z";
    options.field_of_view =
        command.fov == "formula" ? pipeline::FieldOfView::formula : pipeline::FieldOfView::distance;
    options.boxes = command.boxes == "fixed"     ? pipeline::BoxMotion::fixed
                    : command.boxes == "dynamic" ? pipeline::BoxMotion::dynamic
                                                 : pipeline::BoxMotion::automatic;
    options.force_time = command.force_time;
    const pipeline::ImportResult result =
        pipeline::import_scene_file(command.scene, folder, options);
    report_problems(result.problems, context.console);
    if (result.yaml.empty()) {
        throw InputError("'" + command.scene + "' has " + count_text(result.problems));
    }
    for (const std::string& note : result.notes) {
        context.console.event("note", JsonMembers().add("message", note), "note: " + note + "\n",
                              false);
    }
    write_text_output(path, result.yaml);
    // The imported shot is checked like by 'carom check'.
    const pipeline::LoadResult shot =
        pipeline::load_shot_text(result.yaml, to_stdout ? folder + "/shot.yaml" : path);
    report_problems(shot.problems, context.console);
    if (!shot.shot) {
        throw InputError("the imported shot has " + count_text(shot.problems) +
                         "; correct the scene or the shot");
    }
}

}  // namespace carom::cli
