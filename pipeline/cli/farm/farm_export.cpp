// A job in a folder of its own, to be run elsewhere.
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <span>
#include <system_error>

#include <fmt/core.h>
#include <sys/stat.h>

#include "core/hash.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/farm_files.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/cli/farm/farm_plan.h"
#include "pipeline/farm/engine_files.h"
#include "pipeline/farm/scripts.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kIdDigits = 6;

std::string readme_text(const PlannedFarm& planned, const farm::EngineFiles& engine) {
    const farm::FarmJob& job = planned.job;
    const std::vector<pipeline::WorkerFilm> shots = planned.film.shots();
    const bool is_ocio = std::ranges::any_of(shots, [](const pipeline::WorkerFilm& film) {
        return film.shot.output.view == pipeline::ViewTransform::ocio;
    });
    const std::string program = engine.start.ends_with(".sh")
                                    ? fmt::format(
                                          "If carom is not found by its name, say\nwhere it is:\n\n"
                                          "    CAROM=/path/to/carom {}\n\n",
                                          engine.sentence)
                                    : "\n\n";
    return fmt::format(
        "# The film {}\n\n"
        "This folder has all that is needed to render the film of {}, except carom itself. The\n"
        "files that shots name (meshes, pictures) are in folders files/, and no others are "
        "read.\n\n"
        "    {}\n\n"
        "renders its frames and writes the film into this folder. It may be stopped at any time "
        "and\n"
        "started again: finished frames are in store/. The folder may be moved or copied to other\n"
        "machines; all that take part have to see it. {}"
        "{}{}`carom farm status .` tells how far it is.\n",
        fs::path(job.film).filename().string(), job.name, engine.sentence, program, engine.note,
        is_ocio ? "The environment variable OCIO has to name the shot's OpenColorIO "
                  "configuration.\n\n"
                : "");
}

void copy_all_files(FarmFilm& film, const std::string& folder) {
    if (auto* one = std::get_if<FarmFilm::OneShot>(&film.content)) {
        return copy_files(one->input.shot, *one->input.source, one->bake, folder);
    }
    auto& [sequence, bakes] = std::get<FarmFilm::SeveralShots>(film.content);
    for (auto& [part, bake] : bakes) {
        const auto& shot = std::get<pipeline::ShotPart>(sequence.parts[part].content);
        const std::string part_folder = folder + "/" + farm::part_folder_name(part);
        pipeline::create_folder(part_folder);
        copy_files(shot.shot, *shot.source, bake, part_folder);
    }
}

}  // namespace

void farm_export(const FarmCommand& command, CommandContext& context) {
    const std::string folder = absolute_path(command.folder);
    if (::mkdir(folder.c_str(), 0700) != 0) {
        throw InputError(errno == EEXIST ? "'" + folder + "' exists; choose another folder"
                                         : pipeline::system_problem(folder, "it cannot be made"));
    }
    try {
        FarmCommand inside = command;
        inside.store = folder + "/store";
        PlannedFarm planned = plan_farm(inside, context);
        fs::remove_all(inside.store);  // its bake names files where they were, and is not needed
        farm::FarmJob& job = planned.job;
        job.folder = folder;
        job.store = "store";
        job.film = fs::path(job.film).filename().string();
        job.root = ".";
        job.is_portable = true;
        job.id = hash_bytes(std::as_bytes(std::span(folder))).to_string().substr(0, kIdDigits);
        pipeline::create_folder(folder + "/logs");
        pipeline::create_folder(folder + "/workers");
        copy_all_files(planned.film, folder);
        write_folder(planned);
        farm::write_portable_scripts(job);
        const farm::EngineFiles engine = farm::engine_files(job);
        for (const farm::EngineFile& file : engine.files) {
            farm::write_engine_file(job, file);
        }
        pipeline::create_folder(folder + "/container");
        farm::write_engine_file(job, farm::container_file());
        farm::write_engine_file(job, {"README.md", readme_text(planned, engine)});
        print_path(folder + "/" + engine.start);
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
        throw;
    }
}

}  // namespace carom::cli
