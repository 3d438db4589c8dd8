// What a process arranges before it opens files.
#pragma once

namespace carom::cli {

/// If descriptor 0, 1 or 2 is closed (`carom … 2>&-`), opens it so that reading and writing still
/// fail. Otherwise the next file that is opened would get this descriptor, and messages would be
/// written to a film. Must be called before anything is opened.
void reserve_standard_descriptors();

/// A write beyond the limit of a file's size (ulimit -f) fails with EFBIG, like one beyond a quota,
/// instead of ending the process. Programs that the process executes inherit this.
void let_too_large_files_fail();

}  // namespace carom::cli
