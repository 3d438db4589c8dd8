#include "pipeline/cli/standard_input.h"

#include <array>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <span>
#include <system_error>

#include <sys/mman.h>
#include <unistd.h>

#include "core/write_all.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/config/parse_yaml.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

namespace {

[[noreturn]] void fail() {
    throw InputError(std::string("cannot read ") + kStandardInput + ": " +
                     std::generic_category().message(errno));
}

/// What may still become a shot: a bake of any length, or a text that is not too long.
bool may_continue(const std::string& bytes) {
    return bytes.size() <= pipeline::config::YamlLimits{}.bytes ||
           sim::has_bake_identifier(std::as_bytes(std::span(bytes)));
}

std::string read_all() {
    std::string bytes;
    std::array<char, 65536> block{};
    while (may_continue(bytes)) {
        const ::ssize_t size = ::read(STDIN_FILENO, block.data(), block.size());
        if (size == 0) {
            break;
        }
        if (size > 0) {
            bytes.append(block.data(), static_cast<std::size_t>(size));
        } else if (errno != EINTR) {
            fail();
        }
    }
    return bytes;
}

/// Standard input becomes a file in memory with these bytes. If that fails, another program will
/// say that its input is empty.
void replace_by(const std::string& bytes) {
    const int file = ::memfd_create("carom-standard-input", MFD_CLOEXEC);
    if (file < 0) {
        return;
    }
    if (write_all(file, std::as_bytes(std::span(bytes))) && ::lseek(file, 0, SEEK_SET) == 0) {
        static_cast<void>(::dup2(file, STDIN_FILENO));
    }
    ::close(file);
}

InputOptions* input_of(Command& command) {
    return std::visit(
        []<class T>(T& chosen) -> InputOptions* {
            if constexpr (requires { chosen.input; }) {
                return &chosen.input;
            } else if constexpr (requires { chosen.render.input; }) {
                return &chosen.render.input;
            } else {
                return nullptr;
            }
        },
        command);
}

}  // namespace

void take_standard_input(Command& command) {
    InputOptions* input = input_of(command);
    if (input == nullptr || input->path != "-") {
        return;
    }
    if (std::holds_alternative<StudioCommand>(command)) {
        throw InputError("the studio edits a file, not what is read from standard input");
    }
    if (std::holds_alternative<FarmCommand>(command)) {
        throw InputError("a job on a farm needs a file, not what is read from standard input");
    }
    std::string bytes = read_all();
    replace_by(bytes);
    std::error_code code;
    const std::filesystem::path path = std::filesystem::weakly_canonical(kStandardInput, code);
    input->path = kStandardInput;
    input->texts = std::make_shared<const std::map<std::string, std::string>>(
        std::map<std::string, std::string>{{path.string(), std::move(bytes)}});
}

}  // namespace carom::cli
