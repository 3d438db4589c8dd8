// What the servers of carom's pages have in common.
#pragma once

#include <string>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/server/server.h"

namespace carom::cli {

/// A file or folder beside libexec/carom, in the build tree as in an installation.
[[nodiscard]] std::string installed_path(const std::string& name);

/// With the files of all pages. Throws Error if they are missing, InputError.
[[nodiscard]] server::ServerOptions server_options(const PageOptions& page);

/// Opens the server's address in the user's browser, unless that is not wanted, and serves until
/// the command is stopped or nothing was asked for long. Throws Error.
void serve(server::Server& server, const PageOptions& options, CommandContext& context);

}  // namespace carom::cli
