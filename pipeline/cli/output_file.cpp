#include "pipeline/cli/output_file.h"

#include <filesystem>
#include <fstream>
#include <span>

#include "core/atomic_file.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

namespace fs = std::filesystem;

std::string output_or_default(const std::string& given, const std::string& input,
                              const std::string& extension) {
    return given.empty() ? fs::path(input).stem().string() + extension : given;
}

void check_output_folder(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    std::error_code ignored;
    if (!folder.empty() && !fs::is_directory(folder, ignored)) {
        throw InputError("cannot write '" + path + "': there is no folder '" + folder.string() +
                         "'");
    }
}

void write_text_output(const std::string& path, const std::string& text) {
    if (path == "-") {
        print_text(text);
        return;
    }
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        std::ofstream file(path, std::ios::binary);
        file << text << std::flush;
        if (!file) {
            throw Error("cannot write '" + path + "'");
        }
        return;
    }
    write_file_atomically(path, std::as_bytes(std::span(text)));
    print_path(path);
}

}  // namespace carom::cli
