#include <filesystem>
#include <string>
#include <utility>

#include "pipeline/cli/page_server.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/studio_site.h"
#include "pipeline/server/server.h"
#include "pipeline/studio/longest_message.h"

namespace carom::cli {

namespace {

studio::SessionOptions session_options(const StudioCommand& command) {
    std::error_code ignored;
    if (!command.input.path.empty() &&
        !std::filesystem::is_regular_file(command.input.path, ignored)) {
        throw InputError("there is no file '" + command.input.path +
                         "'; 'carom studio' without a file offers templates to start from");
    }
    if (!command.output.empty() && !std::filesystem::is_directory(command.output, ignored)) {
        throw InputError("there is no folder '" + command.output + "' for films and exports");
    }
    studio::SessionOptions options;
    options.output = command.output;
    options.shot = command.input.path;
    options.overrides = command.input.overrides;
    options.quality = command.input.quality;
    options.root = command.input.root;
    options.cache_folder = command.cache.folder;
    options.program = installed_path("bin/carom");
    return options;
}

}  // namespace

void run(const StudioCommand& command, CommandContext& context) {
    server::ServerOptions options = server_options(command.page);
    options.limits.message_bytes = studio::kLongestMessage;

    StudioSite site;
    server::Server server(std::move(options), site);
    studio::Session session(session_options(command), [&](studio::Outgoing message) {
        server.send(message.to, {message.binary, std::move(message.data), std::move(message.slot)});
    });
    site.use(session);

    const std::string root = session.files_root();
    std::error_code ignored;
    const std::filesystem::path shot =
        std::filesystem::weakly_canonical(command.input.path, ignored);
    if (command.input.root.empty() && !command.input.path.empty() && shot.parent_path() != root) {
        context.console.info("files below '" + root +
                             "' can be read and written, because the shot names some that are not "
                             "in its own folder; --root FOLDER chooses another one");
    }
    print_text("carom studio: " + server.address() + "\n");
    serve(server, command.page, context);
}

}  // namespace carom::cli
