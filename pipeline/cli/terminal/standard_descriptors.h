// Reserves standard input, output and error in a process that was started without them.
#pragma once

namespace carom::cli {

/// If descriptor 0, 1 or 2 is closed (`carom … 2>&-`), opens it so that reading and writing still
/// fail. Otherwise the next file that is opened would get this descriptor, and messages would be
/// written to a film. Must be called before anything is opened.
void reserve_standard_descriptors();

}  // namespace carom::cli
