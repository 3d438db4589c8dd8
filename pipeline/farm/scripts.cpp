#include "pipeline/farm/scripts.h"

#include <span>

#include <fmt/core.h>
#include <sys/stat.h>

#include "core/atomic_file.h"
#include "pipeline/farm/shell_text.h"
#include "pipeline/farm/stages.h"

namespace carom::farm {
namespace {

void write_stage(const FarmJob& job, const Stage& stage, const std::string& commands) {
    write_script(job, stage.script, fmt::format("#!/bin/sh\n# {}\n{}", stage.purpose, commands));
}

}  // namespace

void write_script(const FarmJob& job, const std::string& name, const std::string& text) {
    const std::string path = job.folder + "/" + name;
    write_file_atomically(path, std::as_bytes(std::span(text)));
    ::chmod(path.c_str(), 0755);
}

void write_scripts(const FarmJob& job, const std::string& carom) {
    for (const Stage& stage : stages()) {
        write_stage(job, stage,
                    fmt::format("exec {} farm {} {}\n", shell_word(carom), stage.command,
                                shell_word(job.folder)));
    }
}

void write_portable_scripts(const FarmJob& job) {
    for (const Stage& stage : stages()) {
        write_stage(
            job, stage,
            fmt::format("{}exec \"${{CAROM:-carom}}\" farm {} .\n", kGoToFolder, stage.command));
    }
}

}  // namespace carom::farm
