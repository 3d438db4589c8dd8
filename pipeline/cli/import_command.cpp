#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/import/import_mesh.h"
#include "pipeline/import/import_scene.h"

namespace carom::cli {

namespace {

void tell_notes(const std::vector<std::string>& notes, CommandContext& context) {
    for (const std::string& note : notes) {
        context.console.event("note", JsonMembers().add("message", note), "note: " + note + "\n",
                              false);
    }
}

/// Throws InputError if there is a file that carom import did not make.
void check_may_replace(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) {
        return;
    }
    std::ifstream file(path, std::ios::binary);
    std::string start(std::strlen(pipeline::kMadeMesh), '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (!file || start != pipeline::kMadeMesh) {
        throw InputError(
            "'" + path +
            "' already exists and was not made by carom import; give another name with "
            "-o");
    }
}

void import_mesh(const ImportCommand& command, const std::string& path, CommandContext& context) {
    pipeline::ImportMeshOptions options;
    options.unit = command.unit.value_or(options.unit);
    options.is_z_up = command.up == "z";
    const bool to_stdout = path == "-";
    const std::string yaml_path =
        to_stdout ? std::filesystem::path(command.scene).stem().string() + ".yaml" : path;
    const pipeline::ImportMeshResult result =
        pipeline::import_mesh(command.scene, yaml_path, options);
    report_problems(result.problems, context.console, true);
    if (result.yaml.empty()) {
        throw InputError("'" + command.scene + "' has " + count_text(result.problems));
    }
    if (to_stdout && !result.files.empty()) {
        throw InputError("'" + command.scene +
                         "' has several materials and becomes several files; name one with -o");
    }
    tell_notes(result.notes, context);
    const std::filesystem::path folder = std::filesystem::path(yaml_path).parent_path();
    for (const pipeline::MeshFileText& file : result.files) {
        check_may_replace((folder / file.name).string());
    }
    for (const pipeline::MeshFileText& file : result.files) {
        write_text_output((folder / file.name).string(), file.text);
    }
    write_text_output(path, result.yaml);
}

}  // namespace

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
    if (pipeline::is_mesh_name(command.scene)) {
        import_mesh(command, path, context);
        return;
    }
    pipeline::ImportOptions options;
    options.unit = command.unit.value_or(options.unit);
    options.is_z_up = command.up == "z";
    options.field_of_view =
        command.fov == "formula" ? pipeline::FieldOfView::formula : pipeline::FieldOfView::distance;
    options.boxes = command.boxes == "fixed"     ? pipeline::BoxMotion::fixed
                    : command.boxes == "dynamic" ? pipeline::BoxMotion::dynamic
                                                 : pipeline::BoxMotion::automatic;
    options.force_time = command.force_time;
    const pipeline::ImportResult result =
        pipeline::import_scene_file(command.scene, folder, options);
    report_problems(result.problems, context.console, true);
    if (result.yaml.empty()) {
        throw InputError("'" + command.scene + "' has " + count_text(result.problems));
    }
    tell_notes(result.notes, context);
    write_text_output(path, result.yaml);
    // The imported shot is checked like by 'carom check'.
    const pipeline::LoadResult shot =
        pipeline::load_shot_text(result.yaml, to_stdout ? folder + "/shot.yaml" : path);
    report_problems(shot.problems, context.console, true);
    if (!shot.shot) {
        throw InputError("the imported shot has " + count_text(shot.problems) +
                         "; correct the scene or the shot");
    }
}

}  // namespace carom::cli
