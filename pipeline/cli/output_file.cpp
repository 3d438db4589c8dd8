#include "pipeline/cli/output_file.h"

#include <cerrno>
#include <filesystem>
#include <span>
#include <system_error>
#include <type_traits>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "core/atomic_file.h"
#include "core/write_all.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/standard_input.h"

namespace carom::cli {

namespace fs = std::filesystem;

namespace {

/// To a pipe or a device.
void write_directly(const std::string& path, const std::string& text) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    const bool is_written = file >= 0 && write_all(file, std::as_bytes(std::span(text)));
    const int reason = errno;
    if (file >= 0) {
        ::close(file);
    }
    if (!is_written) {
        throw Error("cannot write '" + path + "': " + std::generic_category().message(reason));
    }
}

bool is_same_file(const std::string& a, const std::string& b) {
    std::error_code code;
    return !a.empty() && !b.empty() && fs::is_regular_file(a, code) && fs::equivalent(a, b, code) &&
           !code;
}

}  // namespace

void check_not_input(const Command& command) {
    const auto check = []<class T>(const T& chosen) {
        std::vector<std::string> inputs;
        std::vector<std::string> outputs;
        if constexpr (requires { chosen.input; }) {
            inputs = {chosen.input.path, chosen.input.camera_file};
        }
        const auto add = [&](auto member) {
            if constexpr (std::is_invocable_v<decltype(member), const T&>) {
                outputs.push_back(member(chosen));
            }
        };
        add([](const auto& c) -> decltype(c.output) { return c.output; });
        add([](const auto& c) -> decltype(c.plot) { return c.plot; });
        add([](const auto& c) -> decltype(c.events) { return c.events; });
        add([](const auto& c) -> decltype(c.contacts) { return c.contacts; });
        add([](const auto& c) -> decltype(c.heard) { return c.heard; });
        for (const std::string& output : outputs) {
            for (const std::string& input : inputs) {
                if (is_same_file(output, input)) {
                    throw InputError("'" + output +
                                     "' is what the command reads; give -o another name");
                }
            }
        }
    };
    std::visit(check, command);
}

std::string output_or_default(const std::string& given, const std::string& input,
                              const std::string& extension) {
    const std::string stem = input == kStandardInput ? "stdin" : fs::path(input).stem().string();
    return given.empty() ? stem + extension : given;
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
        write_directly(path, text);
        return;
    }
    write_file_atomically(path, std::as_bytes(std::span(text)));
    print_path(path);
}

}  // namespace carom::cli
